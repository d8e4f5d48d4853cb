# The points of a series, SHAPE-SIZES: aspect ratio, run-out, height
function value(key) { return match($0, "\"" key "\": ") ? substr($0, RSTART + RLENGTH) + 0 : 0 }
{
    split(series, part, "-")
    if (index($0, "\"shape\": \"" part[1] "\", \"sizes\": " part[2] ",")) print value("aspect"), value("run_out"), value("height")
}
