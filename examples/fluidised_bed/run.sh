#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Air makes a bed of beads fluid: run.sh [--quick] [DIR]
#
# --quick   0.5 s instead of 0.8 s, no picture
# DIR       the results (out)
#
# Prints a line of JSON, which DIR/results.jsonl has, too: porosity of the packed bed between 4 and 13 mm above the floor, the velocity of least
# fluidisation there, Ergun's (1952), how far off it is, and drag over weight of the fluid bed. Draws pressure drop, porosity and three states of the bed.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
quick_or_folder "$@"
set --
[ $quick = no ] || set -- --set duration='0.5 s'
# shellcheck disable=SC2086
on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/scene.yaml" -o "$out" --overwrite --quiet "$@" ${SCREE_ARGS:-}
# Porosity by the parts of the beads between the two levels, at 0.45 m/s
porosity=$(awk 'function part(s, r) { s = s < -r ? -r : s > r ? r : s; return pi * (s + r) ^ 2 * (2 * r - s) / 3 }
    BEGIN { pi = atan2(0, -1) }
    /^ITEM: TIMESTEP/ { getline; on = $1 == 6250; next } /^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next }
    /^ITEM/ { reading = 0 } on && reading { z = $at["z"]; r = $at["radius"]; solid += part(13e-3 - z, r) - part(4e-3 - z, r) }
    END { printf "%.8g", 1 - solid / (24.6e-3 * 6.2e-3 * 9e-3) }' "$out/dump.lammpstrj")
# The packed bed's ratio a U + b U^2 between 0.6 and 0.9 is 1 at the least velocity
awk -F , -v e="$porosity" 'NR == 1 { for (k = 1; k <= NF; k++) { name = $k; sub(/\[.*/, "", name); at[name] = k } next }
    { U = $at["superficial_velocity_z"]; y = $at["drag_over_weight_middle"]; if ($1 < 0.17) next }
    y > 0.9 { over = 1 }
    !over && y > 0.6 { s2 += U ^ 2; s3 += U ^ 3; s4 += U ^ 4; y1 += y * U; y2 += y * U * U }
    U > 0.6 && U < 0.7 { fluid += $at["drag_over_weight"]; m++ }
    END {
        det = s2 * s4 - s3 * s3; a = (y1 * s4 - y2 * s3) / det; b = (s2 * y2 - s3 * y1) / det; least = (sqrt(a * a + 4 * b) - a) / (2 * b)
        p = 150 * 1.8e-5 * (1 - e) / 1e-6; q = 1.75 * 1.2 / 1e-3
        ergun = (sqrt(p * p + 4 * q * 2498.8 * 9.81 * e ^ 3) - p) / (2 * q)
        printf "{\"porosity\": %.4f, \"least_velocity\": %.4f, \"ergun\": %.4f, \"error\": %.4f, \"fluidised_ratio\": %.4f}\n", e, least, ergun, least / ergun - 1, fluid / m
    }' "$out/observables.csv" | tee "$out/results.jsonl"
[ $quick = no ] || exit 0
if command -v gnuplot >/dev/null; then
    for step in 6250 12500 18750; do
        awk -v step=$step '/^ITEM: TIMESTEP/ { getline; on = $1 == step; next } /^ITEM: ATOMS/ { reading = 1; for (k = 3; k <= NF; k++) at[$k] = k - 2; next }
            /^ITEM:/ { reading = 0; next } on && reading { print $at["x"] * 1e3, $at["z"] * 1e3, $at["radius"] * 1e3, $at["porosity"] }' \
            "$out/dump.lammpstrj" >"$out/state-$step.txt"
    done
    gnuplot -e "out='$out/'" "$here/picture.gp"
    echo "drawn: $out/fluidised-bed.png"
fi
