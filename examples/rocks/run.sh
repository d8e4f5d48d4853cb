#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Rocks in a drum, in a hopper and in a heap: run.sh [--quick] [-o DIR] [NAME...], NAME one of drum, hopper, heap. Draws DIR/NAME.png; of the heap
# also writes DIR/angles.tsv, a row for each roundness: roundness, angle in degrees, rocks that stayed; the last row is of spheres.
# --quick: seconds instead of minutes, as the tests do; it draws nothing. Further settings by SCREE_ARGS, ranks by SCREE_RANKS.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
quick=no
out=
while :; do
    case ${1:-} in
    --quick) quick=yes ;;
    -o) out=$2 && shift ;;
    *) break ;;
    esac
    shift
done
out=${out:-$(results out)}
[ $# != 0 ] || set -- drum hopper heap
mkdir -p "$out"

# run NAME SCENE [FLAG...]
run() {
    folder=$1
    scene=$2
    shift 2
    # shellcheck disable=SC2086
    on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/$scene.yaml" -o "$out/$folder" --overwrite --quiet "$@" ${SCREE_ARGS:-}
}

# draw NAME RUN [FLAG...]
draw() {
    picture=$out/$1.png
    from=$out/$2
    shift 2
    [ $quick = yes ] || ! command -v povray >/dev/null || { "$SCREE" picture "$from" -o "$picture" --overwrite --size 480x360 "$@" && echo "drawn: $picture"; }
}

# The slope of a heap that leans on the wall at x = 0 and runs out at the edge of the floor is a triangle, whose centre has a third of its
# length and height
heap() { # NAME ROUNDNESS FLAG...
    name=$1
    roundness=$2
    shift 2
    run "heap-$name" heap "$@"
    "$SCREE" info "$out/heap-$name" --column centre_x --row last >"$out/x"
    "$SCREE" info "$out/heap-$name" --column centre_z --row last >"$out/z"
    "$SCREE" info "$out/heap-$name" --column particles --row last | paste "$out/x" "$out/z" - |
        awk -v name="$roundness" '{ printf "%s\t%.1f\t%d\n", name, atan2($2, $1) * 45 / atan2(1, 1), $3 }' >>"$out/angles.tsv"
}

for one; do
    case $one in
    drum)
        # shellcheck disable=SC2046
        run drum drum $([ $quick = no ] || echo --set duration=0.3s --set particles.sources[0].region.length=1cm --set box.upper=[0.052,0.02,0.052])
        draw drum drum --colour z@0 --view front
        ;;
    hopper)
        # shellcheck disable=SC2046
        run hopper hopper $([ $quick = no ] || echo --set stages[0].duration=0.15s --set stages[1].duration=0.2s --set particles.sources[0].count=60)
        draw hopper hopper --colour z@0
        ;;
    heap)
        : >"$out/angles.tsv"
        for roundness in 0.1 0.3 0.6 0.9; do
            if [ $quick = no ] || [ $roundness = 0.6 ]; then
                # shellcheck disable=SC2046
                heap $roundness $roundness --set bodies.shapes[0].roundness=$roundness $([ $quick = no ] || echo --set duration=0.05s)
            fi
        done
        [ $quick = yes ] || heap spheres spheres --set bodies='~' --set particles.sources[0].shape='""'
        cat "$out/angles.tsv"
        draw heap heap-0.1 --colour z@0
        ;;
    *) echo "run.sh: $one: allowed are drum, hopper and heap" >&2 && exit 2 ;;
    esac
done
