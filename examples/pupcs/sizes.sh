#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# What a larger and larger particle costs: sizes.sh [DIR [GRID...]]
#
# Eibl and Ruede, section 4.3: the cube of edge 80 of the scenario `large`, its sphere with a radius of 1 ... 30 (RADII), among
# spheres of radius 0.4 on a lattice that leaves out a cube around it; divided into GRID^3 subdomains, one a rank ("2 4": edges of 40
# and 20; 8 is 512 ranks, some 15 GB), with both ways of synchronising. Prints a JSON line a run, `pupcs` null where next-neighbour
# synchronisation refuses; with more ranks than cores, the cores count. DIR (out beside this script) keeps the lines (sizes.jsonl), a
# picture (sizes.svg) and a section for the page on scaling (sizes.md). STEPS (20) may be set.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
out=${1:-$(results out)}
[ $# = 0 ] || shift
[ $# != 0 ] || set -- 2 4
mkdir -p "$out"
export SCREE
radii=${RADII:-1 5 10 15 20 25 30}

# scene RADIUS
scene() {
    low=$((39 - $1)) high=$((41 + $1))
    cat <<END
units: none
box: {lower: [0, 0, 0], upper: [80, 80, 80], periodic: true}
contact: {law: hooke, tangential: none}
materials: [{name: sphere, density: 1}]
material_pairs: [{k_n: 0.33, restitution: 1}]
ghosts: reduced
guards: {overlap: off, speed: off}
output: {checkpoint: {at_end: false}}
step: {dt: 0.1, count: ${STEPS:-20}}
particles:
  sources:
    - {from: single, position: [40, 40, 40], radius: $1, velocity: [0.05, 0.03, -0.02]}
END
    while read -r lower upper; do
        echo "    - {from: lattice, lattice: sc, spacing: 1, sizes: 0.4, velocity_sigma: 0.0577, region: {shape: box, lower: [$lower], upper: [$upper]}}"
    done <<END
0,0,0 80,80,$low
0,0,$high 80,80,80
0,0,$low 80,$low,$high
0,$high,$low 80,80,$high
0,$low,$low $low,$high,$high
$high,$low,$low 80,$high,$high
END
}

section() {
    cat <<END

## The size of the largest particle

\`examples/pupcs/sizes.sh\` writes this section, after section 4.3 of Eibl and Rüde: one sphere of growing radius is in a periodic cube of edge 80 full
of spheres of radius 0.4, divided into subdomains of the given edge. The table has millions of particle updates per core and second. Many ranks
share few cores here, so messages cost more than with one core for each rank.

![particle updates against the radius of the largest particle](images/scaling-sizes.svg)

| edge | ranks | synchronisation |$(for radius in $radii; do printf ' R = %s |' "$radius"; done)
|---|---|---|$(for _ in $radii; do printf '%s' '---|'; done)
END
    awk -F'[:,"} ]+' '
        {
            for (k = 2; k < NF; k++) field[$k] = $(k + 1)
            row = "| " field["edge"] " | " field["ranks"] " | " field["sync"] " |"
            if (!(row in cells)) order[++rows] = row
            cells[row] = cells[row] (field["pupcs"] == "null" ? " refused |" : sprintf(" %.2f |", field["pupcs"] / 1e6))
        }
        END { for (k = 1; k <= rows; k++) print order[k] cells[order[k]] }' "$out/sizes.jsonl"
}

: >"$out/sizes.jsonl"
for grid in "$@"; do
    for sync in neighbours shadow; do
        curve=$out/sizes-$grid-$sync
        : >"$curve"
        for radius in $radii; do
            scene "$radius" >"$out/sizes.yaml"
            line="{\"scenario\": \"sizes\", \"edge\": $((80 / grid)), \"ranks\": $((grid * grid * grid)), \"sync\": \"$sync\", \"radius\": $radius, \"pupcs\":"
            if OMP_WAIT_POLICY=passive on_ranks $((grid * grid * grid)) "$SCREE" run "$out/sizes.yaml" -o "$out/sizes" --overwrite \
                --quiet --set threads=1 --set sync="$sync" 2>"$out/sizes.log"; then
                line="$line $(report_number "$out/sizes" pupcs), \"sync_share\": $(report_number "$out/sizes" sync_share)}"
                echo "$radius $(report_number "$out/sizes" pupcs)" >>"$curve"
            elif grep -q 'sync: neighbours' "$out/sizes.log"; then
                line="$line null}"
            else
                cat "$out/sizes.log" >&2
                exit 1
            fi
            echo "$line" | tee -a "$out/sizes.jsonl"
        done
    done
done
section >"$out/sizes.md"
command -v "${GNUPLOT:-gnuplot}" >/dev/null || exit 0
"${GNUPLOT:-gnuplot}" -e "picture = '$out/sizes.svg'; data = '$out/sizes-'; grids = '$*'" "$here/sizes.gp"
