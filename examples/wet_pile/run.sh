#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Dry and wet sand when their mould is drawn up: run.sh [DIR]. Prints for each the height of the centre of mass before and after, and the share
# of the grains that stayed within 1.2 radii of the mould; writes them to DIR/piles.tsv. With gnuplot, draws DIR/wet-pile.png. Further
# settings by SCREE_ARGS.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
out=${1:-$(results out)}
mkdir -p "$out"
: >"$out/piles.tsv"
for pile in dry wet; do
    settings=
    [ $pile = wet ] || settings="--set material_pairs[1].surface_tension=0"
    # shellcheck disable=SC2086
    on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/scene.yaml" -o "$out/$pile" --overwrite --quiet $settings ${SCREE_ARGS:-}
    awk -F, -v pile=$pile 'NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); at[$k] = k } next }
        $at["time"] < 0.12 { before = $at["sand_z"] }
        { after = $at["sand_z"]; share = $at["foot"] / $at["particles"] }
        END { printf "%s\t%.3f\t%.3f\t%.3f\n", pile, 1e3 * before, 1e3 * after, share }' "$out/$pile/observables.csv" >>"$out/piles.tsv"
    awk -f "$here/../repose/last.awk" "$out/$pile/dump.lammpstrj" | sort -rg >"$out/$pile.txt"
done
cat "$out/piles.tsv"
if command -v gnuplot >/dev/null; then
    gnuplot -e "out='$out/'" "$here/picture.gp"
    echo "drawn: $out/wet-pile.png"
fi
