#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A run has only the data that the scene needs: bytes of a particle, passes, fields in files and bytes between ranks, with one feature
# less at a time.

. "$(dirname "$0")/common.sh"
cd "$out" || exit 1
cat >scene.yaml <<'EOS'
units: none
box: {lower: [0, 0, 0], upper: [20, 20, 20], periodic: [true, true, false]}
gravity: [0, 0, -10]
step: {dt: 1e-4, count: 50}
contact: {law: hertz, rolling: spring}
materials: [{name: a, density: 1, young: 1e5, poisson: 0.3}, {name: b, density: 1, young: 1e5, poisson: 0.3}]
material_pairs: [{restitution: 0.5, friction: 0.5, rolling_friction: 0.1}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1], material: a, motion: [{kind: translate, velocity: [0, 0, 0.1]}]}]
groups: [{name: held, motion: frozen, select: {ids: [1]}}]
particles: {from: lattice, lattice: sc, spacing: 2, sizes: 1, count: 600, material: a}
EOS

smooth=(--set contact='{law: hertz, tangential: none}' --set 'material_pairs=[{restitution: 0.5}]')
wall_less=(--set 'walls=[]')
one_material=(--set 'materials=[{name: a, density: 1, young: 1e5, poisson: 0.3}]')
closed=(--set box.periodic=false)
free=(--set 'groups=[]')

needs() { # NAME FLAG...: what check says on two ranks, in NAME.txt
    local name=$1
    shift
    on "${ranks:-1}" "$scree" check --all scene.yaml "$@" >"$name.txt" 2>&1 || { cat "$name.txt"; return 1; }
}
stored() { sed -n 's/^  stored: \([0-9]*\) bytes.*/\1/p' "$1.txt"; }
field() { grep -q "^  $2  *[0-9][0-9]* " "$1.txt"; }
pass() { grep -q "^  $2  *[af][lo][wr]" "$1.txt"; }
less_by() { # NAME BYTES: each particle takes so many fewer than in the full scene
    local apart=$(($(stored full) - $(stored "$1")))
    [ "$apart" -ge "$2" ] || { echo "  $apart bytes less, not $2"; return 1; }
}
wire() { # NAME: bytes a copy when made, a copy and step, sent back, migrating
    sed -n 's/^bytes on the wire: \([0-9]*\) a copy when made, \([0-9]*\) a copy and step, \([0-9]*\) sent back, \([0-9]*\) a migrating.*/\1 \2 \3 \4/p' "$1.txt"
}

ranks=2
check 'the full scene' needs full
check 'without friction' needs smooth "${smooth[@]}"
check 'without walls' needs wall_less "${wall_less[@]}"
check 'of one material' needs one_material "${one_material[@]}"
check 'without periodic sides' needs closed "${closed[@]}"
check 'without groups' needs free "${free[@]}"

check 'spin and torque are stored with friction' eval 'field full angular_velocity && field full torque'
check 'and not without' eval '! field smooth angular_velocity && ! field smooth torque && less_by smooth 48'
check 'nor is there a history' eval 'holds smooth.txt "history: none" && ! holds full.txt "history: none"'
check 'no material number: a byte less at least' eval 'field full material && ! field one_material material && less_by one_material 1'
check 'no images' eval 'field full image && ! field closed image && less_by closed 12'
check 'no groups and densities' eval 'field full group && ! field free group && ! field free density && less_by free 9'
check 'no pass for walls' eval 'pass full wall && pass full walls && ! pass wall_less wall && ! pass wall_less walls'
fewer_sent() {
    local full smooth
    read -r -a full <<<"$(wire full)"
    read -r -a smooth <<<"$(wire smooth)"
    echo "  with friction ${full[*]}, without ${smooth[*]}"
    [ "${#full[@]}" = 4 ] && [ $((full[1] - smooth[1])) -ge 24 ] && [ $((full[2] - smooth[2])) -ge 24 ] && [ "${smooth[0]}" -lt "${full[0]}" ] && [ "${smooth[3]}" -lt "${full[3]}" ]
}
check 'less is sent without friction: 24 bytes a copy and step, 24 back' fewer_sent
check 'and without materials' eval '[ "$(wire one_material | cut -d " " -f 1)" -lt "$(wire full | cut -d " " -f 1)" ]'
measured() { # what was sent, of the reports
    run_scene 2 scene.yaml run_full --set step.count=50 && run_scene 2 scene.yaml run_smooth "${smooth[@]}" || return 1
    local full smooth
    full=$(sed -n 's/.*"bytes": \[\([0-9]*\),.*/\1/p' run_full/report.json)
    smooth=$(sed -n 's/.*"bytes": \[\([0-9]*\),.*/\1/p' run_smooth/report.json)
    echo "  rank 0 sent $full bytes, without friction $smooth"
    [ -n "$full" ] && [ "$smooth" -lt "$full" ]
}
check 'and the run did send less' measured
writes() { # what files hold: without friction no spins, torques and contact histories, of one material no numbers of it
    local output='output={trajectory: {every: 50}, checkpoint: {at_end: true}}'
    run_scene 1 scene.yaml wrote_full --set "$output" && run_scene 1 scene.yaml wrote_smooth --set "$output" "${smooth[@]}" &&
        run_scene 1 scene.yaml wrote_one --set "$output" "${one_material[@]}" && run_scene 1 scene.yaml wrote_free --set "$output" "${free[@]}" || return 1
    has wrote_full checkpoint-50.h5 angular_velocity && has wrote_full trajectory.h5 angular_velocity && has wrote_full checkpoint-50.h5 history &&
        ! has wrote_smooth checkpoint-50.h5 angular_velocity && ! has wrote_smooth trajectory.h5 angular_velocity && ! has wrote_smooth checkpoint-50.h5 torque &&
        has wrote_full checkpoint-50.h5 material && smaller wrote_smooth checkpoint-50.h5 $((600 * 24)) && smaller wrote_smooth trajectory.h5 $((600 * 24)) &&
        smaller wrote_one trajectory.h5 $((600 * 1)) && smaller wrote_free checkpoint-50.h5 $((600 * 1))
}
has() { grep -qaF "$3" "$1/$2"; }
smaller() { # DIR FILE BYTES: than that of the full scene
    local apart=$(($(stat -c %s "wrote_full/$2") - $(stat -c %s "$1/$2")))
    echo "  $1/$2 is $apart bytes smaller"
    [ $apart -ge "$3" ]
}
check 'files hold no more than the scene needs' writes
ranks=1
check 'one rank' needs alone
check 'exchanges nothing' eval '! grep -q "bytes on the wire" alone.txt && ! pass alone reverse && pass full reverse && grep -q "exchange of copies  *off" alone.txt'
cat >flat.yaml <<'EOS'
units: none
box: {dimension: 2, lower: [0, 0, 0], upper: [20, 20, 1]}
gravity: [0, -10, 0]
step: {dt: 1e-4, count: 200}
contact: {law: hooke, tangential: none}
materials: [{name: a, density: 1}]
material_pairs: [{restitution: 0.5, k_n: 1e4}]
particles: {from: random, count: 60, sizes: 0.7, velocity_sigma: 3}
output: {trajectory: {every: 200}}
observables: {every: 200, list: [{name: momentum}, {name: centre}]}
EOS
flat() { # nothing along z
    run_scene 1 flat.yaml flat && awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } END { exit !($at["momentum_z[1]"] == 0 && $at["centre_z[1]"] == 0.5) }' flat/observables.csv || { cat flat/observables.csv; return 1; }
}
check 'in two dimensions nothing moves along z' flat
leanest() { # position, velocity, radius, mass, force, id and class alone
    "$scree" check --all flat.yaml >flat.txt && [ "$(sed -n '/^fields/,/stored/p' flat.txt | grep -c '^  [a-z_]*  *[0-9][0-9]* ')" = 7 ] && holds flat.txt 'history: none'
}
check 'smooth discs of one material store seven fields' leanest
# In a control group that is full of files which the system keeps in memory, and in one that is full of data
group() { # FILES COMMAND...
    local files=$1
    shift
    unshare -rm bash -c 'mount -t tmpfs group /sys/fs/cgroup && cd /sys/fs/cgroup && echo 1000000000 >memory.max && echo 999999000 >memory.current &&
        printf "anon 1\nactive_file %d\ninactive_file %d\n" "$0" "$0" >memory.stat && cd "$OLDPWD" && exec "$@"' "$files" "$@"
}
if group 0 true 2>/dev/null; then
    check 'files that the system keeps are room for grains' eval 'group 400000000 "$scree" check scene.yaml >kept.txt 2>&1 || { cat kept.txt; false; }'
    check 'and other data are not' eval '! group 0 "$scree" check scene.yaml >kept.txt 2>&1 && holds kept.txt "GiB are free"'
else
    skip 'room in a control group: no mounts here'
fi
finish
