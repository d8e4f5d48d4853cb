# SPDX-License-Identifier: BSD-3-Clause
# Sourced by run.sh. pour: beads fall into the column, a lid presses them to the height of the column, and DIR/packing.txt gets their places.
#
# The beads begin at random places, 28 % of the space, and fall into the column; when they are at rest the lid falls to 0.6 mm above its last place, and
# sinks from there with 3 cm/s. What is above is pushed in; friction lets the packing be as loose as it is.

pour() {
    awk -v n="$beads" -v r=0.25e-3 -v column="$column" -v height="$height" 'BEGIN {
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
        --set "particles.sources[0].count=$beads"
    awk '/^ITEM: TIMESTEP/ { n = reading = 0; next } /^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next } /^ITEM/ { reading = 0 }
        reading { line[++n] = $at["radius"] " " $at["x"] " " $at["y"] " " $at["z"] }
        END { for (k = 1; k <= n; k++) print line[k] }' "$out/pour/dump.lammpstrj" >"$out/packing.txt"
}
