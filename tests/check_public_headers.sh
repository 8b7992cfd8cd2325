#!/usr/bin/env bash
# Fails unless rigless.h includes every public header, which are those outside detail folders and thesis, includes nothing
# else, and they are 25 at most; and unless what lies in a detail folder is in namespace rigless::detail, but for what
# users name. First proves on a scratch tree that it would. Usage: check_public_headers.sh [root]
set -u
most=25
# Types in public signatures that public headers include from below, and the index helpers of all of our code.
named='math/detail/(index|macros)|motion/detail/(acclaim_skeleton|body_parts|length_unit)|retarget/detail/example|mesh/detail/(one_ring|shape_facts|solid_parts)|deform/detail/(cells|control|discs|volume_law)'

wrong() {
  local include="$1/include" public listed
  public=$(cd "$include" && find rigless -name '*.h' -not -path '*/detail/*' -not -path 'rigless/thesis/*' | sort)
  listed=$(sed -n 's/^#include "\(.*\)"$/\1/p' "$include/rigless/rigless.h"; echo rigless/rigless.h)
  comm -3 <(echo "$public") <(sort <<< "$listed") |
    sed -E 's/^\t(.*)/\1 is not public, but rigless.h includes it/; t; s/$/ is public, but rigless.h does not include it/'
  [ "$(wc -l <<< "$public")" -le $most ] || echo "more than $most public headers: $(wc -l <<< "$public")"
  (cd "$include/rigless" && find . -path '*/detail/*.h' | sort) | grep -vE "^\./($named)\.h$" | while read -r header; do
    grep -q '^namespace rigless {' "$include/rigless/$header" ||
      ! grep -q '^namespace rigless::detail\b' "$include/rigless/$header" || continue
    echo "rigless/${header#./} is not all in namespace rigless::detail"
  done
}

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
tree="$scratch/include/rigless"
mkdir -p "$tree"/{math/detail,thesis}
touch "$tree"/math/{span,detail/index}.h "$tree/thesis/pose_map.h"
echo 'namespace rigless::detail::simd {' > "$tree/math/detail/simd.h"
echo '#include "rigless/math/span.h"' > "$tree/rigless.h"
[ -z "$(wrong "$scratch")" ] || { echo "check_public_headers: a complete list is refused"; exit 1; }
printf '#include "rigless/%s"\n' math/detail/simd.h thesis/pose_map.h > "$tree/rigless.h"
[ "$(wrong "$scratch" | wc -l)" = 3 ] || { echo "check_public_headers: a wrong list is not seen"; exit 1; }
echo '#include "rigless/math/span.h"' > "$tree/rigless.h"
touch "$tree/math/detail/empty.h"
echo 'namespace rigless {' >> "$tree/math/detail/simd.h"
[ "$(wrong "$scratch" | grep -c 'namespace rigless::detail$')" = 2 ] ||
  { echo "check_public_headers: a helper that is public is not seen"; exit 1; }
for ((n = 1; n < most; ++n)); do touch "$tree/math/$n.h"; done
wrong "$scratch" | grep -q '^more than' || { echo "check_public_headers: too many headers are not seen"; exit 1; }

! wrong "${1:-$(dirname "$0")/..}" | grep .
