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
by_reader h5py
by_reader MDAnalysis

finish
