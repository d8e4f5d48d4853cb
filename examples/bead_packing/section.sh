#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The section of docs/pores.md about the packing of beads: section.sh RESULTS
# RESULTS: lines of run.sh, of one run or of several; each run ends with the line that has "richardson_pa". The first one is that of the picture.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
awk -v published="$here/published.txt" -f "$here/section.awk" "$1"
