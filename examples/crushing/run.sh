#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Crushes a ball of bonded grains: run.sh [DIR] [ACROSS]
# ACROSS: grains along a diameter (13). Draws the force of the plate over its way, and the ball before and after. Further settings by
# SCREE_ARGS.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
out=${1:-$(results out)}
across=${2:-13}
mkdir -p "$out"
awk -v across="$across" -f "$here/grains.awk" >"$out/grains.txt"
top=$(awk '/top/ { print $3 }' "$out/grains.txt")
sed "s/point: \[0, 0, 13 mm\]/point: [0, 0, $top]/; s#file: grains.txt#file: $(cd "$out" && pwd)/grains.txt#; s/^duration: .*/duration: $across ms/" "$here/scene.yaml" >"$out/scene.yaml"

# shellcheck disable=SC2086
on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$out/scene.yaml" -o "$out/run" --overwrite --quiet ${SCREE_ARGS:-}

awk -F, -v across="$across" -f "$here/curve.awk" "$out/run/observables.csv" >"$out/curve.txt"
awk -f "$here/summary.awk" "$out/curve.txt"
if command -v gnuplot >/dev/null && [ -e "$out/run/dump.lammpstrj" ]; then
    awk -v which=first -f "$here/picture.awk" "$out/run/dump.lammpstrj" | sort -g -k 1,1 -k 2,2 -k 3,3 >"$out/before.txt"
    awk -v which=last -f "$here/picture.awk" "$out/run/dump.lammpstrj" | sort -g -k 1,1 -k 2,2 -k 3,3 >"$out/after.txt"
    gnuplot -e "curve='$out/curve.txt'; before='$out/before.txt'; after='$out/after.txt'; wide=$across; picture='$out/crushing.png'" "$here/crushing.gp"
    echo "$out/crushing.png"
fi
