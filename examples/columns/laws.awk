# The lines of columns beside the laws of the experiments: a line a series, and the last line. Exit status 1 if something is out of bounds.
# Run-out of the experiments, over the radius or length of the column, with aspect ratio a:
#   round, Lube et al., J. Fluid Mech. 508 (2004) 175: 1.24 a below 1.7, 1.6 a^(1/2) above; height 0.88 a^(1/6) above 1 (a below 0.7)
#   round, Lajeunesse et al., Phys. Fluids 16 (2004) 2371: a below 3, about 1.7 a^(1/2) above; height 0.74 above 0.74
#   plane, Lube et al., Phys. Rev. E 72 (2005) 041301: 1.2 a below 1.8, 1.9 a^(2/3) above 2.8
#   plane, Lajeunesse et al., Phys. Fluids 17 (2005) 103302: a below 3, about 1.4 a^(2/3) above; height a below 0.7, about 0.8 a^(1/3) above
# The bounds of a run-out are the two laws, 20 % more and less, and two diameters of a grain, as the columns are only ten grains wide. Exponents are fitted from a = 2 (round) and a = 3 on.
function value(key) { return match($0, "\"" key "\": ") ? substr($0, RSTART + RLENGTH) + 0 : 0 }
function word(key, rest) {
    if (!match($0, "\"" key "\": \"")) return ""
    rest = substr($0, RSTART + RLENGTH)
    sub(/".*/, "", rest)
    return rest
}
function lube(shape, a) { return shape == "round" ? (a < 1.7 ? 1.24 * a : 1.6 * sqrt(a)) : (a < 2.3 ? 1.2 * a : 1.9 * a ^ (2 / 3)) }
function lajeunesse(shape, a) { return a < 3 ? a : shape == "round" ? sqrt(3 * a) : (3 * a * a) ^ (1 / 3) }
{
    shape = word("shape")
    series = shape "-" value("sizes")
    if (!(series in seen)) order[++many] = series
    seen[series] = shape
    a = value("aspect")
    run_out = value("run_out")
    one = lube(shape, a)
    two = lajeunesse(shape, a)
    grain = 2 * value("grain")
    low = 0.8 * (one < two ? one : two) - grain
    high = 1.2 * (one > two ? one : two) + grain
    columns++
    of[series]++
    if (run_out < low || run_out > high) {
        far[series]++
        outside++
    }
    ratio[series] += run_out / ((one + two) / 2)
    if (a > (shape == "round" ? 1.9 : 2.8)) {
        n[series]++
        sx[series] += log(a)
        sy[series] += log(run_out)
        sxx[series] += log(a) ^ 2
        sxy[series] += log(a) * log(run_out)
    }
}
END {
    for (k = 1; k <= many; k++) {
        s = order[k]
        exponent = n[s] > 1 ? (n[s] * sxy[s] - sx[s] * sy[s]) / (n[s] * sxx[s] - sx[s] ^ 2) : 0
        law = seen[s] == "round" ? 0.5 : 0.667
        fits = n[s] < 2 || exponent > law - 0.15 && exponent < law + 0.15
        failed += !fits
        fitted = n[s] > 1 ? sprintf("%.3f", exponent) : "null"
        printf "{\"series\": \"%s\", \"columns\": %d, \"outside\": %d, \"mean_over_laws\": %.3f, \"exponent\": %s, \"law\": %.3f}\n", s, of[s], far[s],
            ratio[s] / of[s], fitted, law
    }
    passed = columns > 0 && !outside && !failed
    printf "{\"columns\": %d, \"outside\": %d, \"passed\": %s}\n", columns, outside, passed ? "true" : "false"
    exit !passed
}
