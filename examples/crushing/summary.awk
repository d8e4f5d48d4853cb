# From curve.awk: the strength of the ball, and what broke
{
    if ($2 > peak) {
        peak = $2
        way = $1
    }
    whole = $3
    tension = $4
    shear = $5
    drift = $6
    if (NR == 1)
        all = $3
}
END {
    printf "largest force %.4g N at %.4g mm; bonds %d: whole %d, broken by tension %d, by shear %d; drift of energy %.2g of the work\n",
        peak, way, all, whole, tension, shear, drift
}
