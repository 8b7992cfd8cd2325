// Counts heap allocations of this program, so that a test can say "none here".
#pragma once

#include <cstdint>
#include <cstdlib>
#include <new>

namespace rigless::test {
inline std::int64_t allocation_count = 0;
}

#ifdef RIGLESS_DEFINE_NEW  // tests/main.cpp

// Out of line, or the compiler sees a free() of what it takes for a new.
#define RIGLESS_KEEP __attribute__((noinline))

RIGLESS_KEEP void* operator new(std::size_t size) {
  ++rigless::test::allocation_count;
  if (void* p = std::malloc(size)) return p;
  std::abort();
}
RIGLESS_KEEP void* operator new(std::size_t size, std::align_val_t align) {
  ++rigless::test::allocation_count;
  const auto a = static_cast<std::size_t>(align);
  if (void* p = std::aligned_alloc(a, (size + a - 1) / a * a)) return p;
  std::abort();
}
RIGLESS_KEEP void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++rigless::test::allocation_count;
  return std::malloc(size);
}
RIGLESS_KEEP void operator delete(void* p, const std::nothrow_t&) noexcept { std::free(p); }
RIGLESS_KEEP void operator delete(void* p) noexcept { std::free(p); }
RIGLESS_KEEP void operator delete(void* p, std::size_t) noexcept { std::free(p); }
RIGLESS_KEEP void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
RIGLESS_KEEP void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }

#endif
