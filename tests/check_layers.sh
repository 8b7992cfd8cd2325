#!/usr/bin/env bash
# Fails when an include goes up or sideways: math <- mesh, motion <- deform, retarget <- scene <- wasm.
# First proves on a scratch tree that it would. Usage: check_layers.sh [root]
set -u

back_edges() {
  local rule
  for rule in math:math mesh:'math|mesh' motion:'math|motion' deform:'math|mesh|deform' retarget:'math|motion|retarget' \
    scene:'math|mesh|motion|deform|retarget|scene'; do
    grep -rnE '#include +["<]rigless/' "$1/include/rigless/${rule%%:*}" 2>/dev/null |
      grep -vE "#include \"rigless/(${rule#*:})/[a-z0-9_]+\.h\""
  done
  grep -rnE '#include +["<].*wasm/' "$1/include"
}

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$scratch"/include/rigless/{math,mesh,deform}
echo '#include "rigless/math/types.h"' > "$scratch/include/rigless/deform/good.h"
[ -z "$(back_edges "$scratch")" ] || { echo "check_layers: a good include is refused"; exit 1; }
echo '#include "rigless/motion/clip.h"' > "$scratch/include/rigless/deform/bad.h"
echo '#include "rigless/mesh/one_ring.h"' > "$scratch/include/rigless/math/bad.h"
[ "$(back_edges "$scratch" | wc -l)" = 2 ] || { echo "check_layers: a back edge is not seen"; exit 1; }

! back_edges "${1:-$(dirname "$0")/..}" | grep .
