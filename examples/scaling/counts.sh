#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# What 1 to 64 threads and 1 to 64 ranks have to do, by counting: counts.sh [DIR]
#
# Four scenes: a gas (scene.yaml), spheres of radii 1 and 10 (`scree pack`), a bed (bed.yaml), a fluid through an array of spheres
# (../fluid_scaling). On threads the scene stays the same; on ranks gas, bed and fluid grow with the ranks. valgrind's callgrind counts two
# runs: of all threads of a rank, or of one rank among others that run at full speed. What the longer run has more are 16 steps of grains,
# with two rebuilds, or 4 of the fluid. More threads and ranks than cores only make the runs slow.
#
# A line of JSON a run, and in DIR/counts (out beside this script) the lines and a section for the page on scaling (section.md):
#
#   instructions      of the busiest thread in a step; on several ranks of the last rank, without those of MPI and of the C library
#   all, alone        of all threads together; of the first thread outside of parallel regions
#   regions, barriers parallel regions in a step, and barriers inside of these
#   collectives       reductions, broadcasts and the like of a rank in a step
#   messages, bytes   that a rank sends in a step, mean over ranks, as the report of the run has them (fluid: messages of the last rank, PETSc's
#                     among them, as the report knows those of grains alone)
#   memory            MB that the program counts in a rank at the end, mean
#
# THREADS, RANKS ("1 2 4 8 16 32 64"), SCENES ("gas sizes bed fluid"), SHARE (edge of the share of a rank, 10) may be set.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
command -v valgrind >/dev/null || { echo 'no valgrind here: apt-get install valgrind' >&2; exit 1; }
out=${1:-$(results out)}/counts
mkdir -p "$out"
out=$(cd "$out" && pwd)
share=${SHARE:-10}
numbers="1 2 4 8 16 32 64"
export OMP_WAIT_POLICY=passive GOMP_SPINCOUNT=0

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

# scene NAME RANKS: sets the words of the command line, `flags`, in lines, and `steps`
scene() {
    start=8 steps=16
    # shellcheck disable=SC2046
    set -- "$1" $(blocks "$2")
    case $1 in
    gas)
        x=$(($2 * share)) y=$(($3 * share)) z=$(($4 * share))
        flags="$here/scene.yaml
--set
box.upper=[$x, $y, $z]"
        ;;
    sizes)
        data=$out/sizes.data
        [ -s "$data" ] || "$SCREE" pack bidisperse "$data" ratio=10 box=80 large=15 small=41745 velocity=1 threads=1 >&2
        sed "s|@DATA@|$data|; s|@EVERY@|8|; s|@STEPS@|$steps|" "$here/../bench/bidisperse.yaml" >"$out/sizes.yaml"
        flags=$out/sizes.yaml
        ;;
    bed)
        x=$(($2 * share)) y=$(($3 * $4 * share))
        flags="$here/bed.yaml
--set
box.upper=[$x, $y, 12]
--set
particles.sources[0].region.upper=[$x, $y, 8]"
        ;;
    fluid)
        start=2 steps=4
        box="[$(($2 * 19)), $(($3 * 19)), $(($4 * 19))]"
        flags="$here/../fluid_scaling/scene.yaml
--set
box.upper=$box
--set
particles.sources[0].region.upper=$box
--set
fluid.time=transient"
        ;;
    esac
    [ "$1" = fluid ] || flags="$flags
--set
step.rebuild_every=8"
}

# watched STEPS RANKS COMMAND...: runs so many steps under callgrind (on several ranks the last one) and prints what it counts
watched() {
    count=$1 all=$2
    shift 2
    set -- "$@" --set "step.count=$count"
    rm -f "$out"/profile*
    # shellcheck disable=SC2016
    on_ranks "$all" sh -c 'last=$1 profile=$2; shift 2
        [ "${OMPI_COMM_WORLD_RANK:-${PMI_RANK:-0}}" != "$last" ] || exec valgrind --tool=callgrind --separate-threads=yes --callgrind-out-file="$profile" "$@"
        exec "$@"' sh $((all - 1)) "$out/profile" "$@" >"$out/said" 2>&1 || {
        cat "$out/said" >&2
        exit 1
    }
    awk -f "$here/counts.awk" "$out"/profile?*
}

# each KEY: the mean over ranks of a list of the report
each() {
    sed -n "s/^ *\"$1\": \[\(.*\)\].*/\1/p" "$out/run/report.json" | awk -F, '{ for (k = 1; k <= NF; k++) sum += $k; printf "%.6g", sum / NF }'
}

# counted KIND NAME RANKS THREADS SIZE: a line for the terminal and for the lines: a long run less a short one
counted() {
    kind=$1 name=$2 ranks=$3 threads=$4
    scene "$name" "$5"
    old=$IFS
    IFS='
'
    # shellcheck disable=SC2086
    set -- "$SCREE" run $flags -o "$out/run" --overwrite --quiet --set "threads=$threads"
    IFS=$old
    short=$(watched "$start" "$ranks" "$@")
    long=$(watched $((start + steps)) "$ranks" "$@")
    printf '%s\n%s\n' "$short" "$long" | awk -v kind="$kind" -v scene="$name" -v ranks="$ranks" -v threads="$threads" -v steps="$steps" -v all_steps=$((start + steps)) \
        -v particles="$(report_number "$out/run" particles)" -v messages="$(each messages)" -v bytes="$(each bytes)" \
        -v memory="$(report_number "$out/run" memory_held)" '
        NR == 1 { for (k = 1; k <= NF; k++) before[k] = $k; next }
        {
            for (k = 1; k <= NF; k++) {
                part[k] = ($k - before[k]) / steps
                if (k > 6) sum += part[k]
                if (k > 6 && part[k] > most) most = part[k]
            }
            printf "{\"kind\": \"%s\", \"scene\": \"%s\", \"ranks\": %d, \"threads\": %d, \"particles\": %d, \"steps\": %d, ", kind, scene, ranks, threads, particles, steps
            printf "\"instructions\": %.6g, \"all\": %.6g, \"alone\": %.6g, ", (ranks > 1 ? part[5] : most), sum, part[7] - part[6]
            printf "\"regions\": %.4g, \"barriers\": %.4g, \"collectives\": %.4g, ", part[1], part[2], part[3]
            printf "\"messages\": %.4g, \"bytes\": %.6g, \"memory\": %.4g}\n", (scene == "fluid" ? part[4] : messages / all_steps), bytes / all_steps, memory / ranks / 1e6
        }' | tee -a "$out/lines.jsonl"
}

: >"$out/lines.jsonl"
for one in ${SCENES:-gas sizes bed fluid}; do
    for n in ${THREADS:-$numbers}; do counted threads "$one" 1 "$n" 27; done
    for n in ${RANKS:-$numbers}; do counted ranks "$one" "$n" 1 "$n"; done
done
awk -f "$here/counts_section.awk" "$out/lines.jsonl" >"$out/section.md"
