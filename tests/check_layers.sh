#!/usr/bin/env bash
# Fails when an include goes up or sideways: math <- mesh, motion <- deform, retarget <- scene <- wasm. Any layer may use
# the detail folders of those below; `thesis` stands on deform and retarget, and nothing of the product on it.
# First proves on a scratch tree that it would. Usage: check_layers.sh [root]
set -u

back_edges() {
  local rule
  for rule in math:math mesh:'math|mesh' motion:'math|motion' deform:'math|mesh|deform' skin:'math|mesh|skin' retarget:'math|motion|retarget' \
    thesis:'math|mesh|motion|deform|retarget|thesis' scene:'math|mesh|motion|deform|retarget|scene'; do
    grep -rnE '#include +["<]rigless/' "$1/include/rigless/${rule%%:*}" 2>/dev/null |
      grep -vE "#include \"rigless/(${rule#*:})/(detail/)?[a-z0-9_]+\.h\""
  done
  grep -rnE '#include +["<].*(wasm|thesis)/' "$1/include" "$1/wasm" 2>/dev/null | grep -v '/rigless/thesis/[a-z_]*\.h:'
}

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$scratch"/include/rigless/{math,mesh,deform/detail,thesis}
echo '#include "rigless/math/detail/types.h"' > "$scratch/include/rigless/deform/good.h"
echo '#include "rigless/deform/good.h"' > "$scratch/include/rigless/thesis/good.h"
[ -z "$(back_edges "$scratch")" ] || { echo "check_layers: a good include is refused"; exit 1; }
echo '#include "rigless/motion/clip.h"' > "$scratch/include/rigless/deform/detail/bad.h"
echo '#include "rigless/mesh/one_ring.h"' > "$scratch/include/rigless/math/bad.h"
echo '#include "rigless/thesis/good.h"' > "$scratch/include/rigless/top.h"
[ "$(back_edges "$scratch" | wc -l)" = 3 ] || { echo "check_layers: a back edge is not seen"; exit 1; }

! back_edges "${1:-$(dirname "$0")/..}" | grep .
