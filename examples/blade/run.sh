#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Spreads a powder without cohesion and one of Bond number 10: run.sh [DIR]. Prints for each the solid fraction of the layer in the gap between
# x = 1.2 and 2.8 mm, and its highest point; writes them to DIR/layers.tsv. With gnuplot, draws DIR/blade.png. Further settings by
# SCREE_ARGS.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
out=${1:-$(results out)}
numbers=${BOND:-0 10}
mkdir -p "$out"
: >"$out/layers.tsv"
for number in $numbers; do
    # Bo = 3/2 pi W R* / (m g), W = 2 gamma, R* = r / 2, r = 20 um
    energy=$(awk -v bo="$number" 'BEGIN { pi = atan2(0, -1); r = 20e-6; printf "%.6g", bo * 4400 * 4 / 3 * pi * r ^ 3 * 9.81 / (1.5 * pi * r) }')
    # shellcheck disable=SC2086
    on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/scene.yaml" -o "$out/$number" --overwrite --quiet \
        --set "material_pairs[0].surface_energy=$energy" ${SCREE_ARGS:-}
    awk -f "$here/../repose/last.awk" "$out/$number/dump.lammpstrj" | sort -rg >"$out/$number.txt"
    # spheres that lie across an end of the stretch count by their centre: 0.32 mm2 of plate, a gap of 0.1 mm
    awk -v number="$number" '$2 > 1.2 && $2 < 2.8 { volume += 4 / 3 * atan2(0, -1) * $4 ^ 3; if ($3 + $4 > top) top = $3 + $4; grains++ }
        END { printf "%s\t%.4f\t%.4f\t%d\n", number, volume / (1.6 * 0.2 * 0.1), top, grains }' "$out/$number.txt" >>"$out/layers.tsv"
done
cat "$out/layers.tsv"
if command -v gnuplot >/dev/null; then
    gnuplot -e "out='$out/'; numbers='$numbers'" "$here/picture.gp"
    echo "drawn: $out/blade.png"
fi
