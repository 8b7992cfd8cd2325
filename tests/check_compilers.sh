#!/usr/bin/env bash
# Fails unless a compiler without vector extensions is told which compilers have them, before anything else goes wrong, by
# every public header that needs them, and by no other. Usage: check_compilers.sh compiler eigen-directory
set -u
include="$(dirname "$0")/../include"
flags=(-std=c++17 -I"$include" -isystem "$2" -x c++)
failed=0
needing=0
for header in $(cd "$include" && find rigless -name '*.h' -not -path '*/detail/*'); do
  first=$("$1" "${flags[@]}" -U__GNUC__ -U__clang__ -E "$include/$header" 2>&1 > /dev/null | grep -m1 'error:')
  said=$(grep -c 'g++, clang++ .* or em++' <<< "$first")
  needs=$("$1" "${flags[@]}" -M "$include/$header" | grep -c math/detail/simd.h)
  needing=$((needing + needs))
  [ "$said" = "$needs" ] || { echo "$header: $([ "$needs" = 1 ] && echo "${first:-no error}" || echo "needs no vectors")"; failed=1; }
done
[ $needing -gt 3 ] || { echo "only $needing headers need vectors"; failed=1; }
exit $failed
