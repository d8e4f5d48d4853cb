#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Hertz contacts with given damping against LAMMPS's gran/hertz/history (tests/app/lammps/in.hertz): forces and torques at the
# start, positions and velocities after 200 steps. crosscode.sh makes the same comparison for Hooke.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1
data=$top_srcdir/tests/app/lammps
cp "$data/hertz.data" . && gzip -dc "$data/hertz0.dump.gz" >theirs0 && gzip -dc "$data/hertz200.dump.gz" >theirs200 || exit 1

cat >hertz.yaml <<'YAML'
title: spheres in a periodic cube, Hertz contacts, as LAMMPS computes them
units: none
box: {periodic: true}
step: {dt: 0.0002, count: 200}
integrator: velocity_verlet
contact: {law: hertz, damping: coefficient, end: overlap, lammps_history: true}
materials: [{name: a, density: 1.5}]
material_pairs: [{k_n: 20000, k_t: 8000, gamma_n: 30, gamma_t: 12, friction: 0.4}]
particles: {file: hertz.data, format: lammps-data}
skin: 0.3
output: {dump: {every: 200, fields: [id, radius, position, velocity, angular_velocity, force, torque]}}
YAML

agrees() { # RANKS SETTING...: every difference within 1e-10, at the start and at the end
    local ranks=$1
    shift
    rm -rf run ours0 ours200
    run_scene "$ranks" hertz.yaml run "$@" || return 1
    awk '/^ITEM: TIMESTEP/ { getline step; file = "ours" step; print >file; print step >file; next } { print >file }' run/dump.lammpstrj
    for step in 0 200; do
        awk -f "$top_srcdir/examples/bidisperse/compare.awk" theirs$step ours$step | awk '
            { print "  " $0; for (k = 2; k <= NF; k += 2) if (!($k <= 1e-10)) bad = 1 } END { exit bad || NF != 8 }' || return 1
    done
}
check 'Hertz with given damping, as LAMMPS has it' agrees 1
check 'so on another index, and newton off' agrees 1 --set index.name=brute --set newton=off
check 'so on four ranks' agrees 4

# The older name of the key, in the file and on the command line
sed 's/lammps_history/lammps_hooke/' hertz.yaml >older.yaml
older_in_file() {
    "$scree" check older.yaml >told 2>&1 && grep -q 'NOTE: contact.lammps_hooke is an older name of lammps_history' told
}
older_set() {
    "$scree" check hertz.yaml --set contact.lammps_hooke=true >told 2>&1 &&
        grep -q 'NOTE: contact.lammps_hooke is an older name of lammps_history' told
}
silent() {
    "$scree" check hertz.yaml >told 2>&1 && ! grep -q 'older name' told
}
check 'the older name of the key is read, and named' older_in_file
check 'so in --set' older_set
check 'and not where it is not used' silent

finish
