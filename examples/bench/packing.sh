# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the benchmarks of packings (sh, with `here` set to this folder): makes packings, runs packing.yaml on them.

. "$here/bench.sh"
export OMP_WAIT_POLICY=passive LC_ALL=C

# memory_for BYTES: does this machine have so much free?
memory_for() {
    awk -v need="$1" '/^MemAvailable:/ { exit !($2 * 1024 >= need) }' /proc/meminfo
}

# sizes DATA: the volume of the box, then a line a bin of sizes: smallest and largest radius, particles
sizes() {
    awk '/ [xyz]lo [xyz]hi/ { volume = (volume ? volume : 1) * ($2 - $1) }
        /^Atoms/ { atoms = 1; next }
        /^Velocities/ { exit }
        atoms && NF >= 7 {
            r = $3 / 2
            bin = int(1024 + 46 * log(r))
            if (!count[bin]++) low[bin] = high[bin] = r
            if (r < low[bin]) low[bin] = r
            if (r > high[bin]) high[bin] = r
        }
        END {
            printf "%.17g\n", volume
            for (bin = 0; bin < 2048; bin++) if (count[bin]) printf "%.17g %.17g %d\n", low[bin], high[bin], count[bin]
        }' "$1"
}

# packed LAW KEY=VALUE...: a packing, made unless it is there. Sets packing (path without .h5, .data, .sizes) and particles
packed() {
    packing=$work/$(echo "$*" | tr -c 'A-Za-z0-9.\n' '-')
    if [ ! -s "$packing.sizes" ]; then
        law=$1
        shift
        "$SCREE" pack "$law" "$packing.data" "$packing.h5" --overwrite threads="$cores" "$@" >"$packing.log" || exit 1
        sizes "$packing.data" >"$packing.sizes.part"
        mv "$packing.sizes.part" "$packing.sizes"
    fi
    particles=$(awk 'NR > 1 { n += $3 } END { print n }' "$packing.sizes")
}

# cuts LEVELS MARGIN SIZES: radii between levels of equal occupancy, particles x (2 r_max + margin)^3, as a list of YAML;
# fewer where the bins do not allow so many
cuts() {
    awk -v levels="$1" -v margin="$2" '
        function fill(m, k, have, need) { # levels from the largest down, each filled to m; returns how many
            found = 0
            for (k = n; k > 0;) {
                found++
                need = m / (2 * high[k] + margin) ^ 3
                for (have = 0; k > 0 && have < need; k--) have += count[k]
                edge[found] = k > 0 ? (high[k] + low[k + 1]) / 2 : 0
            }
            return found
        }
        NR > 1 { n++; low[n] = $1; high[n] = $2; count[n] = $3 }
        END {
            a = -60
            b = 90
            for (i = 0; i < 60; i++) {
                m = (a + b) / 2
                if (fill(exp(m)) > levels) a = m
                else b = m
            }
            fill(exp(b))
            for (k = found - 1; k > 0; k--) printf "%s%.9g", k < found - 1 ? ", " : "", edge[k]
        }' "$3"
}

# one_class, or classes cut at radii: the setting for `classes`
classes_at() {
    if [ -n "$1" ]; then echo "classes={method: cuts, cuts: [$1]}"; else echo "classes={method: one}"; fi
}

# packing_run KEY=VALUE...: runs the packing into WORK/run with these settings, on `ranks` ranks (1)
packing_run() {
    for setting; do
        shift
        set -- "$@" --set "$setting"
    done
    if [ -s "$packing.h5" ]; then
        set -- --set particles.file="$packing.h5" "$@"
    else
        set -- --set particles.file="$packing.data" --set particles.format=lammps-data "$@"
    fi
    quietly on_ranks "${ranks:-1}" "$SCREE" run "$here/packing.yaml" -o "$work/run" --overwrite --quiet "$@"
}

# report KEY: a number of the last run's report
report() {
    report_number "$work/run" "$1"
}

# stages NAME...: seconds of these stages in the last run, added up
stages() {
    report_stages "$work/run" "$@"
}
rebuild_stages="migrate reorder ghosts index pairs history"

# calc EXPRESSION
calc() {
    awk "BEGIN { printf \"%.9g\", ($1) }"
}

# value KEY LINE: a number or a word of a line of JSON
value() {
    echo "$2" | sed -n 's/.*"'"$1"'": "\{0,1\}\([^",}]*\).*/\1/p'
}
