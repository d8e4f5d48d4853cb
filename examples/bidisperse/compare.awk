# Compares two LAMMPS dumps of the same particles, reference first: awk -f compare.awk REFERENCE OURS
# The reference may be a sample of the particles: rows of others are then left out, with -v sample=1.
# Prints a line: largest difference of force, torque, position and velocity vectors, relative to the largest force, the largest
# torque, the box edge and the largest speed. Rows may come in any order; positions are compared by nearest images.
# Of a cube that is sheared along x: -v cube=EDGE -v tilt=OFFSET -v slip=VELOCITY, of the image one edge up y.
function fail(why) {
    print "compare: " why >"/dev/stderr"
    failed = 1
    exit 2
}
function column(name) {
    if (!(name in place))
        fail(FILENAME " has no column " name)
    return place[name]
}
function size(x, y, z) {
    return sqrt(x * x + y * y + z * z)
}
function turns(d) { # edges along y between two images, where images slide
    return tilt == "" ? 0 : d / edge > 0 ? int(d / edge + 0.5) : -int(0.5 - d / edge)
}
function nearest(d) {
    d -= edge * int(d / edge)
    return d > edge / 2 ? d - edge : d < -edge / 2 ? d + edge : d
}
function larger(kind, value) {
    if (!(kind in most) || value > most[kind] || value != value)
        most[kind] = value
}
FNR == 1 {
    files++
    reading = rows = 0
}
/^ITEM: BOX BOUNDS/ {
    getline
    edge = cube == "" ? $2 - $1 : cube
    next
}
/^ITEM: ATOMS/ {
    if (reading)
        fail(FILENAME " holds more than one step")
    split("", place)
    for (k = 3; k <= NF; k++)
        place[$k] = k - 2
    id = column("id")
    x = column("x"); y = column("y"); z = column("z")
    vx = column("vx"); vy = column("vy"); vz = column("vz")
    wx = column("omegax"); wy = column("omegay"); wz = column("omegaz")
    fx = column("fx"); fy = column("fy"); fz = column("fz")
    tx = column("tqx"); ty = column("tqy"); tz = column("tqz")
    reading = 1
    next
}
/^ITEM:/ {
    if (reading)
        fail(FILENAME " holds more than one step")
    next
}
reading && files == 1 {
    count++
    known[$id] = 1
    X[$id] = $x; Y[$id] = $y; Z[$id] = $z
    VX[$id] = $vx; VY[$id] = $vy; VZ[$id] = $vz
    FX[$id] = $fx; FY[$id] = $fy; FZ[$id] = $fz
    TX[$id] = $tx; TY[$id] = $ty; TZ[$id] = $tz
    larger("speed", size($vx, $vy, $vz))
    larger("force", size($fx, $fy, $fz))
    larger("torque", size($tx, $ty, $tz))
}
reading && files == 2 {
    i = $id
    if (!(i in known) && sample && !(i in X))
        next
    if (!(i in known))
        fail(FILENAME ": particle " i " is unknown or there twice")
    delete known[i]
    rows++
    turn = turns($y - Y[i])
    larger("dx", size(nearest($x - X[i] - turn * tilt), nearest($y - Y[i]), nearest($z - Z[i])))
    larger("dv", size($vx - VX[i] - turn * slip, $vy - VY[i], $vz - VZ[i]))
    larger("df", size($fx - FX[i], $fy - FY[i], $fz - FZ[i]))
    larger("dt", size($tx - TX[i], $ty - TY[i], $tz - TZ[i]))
}
END {
    if (failed)
        exit 2
    if (files != 2 || rows != count || count == 0) {
        print "compare: " rows " of " count " particles" >"/dev/stderr"
        exit 2
    }
    printf "force %.3g torque %.3g position %.3g velocity %.3g\n", most["df"] / most["force"], most["dt"] / most["torque"], \
        most["dx"] / edge, most["dv"] / most["speed"]
}
