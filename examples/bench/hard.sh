#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# What the solver of contacts costs: hard.sh [--short] [PART...]; PART: sweep ranks penetration (all if none is named)
#
#   sweep        a sweep against an explicit step of Hertz's law with friction, in the same bed: instructions (by perf, or by valgrind
#                where perf cannot count) and the processor's seconds, the least of five runs
#   ranks        sweeps a step until the residual is 1e-4, on 1, 2, 4 and 8 ranks, in a collapse
#   penetration  a ball in a bed of glass at 70 GPa, by implicit and by explicit steps to the same time: steps, sweeps, seconds, and the
#                error of the ball against explicit steps half as long
#
# Prints a JSON line a figure, and keeps them in VERIFY_RESULTS or out-hard beside this script (hard.jsonl). --short: a quarter of the bed, and a hundredth
# of the penetration.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
export LC_ALL=C OMP_NUM_THREADS=1 OMP_WAIT_POLICY=passive
short=no
[ "${1:-}" != --short ] || { short=yes; shift; }
[ $# != 0 ] || set -- sweep ranks penetration
out=${VERIFY_RESULTS:-$(results out-hard)}
mkdir -p "$out"
out=$(cd "$out" && pwd)
: >"$out/hard.jsonl"
say() { echo "$1" | tee -a "$out/hard.jsonl"; }

width=32
[ $short = no ] || width=8

pour() {
    [ ! -e "$out/bed-$width/trajectory.h5" ] || return 0
    "$SCREE" run "$here/../solver/bed.yaml" -o "$out/bed-$width" --overwrite --quiet --set "box.upper=[80 mm, $width mm, 60 mm]" \
        --set "particles.region.upper=[16 mm, $width mm, 50 mm]" --set particles.count=$((width * 30))
}

# bed NAME ARGUMENT...: the bed at rest behind its gate
bed() {
    name=$1
    shift
    # shellcheck disable=SC2086
    $counter "$SCREE" run "$here/../solver/collapse.yaml" -o "$out/$name" --overwrite --quiet --set "box.upper=[80 mm, $width mm, 60 mm]" \
        --set 'observables=~' --set "particles.sources[0].file='$out/bed-$width/trajectory.h5'" --set 'duration=~' --set output.checkpoint.at_end=false \
        --set 'walls[gate]={shape: plane, point: [16 mm, 0, 0], normal: [-1, 0, 0]}' "$@"
}
counter=

# instructions ARGUMENT...: of a run, user's code alone
instructions() {
    if perf stat -x, -e instructions:u true 2>&1 | grep -q '^[0-9]'; then
        counter="perf stat -x, -e instructions:u -o $out/perf"
        bed counted "$@" >/dev/null 2>&1
        awk -F, '/instructions/ { print $1 }' "$out/perf"
    else
        counter="valgrind --tool=callgrind --callgrind-out-file=/dev/null"
        bed counted "$@" 2>&1 | sed -n 's/.*Collected : *//p'
    fi
    counter=
}

# seconds ARGUMENT...: of the steps of a run, the least of five
seconds() {
    for _ in 1 2 3 4 5; do
        bed timed "$@" >/dev/null 2>&1
        report_number "$out/timed" seconds
    done | sort -g | head -n 1
}

# difference FUNCTION STEPS FEW MANY: (MANY - FEW) / STEPS; FEW and MANY are words of arguments
difference() {
    # shellcheck disable=SC2086
    awk -v few="$($1 $3)" -v many="$($1 $4)" -v n="$2" 'BEGIN { printf "%.6g", (many - few) / n }'
}

explicit="--set contact.solver=null --set contact.law=hertz --set materials[0].young=1e8 --set materials[0].poisson=0.25 --set step.dt=1e-7"
rigid="--set contact.solver.tolerance=0 --set contact.solver.sweeps"

sweep() {
    for what in instructions seconds; do
        n=40 steps=20
        if [ $what = seconds ]; then n=400 steps=200; fi
        step=$(difference $what $n "$explicit --set step.count=$steps" "$explicit --set step.count=$((steps + n))")
        visit=$(difference $what $((10 * n)) "$rigid=10 --set step.count=$n" "$rigid=20 --set step.count=$n")
        whole=$(difference $what $n "$rigid=1 --set step.count=$steps" "$rigid=1 --set step.count=$((steps + n))")
        say "{\"part\": \"sweep\", \"what\": \"$what\", \"grains\": $((width * 30)), \"contacts\": $(report_number "$out/$([ $what = seconds ] && echo timed || echo counted)" contacts), \"explicit_step\": $step, \"sweep\": $visit, \"step_of_one_sweep\": $whole, \"sweep_over_step\": $(awk -v a="$visit" -v b="$step" 'BEGIN { printf "%.3g", a / b }')}"
    done
}

ranks() {
    for n in 1 2 4 8; do
        on_ranks "$n" "$SCREE" run "$here/../solver/collapse.yaml" -o "$out/ranks" --overwrite --quiet --set "box.upper=[80 mm, $width mm, 60 mm]" \
            --set 'observables=~' --set "particles.sources[0].file='$out/bed-$width/trajectory.h5'" --set contact.solver.sweeps=1000 --set duration=0.02 \
            --set output.checkpoint.at_end=false
        each=$(awk '/"name": "contacts"/ { match($0, /"solves": [0-9]+/); n = substr($0, RSTART + 10, RLENGTH - 10); match($0, /"iterations": [0-9]+/)
            printf "%.4g", substr($0, RSTART + 14, RLENGTH - 14) / n }' "$out/ranks/report.json")
        [ "$n" != 1 ] || alone=$each
        say "{\"part\": \"ranks\", \"ranks\": $n, \"sweeps\": $each, \"over_one_rank\": $(awk -v a="$each" -v b="$alone" 'BEGIN { printf "%.3g", a / b }')}"
    done
}

penetration() {
    duration=0.0004
    [ $short = no ] || duration=0.000004
    "$SCREE" ablate "$here/../penetration/scene.yaml" --error -o "$out/penetration" --overwrite --duration $duration --samples 4 --members 2 --repeat 1 --set threads=1 \
        --set 'particles.sources[1].position=[0, 0, -4.64 cm]' --set 'particles.sources[1].velocity=[0, 0, -5.2]' --set 'materials[glass].young=70 GPa' \
        --set contact.solver=gauss_seidel --set contact.solver.sweeps=30 --set step.dt=${STEP:-1e-6} --set guards.residual=off --judge ball_z,ball_vz --only explicit,solver >"$out/penetration.txt"
    awk '/"group": "(scene|solver|explicit)"/ { sub(/^{/, "{\"part\": \"penetration\", "); print }' "$out/penetration/speed_error.jsonl" | tee -a "$out/hard.jsonl"
}

pour
for part in "$@"; do
    case $part in
    sweep | ranks | penetration) $part ;;
    *) echo "no part '$part'; there are: sweep ranks penetration" >&2 && exit 2 ;;
    esac
done
