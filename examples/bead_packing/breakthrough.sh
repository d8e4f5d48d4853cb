#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A front of a dissolved or warm substance passes a packing between an inlet and an outlet: breakthrough.sh [--spacing LENGTH] [--packing FILE] [DIR]
#
# --spacing LENGTH   of the fluid (100um)
# --packing FILE     takes the 410 beads of a file that run.sh --quick made (DIR/packing.txt) instead of pouring
# DIR                the results (out-breakthrough)
#
# Water flows slowly and steadily; from t = 0 on it brings the value 1, which spreads with the diffusivity of a bead's Peclet number PECLET (10,
# pore velocity x diameter over diffusivity). Beads and column take nothing. Prints a line of JSON: how long the front is on its way from the slab
# before the beads to that behind them (arrival_s, the difference of the means of 1 - c), beside the volume of water between them over the flow (pore_time_s); and
# the dispersion along the flow from the growth of its variance, over the diffusivity, beside Sahimi's fit of measurements. DIR/curve.csv has the
# curves. SEED: of the pouring (1).
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
. "$here/open.sh"
spacing=100um packing='' out='' peclet=${PECLET:-10}
while [ $# -gt 0 ]; do
    case $1 in
        --spacing) spacing=$2; shift ;;
        --packing) packing=$2; shift ;;
        -*) echo "breakthrough.sh: $1: allowed are --spacing LENGTH, --packing FILE" >&2; exit 2 ;;
        *) out=$1 ;;
    esac
    shift
done
out=${out:-$(results out-breakthrough)}
mkdir -p "$out"
out=$(cd "$out" && pwd)
column=2.2e-3 height=3.2e-3 beads=410 density=997.561
if [ -n "$packing" ]; then
    cp "$packing" "$out/packing.txt"
else
    . "$here/pour.sh"
    pour
fi
spacing=$(calc "$height / int($height / ($(echo "$spacing" | sed 's/um$/ * 1e-6/; s/mm$/ * 1e-3/')) + 0.5)")
zone=$(calc "int(1e-3 / $spacing + 0.5) * $spacing")
velocity=$(calc "2.771e-5 / $density / (atan2(0, -1) * 4.4e-3 ^ 2)") # superficial
diameter=$(awk '{ print 2 * $1; exit }' "$out/packing.txt")
porosity=$(awk -v column="$column" -v height="$height" '{ solid += 4 / 3 * atan2(0, -1) * $1 ^ 3 } END { printf "%.15g", 1 - solid / (atan2(0, -1) * column ^ 2 * height) }' "$out/packing.txt")
diffusivity=$(calc "$velocity / $porosity * $diameter / $peclet")
whole=$(calc "($height + 2 * $zone) / $velocity * $porosity") # more than the way through
slab() { echo "{name: $1, shape: box, lower: [-$column, -$column, $2], upper: [$column, $column, $(calc "$2 + $spacing")]}"; }
"$SCREE" run "$here/scene.yaml" -o "$out/run" --overwrite --quiet --set "particles.sources[0].file=$out/packing.txt" --set "walls[0].radius=$column" --set box.periodic=false \
    --set "box.lower=[-$column, -$column, -$zone]" --set "box.upper=[$column, $column, $(calc "$height + $zone")]" \
    --set "fluid.spacing=$spacing" --set 'fluid.drive={}' --set "fluid.open=[{side: z_lower, velocity: [0, 0, $velocity]}, {side: z_upper, pressure: 0}]" \
    --set "fluid.scalars=[{name: front, diffusivity: $diffusivity, given: [{side: z_lower, value: 1}]}]" \
    --set "step.dt=$(calc "$whole / 150")" --set step.count=600 --set "observables.regions=[$(slab before "$(calc "-2 * $spacing")"), $(slab behind "$(calc "$height + $spacing")")]" \
    --set 'observables.list=[{name: scalar_1_carried, target: before}, {name: scalar_1_carried, target: behind}, {name: scalar_1_mean}]' ${SCREE_ARGS:-} 2>"$out/notes" || { cat "$out/notes" >&2; exit 1; }
cp "$out/run/observables.csv" "$out/curve.csv"
awk -F , -v spacing="$spacing" -v diameter="$diameter" -v peclet="$peclet" -v velocity="$velocity" -v porosity="$porosity" -v height="$height" -v diffusivity="$diffusivity" '
    NR == 2 { for (k = 2; k <= 3; k++) c[k] = 0 } # nothing is there yet, and nothing flows
    NR > 2 {
        for (k = 2; k <= 3; k++) {
            lack = 1 - 0.5 * (c[k] + $k); middle = 0.5 * (t + $1)
            first[k] += lack * ($1 - t); second[k] += 2 * middle * lack * ($1 - t); c[k] = $k
        }
        t = $1
    }
    END {
        arrival = first[3] - first[2]
        pore = (height * porosity + 3 * spacing) / velocity # the slabs are three spacings of free water farther apart than the packing is high
        growth = (second[3] - first[3] ^ 2) - (second[2] - first[2] ^ 2)
        speed = (height + 3 * spacing) / arrival
        dispersion = growth * speed ^ 2 / (2 * arrival) / diffusivity
        printf "{\"breakthrough_um\": %.5g, \"spacings_a_diameter\": %.4g, \"peclet\": %g, \"diffusivity\": %.4g, \"arrival_s\": %.5g, \"pore_time_s\": %.5g, \"arrival_over_pore_time\": %.4f, \"at_end\": %.5f, \"dispersion_over_diffusivity\": %.3g, \"sahimi\": %.3g}\n",
            1e6 * spacing, diameter / spacing, peclet, diffusivity, arrival, pore, arrival / pore, c[3], dispersion, 1 / sqrt(2) + 0.5 * peclet ^ 1.2
    }' "$out/curve.csv" | tee "$out/breakthrough.jsonl"
