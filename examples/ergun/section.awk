# SPDX-License-Identifier: BSD-3-Clause
# Tables from the lines of run.sh: awk -f section.awk RESULTS
# With two lattices or more, 1 / friction of the two finest is taken to differ by c h^2 from its limit at the same force.
function of(key,    value) {
    if (!match($0, "\"" key "\": ")) return ""
    value = substr($0, RSTART + RLENGTH)
    sub(/[,}].*/, "", value)
    return value + 0
}
function ergun(re) { return 150 + 1.75 * re / solid }
function eisfeld(re) { return 154 + re / (0.87 ^ 2 * solid) } # no walls
# Beetstra, van der Hoef, Kuipers, AIChE J. 53 (2007) 489: drag over that of a sphere alone, 3 pi mu d U
function beetstra(re,    e, drag) {
    e = 1 - solid
    drag = 10 * solid / e ^ 2 + e ^ 2 * (1 + 1.5 * sqrt(solid))
    if (re > 0)
        drag += 0.413 * re / (24 * e ^ 2) * (1 / e + 3 * solid * e + 8.4 * re ^ -0.343) / (1 + 10 ^ (3 * solid) * re ^ (-(1 + 4 * solid) / 2))
    return 18 * e ^ 2 * drag / solid
}
function limit(a, b, x, y) { return (a ^ 2 * y - b ^ 2 * x) / (a ^ 2 - b ^ 2) } # of values x at spacing a and y at b < a
BEGIN { solid = 0.58 }
/"friction"/ {
    p = of("packing"); t = of("target"); h = 1 / of("spacings_a_diameter")
    if (!((p, t) in fine)) { if (!(t in seen)) { seen[t] = ++targets; target[targets] = t } }
    else { coarse_h[p, t] = fine[p, t]; coarse_f[p, t] = friction[p, t]; coarse_r[p, t] = reynolds[p, t] }
    fine[p, t] = h; friction[p, t] = of("friction"); reynolds[p, t] = of("reynolds")
    packings = p > packings ? p : packings
    change = of("change"); change = change < 0 ? -change : change; worst = change > worst ? change : worst
    per[sprintf("%.1f", 1 / h)] = 1
}
END {
    print "\n## From Darcy to Forchheimer\n"
    print "[examples/ergun](../examples/ergun/README.md), `run.sh`: scree packs 32 spheres at random in a periodic cube, 58 % of its volume, and a fluid flows through them, slowly and with inertia. The friction"
    print "factor is force d^2 porosity^3 / (viscosity U (1 - porosity)^2), the Reynolds number U d / nu with the superficial velocity U.\n"
    print "| Reynolds number | friction factor | packings | at the finest lattice | Ergun | Eisfeld and Schnitzlein | Beetstra et al. | over slow flow | Ergun | Eisfeld and Schnitzlein | Beetstra et al. |"
    print "|---|---|---|---|---|---|---|---|---|---|---|"
    for (k = 1; k <= targets; k++) {
        t = target[k]; n = sum = square = at_re = finest = 0
        for (p = 1; p <= packings; p++) {
            if (!((p, t) in fine)) continue
            f = (p, t) in coarse_h ? 1 / limit(coarse_h[p, t], fine[p, t], 1 / coarse_f[p, t], 1 / friction[p, t]) : friction[p, t]
            at_re += (p, t) in coarse_h ? limit(coarse_h[p, t], fine[p, t], coarse_r[p, t], reynolds[p, t]) : reynolds[p, t]
            n++; sum += f; square += f * f; finest += friction[p, t]
        }
        mean = sum / n
        error = n > 1 ? sqrt((square / n - mean ^ 2 > 0 ? square / n - mean ^ 2 : 0) / (n - 1)) : 0
        re = at_re / n
        if (t == 0) slow = mean
        printf "| %.3g | %.1f%s | %d | %.1f | %.1f | %.1f | %.1f | %.3f | %.3f | %.3f | %.3f |\n", re, mean, (n > 1 ? sprintf(" +- %.1f", error) : ""), n, finest / n, ergun(re), eisfeld(re), beetstra(re), mean / slow, \
            ergun(re) / ergun(0), eisfeld(re) / eisfeld(0), beetstra(re) / beetstra(0)
    }
    printf "\nThe friction factor is extrapolated from lattices of"
    for (one in per) { lattices++; list[lattices] = one + 0 }
    for (a = 1; a <= lattices; a++) for (b = a + 1; b <= lattices; b++) if (list[b] < list[a]) { swap = list[a]; list[a] = list[b]; list[b] = swap }
    for (a = 1; a <= lattices; a++) printf " %.1f%s", list[a], a == lattices ? "" : a == lattices - 1 ? " and" : ","
    print " spacings a diameter; its error is the standard error of the mean over packings. In the last fifth of a march the velocity changed"
    printf "by %.1g at most. Ergun: 150 + 1.75 Re / (1 - porosity); Eisfeld and Schnitzlein far from walls: 154 + 1.32 Re / (1 - porosity); Kozeny and Carman: 180; Beetstra, van der Hoef and Kuipers, AIChE J. 53\n", worst
    print "(2007) 489: fitted to lattice Boltzmann simulations of packings like these. An ordered packing: Zick and Homsy's simple cubic array of spheres that touch, 47.6 % porosity, has 156.5."
    print "\nWith advection by plain central differences flows ended at 10: in narrow throats they grew without bound, with any time step from 2e-4 to 5e-6 d^2/nu."
    print "Advection that makes no kinetic energy, with some diffusion beside grains ([fluid-method.md](fluid-method.md#advection)), marches to a steady flow at 30 and 100 with 6.5 spacings a diameter, too, but its friction factor is 210"
    print "to 216 at 30. At 10.4 spacings a diameter and 100 the largest velocity times the spacing is 117 kinematic viscosities: the throats are coarse."
}
