# From observables.csv: way of the plate (mm), its force (N), bonds whole, broken by tension, by shear, drift of the balance of energies
# over the work of the plate
NR == 1 {
    for (k = 1; k <= NF; k++) {
        sub(/\[.*/, "", $k)
        at[$k] = k
    }
    next
}
{
    if (NR == 2)
        start = $at["energy_balance"]
    work = $at["work_walls"]
    drift = work == 0 ? 0 : ($at["energy_balance"] - start) / work
    print 200 * $at["time"], $at["plate_fz"], $at["bonds_whole"], $at["bonds_broken_tension"], $at["bonds_broken_shear"], drift
}
