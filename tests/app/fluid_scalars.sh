#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Scalars and an electrolyte that a fluid carries, in a run: the same on all ranks, threads and indexes, and after a resume; scenes that make
# no sense. The closed forms are cases of examples/verify (fluid-taylor-aris, fluid-electroosmosis).
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

# Scalars: nothing of one is lost, one that is the same everywhere stays so, one is given by the grain; the same on other ranks and indexes, and
# after a resume
cat >dye.yaml <<'YAML'
units: none
box: {lower: [-1, 0, 2], upper: [0, 1, 3], periodic: true}
particles: {from: single, position: [-0.9, 0.1, 2.05], radius: 0.31, density: 1, group: bed}
groups: [{name: bed, motion: frozen}]
fluid:
  spacing: 0.1
  density: 1
  viscosity: 1
  drive: {body_force: [100, 0, 0]}
  solver: {tolerance: 1e-9}
  scalars:
    - {name: dye, diffusivity: 0.05, initial: {value: 1, region: {shape: box, lower: [-1, 0, 2], upper: [-0.5, 1, 3]}}}
    - {diffusivity: 0, initial: 1}
    - {diffusivity: 0.2, advection: upwind, given: [{group: bed, value: 1}]}
step: {dt: 0.01, count: 4}
observables: {every: 1, list: [{name: scalar}]}
output: {checkpoint: {every: 2}, dump: {every: 4, fields: [id, scalar_1, scalar_2, scalar_3]}}
YAML

needs_petsc dye.yaml 'fluid'

dyes() { # DIR: id and scalars of the last frame
    awk '/^ITEM: TIMESTEP/ { n = 0 } !/^ITEM/ && NF == 5 { line[++n] = $1 " " $3 " " $4 " " $5 } END { for (k = 1; k <= n; k++) print line[k] }' "$1/dump.lammpstrj" | sort -n
}
dyed() {
    run_scene 1 dye.yaml one --set threads=1 && dyes one >one.frame && awk '
        $3 != 0 { n++; d = $3 - 1; d = d < 0 ? -d : d; if (d > gap) gap = d; if ($2 > least) moved = 1; if ($4 < -1e-12 || $4 > 1 + 1e-12) beyond++; sum += $4 }
        END { printf "  %d particles; 1 stays to %.1e; the grain has given %.3g\n", n, gap, sum; exit !(n > 700 && gap < 1e-8 && sum > 10 && !beyond) }' one.frame &&
        awk -F, 'NR == 2 { first = $2 } NR > 1 { last = $2; flux = $3 } END { printf "  %.12g of %.12g left, flux %g\n", last, first, flux; d = last / first - 1
            exit !(first > 0.4 && d * d < 1e-20 && flux > 0.1) }' one/observables.csv
}
rm -rf one
check "scalars: conserved, constant, and bounded" dyed
dyed_on() { # RANKS THREADS FLAG...
    local ranks=$1 threads=$2
    shift 2
    rm -rf other
    run_scene "$ranks" dye.yaml other --set threads="$threads" "$@" && dyes other >other.frame && paste -d ' ' one.frame other.frame | awk '
        { for (k = 1; k <= 4; k++) { d = $k - $(k + 4); d = d < 0 ? -d : d; if (!(d <= gap)) gap = d } } END { printf "  %d particles, apart by %.1e\n", NR, gap; exit !(NR > 700 && gap < 1e-7) }'
}
check "scalars on 2 ranks x 2 threads" dyed_on 2 2
check "scalars on 4 ranks, hgrid" dyed_on 4 1 --set index=hgrid
dye_resumes() {
    rm -rf other
    run_scene 1 dye.yaml other --set threads=1 --resume one/checkpoint-2.h5 && dyes other | cmp - one.frame
}
check "scalars: a resume gives the same bits" dye_resumes
check "scalars in particles that move" scene_refused 'fluid.scalars|fixed' dye.yaml --set fluid.motion=lagrangian
sed 's/group: bed, value: 1/value: 1/' dye.yaml >nowhere.yaml
check "a scalar given nowhere" scene_refused 'nowhere.yaml:14|fluid.scalars[2].given[0]|one of wall, group and side' nowhere.yaml
check "a scalar given at a side that is not open" scene_refused 'fluid.scalars[2].given[0].side|x_lower is no open side' dye.yaml --set 'fluid.scalars[2].given=[{side: x_lower, value: 1}]'
check "a scalar given twice" scene_refused 'fluid.scalars[2].given[1]|twice' dye.yaml --set 'fluid.scalars[2].given=[{group: bed, value: 1}, {group: bed, value: 2}]'
check "a scalar given at grains that no fluid stands around" scene_refused 'fluid.scalars[2].given[0].group|frozen' dye.yaml --set 'fluid.scalars[2].given=[{group: free, value: 1}]'
check "a scalar without diffusivity" scene_refused 'fluid.scalars[0].diffusivity|missing' dye.yaml --set 'fluid.scalars=[{name: dye}]'
# An electrolyte: charged grain and walls, a field that drives the flow; the same on other ranks (of the velocity as far as the steady solver goes)
cat >ions.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [1, 1, 0], periodic: [true, false, false], dimension: 2}
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]}, {name: ceiling, shape: plane, point: [0, 1, 0], normal: [0, -1, 0]}]
particles: {from: single, position: [0.5, 0.5, 0], radius: 0.2, density: 1, group: bed}
groups: [{name: bed, motion: frozen}]
fluid:
  spacing: 0.04166666666666667
  density: 1
  viscosity: 1
  equations: stokes
  time: steady
  solver: {tolerance: 1e-8}
  electrolyte:
    permittivity: 2
    debye_length: 0.2
    thermal_voltage: 0.5
    field: [1, 0, 0]
    surfaces: [{wall: floor, charge: 30}, {wall: ceiling, zeta: 4, period: 1}, {group: bed, zeta: -1}]
step: {count: 1}
observables: {every: 1, list: [{name: fluid_velocity, components: x}, {name: fluid_charge}]}
output: {checkpoint: {at_end: false}, dump: {every: 1, fields: [id, velocity, potential, charge_density, electric_field]}}
YAML
charged() { # frame: id type v E potential charge; a potential of 8 thermal voltages wants damped steps
    run_scene 1 ions.yaml one --set threads=1 || return 1
    awk '/^ITEM/ { n = 0 } !/^ITEM/ && NF == 10 { line[++n] = $0 } END { for (k = 1; k <= n; k++) print line[k] }' one/dump.lammpstrj | sort -n >one.frame
    awk '$9 != 0 { n++; if ($9 > most) most = $9; if ($9 < least) least = $9; e += $6; u += $3 } END { printf "  %d particles, potential %g ... %g, field %g, velocity %g\n", n, least, most, e / n, u / n
        exit !(n > 400 && most > 2 && least < -2 && e / n > 0.8 && e / n < 1.2 && u * u > 1e-6) }' one.frame
}
rm -rf one
check "an electrolyte between charged walls, around a charged grain" charged
charged_on() { # RANKS THREADS FLAG...
    local ranks=$1 threads=$2
    shift 2
    rm -rf other
    run_scene "$ranks" ions.yaml other --set threads="$threads" "$@" &&
        awk '/^ITEM/ { n = 0 } !/^ITEM/ && NF == 10 { line[++n] = $0 } END { for (k = 1; k <= n; k++) print line[k] }' other/dump.lammpstrj | sort -n | paste -d ' ' one.frame - | awk '
        { for (k = 1; k <= 10; k++) { d = $k - $(k + 10); d = d < 0 ? -d : d; bound = k == 3 || k == 4 ? 2e-3 : k == 10 ? 1e-7 : 1e-8; if (!(d <= bound)) bad++; if (k > 4 && !(d <= gap)) gap = d } }
        END { printf "  %d particles, apart by %.1e\n", NR, gap; exit bad > 0 || NR < 500 }'
}
check "an electrolyte on 2 ranks x 2 threads" charged_on 2 2
check "an electrolyte on 4 ranks, hgrid" charged_on 4 1 --set index=hgrid
# An insulating disc in an array, 0.4 of the plane, at a place on the lattice where counting is bad: mean field times porosity, by Rayleigh's series 0.42535
cat >array.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [1, 1, 0], periodic: [true, true, false], dimension: 2}
particles: {from: single, position: [0.503, 0.521, 0], radius: 0.3568248, density: 1, group: bed}
groups: [{name: bed, motion: frozen}]
fluid:
  spacing: 0.03125
  density: 1
  viscosity: 1
  equations: stokes
  time: steady
  electrolyte: {permittivity: 2, debye_length: 0.2, thermal_voltage: 0.5, field: [1, 0, 0], surfaces: [{group: bed, zeta: 0.1}]}
step: {count: 1}
output: {checkpoint: {at_end: false}, dump: {every: 1, fields: [id, electric_field]}}
YAML
insulated() {
    rm -rf array
    run_scene 1 array.yaml array --set threads=1 && awk '/^ITEM: ATOMS/ { sum = count = 0; for (k = 3; k <= NF; k++) at[$k] = k - 2; next } /^ITEM/ || NF < 4 { next }
        $at["efieldx"] != 0 { sum += $at["efieldx"]; count++ }
        END { e = 0.6 * sum / count; printf "  %d particles, %.5f\n", count, e; exit !(count > 500 && e > 0.42535 * 0.98 && e < 0.42535 * 1.02) }' array/dump.lammpstrj
}
check "a field through an array of insulating discs" insulated
check "a surface with potential and charge" scene_refused 'fluid.electrolyte.surfaces[0]|one of zeta and charge, not both' ions.yaml --set 'fluid.electrolyte.surfaces=[{wall: floor, zeta: 1, charge: 1}]'
check "a charged surface that is none" scene_refused 'fluid.electrolyte.surfaces[0]|one of wall, group and side' ions.yaml --set 'fluid.electrolyte.surfaces=[{zeta: 1}]'
grep -v debye_length ions.yaml >uncertain.yaml
check "an electrolyte without Debye length" scene_refused 'uncertain.yaml:13|fluid.electrolyte.debye_length|missing' uncertain.yaml
check "a given flow of an electrolyte" scene_refused 'fluid.drive.mass_flow|electrolyte' ions.yaml --set fluid.drive.mass_flow=1
check "an electrolyte in particles that move" scene_refused 'fluid.motion' ions.yaml --set fluid.motion=lagrangian

check "a dump of a scalar that is not there" scene_refused 'scalar_1|no such field' ions.yaml --set 'output.dump.fields=[id, scalar_1]'

rolls() {
    SCREE=$scree "$top_srcdir/examples/electroosmosis/check" "$PWD/rolls"
}
check "the example of electroosmosis: rolls that mix" rolls

finish
