#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Puts sections of cases into a page of accuracy: table.sh PAGE FILE...
#
# A section replaces that of the same case; sections of other cases stay as they are, with the revision that each names, as long as the
# case is there. A page that is not there is made.
set -u
page=$1
shift
here=$(cd "$(dirname "$0")" && pwd)
old=
[ ! -e "$page" ] || old=$page
# shellcheck disable=SC2086
{
    cat "$here/accuracy.head.md"
    awk -v cases="$(cd "$here" && echo */check)" '
        FNR == 1 { name = "" }
        /^## / { name = substr($0, 4); if (!(name in text)) names[++n] = name; text[name] = "" }
        name != "" { text[name] = text[name] $0 "\n" }
        END {
            for (a = 2; a <= n; a++)
                for (b = a; b > 1 && names[b] < names[b - 1]; b--) { swap = names[b]; names[b] = names[b - 1]; names[b - 1] = swap }
            for (k = 1; k <= n; k++)
                if (index(" " cases " ", " " names[k] "/check ")) { sub(/\n+$/, "\n", text[names[k]]); printf "\n%s", text[names[k]] }
        }' $old "$@"
} >"$page.new" && mv "$page.new" "$page"
