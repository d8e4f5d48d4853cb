# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the benchmarks (sh, with `here` set to this folder): how they are called and where they work; what a run of either
# code tells about itself.

. "$here/../common.sh"
cores=${CORES:-$(env -u OMP_NUM_THREADS nproc)}
work=${WORK:-${TMPDIR:-/tmp}/scree-bench}
mkdir -p "$work"

# wrong_call: says how the script is called, and ends it
wrong_call() {
    echo "usage: $usage" >&2
    exit 2
}

# quick_after COUNT USAGE ARGUMENT...: there are COUNT arguments, then --quick or no more, which sets quick (yes or empty); else the
# script ends with its usage
quick_after() {
    usage=$2
    test $# -ge $(($1 + 2)) || wrong_call
    shift $(($1 + 2))
    quick=
    test "${1:-}" != --quick || quick=yes
    test $# = 0 || test -n "$quick" || wrong_call
}

# by_mode QUICK FULL: one of the two
by_mode() {
    if [ -n "$quick" ]; then echo "$1"; else echo "$2"; fi
}

# built VARIABLE VALUE PROGRAM: the value if it has one, else this program of the folder where scree was built; ends the script if
# it is not there
built() {
    program=${2:-$(dirname "$SCREE")/$3}
    command -v "$program" || { echo "no $program here: make $3, or set $1" >&2; exit 1; }
}

# lammps_figures LOG STEPS: loop seconds, Neigh seconds, rebuilds, pairs, kinetic energy after STEPS (thermo_style custom step ke)
lammps_figures() {
    awk -v steps="$2" '
        /^Loop time/ { loop = $4 }
        /^Neigh *\|/ { split($0, part, "|"); neigh = part[3] + 0 }
        /^Neighbor list builds/ { builds = $5 }
        /^Total # of neighbors/ { pairs = $6 }
        $1 == steps && NF == 2 { energy = $2 }
        END { print loop, neigh, builds, pairs, energy; exit !(loop > 0) }' "$1"
}

# scree_figures DIR OBSERVABLE: loop seconds, seconds of all that a rebuild does, rebuilds, pairs, the last value of the observable
scree_figures() {
    awk -F, -v name="$2" 'NR == 1 { for (k = 1; k <= NF; k++) if (index($k, name "[") == 1) at = k } END { print $at; exit !at }' \
        "$1/observables.csv" >"$1/last"
    tr -d ' \n' <"$1/report.json" | awk -v last="$(cat "$1/last")" '
        function value(text) {
            if (!match($0, "\"" text "\":[-+.0-9e]+")) {
                print "report.json has no " text >"/dev/stderr"
                exit failed = 1
            }
            return substr($0, RSTART + length(text) + 3, RLENGTH - length(text) - 3) + 0
        }
        {
            stages = split("migrate reorder ghosts index pairs history", name, " ")
            for (k = 1; k <= stages; k++)
                if (match($0, "\"" name[k] "\":{[^}]*}")) {
                    stage = substr($0, RSTART, RLENGTH)
                    sub(/.*"mean":/, "", stage)
                    rebuild += stage + 0
                }
            print value("seconds"), rebuild, value("rebuilds"), value("pairs"), last
        }
        END { exit failed }'
}

# report_stages DIR STAGE...: seconds of these stages of a run, the mean of its ranks, added up
report_stages() {
    stages_of=$1
    shift
    tr -d ' \n' <"$stages_of/report.json" | awk -v names="$*" '{
        n = split(names, name, " ")
        for (k = 1; k <= n; k++)
            if (match($0, "\"" name[k] "\":{\"min\":[^}]*}")) {
                stage = substr($0, RSTART, RLENGTH)
                sub(/.*"mean":/, "", stage)
                sum += stage
            }
        printf "%.9g", sum }'
}

# quietly COMMAND ...: its output is shown only if it fails
quietly() {
    "$@" >"$work/output" 2>&1 || {
        cat "$work/output" >&2
        return 1
    }
}

# try FILE WORDS COMMAND...: the five figures that the command prints, and the words, as a line of FILE; one that fails is told, and left out
try() {
    tried=$1 words=$2
    shift 2
    if figures=$("$@") && [ "$(echo "$figures" | wc -w)" -eq 5 ]; then
        echo "$figures $words" >>"$tried"
    else
        echo "a trial failed and is left out: $*" >&2
    fi
}

# best FILE: what follows the five figures on the line with the smallest loop time; fails if no trial succeeded
best() {
    test -s "$1" || { echo "all trials failed: $(basename "$1")" >&2; return 1; }
    sort -g "$1" | head -n 1 | cut -d ' ' -f 6-
}

# table1_system R: edge of the cube, large and small spheres of Table 1 of Stratford, Shire and Hanley, in `table`; false if it has no such R
table1_system() {
    case $1 in
    10) table="205.9 250 711657" ;;
    20) table="314.15 111 2337678" ;;
    40) table="500.14 56 9624306" ;;
    80) table="793.92 28 42900051" ;;
    100) table="955.61 25 66193461" ;;
    *) return 1 ;;
    esac
}

# table1_cube EDGE: keys of a packing as dense as `table`, in a cube of this edge
table1_cube() {
    echo "$table" | awk -v edge="$1" '{
        part = (edge / $1) ^ 3
        printf "box=%g large=%d small=%d", edge, part * $2 + 0.5, part * $3 + 0.5 }'
}

# quick_edge R: of the cube for --quick, max(4 R, 80)
quick_edge() {
    echo $((4 * $1 > 80 ? 4 * $1 : 80))
}

# find_lammps [HINT]: sets lammps; ends the script if it is missing
find_lammps() {
    lammps=${LAMMPS:-lmp}
    command -v "$lammps" >/dev/null || { echo "no $lammps here: apt-get install lammps${1:-}" >&2; exit 1; }
}

# lammps_unless_skipped SCRIPT: find_lammps, and with_lammps, which is empty with SKIP_LAMMPS=1; that is said
lammps_unless_skipped() {
    with_lammps=
    if [ -n "${SKIP_LAMMPS:-}" ]; then
        echo "$1: LAMMPS is left out, as SKIP_LAMMPS asks" >&2
    else
        find_lammps ", or SKIP_LAMMPS=1"
        with_lammps=yes
    fi
}
