#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Runs the quick verification cases and the hard cases on every index and on 1 to 4 ranks of 1 and 2 threads: layouts.sh [--all] [CASE...]
#
# Every index on one rank, and every number of ranks and threads with one of the indexes in turn; --all: all of them together. A line a
# layout: `INDEX, N ranks, M threads: C cases, F failed`, then the lines of the failed. Fails if one failed. With no CASE the hard cases
# are run too, and docs/layouts.md is written (into the folder of the results where that cannot be). Cases that take a minute are left out
# unless named. LAYOUTS="INDEX,RANKS,THREADS ..." names the layouts.
set -u
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
export SCREE OMP_WAIT_POLICY=passive
layouts=${LAYOUTS:-brute,1,1 linkcell,1,1 multi,1,1 bytype,1,1 hgrid,1,1 brute,1,2 bytype,2,1 multi,2,2 linkcell,3,1 linkcell,4,1 hgrid,4,2}
if [ "${1:-}" = --all ]; then
    layouts=$(for index in brute linkcell multi bytype hgrid; do for ranks in 1 2 4; do for threads in 1 2; do echo "$index,$ranks,$threads"; done; done; done)
    shift
fi
cases=$*
hard=no
slow=" beverloo beverloo-3d drum-angle hard-beverloo hard-janssen hard-mu-of-i janssen settling "
if [ -z "$cases" ]; then
    hard=yes
    cases=$(cd "$here" && for check in */check; do name=$(dirname "$check") && [ "${slow#* "$name" }" != "$slow" ] || echo "$name"; done)
fi
results=${VERIFY_RESULTS:-$(results out)}/layouts
mkdir -p "$results" || exit 1
: >"$results/rows"
failed=0
for layout in $layouts; do
    index=${layout%%,*} ranks=${layout#*,} threads=${layout##*,}
    ranks=${ranks%,*}
    said=$results/$index-$ranks-$threads
    # shellcheck disable=SC2086
    VERIFY_RESULTS=$said.runs "$here/run.sh" --quick --index "$index" --ranks "$ranks" --threads "$threads" $cases >"$said" 2>&1
    [ $hard = no ] || "$here/../hard/run.sh" --quick --index "$index" --ranks "$ranks" --threads "$threads" >>"$said" 2>&1
    rm -rf "$said.runs"
    good=$(grep -c ': passed, ' "$said")
    bad=$(grep -c ': failed, ' "$said")
    failed=$((failed + bad + (good == 0)))
    echo "$index, $ranks ranks, $threads threads: $((good + bad)) cases, $bad failed"
    grep ': failed, ' "$said" | sed 's/^/    /'
    echo "| $index | $ranks | $threads | $((good + bad)) | $bad |" >>"$results/rows"
done
if [ $hard = yes ]; then
    documents=$here/../../docs
    [ -w "$documents" ] && [ -z "${VERIFY_RESULTS:-}" ] || documents=$results
    {
        echo '# Layouts'
        echo
        echo '`examples/verify/layouts.sh` runs the quick verification cases and the hard cases on several indexes, ranks and threads, each case with'
        echo 'its own tolerances (`docs/accuracy.md`, `docs/hard-cases.md`), and writes this page. With `--all` the script runs every index on every'
        echo 'number of ranks and threads; `layouts.sh [--all] CASE...` runs some cases. `tests/app/reproducible.sh` compares layouts to the last'
        echo 'bit, `tests/app/ranks.sh` and `tests/app/layouts.sh` within rounding.'
        echo
        echo '| index | ranks | threads | cases | failed |'
        echo '|---|---|---|---|---|'
        cat "$results/rows"
    } >"$documents/layouts.md"
fi
[ $failed = 0 ]
