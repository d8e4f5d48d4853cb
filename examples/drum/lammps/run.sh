#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Makes a CSV of the zone counts with LAMMPS: run.sh [RANKS] [STEPS] [CSV]
# Needs Debian's packages lammps and openmpi-bin; the 625,000 steps (0.5 s) take an hour or more.
set -e
here=$(cd "$(dirname "$0")" && pwd)
ranks=${1:-2}
steps=${2:-625000}
csv=${3:-$here/../lammps.csv}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

tsuji() { awk -v e="$1" -f "$here/../../penetration/lammps/tsuji.awk"; }
gzip -dc "$here/../particles.txt.gz" | awk -f "$here/data.awk" >"$work/data"
mpirun --allow-run-as-root --oversubscribe --bind-to none --mca mpi_yield_when_idle 1 -n "$ranks" \
    lmp -in "$here/in.drum" -log "$work/log" -var data "$work/data" -var out "$work/out" -var every 12500 \
    -var steps "$steps" -var e50 "$(tsuji 0.5)" -var e45 "$(tsuji 0.45)" -var e40 "$(tsuji 0.4)"
awk 'BEGIN { print "time[s],m1_upper,m2_upper,m1_lower,m2_lower" }
    !/^#/ { printf "%s,%.0f,%.0f,%.0f,%.0f\n", $2, $3, $4, $5, $6 }' "$work/out" >"$csv"
grep '^Loop time' "$work/log"
