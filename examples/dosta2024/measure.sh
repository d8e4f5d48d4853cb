#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Measures cases on this machine, which should have no other work, and adds their rows to the page: measure.sh [--short] [--step STEP] [CASE ...]
# All eight cases if none is named. WORK (out-measure beside this script) keeps the runs. Exit status 1 if a case did not pass.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
export LC_ALL=C
short= step=published
while [ $# -gt 0 ]; do
    case $1 in
    --short) short=--short ;;
    --step)
        step=${2:?measure.sh: --step needs a word}
        shift
        ;;
    *) break ;;
    esac
    shift
done
test $# != 0 || set -- impact25 impact50 impact100 drum silo-large-m1 silo-small-m1 silo-large-m2 silo-small-m2
work=${WORK:-$(results out-measure)}
mkdir -p "$work"
failed=0
for name; do
    load=$(cut -d ' ' -f 1 /proc/loadavg)
    # shellcheck disable=SC2086
    "$here/run.sh" "$name" $short --step "$step" "$work/$name-$step" >"$work/$name.jsonl" || failed=1
    tail -n 1 "$work/$name.jsonl"
    # a short run has no result of a whole one, so its row has none
    tail -n 1 "$work/$name.jsonl" | awk -v short="$short" -v load="$load" -v when="$(date +%Y-%m)" -f "$here/row.awk" >>"$here/rows.tsv"
done
"$here/page.sh"
exit $failed
