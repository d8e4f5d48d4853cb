# SPDX-License-Identifier: BSD-3-Clause
# From the lines of a packing and of the flows through it to the last line of run.sh: awk -v seconds=CORE_SECONDS -f summary.awk
# The flow at a given pressure drop, 1 / drop, is taken to differ by c h^2 from its limit; the limit follows from the two finest spacings,
# the observed order from the three finest.
function of(key,    value) {
    if (!match($0, "\"" key "\": ")) return ""
    value = substr($0, RSTART + RLENGTH)
    sub(/[,}].*/, "", value)
    return value + 0
}
# The order p for which (h1^p - h2^p) / (h2^p - h3^p) is what the flows say; 0: none
function order(a, b, c,    ratio, low, high, p, k) {
    if (flow[b] == flow[c]) return 0
    ratio = (flow[a] - flow[b]) / (flow[b] - flow[c])
    low = 0.05; high = 8
    if (ratio < quotient(a, b, c, low) || ratio > quotient(a, b, c, high)) return 0
    for (k = 0; k < 60; k++) {
        p = 0.5 * (low + high)
        if (quotient(a, b, c, p) < ratio) low = p
        else high = p
    }
    return p
}
function quotient(a, b, c, p) { return (h[a] ^ p - h[b] ^ p) / (h[b] ^ p - h[c] ^ p) }
function extrapolate(a, b) { return (h[a] ^ 2 - h[b] ^ 2) / (h[a] ^ 2 * flow[b] - h[b] ^ 2 * flow[a]) }
# Eisfeld and Schnitzlein, Chem. Eng. Sci. 56 (2001) 4321, spheres: K1 = 154, k1 = 1.15, k2 = 0.87
function eisfeld_schnitzlein(e, velocity,    viscosity, density, wall, inertia, near) {
    viscosity = 8.887e-4; density = 997.561
    wall = 1 + 2 / (3 * (column / diameter) * (1 - e))
    near = (1.15 * (diameter / column) ^ 2 + 0.87) ^ 2
    return height * (154 * wall ^ 2 * (1 - e) ^ 2 / e ^ 3 * viscosity * velocity / diameter ^ 2 + \
        wall / near * (1 - e) / e ^ 3 * density * velocity ^ 2 / diameter)
}
function list(values, form,    k, text) {
    for (k = 1; k <= n; k++) text = text (k > 1 ? ", " : "") sprintf(form, values[k])
    return text
}
/"beads"/ { beads = of("beads"); porosity = of("porosity"); diameter = of("diameter_um") * 1e-6; column = of("column_mm") * 1e-3; height = of("height_mm") * 1e-3 }
/"spacing_um"/ { h[++n] = of("spacing_um"); drop[n] = of("pressure_drop_pa"); flow[n] = 1 / drop[n]; rate = of("flow_kg_s"); k_found = of("permeability_m2") }
END {
    if (n == 0) exit 1
    velocity = rate / (997.561 * atan2(0, -1) * column ^ 2 / 4)
    es = eisfeld_schnitzlein(porosity, velocity)
    found = n > 1 ? extrapolate(n - 1, n) : drop[n]
    change = n > 2 ? found - extrapolate(n - 2, n - 1) : 0
    p = n > 2 ? order(n - 2, n - 1, n) : 0
    kozeny = porosity ^ 3 * diameter ^ 2 / (180 * (1 - porosity) ^ 2)
    k_limit = k_found * drop[n] / found
    printf "{\"beads\": %d, \"porosity\": %.5f, \"spacings_um\": [%s], \"pressure_drops_pa\": [%s], \"richardson_pa\": %.5g, \"eisfeld_schnitzlein_pa\": %.5g, " \
        "\"observed_order\": %s, \"core_seconds\": %.4g, \"richardson_change_pa\": %.3g, \"from_reference\": %.4f, \"permeability_m2\": %.5g, \"kozeny_carman_m2\": %.5g, \"reynolds\": %.4g}\n",
        beads, porosity, list(h, "%.5g"), list(drop, "%.5g"), found, es, (p > 0 ? sprintf("%.3g", p) : "null"), seconds, change, found / es - 1, k_limit, kozeny,
        997.561 * velocity * diameter / 8.887e-4
}
