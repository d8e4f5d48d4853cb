#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A box that moves: strain at a rate, a stress that the box follows, files, resumes and refusals. Pairs in a sheared box are tested in
# tests/mpi/test_shear, layouts in reproducible.sh, forces in granular_lammps.sh.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

cat >gas.yaml <<'END'
units: none
box: {lower: [0, 0, 0], upper: [8, 7, 6], periodic: true, shear: {rate: 3, flow: x, gradient: y}, strain: {rate: [-0.3, 0.1, 0.2]}}
step: {dt: 0.001, count: 400}
contact: {law: hooke}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 0.7, friction: 0.4, k_n: 500}]
particles: {from: random, count: 200, sizes: {law: uniform, min: 0.2, max: 0.4}, velocity_sigma: 1}
observables: {every: 100, list: [{name: box_edges}, {name: shear_strain}, {name: energy_fluctuation}, {name: momentum}]}
output: {checkpoint: {at_end: true}, dump: {every: 400}, trajectory: {every: 200}}
END
# Grains on a lattice that do not touch yet, soft and hard
cat >press.yaml <<'END'
units: none
box: {lower: [0, 0, 0], upper: [4.32, 4.32, 4.32], periodic: true, stress: {pressure: 2, inertia: 0.05}}
step: {count: 10000}
contact: {law: hooke}
materials: [{name: a, density: 1.9}]
material_pairs: [{restitution: 0.3, friction: 0.3, k_n: 200}]
particles: {from: lattice, lattice: sc, spacing: 1.08, sizes: 0.5, jitter: 0.5, velocity_sigma: 0.01}
observables: {every: 100, list: [{name: stress}, {name: box_edges}]}
output: {checkpoint: {at_end: true}}
END

column() { # DIR NAME: the last row's value
    awk -F, -v name="$2" 'NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); if ($k == name) at = k } } END { print $at }' "$1/observables.csv"
}

strained() { # edges grow by (1 + rate dt) a step, and the offset by rate x edge
    run_scene 1 gas.yaml gas || return 1
    local d edge
    for d in 'x 8 -0.3' 'y 7 0.1' 'z 6 0.2'; do
        set -- $d
        edge=$(awk -v e="$2" -v r="$3" 'BEGIN { for (k = 0; k < 400; k++) e *= 1 + r * 0.001; printf "%.14g", e }')
        within "$(column gas "box_edges_$1")" "$edge" 1e-9 || return 1
    done
    # d offset = rate edge_y dt + rate_x offset dt
    within "$(column gas shear_strain)" "$(awk 'BEGIN { y = 7; for (k = 0; k < 400; k++) { o += 0.001 * (3 * y - 0.3 * o); y *= 1.0001 } printf "%.14g", o / y }')" 1e-9
}

files() { # LAMMPS's bounds and tilt, and edges in each frame
    local tilt
    holds gas/dump.lammpstrj 'ITEM: BOX BOUNDS xy xz yz pp pp pp' || return 1
    tilt=$(awk '/BOX BOUNDS/ { getline; last = $3 } END { print last }' gas/dump.lammpstrj)
    awk -v tilt="$tilt" -v x="$(column gas box_edges_x)" -v y="$(column gas box_edges_y)" -v strain="$(column gas shear_strain)" 'BEGIN {
        turns = (strain * y - tilt) / x; whole = int(turns + 0.5); exit !(turns - whole < 1e-6 && whole - turns < 1e-6) }' || return 1
    command -v h5dump >/dev/null || return 0
    h5dump -d /particles/all/box/edges/value gas/trajectory.h5 | grep -q '( 3, 3, 3 )'
}

# A list that is kept as long as its skin allows gives what a rebuild in each step gives
rebuilt() {
    run_scene 1 gas.yaml often --set step.rebuild_every=1 --set reproducible=true && run_scene 1 gas.yaml seldom --set reproducible=true || return 1
    local a b
    a=$(column often energy_fluctuation) b=$(column seldom energy_fluctuation)
    [ "$(number often/report.json rebuilds)" -gt "$(number seldom/report.json rebuilds)" ] && within "$a" "$b" 1e-6
}

# Places and velocities are of one image, that in the box, whenever a particle was wrapped last
images() { # what a gas conserves, and the velocity relative to the mean flow, by expressions
    run_scene 1 gas.yaml images --set skin=0.4 --set observables.every=1 --set 'observables.list=[{name: energy_fluctuation},
        {name: sum, label: own, of: "0.5*mass*((vx+0.3*x-3*(y-3.5*1.0001^(1000*t)))^2+(vy-0.1*y)^2+(vz-0.2*z)^2)"}]' || return 1
    awk -F, 'NR > 1 { off = $2 / $3 - 1; off = off < 0 ? -off : off; if (off > most) most = off }
        END { print "  sum and energy_fluctuation differ by up to " most; exit !(NR > 300 && most < 1e-3) }' images/observables.csv || return 1
    run_scene 1 gas.yaml conserved --set skin=0.4 --set box.strain=~ --set observables.every=1 --set 'observables.list=[
        {name: sum, label: own, of: "mass*(vx-3*(y-3.5))"}, {name: sum, label: drift, of: "mass*vy"}]' || return 1
    awk -F, 'NR == 2 { first = $2 } NR > 1 { off = $2 + 3 * $1 * $3 - first; off = off < 0 ? -off : off; if (off > most) most = off }
        END { print "  the sum of m (v_x - rate y) leaves its line by up to " most; exit !(NR > 300 && most < 1e-9) }' conserved/observables.csv
}
unwrapped_late() { # the same numbers whether particles are wrapped in each step or seldom
    local list='observables.list=[{name: momentum}, {name: energy_kinetic}, {name: speed_max}, {name: position, id: 7}, {name: velocity, id: 7},
        {name: position, id: 30}, {name: velocity, id: 30}, {name: mean, of: "vx*y"}, {name: angular_momentum}, {name: energy_kinetic_mean, target: low}]'
    local region='observables.regions=[{name: low, shape: box, lower: [-1, 0, -1], upper: [20, 1, 20]}]'
    local row='observables.grids=[{name: smooth, cells: [2, 7, 1], kernel: gauss, width: 0.4}, {name: cells, cells: [1, 7, 2]}]'
    run_scene 1 gas.yaml early --set reproducible=true --set step.rebuild_every=1 --set observables.every=20 --set "$list" --set "$region" --set "$row" &&
        run_scene 1 gas.yaml late --set reproducible=true --set skin=0.4 --set observables.every=20 --set "$list" --set "$region" --set "$row" || return 1
    local file
    for file in observables grid-smooth grid-cells; do
        paste -d, early/$file.csv late/$file.csv | awk -F, 'NR > 1 { for (k = 1; k <= NF / 2; k++) { size = $k < 0 ? -$k : $k; off = $k - $(k + NF / 2)
            off = off < 0 ? -off : off; if (off > 1e-6 * (1 + size)) { print "  '$file': row " NR ", column " k ": " $k ", " $(k + NF / 2); exit 1 } } }' || return 1
    done
}
dragged() { # a given fluid moves with the box: the same drag whenever a grain is wrapped
    local fluid='drag={law: schiller_naumann, fluid: {density: 0.1, viscosity: 0.5, velocity: [1, 0, 0]}}'
    run_scene 1 gas.yaml early --overwrite --set reproducible=true --set step.rebuild_every=1 --set observables.every=20 --set "$fluid" &&
        run_scene 1 gas.yaml late --overwrite --set reproducible=true --set skin=0.4 --set observables.every=20 --set "$fluid" || return 1
    paste -d, early/observables.csv late/observables.csv | awk -F, 'NR > 1 { for (k = 2; k <= NF / 2; k++) { off = $k - $(k + NF / 2)
        if (off > 1e-6 || off < -1e-6) { print "  row " NR ", column " k ": " $k ", " $(k + NF / 2); exit 1 } } }'
}
even() { # the granular temperature of a sheared gas is the same in all cells, those at the faces included
    run_scene 1 gas.yaml even --set box.strain=~ --set material_pairs='[{restitution: 1, k_n: 3000}]' --set contact.tangential=none --set skin=0.4 --set guards.overlap=off --set step.count=3000 \
        --set box.shear.rate=1 --set 'observables={every: 20, grids: [{name: smooth, cells: [1, 7, 1], kernel: gauss, width: 0.4}, {name: cells, cells: [1, 7, 1]}]}' || return 1
    for file in smooth cells; do
        awk -F, 'NR > 1 && $1 > 0.5 { t[$3] += $11; v[$3] += $8 - ($3 - 3.5); n[$3]++ } END { for (k in t) mean += t[k] / n[k] / 7
            for (k in t) { printf "  %g: temperature %.3g, velocity off by %.3g\n", k, t[k] / n[k], v[k] / n[k]; off = t[k] / n[k] / mean - 1; bad += off > 0.2 || off < -0.2 }; exit bad > 0 }' \
            even/grid-$file.csv || return 1
    done
}

resumed() { # the same bits on the same layout
    run_scene 2 press.yaml whole --set step.count=2000 --set output.checkpoint.every=1000 --set "$1" &&
        run_scene 2 press.yaml half --set step.count=1000 --set output.checkpoint.every=1000 --set "$1" &&
        run_scene 2 press.yaml half --overwrite --resume last --set step.count=2000 --set output.checkpoint.every=1000 --set "$1" || return 1
    contents whole/checkpoint-2000.h5 | grep -v /runs/ >a && contents half/checkpoint-2000.h5 | grep -v /runs/ >b && cmp a b
}

reaches() { # DIR FROM: stresses of the last rows, as "name target" lines of the input, within 1 %
    local name target
    while read -r name target; do
        awk -F, -v name="$name" -v target="$target" '
            NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); at[$k] = k } next } { row[NR] = $0 }
            END { for (k = NR - 9; k <= NR; k++) { split(row[k], v, ",")
                    value += name == "pressure" ? (v[at["stress_xx"]] + v[at["stress_yy"]] + v[at["stress_zz"]]) / 30 : v[at[name]] / 10 }
                printf "  %s: %.5g, target %g\n", name, value, target; exit !(value / target > 0.99 && value / target < 1.01) }' "$1/observables.csv" || return 1
    done
}
pressed() { # STIFFNESS STEPS
    run_scene 1 press.yaml press --overwrite --set threads=1 --set "material_pairs[0].k_n=$1" --set "step.count=$2" && echo pressure 2 | reaches press
}
sides() { # each edge by itself, on three ranks
    run_scene 3 press.yaml sides --set box.stress.pressure='~' --set box.stress.xx=1 --set box.stress.yy=2 --set box.stress.zz=1.5 &&
        printf 'stress_xx 1\nstress_yy 2\nstress_zz 1.5\n' | reaches sides
}

# slow DIMENSION DENSITY: grains that do not touch resist by nothing but the bound of the rate, inertia sqrt(pressure / density) / diameter
slow() {
    local flat='{lower: [0, 0, 0], upper: [4.32, 4.32, 4.32], periodic: true, stress: {pressure: 2, inertia: 0.05}}'
    [ "$1" = 3 ] || flat='{dimension: 2, lower: [0, 0], upper: [4.32, 4.32], periodic: true, stress: {pressure: 2, inertia: 0.05}}'
    run_scene 1 press.yaml slow --overwrite --set "box=$flat" --set step.dt=0.001 --set step.count=200 --set particles.lattice="$3" --set particles.jitter=0 &&
        within "$(column slow box_edges_x)" "$(awk -v density="$2" 'BEGIN { printf "%.14g", 4.32 * (1 - 0.001 * 0.05 * sqrt(2 / density)) ^ 200 }')" 1e-9
}

held() { # a packing under a pressure and a shear stress: alone with the plane of the stress, and along the other of its two directions
    run_scene 1 press.yaml held --overwrite --set threads=1 --set box.stress.xz=-0.2 --set step.count=15000 &&
        printf 'pressure 2\nstress_xz -0.2\n' | reaches held || return 1
    run_scene 1 press.yaml held --overwrite --set threads=1 --set box.stress.xy=0.15 --set box.shear.rate=0.01 --set box.shear.flow=y --set box.shear.gradient=x \
        --set step.count=15000 && printf 'pressure 2\nstress_xy 0.15\n' | reaches held
}

refused() { # STATUS TEXT COMMAND...
    local wanted=$1 text=$2 status
    shift 2
    "$@" >said 2>&1
    status=$?
    [ $status = "$wanted" ] && holds said "$text"
}

quick_cell() { "$top_srcdir/examples/shear_cell/run.sh" --quick cell >/dev/null && "$top_srcdir/examples/shear_cell/check" cell 0.1; }

check 'edges and offset move at their rates' strained
check 'dumps have the tilt, trajectories the edges' files
check 'place and velocity of an observable are of one image' images
check 'whenever particles are wrapped' unwrapped_late
check 'and the drag of a given fluid' dragged
check 'the faces of a sheared box are as any other cells' even
seen() { # of the trajectory and of the checkpoint; the first has no povray to start
    on 1 "$scree" picture gas -o gas.pov && [ "$(grep -c '^sphere' gas.pov)" = 200 ] && on 1 "$scree" picture gas/checkpoint-400.h5 -o last.pov &&
        cmp gas.pov last.pov && on 1 "$scree" info gas/trajectory.h5 >said && grep -q '  sheared    the image above along y lies at [0-9.-]* along x' said
}
check 'a sheared box is drawn' seen
turned() { # the tilt is kept on the way through all kinds of files
    local file before=gas/trajectory.h5
    for file in one.dump two.h5 three.data four.dump five.data; do
        on 1 "$scree" convert $before $file || return 1
        before=$file
    done
    grep -q '^[0-9.]* 0 0 xy xz yz$' five.data && awk -f "$top_srcdir/tests/app/near.awk" three.data five.data
}
check 'a sheared box keeps its tilt through dumps, trajectories and data files' turned
scene_of_it() {
    sed 's/^particles: .*/particles: {file: three.data, format: lammps-data}/; s/, velocity_sigma: 1//' gas.yaml >again.yaml
    refused 2 'the box of this frame is sheared' "$scree" check again.yaml
}
check 'a scene does not begin with a sheared frame' scene_of_it
check 'the skin holds while the box moves' rebuilt
check 'a resume under a pressure and a shear stress has the same bits' resumed box.stress.xy=-0.2
for case in '200 8000' '2000 12000' '20000 125000'; do
    check "a packing of stiffness ${case% *} comes to its pressure" pressed $case
done
check 'three stresses, three edges' sides
check 'a stress moves the box no faster than its bound' slow 3 1.9 sc
check 'in two dimensions, where the density is that of an area' slow 2 "$(awk 'BEGIN { printf "%.15g", 1.9 * 2 / 3 }')" square
check 'a packing is held to a shear stress' held
check 'a resume needs the box to go on moving' refused 2 'must stay' "$scree" run gas.yaml -o gas --overwrite --resume last --set box.shear='~' --set box.strain='~'
check 'an edge that gets too short ends the run' refused 3 'edge has shrunk' \
    "$scree" run gas.yaml -o short --set box.strain.rate='[0, -5, 0]' --set step.count=600 --set guards.overlap=off --set guards.speed=off
check 'one plane shears' refused 2 'in one plane' "$scree" check press.yaml --set box.stress.xz=1 --set box.stress.yz=1
check 'the plane of the shear is that of its stress' refused 2 'flow and gradient are x and y' \
    "$scree" check press.yaml --set box.stress.xz=1 --set box.shear.rate=0
check 'a stress needs a target' refused 2 'one of xy, xz, yz' "$scree" check press.yaml --set box.stress.pressure='~'
check 'an edge has one master' refused 2 'by box.strain, too' "$scree" check press.yaml --set box.strain.rate='[1, 0, 0]'
SCREE=$scree check 'the example finds mu(I)' quick_cell
finish
