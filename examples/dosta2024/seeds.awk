# The last line of a case: the verdict of one run; or of several, with means of steps, seconds and results, and the spread of these
# The standard deviation of n values
function deviation(sum, squares, v) {
    v = (squares - sum * sum / n) / (n - 1)
    return v > 0 ? sqrt(v) : 0
}
function number(key, at) {
    if (!match($0, "\"" key "\": [-+.0-9e]+")) return 0
    return substr($0, RSTART + length(key) + 4, RLENGTH - length(key) - 4) + 0
}
{
    n++
    x = number("result")
    sum += x
    squares += x * x
    ends += number("end")
    end_squares += number("end") ^ 2
    seconds += number("seconds")
    steps += number("steps")
    speed += number("updates_per_core_second") * number("seconds")
    passed += /"passed": true/
    last = $0
}
END {
    if (!n) exit 1
    if (n > 1) {
        sub(/"steps": [^,]*/, sprintf("\"steps\": %d", steps / n), last)
        sub(/"seconds": [^,]*/, sprintf("\"seconds\": %.6g", seconds / n), last)
        sub(/"updates_per_core_second": [^,]*/, sprintf("\"updates_per_core_second\": %.4g", speed / seconds), last)
        sub(/"result": [^,]*/, sprintf("\"result\": %.5f", sum / n), last)
        sub(/"deepest_at.*"step"/, sprintf("\"seeds\": %d, \"spread\": %.5f, \"end\": %.5f, \"end_spread\": %.5f, \"seeds_passed\": %d, \"step\"", n, deviation(sum, squares),
            ends / n, deviation(ends, end_squares), passed), last)
        sub(/"passed": [a-z]*/, "\"passed\": " (2 * passed > n ? "true" : "false"), last)
    }
    print last
    exit last !~ /"passed": true/
}
