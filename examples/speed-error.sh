#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Speed against error of the examples, as docs/speed-error.md shows it: speed-error.sh [column|penetration|drum|angle]...
#
# Each of them takes minutes to a quarter of an hour on one core. Results in out-speed-error/NAME (speed_error.txt, .csv, .svg); the pictures
# go to docs/images of this checkout as well.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/common.sh"
out=$(results out-speed-error)
[ $# -gt 0 ] || set -- column penetration drum angle
export OMP_NUM_THREADS=1

# study NAME SCENE FLAG...
study() {
    local name=$1 scene=$2
    shift 2
    "$SCREE" ablate "$here/$scene" --error -o "$out/$name" --overwrite --set threads=1 "$@" || exit 1
    [ ! -w "$here/../docs/images" ] || [ ! -s "$out/$name/speed_error.svg" ] || cp "$out/$name/speed_error.svg" "$here/../docs/images/speed-error-$name.svg"
}

mkdir -p "$out" || exit 1
for name in "$@"; do
    case $name in
    column) # the whole collapse, at a step as long as one takes in practice
        study column column/scene.yaml --duration 0.1 --samples 50 --members 4 --repeat 1 --set step.fraction=0.45 --judge sand_z,foot ;;
    penetration) # the ball is set down where it meets the bed
        study penetration penetration/scene.yaml --duration 0.0004 --samples 16 --members 2 --repeat 1 --judge ball_z,ball_vz \
            --set 'particles.sources[1].position=[0, 0, -4.64 cm]' --set 'particles.sources[1].velocity=[0, 0, -5.2]' ;;
    drum) # the packing takes up the turning
        study drum drum/scene.yaml --duration 0.0012 --samples 16 --members 2 --repeat 1 --judge trajectory,energy_kinetic ;;
    angle) # discs in a drum that has turned for long: means and their spread
        study angle verify/drum-angle/scene.yaml --duration 100 --samples 200 --mean-from 50 --members 4 --repeat 1 --judge centre_x,centre_y ;;
    *) echo "speed-error.sh: there is no '$name'" >&2 && exit 2 ;;
    esac
done
