#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The indexes over the points of a fluid at two resolutions: fine in the eighth of the box next to a boundary, four times as coarse
# beyond; a point's support radius is 2.2 spacings, and two points are a pair nearer than the mean of their supports. The same pairs
# on each index; seconds of the search by index, and up to N = 16 brute force beside. fluid_index.sh [N [FOLDER]]: N fine points an edge, a multiple of 8.
#
# The points are spheres of half a support that do not act upon each other: the physics `fluid` itself has one spacing.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
n=${1:-16}
out=${2:-$(mktemp -d)}
mkdir -p "$out"

awk -v n="$n" 'function fill(h, from, to, x, y, z) {
        for (z = from + h / 2; z < to; z += h) for (y = h / 2; y < 1; y += h) for (x = h / 2; x < 1; x += h) print x, y, z, 1.1 * h }
    BEGIN { fill(1 / n, 0, 0.125); fill(4 / n, 0.125, 1) }' >"$out/points.txt"
cat >"$out/scene.yaml" <<YAML
title: Points of a fluid at two resolutions
units: none
box: {lower: [0, 0, 0], upper: [1, 1, 1], periodic: [true, true, false]}
contact: {law: hooke}
materials: [{name: point, density: 1}]
material_pairs: [{k_n: 1.0e-9, restitution: 1, friction: 0}]
particles: {from: file, format: table, file: points.txt, columns: [x, y, z, radius], velocity_sigma: $(awk -v n="$n" 'BEGIN { print 0.3 / n }')}
classes: {method: geometric, count: 2}
skin: $(awk -v n="$n" 'BEGIN { print 0.1 / n }')
step: {dt: 0.05, count: 40, force: true}
guards: {overlap: off, energy: off}
YAML
brute=
[ "$n" -gt 16 ] || brute=,brute
"$SCREE" ablate "$out/scene.yaml" -o "$out/ablate" --overwrite --index "linkcell,multi,bytype,hgrid,auto$brute" --threads 1 --newton on >"$out/said" 2>&1 ||
    { cat "$out/said" >&2; exit 1; }
awk -F , 'NR == 1 { for (k = 1; k <= NF; k++) at[$k] = k; next }
    { printf "%-9s %d pairs, %d rebuilds, index %.4g s, pairs %.4g s\n", $at["index"], $at["pairs"], $at["rebuilds"], $at["index[s]"], $at["pairs[s]"]
      seen[$at["pairs"]]++ || kinds++ }
    END { print NR - 1 " indexes, " (kinds == 1 ? "the same pairs" : "OTHER PAIRS"); exit !(NR > 5 && kinds == 1) }' "$out/ablate/ablate.csv"
