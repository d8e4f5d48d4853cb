#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The system may grant fewer threads than the machine has cores, or fewer than the user wants: the program does all work
# nevertheless, or reports the failure.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

cat >gas.yaml <<'EOF'
units: none
box: {lower: [0, 0, 0], upper: [12, 12, 12], periodic: true}
step: {dt: 1e-3, count: 200}
contact: {law: hooke, tangential: none}
materials: [{name: stone, density: 1}]
material_pairs: [{restitution: 1, k_n: 1000}]
particles: {sources: [{from: random, count: 300, sizes: 0.5, velocity_sigma: 1}]}
observables: {every: 200, list: [{name: energy_kinetic}, {name: contacts}]}
EOF
last() { tail -n 1 "$1/observables.csv"; }

run_scene 1 gas.yaml one --set threads=1
OMP_NUM_THREADS=2 run_scene 1 gas.yaml two
check 'two threads by default' [ "$(number two/report.json threads)" = 2 ]
shared_out() { # RANKS THREADS
    (unset OMP_NUM_THREADS && run_scene "$1" gas.yaml "shared$1") && [ "$(number "shared$1/report.json" threads)" = "$2" ]
}
cores=$(env -u OMP_NUM_THREADS nproc)
check 'all cores where nobody says how many' shared_out 1 "$cores"
check 'ranks of one machine share them' shared_out "$cores" 1
check 'and have one thread each where there are more ranks than cores' shared_out $((cores + 1)) 1
# granted DIR THREADS: what the default comes to
granted() {
    [ "$(number "$1/report.json" threads)" = "$2" ] || { echo "  $(number "$1/report.json" threads) threads"; return 1; }
    within "$(last "$1" | cut -d , -f 2)" "$(last one | cut -d , -f 2)" 1e-9 && [ "$(last "$1" | cut -d , -f 3)" = "$(last one | cut -d , -f 3)" ]
}
OMP_NUM_THREADS=4 OMP_THREAD_LIMIT=3 run_scene 1 gas.yaml limited
check 'three granted of four: three do the work of four' granted limited 3
OMP_NUM_THREADS=2 OMP_DYNAMIC=true run_scene 1 gas.yaml dynamic
check 'nobody takes threads away: two are two' granted dynamic 2
refused() {
    OMP_THREAD_LIMIT=1 "$scree" run gas.yaml -o refused --set threads=2 >said 2>&1
    [ $? = 2 ] && holds said 'threads: 2 asked for'
}
check 'more asked for than granted is refused' refused
refused_to_pack() {
    OMP_THREAD_LIMIT=1 "$scree" pack power refused.data count=50 fraction=0.1 threads=2 >said 2>&1
    [ $? = 2 ] && holds said 'threads: 2 asked for'
}
check 'so by scree pack' refused_to_pack

# On cores that other programs use: a busy loop on each of two
cat >bed.yaml <<'EOF2'
units: none
box: {lower: [0, 0, 0], upper: [12, 12, 12], periodic: [true, true, false]}
gravity: [0, 0, -1]
step: {dt: 1e-3, count: 4000}
contact: {law: hooke, tangential: none}
materials: [{name: stone, density: 1}]
material_pairs: [{restitution: 0.9, k_n: 1000}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]
particles: {sources: [{from: random, count: 300, sizes: 0.5, velocity_sigma: 1}]}
observables: {every: 100, list: [{name: energy_kinetic}, {name: contacts}]}
output: {checkpoint: {at_end: true}}
EOF2
unset OMP_WAIT_POLICY
allowed=$(taskset -cp $$ | sed 's/.*: //')
read -r -a two < <(echo "$allowed" | tr ',' '\n' | awk -F - '{ for (c = $1; c <= (NF > 1 ? $2 : $1); c++) print c }' | head -n 2 | tr '\n' ' ')
loops=()
for core in "${two[@]}"; do
    taskset -c "$core" bash -c 'while :; do :; done' &
    loops+=($!)
done
trap 'kill "${loops[@]}" 2>/dev/null; rm -rf "$out"' EXIT
# crowded DIR FLAG...: on these cores; what it says goes to DIR.said
crowded() {
    local dir=$1
    shift
    OMP_NUM_THREADS=2 timeout "$limit" taskset -c "$(IFS=,; echo "${two[*]}")" "$scree" run bed.yaml -o "$dir" --overwrite "$@" >/dev/null 2>"$dir.said"
}
quickest() {
    printf '%s\n' "$@" | sort -g | head -n 1
}
default=() single=()
for turn in 1 2 3; do
    crowded crowded && default+=("$(number crowded/report.json seconds)")
    crowded single --set threads=1 && single+=("$(number single/report.json seconds)")
done
crowded fixed --set threads=2 --set step.count=400
# how long they take depends on what else runs here: told, not judged
echo "seconds of the default: ${default[*]}; of one thread: ${single[*]}; the quickest $(quickest "${default[@]}") and $(quickest "${single[@]}")"
check 'runs on busy cores end' [ "${#default[@]}" = 3 ]
warned() {
    [ "$(grep -c 'other programs use the cores (load .* on .* cores)' crowded.said)" = 1 ]
}
check 'and says once that they are busy' warned
working() {
    awk -v a="$(number crowded/report.json threads_working)" 'BEGIN { exit !(a >= 1 && a < 2) }' && [ "$(number crowded/report.json threads)" = 2 ]
}
check 'two threads do not work all the time' working
check 'all of a number that the scene names' [ "$(number fixed/report.json threads_working)" = 2 ]
kill "${loops[@]}"
# all that a checkpoint holds but the scene, which names the threads
bits() {
    contents "$1/checkpoint-4000.h5" | grep -vE '^/scene |^/runs/' | awk '{ print } END { exit NR < 10 }'
}
same_bits() {
    OMP_WAIT_POLICY=passive run_scene 1 bed.yaml all --set threads=2 && cmp all/observables.csv crowded/observables.csv &&
        bits all >all.txt && bits crowded >crowded.txt && cmp all.txt crowded.txt
}
check 'the same bits as with both at work all the time' same_bits
finish
