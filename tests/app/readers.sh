#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Other programs read our trajectories: h5py and MDAnalysis, where a Python has them. Trajectories of floats and compressed
# ones hold the same numbers, and are smaller.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

cat >gas.yaml <<'EOF'
box: {lower: [-1 cm, 0, 0], upper: [3 cm, 3 cm, 2 cm], periodic: true}
step: {count: 20, dt: 1 us}
contact: {law: hooke}
materials: [{name: glass, density: 2500}]
material_pairs: [{restitution: 0.9, k_n: 1000}]
particles: {from: random, sizes: {law: uniform, min: 0.3 mm, max: 1 mm}, count: 2000, velocity_sigma: 0.1}
output: {trajectory: {every: 5, fields: [position, velocity, radius, force]}}
observables: {every: 5, list: [{name: energy}]}
EOF
traced() { # FOLDER RANKS SETTING...: a run
    local folder=$1 ranks=$2
    shift 2
    on "$ranks" "$scree" run gas.yaml -o "$folder" --overwrite --quiet "$@" >said 2>&1 || { cat said; return 1; }
}
check 'a trajectory of doubles' traced double 1
check 'without units' traced plain 1 --set output.trajectory.units=false
check 'of floats' traced single 1 --set output.trajectory.precision=single
check 'compressed' traced packed 1 --set output.trajectory.compression=4
check 'of floats, compressed, on three ranks' traced both 3 --set output.trajectory.precision=single --set output.trajectory.compression=4

size() {
    stat -c %s "$1/trajectory.h5"
}
smaller() { # FOLDER PERCENT: at most so much of the trajectory of doubles
    echo "  $1: $(($(size "$1") * 100 / $(size double))) % of $(size double) bytes"
    [ $(($(size "$1") * 100)) -le $(($(size double) * $2)) ]
}
check 'floats are smaller' smaller single 65
check 'so are compressed doubles' smaller packed 97
check 'and compressed floats' smaller both 60
values() { # FOLDER: the last frame as LAMMPS data, which scree reads back
    rm -f "$1.data"
    "$scree" convert "$1/trajectory.h5" "$1.data" >said 2>&1 || { cat said; return 1; }
}
same_values() {
    values double && values packed && cmp double.data packed.data
}
check 'compression changes no number' same_values
near_values() {
    values both && [ "$(wc -l <both.data)" = "$(wc -l <double.data)" ] && ! cmp -s double.data both.data
}
check 'floats read back' near_values
check 'a resume goes on in floats' traced both 2 --resume last --set step.count=30
# by_reader MODULE: a check in tests/app/readers.py, by the first Python that has the module
by_reader() {
    for python in "${PYTHON:-python3}" python3 /usr/bin/python3; do
        "$python" -W ignore -c "import $1" 2>/dev/null || continue
        check "read by $1" "$python" -W ignore "$top_srcdir/tests/app/readers.py" "$1"
        return
    done
    echo "skipped: no Python here has $1"
}
# walls: planes, a tube and a mesh that move, under a rain
cat >quad.obj <<'EOF'
v -0.01 -0.01 0
v 0.01 -0.01 0
v 0.01 0.01 0
v -0.01 0.01 0
f 1 2 3 4
EOF
cat >walls.yaml <<'EOF'
box: {lower: [-2 cm, -2 cm, 0], upper: [2 cm, 2 cm, 5 cm]}
gravity: [0, 0, -200]
step: {count: 600, dt: 10 us}
contact: {law: hooke}
materials: [{name: glass, density: 2500}]
material_pairs: [{restitution: 0.5, k_n: 1000}]
particles: {from: random, sizes: 1 mm, count: 150, velocity_sigma: 0.5,
            region: {shape: box, lower: [-8 mm, -8 mm, 16 mm], upper: [8 mm, 8 mm, 28 mm]}}
walls:
  - {name: floor, shape: plane, point: [0, 0, 1.3 cm], normal: [0.1, 0, 1]}
  - {name: funnel, shape: cone, point: [0, 0, 9 mm], axis: [0, 0, 1], radius: 4 mm, radius_end: 15 mm, length: 20 mm}
  - {name: plate, shape: disc, point: [0, 0, 3 mm], normal: [0, 0, 1], radius: 18 mm, hole: 5 mm,
     motion: [{kind: translate, velocity: [0, 0, 2]}]}
  - {name: tube, shape: cylinder, point: [0, 0, 2.5 cm], axis: [0, 0, 1], radius: 11.5 mm, length: 5 cm}
  - {name: step, shape: box, lower: [-2 mm, -2 mm, 1 mm], upper: [2 mm, 2 mm, 16 mm]}
  - {name: lid, shape: rectangle, point: [-1 cm, -1 cm, 29.5 mm], along: [2 cm, 0, 0], across: [0, 2 cm, 0]}
output: {walls: {every: 200}}
observables: {every: 200, list: [{name: wall_force}]}
EOF
sed -i 's/name: lid, .*/name: lid, shape: mesh, file: quad.obj, offset: [0, 0, 29.5 mm]}/' walls.yaml
walled() { # FOLDER RANKS SETTING...
    local folder=$1 ranks=$2
    shift 2
    on "$ranks" "$scree" run walls.yaml -o "$folder" --overwrite --quiet "$@" >said 2>&1 || { cat said; return 1; }
}
check 'walls on one rank' walled walls_one 1
check 'walls on three ranks' walled walls_three 3 --set step.count=400
check 'a resume goes on with the walls' walled walls_three 3 --resume last --set step.count=600
list_of() { # a frame each, in order
    [ "$(grep -o 'walls-[0-9]*' "$1/walls.pvd" | tr '\n' ' ')" = 'walls-0 walls-200 walls-400 walls-600 ' ]
}
check 'the list of frames' list_of walls_one
check 'the list of frames over a resume' list_of walls_three
by_reader vtkmodules
by_reader h5py
by_reader MDAnalysis

finish
