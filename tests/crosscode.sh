#!/usr/bin/env bash
# The bidisperse example against LAMMPS's forces and positions, on every index, newton on and off, ranks and threads
set -eu
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
SCREE=$top_builddir/scree "$top_srcdir/examples/bidisperse/check" "$out"
