#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Runs the benchmarks and writes the pages docs/performance*.md with their pictures: report.sh [--quick] [--only "NAME..."] [--tables]
#
# --quick: the scaled-down form of those that matter most, ten minutes; without it all of them at full size: hours, 24 GiB.
# --only:  these alone; what others printed in earlier runs is kept.
# --tables: runs nothing, writes the page again.
# --list:  their names.
#
# What each benchmark printed goes to RESULTS/NAME.jsonl, led by a line that says on what machine and under what conditions, and what it said
# besides to RESULTS/NAME.log. One that fails is named at the end, and on the page until it succeeds (RESULTS/NAME.failed); the others go on. What the page was made from is kept beside it, in
# DOCUMENTS/results/performance, and stands in for benchmarks that RESULTS does not hold. RESULTS (examples/bench/out) and
# DOCUMENTS (docs of this checkout if it can be written, else RESULTS), SCREE, CORES, WORK (keeps the packings) may be set; and SKIP_LAMMPS=1,
# which leaves out LAMMPS, and the benchmarks that are nothing without it.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
case $SCREE in # benchmarks may run elsewhere
*/*) SCREE=$(cd "$(dirname "$SCREE")" && pwd)/$(basename "$SCREE") ;;
esac
export SCREE OMP_WAIT_POLICY=passive LC_ALL=C
quick=
only=
run=yes
while [ $# -gt 0 ]; do
    case $1 in
    --quick) quick=--quick ;;
    --only) only=$2 && shift ;;
    --tables) run= ;;
    --list) run=list ;;
    *)
        sed -n '3,8s/^# \{0,1\}//p' "$0" >&2
        exit 2
        ;;
    esac
    shift
done
results=${RESULTS:-$(results out)}
documents=${DOCUMENTS:-}
if [ -z "$documents" ]; then
    documents=$here/../../docs
    test -w "$documents" || documents=$results
fi
kept=$documents/results/performance
mkdir -p "$results"

all="roofline bidisperse-10 table1-10 cells-10 continuous-dunkirk-10 continuous-exponential-50 univol-0.1 univol-0.4 auto growth chute ablation needs"
test -n "$quick" || all="$all univol-0.2 univol-0.62 bidisperse-20 table1-20 cells-20 continuous-dunkirk-20 bidisperse-40 table1-40 continuous-dunkirk-40 cells-40 table1-80 table1-100"
if [ "$run" = list ]; then
    echo "$all" | tr ' ' '\n'
    exit
fi

# ablation: what can be switched, each against the default
ablation() {
    for setting in step.fused=false simd=x86-64-v3 simd=baseline index=bytype index.cross_search=smaller 'index=linkcell classes.method=one' index=multi \
        skin.length=0.25 skin.length=1 threads=1; do
        "$here/compare.sh" $quick "" "$setting"
    done
}

# command_of NAME: runs it
command_of() {
    case $1 in
    ablation) ablation ;;
    needs) "$here/needs.sh" ${quick:+100 ${VARIANTS:-}} ;;
    roofline | auto | growth | chute) "$here/$1.sh" $quick ;;
    continuous-*-*)
        rest=${1#continuous-}
        "$here/continuous.sh" "${rest%-*}" "${rest#*-}" $quick
        ;;
    bidisperse-* | table1-* | cells-* | univol-*) "$here/${1%%-*}.sh" "${1#*-}" $quick ;;
    esac
}

# known NAME: can command_of run it?
known() {
    case $1 in
    ablation | needs | roofline | auto | growth | chute | continuous-*-* | bidisperse-* | table1-* | cells-* | univol-*) ;;
    *)
        echo "report.sh: there is no benchmark $1; report.sh --list names them" >&2
        return 2
        ;;
    esac
}

# busy: the share of all cores that is in use, in per cent, over two seconds
busy() {
    { grep '^cpu ' /proc/stat; sleep 2; grep '^cpu ' /proc/stat; } | awk '
        {
            all = 0
            for (k = 2; k <= 9 && k <= NF; k++) all += $k
            idle = $5 + $6
            if (NR == 1) { all_before = all; idle_before = idle }
        }
        END {
            share = NR == 2 && all > all_before ? 1 - (idle - idle_before) / (all - all_before) : 0
            printf "%.0f %%", 100 * (share > 0 ? share : 0)
        }'
}

conditions() {
    cpu=$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)
    memory=$(awk '/^MemTotal/ { printf "%.0f GiB", $2 / 1048576 }' /proc/meminfo)
    revision=$("$SCREE" --version 2>/dev/null | sed -n 's/.*(\([0-9a-f][^)]*\)).*/\1/p' | head -n 1)
    echo "{\"conditions\": \"| $1 | $2 | ${cpu:-?}, $memory | ${CORES:+$CORES of }$(env -u OMP_NUM_THREADS nproc) | $(busy) | ${revision:-?} | $(date -u +%Y-%m-%d) | @SECONDS@ |\"}"
}

failed=
for name in $only; do
    known "$name" || exit 2
done
if [ -n "$run" ]; then
    build=$(dirname "$SCREE") # some benchmarks need programs of their own
    if [ "$SCREE" != scree ] && [ -f "$build/Makefile" ]; then
        make -s -C "$build" tests/index/bench_index tests/bench_triad >&2
    fi
    for name in ${only:-$all}; do
        case $name in
        bidisperse-* | chute)
            if [ -n "${SKIP_LAMMPS:-}" ]; then
                echo "report.sh: $name is left out: it is nothing without LAMMPS" >&2
                continue
            fi
            ;;
        esac
        echo "report.sh: $name" >&2
        conditions "$name" "${quick:+quick}" | sed 's/|  |/| full |/' >"$results/$name.part"
        began=$(date +%s)
        if command_of "$name" >>"$results/$name.part" 2>"$results/$name.log"; then
            sed "s/@SECONDS@/$(($(date +%s) - began))/" "$results/$name.part" >"$results/$name.jsonl"
            rm -f "$results/$name.part" "$results/$name.failed"
        else
            failed="$failed $name"
            said=$(tail -n 1 "$results/$name.log" | tr -d '`')
            echo "$(date -u +%Y-%m-%d) (\`${said:-it said nothing}\`)" >"$results/$name.failed"
            echo "report.sh: $name failed:" >&2
            tail -n 3 "$results/$name.log" >&2
        fi
    done
fi
for made in "$kept"/*.jsonl; do
    test ! -s "$made" || test -s "$results/$(basename "$made")" || cp "$made" "$results"
done
"$here/page.sh" "$results" "$documents"
mkdir -p "$kept"
cp "$results"/*.jsonl "$kept"
echo "report.sh: wrote $documents/performance.md, performance-index.md and performance-journal.md" >&2
test -z "$failed" || { echo "report.sh: failed:$failed" >&2; exit 1; }
