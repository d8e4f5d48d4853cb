#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# scree picture: what is drawn of a run and where, its messages, and a picture and a film by the programs that draw them.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

printf '0 0 3 1 0 3 0 1 3\n0 0 -1 1 0 -1 0 1 -1\n' >plate.txt
cat >bed.yaml <<'EOS'
units: none
gravity: [0, 0, -10]
duration: 0.02
box: {lower: [-2, -2, -2], upper: [4, 4, 4]}
contact: {law: hooke}
materials: [{name: glass, density: 1}, {name: steel, density: 2}]
material_pairs: [{restitution: 0.5, k_n: 1000}]
walls:
  - {name: floor, shape: plane, point: [0, 0, -1.1], normal: [0, 0, 1], material: glass}
  - {name: roof, shape: plane, point: [0, 0, 2], normal: [0, 0, -1], material: glass}
  - {name: tube, shape: cylinder, point: [0, 0, 0], axis: [0, 0, 1], radius: 6, inside: true, material: glass}
  - {name: plate, shape: mesh, file: plate.txt, format: table, material: glass, motion: [{kind: translate, velocity: [5, 0, 0]}]}
particles:
  sources:
    - {from: single, position: [0, 0, 0], radius: 0.5, material: glass}
    - {from: single, position: [2, 0, 0], radius: 0.25, velocity: [3, 0, 4], material: glass}
    - {from: single, position: [0, 2, 1], radius: 0.25, material: glass}
    - {from: single, position: [2, 2, 1], radius: 0.5, material: steel}
step: {dt: 0.001}
output: {trajectory: {every: 10}}
EOS
check 'a run' run_scene 1 bed.yaml bed

# draw FLAG...: the text for POV-Ray in bed.pov
draw() { on 1 "$scree" picture bed -o bed.pov --overwrite "$@" >said.txt 2>&1 || { cat said.txt; return 1; }; }
colours() { sed -n 's/^sphere{.*texture{\(.*\)}}/\1/p' bed.pov | tr '\n' ' '; }
drawn() { # WANTED FLAG...
    local wanted=$1
    shift
    draw "$@" && [ "$(colours)" = "$wanted " ] || { echo "  $(colours)instead of $wanted"; return 1; }
}
check 'several materials have a colour each' drawn 'C0 C0 C0 C1'
check 'the materials have names in the legend' holds bed.pov '"steel"'
check 'a radius has the first or the last of four colours' drawn 'C3 C0 C0 C3' --colour radius --bands 4
check 'a range limits the colours' drawn 'C1 C0 C0 C1' --colour radius --bands 4 --range 0.25,1.2
check 'a component of a field of the trajectory' drawn 'C0 C3 C0 C0' --colour velocity.x --bands 4
check 'the value of another frame' drawn 'C0 C0 C3 C3' --colour z@0 --bands 4
check 'a cut takes away what fulfils all conditions' drawn 'C0 C0 C0' --colour z@0 --cut 'x>1,y>1' --bands 2 --range 0,9
check 'grey ones are not cut' drawn 'G' --colour radius --grey steel --cut 'x<9' --bands 4
fits() { # every sphere lies in the angle of view
    awk -F'[<,>]' '/^camera/ { split($0, w, /right |\*x up |\*y/); across = w[2] / 2; up = w[3] / 2 }
        /^sphere/ { split($5, r, " "); n++; for (s = -1; s <= 1; s += 2) {
            if (s * $2 + r[1] * sqrt(1 + across ^ 2) > $4 * across || s * $3 + r[1] * sqrt(1 + up ^ 2) > $4 * up) bad = bad " " $0 } }
        END { print bad; exit bad != "" || n != 4 }' bed.pov
}
for view in corner front 77,-30; do
    check "all is seen from $view" eval "draw --view $view --colour z && fits >fits.txt"
done
turned() { # seen from the front x is to the right and z is up, from the right y is to the right
    draw --view "$1" --bare && awk -F'[<,>]' -v to="$2" '/^sphere/ { x[++n] = $2; y[n] = $3; z[n] = $4 }
        END { exit !(x[to] > x[1] + 50 && y[4] > y[1] + 20 && (z[5 - to] - z[1]) * (to == 2 ? 1 : -1) > 50) }' bed.pov
}
check 'x is to the right from the front' turned front 2
check 'y is to the right from the right' turned right 3
walls() { # the floor and the lower plate, not what hides the particles: the roof, the upper plate
    draw --view 0,30 --colour z && [ "$(grep -c '^union' bed.pov)" = 1 ] && [ "$(grep -v ^union bed.pov | grep -c 'triangle{')" = 1 ] &&
        [ "$(grep -c '^cylinder' bed.pov)" = 1 ] || { grep -E '^union|triangle|^cylinder' bed.pov; return 1; }
}
check 'walls are drawn but for those between the camera and the particles' walls
moved() { # from the front 0.02 s at a speed of 5 are a tenth of the unit on the right, of which 2.75 are `wide`
    draw --view front --colour z --frame 0 && sed -n '/^union/d;s/.*triangle{<\([^,]*\),.*/\1/p' bed.pov | head -1 >first.txt &&
        draw --view front --colour z && sed -n '/^union/d;s/.*triangle{<\([^,]*\),.*/\1/p' bed.pov | head -1 >last.txt || return 1
    awk -v a="$(cat first.txt)" -v b="$(cat last.txt)" -F'[<,>]' '/^sphere/ { x[++n] = $2; at = n == 1 ? 0 : at }
        END { unit = (x[4] - x[1]) / 2; print a, b, unit; exit !(b - a > 0.01 * unit && b - a < 0.2 * unit) }' bed.pov >moved.txt || { cat moved.txt; return 1; }
}
check 'a wall that moves is where it is at that time' moved
bare() { draw --bare && ! grep -q '^union\|^text' bed.pov; }
check 'no walls and no legend' bare
gone() { # in a stage that has opened the gate: the plate is no more, the floor is
    sed -e '/name: plate/d' -e '/name: roof/d' -e 's/^duration: .*/stages: [{name: closed, duration: 0.01}, {name: open, duration: 0.01, set: {"walls[tube]": ~}}]/' bed.yaml >gate.yaml
    run_scene 1 gate.yaml gate && on 1 "$scree" picture gate -o gate.pov --view 0,30 >said.txt 2>&1 && ! grep . said.txt &&
        [ "$(grep -c '^union' gate.pov)" = 1 ] && ! grep '^cylinder' gate.pov || { cat said.txt; return 1; }
}
check 'a wall that a stage has taken away is not drawn, the others are' gone
whole() { on 1 "$scree" picture bed/checkpoint-20.h5 -o point.pov --colour radius --bands 4 && grep -c '^sphere' point.pov | grep -qx 4; }
check 'a checkpoint is drawn' whole

says() { # TEXT FLAG...: exit status 2 and the text
    local text=$1 status=0
    shift
    on 1 "$scree" picture "$@" >said.txt 2>&1 || status=$?
    [ "$status" = 2 ] && grep -q -- "$text" said.txt || { cat said.txt; return 1; }
}
check 'message: no such field' says "no field 'heat'; it has: .*velocity" bed -o a.png --colour heat
check 'message: nothing to draw' says 'holds nothing to draw' . -o a.png
check 'message: ending' says 'must end in' bed -o a.gif
check 'message: view' says 'corner, front' bed -o a.png --view behind
check 'message: cut' says 'conditions on centres' bed -o a.png --cut y=0
check 'message: all cut' says 'takes all particles away' bed -o a.png --cut 'x<9'
check 'message: frame' says 'has 3 frames' bed -o a.png --frame 3
left() { # a run whose particles leave: the message names the last frame that has some
    cat >leave.yaml <<'EOS'
units: none
box: {lower: [0, 0, 0], upper: [4, 4, 4], leave: delete}
step: {count: 300, dt: 0.01}
contact: {law: hooke}
materials: [{name: a, density: 1}]
material_pairs: [{k_n: 1, restitution: 0.9}]
particles: {from: single, position: [2, 2, 2], radius: 0.1, velocity: [1, 0, 0]}
output: {trajectory: {every: 100}}
EOS
    run_scene 1 leave.yaml leave && says 'frame 3 has no particles; the last one before it that has some: --frame [12]' leave -o a.png
}
check 'message: an empty frame' left
check 'message: palette' says 'viridis' bed -o a.png --palette jet
empty() { local status=0; PATH=/nowhere "$scree" picture bed -o a.png >said.txt 2>&1 || status=$?; [ $status = 2 ] && grep -q 'povray is not there' said.txt && [ ! -e a.png ] && [ ! -e a.png.frames ] || { cat said.txt; return 1; }; }
check 'message: POV-Ray is not there' empty
if command -v povray >/dev/null; then
    png() { on 1 "$scree" picture bed -o bed.png --size 64x48 && [ "$(od -An -tx1 -j16 -N8 bed.png | tr -d ' \n')" = 0000004000000030 ] && [ ! -e bed.png.frames ]; }
    check 'a picture of 64 x 48 pixels' png
    # names [ENDING]: whatever letters a name has, other programs see plain ones
    names() {
        local name
        for name in 'a b' "a'b\"c" 'a;b' 'a[1]' 'a,b=c' '$HOME`x`' '+Oc' '%d' $'a\nb' 'ä ü'; do
            mkdir -p "in $name" && on 1 "$scree" picture bed -o "in $name/$name.$1" --size 64x48 && [ -s "in $name/$name.$1" ] &&
                [ "$(find "in $name" | grep -c .)" = "$(find "in $name/$name.$1" "in $name" -maxdepth 0 | grep -c .)" ] ||
                { echo "  not $name.$1"; return 1; }
        done
        on 1 "$scree" picture bed -o "-W9.$1" --size 64x48 && [ -s "./-W9.$1" ]
    }
    check 'a name may have any letters' names png
    film() { on 1 "$scree" picture bed -o bed.mp4 --size 64x48 && [ -s bed.mp4 ] && [ ! -e bed.mp4.frames ]; }
    if command -v ffmpeg >/dev/null; then check 'a film' film && check 'of any name' names mp4; else skip 'film: no ffmpeg here'; fi
else
    skip 'picture: no povray here'
fi
finish
