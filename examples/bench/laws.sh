#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What laws of contacts, their parts, and what grains have beside contacts cost: laws.sh [--quick] [NAME...]
#
# The spheres of laws.yaml touch up to twelve others each. A line of JSON a setting: contacts, and the median of REPEAT (5) runs, which take
# turns, of ns a contact and step; `ratio` to Hertz's law. With valgrind and COUNT=1, the instructions of a contact and step, which other
# load on the machine does not change: runs of 1 step and of STEPS more are compared. All with one thread.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/bench.sh"
quick=no
[ "${1:-}" != --quick ] || { quick=yes && shift; }
export OMP_NUM_THREADS=1 OMP_WAIT_POLICY=passive LC_ALL=C
repeat=${REPEAT:-$([ $quick = yes ] && echo 1 || echo 5)}
steps=${STEPS:-$([ $quick = yes ] && echo 10 || echo 100)}
edge=$([ $quick = yes ] && echo 15 || echo 40)
out=$work/laws
mkdir -p "$out"

pair='restitution: 0.5, friction: 0.5'
turning='rolling_friction: 0.1'
settings=(
    "hertz|"
    "hooke|contact.law=hooke materials=[{name: m, density: 1}] material_pairs=[{$pair, k_n: 1e5}]"
    "no friction|contact.tangential=none material_pairs=[{restitution: 0.5}]"
    "rescale|contact.tangential=rescale"
    "force|contact.tangential=force"
    "viscous|contact.tangential=viscous"
    "rolling spring|contact.rolling=spring material_pairs=[{$pair, $turning}]"
    "rolling epsd|contact.rolling=epsd material_pairs=[{$pair, $turning}]"
    "rolling constant|contact.rolling=constant material_pairs=[{$pair, $turning}]"
    "twisting marshall|contact.twisting=marshall"
    "dmt|contact.cohesion=dmt material_pairs=[{$pair, surface_energy: 10}]"
    "jkr|contact.cohesion=jkr material_pairs=[{$pair, surface_energy: 10}]"
    "sjkr|contact.cohesion=sjkr material_pairs=[{$pair, cohesion_density: 100}]"
    "capillary|contact.cohesion=capillary material_pairs=[{$pair, surface_tension: 10, contact_angle: 0.1, bridge_fraction: 0.01}]"
    "van der Waals|contact.cohesion=van_der_waals material_pairs=[{$pair, hamaker: 1, gap_least: 0.01, cut_off: 0.1}]"
    "luding|contact.law=luding materials=[{name: m, density: 1}] material_pairs=[{friction: 0.5, restitution: 0.5, k_n: 1e5, k_2: 3e5, k_c: 1e4, plasticity_depth: 0.05}]"
    "thornton|contact.law=thornton material_pairs=[{$pair, yield_pressure: 1e5}]"
    "eepa|contact.law=eepa material_pairs=[{$pair, plasticity_ratio: 0.5, adhesion_energy: 1}]"
    "heat|heat={temperature: 300, materials: [{material: m, conductivity: 1, capacity: 1}]}"
    "drag stokes|drag={law: stokes, fluid: {density: 0.1, viscosity: 0.1}}"
    "drag and porosity|drag={law: di_felice, fluid: {density: 0.1, viscosity: 0.1}, porosity: {support: 5}}"
    "bonds|bonds={when: start, gap: 0, laws: [{modulus: 1e6, stiffness_ratio: 2, radius: 0.5}]}"
)
awk -v edge="$edge" 'BEGIN {
    side = 1.98 / sqrt(2)
    for (i = 0; (x = 1 + i * side) <= edge - 1; i++)
        for (j = 0; (y = 1 + j * side) <= edge - 1; j++)
            for (k = (i + j) % 2; (z = 1 + k * side) <= edge - 1; k += 2)
                printf "%.9g %.9g %.9g 1\n", x, y, z
}' >"$out/lattice.txt"
# run NAME STEPS SETTING: into OUT/NAME; with COUNTED under callgrind, and prints the instructions
run() {
    local name=$1 count=$2 with=() flags=() word
    [ -z "${COUNTED:-}" ] || with=(valgrind --tool=callgrind --callgrind-out-file=/dev/null)
    while IFS= read -r word; do [ -z "$word" ] || flags+=(--set "$word"); done < <(echo "$3" | sed -E 's/ ([a-z_.]+=)/\n\1/g')
    "${with[@]}" "$SCREE" run "$here/laws.yaml" -o "$out/run" --overwrite --quiet --set threads=1 --set step.count="$count" \
        --set "box.upper=[$edge, $edge, $edge]" --set "particles.sources[0].file='$out/lattice.txt'" \
        "${flags[@]}" >"$out/$name.log" 2>&1 || {
        echo "$name does not run:" >&2
        cat "$out/$name.log" >&2
        return 1
    }
    [ -z "${COUNTED:-}" ] || sed -n 's/.*Collected : \([0-9]*\).*/\1/p' "$out/$name.log"
}
wanted() { # NAME ASKED...
    local name=$1 one
    shift
    [ $# != 0 ] && [ "$name" != hertz ] || return 0
    for one; do [ "$one" != "$name" ] || return 0; done
    return 1
}
names=()
for setting in "${settings[@]}"; do
    wanted "${setting%%|*}" "$@" || continue
    names+=("$setting")
    : >"$out/${setting%%|*}.rows"
done
for ((r = 0; r < repeat; r++)); do
    for setting in "${names[@]}"; do
        name=${setting%%|*}
        run "$name" "$steps" "${setting#*|}" || exit 1
        echo "$(report_number "$out/run" seconds) $(report_number "$out/run" contacts)" >>"$out/$name.rows"
    done
done
hertz= hertz_counted=
for setting in "${names[@]}"; do
    name=${setting%%|*}
    contacts=$(tail -n 1 "$out/$name.rows" | cut -d ' ' -f 2)
    ns=$(awk -v s="$(median 1 "$out/$name.rows")" -v n="$contacts" -v steps="$steps" 'BEGIN { printf "%.4g", 1e9 * s / steps / n }')
    counted=null
    if [ -n "${COUNT:-}" ]; then
        one=$(COUNTED=1 run "$name" 1 "${setting#*|}")
        more=$(COUNTED=1 run "$name" 11 "${setting#*|}")
        counted=$(awk -v d=$((more - one)) -v n="$contacts" 'BEGIN { printf "%.4g", d / 10 / n }')
    fi
    hertz=${hertz:-$ns} hertz_counted=${hertz_counted:-$counted}
    printf '{"setting": "%s", "contacts": %d, "ns": %s, "ratio": %s, "instructions": %s, "instructions_ratio": %s}\n' "$name" "$contacts" "$ns" \
        "$(awk -v a="$ns" -v b="$hertz" 'BEGIN { printf "%.3g", a / b }')" "$counted" \
        "$(awk -v a="$counted" -v b="$hertz_counted" 'BEGIN { if (b + 0 > 0) printf "%.3g", a / b; else printf "null" }')"
done
