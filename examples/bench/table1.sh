#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The systems of Table 1 of Stratford, Shire and Hanley in scree alone: table1.sh R [--quick]
#
# R is 10, 20, 40, 80 or 100 (0.7 ... 66 million spheres). Prints seconds a step and a rebuild, and bytes a particle. Where memory is
# short (400 bytes a particle), the run is left out, with the memory that the bytes a particle of the last
# smaller system ask for. --quick: a cube of edge max(4 R, 80).
#
# One JSON line a run (seconds is one step, rebuilds included, a rebuild every 16 steps); the last line holds the medians.
# SCREE, THREADS (all cores), RUNS (3; quick: 1), WORK (keeps the packings) may be set.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/packing.sh"
quick_after 1 "table1.sh 10|20|40|80|100 [--quick]" "$@"
ratio=$1
table1_system "$ratio" || wrong_call
threads=${THREADS:-$cores}
runs=${RUNS:-$(by_mode 1 3)}
steps=32
every=16
cube=$(table1_cube "$(by_mode "$(quick_edge "$ratio")" "${table%% *}")")
expected=$(echo "$cube" | awk '{ split($2, a, "="); split($3, b, "="); print a[2] + b[2] }')
known=$work/table1.bytes # bytes a particle of the last system that ran
if ! memory_for $((expected * 400)); then
    each=$(cat "$known" 2>/dev/null || echo null)
    needs=null
    test "$each" = null || needs=$(calc "$each * $expected")
    echo "table1.sh: $expected particles are left out: $((expected * 400)) bytes are not free" >&2
    echo "{\"summary\": true, \"R\": $ratio, \"threads\": $threads, \"seconds\": null, \"particles\": $expected, \"ns_per_particle\": null, \
\"bytes_per_particle\": $each, \"memory\": $needs, \"left_out\": \"memory is short\"}"
    exit 0
fi
packing=$work/table1-$ratio${quick:+-quick}
particles=$expected
# shellcheck disable=SC2086
test -s "$packing.h5" || "$SCREE" pack bidisperse "$packing.h5" --overwrite ratio="$ratio" $cube velocity=1 threads="$cores" >&2
: >"$work/table1.runs"
run=0
while [ $run -lt "$runs" ]; do
    packing_run threads="$threads" classes.method=auto step.count=$steps observables.every=$steps step.rebuild_every=$every
    figures="$(report seconds) $(stages $rebuild_stages) $(report rebuilds) $(report bytes_per_particle) $(report memory_peak)"
    echo "$figures" >>"$work/table1.runs"
    run=$((run + 1))
    test $run = "$runs" || echo "$figures" | awk -v R="$ratio" -v threads="$threads" -v n="$particles" -v steps=$steps '{
        printf "{\"R\": %d, \"threads\": %d, \"seconds\": %.6g, \"particles\": %d, \"ns_per_particle\": %.6g, \"rebuild_seconds\": %.6g, \"bytes_per_particle\": %.5g}\n",
            R, threads, $1 / steps, n, 1e9 * $1 / steps / n, $2 / $3, $4 }'
done
echo "$(median 1 "$work/table1.runs") $(median 2 "$work/table1.runs") $(median 3 "$work/table1.runs") $(median 4 "$work/table1.runs") \
$(median 5 "$work/table1.runs")" | awk -v R="$ratio" -v threads="$threads" -v n="$particles" -v steps=$steps '{
    printf "{\"summary\": true, \"R\": %d, \"threads\": %d, \"seconds\": %.6g, \"particles\": %d, \"ns_per_particle\": %.6g, \"rebuild_seconds\": %.6g, \"bytes_per_particle\": %.5g, \"memory\": %.0f}\n",
        R, threads, $1 / steps, n, 1e9 * $1 / steps / n, $2 / $3, $4, $5 }'
median 4 "$work/table1.runs" >"$known"
