# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the checks of single impacts: what scree and the independent integration (impact.c) make of them.
tool impact

# frame RUN first|last: id type radius mass x y z vx vy vz wx wy wz, by id
frame() {
    awk -v which="$2" '/^ITEM: ATOMS/ { n = 0; reading = 1; frames++; next } /^ITEM:/ { reading = 0; next }
        reading && (which == "last" || frames == 1) { n++; $14 = ""; line[n] = ""
            for (k = 1; k <= 13; k++) line[n] = line[n] $k " "; most = n }
        END { for (k = 1; k <= most; k++) print line[k] }' "$out/$1/dump.lammpstrj" | sort -n
}

# impacts RUN TYPE plane|pairs LAW E1 NU1 E2 NU2 E MU: the impacts of the particles of a material (number TYPE) along z, in the
# plane y = 0, spins about y. A line for each: vx vz w (before) of both bodies, the same after by impact.c, the same after by
# scree, then impact.c's overlap, force and duration. With pairs the particles 2 k - 1 (above) and 2 k meet.
impacts() {
    name=$1
    kind=$2-$3
    frame "$1" first | awk -v type="$2" '$2 == type' >"$out/before"
    frame "$1" last | awk -v type="$2" '$2 == type' >"$out/after"
    paired=$3
    shift 3
    for state in before after; do
        awk -v paired="$paired" '{ mine = $8 " " $10 " " (-$12); size = $3 " " $4 }
            paired == "plane" { print size " 0 0 " mine " 0 0 0"; next }
            NR % 2 { upper = mine; sizes = size; next }
            { print sizes " " size " " upper " " mine }' "$out/$state" >"$out/$state.rows"
    done
    # shellcheck disable=SC2046
    cut -d ' ' -f 5- "$out/before.rows" | "$out/impact" "$@" $(head -n 1 "$out/before.rows" | cut -d ' ' -f 1-4) >"$out/ode.rows"
    paste -d ' ' "$out/before.rows" "$out/ode.rows" "$out/after.rows" |
        awk '{ for (k = 5; k <= 16; k++) printf "%s ", $k; for (k = 24; k <= 29; k++) printf "%s ", $k; print $17, $18, $19 }'
}
