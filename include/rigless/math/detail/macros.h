// What the compiler is told beside the code.
#pragma once

#include <cassert>

#define RIGLESS_ASSERT(condition) assert(condition)

// Marks what runs once for each mesh: in a wasm module, where every byte is downloaded, it is built for size, unless a
// build says otherwise.
#if defined(RIGLESS_COLD)
#elif defined(__wasm__)
#define RIGLESS_COLD __attribute__((minsize, noinline))
#else
#define RIGLESS_COLD
#endif

// Marks the small functions of inner loops that hand whole registers to each other: g++ gives up on them when several
// loops use them, and each call then costs a trip through memory.
#define RIGLESS_INNER __attribute__((always_inline)) inline
