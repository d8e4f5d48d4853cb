#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Makes the states and dumps of this folder by LAMMPS from its own inputs: make.sh [DIR]
# Needs Debian's packages lammps and lammps-examples; LMP (lmp) is the program, EXAMPLES the folder of the inputs. Each input runs to a state, with
# fewer steps than it has; the state is then read again, so that both codes begin without slip history, and runs for 100 steps.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
out=${1:-$here/out-make}
examples=${EXAMPLES:-/usr/share/lammps/examples}
lmp=${LMP:-lmp}

# part MODE GRAVITY FILE: the input up to its first run: before the state, or after it with the state in place of what makes grains
part() {
    awk -v mode="$1" -v gravity="$2" '
        /^run[ \t]/ { exit }
        /&[ \t]*$/ { sub(/&[ \t]*$/, ""); held = held $0; next }
        { $0 = held $0; held = "" }
        mode == "after" && /^create_box/ { print "read_data state.data"; next }
        mode == "after" && /^(fix[ \t]+ins|change_box|create_atoms|delete_atoms|set[ \t]|velocity|lattice|thermo|compute_modify)/ { next }
        !gravity && /gravity/ { next }
        { print }' "$3"
}
# state NAME INPUT STEPS
state() {
    mkdir -p "$out/$1"
    cd "$out/$1"
    { part before 1 "$examples/$2"; printf 'run %s\nwrite_data state.data\n' "$3"; } >in.before
    "$lmp" -in in.before -log before.log >/dev/null
    for step in 0 100; do
        { part after $step "$examples/$2"
          echo "dump cmp all custom 100 dump.$step id radius x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz"
          printf 'dump_modify cmp sort id format float %%.13g\nrun %s\n' $step; } >in.after
        "$lmp" -in in.after -log after.log >/dev/null
        awk -v step=$step '/^ITEM: TIMESTEP/ { getline now; on = now == step; if (on) { print; print now }; next } on' dump.$step | gzip -9nc >"$here/$1-$step.dump.gz"
    done
    grep -v 'xy xz yz' state.data | gzip -9nc >"$here/$1.data.gz"
    cd "$here"
}
state pour pour/in.pour 8000
state pour.2d pour/in.pour.2d 10000
state granular multi/in.granular 1500
rm -f "$here/granular-100.dump.gz" # its barostat has no like here
