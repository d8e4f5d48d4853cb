#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Rigid bodies of spheres: free flight against its closed form; collisions conserve momentum, angular momentum and energy; overlapping
# members; bodies larger than a subdomain on ranks, threads and indexes; prescribed bodies; resume; messages.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

rows() { # DIR: the last frame of the dump, by id
    tail -n "+$(grep -n '^ITEM: ATOMS' "$1/dump.lammpstrj" | tail -n 1 | cut -d : -f 1)" "$1/dump.lammpstrj" | grep -v '^ITEM' | sort -n
}

# A dumbbell thrown across two periodic sides: a symmetric top, whose rotation the scheme has without error
cat >flight.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [5, 5, 50], periodic: [true, true, false]}
gravity: [0, 0, -2]
step: {count: 1000, dt: 0.002}
contact: {law: hooke}
materials: [{name: a, density: 1}]
material_pairs: [{k_n: 1000, restitution: 0.9, friction: 0.3}]
particles: {from: single, position: [4.5, 1, 20], radius: 2, velocity: [1, 2, 3], density: 0.25}
bodies:
  clumps:
    - {name: dumbbell, spheres: [{centre: [5, 5, 4], radius: 1}, {centre: [5, 5, 6], radius: 1}], orientation: given, quaternion: [2, 0, 0, 0], angular_velocity: [0, 1.5, 0]}
observables: {every: 1000, list: [{name: energy}, {name: momentum}, {name: bodies}]}
output: {dump: {every: 1000, fields: [id, position, velocity, angular_velocity]}}
YAML
flight() {
    rm -rf flight && run_scene "$1" flight.yaml flight && rows flight | awk '
        function near(a, b) { a -= b; a -= 5 * int(a / 5 + (a > 0 ? 0.5 : -0.5)); a = a < 0 ? -a : a; if (a > most) most = a }
        function same(a, b) { a -= b; a = a < 0 ? -a : a; if (a > most) most = a }
        { t = 2; side = $1 == 1 ? 0 : $1 % 2 == 0 ? -1 : 1; s = sin(1.5 * t); c = cos(1.5 * t)
          near($3, 4.5 + t + side * s); near($4, 1 + 2 * t); same($5, 20 + 3 * t - t * t + side * c)
          same($6, 1 + side * 1.5 * c); same($7, 2); same($8, 3 - 2 * t - side * 1.5 * s); same($10, 1.5) }
        END { printf "  %d rows, largest difference %.2g\n", NR, most; exit !(NR == 3 && most < 1e-11) }' &&
        awk -F , 'NR > 1 { e = $2 + $3 + $4; if (NR > 2 && (e - first > 1e-10 || first - e > 1e-10)) bad = 1; first = e } END { exit bad || NR != 3 }' flight/observables.csv
}
check 'free flight of a dumbbell across periodic sides: closed form, energy' flight 1

# Members across periodic sides keep their images: a jump by an edge would ask for a rebuild in the step after each rebuild
seldom() { # bodies that fly 0.5 and turn; a skin of 0.1 lasts for 0.05
    run_scene 1 flight.yaml seldom --set gravity=[0,0,0] --set 'box={lower: [0, 0, 0], upper: [5, 5, 5], periodic: true}' --set 'step={count: 600, dt: 0.0005}' --set skin=0.1 \
        --set 'particles={from: random, count: 200, sizes: {law: fixed, radius: 0.2}, velocity: [1, 1, 1]}' --set material_pairs='[{k_n: 100, restitution: 0.9}]' --set contact.tangential=none &&
        grep -o '"rebuilds": *[0-9]*' seldom/report.json | awk '{ print "  " $0; exit !($2 < 20) }'
}
check 'members across sides keep their images' seldom

# A third of a turn about (1, 1, 1) takes the x axis of the entry to y and its y axis to z, whatever its principal axes are
turned_body() {
    rm -rf turned
    run_scene 1 flight.yaml turned --set gravity=[0,0,0] --set particles.velocity=[0,0,0] --set step.count=1 --set output.dump.every=1 --set 'output.dump.fields=[id, radius, position]' --set \
        'bodies.clumps[0]={name: angle, size: drawn, spheres: [{centre: [0, 0, 0], radius: 0.5}, {centre: [1, 0, 0], radius: 0.3}, {centre: [0, 1.5, 0], radius: 0.4}], orientation: given, quaternion: [1, 1, 1, 1]}' &&
        rows turned | awk 'function apart(a, b) { a -= b; return a - 5 * int(a / 5 + (a > 0 ? 0.5 : -0.5)) }
            { r = $3 + 0; for (d = 0; d < 3; d++) x[r, d] = $(4 + d) }
            END { for (d = 0; d < 3; d++) { one = apart(x[0.3, d], x[0.5, d]) - (d == 1); two = apart(x[0.4, d], x[0.5, d]) - 1.5 * (d == 2); off += one * one + two * two }
                print "  off " sqrt(off); exit NR != 4 || off > 1e-20 }'
}
check 'a body turned as its entry says' turned_body

# Bodies as drawn: members keep their radii and distances whatever the radius of the grain is, and `scree check` knows the body: of two balls of
# radius 1/2, 1.5 apart, at a density of 2, M = 2 pi / 3, inertia 2/5 M r^2 about the axis and M (2/5 r^2 + (3/4)^2) across it
drawn='bodies.clumps[0]={name: dumbbell, size: drawn, spheres: [{centre: [7, 7, 7], radius: 0.5}, {centre: [7, 7, 8.5], radius: 0.5}], orientation: given, quaternion: [1, 0, 0, 0], angular_velocity: [0, 1.5, 0]}'
known_body() { # RANKS SETTING...
    on "$1" "$scree" check --all flight.yaml --set "$drawn" --set particles.density=2 "${@:2}" | awk -v FS='[ ,]+' 'function off(a, b) { a = a / b - 1; return a < 0 ? -a : a }
        /^bodies .dumbbell/ { print; about = index($0, "radius of the ball 1.25 about 7 7 7.75,") }
        /^  each: radius 1.25,/ { print; pi = atan2(0, -1); m = 2 * pi / 3
            good = off($6, m) < 1e-5 && off($11, m * 0.1) < 1e-5 && off($12, m * (0.1 + 0.5625)) < 1e-5 && off($13, m * (0.1 + 0.5625)) < 1e-5 }
        END { exit !(about && good) }'
}
check 'a body as drawn: mass, radius and inertia' known_body 1
check 'a body as drawn, on 2 ranks' known_body 2
drawn_flight() { # RANKS
    rm -rf drawn && run_scene "$1" flight.yaml drawn --set "$drawn" --set particles.radius=0.3 --set particles.density=2 --set "output.dump.fields=[id, kind, radius, position]" && grep -q "^ITEM: ATOMS id type radius x y z kind$" drawn/dump.lammpstrj && rows drawn | awk '
        function same(a, b) { a -= b; a -= 5 * int(a / 5 + (a > 0 ? 0.5 : -0.5)); a = a < 0 ? -a : a; if (a > most) most = a }
        { t = 2; side = $1 == 1 ? 0 : $1 % 2 == 0 ? -1 : 1; s = 0.75 * sin(1.5 * t); c = 0.75 * cos(1.5 * t)
          same($4, 4.5 + t + side * s); same($5, 1 + 2 * t); same($6, 20 + 3 * t - t * t + side * c); if ($3 != ($1 == 1 ? 1.25 : 0.5) || $7 != ($1 == 1 ? 3 : 0)) bad = 1 }
        END { printf "  %d rows, largest difference %.2g\n", NR, most; exit !(NR == 3 && most < 1e-11 && !bad) }'
}
check 'a body as drawn, of a grain of another radius: closed form' drawn_flight 1
check 'a body as drawn, on 2 ranks: closed form' drawn_flight 2

# Bodies of overlapping and of separate spheres meet without loss
cat >collide.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [4, 4, 4]}
step: {count: 24000, dt: 0.00005}
contact: {law: hooke, tangential: none}
materials: [{name: a, density: 1}, {name: b, density: 2}, {name: c, density: 1}]
material_pairs: [{k_n: 10000, restitution: 1}]
walls: []
particles:
  sources:
    - {from: single, position: [1, 2, 2], radius: 0.7, velocity: [1, 0.1, 0], material: a}
    - {from: single, position: [2.6, 2.2, 2.1], radius: 0.6, velocity: [-1, 0, 0], material: b}
    - {from: single, position: [2.2, 2.9, 2.9], radius: 0.3, velocity: [-0.5, -1, -1], material: c}
bodies:
  clumps:
    - {name: dumbbell, material: a, spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}]}
    - {name: triple, material: b, angular_velocity: [1, 2, 0.5], spheres: [{centre: [-0.7, 0, 0], radius: 1}, {centre: [0.7, 0, 0], radius: 1}, {centre: [0, 1, 0.3], radius: 0.8}]}
observables: {every: 24000, list: [{name: energy_kinetic}, {name: energy_rotational}, {name: energy_elastic_normal}, {name: momentum}, {name: angular_momentum}]}
output: {dump: {every: 24000, fields: [id, position, velocity, angular_velocity]}}
YAML
conserved() { # DIR WITH_ENERGY
    awk -F , -v energy="$2" 'NR == 2 { for (k = 1; k <= NF; k++) first[k] = $k; was = $2 + $3 + $4 }
        NR == 3 { e = ($2 + $3 + $4) / was - 1; for (k = 5; k <= 10; k++) { d = $k - first[k]; d = d < 0 ? -d : d; if (d > most) most = d }
            met = $2 / first[2] - 1; met = met < 0 ? -met : met
            printf "  energy %.2g, momenta %.2g, kinetic energy changed by %.2g\n", e, most, met
            exit !(most < 1e-11 && met > 0.01 && (!energy || (e < 2e-5 && e > -2e-5))) }' "$1/observables.csv"
}
collide() { # RANKS WITH_ENERGY SETTING...
    local ranks=$1 energy=$2
    shift 2
    rm -rf collide && run_scene "$ranks" collide.yaml collide "$@" && conserved collide "$energy"
}
check 'collisions: energy, momentum, angular momentum' collide 1 yes
centres() { # RANKS: a dumbbell that flies and turns: M v^2 / 2 by its momentum, and the rest, which is I w^2 / 2
    run_scene "$1" collide.yaml centres --overwrite --set particles.sources='[{from: single, position: [1, 2, 2], radius: 0.7, velocity: [0.5, 1, 0], material: a}]' \
        --set bodies.clumps='[{name: dumbbell, material: a, angular_velocity: [0, 0, 3], spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}]}]' \
        --set observables='{every: 2000, list: [{name: energy_kinetic}, {name: momentum}, {name: energy_rotational}, {name: energy_kinetic_mean}, {name: energy_balance}]}' \
        --set step.count=10000 || return 1
    awk -F, 'NR > 1 { mass = $4 / 1; want = 0.5 * mass * 1.25; off = $2 / want - 1; if (off * off > 1e-22 || ($7 - $2 / 2) ^ 2 > 1e-22 || ($2 + $6 - $8) ^ 2 > 1e-22 || $6 < 0.01) bad = 1
        if (bad) { print "  " $0 "; M v^2 / 2 is " want; exit 1 } }' centres/observables.csv
}
check 'the translational energy of a body is that of its centre' centres 1
check 'on two ranks, too' centres 2
check 'collisions with friction and damping, 3 ranks: momentum, angular momentum' collide 3 '' --set contact.tangential=history \
    --set step.dt=0.0002 --set step.count=6000 --set observables.every=6000 --set output.dump.every=6000 --set 'material_pairs=[{k_n: 10000, restitution: 0.8, friction: 0.4}]'

# A cube of 12 triangles, filled with spheres: volume and moments are those of the cube, a^2 / 6
awk 'BEGIN { split("0 2 3 1 4 5 7 6 0 1 5 4 2 6 7 3 0 4 6 2 1 3 7 5", v, " ")
    for (s = 0; s < 6; s++) for (t = 0; t < 2; t++) { line = ""
        for (c = 0; c < 3; c++) { at = v[4 * s + (c ? t + c : 0) + 1]; line = line " " at % 2 " " int(at / 2) % 2 " " int(at / 4) }
        print line } }' >cube.txt
cube='bodies.clumps[1]={name: cube, material: b, angular_velocity: [1, 2, 0.5], mesh: cube.txt, scale: 2, mesh_spheres: 40}'
filled() {
    "$scree" check --all collide.yaml --set "$cube" | awk -v FS='[ ,]+' '/^bodies .cube/ { print "  " $0
        spheres = $3; part = $7; for (k = 1; k <= NF; k++) if ($k == "volume" && $(k + 1) ~ /^[0-9]/) volume = $(k + 1)
        good = spheres > 8 && part > 0.7 && part < 1 && volume == 8 && $NF == 0.666667 && $(NF - 1) == 0.666667 }
        END { exit !good }'
}
check 'a cube filled with spheres' filled
check 'it meets others: energy, momentum, angular momentum' collide 1 yes --set "$cube"

# A rod nearly as long as the box, dumbbells and spheres between two walls
cat >crowd.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [6, 6, 6], periodic: [true, true, false]}
gravity: [0, 0, -5]
step: {count: 900, dt: 0.0004}
contact: {law: hooke}
materials: [{name: a, density: 1}, {name: b, density: 2}, {name: c, density: 1}]
material_pairs: [{k_n: 10000, restitution: 0.8, friction: 0.3}]
groups: [{name: moves, motion: moving, velocity: [0.5, 0, 0], omega: [0, 0, 2]}]
walls:
  - {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1], material: a}
  - {name: lid, shape: plane, point: [0, 0, 6], normal: [0, 0, -1], material: a}
particles:
  sources:
    - {from: single, position: [3, 3, 3], radius: 2.7, material: c}
    - {from: single, position: [1, 1, 1], radius: 0.5, material: a, group: moves}
    - {from: random, count: 30, sizes: {law: fixed, radius: 0.35}, velocity_sigma: 1, material: b}
    - {from: random, count: 120, sizes: {law: uniform, min: 0.3, max: 0.4}, velocity_sigma: 3, material: a}
bodies:
  clumps:
    - {name: dumbbell, material: a, spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}]}
    - {name: rod, material: c, orientation: given, quaternion: [1, 0.2, 0.3, 0.1], angular_velocity: [0.1, 0.5, 0.3], file: rod.txt, scale: 2}
skin: 0.05
observables: {every: 900, list: [{name: energy}, {name: bodies}]}
output: {dump: {every: 900, fields: [id, position, velocity, angular_velocity]}, checkpoint: {every: 600}}
YAML
awk 'BEGIN { for (k = -4; k <= 4; k++) print k * 0.75, 0, 0, 0.5; print 0, 1, 0, 0.75 }' >rod.txt
alike() { # RANKS THREADS SETTING...
    local ranks=$1 threads=$2
    shift 2
    rm -rf other && run_scene "$ranks" crowd.yaml other --set "threads=$threads" --set reproducible=true "$@" && rows other | cmp - one.rows
}
check 'a crowd' run_scene 1 crowd.yaml one --set threads=1 --set reproducible=true
rows one >one.rows
check 'a crowd: all rows' [ "$(wc -l <one.rows)" = 404 ]
moved() { awk '$1 == 2 { exit !(($3 - 1.18)^2 + ($4 - 1)^2 + ($5 - 1)^2 < 1e-20 && $11 == 2) }' one.rows; }
check 'a body that moves by order' moved
check 'the same bits: 2 ranks, 2 threads, brute' alike 2 2 --set index.name=brute
check 'the same bits: 4 ranks, hgrid' alike 4 1 --set index.name=hgrid
check 'the same bits: 3 ranks, bisection, multi' alike 3 1 --set domain.name=bisection --set index.name=multi
for index in linkcell; do
    check "the same bits: $index" alike 1 2 --set index.name=$index
done
resumed() { rm -rf more && run_scene 3 crowd.yaml more --set reproducible=true --resume one/checkpoint-600.h5 && rows more | cmp - one.rows; }
check 'a resume on 3 ranks gives the same bits' resumed
near() { # RANKS SETTING...: without the reproducible mode, after a few contacts
    rm -rf fast && run_scene "$1" crowd.yaml fast --set threads=1 "${@:2}" && rows fast | paste one.rows - | awk '{ for (k = 3; k <= 8; k++) { d = $k - $(k + 11); d = d < 0 ? -d : d; if (d > most) most = d } }
        END { printf "  largest difference %.2g\n", most; exit !(NR == 404 && most < 1e-7) }'
}
check 'newton on, 4 ranks' near 4
check 'newton off, 2 ranks' near 2 --set newton=off

check 'a drum of dumbbells' env OMP_NUM_THREADS=1 SCREE="$scree" "$top_srcdir/examples/dumbbells/check" "$out/drum" 1.6

# Without bodies nothing of them is there
absent() {
    ! "$scree" check --all crowd.yaml --set 'bodies=~' --set 'observables.list=[{name: energy}]' | grep -E '^  (orientation|body|body_part|kind) +[0-9]|^  bodies '
}
check 'absent unless asked for' absent

refused() { # TEXT SCENE SETTING...
    local text=$1 scene=$2
    shift 2
    "$scree" check --all "$scene" "$@" >told 2>&1
    [ $? = 2 ] && grep -qF -- "$text" told || { cat told; return 1; }
}
entry() { echo "bodies={clumps: [{material: a, $1}]}"; }
two='spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}]'
check 'neither spheres nor a file' refused 'bodies.clumps[0]: needs one of spheres, file and mesh' crowd.yaml --set "$(entry 'name: x')"
head -n 11 cube.txt >open.txt
check 'an open surface' refused 'open.txt: is no closed surface' crowd.yaml --set "$(entry 'mesh: open.txt')"
check 'a file that is not there' refused 'nowhere.txt' crowd.yaml --set "$(entry 'file: nowhere.txt')"
echo '0 0 0' >short.txt
check 'a short row' refused 'short.txt:1' crowd.yaml --set "$(entry 'file: short.txt')"
check 'a radius of 0' refused 'bodies.clumps[0].spheres[0].radius' crowd.yaml --set "$(entry 'spheres: [{centre: [0, 0, 0], radius: 0}]')"
check 'no material' refused 'needs material' crowd.yaml --set "bodies={clumps: [{$two}]}"
check 'inertia without mass' refused 'needs mass' crowd.yaml --set "$(entry "$two, inertia: [1, 1, 1, 0, 0, 0]")"
check 'inertia of no body' refused 'no body has such moments' crowd.yaml --set "$(entry "$two, mass: 1, inertia: [1, 1, 3, 0, 0, 0]")"
check 'a centre off the axis' refused 'the centre of mass is too far' crowd.yaml --set "$(entry "$two, mass: 1, inertia: [1, 1, 1, 0, 0, 0], centre: [0, 0.5, 0]")"
check 'no quaternion' refused 'needs quaternion' crowd.yaml --set "$(entry "$two, orientation: given")"
finish
