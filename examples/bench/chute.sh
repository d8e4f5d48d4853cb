#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The chute benchmark against LAMMPS, side by side: chute.sh [--quick]
#
# 32,000 spheres flow down an incline of 26 degrees over a base of fixed ones (the physics of LAMMPS's own benchmark: Hooke contacts with
# slip history, k_n = 2000, gamma_n = 50, friction 0.5, dt = 0.0001). The bed is made by scree: spheres rain onto a floor; those whose
# centres end below 1.0 are the base; then they flow for 2 time units. --quick takes a quarter of the spheres and fewer runs.
#
# Both codes first try a few settings (LAMMPS: newton, skin; scree: index, skin, ranks x threads), then the best of each run in
# turns, on one core and on all. Prints one JSON line a run; the last holds the medians: loop_ratio on all cores and loop_ratio_one on
# one, LAMMPS's loop time over scree's.
#
# Needs LAMMPS (Debian: lammps). SCREE, LAMMPS (lmp), CORES (all), RUNS (5), WORK (a folder that keeps the bed) may be set.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/bench.sh"
export OMP_NUM_THREADS=1
quick_after 0 "chute.sh [--quick]" "$@"
find_lammps

length=40 width=20 count=32000 steps=2000 runs=${RUNS:-5} name=chute
test -z "$quick" || length=20 width=10 count=8000 steps=1000 runs=${RUNS:-3} name=chute-quick
data=$work/$name.data

# fill TEMPLATE STEPS DATA SKIN
fill() {
    sed "s|@LENGTH@|$length|g; s|@WIDTH@|$width|g; s|@COUNT@|$count|; s|@STEPS@|$2|g; s|@DATA@|$3|; s|@SKIN@|$4|" "$here/$1" >"$work/$1"
}

make_bed() {
    fill chute_settle.yaml 0 - 0
    quietly "$SCREE" run "$work/chute_settle.yaml" -o "$work/bed" --overwrite --set threads="$cores"
    quietly "$SCREE" convert "$work/bed/trajectory.h5" "$work/settled.data" --frame -1 --overwrite
    awk '/^[0-9]+ atom types/ { $1 = 2 } /^Atoms/ { atoms = NR } /^Velocities/ { atoms = 0 }
        atoms && NF >= 7 { $2 = $7 < 1 ? 2 : 1 } { print }' "$work/settled.data" >"$work/still.data"
    fill chute.yaml 8000 "$work/still.data" 0.1
    quietly "$SCREE" run "$work/chute.yaml" -o "$work/bed" --overwrite --set threads="$cores" --set step.dt=0.00025 \
        --set output.trajectory.every=8000
    quietly "$SCREE" convert "$work/bed/trajectory.h5" "$data.part.data" --frame -1 --overwrite
    mv "$data.part.data" "$data"
}
test -s "$data" || make_bed
particles=$(awk '/ atoms$/ { print $1; exit }' "$data")

# run_lammps RANKS NEWTON SKIN STEPS
run_lammps() {
    quietly on_ranks "$1" "$lammps" -in "$here/in.chute" -log "$work/lammps.log" -screen none -var data "$data" -var newton "$2" \
        -var skin "$3" -var steps "$4" && lammps_figures "$work/lammps.log" "$4"
}

# run_scree RANKS THREADS INDEX SKIN STEPS
run_scree() {
    fill chute.yaml "$5" "$data" "$4"
    quietly on_ranks "$1" "$SCREE" run "$work/chute.yaml" -o "$work/run" --overwrite --set index.name="$3" --set threads="$2" &&
        scree_figures "$work/run" energy_kinetic
}

# line CODE RANKS THREADS SETTINGS FIGURES: one run as JSON
line() {
    echo "$5" | awk -v code="$1" -v ranks="$2" -v threads="$3" -v settings="$4" -v n="$particles" -v steps="$steps" '{
        printf "{\"code\": \"%s\", \"particles\": %d, \"ranks\": %d, \"threads\": %d, \"settings\": \"%s\", ", code, n, ranks, threads, settings
        printf "\"steps\": %d, \"seconds\": %.6g, \"ns_per_particle\": %.6g, ", steps, $1, 1e9 * $1 / steps / n
        printf "\"rebuild_seconds\": %.6g, \"rebuilds\": %d, \"pairs\": %.0f, \"kinetic_energy\": %.15g}\n", $2, $3, $4, $5 }'
}

# compare CORES: tries settings, then runs both in turns; leaves the figures in FILE.CORES
compare() {
    : >"$work/lammps.tried"
    for newton in on off; do
        for skin in 0.1 0.2; do
            try "$work/lammps.tried" "$newton $skin" run_lammps "$1" $newton $skin $((steps / 2))
        done
    done
    : >"$work/scree.tried"
    layouts="1:$1 $1:1"
    test "$1" -gt 1 || layouts=1:1
    for layout in $layouts; do
        for index in linkcell hgrid; do
            for skin in 0.1 0.2; do
                try "$work/scree.tried" "${layout%:*} ${layout#*:} $index $skin" \
                    run_scree "${layout%:*}" "${layout#*:}" $index $skin $((steps / 2))
            done
        done
    done
    theirs=$(best "$work/lammps.tried")
    mine=$(best "$work/scree.tried")
    # shellcheck disable=SC2086
    set -- "$1" $theirs $mine
    : >"$work/lammps.runs.$1"
    : >"$work/scree.runs.$1"
    run=0
    while [ $run -lt "$runs" ]; do
        figures=$(run_lammps "$1" "$2" "$3" "$steps")
        echo "$figures" >>"$work/lammps.runs.$1"
        line lammps "$1" 1 "newton $2, skin $3" "$figures"
        figures=$(run_scree "$4" "$5" "$6" "$7" "$steps")
        echo "$figures" >>"$work/scree.runs.$1"
        line scree "$4" "$5" "$6, skin $7" "$figures"
        run=$((run + 1))
    done
    threads=$5
}

# ratio CORES
ratio() {
    echo "$(median 1 "$work/lammps.runs.$1") $(median 1 "$work/scree.runs.$1")" | awk '{ printf "%.4g", $1 / $2 }'
}

compare 1
one=$(ratio 1)
test "$cores" = 1 || compare "$cores"
echo "$(median 1 "$work/scree.runs.$cores") $(median 1 "$work/lammps.runs.$cores") $(median 5 "$work/lammps.runs.$cores") \
$(median 5 "$work/scree.runs.$cores")" | awk -v n="$particles" -v steps="$steps" -v runs="$runs" -v cores="$cores" -v one="$one" \
    -v threads="$threads" -v all="$(ratio "$cores")" '{
    printf "{\"particles\": %d, \"steps\": %d, \"runs\": %d, \"cores\": %d, \"threads\": %d, \"seconds\": %.6g, ", n, steps, runs, cores, threads, $1
    printf "\"ns_per_particle\": %.6g, \"loop_ratio\": %s, \"loop_ratio_one\": %s, ", 1e9 * $1 / steps / n, all, one
    printf "\"lammps\": {\"seconds\": %.6g}, \"kinetic_energy_difference\": %.2g}\n", $2, $4 / $3 - 1 }'
