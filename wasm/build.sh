#!/usr/bin/env bash
# wasm/build.sh OUTPUT: the core as one .wasm file, shape-analysis.wasm beside it, and what TypeScript knows of both
# (abi.mjs). Surfaces are built for speed, motions for size. What must be inlined or held in vectors says so in its source: to
# leave the compiler few choices of its own costs no speed (measured) and saves 30 kB. Performances are as fast by -O1 as by
# -O2, four times as fast as by -Oz, and 2 kB larger than that. Who understands a mesh is not downloaded before there is one,
# and ten times as fast as by -Oz.
set -euo pipefail
cd "$(dirname "$0")/.."
objects=$(mktemp -d)
trap 'rm -rf "$objects"' EXIT
abi=$(node wasm/abi.mjs)
flags=(-std=c++17 -DNDEBUG "-DRIGLESS_ABI=$abi" -DEIGEN_NO_IO -msimd128 -fno-exceptions -fno-rtti
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -Wno-c++20-designator -Iinclude -isystem /usr/include/eigen3)
link=(--no-entry -sALLOW_MEMORY_GROWTH=1 -sMALLOC=emmalloc -sFILESYSTEM=0)
em++ "${flags[@]}" -O2 -mllvm -inline-threshold=25 -fno-vectorize -fno-slp-vectorize -c wasm/surface.cpp -o "$objects/surface.o"
em++ "${flags[@]}" -O1 -c wasm/performance.cpp -o "$objects/performance.o"
em++ "${flags[@]}" -Oz -c wasm/motion.cpp -o "$objects/motion.o"
em++ "${flags[@]}" -Oz -c wasm/memory.cpp -o "$objects/memory.o"
em++ -Os "$objects"/{surface,performance,motion,memory}.o "${link[@]}" -o "$objects/rigless.wasm"
em++ "${flags[@]}" -O2 -DRIGLESS_COLD= wasm/shape_analysis.cpp "$objects/memory.o" "${link[@]}" -o "$objects/shape-analysis.wasm"
mv "$objects/shape-analysis.wasm" "$(dirname "$1")/shape-analysis.wasm"
mv "$objects/rigless.wasm" "$1"
