# SPDX-License-Identifier: BSD-3-Clause
# Sourced by run.sh. pour: beads fall into a column, a lid presses them to the porosity wanted, the middle is cut out and closed to a packing that
# repeats along the axis; DIR/packing.txt gets its places.
#
# The beads begin at random places, 28 % of the space, and fall into the column; when they are at rest the lid falls to 0.6 mm above its last place, and
# sinks from there with 3 cm/s. What is above is pushed in; friction lets the packing be as loose as it is. Floor and lid lie two diameters away from
# the cut, which floor and lid have not ordered in layers, and 0.2 mm farther apart, which is about what such layers hold less.

pour() {
    poured=$(awk -v n="$beads" -v height="$height" 'BEGIN { printf "%d", n * (height + 2e-3) / height + 0.5 }')
    awk -v n="$poured" -v r=0.25e-3 -v column="$column" -v height="$height" 'BEGIN {
        height += 2.2e-3
        length_ = n * 4 / 3 * r ^ 3 / (0.28 * column ^ 2)
        top = length_ + 0.6e-3
        rest = 0.03 + sqrt(2 * (top - 0.5 * height) / 9.81)
        near = height + 0.6e-3
        press = rest + 0.015
        still = press + (near - height) / 0.03
        printf "ceiling=%.9g top=%.9g middle=%.9g length=%.9g end=%.9g\n", top + 0.2e-3, top, 0.5 * length_ + 0.3e-3, length_, still + 0.015 >"/dev/stderr"
        printf "%.9g 0 0 0 0 0 0\n%.9g 0 0 %.9g 0 0 0\n%.9g 0 0 %.9g 0 0 0\n", rest, press, near - top, still, height - top
    }' >"$out/lid.txt" 2>"$out/schedule"
    . "$out/schedule"
    "$SCREE" run "$here/pour.yaml" -o "$out/pour" --overwrite --quiet --set "seed=${SEED:-1}" --set "duration=$end" \
        --set "box.upper=[4.5 mm, 4.5 mm, $ceiling]" --set "walls[1].radius=$column" --set "walls[2].point=[0, 0, $top]" --set "walls[2].motion=[{kind: table, file: $(cd "$out" && pwd)/lid.txt}]" \
        --set "particles.sources[0].region={shape: cylinder, centre: [0, 0, $middle], axis: [0, 0, 1], radius: $column, length: $length}" \
        --set "particles.sources[0].count=$poured"
    awk -v count="$beads" -v height="$height" -v floor=0.75e-3 -v slack=0.5e-3 -f "$here/cut.awk" "$out/pour/dump.lammpstrj" >"$out/cut.txt"
    "$SCREE" run "$here/close.yaml" -o "$out/close" --overwrite --quiet --set "walls[0].radius=$column" --set "box.upper=[4.5 mm, 4.5 mm, $height]" \
        --set "particles.sources[0].file=$(cd "$out" && pwd)/cut.txt" 2>"$out/close.notes" || { cat "$out/close.notes" >&2; exit 1; }
    awk '/^ITEM: TIMESTEP/ { n = reading = 0; next } /^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next } /^ITEM/ { reading = 0 }
        reading { line[++n] = $at["radius"] " " $at["x"] " " $at["y"] " " $at["z"] }
        END { for (k = 1; k <= n; k++) print line[k] }' "$out/close/dump.lammpstrj" >"$out/packing.txt"
}
