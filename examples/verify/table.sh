#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Writes accuracy.md from the figures of the cases: table.sh RESULTS DOCUMENTS CASE...
set -u
results=$1
documents=$2
shift 2
here=$(cd "$(dirname "$0")" && pwd)
{
    cat "$here/accuracy.head.md"
    for name in "$@"; do
        # the heading of a case is the title of its scene
        printf '\n## %s\n\n%s. ' "$name" "$(sed -n 's/^title: //p' "$here/$name/scene.yaml")"
        printf 'Reference: %s.\n\n' "$(cat "$results/$name/source" 2>/dev/null)"
        echo '| figure | reference | computed | error | tolerance | order | |'
        echo '|---|---|---|---|---|---|---|'
        sed 's/|/ | /g; s/^/| /; s/$/ |/; s/  */ /g' "$results/$name/figures" 2>/dev/null
        [ ! -s "$documents/images/verify-$name.svg" ] || printf '\n![%s](images/verify-%s.svg)\n' "$name" "$name"
    done
} >"$documents/accuracy.md"
