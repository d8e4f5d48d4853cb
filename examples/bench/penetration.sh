#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The penetration case against LAMMPS, side by side: penetration.sh [--quick]
#
# Both codes run examples/penetration/scene.yaml from the throw on, with plain velocity Verlet and equal dampers: 200,000 steps of
# 25,001 particles, many minutes each, of which the height of the ball is written; --quick runs 2,000 steps from just above
# the bed. LAMMPS runs its multi search on all cores with the better of two skins, scree with the better of ranks and threads.
# Prints one JSON line a run; the last holds loop_ratio, LAMMPS's loop time over scree's.
#
# Needs LAMMPS (Debian: lammps). SCREE, LAMMPS (lmp), CORES (all), RUNS (1, quick 3), WORK may be set.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/bench.sh"
export OMP_NUM_THREADS=1
quick_after 0 "penetration.sh [--quick]" "$@"
find_lammps
case=$here/../penetration

z=0.06 v=-5 steps=200000 runs=${RUNS:-1}
test -z "$quick" || z=-0.0445615 v=-5.201105 steps=2000 runs=${RUNS:-3}

tsuji() { awk -v e="$1" -f "$case/lammps/tsuji.awk"; }
gzip -dc "$case/particles.txt.gz" | awk -v z=$z -v vz=$v -f "$case/lammps/data.awk" >"$work/penetration.data"

# Both print the five figures of a run (bench.sh): the loop seconds are the first, the height of the ball at the end is the last

# run_lammps SKIN STEPS
run_lammps() {
    quietly on_ranks "$cores" "$lammps" -in "$case/lammps/in.penetration" -log "$work/lammps.log" -screen none \
        -var data "$work/penetration.data" -var out "$work/ball" -var skin "$1" -var steps "$2" -var every "$2" \
        -var e11 "$(tsuji 0.5)" -var e12 "$(tsuji 0.4)" -var e22 "$(tsuji 0.6)" &&
        echo "$(awk '/^Loop time/ { print $4 }' "$work/lammps.log") 0 0 0 $(tail -n 1 "$work/ball" | cut -d ' ' -f 3)"
}

# run_scree RANKS THREADS STEPS
run_scree() {
    quietly on_ranks "$1" "$SCREE" run "$case/scene.yaml" -o "$work/run" --overwrite --set threads="$2" \
        --set duration="$(awk -v n="$3" 'BEGIN { printf "%.10g", n * 5e-7 }')" \
        --set integrator=velocity_verlet --set contact.tangential_damping_equal=true --set contact.sliding=total --set contact.end=overlap \
        --set "particles.sources[1].position=[0, 0, $z]" --set "particles.sources[1].velocity=[0, 0, $v]" \
        --set "observables.list=[{name: position, label: ball, id: 25001, components: z}]" \
        --set output.trajectory.every=0 --set output.checkpoint.at_end=false &&
        scree_figures "$work/run" ball_z
}

# line CODE RANKS THREADS SETTINGS FIGURES
line() {
    echo "$5" | awk -v code="$1" -v ranks="$2" -v threads="$3" -v settings="$4" -v steps=$steps '{
        printf "{\"code\": \"%s\", \"particles\": 25001, \"steps\": %d, \"ranks\": %d, \"threads\": %d, \"settings\": \"%s\", ", code, steps,
            ranks, threads, settings
        printf "\"seconds\": %.6g, \"ns_per_particle\": %.6g, \"ball_z\": %.9g}\n", $1, 1e9 * $1 / steps / 25001, $5 }'
}

trial=1000
: >"$work/tried"
for skin in 0.0002 0.0006; do try "$work/tried" $skin run_lammps $skin $trial; done
skin=$(best "$work/tried")
: >"$work/tried"
# shellcheck disable=SC2086
for layout in "1 $cores" "$cores 1"; do try "$work/tried" "$layout" run_scree $layout $trial; done
chosen=$(best "$work/tried")
ranks=${chosen% *}
threads=${chosen#* }

: >"$work/lammps.runs"
: >"$work/scree.runs"
run=0
while [ $run -lt "$runs" ]; do
    figures=$(run_lammps "$skin" $steps)
    echo "$figures" >>"$work/lammps.runs"
    line lammps "$cores" 1 "multi, newton off, skin $skin" "$figures"
    figures=$(run_scree "$ranks" "$threads" $steps)
    echo "$figures" >>"$work/scree.runs"
    line scree "$ranks" "$threads" "as the scene says" "$figures"
    run=$((run + 1))
done

echo "$(median 1 "$work/lammps.runs") $(median 1 "$work/scree.runs")" | awk -v steps=$steps -v runs="$runs" -v ranks="$ranks" \
    -v threads="$threads" -v cores="$cores" '{
    printf "{\"particles\": 25001, \"steps\": %d, \"runs\": %d, \"ranks\": %d, \"threads\": %d, \"seconds\": %.6g, ", steps, runs, ranks, threads, $2
    printf "\"ns_per_particle\": %.6g, \"loop_ratio\": %.4g, \"lammps\": {\"ranks\": %d, \"seconds\": %.6g}}\n", 1e9 * $2 / steps / 25001,
        $1 / $2, cores, $1 }'
