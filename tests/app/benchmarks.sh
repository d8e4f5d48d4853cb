#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The published benchmarks: the page is what its rows say, the judges tell good curves from bad ones, a case runs, stops and goes on;
# LAMMPS's own examples have LAMMPS's forces, and a gas has the energies of Yade.
set -u
. "$top_srcdir/tests/app/common.sh"
case $scree in /*) ;; *) scree=$PWD/$scree ;; esac
dosta=$top_srcdir/examples/dosta2024
cd "$out" || exit 1

mkdir -p docs
check 'docs/benchmarks.md is what page.sh draws from the rows' eval 'sh "$dosta/page.sh" docs && { ! command -v gnuplot >/dev/null || cmp docs/benchmarks.md "$top_srcdir/docs/benchmarks.md"; }'

# judge CASE COUNT PROGRAM: the verdict on o.csv
printf '10 1 2 1e6 5e-6\nabc 5e-7 a cpu\n' >costs
judge() { awk -F, -v name="$1" -v count="$2" -v step=published -v costs=costs -v folder="$dosta/curves" -f "$dosta/curves.awk" -f "$dosta/$3.awk" o.csv; }
# theirs CASE CODE HEAD FACTOR: a curve of another code, times a factor, as if it were a run of this one
theirs() { { echo "$3"; grep -v '^[#t]' "$dosta/curves/$1-$2.csv" | awk -F, -v OFS=, -v f="$4" '{ for (k = 2; k <= NF; k++) $k *= f } 1'; } >o.csv; }
codes_pass() {
    local code
    for code in musen liggghts peclet; do
        theirs impact25 $code 'time[s],ball_z[m]' 1 && judge impact25 25000 impact >verdict || { cat verdict; return 1; }
        theirs silo-large-m1 $code 'time[s],left[1]' 1 && judge silo-large-m1 100000 silo >verdict || { cat verdict; return 1; }
        theirs drum $code 'time[s],m1_upper[1],m2_upper[1],m1_lower[1],m2_lower[1]' 1 && judge drum 38000 drum >verdict || { cat verdict; return 1; }
    done
}
others_fail() {
    theirs impact25 musen 'time[s],ball_z[m]' 1.05 && ! judge impact25 25000 impact >verdict &&
        theirs silo-large-m1 musen 'time[s],left[1]' 1.1 && ! judge silo-large-m1 100000 silo >verdict &&
        theirs drum musen 'time[s],m1_upper[1],m2_upper[1],m1_lower[1],m2_lower[1]' 1.2 && ! judge drum 38000 drum >verdict
}
check 'the other codes pass beside each other' codes_pass
check 'curves that are off by 5, 10 and 20 % fail' others_fail
row() {
    theirs silo-large-m1 musen 'time[s],left[1]' 1 && judge silo-large-m1 100000 silo |
        awk -v short= -v load=0.1 -v when=2026-01 -f "$dosta/row.awk" | awk -F'\t' '{ print } NF != 12 || $2 != "scree" || $9 != 2e6 || $10 != 24188.7 { exit 1 }'
}
check 'a verdict becomes a row' row
seeds() { # two runs of an impact: their mean, its spread, the row; a run of which a part was not timed has no seconds in its row
    {
        theirs impact25 musen 'time[s],ball_z[m]' 1 && judge impact25 25000 impact
        theirs impact25 musen 'time[s],ball_z[m]' 1.001 && judge impact25 25000 impact
    } >verdicts
    awk -f "$dosta/seeds.awk" verdicts | awk -v short= -v load=0.1 -v when=2026-01 -f "$dosta/row.awk" |
        awk -F'\t' '{ print } NF != 12 || $3 !~ /, mean of 2 seeds$/ || $7 != 10 || $8 != 1 || $10 != "-0.13809+-0.00010" { exit 1 }' >said &&
        printf '10 1 2 1e6 2e-5\nabc 5e-7 a cpu\n' >costs &&
        judge impact25 25000 impact | awk -v short= -v load=0.1 -v when=2026-01 -f "$dosta/row.awk" | awk -F'\t' '{ print } $8 != "-" { exit 1 }' >>said || { cat verdicts said; return 1; }
}
check 'so do those of several seeds' seeds

case_of() { # TIME STEPS [TIMED]: a tiny run of impact25; a verdict that did not pass is no failure here
    DURATION=$1 SCREE=$scree SCREE_ARGS='--quiet --set threads=1' "$dosta/run.sh" impact25 "$out/impact" >lines 2>said
    [ $? = 1 ] && tail -n 1 lines | grep -qE '"case": "impact25", "particles": 25001, "steps": '"$2"', "seconds": [0-9.e-]+, "cores": 1, "updates_per_core_second": [0-9.e+]+, '"${3:-}"'"result": [-0-9.]+, "reference": [-0-9.]+, .*"passed": false}$' ||
        { cat said lines; return 1; }
}
check 'a case runs, and its last line has what others read' case_of 1e-5 20
check 'one that is done is not run again' case_of 1e-5 20
check 'the same command goes on from there' case_of 2e-5 40
rm impact/run/segments # as if the machine had died before the script could note the steps and their seconds
check 'a run that was killed goes on from its checkpoint, and says what was timed' case_of 3e-5 20 '"timed": 0.333, '
wrong() { "$dosta/run.sh" "$@" >said 2>&1; [ $? = 2 ] && grep -q '^usage: run.sh CASE' said; }
check 'a case that is not there is refused, with the names' eval 'wrong impact26 && wrong impact25 --step long && wrong'

soft_ball() { "$dosta/run.sh" impact25 --step soft "$out/soft" >said 2>&1; [ $? = 2 ] && grep -q 'silos and the drum' said && [ ! -e "$out/soft" ]; }
check 'an impact of soft beads is refused' soft_ball

lammps() { SCREE=$scree SCREE_RANKS=$1 SCREE_ARGS=$2 "$top_srcdir/examples/lammps/check" "$out/lammps" >lines 2>said || { cat said lines; return 1; }; }
check "LAMMPS's examples: its forces and places" lammps 1 '--set threads=2'
check 'so on three ranks, newton off' lammps 3 '--set threads=1 --set newton=off'
others_differ() { ! lammps 1 '--set material_pairs[0].k_n=2000.1' >/dev/null; }
check 'another stiffness is found out' others_differ
# columns: a small one that has no time to fall makes a line and fails; columns on the laws pass, those that run out by half as much again fail
small_column() {
    SCREE=$scree SERIES=plane ASPECTS=0.5 SCREE_ARGS='--set stages[settle].duration=1e-3 --set stages[collapse].duration=1e-3' \
        "$top_srcdir/examples/columns/run.sh" --quick "$out/columns" >lines 2>said
    [ $? = 1 ] && [ "$(grep -cE '^\{"shape": "plane", "sizes": 1, "grains": [1-9][0-9]*, "aspect": 0\.[45][0-9]*, "run_out": [-0-9.]+, "height": 0\.[45][0-9]*, ' lines)" = 1 ] &&
        tail -n 1 lines | grep -q '"columns": 1, "outside": 1, "passed": false' || { cat lines said; return 1; }
}
laws() { # FACTOR
    for a in 0.5 1 2 4 8; do
        awk -v a=$a -v f="$1" 'BEGIN {
            printf "{\"shape\": \"round\", \"sizes\": 1, \"aspect\": %g, \"run_out\": %g}\n", a, f * (a < 1.7 ? 1.24 * a : 1.6 * sqrt(a))
            printf "{\"shape\": \"plane\", \"sizes\": 10, \"aspect\": %g, \"run_out\": %g}\n", a, f * (a < 2.3 ? 1.2 * a : 1.9 * a ^ (2 / 3)) }'
    done | awk -f "$top_srcdir/examples/columns/laws.awk" >said
}
check 'a column makes a line, and one that has not fallen fails' small_column
check 'columns that follow the laws pass' laws 1
others_run() { ! laws 1.5; }
check 'columns that run out by half as much again fail' others_run
check "Yade's gas: its energies" env SCREE="$scree" YADE=none "$top_srcdir/examples/yade/run.sh" "$out/yade"
other_gas() { ! SCREE=$scree YADE=none SCREE_ARGS='--set material_pairs[0].restitution=0.82' "$top_srcdir/examples/yade/run.sh" "$out/yade" >said 2>&1; }
check 'another restitution is found out' other_gas
finish
