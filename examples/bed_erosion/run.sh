#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A flow erodes a bed: run.sh [--quick] [--resolved] [DIR]
#
# --quick     two forces instead of four, a fifth of the time
# --resolved  discs that the fluid resolves, in two dimensions (resolved.yaml); no picture
# DIR         the results (out)
#
# Prints a line of JSON for each force that drives the liquid, which DIR/results.jsonl has, too: Shields number of the flow that belongs to it, mean velocity of the grains
# that are not fixed, and of the liquid. Draws DIR/bed-erosion.png where gnuplot is.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
forces='0.02 0.05 0.1 0.2'
steps=3000
scene=scene.yaml
out=
for argument; do
    case $argument in
        --quick) forces='0.02 0.2'; steps=600 ;;
        --resolved) scene=resolved.yaml ;;
        -*) echo "run.sh: $argument: allowed are --quick and --resolved" >&2; exit 2 ;;
        *) out=$argument ;;
    esac
done
case $scene,$steps in
    resolved.yaml,600) forces='0.02 0.3' steps=2500 ;;
    resolved.yaml,*) forces='0.02 0.1 0.2 0.3' steps=5000 ;;
esac
out=${out:-$(results out)}
mkdir -p "$out"
resolved() { # FORCE: 11 discs of the mass 1.952 are free; the channel over the bed is 4.1 high
    # shellcheck disable=SC2086
    "$SCREE" run "$here/resolved.yaml" -o "$out/resolved-$1" --overwrite --quiet --set "fluid.drive.body_force=[$1, 0, 0]" --set step.count=$steps ${SCREE_ARGS:-}
    awk -F , -v f="$1" 'NR > 1 { t = $1; p = $3; x = $4; u = $7; if (NR == 2) first = x }
        END { printf "{\"resolved\": true, \"force\": %g, \"shields\": %.3f, \"time\": %g, \"grains\": %.5f, \"way\": %.4f, \"liquid\": %.4f}\n", f, f * 4.1 / 2 / 1.5, t, p / (11 * 1.952), (x - first) * 19 / 11, u }' \
        "$out/resolved-$1/observables.csv" | tee -a "$out/results.jsonl"
}
: >"$out/results.jsonl"
for force in $forces; do
    [ $scene = scene.yaml ] || { resolved "$force"; continue; }
    # shellcheck disable=SC2086
    "$SCREE" run "$here/scene.yaml" -o "$out/force-$force" --overwrite --quiet --set "fluid.drive.body_force=[$force, 0, 0]" --set step.count=$steps \
        --set output.dump.every=$((steps / 2)) ${SCREE_ARGS:-}
    # 110 grains of the mass 1.309 are free; the channel over the bed is 7 high, and bed and lid have half of the force each
    awk -F , -v f="$force" 'NR > 1 { t = $1; p = $2; z = $3; u = $4 }
        END { printf "{\"force\": %g, \"shields\": %.3f, \"time\": %g, \"grains\": %.4f, \"liquid\": %.4f, \"height\": %.3f}\n", f, f * 7 / 2 / 1.5, t, p / (110 * 1.309), u, z }' \
        "$out/force-$force/observables.csv" | tee -a "$out/results.jsonl"
done
if [ $scene = scene.yaml ] && [ $steps = 3000 ] && command -v gnuplot >/dev/null; then
    for force in 0.02 0.2; do
        awk -v dir="$out/force-$force" '/^ITEM: TIMESTEP/ { getline; frame = $1 } /^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next } /^ITEM/ { reading = 0 }
            reading && NF > 4 && frame == 3000 { name = dir ($at["radius"] == 0.5 ? "-grains.txt" : "-liquid.txt")
                print $at["x"], $at["z"], $at["vx"], $at["radius"], $at["y"] >name }' "$out/force-$force/dump.lammpstrj"
    done
    gnuplot -e "out='$out/'" "$here/picture.gp"
    rm "$out"/force-*-grains.txt "$out"/force-*-liquid.txt
    echo "drawn: $out/bed-erosion.png" >&2
fi
