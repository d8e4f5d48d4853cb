#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# scree pack as a user starts the command: files for LAMMPS and H5MD that the program reads back, equal on any number of ranks
# and threads, and mistakes that end with status 2 before the program makes any file.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

# packed RANKS ARGUMENTS...: what it prints goes to said
packed() {
    local ranks=$1
    shift
    on "$ranks" "$scree" pack "$@" >said 2>warned || { cat said warned; return 1; }
}

same_numbers() {
    cmp "$1" "$2"
}

printf '# opening, mm; percent that passes\n1 0\n2 40\n4 100\n' >sieve.txt
check "bidisperse, two files" packed 1 bidisperse b.data b.h5 ratio=3 box=20 large=9 small=600 velocity=1
check "numbers are printed" holds said "9 large, 600 small"
check "no overlap is printed" holds said "none overlap"
check "on three ranks" packed 3 bidisperse b3.data b3.h5 ratio=3 box=20 large=9 small=600 velocity=1
check "they say that one works" holds warned "works on one rank"
check "and the data are the same" same_numbers b.data b3.data
check "with three threads" packed 1 bidisperse t3.data ratio=3 box=20 large=9 small=600 velocity=1 threads=3
check "the data are the same again" same_numbers b.data t3.data
check "H5MD reads back" "$scree" convert b.h5 back.data
check "and holds the same atoms" same_numbers <(sed -n '/^Atoms/,/^Velocities/p' b.data | awk 'NF == 7 { print $1, $2, $5, $6, $7 }') \
    <(sed -n '/^Atoms/,/^Velocities/p' back.data | awk 'NF >= 7 { print $1, $2, $5, $6, $7 }')
cat >packed.yaml <<'EOF'
units: none
step: {count: 1}
contact: {law: hooke}
materials: [{name: a, density: 1}]
material_pairs: [{restitution: 0.5, k_n: 1000}]
particles: {file: b.h5, format: h5md, material: a}
EOF
# sides WORDS FLAG...: what brings images in this scene
sides() {
    "$scree" check --all packed.yaml "${@:2}" >said 2>&1 || { cat said; return 1; }
    [ "$(grep -o 'a periodic direction: .*' said)" = "$1" ] || { cat said; return 1; }
}
check "a scene takes the periodic sides of the file" sides 'a periodic direction: x, y, z'
check "unless it says itself" sides '' --set box.periodic=false
check "H5MD of three ranks reads back" "$scree" convert b3.h5 back3.data
check "and is the same" same_numbers back.data back3.data

for law in "univol count=500 ratio=8 fraction=0.5" "sand count=500" "exponential count=3000" "power count=500" \
    "sieve table=sieve.txt count=500"; do
    # shellcheck disable=SC2086
    set -- $law
    law=$1
    shift
    check "$law" packed 1 "$law" "$law.data" "$@"
    check "$law does not overlap" holds said "none overlap"
    check "$law is read" "$scree" info "$law.data"
    check "$law has help" "$scree" help pack "$law"
done

check "a cylinder" packed 1 power c.data c.h5 shape=cylinder radius=10 length=20 max=2 fraction=0.5
check "is named, with its fraction" holds said "in a cylinder of radius 10 and length 20"
check "on three ranks" packed 3 power c3.data c3.h5 shape=cylinder radius=10 length=20 max=2 fraction=0.5
check "the cylinder is the same" same_numbers c.data c3.data
check "its axis is that of z" holds c.data "10 10 xlo xhi"
check "its H5MD has the same box" sh -c '"$1" convert c3.h5 cback.data --overwrite && grep -q "^-10 10 xlo xhi" cback.data' sh "$scree"
cat >pour.yaml <<'EOF'
units: none
step: {count: 5}
contact: {law: hooke}
materials: [{name: a, density: 1}]
material_pairs: [{restitution: 0.5, k_n: 1000}]
walls: [{shape: cylinder, point: [0, 0, 10], axis: [0, 0, 1], radius: 10, length: 20, inside: true}]
particles: {file: c.h5, format: h5md, material: a}
EOF
check "a scene runs in it" "$scree" run pour.yaml -o poured --quiet
check "a sieve curve as a list" packed 1 sieve list.data diameters=1,2,4 passing=0,40,100 count=500
check "is that of the file" same_numbers list.data sieve.data
printf 'radius passing\n0.5 0\n1 0.4\n2 1\n' >radii.txt
check "a file of radii and parts" packed 1 sieve radii.data table=radii.txt count=500
check "is the same" same_numbers radii.data sieve.data
check "a few sizes" packed 1 discrete few.data radii=1,3 weights=60,40 count=500 by=number
check "are those" holds said "radii 1 to 3"
for form in "radii: [0.5, 1, 2], passing: [0, 0.4, 1]" "diameters: [1, 2, 4], passing: [0, 40, 100]" "file: sieve.txt"; do
    cat >sieve.yaml <<EOF
units: none
box: {lower: [0, 0, 0], upper: [20, 20, 20]}
step: {count: 1}
contact: {law: hooke}
materials: [{name: a, density: 1}]
material_pairs: [{restitution: 0.5, k_n: 1000}]
particles: {from: random, volume_fraction: 0.2, sizes: {law: table, $form}}
output: {dump: {every: 1}}
EOF
    check "a scene takes it as {$form}" "$scree" run sieve.yaml -o sieved --overwrite
    [ -e first.dump ] || cp sieved/dump.lammpstrj first.dump
    check "with the same particles" same_numbers first.dump sieved/dump.lammpstrj
done

# A packed source in scenes: two of them around a cylinder and a frozen sphere, random ones between
cat >source.yaml <<'EOF2'
units: none
box: {lower: [0, 0, 0], upper: [10, 10, 12], periodic: [true, false, false]}
step: {count: 20, fraction: 0.2}
reproducible: true
gravity: [0, 0, -1]
contact: {law: hooke}
materials: [{name: a, density: 1}, {name: b, density: 2}]
material_pairs: [{restitution: 0.5, k_n: 10000}]
groups: [{name: held, motion: frozen}]
walls:
  - {shape: plane, point: [0, 0, 0], normal: [0, 0, 1], material: a}
  - {shape: cylinder, point: [7, 5, 6], axis: [0, 0, 1], radius: 1.5, length: 12, inside: false, material: a}
particles:
  sources:
    - {from: single, position: [3, 3, 3], radius: 2, material: b, group: held}
    - {from: packed, volume_fraction: 0.3, sizes: {law: uniform, min: 0.4, max: 0.8}, material: a}
    - {from: packed, count: 60, sizes: 0.3, material: b, density: 5, velocity_sigma: 0.1}
    - {from: packed, meets: yield, count: 400, sizes: 0.15, material: a}
    - {from: random, count: 20, sizes: 0.1, material: a}
observables: {every: 1, list: [{name: overlap_max}]}
output: {dump: {every: 10}, checkpoint: {every: 10}}
EOF2
# scene OUTPUT RANKS ARGUMENTS...
scene() {
    on "$2" "$scree" run source.yaml -o "$1" --quiet "${@:3}" >said 2>&1 || { cat said; return 1; }
}
# last FOLDER: the particles of the last frame, by id
last() {
    awk '/^ITEM: ATOMS/ { n = 0; next } /^ITEM/ { next } NF > 8 { row[n++] = $0 } END { for (k = 0; k < n; k++) print row[k] }' "$1/dump.lammpstrj" | sort -n
}
check "packed sources run" scene one 1
check "and begin without overlap" sh -c '[ "$(sed -n 2p one/observables.csv)" = 0,0 ]'
check "on three ranks" scene three 3
check "they are the same" same_numbers <(last one) <(last three)
check "a run resumes" scene again 2 --resume one/checkpoint-10.h5
check "to the same end" same_numbers <(last one) <(last again)
check "check counts them" sh -c '"$1" check source.yaml >said && grep -q "[0-9]* particles, 2 materials, 2 walls, 2 groups" said' sh "$scree"
check "a box that shears" scene shear 2 --set box.periodic=true --set 'box.shear={flow: x, gradient: y, rate: 0.1}' \
    --set 'walls=~' --set 'groups=~' --set 'particles={from: packed, material: a, sizes: 0.5, volume_fraction: 0.55}'
check "with heat, and a temperature of its own" scene hot 1 --set 'particles.sources[1].temperature=400' \
    --set 'heat={temperature: 300, materials: [{material: a, conductivity: 1, capacity: 1}, {material: b, conductivity: 1, capacity: 1}]}'

# Spheres that settle. number WORD: the number before this word of what the program printed
number() {
    sed -n "s/.* \\([0-9.e+-]*\\) $1.*/\\1/p; s/.*$1 \\([0-9.e+-]*[0-9]\\).*/\\1/p" said | head -n 1
}
between() {
    awk -v least="$1" -v value="$2" -v most="$3" 'BEGIN { if (value == "" || !(value + 0 >= least && value + 0 <= most)) {
        print "  " value " is not in " least " ... " most; exit 1 } }'
}
# lowered FILE FILE PART: the mean height of the spheres of the first is below this part of that of the second
lowered() {
    awk 'FNR == 1 { on = 0 } /^Atoms/ { on = 1; file++; next } on && NF >= 7 { sum[file] += $7; n[file]++ }
        END { exit !(n[1] == n[2] && n[1] > 30 && sum[1] < part * sum[2]) }' part="$3" "$1" "$2"
}
# inside FILE RADIUS LENGTH: no sphere leaves the cylinder by more than a fiftieth of its radius
inside() {
    awk -v R="$2" -v L="$3" '/^Atoms/ { on = 1; next } on && NF >= 7 { r = $3 / 2; d = sqrt($5 ^ 2 + $6 ^ 2) + r - R
        if (d > 0.02 * r || $7 < 0.98 * r || $7 > L - 0.98 * r) { print "  " $0; bad = 1 } n++ } END { exit bad || n < 30 }' "$1"
}
mkdir -p settle-tmp
export TMPDIR=$out/settle-tmp
settled="shape=cylinder radius=4 length=9 min=0.8 max=1.2 fraction=0.3"
# shellcheck disable=SC2086
{
check "a cylinder of spheres in the air" packed 1 power air.data $settled
check "that settle" packed 1 power bed.data $settled settle=yes
check "they come to rest" holds said "settled in "
check "at rest indeed" sh -c '! grep -q "not at rest" warned'
check "each with the contacts of a bed" between 3.5 "$(number 'contacts a sphere')" 7
check "as dense as a bed" between 0.4 "$(number "solid fraction of")" 0.68
check "lower than before" lowered bed.data air.data 0.9
check "inside the cylinder" inside bed.data 4 9
check "on three ranks and one thread" packed 3 power bed3.data $settled settle=yes threads=1
check "the bed is the same" same_numbers bed.data bed3.data
check "without friction" packed 1 power smooth.data $settled settle=yes friction=0
check "the bed is lower" lowered smooth.data bed.data 0.98
check "a ball" packed 1 power ball.data shape=sphere radius=4 min=0.8 max=1.2 fraction=0.3 settle=yes
check "settles" holds said "settled in "
box=$'a "box" of \'6\' sides\n\\.txt'
printf '%s\n' '0 0 0 0 12 0 12 0 0' '12 0 0 0 12 0 12 12 0' '0 0 12 12 0 12 0 12 12' '12 0 12 12 12 12 0 12 12' \
    '0 0 0 12 0 0 0 0 12' '12 0 0 12 0 12 0 0 12' '0 12 0 0 12 12 12 12 0' '12 12 0 0 12 12 12 12 12' \
    '0 0 0 0 0 12 0 12 0' '0 12 0 0 0 12 0 12 12' '12 0 0 12 12 0 12 0 12' '12 12 0 12 12 12 12 0 12' >"$box"
check "a mesh" packed 1 power mesh.data shape=mesh "file=$box" min=1.5 max=2 fraction=0.35 settle=yes
check "settles, too" between 0.4 "$(number "solid fraction of")" 0.68
check "no file is left" rmdir "$TMPDIR"
unset TMPDIR
}

# refused WORDS ARGUMENTS...: status 2, one line with these words, and no file
refused() {
    local words=$1
    shift
    "$scree" pack "$@" >said 2>warned
    local status=$?
    [ $status = 2 ] || { echo "  status $status"; return 1; }
    [ "$(wc -l <warned)" = 1 ] && holds warned "$words" && [ ! -e new.data ]
}

check "no law of this name" refused "no law of sizes" gravel new.data
check "no file" refused "needs a file to write" sand ratio=10
check "no format" refused "format is not clear" sand new.xyz
check "a file that is there" refused "is there already" sand b.data
check "a folder that is not" refused "folder is not there" sand nowhere/new.data
check "no such key" refused "no key of the law" sand new.data colour=3
check "too dense" refused "too dense" power new.data count=200 max=1.01 fraction=0.8 sweeps=20
check "a sieve file that is not there" refused "no.txt" sieve new.data table=no.txt
check "no such container" refused "allowed are cube, box, cylinder, sphere, mesh" power new.data shape=ball
check "a container's key that is missing" refused "needs radius= and length=" power new.data shape=cylinder radius=3
check "another container's key" refused "edges= does not go with shape=sphere" power new.data shape=sphere radius=9 edges=1,2,3
check "two edges" refused "three lengths" power new.data shape=box edges=1,2
check "periodic and round" refused "walls=periodic goes with" power new.data shape=sphere radius=9 walls=periodic
check "count, fraction and size" refused "two decide the third" power new.data shape=sphere radius=9 count=9 fraction=0.3
check "settling without walls" refused "settle=yes needs walls" power new.data box=20 fraction=0.3 settle=yes walls=periodic
check "friction of spheres that do not settle" refused "friction= goes with settle=yes" power new.data friction=0.3
check "published systems do not settle" refused "no key of the law" bidisperse new.data settle=yes
check "too many for it" refused "times that of the region" power new.data shape=sphere radius=20 count=5000
check "too large a container" refused "fewer than 134217728" power new.data shape=sphere radius=1e6
check "a mesh that is not there" refused "nix.stl" power new.data shape=mesh file=nix.stl
printf '0 0 0 1 0 0 0 1 0\n' >open.txt
check "an open mesh" refused "no closed surface" power new.data shape=mesh file=open.txt
check "overwriting" packed 1 power b.data count=100 --overwrite --quiet
check "quietly" test ! -s said

finish
