#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The pages as a site: made without a warning, with each function of the headers and of the Python package, and shown by a browser.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

# tool NAME: as configure found it
tool() { sed -n "s/^$1 = //p" "$top_builddir/Makefile"; }
sphinx=$(tool SPHINX)
python=$(head -n 1 "${sphinx:-/dev/null}" | sed -n 's/^#!//p')
if [ -z "$sphinx" ] || [ -z "$(tool DOXYGEN)" ] || ! ${python:-false} -c 'import myst_parser, furo, breathe' 2>/dev/null; then
    skip 'the site: no Sphinx with MyST, Furo, Doxygen and Breathe here (Debian: python3-sphinx python3-myst-parser furo doxygen python3-breathe)'
    exit 77
fi

made() { make -C "$top_builddir" --no-print-directory docs >said 2>&1 || { tail -n 20 said; return 1; }; }
check 'make docs, where a warning is an error' made

site=$top_builddir/site
# shows PAGE WORD...: the page has an entry for each
shows() {
    local page=$1 word
    shift
    for word in "$@"; do
        grep -q "id=\"\(c\.\)\?$word\"" "$site/docs/$page.html" || { echo "  no $word in $page.html"; return 1; }
    done
}
functions=$(grep -vhE '^(/\*| \*)' "$top_srcdir"/src/scree.h "$top_srcdir"/src/scree_pairs.h | grep -oE '\bscree_[a-z_]+\(' | tr -d '(' | sort -u)
# shellcheck disable=SC2086
check 'each function of the headers is in it' shows library $functions scree_options.log scree_status.SCREE_USER
names=$(sed -n 's/^    def \([a-z][a-z_]*\)(.*/scree.Simulation.\1/p' "$top_srcdir/src/front/python/scree/_simulation.py")
# shellcheck disable=SC2086
check 'each name of scree.Simulation, and scree.pairs' shows python $names scree.pairs scree.Scene scree.Error

picture=$top_builddir/tests/app/site.png
seen() {
    browse 120 --disable-gpu --hide-scrollbars --window-size=1200,800 --screenshot="$picture" "file://$site/docs/library.html" 2>/dev/null &&
        [ "$(wc -c <"$picture")" -gt 20000 ]
}
if [ -n "$browser" ]; then
    check 'a screenshot' seen
else
    skip 'the site in a browser: no chromium here'
fi
finish
