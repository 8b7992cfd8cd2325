#!/usr/bin/env bash
# Fails unless every header compiles without a warning: a public one alone, those of the detail folders together, each of
# them before and after all others. Two at a time; what math/types.h takes from Eigen is compiled once for all that include
# it, the others see nothing but themselves. First proves on a scratch tree that it would.
# Usage: check_headers.sh compiler eigen-directory flag...
set -u
compile=("$1" -std=c++17 -isystem "$2" "${@:3}")
types=rigless/math/types.h

# Those that include math/types.h, through others too.
with_types() {
  local all=$types known=
  until [ "$all" = "$known" ]; do
    known=$all
    all=$(sed 's/.*/#include "&"/' <<< "$known" | grep -rlFf - rigless | sort -u - <(echo "$known"))
  done
  echo "$all"
}

compile_each() {  # root
  local eigen=$scratch/eigen.h known
  cd "$1/include" || return
  grep '^#include <' $types > "$eigen"
  "${compile[@]}" -x c++-header "$eigen" -o "$eigen.gch" || return
  known=$(with_types)
  find rigless -path '*/detail/*.h' | sort > "$scratch/detail"
  {
    for order in "sort" "sort -r"; do echo "-include $eigen $($order "$scratch/detail" | sed 's/^/-include /' | paste -sd ' ')"; done | sed 's/ *$//'
    grep -vxFf "$scratch/detail" <<< "$known" | sed "s|^|-Winvalid-pch -include $eigen -include |"
    find rigless -name '*.h' | grep -vxFf "$scratch/detail" | grep -vxFf <(echo "$known") | sed 's/^/-include /'
  } | xargs -P"$jobs" -L1 "${compile[@]}" -I. -x c++ -fsyntax-only /dev/null
}

scratch=$(mktemp -d)
jobs=1 # what is said of the scratch tree is read: two at a time would break each other's lines
trap 'rm -rf "$scratch"' EXIT
tree=$scratch/include/rigless
mkdir -p "$tree"/{math,detail}
printf '#pragma once\n#include <string>\n' > "$tree/math/types.h"
printf '#pragma once\n#include "rigless/math/types.h"\ninline std::string none() { return {}; }\n' > "$tree/good.h"
(compile_each "$scratch") || { echo "check_headers: a good header is refused"; exit 1; }
for bad in 'bad.h inline std::string none() { return {}; }' 'bad.h #include "rigless/good.h"\nstatic int one() { return 1; }' \
  'detail/bad.h static int one() { return 1; }'; do
  printf "#pragma once\n${bad#* }\n" > "$tree/${bad%% *}"
  ! (compile_each "$scratch") > "$scratch/said" 2>&1 || { echo "check_headers: a bad header is not seen"; exit 1; }
  ! grep -v bad.h "$scratch/said" | grep 'error:' || exit 1
  rm "$tree/${bad%% *}"
done

jobs=2
compile_each "$(dirname "$0")/.."
