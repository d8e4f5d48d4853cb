# From the grains of last.awk: Bond number, slope in degrees, grains above the floor. The slope is that of the triangle over the floor, 20 mm
# long, with the cross section of the heap: the sum over strips of 1 mm of the top of the highest grain. Variable: number.
$2 < 20 && $3 > 0 {
    strip = int($2)
    if (!(strip in top) || $3 + $4 > top[strip])
        top[strip] = $3 + $4
    grains++
}
END {
    for (k = 0; k < 20; k++)
        area += top[k]
    printf "%s\t%.2f\t%d\n", number, 180 / atan2(0, -1) * atan2(2 * area, 20 * 20), grains
}
