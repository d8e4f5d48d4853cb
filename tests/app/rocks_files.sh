#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Rocks, clumps and spheres that a run has written start another scene as they were: from trajectories, from dumps by way of `convert`, and rocks of
# tables by their columns; on several ranks; names, scales and messages.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

cat >gas.yaml <<'YAML'
units: none
seed: 5
threads: 1
reproducible: true
box: {lower: [-1, 0, 0], upper: [5, 5, 5], periodic: [true, true, false]}
step: {dt: 1e-4, count: 400}
contact: {law: hooke}
materials: [{name: a, density: 2}]
material_pairs: [{k_n: 1e4, restitution: 1, friction: 0}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}, {name: lid, shape: plane, point: [0, 0, 5], normal: [0, 0, -1]}]
particles:
  sources:
    - {from: random, shape: cube, count: 8, sizes: 0.5, velocity_sigma: 3, density: 3}
    - {from: random, shape: ballast, count: 8, sizes: {law: uniform, min: 0.3, max: 0.4}, velocity_sigma: 3, omega: [0, 1, 0]}
    - {from: random, count: 7, sizes: 0.3, velocity_sigma: 3}
    - {from: random, shape: dumbbell, count: 4, sizes: 0.3, velocity_sigma: 3}
bodies:
  clumps: [{name: dumbbell, spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1.5}]}]
  shapes:
    - {name: cube, vertices: [0,0,0, 1,0,0, 0,1,0, 1,1,0, 0,0,1, 1,0,1, 0,1,1, 1,1,1], rounding: 0.05, angular_velocity: [1, 2, 3]}
    - {name: ballast, random: {corners: 14, variants: 5}, roundness: 0.2}
observables: {every: 400, list: [{name: energy}, {name: momentum}]}
output:
  trajectory: {every: 200}
  dump: {every: 200, fields: [id, kind, body, body_part, body_mass, rock_shape, radius, mass, position, velocity, angular_velocity, rock_orientation]}
  checkpoint: {every: 400, at_end: false}
YAML
rows() { # DIR N: frame N of the dump, from 1, by id
    awk -v n="$2" '/^ITEM: TIMESTEP/ { frame++ } /^ITEM: ATOMS/ { on = frame == n; if (on) { sub(/^ITEM: ATOMS /, ""); print; next } } /^ITEM/ { on = 0 } on { print | "sort -n" }' "$1/dump.lammpstrj"
}
near() { # A B BOUND: two such frames; numbers agree to a part of their size, or of 1
    paste "$1" "$2" | awk -v bound="$3" 'NR == 1 { n = NF / 2; next } NF != 2 * n { bad = 1 }
        { for (k = 1; k <= n; k++) { d = $k - $(k + n); a = $k < 0 ? -$k : $k; if (!(d * d <= (bound * (a + 1)) ^ 2)) { if (!bad) print "  row", NR, "column", k, $k, $(k + n); bad = 1 } } }
        END { exit bad || NR < 20 }'
}
check 'a gas of rocks, clumps and spheres' run_scene 1 gas.yaml gas
rows gas 2 >middle && rows gas 3 >end

# From the middle of its trajectory: the same state, and the same way from there
again() { # RANKS DIR FLAG...
    run_scene "$1" gas.yaml "$2" --set 'particles={from: file, file: gas/trajectory.h5, format: h5md, frame: 1}' --set step.count=200 "${@:3}"
}
same() { rows again 1 >first && near first middle 1e-13; }
check 'its trajectory starts another scene' again 1 again
check 'with the same rocks, clumps and spheres' same
later() { rows again 2 >last && near last end 1e-9; }
check 'which goes on as the first one did' later
ranks() { again 3 ranks --set index.name=brute && rows ranks 1 | cmp - first && rows ranks 2 | cmp - last; }
check 'on 3 ranks, to the bit' ranks
boxed() { again 1 boxed --set 'box={periodic: [true, true, false]}' && rows boxed 2 | cmp - last; }
check 'with the box of the file' boxed
keyed() { # spheres of the file stay spheres, though an entry chooses grains of their radius
    again 1 keyed --set bodies.clumps[0].radius_above=0.2 --set step.count=0 && rows keyed 1 >keyed.rows && near keyed.rows middle 1e-13
}
check 'beside an entry that chooses by radius' keyed

# Without clumps the balls of rocks tell all: dumps have no other orientations
rocks_alone="particles.sources=[{from: random, shape: cube, count: 8, sizes: 0.5, velocity_sigma: 3, density: 3}, {from: random, shape: ballast, count: 8, sizes: 0.4, velocity_sigma: 3}, {from: random, count: 7, sizes: 0.3}]"
grains() { # of such a frame what counts of grains and balls, whatever their ids: by x
    awk 'NR == 1 { for (k = 1; k <= NF; k++) at[$k] = k; print "x" } NR == 1 || $at["kind"] == 0 { line = $at["x"]; n = split("y z radius mass vx vy vz omegax omegay omegaz rock_shape quatw quati quatj quatk", name, " ")
        for (k = 1; k <= n; k++) line = line " " $at[name[k]]; if (NR == 1) print line; else print line | "sort -g" }' | sed 1d
}
by_dump() {
    run_scene 1 gas.yaml alone --set "$rocks_alone" --set bodies.clumps='[]' && on 1 "$scree" convert alone/dump.lammpstrj dump.h5 &&
        run_scene 1 gas.yaml dumped --set bodies.clumps='[]' --set 'particles={from: file, file: dump.h5, format: h5md, frame: 1}' --set step.count=200 || return 1
    near <(rows alone 2 | grains) <(rows dumped 1 | grains) 1e-12 && near <(rows alone 3 | grains) <(rows dumped 2 | grains) 1e-9
}
check 'a dump starts another scene, by way of H5MD' by_dump
by_checkpoint() { # velocities of checkpoints are those of half a step before
    on 1 "$scree" convert gas/checkpoint-400.h5 check.h5 && run_scene 1 gas.yaml checked --set 'particles={from: file, file: check.h5, format: h5md}' --set step.count=0 || return 1
    rows checked 1 | awk 'NR == 1 { for (k = 1; k <= NF; k++) at[$k] = k } { print $at["id"], $at["x"], $at["y"], $at["z"], $at["rock_shape"], $at["quatw"], $at["quati"], $at["quatj"], $at["quatk"] }' >a
    awk 'NR == 1 { for (k = 1; k <= NF; k++) at[$k] = k } { print $at["id"], $at["x"], $at["y"], $at["z"], $at["rock_shape"], $at["quatw"], $at["quati"], $at["quatj"], $at["quatk"] }' end | near a - 1e-12
}
check 'a checkpoint does, too' by_checkpoint
copied() { # names of shapes are kept
    on 1 "$scree" convert gas/trajectory.h5 copy.h5 && run_scene 1 gas.yaml copied --set 'particles={from: file, file: copy.h5, format: h5md, frame: 1}' --set step.count=200 && rows copied 2 | cmp - last
}
check 'a copy of a trajectory has its shapes' copied

# Twice as large, with other spheres of the same material beside them, which stay spheres
scaled() {
    run_scene 1 gas.yaml scaled --set 'box={lower: [-2, 0, 0], upper: [10, 10, 30], periodic: [true, true, false]}' --set walls='[]' --set step.count=0 \
        --set 'particles.sources=[{from: file, file: gas/trajectory.h5, format: h5md, frame: 1, scale: 2}, {from: random, count: 9, sizes: 0.5, region: {shape: box, lower: [-2, 0, 12], upper: [10, 10, 30]}}]' || return 1
    rows scaled 1 | awk 'NR == 1 { for (k = 1; k <= NF; k++) at[$k] = k; next } $at["kind"] == 3 { n++; mass += $at["body_mass"] } $at["kind"] == 0 && $at["body"] < 0 { s++ } END { print n, s, mass }' >a
    awk 'NR == 1 { for (k = 1; k <= NF; k++) at[$k] = k; next } $at["kind"] == 3 { n++; mass += $at["body_mass"] } $at["kind"] == 0 && $at["body"] < 0 { s++ } END { print n, s + 9, 8 * mass }' middle >b
    cat a && paste a b | awk '{ exit !($1 == 20 && $1 == $4 && $2 == 16 && $2 == $5 && ($3 / $6 - 1) ^ 2 < 1e-18) }'
}
check 'twice as large, beside spheres' scaled

# Entries are found by their names, wherever they stand
cat >two.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [6, 6, 6]}
step: {dt: 1e-4, count: 1}
contact: {law: hooke}
materials: [{name: a, density: 2}]
material_pairs: [{k_n: 1e4, restitution: 1}]
particles: {sources: [{from: random, shape: box, count: 4, sizes: 0.5}, {from: random, shape: wedge, count: 3, sizes: 0.5}]}
bodies:
  shapes:
    - {name: box, vertices: [0,0,0, 3,0,0, 0,2,0, 3,2,0, 0,0,1, 3,0,1, 0,2,1, 3,2,1], rounding: 0.05}
    - {name: wedge, vertices: [0,0,0, 1,0,0, 0,1,0, 1,1,0, 0,0,1, 1,0,1], rounding: 0.05}
output: {trajectory: {every: 1}, dump: {every: 1, fields: [id, kind, rock_shape, position, rock_orientation]}}
YAML
swapped="bodies.shapes=[{name: sand, vertices: [0,0,0, 1,0,0, 0,1,0, 0,0,1], rounding: 0.05}, {name: wedge, vertices: [0,0,0, 1,0,0, 0,1,0, 1,1,0, 0,0,1, 1,0,1], rounding: 0.05}, {name: box, vertices: [0,0,0, 3,0,0, 0,2,0, 3,2,0, 0,0,1, 3,0,1, 0,2,1, 3,2,1], rounding: 0.05}]"
names() {
    run_scene 1 two.yaml two && run_scene 1 two.yaml swapped --set "$swapped" --set 'particles={from: file, file: two/trajectory.h5, format: h5md, frame: 0}' || return 1
    rows two 1 | awk 'NR > 1 && $NF >= 0 { $NF = $NF == 0 ? 2 : 1 } { print }' >a
    rows swapped 1 | awk 'NR > 1 && $NF < 0 && $3 == 3 { } { print }' >b
    sed 1d a | awk '{ print }' | sort -n >a2 && sed 1d b | sort -n >b2
    paste a2 b2 | awk '{ n = NF / 2; for (k = 1; k <= n; k++) bad += ($k - $(k + n)) ^ 2 > 1e-24 } END { exit bad || NR != 14 }'
}
check 'entries are found by name' names

# Tables: orientations in the frame of the entry, as `quaternion` has them
cat >one.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [6, 6, 6]}
step: {dt: 1e-4, count: 1}
contact: {law: hooke}
materials: [{name: a, density: 2}]
material_pairs: [{k_n: 1e4, restitution: 1, friction: 0.1}]
particles: {from: single, shape: box, position: [1, 2, 3], radius: 0.5, omega: [1, 0, 2]}
bodies: {shapes: [{name: box, orientation: given, quaternion: [1, 2, 3, 4], vertices: [0,0,0, 3,0,0, 0,2,0, 3,2,0, 0,0,1, 3,0,1, 0,2,1, 3,2,1], rounding: 0.05}]}
output: {dump: {every: 1, fields: [id, kind, rock_shape, radius, mass, position, angular_velocity, rock_orientation]}, checkpoint: {at_end: false}}
YAML
printf 'x y z radius shape qw qx qy qz omega_x omega_y omega_z\n1 2 3 0.5 box 2 4 6 8 1 0 2\n' >table.txt
printf 'x y z radius qw qx qy qz omega_x omega_y omega_z\n1 2 3 0.5 2 4 6 8 1 0 2\n' >turns.txt
printf 'x y z radius shape\n1 2 3 0.5 box\n4 4 4 0.3 -\n' >some.txt
table() {
    run_scene 1 one.yaml given && run_scene 1 one.yaml table --set 'particles={from: file, format: table, file: table.txt}' --set bodies.shapes[0].orientation=random --set bodies.shapes[0].quaternion='~' &&
        run_scene 1 one.yaml turns --set 'particles={from: file, format: table, file: turns.txt, shape: box}' --set bodies.shapes[0].orientation=random --set bodies.shapes[0].quaternion='~' || return 1
    cmp given/dump.lammpstrj table/dump.lammpstrj && cmp given/dump.lammpstrj turns/dump.lammpstrj
}
check 'a table with shapes and orientations' table
some() {
    run_scene 2 one.yaml some --set 'particles={from: file, format: table, file: some.txt}' && rows some 1 | awk 'NR == 1 { for (k = 1; k <= NF; k++) at[$k] = k; next }
        { rocks += $at["rock_shape"] >= 0; balls += $at["rock_shape"] < 0 && $at["kind"] == 0 && $at["radius"] == 0.3 } END { exit !(NR == 4 && rocks == 1 && balls == 1) }'
}
check 'rows without a shape stay spheres, on 2 ranks' some
dimer="bodies={clumps: [{name: pair, spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1.5}]}]}"
plane=(--set 'box={lower: [0, 0, 0], upper: [6, 6, 0], dimension: 2}' --set "$dimer" --set 'output.dump.fields=[id, kind, radius, position]' --set 'output.trajectory.every=1')
flat() { # clumps in two dimensions: a quarter turn about z
    printf 'x y radius shape qw qx qy qz\n1 2 0.5 pair 1 0 0 1\n' >flat.txt
    run_scene 1 one.yaml flat "${plane[@]}" --set 'particles={from: file, format: table, file: flat.txt}' &&
        run_scene 1 one.yaml flat2 "${plane[@]}" --set 'particles={from: file, format: h5md, file: flat/trajectory.h5, frame: 0}' || return 1
    rows flat 1 >a && rows flat2 1 >b && awk 'NR == 1 { for (k = 1; k <= NF; k++) at[$k] = k; next } $at["kind"] == 0 { n++; bad += ($at["x"] - 1) ^ 2 > 1e-20 } END { exit bad || n != 2 }' a &&
        paste a b | awk 'NR > 1 { n = NF / 2; for (k = 1; k <= n; k++) bad += ($k - $(k + n)) ^ 2 > 1e-20 } END { exit bad || NR != 4 }'
}
check 'clumps in two dimensions' flat

# Dumps of LAMMPS: quaternions of which the source says what they turn
cat >lammps.dump <<'TXT'
ITEM: TIMESTEP
0
ITEM: NUMBER OF ATOMS
1
ITEM: BOX BOUNDS ff ff ff
0 6
0 6
0 6
ITEM: ATOMS id type radius x y z c_q[1] c_q[2] c_q[3] c_q[4] omegax omegay omegaz
1 1 0.5 1 2 3 0.18257418583505536 0.3651483716701107 0.5477225575051661 0.7302967433402214 1 0 2
TXT
lammps() {
    on 1 "$scree" convert lammps.dump lammps.h5 && run_scene 1 one.yaml lammps --set 'particles={from: file, format: h5md, file: lammps.h5, shape: box}' --set bodies.shapes[0].orientation=random --set bodies.shapes[0].quaternion='~' || return 1
    rows given 1 >a && rows lammps 1 >b && paste a b | awk 'NR > 1 { n = NF / 2; for (k = 1; k <= n; k++) bad += ($k - $(k + n)) ^ 2 > 1e-24 } END { exit bad || NR != 3 }'
}
check 'a dump with quaternions, of which the source says the shape' lammps

# Messages
wrong() { # TEXT SCENE SETTING...
    check "refused: $1" scene_refused "$1" "$2" "${@:3}"
}
file='particles={from: file, file: gas/trajectory.h5, format: h5md}'
wrong "gas/trajectory.h5: has rigid bodies, and the scene has no section bodies" gas.yaml --set "$file" --set bodies='~' --set output.dump='~'
wrong "gas/trajectory.h5: has bodies of the shape 'ballast': no entry of bodies has the name 'ballast'; allowed: dumbbell, cube" gas.yaml --set "$file" --set bodies.shapes[1]='~'
wrong "gas/trajectory.h5: has bodies of the shape 'cube' with other corners than the entry of the scene" gas.yaml --set "$file" --set bodies.shapes[0].rounding=0.1
wrong "gas/trajectory.h5: has bodies of the shape 'ballast' with other corners" gas.yaml --set "$file" --set seed=6
wrong "gas/trajectory.h5: has bodies of the shape 'ballast' with other corners" gas.yaml --set "$file" --set bodies.shapes[1].random.variants=2
wrong "gas/trajectory.h5: has rigid bodies whose shapes it tells; leave \`shape\` of the source out" gas.yaml --set 'particles={from: file, file: gas/trajectory.h5, format: h5md, shape: cube}'
wrong "gas/trajectory.h5: has a body 'cube' in a ball of radius" gas.yaml --set "$file" --set bodies.shapes[0].size=drawn
wrong "gas/trajectory.h5: has a body of shape number 0" gas.yaml --set "$file" --set bodies.clumps='[]'
lost() {
    run_scene 1 gas.yaml lost --set 'output.trajectory.fields=[position, radius, kind, body, rock_shape, rock_orientation]' --set step.count=0 &&
        scene_refused "lost/trajectory.h5: has bodies, but not all fields that tell what they are; needed: kind, body, body_part and orientation" gas.yaml --set 'particles={from: file, file: lost/trajectory.h5, format: h5md}'
}
check 'refused: fields that are missing' lost
wrong "table.txt:1: there is a column of shapes, and the scene has no section bodies" one.yaml --set bodies='~' --set output.dump='~' --set 'particles={from: file, format: table, file: table.txt}'
wrong "table.txt:1: there is a column of shapes, and the source names one" one.yaml --set 'particles={from: file, format: table, file: table.txt, shape: box}'
wrong "turns.txt:1: there are orientations, and nothing says of what" one.yaml --set 'particles={from: file, format: table, file: turns.txt}'
wrong "an orientation has four columns: qw qx qy qz" one.yaml --set 'particles={from: file, format: table, file: turns.txt, shape: box, columns: [x, y, z, radius, qw, qx, qy, skip, skip, skip, skip]}'
sed '2s/2 4 6 8/0 0 0 0/' turns.txt >zero.txt && sed '2s/box/cube/' table.txt >cube.txt
wrong "zero.txt:2: the orientation is no quaternion" one.yaml --set 'particles={from: file, format: table, file: zero.txt, shape: box}'
wrong "cube.txt:2: no entry of bodies has the name 'cube'; allowed: box (or - for a sphere)" one.yaml --set 'particles={from: file, format: table, file: cube.txt}'
wrong "lammps.h5: has orientations, and nothing says of what" one.yaml --set 'particles={from: file, format: h5md, file: lammps.h5}'
sed 's/ c_q\[3\]//; 10s/0.5477225575051661 //' lammps.dump >three.dump
three() { on 1 "$scree" convert three.dump three.h5 >said 2>&1; [ $? = 2 ] && grep -qF 'there is no column for the j component among quatw quati quatj quatk' said || { cat said; return 1; }; }
check 'refused: a quaternion of three columns' three

# Files of shapes that are not there: the place in the scene
wrong "bodies.shapes[0].file: no.stl cannot be opened" one.yaml --set bodies.shapes[0].vertices='~' --set bodies.shapes[0].file=no.stl
missing() { # MESSAGE FROM TO: with another line of the scene
    sed "s/$2/$3/" one.yaml >missing.yaml && scene_refused "$1" missing.yaml
}
check 'refused: a file of a shape that is missing, by its line' missing "missing.yaml:8: bodies.shapes[0].file: no.stl cannot be opened" 'vertices: [^]]*\]' 'file: no.stl'
check 'refused: a mesh of a clump that is missing, by its line' missing "missing.yaml:8: bodies.clumps[0].mesh: no.stl cannot be opened" '^bodies:.*' 'bodies: {clumps: [{name: box, mesh: no.stl}]}'
finish
