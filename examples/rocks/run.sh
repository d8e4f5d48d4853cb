#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Rocks in a drum and in a hopper: run.sh [--quick] [-o DIR] [NAME...], NAME one of drum, hopper, angles, solver. Draws DIR/drum.png and DIR/hopper.png; writes
# DIR/angles.tsv, the slope of cubes in the drum, a row for each roundness: roundness, angle in degrees; the last row is of spheres.
# solver (not among the usual ones): the drum by contact.solver beside explicit springs, soft as in drum.yaml and as stiff as wood; DIR/solver.tsv has the step, steps and
# seconds of the processor for a second of the drum, the slope, the largest overlap over the radius of the ball.
# --quick: seconds instead of minutes, as the tests do; it draws nothing. Further settings by SCREE_ARGS, ranks by SCREE_RANKS.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
quick=no
out=
while :; do
    case ${1:-} in
    --quick) quick=yes ;;
    -o) out=$2 && shift ;;
    *) break ;;
    esac
    shift
done
out=${out:-$(results out)}
[ $# != 0 ] || set -- drum hopper angles
mkdir -p "$out"

# run NAME SCENE [FLAG...]
run() {
    folder=$1
    scene=$2
    shift 2
    # shellcheck disable=SC2086
    on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/$scene.yaml" -o "$out/$folder" --overwrite --quiet "$@" ${SCREE_ARGS:-}
}

# draw NAME RUN [FLAG...]
draw() {
    picture=$out/$1.png
    from=$out/$2
    shift 2
    [ $quick = yes ] || ! command -v povray >/dev/null || { "$SCREE" picture "$from" -o "$picture" --overwrite --size 480x360 "$@" && echo "drawn: $picture"; }
}

# The centre of mass lies below the middle of a flat surface: its direction is the slope. Mean over the second half.
angle() { # NAME ROUNDNESS
    "$SCREE" info "$out/$1" --column centre_x >"$out/x"
    "$SCREE" info "$out/$1" --column centre_z | paste -d ' ' "$out/x" - | awk -v name="$2" '{ a[NR] = atan2($1, -$2) }
        END { for (k = int(NR / 2) + 1; k <= NR; k++) { s += a[k]; n++ } s *= 45 / atan2(1, 1) / n; printf "%s\t%.1f\n", name, s < 0 ? -s : s }' >>"$out/angles.tsv"
}

# spend: sets `spent`, the seconds of the processor that the children of this shell have used
spend() {
    times >"$out/times"
    spent=$(awk 'NR == 2 { for (k = 1; k <= 2; k++) { split($k, part, "[ms]"); sum += 60 * part[1] + part[2] } print sum }' "$out/times")
}

# cost NAME DURATION [FLAG...]: a row of solver.tsv
cost() {
    name=$1
    duration=$2
    shift 2
    spend
    before=$spent
    run "drum-$name" drum --set duration="$duration" --set threads=1 "$@"
    spend
    steps=$("$SCREE" info "$out/drum-$name/report.json" --get steps)
    dt=$("$SCREE" info "$out/drum-$name/report.json" --get dt)
    awk -v name="$name" -v seconds="$(awk -v now="$spent" -v before="$before" 'BEGIN { print now - before }')" -v steps="$steps" -v dt="$dt" \
        'BEGIN { printf "%s\t%.3g\t%.4g\t%.3g\t", name, dt, 1 / dt, seconds / (steps * dt) }' >>"$out/solver.tsv"
    awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); at[$k] = k } next }
        { a[NR] = atan2($at["centre_x"], -$at["centre_z"]); if ($at["overlap_max"] > most) most = $at["overlap_max"] }
        END { for (k = int(NR / 2) + 1; k <= NR; k++) { s += a[k]; n++ } s *= 45 / atan2(1, 1) / n
            printf "%.1f\t%.2g\n", s < 0 ? -s : s, most }' "$out/drum-$name/observables.csv" >>"$out/solver.tsv"
}

for one; do
    case $one in
    drum)
        # shellcheck disable=SC2046
        run drum drum $([ $quick = no ] || echo --set duration=0.3s --set particles.sources[0].region.length=1cm --set box.upper=[0.052,0.02,0.052])
        draw drum drum --colour z@0 --view front
        ;;
    hopper)
        # shellcheck disable=SC2046
        run hopper hopper $([ $quick = no ] || echo --set stages[0].duration=0.15s --set stages[1].duration=0.2s --set particles.sources[0].count=60)
        draw hopper hopper --colour z@0 --frame 10
        ;;
    angles)
        : >"$out/angles.tsv"
        for roundness in 0.12 0.4 0.8; do
            if [ $quick = no ] || [ $roundness = 0.8 ]; then
                run drum-$roundness drum --set bodies.shapes[0].roundness=$roundness --set duration="$([ $quick = no ] && echo 1.5s || echo 0.1s)"
                angle drum-$roundness $roundness
            fi
        done
        run drum-spheres drum --set bodies='~' --set particles.sources[0].shape='""' --set 'observables.list=[{name: centre}]' --set duration=1.5s
        angle drum-spheres spheres
        cat "$out/angles.tsv"
        ;;
    solver)
        time=$([ $quick = no ] && echo 1.5s || echo 0.1s)
        printf 'run\tstep\tsteps\tseconds\tangle\toverlap\n' >"$out/solver.tsv"
        cost solver "$time" --set step.fraction=0.3 --set contact='{law: rigid, solver: {sweeps: 20}}' --set material_pairs='[{restitution: 0.7, friction: 0.5}]'
        cost springs "$time"
        cost wood "$([ $quick = no ] && echo 0.05s || echo 2ms)" --set contact=hertz --set 'materials=[{name: wood, density: 1200, young: 10 GPa, poisson: 0.3}]' \
            --set material_pairs='[{restitution: 0.7, friction: 0.5}]'
        cat "$out/solver.tsv"
        ;;
    *) echo "run.sh: $one: allowed are drum, hopper, angles and solver" >&2 && exit 2 ;;
    esac
done
