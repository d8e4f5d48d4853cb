#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Rocks: a cube comes to rest on a floor; a gas of rocks keeps energy and momentum; rocks, clumps, spheres and a slab larger than a subdomain on
# ranks, threads and indexes; resume; files of meshes; messages.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

rows() { # DIR: the last frame of the dump, by id
    tail -n "+$(grep -n '^ITEM: ATOMS' "$1/dump.lammpstrj" | tail -n 1 | cut -d : -f 1)" "$1/dump.lammpstrj" | grep -v '^ITEM' | sort -n
}

# A cube that falls on an edge: it lies on four corners, sunk by m g / (4^(1/3) k), and does not rattle
cat >drop.yaml <<'YAML'
units: none
box: {lower: [-5, -5, -1], upper: [5, 5, 9]}
gravity: [0, 0, -10]
step: {dt: 2e-4, count: 20000}
contact: {law: hooke}
materials: [{name: rock, density: 1}]
material_pairs: [{k_n: 1e5, restitution: 0.3, friction: 0.5}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]
particles: {from: single, position: [0, 0, 1.2], radius: 1}
bodies:
  shapes: [{name: cube, vertices: [0,0,0, 1,0,0, 0,1,0, 1,1,0, 0,0,1, 1,0,1, 0,1,1, 1,1,1], rounding: 0.05, size: drawn, orientation: given, quaternion: [1, 0.3, 0.2, 0.1]}]
observables: {every: 1000, list: [{name: position, id: 1, components: z}, {name: energy_kinetic}, {name: energy_rotational}, {name: wall_force, target: floor}, {name: contacts}]}
output: {checkpoint: {at_end: false}}
YAML
rests() {
    run_scene 1 drop.yaml drop && tail -n 1 drop/observables.csv | awk -F, '{ print "  z " $2 ", energies " $3 " " $4 ", force " $7 ", contacts " $8
        exit !(($2 - (0.5 - 1e-4 / 4 ^ (1 / 3))) ^ 2 < 1e-20 && $3 < 1e-20 && $4 < 1e-20 && ($7 + 10) ^ 2 < 1e-12 && $8 == 1) }'
}
check 'a cube comes to rest on a face' rests
known() { # the mass of the sharp cube, moments a^2 / 6, the ball around the rounded one
    "$scree" check drop.yaml | awk '/^rocks .cube/ { print "  " $0; good = /8 corners, 6 faces, rounding 0.05/ && /radius of the ball 0.829423/ && /volume 1,/ && /0.166667 0.166667 0.166667/ } END { exit !good }'
}
check 'scree check knows the cube' known

# A gas of rocks without friction: the error of the energy is that of the time step
cat >gas.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [7, 7, 7], periodic: true}
step: {dt: 1e-4, count: 8000}
contact: {law: hooke, tangential: none}
materials: [{name: rock, density: 1}]
material_pairs: [{k_n: 1e4, restitution: 1}]
particles: {from: random, count: 36, sizes: {law: uniform, min: 0.8, max: 1}, velocity_sigma: 2}
bodies:
  shapes: [{name: rock, random: {corners: 14, variants: 8}, roundness: 0.2}]
observables: {every: 8000, list: [{name: energy_kinetic}, {name: energy_rotational}, {name: energy_elastic_normal}, {name: momentum}]}
output: {checkpoint: {at_end: false}}
YAML
gas() { # DIR BOUND RANKS SETTING...
    run_scene "$3" gas.yaml "$1" "${@:4}" && awk -F, -v bound="$2" 'NR == 2 { e = $2 + $3 + $4; for (k = 5; k < 8; k++) p[k] = $k; r = $3 }
        NR == 3 { e = ($2 + $3 + $4) / e - 1; for (k = 5; k < 8; k++) off += ($k - p[k]) ^ 2
            printf "  energy %.2g, momentum %.2g, energy of rotation from %g to %g\n", e, sqrt(off), r, $3
            exit !(e * e < bound * bound && off < 1e-20 && $3 > 1) }' "$1/observables.csv"
}
check 'a gas of rocks keeps energy and momentum' gas gas 4e-5 1
check 'on 3 ranks, too' gas gas3 4e-5 3
check 'at the whole stable step, too' gas gas_step 1e-2 1 --set step='{fraction: 1, count: 4000}' --set observables.every=4000

# The stable step: two contacts of a cube along faces, at both ends, of 30 x 4^(-2/3) x 4 x 0.45^2 springs each (test_stiff); of contacts that are there
cat >stack.txt <<'TABLE'
x y z vx vy vz radius
0 0 0.499 0 0 0 0.45
0.001 0.002 1.4985 1e-4 0 2e-4 0.45
0.003 0 2.498 0 1e-4 0 0.45
TABLE
stack() { # EXPRESSION SETTING...: of the stable step h that check finds for a stack of cubes between a floor and a lid
    "$scree" check drop.yaml --set 'particles={from: file, file: stack.txt, format: table}' --set bodies.shapes[0].quaternion='[1, 0, 0, 0]' \
        --set material_pairs='[{k_n: 1e5, restitution: 1}]' --set contact.tangential=none --set gravity='[0, 0, 0]' --set observables.list='[{name: energy}]' \
        --set walls='[{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}, {name: lid, shape: plane, point: [0, 0, 2.997], normal: [0, 0, -1]}]' \
        "${@:2}" | sed -n 's/^time step.*of the stable \([0-9.e+-]*\).*/\1/p' >stable && awk -v seat="$(awk 'BEGIN { print 30 / 4 ^ (2 / 3) * 4 * 0.45 ^ 2 }')" \
        "{ h = \$1; known = 2 / sqrt(4 * seat * 1e5); print \"  stable \" h \", of faces to come \" known; exit !($1) }" stable
}
check 'the stable step is that of faces' stack 'h > 0.9999 * known && h < 1.0001 * known' --set particles='{from: single, position: [0, 0, 1.5], radius: 1}'
check 'faces on faces lower it' stack 'h < 0.9 * known && h > 0.6 * known'

# Everything at once, between walls
cat >crowd.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [6, 6, 8], periodic: [true, true, false]}
gravity: [0, 0, -5]
step: {count: 1200, dt: 0.0002}
contact: {law: hooke}
materials: [{name: a, density: 1}, {name: b, density: 2}]
material_pairs: [{k_n: 10000, restitution: 0.8, friction: 0.3}]
groups: [{name: moves, motion: moving, velocity: [0.5, 0, 0], omega: [0, 0, 2]}]
walls:
  - {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1], material: a}
  - {name: lid, shape: plane, point: [0, 0, 8], normal: [0, 0, -1], material: a, motion: [{kind: oscillate, direction: [0, 0, 1], amplitude: 0.1, frequency: 5}]}
particles:
  sources:
    - {from: single, position: [3, 3, 3.2], radius: 2.6, material: b}
    - {from: single, position: [1, 1, 1], radius: 0.6, material: b, group: moves}
    - {from: random, count: 25, sizes: {law: uniform, min: 0.4, max: 0.6}, velocity_sigma: 3, material: b}
    - {from: random, count: 150, sizes: {law: uniform, min: 0.1, max: 0.3}, velocity_sigma: 6, material: a}
bodies:
  clumps: [{name: dumbbell, material: a, radius_above: 0.25, spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}]}]
  shapes:
    - {name: slab, material: b, radius_above: 2, vertices: [0,0,0, 4,0,0, 0,3,0, 4,3,0, 0,0,1, 4,0,1, 0,3,1, 4,3,1], rounding: 0.1, orientation: given, quaternion: [1, 0.2, 0.1, 0.3], angular_velocity: [1, 2, 0]}
    - {name: rock, material: b, random: {corners: 14, variants: 5}, roundness: 0.2}
skin: 0.05
observables: {every: 1200, list: [{name: energy}, {name: bodies}, {name: wall_force, target: lid}]}
output: {dump: {every: 1200, fields: [id, position, velocity, angular_velocity]}, checkpoint: {every: 600}}
YAML
alike() { # RANKS THREADS SETTING...
    local ranks=$1 threads=$2
    shift 2
    rm -rf other && run_scene "$ranks" crowd.yaml other --set "threads=$threads" --set reproducible=true "$@" && rows other | cmp - one.rows
}
check 'a crowd' run_scene 1 crowd.yaml one --set threads=1 --set reproducible=true
rows one >one.rows
met() { tail -n 1 one/observables.csv | awk -F, '{ print "  dissipated " $7; exit !($7 > 10) }'; }
check 'its particles meet' met
check 'the same bits: 2 ranks, 2 threads, brute' alike 2 2 --set index.name=brute
check 'the same bits: 3 ranks, bisection, multi' alike 3 1 --set domain.name=bisection --set index.name=multi
every() { # each of the other indexes, on 4, 1 or 2 ranks in turns
    local index k=0 ranks=(4 1 2)
    for index in $(indexes); do
        [[ $index =~ ^(auto|brute|multi)$ ]] || alike "${ranks[k++ % 3]}" $((1 + k % 2)) --set index.name="$index" || { echo "  $index"; return 1; }
    done
    echo "  $k indexes"
    [ $k -ge 2 ]
}
check 'the same bits on the other indexes, 4, 1 and 2 ranks' every
ablated() { # an ablation over the indexes: the same trajectories to rounding
    on 2 "$scree" ablate gas.yaml --error -o ablated --only index --duration 0.05 --samples 2 --repeat 1 --set output='~' --judge trajectory >said 2>&1 || { cat said; return 1; }
    awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) at[$k] = k; next } $at["settings"] == "as it is" { own = $at["trajectory_error"] }
        $1 == "index" { n++; d = $at["trajectory_error"] - own; if (!(d * d <= (1e-6 * own) ^ 2)) { bad = 1; print "  " $2, $at["trajectory_error"], own } }
        END { print "  " n " indexes, error " own; exit bad || n < 3 }' ablated/speed_error.csv
}
check 'an ablation over indexes finds the same motion' ablated
resumed() { rm -rf more && run_scene 3 crowd.yaml more --set reproducible=true --resume one/checkpoint-600.h5 && rows more | cmp - one.rows; }
check 'a resume on 3 ranks gives the same bits' resumed
near() { # RANKS SETTING...: without the reproducible mode
    rm -rf fast && run_scene "$1" crowd.yaml fast --set threads=1 "${@:2}" && rows fast | paste one.rows - | awk '{ n = NF / 2; for (k = 3; k <= 8; k++) { d = $k - $(k + n); d = d < 0 ? -d : d; if (d > most) most = d } }
        END { printf "  largest difference %.2g\n", most; exit !(NR > 200 && most < 1e-6) }'
}
check 'newton on, 4 ranks' near 4
check 'newton off, 2 ranks' near 2 --set newton=off

# Meshes: a cube of 12 triangles, one without its lid, an L
awk 'BEGIN { split("0 2 3 1 4 5 7 6 0 1 5 4 2 6 7 3 0 4 6 2 1 3 7 5", v, " ")
    for (s = 0; s < 6; s++) for (t = 0; t < 2; t++) { line = ""
        for (c = 0; c < 3; c++) { at = v[4 * s + (c ? t + c : 0) + 1]; line = line " " at % 2 " " int(at / 2) % 2 " " int(at / 4) }
        print line } }' >cube.txt
sed 3,4d cube.txt >open.txt
awk 'BEGIN { n = split("0 0 2 0 2 1 1 1 1 2 0 2", p, " "); m = n / 2 # a prism over an L
    for (k = 0; k < m; k++) { a = p[2 * k + 1] " " p[2 * k + 2]; l = (k + 1) % m; b = p[2 * l + 1] " " p[2 * l + 2]; print a, 0, b, 0, b, 1; print a, 0, b, 1, a, 1 }
    split("1 2 3 1 3 4 1 4 5 1 5 6", t, " ")
    for (k = 1; k <= 12; k += 3) { up = ""; down = ""
        for (c = 0; c < 3; c++) { i = t[k + c] - 1; j = t[k + 2 - c] - 1; up = up " " p[2 * i + 1] " " p[2 * i + 2] " 1"; down = down " " p[2 * j + 1] " " p[2 * j + 2] " 0" }
        print up; print down } }' >ell.txt
shape() { echo "bodies.shapes[0]={name: s, size: drawn, $1}"; }
of_file() { # VALUE TEXT: what check says of the shape
    "$scree" check drop.yaml --set "$(shape "$1")" | grep '^rocks' | grep -q "$2"
}
check 'a mesh as a rock' of_file 'file: cube.txt, rounding: 0.1' '8 corners, 6 faces.*volume 1,'
check 'the hull of an open mesh' of_file 'file: open.txt, hull: true, rounding: 0.1' '8 corners, 6 faces.*volume 1,'
check 'the hull of an L' of_file 'file: ell.txt, hull: true, rounding: 0.1' '10 corners, 7 faces.*volume 3.5,'

refused() { # TEXT SETTING...: one message with this text, exit status 2
    local text=$1 said
    shift
    said=$("$scree" check drop.yaml "$@" 2>&1 >/dev/null)
    [ $? = 2 ] && [ "$(wc -l <<<"$said")" = 1 ] && grep -q -- "$text" <<<"$said" || { echo "  $said"; return 1; }
}
cube='vertices: [0,0,0, 1,0,0, 0,1,0, 1,1,0, 0,0,1, 1,0,1, 0,1,1, 1,1,1]'
check 'refused: an open mesh' refused 'no closed surface' --set "$(shape 'file: open.txt')"
check 'refused: a mesh that is not convex' refused 'is not convex: it fills 0.857[0-9]* of its hull; hull: true' --set "$(shape 'file: ell.txt')"
check 'refused: a flat shape' refused 'has no volume' --set "$(shape 'vertices: [0,0,0, 1,0,0, 0,1,0, 1,1,0]')"
check 'refused: a sliver' refused 'is a sliver' --set "$(shape 'vertices: [0,0,0, 1,0,0, 0,1,0, 0.3,0.3,1e-4]')"
check 'refused: two numbers of a corner' refused 'three numbers x y z a corner' --set "$(shape 'vertices: [0,0,0, 1,0]')"
check 'refused: no shape' refused 'needs one of vertices, file and random' --set "$(shape 'rounding: 0.1')"
check 'refused: a rounding that leaves nothing' refused 'leaves no core' --set "$(shape "$cube, rounding: 0.5")"
check 'refused: no bodies' refused 'needs clumps or shapes' --set bodies.shapes='[]'
check 'refused: a periodic box that is too small' refused 'as large as a periodic edge' --set 'box={lower: [0, 0, 0], upper: [1.5, 5, 5], periodic: true}' --set particles.radius=0.7 --set walls='[]' --set observables.list='[{name: energy}]'
check 'refused: cohesion' refused 'is for spheres' --set contact='{law: hertz, cohesion: {law: dmt}}' --set 'materials=[{name: rock, density: 1, young: 1e6, poisson: 0.3}]' --set 'material_pairs=[{restitution: 0.3, friction: 0.5, surface_energy: 1}]'
check 'refused: a list of contacts' refused 'knows none of rocks' --set output.trajectory.contacts=100
check 'refused: loads on walls' refused 'know none of rocks' --set output.walls.every=100
check 'refused: two dimensions' refused 'in two dimensions' --set box.dimension=2 --set gravity=[0,-10,0] --set walls='[]' --set particles.position=[0,0,0] --set bodies.shapes[0].orientation=random --set bodies.shapes[0].quaternion=~ --set observables.list='[{name: energy}]'

finish
