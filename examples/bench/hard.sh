#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# What the solver of contacts costs: hard.sh [--short] [PART...]; PART: sweep ranks penetration (all if none is named)
#
#   sweep        a sweep against an explicit step of Hertz's law with friction, in the same bed: instructions (by perf, or by valgrind
#                where perf cannot count) and the processor's seconds, the least of five runs
#   ranks        sweeps a step until the residual is 1e-4, on 1, 2, 4 and 8 ranks, in a collapse
#   penetration  a ball in 25,000 beads of glass at 70 GPa, by implicit steps (STEP, 20 us; SWEEPS, 10) and explicit ones of 0.6 of the stable step:
#                seconds a step while it digs in, 0.5 ms in turns, the least of three; how far 5 ms of digging are off explicit steps half as
#                long, by half and twice the step and by three times the sweeps, too; the whole run of 0.1 s by implicit steps, and what the explicit one would take by its steps and the seconds of each
#
# Prints a JSON line a figure, and keeps them in VERIFY_RESULTS or out-hard beside this script (hard.jsonl). --short: a quarter of the bed, and some
# hundredths of the penetration.
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
    pour
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
    pour
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

# plunge NAME SECONDS ARGUMENT...: the ball digs into the bed at the modulus of glass, or (whole) is thrown as in the scene
plunge() {
    name=$1 seconds=$2
    shift 2
    "$SCREE" run "$here/../penetration/scene.yaml" -o "$out/$name" --overwrite --quiet --set threads=1 --set 'materials[glass].young=70 GPa' --set duration="$seconds" \
        --set output.trajectory.every=0 --set output.checkpoint.at_end=false --set observables.every="{time: $(awk -v t="$seconds" 'BEGIN { print t / 10 }')}" \
        --set 'observables.list=[{name: position, label: ball, id: 25001, components: z}, {name: velocity, label: ball, id: 25001, components: z}]' "$@" >/dev/null
}
number() { report_number "$out/$1" "$2"; }
touching="--set particles.sources[ball].position=[0,0,-0.0464] --set particles.sources[ball].velocity=[0,0,-5.2]"
by_steps() { echo "--set contact.solver=gauss_seidel --set contact.solver.sweeps=$2 --set guards.residual=off --set step.dt=$1"; }
by_springs() { echo "--set step.dt=~ --set step.fraction=$1"; }

# dug NAME: how far the ball has come, and its speed
dug() { echo "$("$SCREE" info "$out/$1" --column ball_z --row last) $("$SCREE" info "$out/$1" --column ball_vz --row last)"; }

# shellcheck disable=SC2046,SC2086
penetration() {
    dig=5e-3 stretch=5e-4 whole=0.1 step=${STEP:-2e-5} sweeps=${SWEEPS:-10}
    [ $short = no ] || dig=1.2e-4 stretch=4e-5 whole=1e-3
    for turn in 1 2 3; do
        plunge "springs-$turn" $stretch $touching $(by_springs 0.6)
        plunge "sweeps-$turn" $stretch $touching $(by_steps "$step" "$sweeps")
    done
    for run in springs sweeps; do
        each=$(for turn in 1 2 3; do awk -v s="$(number $run-$turn seconds)" -v n="$(number $run-$turn steps)" 'BEGIN { printf "%.6g\n", s / n }'; done | sort -g | head -n 1)
        say "{\"part\": \"penetration\", \"what\": \"stretch\", \"run\": \"$run\", \"dt\": $(number $run-1 dt), \"steps\": $(number $run-1 steps), \"seconds_a_step\": $each}"
        [ $run = sweeps ] || spring=$each
    done
    plunge reference $dig $touching $(by_springs 0.3)
    plunge springs $dig $touching $(by_springs 0.6)
    runs="reference springs"
    for dt in $(awk -v dt="$step" 'BEGIN { print dt / 2, dt, 2 * dt }'); do
        for n in "$sweeps" $((3 * sweeps)); do
            plunge "$n-sweeps-$dt" $dig $touching $(by_steps "$dt" "$n")
            runs="$runs $n-sweeps-$dt"
        done
    done
    for run in $runs; do
        say "{\"part\": \"penetration\", \"what\": \"dig\", \"run\": \"$run\", \"dt\": $(number "$run" dt), \"steps\": $(number "$run" steps), \"seconds\": $(number "$run" seconds), $(
            echo "$(dug "$run") $(dug reference)" | awk '{ printf "\"ball_z\": %.8g, \"ball_vz\": %.6g, \"error_z\": %.3g, \"error_vz\": %.3g", $1, $2, ($1 - $3) / ($3 + 0.0464), ($2 - $4) / ($4 + 5.2) }')}"
    done
    plunge whole $whole $(by_steps "$step" "$sweeps")
    say "{\"part\": \"penetration\", \"what\": \"whole\", \"simulated\": $whole, \"steps\": $(number whole steps), \"seconds\": $(number whole seconds), $(
        awk -v t=$whole -v dt="$(number springs dt)" -v each="$spring" -v s="$(number whole seconds)" 'BEGIN { n = t / dt
            printf "\"explicit_steps\": %.0f, \"explicit_seconds_by_the_stretch\": %.4g, \"times_faster\": %.3g", n, n * each, n * each / s }')}"
}

for part in "$@"; do
    case $part in
    sweep | ranks | penetration) $part ;;
    *) echo "no part '$part'; there are: sweep ranks penetration" >&2 && exit 2 ;;
    esac
done
