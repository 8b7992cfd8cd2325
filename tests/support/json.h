// Reads the golden cases. Not a validator: what it cannot read becomes null, and a missing key or index is null too, so
// that a broken case fails the check that needs it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace rigless::json {

class Value {
 public:
  enum class Kind { null, boolean, number, string, array, object };

  Kind kind() const { return kind_; }
  bool is_null() const { return kind_ == Kind::null; }
  bool boolean() const { return number_ != 0; }
  double number() const { return number_; }
  std::int32_t integer() const { return static_cast<std::int32_t>(number_); }
  const std::string& string() const { return string_; }
  const std::vector<Value>& array() const { return items_; }  // an object's values in file order
  const std::vector<std::string>& keys() const { return keys_; }
  std::size_t size() const { return items_.size(); }
  bool has(const std::string& key) const { return !(*this)[key].is_null(); }

  const Value& operator[](std::size_t i) const { return i < items_.size() ? items_[i] : none(); }
  const Value& operator[](int i) const { return (*this)[static_cast<std::size_t>(i)]; }
  const Value& operator[](const char* key) const { return (*this)[std::string(key)]; }
  const Value& operator[](const std::string& key) const {
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      if (keys_[i] == key) return items_[i];
    }
    return none();
  }

  // Nested arrays as the types the library takes.
  std::vector<double> numbers() const {
    return each<double>([](const Value& v) { return v.number(); });
  }
  std::vector<std::int32_t> integers() const {
    return each<std::int32_t>([](const Value& v) { return v.integer(); });
  }
  std::vector<std::string> strings() const {
    return each<std::string>([](const Value& v) { return v.string(); });
  }
  template <class S>
  Eigen::Matrix<S, 3, 1> vec3() const {
    return {static_cast<S>((*this)[0].number()), static_cast<S>((*this)[1].number()),
            static_cast<S>((*this)[2].number())};
  }
  template <class S>
  std::vector<Eigen::Matrix<S, 3, 1>> vec3s() const {
    return each<Eigen::Matrix<S, 3, 1>>([](const Value& v) { return v.vec3<S>(); });
  }
  std::vector<std::array<std::int32_t, 3>> faces() const {
    return each<std::array<std::int32_t, 3>>([](const Value& v) {
      return std::array<std::int32_t, 3>{v[0].integer(), v[1].integer(), v[2].integer()};
    });
  }
  // Rows of equal length.
  template <class S>
  Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> matrix() const {
    const std::size_t columns = (*this)[0].size();
    Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> m(static_cast<Eigen::Index>(size()),
                                                       static_cast<Eigen::Index>(columns));
    for (std::size_t r = 0; r < size(); ++r) {
      for (std::size_t c = 0; c < columns; ++c) {
        m(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = static_cast<S>(items_[r][c].number());
      }
    }
    return m;
  }

 private:
  friend class Reader;

  static const Value& none() {
    static const Value value;
    return value;
  }
  template <class T, class F>
  std::vector<T> each(F f) const {
    std::vector<T> out;
    out.reserve(items_.size());
    for (const Value& v : items_) out.push_back(f(v));
    return out;
  }

  Kind kind_ = Kind::null;
  double number_ = 0;
  std::string string_;
  std::vector<std::string> keys_;
  std::vector<Value> items_;
};

class Reader {
 public:
  explicit Reader(const char* text) : at_(text) {}

  Value value() {
    Value v;
    switch (peek()) {
      case '{':
      case '[':
        container(v);
        break;
      case '"':
        v.kind_ = Value::Kind::string;
        v.string_ = quoted();
        break;
      case 't':
      case 'f':
        v.kind_ = Value::Kind::boolean;
        v.number_ = *at_ == 't' ? 1 : 0;
        word();
        break;
      case 'n':
        word();
        break;
      default:
        number(v);
    }
    return v;
  }

 private:
  char peek() {
    while (*at_ == ' ' || *at_ == '\n' || *at_ == '\r' || *at_ == '\t') ++at_;
    return *at_;
  }
  void word() {
    while (*at_ >= 'a' && *at_ <= 'z') ++at_;
  }
  void number(Value& v) {
    char* end = nullptr;
    v.number_ = std::strtod(at_, &end);
    if (end == at_) return;
    v.kind_ = Value::Kind::number;
    at_ = end;
  }
  std::string quoted() {
    std::string out;
    for (++at_; *at_ != '\0' && *at_ != '"'; ++at_) {
      if (*at_ == '\\' && at_[1] != '\0') ++at_;
      out += *at_;
    }
    if (*at_ == '"') ++at_;
    return out;
  }
  void container(Value& v) {
    const bool object = *at_ == '{';
    const char close = object ? '}' : ']';
    v.kind_ = object ? Value::Kind::object : Value::Kind::array;
    ++at_;
    while (peek() != close && *at_ != '\0') {
      if (object) {
        v.keys_.push_back(quoted());
        if (peek() == ':') ++at_;
      }
      const char* before = at_;
      v.items_.push_back(value());
      if (peek() == ',') ++at_;
      if (at_ == before) break;  // unreadable
    }
    if (*at_ == close) ++at_;
  }

  const char* at_;
};

inline Value parse(const std::string& text) { return Reader(text.c_str()).value(); }

// The whole file, or an empty string when it is absent.
inline std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file) text << file.rdbuf();
  return text.str();
}

// Null when the file is absent.
inline Value parse_file(const std::string& path) { return parse(read_text(path)); }

}  // namespace rigless::json
