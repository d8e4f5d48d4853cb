#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Small grains in a stream around a rock: run.sh [DIR]. Prints a line of JSON, which DIR/results.jsonl has, too: small grains, those that are inside of the rock, their
# mean velocity along the stream. Draws DIR/two-sizes.png where gnuplot is and PICTURE=1.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
out=${1:-$(results out)}
# shellcheck disable=SC2086
"$SCREE" run "$here/scene.yaml" -o "$out" --overwrite --quiet ${SCREE_ARGS:-}
awk -v out="$out" '/^ITEM: TIMESTEP/ { getline; frame = $1 } /^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next } /^ITEM/ { reading = 0 }
    reading && NF > 4 { x = $at["x"]; y = $at["y"] - 0.5; z = $at["z"]; small = $at["radius"] == 0.004; off = y < 0 ? -y : y
        if (off < 0.1 && (small || ($at["radius"] < 0.1 && y > 0 && y < 0.0625))) print x, z, sqrt($at["vx"] ^ 2 + $at["vy"] ^ 2 + $at["vz"] ^ 2) >(out "/" (small ? "small" : "fluid") "-" frame ".txt")
        if (small && frame > last) { last = frame; n = sum = inside = 0 }
        if (small) { n++; sum += $at["vx"]; inside += (x - 0.75) ^ 2 + y ^ 2 + (z - 0.5) ^ 2 < 0.26 ^ 2 } }
    END { printf "{\"grains\": %d, \"inside\": %d, \"velocity\": %.4f}\n", n, inside, sum / n }' "$out/dump.lammpstrj" | tee "$out/results.jsonl"
if [ "${PICTURE:-0}" = 1 ]; then
    gnuplot -e "out='$out/'" "$here/picture.gp"
    echo "drawn: $out/two-sizes.png" >&2
fi
rm "$out"/small-*.txt "$out"/fluid-*.txt
