#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Two settings, or two programs, in turns: compare.sh [--quick] A B, where A and B are settings of a scene ("" for none)
#
#   compare.sh "" step.fused=false               what the fused step gains
#   compare.sh "" "index=linkcell classes.method=one"
#   SCREE_B=../before/scree compare.sh "" ""     the program as it was
#
# Runs the bidisperse packing R = 10 (96 steps, a rebuild every 16) with A and with B, PAIRS (11; 6 at least) times in turns, A first in one
# pair and B in the next. One JSON line a run; the last line is the summary: gain is the median over the pairs of B's loop
# time over A's, with the interval that holds the median with a probability of at least 95 % (from the order of the pairs);
# the same for step and rebuild alone.
#
# SCREE (A's program), SCREE_B (B's; the same), THREADS (all cores), PAIRS, SCENE_LAW (another law and keys of scree pack), WORK may
# be set. --quick: a cube of edge 80, 6 pairs.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/packing.sh"
quick=
if [ "${1:-}" = --quick ]; then
    quick=yes
    shift
fi
test $# = 2 || { echo 'usage: compare.sh [--quick] "SETTINGS" "SETTINGS"' >&2; exit 2; }
first=$1
second=$2
program_a=$SCREE
program_b=${SCREE_B:-$SCREE}
threads=${THREADS:-$cores}
pairs=${PAIRS:-$(by_mode 6 11)}
test "$pairs" -ge 6 2>/dev/null || { echo "compare.sh: PAIRS=$pairs; needed: 6 or more, or no interval holds the median with 95 %" >&2; exit 2; }
steps=96
law=${SCENE_LAW:-bidisperse ratio=10 velocity=1}
test -z "$quick" || law=${SCENE_LAW:-bidisperse ratio=10 box=80 large=15 small=41744 velocity=1}
# shellcheck disable=SC2086
packed $law
rows=$work/compare.rows
: >"$rows"

# once SIDE SETTINGS: a line of JSON; the loop, the step without rebuilds, the rebuilds into WORK/compare.figures
once() {
    # shellcheck disable=SC2086
    packing_run threads="$threads" classes.method=auto step.count=$steps observables.every=$steps step.rebuild_every=16 $2
    echo "$(report seconds) $(stages sweep advance contact decide) $(stages $rebuild_stages)" >"$work/compare.figures"
    awk -v side="$1" -v settings="$2" -v threads="$threads" -v n="$particles" -v steps=$steps '{
        printf "{\"side\": \"%s\", \"settings\": \"%s\", \"threads\": %d, \"seconds\": %.6g, \"particles\": %d, \"ns_per_particle\": %.6g, \"step_seconds\": %.6g, \"rebuild_seconds\": %.6g}\n",
            side, settings, threads, $1, n, 1e9 * $1 / steps / n, $2, $3 }' "$work/compare.figures"
}
side_a() {
    SCREE=$program_a
    once A "$first"
    a=$(cat "$work/compare.figures")
}
side_b() {
    SCREE=$program_b
    once B "$second"
    b=$(cat "$work/compare.figures")
}
pair=0
while [ $pair -lt "$pairs" ]; do
    if [ $((pair % 2)) = 0 ]; then
        side_a
        side_b
    else
        side_b
        side_a
    fi
    echo "$a $b" >>"$rows"
    pair=$((pair + 1))
done

# interval A B: median and interval of column B over column A, sorted ratios in
interval() {
    awk -v a="$1" -v b="$2" '$a > 0 { print $b / $a }' "$rows" | sort -g | awk '
        { v[NR] = $1 }
        function tail(k, j, p, term) { # probability that at most k of NR lie below the median
            term = 0.5 ^ NR
            p = term
            for (j = 1; j <= k; j++) { term *= (NR - j + 1) / j; p += term }
            return p
        }
        END {
            for (k = 0; k + 1 <= NR / 2 && 2 * tail(k) <= 0.05; k++) ;
            low = k > 0 ? k : 1
            printf "%.4g, \"interval\": [%.4g, %.4g]", NR % 2 ? v[(NR + 1) / 2] : (v[NR / 2] + v[NR / 2 + 1]) / 2, v[low], v[NR + 1 - low]
        }'
}
awk -v first="$first" -v second="$second" -v threads="$threads" -v n="$particles" -v steps=$steps '
    { sum += $1 }
    END { printf "{\"summary\": true, \"A\": \"%s\", \"B\": \"%s\", \"pairs\": %d, \"threads\": %d, \"seconds\": %.6g, \"particles\": %d, \"ns_per_particle\": %.6g, ",
        first, second, NR, threads, sum / NR, n, 1e9 * sum / NR / steps / n }' "$rows"
echo "\"gain\": $(interval 1 4), \"step\": {\"gain\": $(interval 2 5)}, \"rebuild\": {\"gain\": $(interval 3 6)}}"
