// Objects behind integers: what a caller without pointers holds.
#pragma once

#include <memory>
#include <vector>

#include "abi.h"

namespace rigless_wasm {

// A handle of a removed object traps instead of reaching whatever took its place.
template <class T>
class HandleTable {
 public:
  ObjectHandle add() {
    std::size_t index = 0;
    while (index < slots_.size() && slots_[index].object) ++index;
    if (index > 0xffff) __builtin_trap();
    if (index == slots_.size()) slots_.emplace_back();
    slots_[index].object = std::make_unique<T>();
    return pack(index);
  }

  T& operator[](ObjectHandle handle) { return *slot(handle).object; }

  void remove(ObjectHandle handle) {
    Slot& s = slot(handle);
    s.object.reset();
    if (++s.generation == 0) s.generation = 1;
  }

 private:
  struct Slot {
    std::unique_ptr<T> object;
    std::uint16_t generation = 1;
  };

  ObjectHandle pack(std::size_t index) const {
    return static_cast<ObjectHandle>(index) | static_cast<ObjectHandle>(slots_[index].generation) << 16;
  }

  Slot& slot(ObjectHandle handle) {
    const std::size_t index = handle & 0xffff;
    if (index >= slots_.size() || !slots_[index].object || pack(index) != handle) __builtin_trap();
    return slots_[index];
  }

  std::vector<Slot> slots_;
};

}  // namespace rigless_wasm
