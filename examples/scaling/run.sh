#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Scaling over ranks x threads: run.sh [--quick] [DIR [PART...]]
#
# PARTs, all of them if none is named:
#   weak     a like share of a gas for each core, on each layout (LAYOUTS, "1x1 1x2 2x1 2x2 4x1": ranks x threads)
#   strong   one gas, on each layout
#   hybrid   the bidisperse benchmark with R = 10 on 1x1, 1xN and Nx1 (N: CORES), stage by stage
#   ranks    messages, bytes, copies and memory of a rank on 8 ... 125 ranks (RANKS, edges of cubes of ranks: "2 3 4 5"), as
#            bricks and by bisection, and with boulders that reach beyond neighbours on 27 ... 108
#   counts   instructions, barriers, messages, bytes and memory of 1 to 64 threads and of 1 to 64 ranks (counts.sh; needs valgrind)
#   ghosts   full and reduced ghosts against geometry on 8 ranks (ghosts.sh)
#   pupcs    the scenarios of examples/pupcs, and the size of the largest particle there
#   lengths  what has the length of the rank count, made up to 10^6 ranks on one: bench_ranks (make tests/mpi/bench_ranks)
#   page     scaling.md and its pictures from what DIR (out beside this script) holds; parts that it does not hold are those
#            that the page was last made from (docs/results/scaling)
#
# Prints a JSON line a run and keeps them in DIR/PART.jsonl; README.md says what the keys mean. `page` writes into docs of this
# checkout when all parts are there and none was quick, else into DIR. --quick: small systems and few layouts, less than a minute.
#
# SCREE, CORES (all), RUNS (3; hybrid 5), LAUNCH (mpirun; e.g. srun: is given -n RANKS -c THREADS), SHARE (58: edge of the
# share of a core in `weak`), STRONG (100), WORK (folder that keeps the packing), BENCH (bench_ranks) may be set.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
cores=${CORES:-$(env -u OMP_NUM_THREADS nproc)}

quick=
if [ "${1:-}" = --quick ]; then
    quick=yes
    shift
fi
case ${1:-} in
-*)
    sed -n '3,22s/^# \{0,1\}//p' "$0"
    [ "$1" = --help ]
    exit
    ;;
esac
out=${1:-$(results out)}
[ $# = 0 ] || shift
[ $# != 0 ] || set -- weak strong hybrid ranks counts ghosts pupcs lengths page
mkdir -p "$out"
out=$(cd "$out" && pwd)

if [ -n "$quick" ]; then
    layouts=${LAYOUTS:-1x1 1x2 2x1} runs=${RUNS:-1} hybrid_runs=${RUNS:-1} weak_edge=${SHARE:-20} strong_edge=${STRONG:-24}
    edges=${RANKS:-2 3} blocks=1 sizes= domains=brick rank_steps=40 steps=100
else
    layouts=${LAYOUTS:-1x1 1x2 2x1 2x2 4x1} runs=${RUNS:-3} hybrid_runs=${RUNS:-5} weak_edge=${SHARE:-58} strong_edge=${STRONG:-100}
    edges=${RANKS:-2 3 4 5} blocks="1 2 3 4" sizes="15 20" domains="brick bisection" rank_steps=40 steps=200
fi

# record PART RANKS THREADS SCENE FLAG...: a run; its line goes to the terminal and to the part's file
record() {
    part=$1 ranks=$2 threads=$3 scene=$4
    shift 4
    set -- "$SCREE" run "$scene" -o "$out/run" --overwrite --quiet --set threads="$threads" "$@"
    [ $((ranks * threads)) -le "$cores" ] || set -- env OMP_WAIT_POLICY=passive "$@"
    if [ -n "${LAUNCH:-}" ]; then
        set -- $LAUNCH -n "$ranks" -c "$threads" "$@"
    else
        set -- on_ranks "$ranks" "$@"
    fi
    "$@" >"$out/said" 2>&1 || {
        cat "$out/said" >&2
        exit 1
    }
    line=$(awk -v head="\"series\": \"$part\", \"scene\": \"$(basename "$scene" .yaml)\", \"share\": $share" -v cores="$cores" \
        -f "$here/figures.awk" "$out/run/report.json")
    echo "$line" | tee -a "$out/$part.jsonl"
}

# gas PART RANKS THREADS X Y Z FLAG...: the gas in a box with these edges
gas() {
    part=$1 ranks=$2 threads=$3 upper="[$4, $5, $6]"
    shift 6
    record "$part" "$ranks" "$threads" "$here/scene.yaml" --set box.upper="$upper" "$@"
}

# blocks N: three factors of N, as near to a cube as can be, largest first
blocks() {
    awk -v n="$1" 'BEGIN {
        for (a = 1; a <= n; a++)
            for (b = 1; b <= a && n % a == 0; b++)
                if (n / a % b == 0 && n / a / b <= b && (!least || a + b + n / a / b < least)) {
                    least = a + b + n / a / b
                    best = a " " b " " n / a / b
                }
        print best }'
}

run_weak() {
    share=$weak_edge
    turn=0
    while [ $turn -lt "$runs" ]; do
        for layout in $layouts; do
            workers=$((${layout%x*} * ${layout#*x}))
            # shellcheck disable=SC2046
            set -- $(blocks $workers)
            gas weak "${layout%x*}" "${layout#*x}" $(($1 * share)) $(($2 * share)) $(($3 * share)) --set step.count=$steps
        done
        turn=$((turn + 1))
    done
}

run_strong() {
    share=$strong_edge
    turn=0
    while [ $turn -lt "$runs" ]; do
        for layout in $layouts; do
            gas strong "${layout%x*}" "${layout#*x}" "$share" "$share" "$share" --set step.count=$steps
        done
        turn=$((turn + 1))
    done
}

run_hybrid() {
    share=10
    work=${WORK:-${TMPDIR:-/tmp}/scree-bench}
    mkdir -p "$work"
    data=$work/bidisperse-10${quick:+-quick}.data
    if [ ! -s "$data" ]; then
        # shellcheck disable=SC2086
        "$SCREE" pack bidisperse "$data" ratio=10 ${quick:+box=80 large=15 small=41745} velocity=1 threads="$cores" >&2
    fi
    count=${quick:+48}
    sed "s|@DATA@|$data|; s|@EVERY@|16|; s|@STEPS@|${count:-100}|" "$here/../bench/bidisperse.yaml" >"$out/bidisperse.yaml"
    both=2
    [ "$cores" = 1 ] || both=$cores
    turn=0
    while [ $turn -lt "$hybrid_runs" ]; do
        for layout in 1x1 1x$both ${both}x1; do
            record hybrid "${layout%x*}" "${layout#*x}" "$out/bidisperse.yaml" --set index="${INDEX:-bytype}"
        done
        turn=$((turn + 1))
    done
}

run_ranks() {
    share=10
    for domain in $domains; do
        for edge in $edges; do
            side=$((edge * share))
            gas ranks $((edge * edge * edge)) 1 $side $side $side --set step.count=$rank_steps --set step.rebuild_every=20 --set domain.name=$domain \
                $([ $domain = brick ] || echo --set domain.threshold=0)
        done
    done
    for share in $sizes; do
        side=$((3 * share))
        gas ranks 27 1 $side $side $side --set step.count=$rank_steps --set step.rebuild_every=20
    done
    share=8
    for block in $blocks; do
        side=$((3 * share))
        awk -v blocks="$block" -v cells=$share -f "$here/boulders.awk" >"$out/spheres.txt"
        cp "$here/boulders.yaml" "$out"
        record ranks $((27 * block)) 1 "$out/boulders.yaml" --set box.upper="[$((block * side)), $side, $side]" \
            --set step.count=$rank_steps --set step.rebuild_every=20 --set domain.x=$((3 * block)) --set domain.y=3 --set domain.z=3
    done
}

run_ghosts() {
    SCREE=$SCREE RATIOS=${quick:+10} LARGE=${quick:+20} SMALL=${quick:+20000} "$here/ghosts.sh" "$out"
}

run_counts() {
    SCREE=$SCREE THREADS=${quick:+1 2} RANKS=${quick:+1 2} SCENES=${quick:+gas} "$here/counts.sh" "$out"
}

run_pupcs() {
    SCREE=$SCREE RUNS=$runs STEPS=${quick:+20} "$here/../pupcs/run.sh" "$out/pupcs" ${quick:+1x1}
    # shellcheck disable=SC2086
    SCREE=$SCREE STEPS=${quick:+5} RADII=${quick:+1 30} "$here/../pupcs/sizes.sh" "$out/pupcs" ${quick:+1}
}

run_lengths() {
    bench=${BENCH:-$examples/../build/tests/mpi/bench_ranks}
    command -v "$bench" >/dev/null || { echo "no $bench here: make tests/mpi/bench_ranks, or set BENCH" >&2; exit 1; }
    # shellcheck disable=SC2086
    "$bench" ${quick:+1000 10000} | tee "$out/lengths.jsonl"
}

# The page, from DIR, and from what it was last made from where DIR has nothing
run_page() {
    documents=$examples/../docs
    kept=$documents/results/scaling
    [ -w "$documents" ] || documents=$out
    parts="counts/lines.jsonl counts/section.md ghosts/lines.jsonl ghosts/section.md weak.jsonl strong.jsonl hybrid.jsonl ranks.jsonl lengths.jsonl pupcs/lines.jsonl pupcs/section.md pupcs/sizes.jsonl pupcs/sizes.md"
    mkdir -p "$out/pupcs" "$out/ghosts" "$out/counts"
    for part in $parts; do
        if [ ! -s "$out/$part" ] && [ -s "$kept/$part" ]; then cp "$kept/$part" "$out/$part"; fi
        case $part in counts/*) [ -s "$out/$part" ] || continue ;; esac # the page can do without
        if [ ! -s "$out/$part" ] || [ -e "$out/${part%/*}.quick" ] || [ -e "$out/${part%.*}.quick" ]; then documents=$out; fi
    done
    "$here/page.sh" "$out" "$documents" >&2
    [ "$documents" != "$out" ] || return 0
    mkdir -p "$kept/pupcs" "$kept/ghosts" "$kept/counts"
    for part in $parts; do
        if [ -s "$out/$part" ]; then cp "$out/$part" "$kept/$part"; fi
    done
}

for part in "$@"; do
    case $part in
    weak | strong | hybrid | ranks | lengths)
        : >"$out/$part.jsonl"
        rm -f "$out/$part.quick"
        [ -z "$quick" ] || : >"$out/$part.quick"
        "run_$part"
        ;;
    counts | ghosts | pupcs)
        mkdir -p "$out/$part"
        rm -f "$out/$part.quick"
        [ -z "$quick" ] || : >"$out/$part.quick"
        "run_$part"
        ;;
    page) run_page ;;
    *)
        echo "no part '$part'; there are: weak strong hybrid ranks counts ghosts pupcs lengths page" >&2
        exit 2
        ;;
    esac
done
