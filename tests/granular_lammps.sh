#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Laws with parts against LAMMPS's pair_style granular: forces and torques at the start within 1e-10 of the largest, positions
# after 300 steps within 1e-8 of the box; three sizes, every index, 1 and 3 ranks; and those at a wall, against fix wall/gran.
# tests/granular/laws and wall_laws have a line for each law, as LAMMPS reads it; `LMP=lmp` computes the references again instead of taking the stored ones. Torques of dmt are all 0: LAMMPS of 29
# Sep 2021 reads a number that it never set in the friction limit of dmt, so dmt runs without friction.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1
data=$top_srcdir/tests/granular
cp "$data/granular.data" "$data/in.granular" "$data/base.yaml" "$data/wall.data" "$data/in.wall" . || exit 1
# the end of contacts is left out
sed -e 's/end: overlap, //; s/granular.data/wall.data/; s/^box: .*/box: {periodic: [true, true, false]}/' \
    -e '$ a walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]' base.yaml >wall.yaml
scene=base.yaml input=in.granular

pair() { # KEY VALUE...: settings of the pair of materials
    while [ $# -gt 1 ]; do
        printf -- '--set material_pairs[0].%s=%s ' "$1" "$2"
        shift 2
    done
}

settings() { # LAW: what base.yaml changes to
    case $1 in
    hertz | wall_hertz) ;;
    jkr) echo "--set contact.cohesion.law=jkr --set contact.cohesion.end=force $(pair surface_energy 20)" ;;
    dmt) echo "--set contact.cohesion.law=dmt $(pair surface_energy 20 friction 0)" ;;
    mindlin_rescale) echo "--set contact.tangential=rescale" ;;
    rescale_force)
        echo "--set contact.tangential=rescale_force --set contact.damping=tsuji --set contact.tangential_damping_equal=true" \
            "--set materials[0].young=28800 --set materials[0].poisson=0.2 $(pair restitution 0.7 k_n '~' k_t '~' gamma_n '~' gamma_t '~')"
        ;;
    rolling_sds | wall_rolling) echo "--set contact.rolling=spring $(pair rolling_friction 0.3 rolling_stiffness 5000 rolling_damping 20)" ;;
    twisting_sds | wall_twisting)
        echo "--set contact.twisting=sds $(pair twisting_stiffness 300 twisting_damping 2 twisting_friction 0.05)"
        ;;
    twisting_marshall) echo "$(settings jkr) --set contact.twisting=marshall" ;;
    esac
}

split_steps() { # NAME: standard input into NAME0 and NAME300
    awk -v name="$1" '/^ITEM: TIMESTEP/ { getline step; file = name step; print >file; print step >file; next } { print >file }'
}

reference() { # LAW
    if [ -n "${LMP:-}" ]; then
        "$LMP" -in $input -var name "$1" -var law "$(sed -n "s/^$1 //p" "$data/laws" "$data/wall_laws")" >/dev/null && split_steps theirs <"$1.dump"
    else
        gzip -dc "$data/$1.dump.gz" | split_steps theirs
    fi
}

agrees() { # LAW RANKS SETTING...: force and torque at the start, place at the end
    local law=$1 ranks=$2 step
    shift 2
    rm -rf run ours0 ours300
    # shellcheck disable=SC2046
    run_scene "$ranks" $scene run $(settings "$law") "$@" || return 1
    split_steps ours <run/dump.lammpstrj
    for step in 0 300; do
        awk -f "$top_srcdir/examples/bidisperse/compare.awk" theirs$step ours$step | awk -v step=$step -v law="$law" '
            { print "  " $0; bad = NF != 8 || !(step == 0 ? $2 <= 1e-10 && (law == "dmt" || $4 <= 1e-10) : $6 <= 1e-8) }
            END { exit bad || NR != 1 }' || return 1
    done
}

while read -r law _; do
    reference "$law"
    for index in brute linkcell multi bytype hgrid; do
        check "$law on $index" agrees "$law" 1 --set index.name=$index </dev/null
    done
    check "$law on three ranks" agrees "$law" 3 </dev/null
    check "$law on three ranks, newton off, two threads" agrees "$law" 3 --set newton=off --set threads=2 </dev/null
done <"$data/laws"
for index in brute linkcell multi bytype; do
    reference twisting_marshall
    check "twisting_marshall on $index and three ranks" agrees twisting_marshall 3 --set index.name=$index </dev/null
done

scene=wall.yaml input=in.wall
while read -r law _; do
    reference "$law"
    check "$law" agrees "$law" 1 --set threads=2 </dev/null
    check "$law, three ranks" agrees "$law" 3 --set newton=off </dev/null
done <"$data/wall_laws"
scene=base.yaml input=in.granular

# A sheared box: forces at an offset at which many pairs touch across the sheared face, and 300 steps in which pairs come to touch
# across it. LAMMPS moves the box after the forces, so scree begins one step of shear, 0.0086, behind.
sheared() { # START BEHIND FORCE POSITION RANKS SETTING...: bounds of the two
    local start=$1 force=$3 position=$4 ranks=$5 offset tilt step
    offset=$(awk -v s="$1" -v b="$2" 'BEGIN { print s - b }')
    tilt=$(awk -v s="$1" 'BEGIN { print s + 0.0086 * 299 }')
    shift 5
    if [ -n "${LMP:-}" ]; then
        "$LMP" -in in.sheared -var name sheared -var start "$start" >/dev/null && split_steps theirs <sheared.dump
    else
        gzip -dc "$data/sheared_$start.dump.gz" | split_steps theirs
    fi
    rm -rf run ours0 ours300
    run_scene "$ranks" base.yaml run --set particles.sources[0].file=plain.data --set skin=0.2 --set guards.overlap=off --set "box.shear={rate: 5, profile: false, offset: $offset}" "$@" ||
        return 1
    split_steps ours <run/dump.lammpstrj
    for step in 0 300; do
        awk -f "$top_srcdir/examples/bidisperse/compare.awk" -v cube=8.6 -v tilt="$tilt" -v slip=43 theirs$step ours$step |
            awk -v step=$step -v force="$force" -v position="$position" '
            { print "  " $0; bad = NF != 8 || !(step == 0 ? $2 <= force && $4 <= force : $6 <= position) }
            END { exit bad || NR != 1 }' || return 1
    done
}

cp "$data/sheared.data" "$data/in.sheared" . && grep -v 'xy xz yz' sheared.data >plain.data || exit 1
for index in brute linkcell multi bytype hgrid; do
    check "sheared, forces at an offset, $index" sheared 2.5 0 1e-10 1 1 --set index.name=$index
    check "sheared, 300 steps, $index" sheared 0 0.0086 1e-10 1e-8 1 --set index.name=$index
done
check 'sheared, forces at an offset, three ranks' sheared 2.5 0 1e-10 1 3
check 'sheared, 300 steps, three ranks' sheared 0 0.0086 1e-10 1e-8 3 --set domain.y=3
check 'sheared, 300 steps, three ranks, newton off, two threads' sheared 0 0.0086 1e-10 1e-8 3 --set newton=off --set threads=2

different() { ! agrees "$@" >/dev/null 2>&1; } # the comparison can fail
reference jkr
slipped() { ! sheared 0 0.0087 1e-10 1e-8 1 >/dev/null 2>&1; }
check 'another offset is found out' slipped
check 'another surface energy is found out' different jkr 1 --set 'material_pairs[0].surface_energy=20.001'
finish
