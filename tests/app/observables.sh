#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Observables with known values: crossings of planes, particles that come and go, the state of a packing, fields on a grid.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

# last DIR COLUMN: the value of a column in the last row
last() {
    awk -F, -v name="$2" 'NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); if ($k == name) at = k } next } { value = $at } END { print value }' \
        "$1/observables.csv"
}

# Grains that fly through a periodic box, twice around
cat >gas.yaml <<'EOS'
units: none
box: {lower: [-1, 0, 0], upper: [9, 6, 6], periodic: true}
contact: {law: hooke}
materials: [{name: glass, density: 1}]
material_pairs: [{restitution: 1, friction: 0, k_n: 100}]
particles: {from: lattice, lattice: sc, spacing: 2, sizes: 0.5, velocity: [1, 0, 0]}
step: {dt: 0.01, count: 2000}
observables:
  every: 500
  planes: [{name: across, point: [2.5, 0, 0], normal: [2, 0, 0]}, {name: back, point: [2.5, 0, 0], normal: [-1, 0, 0]}]
  list: [{name: crossing}, {name: particles}]
EOS
laps() { # RANKS
    run_scene "$1" gas.yaml "gas$1" || return 1
    local n
    n=$(last "gas$1" particles)
    within "$(last "gas$1" crossed_across)" $((2 * n)) 0 && within "$(last "gas$1" crossed_back)" $((-2 * n)) 0 &&
        within "$(last "gas$1" crossed_mass_across)" "$(awk -v n="$n" 'BEGIN { printf "%.15g", n * 3.14159265358979 / 3 }')" 1e-9
}
check 'grains that go twice around cross a plane twice' laps 1
check 'and on two ranks' laps 2

# Grains are inserted at the top and deleted at the bottom
cat >fall.yaml <<'EOS'
units: none
gravity: [0, 0, -10]
box: {lower: [0, 0, 0], upper: [4, 4, 20], periodic: [true, true, false]}
contact: {law: hooke}
materials: [{name: glass, density: 1}]
material_pairs: [{restitution: 0.5, friction: 0, k_n: 1000}]
insertions: [{region: {shape: box, lower: [0, 0, 16], upper: [4, 4, 19]}, sizes: {law: uniform, min: 0.2, max: 0.4}, rate: 50, count: 40, velocity: [0, 0, -1]}]
deletions: [{region: {shape: box, lower: [0, 0, 0], upper: [4, 4, 3]}, every: 7}]
step: {dt: 0.002, count: 1500}
observables: {every: 100, planes: [{name: outlet, point: [0, 0, 9], normal: [0, 0, -1]}], list: [{name: turnover}, {name: crossing}, {name: particles}]}
output: {checkpoint: {every: 500, keep: 9}}
EOS
balance() { # DIR
    local n
    n=$(last "$1" inserted)
    [ "$n" = 40 ] && [ "$(last "$1" deleted)" = "$n" ] && [ "$(last "$1" crossed_outlet)" = "$n" ] && [ "$(last "$1" particles)" = 0 ] &&
        within "$(last "$1" crossed_mass_outlet)" "$(last "$1" inserted_mass)" 1e-12 && within "$(last "$1" deleted_mass)" "$(last "$1" inserted_mass)" 1e-12
}
falls() { run_scene "$1" fall.yaml "fall$1" && balance "fall$1"; }
check 'what is inserted crosses the outlet and is deleted' falls 1
check 'and on two ranks' falls 2
resumed() { run_scene 1 fall.yaml again --resume fall2/checkpoint-500.h5 && balance again; }
check 'and over a resume on another number of ranks' resumed

# A cubic lattice of spheres that overlap, in a periodic box
for k in $(seq 0 26); do echo $((k % 3 * 2 + 1)) $((k / 3 % 3 * 2 + 1)) $((k / 9 * 2 + 1)) 1.01 0.5 0 0.25; done >cube.txt
cat >cube.yaml <<'EOS'
units: none
box: {lower: [0, 0, 0], upper: [6, 6, 6], periodic: true}
contact: {law: hooke}
materials: [{name: glass, density: 2}]
material_pairs: [{restitution: 0.5, friction: 0, k_n: 100}]
particles: {file: cube.txt, format: table, columns: [x, y, z, radius, vx, vy, vz]}
step: {dt: 0.001, count: 20}
observables:
  every: 20
  regions: [{name: half, shape: box, lower: [0, 0, 0], upper: [6, 6, 3.9]}]
  list: [{name: coordination}, {name: solid_fraction}, {name: solid_fraction, target: half, label: lower}, {name: unbalanced_force}, {name: energy_kinetic_mean}, {name: stress}]
  grids:
    - {name: height, cells: [1, 1, 3]}
    - {name: cloud, cells: [6, 6, 6], kernel: gauss, width: 0.7}
EOS
packed() {
    run_scene "$1" cube.yaml "cube$1" || return 1
    local v=4.31569 # of a sphere
    within "$(last "cube$1" coordination)" 6 1e-12 && within "$(last "cube$1" solid_fraction)" 0.53946 1e-4 &&
        within "$(last "cube$1" lower)" "$(awk -v v=$v 'BEGIN { print 18 * v / (36 * 3.9) }')" 1e-4 &&
        within "$(last "cube$1" unbalanced_force)" 0 1e-9 &&
        within "$(last "cube$1" energy_kinetic_mean)" "$(awk -v v=$v 'BEGIN { print 0.5 * 2 * v * 0.3125 }')" 1e-4
}
check 'contacts, solids, forces and energy of a lattice' packed 1
check 'and on two ranks' packed 2
# The mean over the cells is the value of the box: density 2 x solid fraction, velocity, stress
fields() { # DIR GRID TOLERANCE
    awk -F, -v xx="$(last "$1" stress_xx)" -v zz="$(last "$1" stress_zz)" -v xz="$(last "$1" stress_xz)" -v bound="$3" '
        function off(what, a, b, scale) { if (!(a - b <= bound * scale && b - a <= bound * scale)) print what, a, b }
        $1 == "time" { next } $1 > 0 { n++; rho += $6; s += $7; px += $6 * $8; sxx += $12 + $6 * ($8 * $8); szz += $14 + $6 * $10 * $10; sxz += $16 + $6 * $8 * $10 }
        END { off("density", rho / n, 2 * 0.53946, 1); off("solids", s / n, 0.53946, 1); off("velocity", px / rho, 0.5, 1)
              off("xx", sxx / n, xx, xx); off("zz", szz / n, zz, zz); off("xz", sxz / n, xz, 1) }' "$1/grid-$2.csv" >said
    [ ! -s said ] && [ "$(grep -c . "$1/grid-$2.csv")" = "$4" ] || { cat said; wc -l "$1/grid-$2.csv"; return 1; }
}
check 'a profile adds up to the box, its stress included' fields cube1 height 1e-4 7
check 'smooth fields add up to the box' fields cube1 cloud 2e-3 433
check 'and on two ranks' fields cube2 cloud 2e-3 433
# Expressions
sed -e 's/^  list: .*/  list: [{name: sum, of: "0.5*mass*(vx^2+vy^2+vz^2)", unit: J, label: kinetic}, {name: mean, of: z, where: "z > 2", label: upper}, {name: largest, of: -id}, {name: least, of: "radius*vx*t"}, {name: energy_kinetic}, {name: mean, of: mass, where: "x > 7", label: none}]/' \
    -e '/^  grids:/,$d' cube.yaml >words.yaml
words() { # RANKS
    run_scene "$1" words.yaml "words$1" || return 1
    within "$(last "words$1" kinetic)" "$(last "words$1" energy_kinetic)" 1e-9 && within "$(last "words$1" upper)" 4.005 1e-9 &&
        [ "$(last "words$1" largest)" = -1 ] && within "$(last "words$1" least)" 0.0101 1e-9 && [ "$(last "words$1" none)" = nan ]
}
if grep -q 'define HAVE_MUPARSER 1' "$top_builddir/config.h"; then
    check 'expressions over the fields of grains' words 1
    check 'and on two ranks' words 2
    # Lacey's index: layers apart are 0; columns all alike are above 1; else by counting
    lacey() { # RANKS
        run_scene "$1" words.yaml "lacey$1" --set 'observables.list=[{name: lacey, where: "z > 2", cells: [1, 1, 3], label: apart}, {name: lacey, where: "z > 2", cells: [3, 3, 1], label: alike}, {name: lacey, where: "x+2*y+z > 11.5", cells: [2, 3, 1]}]' || return 1
        within "$(last "lacey$1" apart)" 0 1e-12 && within "$(last "lacey$1" alike)" 1.5 1e-12 &&
            within "$(last "lacey$1" lacey)" "$(awk '{ c = int(($1 + 0.01) / 3) "," int($2 / 2); n[c]++; N++; if ($1 + 0.01 + 2 * $2 + $3 > 11.5) { m[c]++; M++ } }
                END { p = M / N; for (c in n) { K++; s += n[c] * (m[c] / n[c] - p) ^ 2 / N }
                      print (p * (1 - p) - s) / (p * (1 - p) * (1 - K / N)) }' cube.txt)" 1e-5
    }
    check "Lacey's index" lacey 1
    check 'and on two ranks' lacey 2
    check "Lacey's index without cells" scene_refused 'lacey: cells: needed: three numbers' words.yaml --set 'observables.list=[{name: lacey, where: "z > 2"}]'
    check 'an expression with an unknown word' scene_refused "observables: mean: where: 'zz > 2' is no expression: Unexpected token|known are t, x, y" \
        words.yaml --set 'observables.list=[{name: mean, of: z, where: "zz > 2"}]'
    check 'an expression where none belongs' scene_refused 'speed_max: takes neither `of` nor `where`; sum, mean' words.yaml --set 'observables.list=[{name: speed_max, of: z}]'
else
    check 'without muParser expressions are refused' scene_refused 'built without (Debian: libmuparser-dev)' words.yaml
fi
# Random velocities of sources add no momentum, whatever the masses, with grains that are fixed among them
cat >shaken.yaml <<'EOS'
units: none
box: {lower: [0, 0, 0], upper: [8, 7, 6], periodic: true}
step: {dt: 0.001, count: 50}
contact: {law: hooke}
materials: [{name: light, density: 1}, {name: heavy, density: 3}]
material_pairs: [{restitution: 0.7, k_n: 500}]
groups: [{name: fixed, motion: frozen, select: {region: {shape: box, lower: [0, 0, 0], upper: [2, 7, 6]}}}]
particles:
  sources:
    - {from: random, count: 200, sizes: {law: uniform, min: 0.2, max: 0.4}, velocity_sigma: 1, material: light}
    - {from: random, count: 100, sizes: {law: uniform, min: 0.1, max: 0.2}, velocity_sigma: 2, material: heavy, velocity: [0, 0, 0]}
    - {from: single, position: [7, 6, 5], radius: 0.3, velocity_sigma: 1, material: heavy}
observables: {every: 50, list: [{name: momentum}, {name: velocity, id: 301}, {name: energy_kinetic}]}
EOS
shaken() { # RANKS VELOCITY FLAG...: at the start the momentum is that of the single sphere, and of the velocity of the second source
    run_scene "$1" shaken.yaml shaken --overwrite --set "particles.sources[1].velocity=[$2, 0, 0]" "${@:3}" || return 1
    awk -F, -v speed="$2" 'NR == 2 { m = 3 * 4 * 3.14159265358979 / 3 * 0.027; off = ($2 - m * $5) / m; bad = speed == 0 ? off * off > 1e-20 : off < 1
        bad += ($3 - m * $6) ^ 2 > 1e-20 || ($4 - m * $7) ^ 2 > 1e-20 || $5 * $5 < 1e-4 || $8 < 10
        if (bad) print "  momentum " $2 " " $3 " " $4 ", of the single one " m * $5 " " m * $6 " " m * $7 ", energy " $8; exit bad }' shaken/observables.csv
}
check 'random velocities of a source add no momentum' shaken 1 0
check 'also on ranks' shaken 3 0
check 'a velocity of the source does' shaken 1 2
check 'a plane that leans along a periodic direction' scene_refused 'leans along the periodic direction x; allowed: along it, or across it' \
    gas.yaml --set 'observables.planes[0].normal=[1, 1, 0]'
check 'a grid of two numbers' scene_refused 'observables.grids[0].cells: has 2 numbers; needed: three' cube.yaml --set 'observables.grids[0].cells=[1, 3]'

finish
