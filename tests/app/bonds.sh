#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Bonds: two grains against closed forms, a bond over a wide gap on many ranks, an agglomerate that breaks on each index, layout and
# after resumes, energies, the limit of the step, messages.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

cat >pair.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [12, 4, 4], periodic: [true, false, false]}
step: {count: 100, dt: 0.01, force: true}
contact: {law: hooke}
materials: [{name: a, density: 1}]
material_pairs: [{k_n: 1000, restitution: 0.9, friction: 0.3}]
groups: [{name: still, motion: frozen}, {name: pulled, motion: moving, velocity: [0.01, 0, 0]}]
particles:
  sources:
    - {from: single, position: [11.6, 2, 2], radius: 0.5, group: still}
    - {from: single, position: [0.6, 2, 2], radius: 0.5, group: pulled}
bonds: {gap: 1e-9, laws: [{k_n: 1000, k_s: 400, radius: 0.5}]}
observables: {every: 100, list: [{name: bonds}]}
output: {checkpoint: {at_end: false}, dump: {every: 100, fields: [id, position, force, torque, bonds]}}
YAML
# value DIR COLUMN ID: a column of the last frame: 1 id, 6-8 force, 9-11 torque, 12 bonds
value() { tail -n 2 "$1/dump.lammpstrj" | awk -v id="$3" -v c="$2" '$1 == id { print $c }'; }
pull() { # RANKS EXPECTED SETTING...
    local ranks=$1 expected=$2
    shift 2
    rm -rf pair && run_scene "$ranks" pair.yaml pair "$@" && within "$(value pair 6 1)" "$expected" 1e-9 &&
        within "$(value pair 6 2)" "$(awk -v e="$expected" 'BEGIN { printf "%.15g", -e }')" 1e-9
}
# pi 0.25^2 k_n 0.01
check 'pulled: k_n A u' pull 1 1.9634954084936 --set bonds.contacts=true
check 'pulled, 3 ranks' pull 3 1.9634954084936
check 'pulled over 4 radii, 3 ranks: partners beyond the search' pull 3 392.69908169872 --set 'groups[1].velocity=[2, 0, 0]'
check 'pushed: the contact acts beside the bond' pull 1 -11.963495408494 --set 'groups[1].velocity=[-0.01, 0, 0]' --set 'material_pairs=[{k_n: 1000, restitution: 1, friction: 0}]'
check 'pushed, contacts off' pull 1 -1.9634954084936 --set 'groups[1].velocity=[-0.01, 0, 0]' --set bonds.contacts=false
sheared() { # k_s A u, and its torque about the centre
    rm -rf pair && run_scene 2 pair.yaml pair --set 'groups[1].velocity=[0, 1e-6, 0]' && within "$(value pair 7 1)" 7.8539816339745e-5 2e-12 &&
        within "$(value pair 11 1)" 3.9269908169872e-5 1e-12 && within "$(value pair 11 2)" 3.9269908169872e-5 1e-12
}
check 'sheared: k_s A u' sheared
turned() { # AXIS COLUMN EXPECTED: turned by 1e-6 about an axis
    rm -rf pair && run_scene 2 pair.yaml pair --set "groups[1]={name: pulled, motion: moving, velocity: [0, 0, 0], omega: $1}" &&
        within "$(value pair "$2" 2)" "$3" 1e-15
}
# -k_s J angle with J = pi 0.25^4 / 2; -(k_n I + k_s A / 4) angle
check 'twisted: k_s J angle' turned '[1e-6, 0, 0]' 9 -2.4543692606170e-6
check 'bent: k_n I angle, and shear' turned '[0, 0, 1e-6]' 11 -2.2702915660708e-5
breaks() { # MODE STEP SETTING...
    local mode=$1 step=$2
    shift 2
    rm -rf pair && run_scene 2 pair.yaml pair "$@" && [ "$(sed -n 2p pair/bonds_broken.csv | cut -d , -f 1,3-5)" = "$step,1,2,$mode" ] &&
        [ "$(value pair 12 1)$(value pair 6 1)" = 00 ] || { cat pair/bonds_broken.csv; return 1; }
}
check 'breaks by tension where the stress reaches the strength' breaks tension 60 --set 'bonds.laws=[{k_n: 1000, k_s: 400, tensile_strength: 5.95}]'
# grain 1 rests at 11.6, grain 2 comes to 0.606 behind the side of the box at 12
place() { within "$(sed -n 2p pair/bonds_broken.csv | cut -d , -f 6)" 0.103 1e-12 && [ "$(sed -n 2p pair/bonds_broken.csv | cut -d , -f 7,8)" = 2,2 ]; }
check 'in the middle between the two grains' place
check 'breaks by shear' breaks shear 70 --set 'groups[1].velocity=[0, 1e-3, 0]' --set 'bonds.laws=[{k_n: 1000, k_s: 400, shear_strength: 0.278}]'
listed() { # over a gap, by ids
    printf '# two ids a line\n2 1\n' >ids.txt
    rm -rf pair && run_scene 2 pair.yaml pair --set bonds.list=ids.txt --set 'particles.sources[1].position=[4.5, 2, 2]' && within "$(value pair 6 1)" 1.9634954084936 1e-9
}
check 'a list of ids' listed
slanted() { # the nearest image, 4.9 along x and 0.5 along y: A u (k_n cos^2 + k_s sin^2)
    rm -rf pair && run_scene 2 pair.yaml pair --set bonds.list=ids.txt --set 'particles.sources[1].position=[4.5, 2.5, 2]' --set 'groups[1].velocity=[1e-6, 0, 0]' &&
        within "$(value pair 6 1)" "$(awk 'BEGIN { printf "%.15g", atan2(0, -1) / 16 * 1e-6 * (1000 * 24.01 + 400 * 0.25) / 24.26 }')" 1e-9
}
check 'a list of ids, across the nearest side' slanted
later() { # made at t = 0.5: half of the way counts
    rm -rf pair && run_scene 2 pair.yaml pair --set bonds.when=time --set bonds.time=0.5 --set bonds.gap=0.1 && within "$(value pair 6 1)" 0.9817477042468 1e-9
}
check 'made at a time' later

none() { # RANKS WORDS SETTING...: check and run warn that there is no bond
    local ranks=$1 words=$2 verb
    shift 2
    for verb in check 'run -o unbonded --overwrite'; do
        on "$ranks" "$scree" $verb pair.yaml --set 'particles.sources[1].position=[4.5, 2, 2]' "$@" >said 2>&1 && holds said "warning: bonds: there is no bond$words" || return 1
    done
}
check 'no bond is told' none 1 ' at t = 0: no two grains'
check 'no bond is told, 3 ranks, later' none 3 ' at t = 0.5: no two grains' --set bonds.when=time --set bonds.time=0.5
echo '# nothing' >empty.txt
check 'an empty list is told' none 1 ': ' --set bonds.list=empty.txt

# Two free grains: the limit of the step, exact for this pair
free() { # FACTOR: the energy after 20 steps over that at the start
    rm -rf free && run_scene 1 pair.yaml free --set 'groups=~' --set 'particles.sources=[{from: single, position: [3, 2, 2], radius: 0.5}, {from: single, position: [4.04, 2, 2], radius: 0.5, velocity: [1e-9, 0, 0]}]' \
        --set bonds.gap=0.05 --set 'bonds.laws=[{k_n: 1000, k_s: 10, radius: 0.5}]' --set "step.dt=$(awk -v f="$1" -v s="$limit_step" 'BEGIN { printf "%.12g", f * s }')" --set step.count=20 \
        --set guards.energy=off --set observables.every=20 --set 'observables.list=[{name: energy_kinetic}]' --set 'output.dump=~' &&
        awk -F , 'NR == 2 { a = $2 } END { printf "%.3g\n", $2 / a }' free/observables.csv
}
stable() {
    limit_step=$("$scree" check --all pair.yaml --set 'groups=~' --set 'particles.sources=[{from: single, position: [3, 2, 2], radius: 0.5}, {from: single, position: [4.04, 2, 2], radius: 0.5}]' \
        --set bonds.gap=0.05 --set 'bonds.laws=[{k_n: 1000, k_s: 10, radius: 0.5}]' --set 'material_pairs=[{k_n: 1, restitution: 0.9, friction: 0.3}]' --set step.dt=1e-4 --set 'output.dump=~' | sed -n 's/^  stable  *\([0-9.e-]*\).*/\1/p')
    within "$limit_step" "$(awk 'BEGIN { pi = atan2(0, -1); print sqrt(2 * (pi / 6) / (1000 * pi / 16)) }')" 2e-5 || return 1
    local below above
    below=$(free 0.95) && above=$(free 1.1) && echo "  limit $limit_step; energy grows by $below at 0.95 of it, by $above at 1.1" &&
        awk -v b="$below" -v a="$above" 'BEGIN { exit !(b < 20 && a > 1e6) }'
}
check 'the limit of the step' stable

# An agglomerate of two sizes, across the sides of a periodic box, falls on a floor and breaks
awk 'BEGIN { srand(5); for (k = -3; k <= 3; k++) for (j = -3; j <= 3; j++) for (i = -3; i <= 3; i++) {
    x = i + 0.5 * ((j + k) % 2); y = 0.87 * j; z = 0.82 * k; if (x * x + y * y + z * z < 8) printf "%.6f %.6f %.6f %.6f\n", (i + j + k) % 3 ? 0.5 : 0.45, x, y, z + 3.2 } }' >ball.txt
cat >ball.yaml <<'YAML'
units: none
box: {lower: [-0.3, -0.2, 0], upper: [11.7, 7.8, 12], periodic: [true, true, false]}
gravity: [0, 0, -1]
step: {count: 900, dt: 0.002}
contact: {law: hooke}
materials: [{name: a, density: 1}, {name: b, density: 1}]
material_pairs: [{k_n: 2000, restitution: 1, friction: 0}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1], material: a}]
particles: {sources: [{from: file, format: table, file: ball.txt, columns: [radius, x, y, z], velocity: [0, 0, -3], material: a}]}
bonds: {gap: 0.09, laws: [{between: [b], k_n: 1, k_s: 1}, {modulus: 3000, stiffness_ratio: 2.5, radius: 0.8, tensile_strength: 200, shear_strength: 200}]}
observables: {every: 20, list: [{name: bonds}, {name: energy}]}
output: {dump: {every: 450, fields: [id, position, velocity, angular_velocity, force, torque, bonds]}, checkpoint: {every: 450}}
YAML
particles=$(wc -l <ball.txt)
ball_rows() { tail -n "$particles" "$1/dump.lammpstrj" | sort -n; }
layouts() {
    run_scene 1 ball.yaml one --set threads=1 --set reproducible=true --set index=brute && ball_rows one >one.rows || return 1
    local broken
    broken=$(wc -l <one/bonds_broken.csv)
    echo "  $particles grains, $((broken - 1)) bonds broke"
    [ "$broken" -gt 20 ] || return 1
    for layout in '2 2 linkcell' '4 1 hgrid'; do
        # shellcheck disable=SC2086
        set -- $layout
        run_scene "$1" ball.yaml other --set "threads=$2" --set "index=$3" --set reproducible=true --overwrite && ball_rows other | cmp - one.rows &&
            cmp one/bonds_broken.csv other/bonds_broken.csv || { echo "  $layout"; return 1; }
    done
}
check 'the same bits on any index and layout' layouts
resumes() { # RANKS
    rm -rf more && cp -r one more && rm more/checkpoint-900.h5 && run_scene "$1" ball.yaml more --set threads=1 --set reproducible=true --resume more/checkpoint-450.h5 &&
        ball_rows more | cmp - one.rows && cmp one/bonds_broken.csv more/bonds_broken.csv
}
check 'a resume gives the same bits' resumes 1
check 'a resume on 3 ranks gives the same bits' resumes 3
fast() { # newton on: the same bonds break first, and the energies balance
    for layout in '1 on' '3 on' '2 off'; do
        # shellcheck disable=SC2086
        set -- $layout
        run_scene "$1" ball.yaml "fast$1" --set newton="$2" && head -n 6 "fast$1/bonds_broken.csv" | cut -d , -f 1,3-5 | cmp - <(head -n 6 one/bonds_broken.csv | cut -d , -f 1,3-5) || return 1
        awk -F , -v bonds="$(sed -n '1s/,/\n/g; 1p' "fast$1/observables.csv" | grep -n energy_balance | cut -d : -f 1)" '
            NR == 2 { first = $bonds } NR > 1 { d = ($bonds - first) / first; if (d * d > worst) worst = d * d; whole = $2; broken = $3 + $4 }
            NR == 2 { all = whole } END { printf "  balance within %.2g; %d bonds, %d whole, %d broken\n", sqrt(worst), all, whole, broken
                exit !(worst < 1e-6 && whole + broken == all && broken > 20) }' "fast$1/observables.csv" || return 1
    done
}
check 'fast mode: breaks and balance of energies' fast
absent() {
    run_scene 1 ball.yaml none --set reproducible=true --set 'bonds.laws=[{between: [b], k_n: 1, k_s: 1}]' --set 'output.dump.fields=[id, position, velocity]' --set 'observables.list=[{name: energy_kinetic}]' &&
        run_scene 1 ball.yaml without --set reproducible=true --set 'bonds=~' --set 'output.dump.fields=[id, position, velocity]' --set 'observables.list=[{name: energy_kinetic}]' &&
        cmp <(ball_rows none) <(ball_rows without) && [ ! -e without/bonds_broken.csv ] &&
        ! "$scree" check --all ball.yaml --set 'bonds=~' --set 'output.dump.fields=[id, position]' --set 'observables.list=[{name: energy_kinetic}]' |
        grep -E '^  (bonds|own_reach|bond_group) +[0-9]|carry'
}
check 'absent unless asked for, and no grain moves otherwise' absent

check 'a ball is crushed' env SCREE="$scree" "$top_srcdir/examples/crushing/check" "$out/crush"

refused() { # TEXT SETTING...
    local text=$1
    shift
    ! "$scree" check --all pair.yaml "$@" >told 2>&1 && grep -qF -- "$text" told || { cat told; return 1; }
}
check 'half of the stiffness' refused 'needs k_n and k_s' --set 'bonds.laws=[{k_n: 1}]'
check 'two kinds of stiffness' refused 'needs k_n and k_s' --set 'bonds.laws=[{k_n: 1, k_s: 1, modulus: 1}]'
check 'no list' refused 'bonds.list' --set bonds.list=nowhere.txt
printf '1 2\n1\n' >ids.txt
check 'half a pair' refused 'ids.txt:2: two ids' --set bonds.list=ids.txt
printf '1 7\n' >ids.txt
check 'an id that is not there' refused 'there is no particle 7' --set bonds.list=ids.txt
check 'an unknown group' refused 'bonds.laws' --set 'bonds.laws=[{groups: [nobody], k_n: 1, k_s: 1}]'
finish
