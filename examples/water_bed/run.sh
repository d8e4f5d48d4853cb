#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A bed of discs falls through water and comes to rest: run.sh [--quick] [DIR]
#
# --quick   ten discs in a smaller box; no picture
# DIR       the results (out)
#
# Prints a line of JSON, which DIR/results.jsonl has, too: kinetic energy at the end over its largest, height of the centre of mass, and the part of the weight less buoyancy that the
# floor carries. Draws DIR/water-bed.png where gnuplot is. SCREE_RANKS: MPI ranks (1).
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
quick_or_folder "$@"
set --
[ $quick = no ] || set -- --set box.upper='[48, 56, 0]' --set 'walls[1].point=[48, 0, 0]' --set 'walls[3].point=[0, 56, 0]' --set particles.count=10 \
    --set particles.region.upper='[48, 56, 0]' --set particles.region.lower='[0, 8, 0]' --set step.count=45000 --set output.dump=~
# shellcheck disable=SC2086
on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/scene.yaml" -o "$out" --overwrite --quiet "$@" ${SCREE_ARGS:-}
awk -F , 'NR > 1 { if ($2 > most) most = $2; energy = $2; height = $4; force = -$7; mass = $9 }
    END { printf "{\"energy\": %.3g, \"height\": %.3f, \"floor\": %.4f, \"time\": %g}\n", energy / most, height, force / (mass * 0.6 * 0.0833333333), $1 }' \
    "$out/observables.csv" | tee "$out/results.jsonl"
if [ $quick = no ] && command -v gnuplot >/dev/null; then
    flow_frames "$out/dump.lammpstrj" "$out"
    gnuplot -e "out='$out/'" "$here/picture.gp"
    rm "$out"/discs-*.txt "$out"/fluid-*.txt
    echo "drawn: $out/water-bed.png" >&2
fi
