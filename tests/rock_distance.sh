#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Distances, normals and overlaps of random pairs of rocks against FCL, where that and a compiler of C++ are there (Debian: libfcl-dev, g++):
# rock_distance.sh [PAIRS], in the build folder `top_builddir=$PWD ../tests/launch ../tests/rock_distance.sh 1000000`. `make check-long` takes 100,000 pairs, `make
# check` none, as FCL takes long to compile. libccd alone: `SCREE_PAIRS=1000000 ../tests/launch tests/physics/bodies/shapes/test_touch`.
set -eu
pairs=${1:-${SCREE_LONG:+100000}}
if [ -z "$pairs" ]; then
    echo 'skipped: distances of rocks against FCL: make check-long tries them'
    exit 0
fi
if ! flags=$(pkg-config --cflags --libs fcl 2>/dev/null) || ! command -v "${CXX:-g++}" >/dev/null; then
    echo 'skipped: distances of rocks against FCL: needs libfcl-dev and g++'
    exit 0
fi
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
program=$top_builddir/tests/physics/bodies/shapes/rock_pairs
[ -x "$program" ] || make -s -C "$top_builddir" tests/physics/bodies/shapes/rock_pairs >&2
# shellcheck disable=SC2086
"${CXX:-g++}" -O2 -w "$top_srcdir/tests/physics/bodies/shapes/fcl_pairs.cpp" -o "$out/fcl_pairs" $flags
"$program" "$pairs" | "$out/fcl_pairs"
