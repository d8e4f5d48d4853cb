#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Ids of files: groups, observables, bond lists and dumps meet the grains that the files name, beside other sources, on several
# ranks, with particles inserted at run time and in a later stage, and after a resume.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

printf 'id radius x y z\n1 0.5 1 1 1\n' >a.txt
printf 'id radius x y z\n9 0.5 3 1 1\n10 0.5 4 1 1\n' >b.txt
printf 'c\n\n2 atoms\n1 atom types\n\n0 12 xlo xhi\n0 12 ylo yhi\n0 12 zlo zhi\n\nAtoms # sphere\n\n40 1 1 1 6 1 1\n30 1 1 1 8 1 1\n' >c.data
cat >files.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [12, 12, 12]}
gravity: [0, 0, -1]
step: {count: 200, dt: 0.001}
contact: {law: hooke}
materials: [{name: a, density: 1}]
material_pairs: [{k_n: 1000, restitution: 0.9}]
groups: [{name: held, motion: frozen, select: {ids: [10, 30]}}]
particles:
  sources:
    - {file: a.txt, format: table}
    - {file: b.txt, format: table}
    - {from: lattice, lattice: sc, spacing: 1.2, sizes: 0.5, count: 12, region: {shape: box, lower: [1, 1, 3], upper: [11, 11, 5]}}
    - {file: c.data, format: lammps-data}
    - {from: single, position: [10.5, 1, 1], radius: 0.5}
bonds: {list: bonds.txt, laws: [{k_n: 1000, k_s: 400}]}
insertions: [{sizes: 0.3, rate: 100, count: 4, region: {shape: box, lower: [1, 1, 8], upper: [11, 11, 11]}}]
observables: {every: 100, list: [{name: position, id: 30, label: held}, {name: position, id: 40, label: free}, {name: bonds}]}
output: {checkpoint: {every: 100}, dump: {every: 200, fields: [id, position, bonds]}}
YAML
printf '9 10\n' >bonds.txt

# frame FILE: id, x, z, bonds of the last frame, a row a particle
frame() { awk '/^ITEM: ATOMS/ { n = 0 } !/^ITEM/ { row[n++] = $0 } END { for (k = 0; k < n; k++) print row[k] }' "$1/dump.lammpstrj" | awk 'NF > 5'; }
# row DIR ID COLUMN: 1 id, 3-5 position, 6 bonds
row() { frame "$1" | awk -v id="$2" -v c="$3" '$1 == id { print $c }'; }
meets() { # DIR
    [ "$(row "$1" 10 3) $(row "$1" 10 5)" = '4 1' ] && [ "$(row "$1" 30 3) $(row "$1" 30 5)" = '8 1' ] &&
        [ "$(row "$1" 40 3)" = 6 ] && [ "$(row "$1" 40 5 | cut -c 1-3)" = 0.9 ] && [ "$(row "$1" 1 3)" = 1 ] &&
        [ "$(row "$1" 9 6) $(row "$1" 10 6) $(row "$1" 1 6)" = '1 1 0' ] &&
        [ "$(last_of "$1/observables.csv" held_x) $(last_of "$1/observables.csv" free_x)" = '8 6' ] || { frame "$1"; return 1; }
}
all_there() { # DIR: 2-8 and 11-15 are new, 16 is the single one, 41-44 are inserted
    [ "$(frame "$1" | awk '{ print $1 }' | tr '\n' ' ')" = '1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 30 40 41 42 43 44 ' ] || { frame "$1"; return 1; }
}
for ranks in 1 3; do
    check "ids of files stand, $ranks ranks" run_scene $ranks files.yaml run$ranks
    check "groups, observables and bonds meet them, $ranks ranks" meets run$ranks
    check "new ids leave them out, $ranks ranks" all_there run$ranks
done
resumed() { run_scene 2 files.yaml again --resume run1/checkpoint-100.h5 && meets again && all_there again; }
check 'after a resume' resumed
staged() {
    run_scene 2 files.yaml staged --set step.count=~ --set insertions[0].rate=1e-9 \
        --set 'stages=[{name: quiet, duration: 0.1}, {name: rain, duration: 0.1, set: {"insertions[0].rate": 2000}}]' && meets staged && all_there staged
}
check 'particles of a later stage' staged
of_h5md() { # a trajectory as a source keeps its ids
    run_scene 1 files.yaml first --set insertions=[] --set output.trajectory.every=200 --set step.count=0 &&
        run_scene 2 files.yaml second --set insertions=[] --set 'particles={sources: [{from: single, position: [6, 6, 10], radius: 0.5}, {file: first/trajectory.h5, format: h5md}]}' &&
        meets second && [ "$(row second 17 5 | cut -c 1-2)" = 9. ]
}
check 'an H5MD file as a source' of_h5md
sed '/^bonds/d; s/, bonds\]/]/' files.yaml >gap.yaml
check 'an observable of an id in a gap' scene_refused 'observables.list[0].id: there is no particle 20; ids go up to 40' gap.yaml \
    --set insertions=[] --set 'observables.list=[{name: position, id: 20}]'

finish
