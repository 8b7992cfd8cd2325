#!/usr/bin/env bash
# wasm_golden.sh SHARED DOCTEST: builds the golden tests of the deformer, and of its fast path against the reference, as
# WebAssembly and runs them in Node.
set -euo pipefail
cd "$(dirname "$0")/.."
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
ln -s "$2/doctest" "$scratch/doctest"  # alone: beside it lie the headers of another system
em++ -std=c++17 -O1 -msimd128 -fno-exceptions -fno-rtti -DDOCTEST_CONFIG_NO_EXCEPTIONS_BUT_WITH_ALL_ASSERTS \
  -DRIGLESS_TEST_DIR="\"$PWD/tests/\"" -DRIGLESS_SHARED_DIR="\"$1\"" -Iinclude -Itests -isystem /usr/include/eigen3 \
  -I"$scratch" tests/main.cpp tests/deform/{deformer,fast_path}_test.cpp \
  -sALLOW_MEMORY_GROWTH=1 -sNODERAWFS=1 -o "$scratch/golden.js"
node --no-experimental-fetch "$scratch/golden.js" --no-colors  # or older Emscripten fetches a file by its path
