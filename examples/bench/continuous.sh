#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Continuous size laws against LAMMPS: continuous.sh dunkirk 10|20|40 [--quick]; continuous.sh exponential 50 [--quick]
#
# The packings of section 4.2 of Stratford, Shire and Hanley (Dunkirk sand, and an exponential law), made by scree pack with the
# report's numbers of particles; Hooke contacts with slip history, skin 0.5 (the smallest diameter is 1), a rebuild every
# four steps. Measures the time of one rebuild
#   - against d_sep, the diameter that separates two size classes: `multi`, `bytype`, and LAMMPS's `multi` (Figures 7 and 9),
#   - of `hgrid` with 1 ... 8 levels of equal occupancy,
#   - of `auto`, which is told nothing,
# then LAMMPS at its best d_sep and cells and `auto` in turns. --quick: 60,000 particles, fewer points, a minute at most.
#
# One JSON line a measurement: seconds is one rebuild (scree: migrate + reorder + ghosts + index + pairs + history; LAMMPS:
# Neigh), ns_per_particle of it. The last line is the summary: rebuild_ratio is LAMMPS's best over scree's auto.
#
# SCREE, LAMMPS (lmp), CORES (all), RUNS (5; quick: 1), WORK (keeps the packings), COUNT (particles) may be set. SKIP_LAMMPS=1 leaves
# LAMMPS out. Where memory is short, fewer particles are taken, and that is said.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/packing.sh"
export OMP_NUM_THREADS=1
quick_after 2 "continuous.sh dunkirk 10|20|40 [--quick]; continuous.sh exponential 50 [--quick]" "$@"
name=$1
ratio=$2
case $name:$ratio in
dunkirk:10) published=712333 keys="sand ratio=10" ;;
dunkirk:20) published=2336380 keys="sand ratio=20" ;;
dunkirk:40) published=9591137 keys="sand ratio=40" ;;
exponential:50) published=5040560 keys="exponential ratio=50" ;;
*) wrong_call ;;
esac
case $name in
dunkirk) separations=$(for x in 0.1 0.15 0.2 0.25 0.3 0.35 0.4 0.5 0.6 0.8; do calc "1 + $x * ($ratio - 1)" && echo; done) ;;
*) separations="1.5 2 3 4 5 6 7 8 10 12" ;;
esac
levels="1 2 3 4 5 6 7 8"
runs=${RUNS:-$(by_mode 1 5)}
every=4
if [ -n "$quick" ]; then
    separations=$(echo "$separations" | tr ' ' '\n' | sed -n '2p;4p;6p;8p')
    levels="1 2 3 5 8"
fi
count=${COUNT:-$(by_mode 60000 "$published")}
lammps_unless_skipped continuous.sh
# both codes in turn: 1,000 bytes a particle are enough for the larger of them
until memory_for $((count * 1000)); do
    count=$((count * 3 / 4))
    echo "continuous.sh: memory is short; $count particles instead of $published" >&2
done
# shellcheck disable=SC2086
packed $keys count="$count" velocity=1
largest=$(awk 'END { print 2 * $2 }' "$packing.sizes")
rows=$work/continuous.rows
: >"$rows"

# emit CODE INDEX LEVELS D_SEP RANKS THREADS FIGURES: a JSON line, on the standard output and into the rows
emit() {
    echo "$7" | awk -v law="$name" -v R="$ratio" -v code="$1" -v index_name="$2" -v levels="$3" -v d="$4" -v ranks="$5" -v threads="$6" \
        -v n="$particles" '{
        printf "{\"code\": \"%s\", \"law\": \"%s\", \"R\": %d, \"index\": \"%s\", \"levels\": %d, \"d_sep\": %s, \"ranks\": %d, \"threads\": %d, ",
            code, law, R, index_name, levels, d, ranks, threads
        printf "\"particles\": %d, \"seconds\": %.6g, \"ns_per_particle\": %.6g, \"rebuilds\": %d, \"loop_seconds\": %.6g, \"pairs\": %.0f, \"kinetic_energy\": %.15g}\n",
            n, $2 / $3, 1e9 * $2 / $3 / n, $3, $1, $4, $5 }' | tee -a "$rows"
}

# scree_point INDEX LEVELS D_SEP STEPS CLASSES
scree_point() {
    packing_run index="$1" "$5" threads="$cores" step.count="$4" observables.every="$4" step.rebuild_every=$every
    reached=$2
    test "$reached" != 0 || reached=$(grep -c '"cell_size"' "$work/run/report.json")
    emit scree "$1" "$reached" "$3" 1 "$cores" "$(scree_figures "$work/run" energy_kinetic)"
}

# lammps_point D_SEP BIN STEPS
lammps_point() {
    quietly on_ranks "$cores" "$lammps" -in "$here/in.continuous" -log "$work/lammps.log" -screen none -var data "$packing.data" \
        -var dsep "$1" -var bin "$2" -var every $every -var steps "$3" || {
        tail -n 3 "$work/lammps.log" >&2
        return 1
    }
    emit lammps multi 2 "$1" "$cores" 1 "$(lammps_figures "$work/lammps.log" "$3")"
}

# best CODE INDEX: the fastest row
best_row() {
    grep "\"code\": \"$1\".*\"index\": \"$2\"" "$rows" | awk '{ match($0, /"seconds": [^,]*/); t = substr($0, RSTART + 11, RLENGTH - 11) + 0
        if (NR == 1 || t < least) { least = t; row = $0 } } END { print row }'
}

few=$((every * 3))
long=$((every * 6))
for d in $separations; do
    test "$(calc "$d < 0.95 * $largest")" = 1 || continue
    cut=$(classes_at "$(calc "$d / 2")")
    scree_point multi 2 "$d" $every "$cut"
    scree_point bytype 2 "$d" $few "$cut"
    test -z "$with_lammps" || lammps_point "$d" 0 $few
done
for l in $levels; do
    scree_point hgrid "$l" null $few "$(classes_at "$(cuts "$l" 0.5 "$packing.sizes")")"
done
scree_point auto 0 null $few classes.method=auto

bin=0
if [ -n "$with_lammps" ]; then # at the best d_sep also with larger cells; the default is half a cut-off
    row=$(best_row lammps multi)
    d=$(value d_sep "$row")
    fastest=$(value seconds "$row")
    for factor in 0.75 1; do
        larger=$(calc "$factor * ($d + 0.5)")
        line=$(lammps_point "$d" "$larger" $few)
        echo "$line"
        t=$(value seconds "$line")
        if [ "$(calc "$t < $fastest")" = 1 ]; then
            fastest=$t
            bin=$larger
        fi
    done
fi
: >"$work/continuous.lammps"
: >"$work/continuous.scree"
run=0
while [ $run -lt "$runs" ]; do
    if [ -n "$with_lammps" ]; then
        line=$(lammps_point "$d" "$bin" $long)
        echo "$line"
        echo "$(value seconds "$line") $(value kinetic_energy "$line")" >>"$work/continuous.lammps"
    fi
    line=$(scree_point auto 0 null $long classes.method=auto)
    echo "$line"
    echo "$(value seconds "$line") $(value kinetic_energy "$line")" >>"$work/continuous.scree"
    run=$((run + 1))
done
mine=$(median 1 "$work/continuous.scree")
peer='"rebuild_ratio": null, "lammps": "left out"'
if [ -n "$with_lammps" ]; then
    theirs=$(median 1 "$work/continuous.lammps")
    peer="\"rebuild_ratio\": $(calc "$theirs / $mine"), \"lammps\": {\"d_sep\": $d, \"bin\": $bin, \"ranks\": $cores, \"rebuild_seconds\": $theirs}, \
\"kinetic_energy_difference\": $(calc "$(median 2 "$work/continuous.scree") / $(median 2 "$work/continuous.lammps") - 1")"
fi
# of KIND INDEX: "KIND": {what and how long}
of() {
    row=$(best_row scree "$2")
    echo "\"$1\": {\"d_sep\": $(value d_sep "$row"), \"levels\": $(value levels "$row"), \"rebuild_seconds\": $(value seconds "$row")}"
}
echo "{\"summary\": true, \"law\": \"$name\", \"R\": $ratio, \"runs\": $runs, \"ranks\": 1, \"threads\": $cores, \"seconds\": $mine, \"particles\": $particles, \
\"ns_per_particle\": $(calc "1e9 * $mine / $particles"), \"published_particles\": $published, $peer, $(of bytype bytype), $(of hgrid hgrid), $(of multi multi)}"
