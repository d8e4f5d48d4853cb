#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Runs the case and draws pressure drop, porosity and three states of the bed: run.sh [DIR]
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
out=${1:-$(results out)}
"$SCREE" run "$here/scene.yaml" -o "$out" --overwrite
"$here/check" "$out" drawn
if command -v gnuplot >/dev/null; then
    for step in 6250 12500 18750; do
        awk -v step=$step '/^ITEM: TIMESTEP/ { getline; on = $1 == step; next } /^ITEM: ATOMS/ { reading = 1; for (k = 3; k <= NF; k++) at[$k] = k - 2; next }
            /^ITEM:/ { reading = 0; next } on && reading { print $at["x"] * 1e3, $at["z"] * 1e3, $at["radius"] * 1e3, $at["porosity"] }' \
            "$out/dump.lammpstrj" >"$out/state-$step.txt"
    done
    gnuplot -e "out='$out/'" "$here/picture.gp"
    echo "drawn: $out/fluidised-bed.png"
fi
