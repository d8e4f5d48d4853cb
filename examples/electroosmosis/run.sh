#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A field mixes two streams of water between walls of alternating charge: run.sh [--quick] [DIR]
#
# --quick   half as fine, 0.2 s, no picture
# DIR       the results (out)
#
# Prints a line of JSON, which DIR/results.jsonl has, too: the largest speed, that of the walls by Smoluchowski, the net flow over the largest speed, the
# part of the dye lost, and its variance at the end over that at the start, with the field and by diffusion alone. Draws DIR/electroosmosis.png.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
quick_or_folder "$@"

# mix NAME [FLAG...]
mix() {
    name=$1
    shift
    [ $quick = no ] || set -- --set fluid.spacing='1 um' --set step.dt='4 ms' --set duration='0.2 s' "$@"
    on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/scene.yaml" -o "$out/$name" --overwrite --quiet "$@"
}

# unmixed NAME: variance of the dye over that at the start
unmixed() {
    awk '/^ITEM: TIMESTEP/ { frame++ } /^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next } /^ITEM/ { reading = 0 }
        reading && $at["y"] > 0 && $at["y"] < 20e-6 { n[frame]++; s[frame] += $at["scalar_1"]; q[frame] += $at["scalar_1"] ^ 2 }
        function variance(f) { return q[f] / n[f] - (s[f] / n[f]) ^ 2 }
        END { printf "%.5f", variance(frame) / variance(1) }' "$out/$1/dump.lammpstrj"
}

# frame NUMBER: x and y in um, the velocity, the potential in mV, the dye
frame() {
    awk -v number="$1" '/^ITEM: TIMESTEP/ { frame++ } /^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next } /^ITEM/ { reading = 0 }
        reading && frame == number && $at["y"] > 0 && $at["y"] < 20e-6 { print 1e6 * $at["x"], 1e6 * $at["y"], $at["vx"], $at["vy"], 1e3 * $at["potential"], $at["scalar_1"] }' \
        "$out/field/dump.lammpstrj"
}

mix field
mix none --set fluid.electrolyte.field='[0, 0, 0]' --set fluid.time=transient
awk -F, -v with="$(unmixed field)" -v without="$(unmixed none)" '
    NR == 2 { first = $4 } { flow = $2; speed = $3; dye = $4 }
    END { lost = dye / first - 1; net = flow / speed; lost = lost < 0 ? -lost : lost; net = net < 0 ? -net : net
        printf "{\"speed_mm_s\": %.4f, \"smoluchowski_mm_s\": 0.39, \"net_flow\": %.1e, \"dye_lost\": %.1e, \"variance\": %.3f, \"variance_by_diffusion\": %.3f}\n", 1e3 * speed, net, lost, with, without }' \
    "$out/field/observables.csv" | tee "$out/results.jsonl"
[ $quick = no ] || exit 0
command -v gnuplot >/dev/null || { echo "no gnuplot here, so nothing is drawn" >&2; exit 0; }
frame 2 >"$out/early.txt"
frame 5 >"$out/late.txt"
gnuplot -e "out='$out/'" "$here/picture.gp"
rm "$out/early.txt" "$out/late.txt"
echo "drawn: $out/electroosmosis.png" >&2
