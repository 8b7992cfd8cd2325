// A view of contiguous memory that somebody else owns (std::span is C++20).
#pragma once

#include <cstddef>
#include <type_traits>
#include <vector>

#include "rigless/math/detail/index.h"

namespace rigless {

template <class T>
class Span {
 public:
  using Value = std::remove_const_t<T>;

  constexpr Span() = default;
  constexpr Span(T* data, std::size_t size) : data_(data), size_(size) {}
  Span(std::vector<Value>& v) : data_(v.data()), size_(v.size()) {}
  template <class U = T, std::enable_if_t<std::is_const_v<U>, int> = 0>
  Span(const std::vector<Value>& v) : data_(v.data()), size_(v.size()) {}
  template <class U, std::enable_if_t<std::is_same_v<const U, T>, int> = 0>
  constexpr Span(Span<U> other) : data_(other.data()), size_(other.size()) {}

  constexpr T* data() const { return data_; }
  constexpr std::size_t size() const { return size_; }
  constexpr bool empty() const { return size_ == 0; }
  constexpr T* begin() const { return data_; }
  constexpr T* end() const { return data_ + size_; }
  template <class I>
  constexpr T& operator[](I i) const {
    RIGLESS_ASSERT(to_size(i) < size_);
    return data_[i];
  }
  constexpr Span subspan(std::size_t first, std::size_t count) const {
    RIGLESS_ASSERT(first + count <= size_);
    return {data_ + first, count};
  }

 private:
  T* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace rigless
