#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The index that chooses itself against a sweep: auto.sh [--quick]
#
# For 24 scenes made by scree pack (one size, bidisperse, sand, exponential, lognormal, power laws, uniform by number and by volume,
# dilute to dense, boulders):
#
# detection: order + build + search, CPU time, of `auto` with its own classes, then of `hgrid` with 1, 2, 3, 4 and 6 levels of equal
#   occupancy at cells of 0.7, 1, 1.4 and 2 cut-offs.
# run: the same of whole runs, wall clock: 10 steps with Hooke contacts and slip history for each rebuild.
#
# Of each kind `auto`, what was fastest and the fastest single level are then measured in turns. The line of the scene holds the ratios
# of the medians: ratio (auto over the fastest), linkcell_ratio (auto over the single level), the same of runs, and prediction (the
# cost model over what was measured).
#
# One JSON line a measurement (seconds is one detection, or ten steps and a rebuild), the last line is the summary: median and
# largest ratios. --quick: 4,000 particles, a short sweep, a minute at most.
#
# Needs `make tests/index/bench_index`; BENCH (that program), SCREE, THREADS (1), RUNS (5), COUNT (particles), SCENES (those
# whose names match this expression), WORK (keeps the packings) may be set.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/packing.sh"
quick_after 0 "auto.sh [--quick]" "$@"
bench=$(built BENCH "${BENCH:-}" tests/index/bench_index)
threads=${THREADS:-1}
total=50000
runs=${RUNS:-5}
levels="1 2 3 4 6"
factors="0.7 1 1.4 2"
steps=60
if [ -n "$quick" ]; then
    total=4000
    runs=${RUNS:-2}
    levels="1 2 4"
    factors="1"
    steps=20
fi
total=${COUNT:-$total}

# two R SHARE FRACTION: keys of a bidisperse packing; SHARE of the particles are large, or so many if it is 1 or more
two() {
    awk -v R="$1" -v share="$2" -v fraction="$3" -v n=$total 'BEGIN {
        large = share < 1 ? int(share * n + 0.5) : share
        large = large < 1 ? 1 : large
        edge = ((large * R ^ 3 + n - large) * 4.18879 / fraction) ^ (1 / 3)
        edge = edge < 2.6 * R ? 2.6 * R : edge # the least that scree pack takes
        printf "bidisperse ratio=%g box=%.6g large=%d small=%d", R, edge, large, n - large }'
}

# lognormal RATIO: a table of sieves, a bell in the logarithm of the diameter, three deviations to each side
lognormal() {
    awk -v ratio="$1" 'BEGIN {
        for (k = 0; k <= 24; k++) {
            z = k / 4 - 3
            d = 2 * ratio ^ (k / 24)
            printf "%.9g %.9g\n", d, k == 0 ? 0 : k == 24 ? 1 : 1 / (1 + exp(-1.702 * z)) }
        }' >"$work/lognormal-$1.txt"
    echo "sieve by=number table=$work/lognormal-$1.txt"
}

rows=$work/auto.rows
scenes=$work/auto.scenes
: >"$scenes"

# detect KEY=VALUE...
detect() {
    "$bench" file="$packing.data" skin=0.3 repetitions="$runs" threads="$threads" "$@" | sed "s/^{/{\"kind\": \"detection\", \"scene\": \"$scene\", /"
}

# whole INDEX LEVELS FACTOR CLASSES
whole() {
    packing_run threads="$threads" index="$1" index.cell_factor="$3" "$4" skin.length=0.3 step.count=$steps observables.every=$steps \
        step.rebuild_every=10 guards.overlap=off
    echo "$(report seconds)" | awk -v scene="$scene" -v index_name="$1" -v levels="$2" -v factor="$3" -v threads="$threads" -v n="$particles" -v steps=$steps '{
        s = $1 * 10 / steps
        printf "{\"kind\": \"run\", \"scene\": \"%s\", \"index\": \"%s\", \"levels\": %d, \"factor\": %g, \"threads\": %d, \"seconds\": %.6g, \"particles\": %d, \"ns_per_particle\": %.5g}\n",
            scene, index_name, levels, factor, threads, s, n, 1e9 * s / n }'
}

# fastest KIND PATTERN: the fastest row of a kind with a pattern
fastest() {
    grep "\"kind\": \"$1\".*$2" "$rows" | awk '{ match($0, /"seconds": [^,]*/); t = substr($0, RSTART + 11, RLENGTH - 11) + 0
        if (NR == 1 || t < least) { least = t; row = $0 } } END { print row }'
}

# turns KIND: a row of seconds for each turn: auto, the fastest, the fastest single level; by commands of these names
turns() {
    : >"$work/auto.$1"
    turn=0
    while [ $turn -lt "$runs" ]; do
        mine=$("$1_auto")
        other=$("$1_best")
        single=$("$1_one")
        echo "$(value seconds "$mine") $(value seconds "$other") $(value seconds "$single")" >>"$work/auto.$1"
        turn=$((turn + 1))
    done
}
medians() {
    echo "$(median 1 "$work/auto.$1") $(median 2 "$work/auto.$1") $(median 3 "$work/auto.$1")"
}
detection_auto() { detect levels=0 index=auto; }
detection_best() { detect levels="$(value levels "$best")" factor="$(value factor "$best")"; }
detection_one() { detect levels=1 factor="$(value factor "$one")"; }
detections_in_turns() {
    best=$(fastest detection '"index": "hgrid"')
    one=$(fastest detection '"index": "hgrid", "levels": 1,')
    turns detection
}
run_auto() { whole auto 0 0 classes.method=auto; }
run_best() { whole hgrid "$(value levels "$best")" "$(value factor "$best")" "$cut"; }
run_one() { whole hgrid 1 "$(value factor "$one")" classes.method=one; }
runs_in_turns() {
    best=$(fastest run '"index": "hgrid"')
    one=$(fastest run '"levels": 1,')
    cut=$(classes_at "$(cuts "$(value levels "$best")" 0.3 "$packing.sizes")")
    turns run
}

# measure: all of one scene
measure() {
    {
        detect levels=0 index=auto
        for l in $levels; do
            for f in $factors; do
                detect levels="$l" factor="$f"
            done
        done
        whole auto 0 0 classes.method=auto
        for l in $levels; do
            cut=$(classes_at "$(cuts "$l" 0.3 "$packing.sizes")")
            for f in $factors; do
                whole hgrid "$l" "$f" "$cut"
            done
        done
    } >"$rows"
    cat "$rows"
    detections_in_turns
    runs_in_turns
    awk -v scene="$scene" -v threads="$threads" -v n="$particles" -v predicted="$(value predicted "$(fastest detection '"index": "auto"')")" \
        -v d="$(medians detection)" -v r="$(medians run)" 'BEGIN {
        split(d, detection)
        split(r, run)
        printf "{\"kind\": \"scene\", \"scene\": \"%s\", \"threads\": %d, \"seconds\": %.6g, \"particles\": %d, \"ns_per_particle\": %.5g, ", scene, threads,
            detection[1], n, 1e9 * detection[1] / n
        printf "\"predicted\": %.6g, \"prediction\": %.3f, \"ratio\": %.3f, \"linkcell_ratio\": %.3f, ", predicted, predicted / detection[1],
            detection[1] / detection[2], detection[1] / detection[3]
        printf "\"run_seconds\": %.6g, \"run_ratio\": %.3f, \"run_linkcell_ratio\": %.3f}\n", run[1], run[1] / run[2], run[1] / run[3] }' | tee -a "$scenes"
}

while IFS='|' read -r scene law <&3; do
    echo "$scene" | grep -Eq "${SCENES:-.}" || continue
    # shellcheck disable=SC2046
    packed $(eval "echo $law") velocity=1
    measure
done 3<<'END_OF_SCENES'
one size|power min=1 max=1.0001 fraction=0.4 count=$total
one size dilute|power min=1 max=1.0001 fraction=0.02 count=$total
one size gas|power min=1 max=1.0001 fraction=0.001 count=$total
one size dense|power min=1 max=1.0001 fraction=0.58 count=$total
bidisperse 10|$(two 10 3.5e-4 0.45)
bidisperse 2|$(two 2 0.2 0.3)
bidisperse 4|$(two 4 0.02 0.4)
bidisperse 20|$(two 20 1e-4 0.3)
uniform by volume|univol count=$total fraction=0.4 walls=periodic
uniform by volume dilute|univol count=$total fraction=0.1 walls=periodic
uniform by volume dense|univol count=$total fraction=0.6 walls=periodic
uniform by volume 300|univol count=$total fraction=0.4 ratio=300 walls=periodic
uniform by number 8|power min=1 max=8 exponent=0 fraction=0.4 count=$total
uniform by number 1.8|power min=1 max=1.8 exponent=0 fraction=0.4 count=$total
power 2 50|power min=1 max=50 exponent=2 fraction=0.3 count=$total
power -2 20|power min=1 max=20 exponent=-2 fraction=0.4 count=$total
power -4 100|power min=1 max=100 exponent=-4 fraction=0.4 count=$total
exponential|exponential count=$total
lognormal 20|$(lognormal 20) count=$total fraction=0.4
lognormal 100|$(lognormal 100) count=$total fraction=0.1
sand 20|sand ratio=20 count=$total fraction=0.4
sand 100|sand ratio=100 count=$total fraction=0.3
one boulder|$(two 20 1 0.35)
five boulders|$(two 8 5 0.05)
END_OF_SCENES

# of KEY: the scenes' values in order
of() {
    sed "s/.*\"$1\": \([-0-9.e+]*\).*/\1/" "$scenes" | sort -g
}
# middle KEY, largest KEY
middle() {
    of "$1" | awk '{ v[NR] = $1 } END { printf "%.4g", NR % 2 ? v[(NR + 1) / 2] : (v[NR / 2] + v[NR / 2 + 1]) / 2 }'
}
largest() {
    of "$1" | tail -n 1
}
awk '
function value(key) {
    match($0, "\"" key "\": [^,}]*")
    return substr($0, RSTART + length(key) + 4, RLENGTH - length(key) - 4) + 0
}
{ s += value("seconds"); n += value("particles"); threads = value("threads") }
END { printf "{\"summary\": true, \"scenes\": %d, \"threads\": %d, \"seconds\": %.6g, \"particles\": %d, \"ns_per_particle\": %.5g, ", NR, threads, s, n, 1e9 * s / n }' "$scenes"
echo "\"ratio_median\": $(middle ratio), \"ratio_largest\": $(largest ratio), \"linkcell_ratio_largest\": $(largest linkcell_ratio), \
\"run_ratio_median\": $(middle run_ratio), \"run_ratio_largest\": $(largest run_ratio), \
\"run_linkcell_ratio_largest\": $(largest run_linkcell_ratio), \"prediction_median\": $(middle prediction), \
\"prediction_least\": $(of prediction | head -n 1), \"prediction_largest\": $(largest prediction)}"
