# Sourced by the benchmarks (sh, after ../common.sh): what a run of either code tells about itself.

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

# quietly COMMAND ...: its output is shown only if it fails
quietly() {
    "$@" >"$work/output" 2>&1 || {
        cat "$work/output" >&2
        return 1
    }
}

# best FILE: what follows the five figures on the line with the smallest loop time
best() {
    sort -g "$1" | head -n 1 | cut -d ' ' -f 6-
}

# median COLUMN FILE
median() {
    cut -d ' ' -f "$1" "$2" | sort -g | awk '{ v[NR] = $1 } END { print NR % 2 ? v[(NR + 1) / 2] : (v[NR / 2] + v[NR / 2 + 1]) / 2 }'
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

# lammps_unless_skipped SCRIPT: sets lammps, and with_lammps (empty with SKIP_LAMMPS=1, which is said); ends the script if it is missing
lammps_unless_skipped() {
    lammps=${LAMMPS:-lmp}
    with_lammps=yes
    if [ -n "${SKIP_LAMMPS:-}" ]; then
        with_lammps=
        echo "$1: LAMMPS is left out, as SKIP_LAMMPS asks" >&2
    else
        command -v "$lammps" >/dev/null || { echo "no $lammps here: apt-get install lammps, or SKIP_LAMMPS=1" >&2; exit 1; }
    fi
}
