#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Columns collapse: run-out and height against the aspect ratio, beside the laws of two experiments: run.sh [--quick] [DIR]
# Round columns and columns in a channel, of one size of grains and of sizes from 1 to 10. Prints a JSON line a column, a line with the fitted
# exponent a series, and a last line; the exit status is 1 if a column or an exponent is out of bounds. Draws DIR/columns.svg.
# --quick: coarser grains. SERIES and ASPECTS, if set, name some of "round plane round-10 plane-10" and the aspect ratios.
# FINER: grains of one size so many times smaller. Their number grows as the third power of it, in the channel, which is eight grains wide, as the square.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
export LC_ALL=C
case "${FINER:-1} ${SERIES:-round-10}" in
"1 "*) ;;
*-10*)
    echo 'run.sh: FINER is for series of one size: SERIES="round plane"' >&2
    exit 2
    ;;
esac
quick=
if [ "${1:-}" = --quick ]; then
    quick=yes
    shift
fi
out=${1:-$(results out)}
mkdir -p "$out"

# column SHAPE SIZES ASPECT: runs a column of the radius or the length 20 mm and prints its line. Grains of one size have a diameter of a twelfth of that
# (--quick: a tenth); of sizes 1 to 10 the largest have a fifth (a quarter).
column() {
    shape=$1 sizes=$2 aspect=$3
    # The floor's are as large, or as the size with half of the volume below.
    case $sizes$quick in
    1) grains="0.8 mm" largest=0.8 glued=0.8 ;;
    1yes) grains="1 mm" largest=1 glued=1 ;;
    10) grains="{law: power, min: 0.2 mm, max: 2 mm, exponent: -3}" largest=2 glued=0.63 ;;
    *) grains="{law: power, min: 0.25 mm, max: 2.5 mm, exponent: -3}" largest=2.5 glued=0.79 ;;
    esac
    if [ "${FINER:-1}" != 1 ]; then
        largest=$(awk -v x="$largest" -v n="$FINER" 'BEGIN { print x / n }')
        glued=$largest grains="$largest mm"
    fi
    # height in mm, the side of the box, its top, the width of the channel, the time of the collapse, depth and spacing of the floor's grains
    # shellcheck disable=SC2046
    set -- $(awk -v a="$aspect" -v r="$largest" -v glued="$glued" -v shape="$shape" 'BEGIN {
        h = 20 * a
        printf "%g %g %g %g %.3f %g %g", h, 20 * (1 + 2.6 * a ^ (shape == "round" ? 0.5 : 0.67)) + 40, h + 20, 8 * r, 0.1 + 4 * sqrt(h / 9810), -2.3 * glued, 2.2 * glued }')
    run=$out/$shape-$sizes-$aspect
    total=$(awk -v t="$5" 'BEGIN { print t + 0.05 }')
    case $shape in
    round)
        corner="-$2e-3,-$2e-3" end="$2e-3,$2e-3"
        region="{shape: cylinder, centre: [0, 0, $(awk -v h="$1" 'BEGIN { print h / 2000 }')], radius: 20 mm, length: $1 mm}"
        ;;
    plane)
        corner="-2e-3,0" end="$2e-3,$4e-3"
        region="{shape: box, lower: [0, 0, 0], upper: [20 mm, $4 mm, $1 mm]}"
        ;;
    esac
    # shellcheck disable=SC2086
    "$SCREE" run "$here/$shape.yaml" -o "$run" --overwrite --quiet --set "box.lower=[$corner,-6e-3]" --set "box.upper=[$end,$3e-3]" \
        --set "particles.sources[column].region=$region" --set "particles.sources[column].sizes=$grains" --set "particles.sources[floor].sizes=$glued mm" \
        --set "particles.sources[floor].spacing=$7 mm" --set "particles.sources[floor].region={shape: box, lower: [$corner,$6 mm], upper: [$end,0]}" --set "walls[floor].point=[0,0,$6 mm]" \
        --set "stages[collapse].duration=$5" --set "output.dump.every={time: $total}" ${SCREE_ARGS:-} >&2
    awk -v shape="$shape" -v sizes="$sizes" -v width="$4" -v largest="$largest" -v glued="$glued" -v seconds="$(report_number "$run" seconds)" -v steps="$(report_number "$run" steps)" \
        -f "$here/deposit.awk" "$run/observables.csv" "$run/dump.lammpstrj"
}

: >"$out/lines"
for series in ${SERIES:-round plane round-10 plane-10}; do
    sizes=1
    case $series in *-10) sizes=10 ;; esac
    for aspect in ${ASPECTS:-0.5 1 2 3 4 6 10}; do
        column "${series%-10}" "$sizes" "$aspect" | tee -a "$out/lines"
    done
done
if command -v gnuplot >/dev/null; then
    for series in round-1 plane-1 round-10 plane-10; do
        awk -v series="$series" -f "$here/pick.awk" "$out/lines" >"$out/points-$series"
    done
    gnuplot -e "out='$out'; picture='$out/columns.svg'" "$here/picture.gp" && echo "drawn: $out/columns.svg" >&2
fi
awk -f "$here/laws.awk" "$out/lines"
