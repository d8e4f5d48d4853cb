# LAMMPS's "damping tsuji" turns its argument into a damping factor by a polynomial that is not the one of Hertz contacts. Prints
# the argument for which the factor is that of Antypov and Elliott (2011) for the restitution e, by bisection:
# awk -v e=0.5 -f tsuji.awk
function polynomial(x) {
    return 1.2728 + x * (-4.2783 + x * (11.087 + x * (-22.348 + x * (27.467 + x * (-18.022 + x * 4.8218)))))
}
BEGIN {
    l = log(e)
    alpha = -l * sqrt(5) / sqrt(3.14159265358979324 ^ 2 + l * l)
    low = 0
    high = 1
    for (i = 0; i < 60; i++) {
        x = (low + high) / 2
        if (polynomial(x) > alpha)
            low = x
        else
            high = x
    }
    printf "%.11g\n", x
}
