#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Dense random packings of rocks of one shape: run.sh [--quick] [-o DIR] [SHAPE...], SHAPE one of sphere, ball, oblate, triaxial, superball, cube, tetrahedron,
# octahedron, dodecahedron. Writes DIR/fractions.tsv, a row for each shape: shape, volume fraction without friction, with friction 0.5 (where loose packings are published), rocks
# that a rock touches without friction, published fractions. --quick: cubes and tetrahedra, few and fast, without friction alone. Further settings by SCREE_ARGS, ranks by SCREE_RANKS.
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
mkdir -p "$out"
count=$([ $quick = no ] && echo 100 || echo 40)
if [ $# = 0 ] && [ $quick = yes ]; then
    set -- cube tetrahedron
elif [ $# = 0 ]; then
    set -- sphere ball oblate triaxial superball cube tetrahedron octahedron dodecahedron
fi

# pack SHAPE FRICTION: one run
pack() {
    set -- "$1" "$2" "$out/$1-$2" --set "material_pairs[0].friction=$2" --set particles.sources[0].count="$count"
    case $1 in
    sphere) set -- "$@" --set bodies='~' --set particles.sources[0].shape='""' --set particles.sources[0].volume_fraction=0.3 --set output.trajectory='~' ;;
    tetrahedron) set -- "$@" --set "bodies.shapes[0].vertices=[$(awk -v shape="$1" -f "$here/shapes.awk")]" --set particles.sources[0].volume_fraction=0.06 ;;
    *) set -- "$@" --set "bodies.shapes[0].vertices=[$(awk -v shape="$1" -f "$here/shapes.awk")]" ;;
    esac
    [ $quick = no ] || set -- "$@" --set duration=30 --set box.stress.inertia=1
    folder=$3
    shift 3
    # shellcheck disable=SC2086
    on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/scene.yaml" -o "$folder" --overwrite --quiet "$@" ${SCREE_ARGS:-}
}

# last SHAPE FRICTION COLUMN: the mean over the last fifth of a run
last() {
    "$SCREE" info "$out/$1-$2" --column "$3" | awk '{ v[NR] = $1 } END { for (k = int(0.8 * NR) + 1; k <= NR; k++) { s += v[k]; n++ } printf "%.3f", s / n }'
}

: >"$out/fractions.tsv"
for shape; do
    pack "$shape" 0
    loose=
    if [ $quick = no ] && grep -q "^$shape.*loose" "$here/published.txt"; then
        pack "$shape" 0.5
        loose=$(last "$shape" 0.5 solid_fraction)
    fi
    printf '%s\t%s\t%s\t%s\t%s\n' "$shape" "$(last "$shape" 0 solid_fraction)" "$loose" "$(last "$shape" 0 contacts | awk -v n="$count" '{ printf "%.1f", 2 * $1 / n }')" \
        "$(awk -F '\t' -v shape="$shape" '$1 == shape { print $2 }' "$here/published.txt")" | tee -a "$out/fractions.tsv"
done
