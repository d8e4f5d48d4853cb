#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A blade stirs water, grains and a dye in a drum: run.sh [--quick] [DIR]
#
# --quick   a smaller drum with six discs, half a turn; no picture
# DIR       the results (out)
#
# Prints a line of JSON, which DIR/results.jsonl has, too: mean torque on the blade in the second half of the run, mean height of the grains over that at the start, mean dye in the water at start and end, and its
# standard deviation over the water at start and end. Draws DIR/mixer.png where gnuplot is. SCREE_RANKS: MPI ranks (1).
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
quick_or_folder "$@"
set --
[ $quick = no ] || set -- --set box.upper='[40, 40, 0]' --set 'walls[0]={name: drum, shape: cylinder, point: [20, 20, 0], axis: [0, 0, 1], radius: 19}' \
    --set 'walls[1].lower=[8, 18, -5]' --set 'walls[1].upper=[32, 22, 5]' --set 'walls[1].motion[0].point=[20, 20, 0]' --set particles.count=6 \
    --set particles.region.centre='[20, 20, 0]' --set particles.region.radius=18 --set step.count=7500 \
    --set 'fluid.scalars[0].initial.region.upper=[40, 20, 0]'
# shellcheck disable=SC2086
on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/scene.yaml" -o "$out" --overwrite --quiet "$@" ${SCREE_ARGS:-}
torque=$(awk -F , 'NR == 1 { for (k = 1; k <= NF; k++) if ($k ~ /^drag_blade_torque_z/) c = k; next } { t[++n] = $c } END { for (k = int(n / 2) + 1; k <= n; k++) sum += t[k]; print sum / (n - int(n / 2)) }' \
    "$out/observables.csv")
awk -v torque="$torque" '
    /^ITEM: TIMESTEP/ { frame++ } /^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next } /^ITEM/ { reading = 0 }
    reading && NF > 4 && $at["kind"] == 0 { y[frame] += $at["y"]; grains[frame]++ }
    reading && NF > 4 && $at["kind"] == 1 { free = 1 - $at["solid"]; water[frame] += free; dye[frame] += free * $at["scalar_1"]; square[frame] += free * $at["scalar_1"] ^ 2 }
    function mean(f) { return dye[f] / water[f] }
    function apart(f) { return sqrt(square[f] / water[f] - mean(f) ^ 2) }
    END { printf "{\"torque\": %.4g, \"rise\": %.2f, \"dye\": %.4f, \"dye_end\": %.4f, \"apart\": %.3f, \"apart_end\": %.3f}\n", torque, y[frame] / grains[frame] - y[1] / grains[1], mean(1), mean(frame), apart(1), apart(frame) }' \
    "$out/dump.lammpstrj" | tee "$out/results.jsonl"
if [ $quick = no ] && command -v gnuplot >/dev/null; then
    awk -v out="$out" '/^ITEM: TIMESTEP/ { getline; frame = $1 } /^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next } /^ITEM/ { reading = 0 }
        reading && NF > 4 && $at["kind"] == 0 { print $at["x"], $at["y"], $at["radius"] >(out "/discs-" frame ".txt") }
        reading && NF > 4 && $at["kind"] == 1 { print $at["x"], $at["y"], $at["scalar_1"] >(out "/dye-" frame ".txt") }' "$out/dump.lammpstrj"
    gnuplot -e "out='$out/'" "$here/picture.gp"
    rm "$out"/discs-*.txt "$out"/dye-*.txt
    echo "drawn: $out/mixer.png" >&2
fi
