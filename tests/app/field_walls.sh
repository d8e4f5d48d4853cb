#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Meshes felt by distance fields: a drum beside that of triangles, layouts, resume, loads in files, a field that is free, messages.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

column() { # DIR NAME: its last value
    awk -F , -v name="$2" 'NR == 1 { for (k = 1; k <= NF; k++) { split($k, w, /[ (\[]/); if (w[1] == name) at = k } } END { print $at }' "$1/observables.csv"
}
rows() { # DIR: the last frame of the dump, by id
    tail -n "+$(grep -n '^ITEM: ATOMS' "$1/dump.lammpstrj" | tail -n 1 | cut -d : -f 1)" "$1/dump.lammpstrj" | grep -v '^ITEM' | sort -n
}

# A closed drum of radius 1 and length 0.6 about y, of 120 sides
awk 'BEGIN { n = 120; pi = atan2(0, -1)
    for (k = 0; k < n; k++) { a = 2 * pi * k / n; b = 2 * pi * ((k + 1) % n) / n
        printf "%.9g 0 %.9g %.9g 0.6 %.9g %.9g 0 %.9g\n%.9g 0 %.9g %.9g 0.6 %.9g %.9g 0.6 %.9g\n", cos(a), sin(a), cos(a), sin(a), cos(b), sin(b), cos(b), sin(b), cos(a), sin(a), cos(b), sin(b)
        printf "0 0 0 %.9g 0 %.9g %.9g 0 %.9g\n0 0.6 0 %.9g 0.6 %.9g %.9g 0.6 %.9g\n", cos(a), sin(a), cos(b), sin(b), cos(b), sin(b), cos(a), sin(a) } }' >drum.txt
cat >drum.yaml <<'YAML'
units: none
seed: 4
box: {lower: [-1.2, -0.2, -1.2], upper: [1.2, 0.8, 1.2]}
gravity: [0, 0, -10]
step: {count: 3000, dt: 0.0005}
contact: {law: hooke}
materials: [{name: a, density: 20}]
material_pairs: [{k_n: 1200, restitution: 0.5, friction: 0.5}]
walls: [{name: drum, shape: mesh, file: drum.txt, format: table, field: true, field_spacing: 0.02, motion: [{kind: rotate, direction: [0, 1, 0], rate: 2}]}]
particles: {from: random, count: 250, sizes: {law: uniform, min: 0.05, max: 0.08}, region: {shape: box, lower: [-0.7, 0.06, -0.65], upper: [0.7, 0.54, 0.6]}}
skin: 0.02
reproducible: true
observables: {every: 50, list: [{name: centre}, {name: wall_torque, target: drum}, {name: wall_force, target: drum}, {name: energy_kinetic}]}
output: {dump: {every: 1500, fields: [id, position, velocity, angular_velocity]}, checkpoint: {every: 1500}}
YAML
mean() { # DIR COLUMN: over the second half of the run
    awk -F , -v name="$2" 'NR == 1 { for (k = 1; k <= NF; k++) { split($k, w, /[ (\[]/); if (w[1] == name) at = k } next } $1 > 0.75 { sum += $at; n++ } END { print sum / n }' "$1/observables.csv"
}
depth() {
    rm -rf one triangles && run_scene 1 drum.yaml one --set threads=1 && run_scene 1 drum.yaml triangles --set 'walls[drum].field=false' --set 'walls[drum].field_spacing=~' || return 1
    echo "  mean height, place along x and torque: $(mean one centre_z) $(mean one centre_x) $(mean one drum_ty); of triangles $(mean triangles centre_z) $(mean triangles centre_x) $(mean triangles drum_ty)"
    within "$(mean one centre_z)" "$(mean triangles centre_z)" 0.01 && within "$(mean one centre_x)" "$(mean triangles centre_x)" 0.02 &&
        within "$(mean one drum_ty)" "$(mean triangles drum_ty)" "$(awk -v t="$(mean triangles drum_ty)" 'BEGIN { print 0.1 * sqrt(t * t) }')"
}
check 'a drum: the same depth as with triangles' depth
same() { rows other | cmp - one.rows && tail -n 1 other/observables.csv | cmp - one.row; }
rows one >one.rows
tail -n 1 one/observables.csv >one.row
layout() { rm -rf other && run_scene "$1" drum.yaml other --set "threads=$2" --set "index.name=$3" "${@:4}" && same; }
check 'the same bits on 2 ranks' layout 2 1 hgrid
check 'the same bits on 2 threads' layout 1 2 linkcell
check 'a resume on 2 ranks gives the same bits' layout 2 1 multi --resume one/checkpoint-1500.h5

# A cube whose faces a field knows exactly, free on a spring: what falls on it makes it sink by the weight; loads of triangles add up
awk 'BEGIN { split("0 2 1 1 2 3 4 5 6 5 7 6 0 1 4 1 5 4 2 6 3 3 6 7 0 4 2 2 4 6 1 3 5 3 7 5", c)
    for (t = 0; t < 12; t++) { for (k = 1; k <= 3; k++) { v = c[3 * t + k]; printf "%d %d %d ", v % 2, int(v / 2) % 2, int(v / 4) } print "" } }' >cube.txt
cat >tray.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [4, 4, 4]}
gravity: [0, 0, -10]
step: {count: 10000, dt: 0.0005}
contact: {law: hooke}
materials: [{name: a, density: 1}]
material_pairs: [{k_n: 2e4, restitution: 0.3, friction: 0.5}]
walls: [{name: tray, shape: mesh, file: cube.txt, format: table, scale: 2, offset: [1, 1, 0], field: true, free: {density: 0.5, freedom: along, direction: [0, 0, 1], spring: 500, damper: 60}}]
particles: {from: single, position: [2, 2, 2.6], radius: 0.5}
observables: {every: 10000, list: [{name: wall_offset, target: tray}, {name: wall_force, target: tray}]}
output: {walls: {every: 10000}, checkpoint: {at_end: false}}
YAML
sinks() {
    rm -rf sinks && run_scene 1 tray.yaml sinks && within "$(column sinks tray_z)" "$(awk 'BEGIN { printf "%.9g", -(4 + 0.523598776) * 10 / 500 }')" 1e-6 && [ -s sinks/walls-10000.vtp ]
}
check 'a free cube with a field' sinks
tells() { "$scree" check drum.yaml >told && grep -q 'field of spacing 0.02, .* MiB, error up to' told && grep -o 'field of spacing.*' told; }
check 'check tells spacing, memory and error' tells

# Large grains feel a small mesh from far: more than 5 GB of nodes
large() (
    ulimit -v 3000000
    "$scree" check drum.yaml >/dev/null 2>&1 || { echo '  this program cannot run with little memory'; return 0; }
    "$scree" check tray.yaml "$@" >/dev/null 2>said
    grep -q "wall 'tray': its field needs .* MiB, more than there are.*a larger field_spacing than" said || { cat said; return 1; }
)
check 'a field of more than the memory' large --set 'walls[tray].scale=0.5' --set particles.radius=0.8 --set particles.position='[2, 2, 3]'

grep -v '^0 0 0 ' drum.txt >open.txt
check 'an open mesh' scene_refused 'field|closed surface' drum.yaml --set 'walls[drum].file=open.txt'
check 'too fine' scene_refused "field_spacing is 0.0001, must be at least" drum.yaml --set 'walls[drum].field_spacing=0.0001'
check 'a spacing without a field' scene_refused 'walls[0].field_spacing|needs field: true' drum.yaml --set 'walls[drum].field=false'
check 'rocks' scene_refused 'walls[0].field|rocks' drum.yaml --set 'bodies={shapes: [{random: {corners: 12}}]}'
check 'two dimensions' scene_refused 'walls[0].field|three dimensions' drum.yaml --set box='{dimension: 2, lower: [-1, -1], upper: [1, 1]}' --set gravity='[0, -10]' \
    --set 'walls[drum].motion=~' --set particles.region='{shape: box, lower: [-0.5, -0.5], upper: [0.5, 0.5]}'
check 'another shape' scene_refused 'walls[0].field' tray.yaml --set 'walls=[{name: w, shape: box, lower: [1, 1, 1], upper: [2, 2, 2], field: true}]'
finish
