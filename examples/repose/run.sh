#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The angle of repose against the Bond number: run.sh [--quick] [DIR]. Writes DIR/angles.tsv, a row for each Bond number: number, angle in
# degrees, grains that stayed. With gnuplot, also DIR/repose.png. Further settings by SCREE_ARGS.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
numbers="0 1 2 4"
if [ "${1:-}" = --quick ]; then # two slopes
    numbers="0 4"
    shift
fi
out=${1:-$(results out)}
mkdir -p "$out"
: >"$out/angles.tsv"
for number in $numbers; do
    # Bo = 3/2 pi W R* / (m g), W = 2 gamma, R* = r / 2, r = 0.5 mm
    energy=$(awk -v bo="$number" 'BEGIN { pi = atan2(0, -1); r = 0.5e-3; printf "%.6g", bo * 2500 * 4 / 3 * pi * r ^ 3 * 9.81 / (1.5 * pi * r) }')
    # shellcheck disable=SC2086
    on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/scene.yaml" -o "$out/$number" --overwrite --quiet \
        --set "material_pairs[1].surface_energy=$energy" ${SCREE_ARGS:-}
    awk -f "$here/last.awk" "$out/$number/dump.lammpstrj" | sort -rg >"$out/$number.txt"
    awk -v number="$number" -f "$here/slope.awk" "$out/$number.txt" >>"$out/angles.tsv"
done
cat "$out/angles.tsv"
if command -v gnuplot >/dev/null; then
    gnuplot -e "out='$out/'; numbers='$numbers'" "$here/picture.gp"
    echo "drawn: $out/repose.png"
fi
