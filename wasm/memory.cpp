// What every module has: memory to lend, and the number of the description that it was built from. Built for size.

#include <cstdlib>

#include "exports.h"

RIGLESS_EXPORT std::int32_t abi() { return RIGLESS_ABI; }

RIGLESS_EXPORT void* alloc(std::int32_t bytes) { return std::malloc(static_cast<std::size_t>(bytes)); }

RIGLESS_EXPORT void release(void* memory) { std::free(memory); }
