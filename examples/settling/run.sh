#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A sphere settles in four liquids: run.sh [--spacing LENGTH] [--liquids "1 2 3 4"] [DIR]
#
# --spacing LENGTH   of the fluid (3 mm, five spacings a diameter)
# --liquids LIST     some of the four
# DIR                the results (out)
#
# Prints a line of JSON for each liquid and one for all, which DIR/results.jsonl has, too. SCREE_RANKS: MPI ranks (1). PICTURE=1 draws DIR/settling.png.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
spacing=3mm
liquids="1 2 3 4"
out=
while [ $# -gt 0 ]; do
    case $1 in
        --spacing) spacing=$2; shift ;;
        --liquids) liquids=$2; shift ;;
        -*) echo "run.sh: $1: allowed are --spacing LENGTH, --liquids LIST" >&2; exit 2 ;;
        *) out=$1 ;;
    esac
    shift
done
out=${out:-$(results out)}
mkdir -p "$out"
: >"$out/lines.jsonl"
for liquid in $liquids; do
    # density, viscosity, measured velocity in mm/s, time, height of the box, height of the start
    set -- $(awk -v liquid="$liquid" '$1 == liquid { print $3, $4, $5, $6, $7, $8 }' "$here/liquids.txt")
    [ $# = 6 ] || { echo "run.sh: liquid $liquid: allowed are 1 to 4" >&2; exit 2; }
    # a step is a third of a spacing at the measured velocity
    steps=$(echo "$spacing" | awk -v v="$3" -v t="$4" '{ dx = $0 + 0; n = t * v / (dx / 3); printf "%d", n < 40 ? 40 : n + 1 }')
    start=$(date +%s)
    on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/scene.yaml" -o "$out/liquid-$liquid" --overwrite --quiet --set fluid.spacing="$spacing" \
        --set fluid.density="$1" --set fluid.viscosity="$2" --set step.dt="$(echo "$4 $steps" | awk '{ printf "%.6g", $1 / $2 }')" --set step.count="$steps" \
        --set box.upper="[100 mm, 100 mm, $5 mm]" --set 'walls[5].point'="[0, 0, $5 mm]" --set particles.position="[50 mm, 50 mm, $6 mm]" ${SCREE_ARGS:-}
    awk -F , -v liquid="$liquid" -v spacing="$spacing" -v rho="$1" -v mu="$2" -v measured="$3" -v seconds="$(($(date +%s) - start))" '
        NR > 1 && -$2 * 1e3 > most { most = -$2 * 1e3; at = $3 }
        END { printf "{\"liquid\": %d, \"density\": %g, \"viscosity\": %g, \"spacing_mm\": %g, \"spacings_a_diameter\": %g, \"reynolds\": %.3g, \"velocity_mm_s\": %.2f, \"measured_mm_s\": %g, \"from_measured\": %.4f, \"steps\": %d, \"seconds\": %d}\n",
            liquid, rho, mu, spacing, 15 / spacing, rho * most * 15e-6 / mu, most, measured, most / measured - 1, NR - 2, seconds }' \
        "$out/liquid-$liquid/observables.csv" | tee -a "$out/lines.jsonl"
done
cp "$out/lines.jsonl" "$out/results.jsonl"
awk '{ match($0, /"from_measured": [-0-9.]+/); x = substr($0, RSTART + 17, RLENGTH - 17) + 0; x = x < 0 ? -x : x; if (x > worst) worst = x }
    END { printf "{\"liquids\": %d, \"worst\": %.4f}\n", NR, worst }' "$out/lines.jsonl" >>"$out/results.jsonl"
tail -n 1 "$out/results.jsonl"
if [ "${PICTURE:-0}" = 1 ]; then
    gnuplot -e "out='$out/'" "$here/picture.gp"
    echo "drawn: $out/settling.png" >&2
fi
