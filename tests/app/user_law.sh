#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A law of the user's: the code of docs/user-law.md gives the forces of the built-in law, on any layout; mistakes have file and line; a
# checkpoint knows the text.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

# listing FILE: the listing of docs/user-law.md that begins with the name of the file
listing() {
    awk -v name="/* $1:" '/^```/ { if (keep) exit; fence = $0 == "```c"; next } fence && index($0, name) == 1 { keep = 1 } { fence = 0 } keep' \
        "$top_srcdir/docs/user-law.md"
}
export TMPDIR=$out/temporary
mkdir -p laws "$TMPDIR" && listing hooke.c >laws/hooke.c && listing stiffening.c >laws/stiffening.c
cat >own.yaml <<'YAML'
units: none
reproducible: true
box: {lower: [0, 0, 0], upper: [4, 4, 6], periodic: [true, true, false]}
gravity: [0, 0, -10]
step: {dt: 2e-4, count: 400}
contact: {law: {file: laws/hooke.c}, rolling: spring}
materials: [{name: a, density: 1}, {name: b, density: 2}]
material_pairs: [{restitution: 0.5, friction: 0.5, rolling_friction: 0.1, k_n: 1e4}, {between: [a, b], restitution: 0.7, friction: 0.2, k_n: 2e4}]
walls: [{name: floor, shape: plane, point: [0, 0, 0.1], normal: [0, 0, 1], material: b}]
particles: {from: random, material: a, region: {shape: box, lower: [0, 0, 0.2], upper: [4, 4, 5.5]}, sizes: {law: uniform, min: 0.2, max: 0.6}, volume_fraction: 0.3}
output: {dump: {every: 400, fields: [id, radius, position, velocity, angular_velocity, force, torque]}, checkpoint: {every: 200, keep: 9}}
observables: {every: 200, list: [{name: energy}]}
YAML
same() { # SETTING...: forces, energies and motion of the copy of hooke are those of hooke
    rm -rf own built
    run_scene 1 own.yaml own "$@" && run_scene 1 own.yaml built --set contact.law=hooke "$@" || return 1
    cmp own/dump.lammpstrj built/dump.lammpstrj && cmp own/observables.csv built/observables.csv
}
check 'a copy of hooke gives the bits of hooke, with walls and two materials' same
check 'so through the general loop' same --set contact.rolling=epsd
layouts() {
    run_scene 1 own.yaml own --overwrite && run_scene 2 own.yaml two --set threads=2 --set index=bytype && cmp own/dump.lammpstrj two/dump.lammpstrj &&
        run_scene 2 own.yaml again --resume own/checkpoint-200.h5 && tail -n 30 own/dump.lammpstrj >a && tail -n 30 again/dump.lammpstrj | cmp - a
}
check 'the same bits on two ranks and threads, and after a resume' layouts
nothing_left() { [ "$(ls laws)" = "$(printf 'hooke.c\nstiffening.c')" ] && ! compgen -G "$TMPDIR/scree-*"; }
check 'nothing is left beside the file, nor in the temporary folder' nothing_left
changed() {
    sed 's/linear spring/spring/' laws/hooke.c >changed.c
    ! run_scene 1 own.yaml again --overwrite --resume own/checkpoint-200.h5 --set contact.law='{file: changed.c}' &&
        holds said 'file hooke (text ' && holds said 'contact.law must stay'
}
check 'a resume with another text is refused' changed
impact() { # the stiffening law: an impact at speed 1 of m* = 0.5 compresses by the overlap of energy 1/4
    cat >impact.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [4, 4, 4]}
step: {dt: 1e-5, count: 1000}
contact: {law: {file: laws/stiffening.c}, tangential: none}
materials: [{name: a, density: 0.238732414637843}]
material_pairs: [{restitution: 1, k_n: 1e4, parameters: [0.004]}]
particles: {sources: [{from: single, position: [1, 2, 2], radius: 1, velocity: [0.5, 0, 0]}, {from: single, position: [3.000001, 2, 2], radius: 1, velocity: [-0.5, 0, 0]}]}
observables: {every: 1, list: [{name: overlap_max}]}
YAML
    run_scene 1 impact.yaml impact && awk -F , 'NR > 1 && $2 > most { most = $2 } END {
        k = 1e4; d = 0.004; x = d * sqrt(sqrt(1 + 4 * 0.25 / (k * d * d)) - 1)
        printf "  overlap %.7g, by energy %.7g\n", most, x; exit !(most / x < 1.001 && most / x > 0.998) }' impact/observables.csv
}
check 'a law with a number of its own' impact

refused() { # TEXT SETTING...
    local text=$1
    shift
    "$scree" check own.yaml "$@" >told 2>&1
    [ $? -eq 2 ] && grep -q '^scree: ' told && holds told "$text"
}
awk '{ sub(/c.overlap;/, "c.overlpa;"); print }' laws/hooke.c >wrong.c
check 'a mistake has file and line' refused 'wrong.c:5:' --set contact.law='{file: wrong.c}'
check 'and the place in the scene' refused 'contact.law' --set contact.law='{file: wrong.c}'
echo 'int x;' >none.c
check 'a file without a law' refused 'defines no law' --set contact.law='{file: none.c}'
check 'no such file' refused 'nowhere.c cannot be opened' --set contact.law='{file: nowhere.c}'
check 'no file' refused 'law_file: is missing' --set contact='{law: custom}'
check 'parameters' refused 'the law stiffening takes 1' --set contact.law='{file: laws/stiffening.c}'
compiler() { ! CC=/nowhere/cc "$scree" check own.yaml >told 2>&1 && holds told '/nowhere/cc does not compile it'; }
check 'the compiler of CC' compiler
named() { # a law in a file of any name, compiled by a compiler with flags
    local name
    for name in "a b'c\";\$x.c" '-o.c'; do
        cp laws/hooke.c "./$name"
        printf 'contact: {law: {file: "%s"}, rolling: spring}\n' "$(sed 's/["\\]/\\&/g' <<<"$name")" >law.part
        { grep -v '^contact:' own.yaml; cat law.part; } >named.yaml
        CC='cc -O1' "$scree" check named.yaml >told 2>&1 || { echo "  $name"; cat told; return 1; }
    done
}
check 'and a law in a file of any name' named
finish
