#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Full and reduced ghosts against what geometry predicts: ghosts.sh [DIR]
#
# Spheres of radius 1 and R (10, 20, 40; RATIOS) at rest in a periodic cube on 8 ranks, newton on: LARGE (200) large ones take
# a tenth of the volume, SMALL (200000) small ones lie between them. A rank holds a copy of each small sphere whose centre lies
# within a distance d of its subdomain, a cuboid with edges a, b, c:
#
#     d = 1 + 1 + skin (reduced), 1 + R + skin (full)
#     copies = number density x (2 (ab + bc + ca) d + pi (a + b + c) d^2 + 4/3 pi d^3)
#
# A step sends 48 bytes a copy (position, velocity) and gets 24 back (force). Prints a JSON line a case and fails if copies or
# bytes of the small spheres differ from the prediction by more than 5 %. DIR/ghosts (out beside this script) keeps the
# reports, the lines and a section for the page on scaling (section.md).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
find_scree
out=${1:-$(results out)}/ghosts
mkdir -p "$out"
large=${LARGE:-200}
small=${SMALL:-200000}
ranks=8
steps=20
skin=0.1
export OMP_WAIT_POLICY=passive

# scene R GHOSTS EDGE
scene() {
    cat <<EOF
units: none
box: {lower: [0, 0, 0], upper: [$3, $3, $3], periodic: true}
step: {dt: 1e-3, count: $steps}
contact: {law: hooke, tangential: none}
materials: [{name: hard, density: 1}]
material_pairs: [{restitution: 0.9, k_n: 100}]
skin: {length: $skin}
classes: {method: cuts, cuts: [2]}
newton: on
ghosts: $2
domain: {name: brick}
output: {checkpoint: {at_end: false}}
particles:
  sources:
    - {from: random, count: $large, sizes: $1}
    - {from: random, count: $small, sizes: 1}
EOF
}

# section: the lines as a table
section() {
    cat <<EOF

## Reduced ghosts

\`examples/scaling/ghosts.sh\` writes this section. The scene has $large spheres of radius R in a tenth of a periodic cube and $small spheres of radius 1
between these spheres, at rest on $ranks ranks, newton on. With full ghosts all ranks within the reach of a large sphere get a copy of a small sphere;
with reduced ghosts only ranks within the reach of small spheres do. The geometric prediction is the number of spheres within this distance of a
subdomain. The copies of large spheres are the same in both.

| R | ghosts | copies of small spheres | by geometry | ratio | kB a step for them | by geometry | copies of large ones | kB a step in all |
|---|---|---|---|---|---|---|---|---|
EOF
    sed 's/"[a-z_R]*": //g; s/[{}"]//g' "$out/lines.jsonl" | awk -F', ' '{
        printf "| %s | %s | %s | %s | %.3f | %.0f | %.0f | %s | %.0f |\n", $1, $2, $5, $6, $7, $8 / 1000, $9 / 1000, $11, $13 / 1000 }'
}

failed=0
: >"$out/lines.jsonl"
for ratio in ${RATIOS:-10 20 40}; do
    edge=$(awk -v n="$large" -v r="$ratio" 'BEGIN { printf "%.6g", r * (n * 4 / 3 * 3.14159265 / 0.1) ^ (1 / 3) }')
    for ghosts in full reduced; do
        run=$out/$ratio-$ghosts
        scene "$ratio" $ghosts "$edge" >"$run.yaml"
        on_ranks $ranks "$SCREE" run "$run.yaml" -o "$run" --overwrite --quiet --set threads=1 >&2
        # a line of the report for each class, the small ones first
        sed -n 's/.*"particles": \([0-9]*\), "ghosts": \([0-9]*\), "bytes": \([0-9]*\), "radius_min".*/\1 \2 \3/p' "$run/report.json" |
            awk -v ratio="$ratio" -v ghosts="$ghosts" -v edge="$edge" -v ranks=$ranks -v skin=$skin -v steps=$steps '
            function copies(n, d, a) {
                a = edge / 2
                return ranks * n / edge ^ 3 * (6 * a ^ 2 * d + 3 * 3.14159265 * a * d ^ 2 + 4 / 3 * 3.14159265 * d ^ 3)
            }
            { n[NR] = $1; held[NR] = $2; bytes[NR] = $3 }
            END {
                if (NR != 2) exit 2
                expected = copies(n[1], 1 + skin + (ghosts == "full" ? ratio : 1))
                # forces go back once before the first step, too
                each = steps * 72 + 24
                part = held[1] / expected
                share = bytes[1] / (expected * each)
                printf "{\"R\": %d, \"ghosts\": \"%s\", \"ranks\": %d, \"small\": %d, ", ratio, ghosts, ranks, n[1]
                printf "\"small_ghosts\": %d, \"predicted\": %.0f, \"ratio\": %.4f, ", held[1], expected, part
                printf "\"small_bytes_per_step\": %.0f, \"predicted_bytes_per_step\": %.0f, \"bytes_ratio\": %.4f, ", \
                    bytes[1] / each * 72, expected * 72, share
                printf "\"large_ghosts\": %d, \"predicted_large\": %.0f, \"all_bytes_per_step\": %.0f}\n", held[2], \
                    copies(n[2], 2 * ratio + skin), (bytes[1] + bytes[2]) / each * 72
                exit part < 0.95 || part > 1.05 || share < 0.95 || share > 1.05
            }' >"$out/line" || failed=1
        tee -a "$out/lines.jsonl" <"$out/line"
    done
done
section >"$out/section.md"
exit $failed
