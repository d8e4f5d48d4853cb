#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The bidisperse example against LAMMPS's forces and positions: every index, newton on and off, on 1, 2 and 4 ranks, 1 and 2
# threads. `make check-long` tries all layouts of these, `make check` two of each index, and one of brute.
set -eu
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
export SCREE=$top_builddir/scree
check=$top_srcdir/examples/bidisperse/check
status=0
if [ -n "${SCREE_LONG:-}" ]; then
    "$check" "$out" || status=1
else
    fast="linkcell multi bytype hgrid"
    INDEXES=$fast NEWTON=on RANKS=4 THREADS=2 "$check" "$out" || status=1
    INDEXES=$fast NEWTON=off RANKS=2 THREADS=1 "$check" "$out" || status=1
    INDEXES=brute NEWTON=on RANKS=2 THREADS=1 "$check" "$out" || status=1
fi
exit $status
