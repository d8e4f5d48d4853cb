#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Each stage under the roof of this machine: roofline.sh [--quick]
#
# The roof: a triad and multiplications with additions, on one thread and on all (tests/bench_triad). Under it the step and the
# stages of a rebuild of the bidisperse packing R = 10 (711,907 spheres, Hooke contacts with slip history, 96 steps, a rebuild every
# 16). Bytes are compulsory ones: what must be read once and written once, however good the cache. With p pairs and c
# contacts a particle they are, a particle:
#
#   step      192 + 8 p + 56 c   state 64 and spin 32 read and written; the pairs (4 + 4) read; the springs
#                                (3 x 8 + 4) read and written
#   reorder   306                positions read where they lie (64), the order written and read (8), state 64, spin 32, id 8,
#                                class 1, image 12 read and written
#   index     84                 positions read (64), three coordinates and a radius in single precision and a slot written (20)
#   pairs     20 + 8 p           these read, the pairs written
#   history   88 + 8 p + 56 c    positions read and kept (64 + 24), the pairs read, the springs read and written
#
# and floating point operations (divisions and roots count one): step 33 + 13 p + 177 c (kick and drift; the filter's distance;
# gather, contact law, scatter), pairs 10 p (one test a pair), else none that matter.
#
# One JSON line a loop or stage: seconds is one execution, gigabytes_per_second the compulsory bytes over it, share that over
# the lower of the two roofs (bandwidth x operations a byte, or peak). The last line is the summary: step_over_compulsory is the time of
# a step over that of its compulsory bytes at the triad's bandwidth; step_speed_up and rebuild_speed_up, one thread over all.
#
# --quick: a cube of edge 80 (42 thousand spheres: they fit into the cache). Needs `make tests/bench_triad`; TRIAD (that program),
# SCREE, CORES (all), RUNS (5; quick: 3), WORK may be set.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/packing.sh"
quick_after 0 "roofline.sh [--quick]" "$@"
triad=$(built TRIAD "${TRIAD:-}" tests/bench_triad)
runs=${RUNS:-$(by_mode 3 5)}
steps=96
every=16
cube=
test -z "$quick" || cube="box=80 large=15 small=41744"
# shellcheck disable=SC2086
packed bidisperse ratio=10 $cube velocity=1

rows=$work/roofline.rows
: >"$rows"
# measure THREADS: the loops, then the stages
measure() {
    "$triad" "$1" ${quick:+64} | tee "$work/roofline.roof"
    : >"$work/roofline.runs"
    run=0
    while [ $run -lt "$runs" ]; do
        packing_run threads="$1" index=auto classes.method=auto step.count=$steps observables.every=$steps step.rebuild_every=$every
        echo "$(stages sweep advance contact decide) $(stages reorder) $(stages index) $(stages pairs) $(stages history) $(stages migrate)" \
            >>"$work/roofline.runs"
        run=$((run + 1))
    done
    echo "$(median 1 "$work/roofline.runs") $(median 2 "$work/roofline.runs") $(median 3 "$work/roofline.runs") $(median 4 "$work/roofline.runs") \
$(median 5 "$work/roofline.runs") $(median 6 "$work/roofline.runs")" | awk -v threads="$1" -v n="$(report particles)" -v pairs="$(report pairs)" \
        -v contacts="$(report contacts)" -v rebuilds="$(report rebuilds)" -v steps=$steps -v memory="$(report bytes_per_particle)" \
        -v triad="$(value gigabytes_per_second "$(grep triad "$work/roofline.roof")")" \
        -v peak="$(value gigaflops "$(grep peak "$work/roofline.roof")")" '
        function print_stage(name, seconds, bytes, flops, roof, best) {
            bytes *= n
            flops *= n
            best = bytes / (1e9 * triad) > flops / (1e9 * peak) ? bytes / (1e9 * triad) : flops / (1e9 * peak)
            printf "{\"stage\": \"%s\", \"threads\": %d, \"particles\": %d, \"seconds\": %.6g, \"ns_per_particle\": %.5g, \"bytes\": %.5g, \"flops\": %.5g, ",
                name, threads, n, seconds, 1e9 * seconds / n, bytes / n, flops / n
            printf "\"gigabytes_per_second\": %.4g, \"gigaflops\": %.4g, \"share\": %.3g, \"bytes_per_particle\": %.4g, \"pairs\": %.4g, \"contacts\": %.4g}\n",
                1e-9 * bytes / seconds, 1e-9 * flops / seconds, best / seconds, memory, p, c
        }
        {
            p = pairs / n
            c = contacts / n
            print_stage("step", $1 / steps, 192 + 8 * p + 56 * c, 33 + 13 * p + 177 * c)
            print_stage("reorder", $2 / rebuilds, 306, 0)
            print_stage("index", $3 / rebuilds, 84, 0)
            print_stage("pairs", $4 / rebuilds, 20 + 8 * p, 10 * p)
            print_stage("history", $5 / rebuilds, 88 + 8 * p + 56 * c, 0)
            print_stage("rebuild", ($2 + $3 + $4 + $5 + $6) / rebuilds, 498 + 24 * p + 56 * c, 10 * p)
        }' | tee -a "$rows"
}
measure 1
test "$cores" = 1 || measure "$cores"
awk -v threads="$cores" -v triad="$(value gigabytes_per_second "$(grep triad "$work/roofline.roof")")" '
    function value(key) {
        match($0, "\"" key "\": [^,}]*")
        return substr($0, RSTART + length(key) + 4, RLENGTH - length(key) - 4) + 0
    }
    /"stage": "step"/ { step[value("threads")] = value("seconds"); bytes = value("bytes") }
    /"stage": "rebuild"/ { rebuild[value("threads")] = value("seconds"); n = value("particles"); memory = value("bytes_per_particle") }
    END {
        compulsory = bytes * n / (1e9 * triad)
        printf "{\"summary\": true, \"threads\": %d, \"particles\": %d, \"seconds\": %.6g, \"ns_per_particle\": %.5g, ", threads, n, step[threads],
            1e9 * step[threads] / n
        printf "\"triad_gigabytes_per_second\": %s, \"compulsory_seconds\": %.5g, \"step_over_compulsory\": %.4g, \"rebuild_seconds\": %.6g, ", triad,
            compulsory, step[threads] / compulsory, rebuild[threads]
        printf "\"step_speed_up\": %.4g, \"rebuild_speed_up\": %.4g, \"bytes_per_particle\": %.4g}\n", step[1] / step[threads],
            rebuild[1] / rebuild[threads], memory
    }' "$rows"
