#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Makes ../lammps.csv (ball against time) with LAMMPS: run.sh [RANKS] [STEPS] [CSV]
# Needs Debian's packages lammps and openmpi-bin; the 200,000 steps take minutes.
set -e
here=$(cd "$(dirname "$0")" && pwd)
ranks=${1:-2}
steps=${2:-200000}
csv=${3:-$here/../lammps.csv}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

tsuji() { awk -v e="$1" -f "$here/tsuji.awk"; }
gzip -dc "$here/../particles.txt.gz" | awk -f "$here/data.awk" >"$work/data"
mpirun --allow-run-as-root --oversubscribe --bind-to none --mca mpi_yield_when_idle 1 -n "$ranks" \
    lmp -in "$here/in.penetration" -log "$work/log" -var data "$work/data" -var out "$work/out" -var every 1000 -var skin 0.0006 \
    -var steps "$steps" -var e11 "$(tsuji 0.5)" -var e12 "$(tsuji 0.4)" -var e22 "$(tsuji 0.6)"
awk 'BEGIN { print "time[s],ball_z[m],ball_vz[m/s]" } !/^#/ { print $2 "," $3 "," $4 }' "$work/out" >"$csv"
grep '^Loop time' "$work/log"
