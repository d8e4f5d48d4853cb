#!/usr/bin/env bash
# The system may grant fewer threads than there are cores or than are asked for: all work is done all the same, or the
# program says so.
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
finish
