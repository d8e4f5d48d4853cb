#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The bidisperse example against LAMMPS's forces and positions: every index, newton on and off, 1, 2, 4 ranks, 1, 2 threads.
# `brute` takes long: two layouts in `make check`, all in `make check-long`.
set -eu
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
export SCREE=$top_builddir/scree
check=$top_srcdir/examples/bidisperse/check
status=0
INDEXES="linkcell multi bytype hgrid" "$check" "$out" || status=1
if [ -n "${SCREE_LONG:-}" ]; then
    INDEXES=brute "$check" "$out" || status=1
else
    INDEXES=brute NEWTON=on RANKS=4 THREADS=1 "$check" "$out" || status=1
    INDEXES=brute NEWTON=off RANKS=2 THREADS=2 "$check" "$out" || status=1
fi
exit $status
