#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Runs the verification cases and says which hold: run.sh [--quick] [--ranks N] [--threads N] [--index NAME] [CASE...],
# or run.sh --layouts [--all] [CASE...]: quick ones on every index and on several ranks and threads (layouts.sh)
# or run.sh --page [CASE...]: runs nothing, takes what earlier runs at full length and on one rank left into docs/accuracy.md
#
# A line a case: `CASE: passed|failed, figure, tolerance`; the figure is the one that comes nearest to its tolerance (or
# passes it). Fails if a case failed. With all cases, at full length and on one rank, writes docs/accuracy.md and the pictures in
# docs/images of this checkout; otherwise they go into the folder of the results (VERIFY_RESULTS, or out beside this script), from
# where --page takes them: so the page can be filled in parts, and each section names the revision that computed it.
set -u
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
export SCREE OMP_WAIT_POLICY=passive
VERIFY_QUICK=no
args=
take=no
while [ $# -gt 0 ]; do
    case $1 in
    --quick) VERIFY_QUICK=yes ;;
    --ranks) VERIFY_RANKS=$2 && shift ;;
    --threads) VERIFY_THREADS=$2 && shift ;;
    --layouts) shift && exec "$here/layouts.sh" "$@" ;;
    --page) take=yes ;;
    --index) args="$args --set index=$2" && shift ;;
    --help | -*)
        sed -n '3,11s/^# //p' "$0"
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
kept=part
if [ "$VERIFY_QUICK$VERIFY_ARGS${VERIFY_RANKS:-1}" = no1 ]; then
    kept=section
fi
if [ $# = 0 ] && [ $kept$take = sectionno ] && [ -w "$docs" ] && [ -z "${VERIFY_RESULTS:-}" ]; then
    documents=$docs
fi

# page_take CASE...: sections and pictures of the results into the page of this checkout
page_take() {
    files=
    for name in "$@"; do
        [ -e "$results/$name/section.md" ] || { echo "no results of '$name' at full length in $results" >&2; exit 2; }
        files="$files $results/$name/section.md"
        [ ! -s "$results/images/verify-$name.svg" ] || cp "$results/images/verify-$name.svg" "$docs/images/"
        echo "$name: $(sed -n 's/.*\(Revision: [^ ]*\)\.$/\1/p' "$results/$name/section.md")"
    done
    "$here/table.sh" "$docs/accuracy.md" $files
    echo "$# cases; table: $docs/accuracy.md"
}
if [ $take = yes ]; then
    # shellcheck disable=SC2046
    [ $# -gt 0 ] || set -- $(cd "$results" && for file in */section.md; do dirname "$file"; done)
    page_take "$@"
    exit
fi

# section CASE: its heading, from the title of its scene, source, revision and figures
section() {
    printf '## %s\n\n%s. ' "$1" "$(sed -n 's/^title: //p' "$here/$1/scene.yaml")"
    printf 'Reference: %s. Revision: %s.\n\n' "$(cat "$results/$1/source" 2>/dev/null)" "$revision"
    echo '| figure | reference | computed | error | tolerance | order | |'
    echo '|---|---|---|---|---|---|---|'
    sed 's/|/ | /g; s/^/| /; s/$/ |/; s/  */ /g' "$results/$1/figures" 2>/dev/null
    [ ! -s "$documents/images/verify-$1.svg" ] || printf '\n![%s](images/verify-%s.svg)\n' "$1" "$1"
}
revision=$("$SCREE" --version 2>/dev/null | sed -n 's/.*(\([0-9a-f][^)]*\)).*/\1/p' | head -n 1)
VERIFY_IMAGES=
[ $VERIFY_QUICK = yes ] || VERIFY_IMAGES=$documents/images
export VERIFY_IMAGES
mkdir -p "$results" "$documents/images" || exit 1
[ $# -gt 0 ] || eval "set -- $(echo $all)"

failed=0
files=
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
    section "$name" >"$results/$name/$kept.md"
    files="$files $results/$name/$kept.md"
done
rm -f "$documents/accuracy.md"
# shellcheck disable=SC2086
"$here/table.sh" "$documents/accuracy.md" $files
echo "$# cases, $failed failed; table: $documents/accuracy.md"
[ $failed = 0 ]
