#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The bidisperse benchmark against LAMMPS, side by side: bidisperse.sh R [--quick]
#
# R is the ratio of radii, 10, 20 or 40: the systems of Table 1 of Stratford, Shire and Hanley (spheres of radius 1 and R in a
# periodic cube, 712 thousand for R = 10), packed by scree pack, Hooke contacts with slip history, skin 0.5, dt 0.001,
# 100 steps, a rebuild every 16 steps in both codes. --quick takes a small cube and fewer runs: a minute at most, for R = 10.
#
# Both codes first try a few settings, twice (LAMMPS's multi: newton, cell size; scree: index, ranks x threads), then the best of
# each run in turns. Prints one JSON line a run, the last line holds the medians: loop_ratio is LAMMPS's loop time over
# scree's; rebuild_ratio LAMMPS's Neigh over scree's migrate + reorder + ghosts + index + pairs + history.
#
# Needs LAMMPS (Debian: lammps). SCREE, LAMMPS (lmp), CORES (all), RUNS (5), WORK (a folder that keeps the packings) may be set.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/bench.sh"
export OMP_NUM_THREADS=1
quick_after 1 "bidisperse.sh 10|20|40 [--quick]" "$@"
ratio=$1
{ table1_system "$ratio" && [ "$ratio" -le 40 ]; } || wrong_call
runs=${RUNS:-$(by_mode 3 5)}
steps=$(by_mode 48 100)
every=16
find_lammps

cube=
test -z "$quick" || cube=$(table1_cube "$(quick_edge "$ratio")")
data=$work/bidisperse-$ratio${quick:+-quick}.data
if [ ! -s "$data" ]; then
    # shellcheck disable=SC2086
    "$SCREE" pack bidisperse "$data" ratio="$ratio" $cube velocity=1 threads="$cores" >&2
fi
particles=$(awk '/ atoms$/ { print $1; exit }' "$data")
sed "s|@DATA@|$data|; s|@EVERY@|$every|; s|@STEPS@|$steps|" "$here/bidisperse.yaml" >"$work/scene.yaml"

# run_lammps NEWTON CELL STEPS
run_lammps() {
    quietly on_ranks "$cores" "$lammps" -in "$here/in.bidisperse" -log "$work/lammps.log" -screen none -var data "$data" \
        -var newton "$1" -var cell "$2" -var every "$every" -var steps "$3" && lammps_figures "$work/lammps.log" "$3"
}

# run_scree INDEX RANKS THREADS STEPS
run_scree() {
    quietly on_ranks "$2" "$SCREE" run "$work/scene.yaml" -o "$work/run" --overwrite --set index.name="$1" --set threads="$3" \
        --set step.count="$4" --set observables.every="$4" && scree_figures "$work/run" energy_kinetic
}

# line CODE RANKS THREADS SETTINGS FIGURES: one run as JSON
line() {
    echo "$5" | awk -v code="$1" -v ranks="$2" -v threads="$3" -v settings="$4" -v ratio="$ratio" -v n="$particles" \
        -v steps="$steps" '{
        printf "{\"code\": \"%s\", \"R\": %d, \"particles\": %d, \"ranks\": %d, \"threads\": %d, \"settings\": \"%s\", ", code, ratio, n,
            ranks, threads, settings
        printf "\"steps\": %d, \"seconds\": %.6g, \"ns_per_particle\": %.6g, ", steps, $1, 1e9 * $1 / steps / n
        printf "\"rebuild_seconds\": %.6g, \"rebuilds\": %d, \"pairs\": %.0f, \"kinetic_energy\": %.15g}\n", $2, $3, $4, $5 }'
}

: >"$work/lammps.tried"
: >"$work/scree.tried"
for _ in 1 2; do # twice, as other load may spoil one try
    for newton in on off; do
        for cell in 1 2; do
            try "$work/lammps.tried" "$newton $cell" run_lammps $newton $cell $((every * 2))
        done
    done
    for index in ${INDEXES:-bytype hgrid}; do
        for layout in "1 $cores" "$cores 1"; do
            # shellcheck disable=SC2086
            try "$work/scree.tried" "$index $layout" run_scree $index $layout $((every * 2))
        done
    done
done
theirs=$(best "$work/lammps.tried")
mine=$(best "$work/scree.tried")
# shellcheck disable=SC2086
set -- $theirs $mine
newton=$1 cell=$2 index=$3 ranks=$4 threads=$5

: >"$work/lammps.runs"
: >"$work/scree.runs"
run=0
while [ $run -lt "$runs" ]; do
    figures=$(run_lammps "$newton" "$cell" "$steps")
    echo "$figures" >>"$work/lammps.runs"
    line lammps "$cores" 1 "multi, newton $newton, cells $(echo "$cell" | awk '{ print 1.25 * $1 }')" "$figures"
    figures=$(run_scree "$index" "$ranks" "$threads" "$steps")
    echo "$figures" >>"$work/scree.runs"
    line scree "$ranks" "$threads" "$index, newton on" "$figures"
    run=$((run + 1))
done

echo "$(median 1 "$work/lammps.runs") $(median 2 "$work/lammps.runs") $(median 3 "$work/lammps.runs") \
$(median 1 "$work/scree.runs") $(median 2 "$work/scree.runs") $(median 3 "$work/scree.runs") \
$(median 5 "$work/lammps.runs") $(median 5 "$work/scree.runs")" | awk -v ratio="$ratio" -v n="$particles" -v steps="$steps" \
    -v runs="$runs" -v cores="$cores" -v every="$every" -v newton="$newton" -v cell="$cell" -v index_name="$index" -v ranks="$ranks" \
    -v threads="$threads" '{
    printf "{\"R\": %d, \"particles\": %d, \"steps\": %d, \"runs\": %d, \"seconds\": %.6g, \"ns_per_particle\": %.6g, ", ratio, n, steps,
        runs, $4, 1e9 * $4 / steps / n
    printf "\"threads\": %d, \"ranks\": %d, \"loop_ratio\": %.4g, \"rebuild_ratio\": %.4g, ", threads, ranks, $1 / $4, ($2 / $3) / ($5 / $6)
    printf "\"rebuild_seconds\": %.6g, \"rebuilds\": %d, \"kinetic_energy_difference\": %.2g, ", $5, $6, $8 / $7 - 1
    printf "\"scree\": {\"index\": \"%s\", \"newton\": \"on\", \"ranks\": %d, \"threads\": %d}, ", index_name, ranks, threads
    printf "\"lammps\": {\"style\": \"multi\", \"newton\": \"%s\", \"cells\": %g, \"ranks\": %d, \"seconds\": %.6g, ", newton, 1.25 * cell, cores, $1
    printf "\"rebuild_seconds\": %.6g, \"rebuilds\": %d}, \"rebuilt_every\": %d, \"skin\": 0.5, \"dt\": 0.001}\n", $2, $3, every }'
