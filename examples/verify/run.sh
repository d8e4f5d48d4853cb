#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Runs the verification cases and says which hold: run.sh [--quick] [--ranks N] [--threads N] [--index NAME] [CASE...],
# or run.sh --layouts [--all] [CASE...]: quick ones on every index and on several ranks and threads (layouts.sh)
#
# A line a case: `CASE: passed|failed, figure, tolerance`; the figure is the one that comes nearest to its tolerance (or
# passes it). Fails if a case failed. With all cases, at full length and on one rank, writes docs/accuracy.md and the pictures in
# docs/images of this checkout; otherwise they go into the folder of the results (VERIFY_RESULTS, or out beside this script).
set -u
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
export SCREE OMP_WAIT_POLICY=passive
VERIFY_QUICK=no
args=
while [ $# -gt 0 ]; do
    case $1 in
    --quick) VERIFY_QUICK=yes ;;
    --ranks) VERIFY_RANKS=$2 && shift ;;
    --threads) VERIFY_THREADS=$2 && shift ;;
    --layouts) shift && exec "$here/layouts.sh" "$@" ;;
    --index) args="$args --set index=$2" && shift ;;
    --help | -*)
        sed -n '3,8s/^# //p' "$0"
        [ "$1" = --help ]
        exit
        ;;
    *) break ;;
    esac
    shift
done
VERIFY_ARGS="${VERIFY_ARGS:-}$args"
export VERIFY_QUICK VERIFY_RANKS VERIFY_THREADS VERIFY_ARGS

all=$(cd "$here" && for check in */check; do dirname "$check"; done | LC_ALL=C sort)
results=${VERIFY_RESULTS:-$(results out)}
documents=$results
docs=$here/../../docs
if [ $# = 0 ] && [ "$VERIFY_QUICK$VERIFY_ARGS${VERIFY_RANKS:-1}" = no1 ] && [ -w "$docs" ] && [ -z "${VERIFY_RESULTS:-}" ]; then
    documents=$docs
fi
VERIFY_IMAGES=
[ $VERIFY_QUICK = yes ] || VERIFY_IMAGES=$documents/images
export VERIFY_IMAGES
mkdir -p "$results" "$documents/images" || exit 1
[ $# -gt 0 ] || eval "set -- $(echo $all)"

failed=0
ran=
for name in "$@"; do
    if [ ! -x "$here/$name/check" ]; then
        echo "no case '$name'; there are: $(echo $all)" >&2
        exit 2
    fi
    mkdir -p "$results/$name"
    rm -f "$results/$name/figures" "$results/$name/source"
    VERIFY_OUT=$results/$name "$here/$name/check" >"$results/$name/said" 2>&1
    status=$?
    awk -F'|' -v name="$name" -v status=$status -f "$here/line.awk" "$results/$name/figures" 2>/dev/null ||
        echo "$name: failed, no figures"
    if [ $status != 0 ]; then
        failed=$((failed + 1))
        sed 's/^/    /' "$results/$name/said"
    fi
    ran="$ran $name"
done
"$here/table.sh" "$results" "$documents" $ran
echo "$# cases, $failed failed; table: $documents/accuracy.md"
[ $failed = 0 ]
