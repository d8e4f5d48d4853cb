# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the tests that compare forces between layouts: the last frame of a dump, the bound of rounding, momentum.
# CASE-first is the reference run of a case; the observables of this run hold momentum first, and overlap_max.

# last_frame DIR: the dump's last step alone
last_frame() {
    local first
    first=$(grep -n '^ITEM: TIMESTEP' "$1/dump.lammpstrj" | tail -n 1 | cut -d : -f 1)
    tail -n "+$first" "$1/dump.lammpstrj" >"$1/last"
}

# bound_of CASE EDGE: max(1e-12, 8 eps EDGE / the largest overlap at the end)
bound_of() {
    awk -F, -v edge="$2" 'NR == 1 { for (k = 1; k <= NF; k++) if ($k ~ /^overlap_max/) column = k }
        END { bound = 8 * 2.2e-16 * edge / $column; if (bound < 1e-12) bound = 1e-12
            printf "%.3g", bound }' "$1-first/observables.csv"
}

# momentum_kept DIR: the last row's momentum is the first one's
momentum_kept() {
    awk -F, 'NR == 2 { for (k = 2; k <= 4; k++) first[k] = $k }
        END { for (k = 2; k <= 4; k++) { d = $k - first[k]; if (!(d < 1e-9 && d > -1e-9)) bad = 1 }
            if (bad || NR < 3) print "  momentum changed"; exit bad || NR < 3 }' "$1/observables.csv"
}

# same_forces CASE DIR EDGE KEY...: the counts of the report are those of CASE-first, the forces agree within the bound
same_forces() {
    local case=$1 dir=$2 edge=$3 key force
    shift 3
    last_frame "$dir"
    for key in "$@"; do
        [ "$(number "$case-first/report.json" "$key")" = "$(number "$dir/report.json" "$key")" ] ||
            { echo "  $key: $(number "$case-first/report.json" "$key") and $(number "$dir/report.json" "$key")"; return 1; }
    done
    force=$(awk -f "$top_srcdir/examples/bidisperse/compare.awk" "$case-first/last" "$dir/last") || return 1
    within "$(echo "$force" | awk '{ print $2 }')" 0 "$(bound_of "$case" "$edge")"
}
