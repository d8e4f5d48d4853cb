#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Scenes with very many materials, pairs of materials and sources: the coefficients of each pair are its own; layouts, resume, the bounds.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

# 250 grains, each of a material and a source of its own, fly to walls: grain k leaves with the restitution of its pair, 0.2 + 0.003 k. Other pairs
# have 0.1
scene() { # MATERIALS
    awk -v n="$1" 'BEGIN {
        print "units: none\nbox: {lower: [0, 0, 0], upper: [260, 4, 4]}\nstep: {count: 5000, dt: 0.0002}\ncontact: {law: hooke, tangential: none}\nmaterials:"
        for (k = 0; k < n; k++) printf "  - {name: m%d, density: %g}\n", k, 1 + 0.01 * k
        print "  - {name: floor, density: 1}\nmaterial_pairs:\n  - {k_n: 3000, restitution: 0.1}"
        for (k = 0; k < n; k++) printf "  - {between: [floor, m%d], k_n: 3000, restitution: %.9g}\n", k, 0.2 + 0.003 * k
        print "walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1], material: floor}]\nparticles:\n  sources:"
        for (k = 0; k < n; k++) printf "    - {from: single, position: [%d.5, 2, 0.8], radius: 0.4, velocity: [0, 0, -1], material: m%d}\n", k, k
        print "output: {dump: {every: 5000, fields: [id, material, mass, velocity]}, checkpoint: {every: 2500}}" }'
}
scene 250 >many.yaml
flies() { # DIR
    tail -n 250 "$1/dump.lammpstrj" | sort -n | awk '{ k = $1 - 1; e = 0.2 + 0.003 * k; m = 4 / 3 * atan2(0, -1) * 0.064 * (1 + 0.01 * k)
        d = $6 / e - 1; if (d > worst) worst = d; if (-d > worst) worst = -d; d = $3 / m - 1; if ($2 != k + 1 || d > 1e-12 || d < -1e-12) bad = 1 }
        END { printf "  largest error of a restitution %.2g\n", worst; exit NR != 250 || bad || worst > 0.02 }'
}
many() { rm -rf many && run_scene "$1" many.yaml many "${@:2}" && flies many; }
check '251 materials, 250 sources, 251 entries of pairs' many 1
check 'the same on 3 ranks' many 3
one_more() { run_scene 2 many.yaml more --resume many/checkpoint-2500.h5 && flies more; }
check 'a resume' one_more

# The same on 250 walls, one for each grain
plates=$(awk 'BEGIN { printf "walls=["; for (k = 0; k < 250; k++) printf "%s{name: w%d, shape: rectangle, point: [%d.02, 0, 0], along: [0.96, 0, 0], across: [0, 4, 0], material: floor}", k ? ", " : "", k, k; print "]" }')
check '250 walls' many 1 --set "$plates"
check '250 walls on 2 ranks' many 2 --set "$plates"

# A grain feels a wall as far as its own pair of materials reaches: no step looks at all pairs of materials
sed 's/\(k_n: 3000, restitution: [0-9.]*\)}/\1, hamaker: 1e-15, gap_least: 0.01, cut_off: 0.1}/' many.yaml >sticky.yaml
sticky() { rm -rf many && run_scene "$1" sticky.yaml many --set contact.cohesion=van_der_waals && flies many; }
check '251 materials that attract each other' sticky 1

# 100 insertions of one grain each, and 100 deletions that take away every second one
comes_and_goes() {
    awk 'BEGIN {
        print "units: none\nbox: {lower: [0, 0, 0], upper: [100, 2, 2]}\nstep: {count: 200, dt: 0.0005}\ncontact: {law: hooke, tangential: none}\nmaterials: [{name: a, density: 1}]\nmaterial_pairs: [{k_n: 3000, restitution: 0.5}]\ninsertions:"
        for (k = 0; k < 100; k++) printf "  - {name: i%d, sizes: 0.2, rate: 1000, count: 1, region: {shape: box, lower: [%d, 0.5, 0.5], upper: [%d, 1.5, 1.5]}}\n", k, k, k + 1
        print "deletions:"
        for (k = 0; k < 100; k++) printf "  - {region: {shape: box, lower: [%d, 0, 0], upper: [%d, 2, %g]}, start: 0.05}\n", k, k + 1, k % 2 ? 2 : 0.01
        print "output: {dump: {every: 200, fields: [id, position]}, checkpoint: {every: 50}}" }' >flow.yaml
    rm -rf flow && run_scene "$1" flow.yaml flow && tail -n "+$(grep -n '^ITEM: ATOMS' flow/dump.lammpstrj | tail -n 1 | cut -d : -f 1)" flow/dump.lammpstrj | awk '!/ITEM/ { n++; if (int($3) % 2) bad = 1 } END { printf "  %d grains\n", n; exit n != 50 || bad }' &&
        grep -q '"name": *"i99"' flow/report.json
}
check '100 insertions and 100 deletions' comes_and_goes 1
check 'the same on 2 ranks' comes_and_goes 2

# Grains of two materials meet: each pair of neighbours has a restitution of its own
awk 'BEGIN { n = 100
    print "units: none\nbox: {lower: [0, 0, 0], upper: [200, 4, 4]}\nstep: {count: 10000, dt: 0.0001}\ncontact: {law: hooke, tangential: none}\nmaterials:"
    for (k = 0; k < n; k++) printf "  - {name: m%d, density: 1}\n", k
    print "material_pairs:\n  - {k_n: 3000, restitution: 0.1}"
    for (k = 0; k < n; k += 2) printf "  - {between: [m%d, m%d], k_n: 3000, restitution: %.9g}\n", k + 1, k, 0.3 + 0.006 * k
    print "particles:\n  sources:"
    for (k = 0; k < n; k++) printf "    - {from: single, position: [%g, 2, 2], radius: 0.4, velocity: [%d, 0, 0], material: m%d}\n", 2 * k + (k % 2 ? -0.5 : 0.5), k % 2 ? -1 : 1, k
    print "output: {dump: {every: 10000, fields: [id, velocity]}}" }' >pairs.yaml
meets() {
    rm -rf meets && run_scene "$1" pairs.yaml meets "${@:2}" && tail -n 100 meets/dump.lammpstrj | sort -n | awk '{ k = $1 - 1; e = 0.3 + 0.006 * (k - k % 2); d = $3 / (k % 2 ? e : -e) - 1
        if (d > worst) worst = d; if (-d > worst) worst = -d } END { printf "  largest error of a restitution %.2g\n", worst; exit NR != 100 || worst > 0.02 }'
}
check '100 materials meet in pairs' meets 1
check 'the same with a law with parts' meets 1 --set contact.tangential=viscous --set 'material_pairs[0].friction=0'
check 'the same on 3 ranks, reproducible' meets 3 --set reproducible=true

# Notes of all materials leave room for a warning
warned() {
    sed 's/density: [0-9.]*}/density: 2}/; s/^units: none/gravity: [0, 0, 0]/' many.yaml >gas.yaml
    "$scree" check gas.yaml --set step.dt=1 --set step.force=true >told 2>&1
    grep -q '^warning: the time step is .* of the stable one' told && grep -qE '^NOTE: [0-9]+ more are left out$' told && [ "$(grep -c '^NOTE' told)" -le 200 ] || { tail -n 5 told; return 1; }
}
check 'a warning after very many notes' warned

scene 255 >over.yaml
bound() { ! "$scree" check over.yaml >told 2>&1 && grep -qF 'materials: 256 entries; at most 255 are possible' told && [ "$(wc -l <told)" = 1 ] || { cat told; return 1; }; }
check 'one material too many: one message' bound
finish
