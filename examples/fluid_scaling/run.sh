#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Messages, bytes and iterations of a fluid on many ranks, counted: run.sh [--quick] [DIR]
#
# Weak scaling of flow through an array of spheres (scene.yaml), transient and steady, on more ranks than there are cores: only counts have a
# meaning, no time is taken. A rank has 32,480 fluid particles on 1 to 8 ranks (LARGE, "1 2 4 8"), and 4,060, as many as in the largest published
# run of implicit SPH, on 1 to 64 (SMALL, "1 8 27 64"). count_calls.c stands between the program and MPI and counts all
# messages, those of PETSc and hypre too. Each flow runs twice, longer the second time; the difference is what a step, or ten iterations, send.
#
# Prints a line of JSON for each, also to DIR/fluid_scaling.jsonl (section.sh makes a section of docs/pores.md from it). --quick: few ranks,
# less than half a minute. SCREE, MPICC (mpicc) may be set; --only-transient, --only-steady leave the other one out.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"

large=${LARGE-1 2 4 8} small=${SMALL-1 8 27 64} schemes='transient steady'
out=
while [ $# -gt 0 ]; do
    case $1 in
        --quick) large='' small='1 2 4' ;;
        --only-transient) schemes=transient ;;
        --only-steady) schemes=steady ;;
        -*) echo "run.sh: $1: allowed are --quick, --only-transient, --only-steady" >&2; exit 2 ;;
        *) out=$1 ;;
    esac
    shift
done
out=${out:-$(results out)}
mkdir -p "$out"
out=$(cd "$out" && pwd)
export OMP_WAIT_POLICY=passive OMP_NUM_THREADS=1
"${MPICC:-mpicc}" -O1 -shared -fPIC "$here/count_calls.c" -o "$out/count_calls.so"

# once RANKS X Y Z NAME SETTING=VALUE...: one run, whose counts go to DIR/NAME.counts and its report to DIR/NAME/report.json
once() {
    ranks=$1 box="[$(($2 * 19)), $(($3 * 19)), $(($4 * 19))]" name=$5
    shift 5
    rm -f "$out/$name.counts"
    set -- "$SCREE" run "$here/scene.yaml" -o "$out/$name" --overwrite --quiet --set "box.upper=$box" --set "particles.sources[0].region.upper=$box" "$@"
    on_ranks "$ranks" env LD_PRELOAD="$out/count_calls.so" COUNT_FILE="$out/$name.counts" "$@" >"$out/$name.said" 2>&1 || { cat "$out/$name.said" >&2; exit 1; }
}

# A transient flow of 1 and of 11 steps; a steady one of 10 and of 30 iterations, and one to its end.
weigh() { # SCHEME RANKS X Y Z
    scheme=$1 ranks=$2 x=$3 y=$4 z=$5 end=
    if [ "$scheme" = transient ]; then
        once "$ranks" "$x" "$y" "$z" short --set fluid.time=transient --set step.count=1
        once "$ranks" "$x" "$y" "$z" long --set fluid.time=transient --set step.count=11
    else
        once "$ranks" "$x" "$y" "$z" short --set fluid.time=steady --set step.count=1 --set fluid.solver.tolerance=0.99 --set guards.residual=off
        once "$ranks" "$x" "$y" "$z" long --set fluid.time=steady --set step.count=1 --set fluid.solver.tolerance=1e-4
    fi
    awk -v scheme="$scheme" -v folder="$out" -f "$here/counts.awk" "$out/short.counts" "$out/long.counts" | tee -a "$out/fluid_scaling.jsonl"
}

# blocks SHARE RANKS: edges, in spheres, of a box of RANKS cubes of SHARE spheres a side
blocks() {
    awk -v share="$1" -v n="$2" 'BEGIN {
        for (a = 1; a * a * a <= n; a++) if (n % a == 0) best = a
        m = n / best
        for (b = best; b * b <= m; b++) if (m % b == 0) second = b
        print share * m / second, share * second, share * best
    }'
}

: >"$out/fluid_scaling.jsonl"
for scheme in $schemes; do
    # shellcheck disable=SC2046
    for ranks in $large; do weigh "$scheme" "$ranks" $(blocks 2 "$ranks"); done
    # shellcheck disable=SC2046
    for ranks in $small; do weigh "$scheme" "$ranks" $(blocks 1 "$ranks"); done
done
