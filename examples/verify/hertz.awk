# An elastic Hertz contact from rows `time overlap force`: prints the largest overlap, the largest force, the duration.
# The times at which the overlap passes zero are interpolated.
{
    if ($2 > overlap) overlap = $2
    if ($3 > force) force = $3
    if (NR > 1 && last <= 0 && $2 > 0) begin = before - last * ($1 - before) / ($2 - last)
    if (NR > 1 && last > 0 && $2 <= 0) end = before - last * ($1 - before) / ($2 - last)
    last = $2
    before = $1
}
END { printf "%.12g %.12g %.12g\n", overlap, force, end - begin }
