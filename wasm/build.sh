#!/usr/bin/env bash
# wasm/build.sh OUTPUT: the core as one .wasm file, shape-analysis.wasm and skin.wasm beside it, and what TypeScript knows of them
# (abi.mjs). Linked for size, which costs a dance 3 % of its time and saves 4 kB. Surfaces are built for speed, motions for
# size. What must be inlined or held in vectors says so in its source: to leave the compiler few choices of its own costs no
# speed (measured) and saves 30 kB, for performances 4. These are as fast by -O1 as by -O2 and four times as fast as by -Oz. Who understands a mesh is not downloaded before there is one,
# and ten times as fast as by -Oz; who carves a skin, not before a dance is taken away.
set -euo pipefail
cd "$(dirname "$0")/.."
objects=$(mktemp -d)
trap 'rm -rf "$objects"' EXIT
abi=$(node wasm/abi.mjs)
flags=(-std=c++17 -DNDEBUG "-DRIGLESS_ABI=$abi" -DEIGEN_NO_IO -msimd128 -fno-exceptions -fno-rtti
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -Wno-c++20-designator -Iinclude -isystem /usr/include/eigen3)
link=(--no-entry -sALLOW_MEMORY_GROWTH=1 -sMALLOC=emmalloc -sFILESYSTEM=0)
object() { em++ "${flags[@]}" "${@:2}" -c "wasm/$1.cpp" -o "$objects/$1.o" && echo "compiled wasm/$1.cpp"; }
object memory -Oz
analysis() { em++ "${flags[@]}" -O2 -DRIGLESS_COLD= wasm/shape_analysis.cpp wasm/solid.cpp "$objects/memory.o" "${link[@]}" -o "$objects/shape-analysis.wasm" && echo "compiled wasm/shape_analysis.cpp and wasm/solid.cpp"; }
skin() { em++ "${flags[@]}" -O2 wasm/skin.cpp "$objects/memory.o" "${link[@]}" -o "$objects/skin.wasm" && echo "compiled wasm/skin.cpp"; }
{ object performance -O1 -mllvm -inline-threshold=5 && object motion -Oz && skin; } & motions=$!
{ object surface -O2 -mllvm -inline-threshold=10 -fno-vectorize -fno-slp-vectorize && analysis; } & surfaces=$!
wait $motions
wait $surfaces
em++ -Oz "$objects"/{surface,performance,motion,memory}.o "${link[@]}" -o "$objects/rigless.wasm"
mv "$objects/shape-analysis.wasm" "$objects/skin.wasm" "$(dirname "$1")"
mv "$objects/rigless.wasm" "$1"
