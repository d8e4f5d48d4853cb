#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The benchmarks run, on tiny systems and without LAMMPS: each line of JSON has the keys that other scripts read, the last line is the
# summary, and the numbers of the summary follow from the other lines. Then the test makes the page from the results.
set -u
. "$top_srcdir/tests/app/common.sh"
top_builddir=$(cd "$top_builddir" && pwd)
bench=$(cd "$top_srcdir/examples/bench" && pwd)
export SCREE=${SCREE:-$top_builddir/scree} WORK=$out/work SKIP_LAMMPS=1 CORES=1 RUNS=1 PAIRS=6 OMP_NUM_THREADS=1
export BENCH=$top_builddir/tests/index/bench_index TRIAD=$top_builddir/tests/bench_triad
for tool in tests/index/bench_index tests/bench_triad; do
    [ -x "$top_builddir/$tool" ] || make -s -C "$top_builddir" $tool || exit 1
done
mkdir -p "$out/results" "$WORK"
cd "$out" || exit 1

# lines FILE: has the four keys in each line, one summary, at the end
lines() {
    awk '
        !/^{.*}$/ { print "  no object: " $0; bad = 1 }
        { for (k in key) if (!match($0, "\"" k "\": [0-9]")) { print "  no number " k ": " $0; bad = 1 } }
        /"summary": true/ { summaries++; last = NR }
        END { if (summaries != 1 || last != NR) { print "  " summaries " summaries, " NR " lines"; bad = 1 } exit bad }
        BEGIN { split("threads seconds particles ns_per_particle", name, " "); for (k in name) key[name[k]] }' "$1"
}
# run NAME COMMAND...: into results/NAME.jsonl
run() {
    local name=$1
    shift
    echo '{"conditions": "| a | test | | | | | | |"}' >"results/$name.jsonl"
    timeout 300 "$@" >"$name.jsonl" 2>said || { cat "$name.jsonl" said; return 1; }
    cat "$name.jsonl" >>"results/$name.jsonl"
    lines "$name.jsonl"
}
# value KEY: of the summary
value() {
    tail -n 1 "$name.jsonl" | sed -n 's/.*"'"$1"'": \([-0-9.e+]*\).*/\1/p'
}
# least PATTERN KEY: the least value of a key in the lines with the pattern
least() {
    grep -E "$1" "$name.jsonl" | sed -n 's/.*"'"$2"'": \([-0-9.e+]*\).*/\1/p' | sort -g | head -n 1
}
same() {
    within "$1" "$2" 1e-12
}
positive() {
    awk -v x="$1" 'BEGIN { good = x > 0; if (!good) print "  " x; exit !good }'
}

name=rocks
check 'pairs of rocks' run $name env STEPS=200 EDGE=5 COUNT=0 "$bench/rocks.sh" --quick
alike() { # all indexes find the same pairs of rocks
    [ "$(grep '"setting": "rocks"' $name.jsonl | sed 's/.*"pairs": \([0-9]*\).*/\1/' | sort -u | wc -l)" = 1 ] && [ "$(grep -c '"rebuild_seconds"' $name.jsonl)" -ge 3 ]
}
check 'the same pairs of rocks on each index' alike
check 'the ratio of rocks to spheres' positive "$(value rocks_over_spheres)"

name=continuous-dunkirk-10
check 'Dunkirk sand' run $name env COUNT=3000 "$bench/continuous.sh" dunkirk 10 --quick
best_of_two() { # the summary holds the best of the sweep
    same "$(sed -n 's/.*"bytype": {[^}]*"rebuild_seconds": \([^}]*\)}.*/\1/p' <(tail -n 1 $name.jsonl))" "$(least '"index": "bytype"' seconds)"
}
check 'names the best d_sep' best_of_two
same_pairs() { # all indexes find the same pairs after as many steps
    [ "$(grep '"rebuilds": 3' $name.jsonl | sed 's/.*"pairs": \([0-9]*\).*/\1/' | sort -u | wc -l)" = 1 ]
}
check 'whatever the index, the pairs are the same' same_pairs
check 'LAMMPS is said to be left out' holds $name.jsonl '"lammps": "left out"'
name=continuous-exponential-50
check 'exponential sizes' run $name env COUNT=3000 "$bench/continuous.sh" exponential 50 --quick
name=cells-10
check 'time against cell size' run $name env BINS='2.5 5' "$bench/cells.sh" 10 --quick
check 'with a gain of a grid for each type' positive "$(value gain)"
name=univol-0.4
check 'levels' run $name env COUNT=3000 "$bench/univol.sh" 0.4 --quick
check 'their best is the fastest' same "$(value best_seconds)" "$(least '"detection".*"index": "hgrid"' seconds)"
check 'K is above zero' positive "$(value K)"
check 'the fastest is what its prediction counts from' same "$(least '"kind": "slowdown"' prediction)" 1
name=auto
check 'auto' run $name env COUNT=2000 SCENES='boulder|lognormal 20|one size$' "$bench/auto.sh" --quick
check 'in four scenes' same "$(value scenes)" 4
check 'its prediction is compared' positive "$(value prediction_least)"
name=growth
check 'growth' run $name env NUMBERS='2000 5000' SMALL=2000 "$bench/growth.sh" --quick
boulders_touch() { # the boulder does reach into the bed
    [ "$(grep '"boulder", "R": 1000' $name.jsonl | sed 's/.*"contacts": \([0-9]*\).*/\1/')" -gt 0 ]
}
check 'with boulders' boulders_touch
name=roofline
check 'roofline' run $name "$bench/roofline.sh" --quick
over_its_bytes() { # what fits into the cache may take less time than its bytes at the memory's bandwidth
    positive "$(value step_over_compulsory)" &&
        within "$(awk "BEGIN { print $(value step_over_compulsory) * $(value compulsory_seconds) / $(value seconds) }")" 1 1e-3
}
check 'the time of a step is divided by that of its bytes' over_its_bytes
name=table1-10
check 'large systems, a small one' run $name "$bench/table1.sh" 10 --quick
check 'bytes a particle' positive "$(value bytes_per_particle)"
name=ablation
check 'two settings in turns' run $name "$bench/compare.sh" --quick "" step.fused=false
check 'have a ratio' positive "$(value gain)"
too_few() { # the least and the largest of five hold the median with 93.75 %
    PAIRS=5 "$bench/compare.sh" --quick "" step.fused=false >said 2>&1
    [ $? = 2 ] && holds said 'PAIRS=5; needed: 6 or more'
}
check 'five pairs are too few' too_few

page() {
    RESULTS=$out/results DOCUMENTS=$out/documents "$bench/report.sh" --tables >said 2>&1 || { cat said; return 1; }
    cat documents/performance*.md >pages
    grep -E "nan|inf[^ol]" pages && return 1
    grep -q 'dunkirk | 10 | 3000 ' pages || { grep dunkirk pages; return 1; }
}
check 'the page is made' page
pictures() {
    local picture
    for picture in cells continuous univol optimum auto roofline growth; do
        [ -s "documents/images/performance-$picture.svg" ] || { echo "  no picture $picture"; return 1; }
    done
}
if command -v gnuplot >/dev/null; then check 'and its pictures' pictures; else skip 'pictures: no gnuplot here'; fi
mkdir fake
printf '#!/bin/sh\ncat >/dev/null\n' >fake/gnuplot
chmod +x fake/gnuplot
words() { # the page again, its pictures as they are
    PATH=$out/fake:$PATH page
}
conditions() { # NAME SHARE_OR_LOAD
    sed -i "1s/.*/{\"conditions\": \"| $1 | test | a machine | 1 | $2 | a revision | a day | 1 |\"}/" "results/$1.jsonl"
}
busy() { # a share of the cores is judged, a load average of an older row is not
    conditions growth '90 %' && conditions roofline '3 %' && conditions auto 158.36 && words &&
        holds pages 'wall clock mean little: growth. Run them again'
}
check 'a machine that was busy is told' busy
levels() { # LEVELS SECONDS VERDICT: of hgrid, where multi takes 3 s and bytype 4
    local results=results/continuous-dunkirk-10.jsonl status
    cp $results as_it_was
    sed -i -e '$s/"bytype": {[^}]*}/"bytype": {"d_sep": 2, "levels": 2, "rebuild_seconds": 4}/' \
        -e '$s/"multi": {[^}]*}/"multi": {"d_sep": 2, "levels": 2, "rebuild_seconds": 3}/' \
        -e '$s/"hgrid": {[^}]*}/"hgrid": {"d_sep": null, "levels": '"$1"', "rebuild_seconds": '"$2"'}/' $results
    words && grep '^| dunkirk | 10 ' pages | grep -q "| $3 |\$"
    status=$?
    mv as_it_was $results
    return $status
}
check 'more than two levels pay where they beat the better of multi and bytype' levels 3 2 'yes, 1.50 times'
check 'but not by less than 3 %' levels 3 2.95 'no difference'
check 'nor where two are the best' levels 2 2 no
missing() { # of a section some are there, of another none
    holds pages 'Not run yet: `examples/bench/report.sh --only "cells-20 cells-40"`.' &&
        holds pages 'Not run yet: `examples/bench/report.sh --only "bidisperse-10 bidisperse-20 bidisperse-40"`.'
}
check 'it names what is missing' missing
left_out() { # a system that did not fit, between two others
    echo '{"summary": true, "R": 40, "threads": 1, "seconds": null, "particles": 1000000, "ns_per_particle": null, "bytes_per_particle": 350, "memory": 3221225472, "left_out": "memory is short"}' \
        >results/table1-40.jsonl
    words && holds pages '| 350 (extrapolated) | 3 (extrapolated) | memory is short |'
}
check 'and what is extrapolated' left_out
report() { # needs alone
    PATH=$out/fake:$PATH REPEAT=1 VARIANTS="jkr hooke" RESULTS=$out/results DOCUMENTS=$out/documents "$bench/report.sh" --quick --only needs >said 2>&1
    local status=$?
    cat documents/performance*.md >pages
    return $status
}
mkdir broken
printf '#!/bin/sh\necho "scree: broken on purpose" >&2\nexit 2\n' >broken/scree
chmod +x broken/scree
fails() {
    SCREE=$out/broken/scree report
    [ $? = 1 ] && holds results/needs.log 'scree: broken on purpose' && holds pages 'The last run of needs failed, on 2' &&
        holds pages '(`scree: broken on purpose`)' && holds pages 'Failed: `examples/bench/report.sh --only "needs"`'
}
check 'a benchmark that fails stands on the page, with what it said' fails
succeeds() {
    report || { cat said; return 1; }
    [ ! -e results/needs.failed ] && lacks pages 'The last run of' && grep -q '^{"conditions": "| needs | quick .* [0-9]* % | ' results/needs.jsonl
}
check 'until it succeeds' succeeds
trials() { # of settings, of which one fails
    here=$bench
    . "$bench/bench.sh"
    works() { echo "$1 2 3 4 5"; }
    rm -f trials
    try trials 'on 1' works 3 && try trials 'off 1' false && try trials 'off 2' echo 1 && try trials 'on 2' works 2 && [ "$(best trials)" = 'on 2' ]
}
check 'one trial may fail' eval '(trials) 2>said && holds said "a trial failed and is left out: false"'
none() {
    : >trials
    ! best trials
}
check 'but not all' eval '(here=$bench; . "$bench/bench.sh"; none) 2>said && holds said "all trials failed: trials"'
unknown() {
    RESULTS=$out/results DOCUMENTS=$out/documents "$bench/report.sh" --only nothing >said 2>&1
    [ $? = 2 ] && holds said 'no benchmark nothing'
}
check 'an unknown benchmark is named' unknown
finish
