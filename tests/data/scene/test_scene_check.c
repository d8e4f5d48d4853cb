/* SPDX-License-Identifier: BSD-3-Clause */
/* Bad scenes: each is refused with its place, its key, and what is allowed. */
#include "tests/scene_by_hand.h"

/* Lines behind GOOD_SCENE, which has seven. */
struct bad_text {
    const char *lines;
    const char *place, *says[3];
};

static const struct bad_text texts[] = {
    {"gravty: [0, 0, 0]\n", "case/scene.yaml:8: ", {"unknown key 'gravty'", "'gravity'"}},
    {"index:\n  nam: hgrid\n", "case/scene.yaml:9: ", {"unknown key 'index.nam'", "'index.name'"}},
    {"dt: 1e-6\n", "case/scene.yaml:8: ", {"unknown key 'dt'", "'step.dt'"}},
    {"gravity: [0, 0, 0]\n", "case/scene.yaml:8: ", {"'gravity' is given twice", "case/scene.yaml:2"}},
    {"threads: many\n", "case/scene.yaml:8: threads: ", {"'many' is not a whole number", "from 0 to 255"}},
    {"threads: 2.5\n", "case/scene.yaml:8: threads: ", {"not a whole number"}},
    {"threads: -1\n", "case/scene.yaml:8: threads: ", {"out of range"}},
    {"threads:\n", "case/scene.yaml:8: threads: ", {"no value is given", "a whole number"}},
    {"threads: [1, 2]\n", "case/scene.yaml:8: threads: ", {"a list stands here"}},
    {"newton: maybe\n", "case/scene.yaml:8: newton: ", {"neither true nor false", "on, off"}},
    {"step: {dt: 5 mm}\n", "case/scene.yaml:8: step.dt: ", {"'mm' is not a unit of time", "in s"}},
    {"step: {dt: 5 parsec}\n",
     "case/scene.yaml:8: step.dt: ",
     {"'parsec' is not a unit; those of time: s sec day min h; allowed"}},
    {"step: {dt: 0}\n", "case/scene.yaml:8: step.dt: ", {"out of range", "> 0"}},
    {"step: {dt: .inf}\n", "case/scene.yaml:8: step.dt: ", {"out of range"}},
    {"step: 3\n", "case/scene.yaml:8: step: ", {"must be a section"}},
    {"step:\n  dt: 1e-6\n  fraction: 0.3\n", "case/scene.yaml:10: step.fraction: ", {"beside step.dt"}},
    {"integrator: euler\n", "case/scene.yaml:8: integrator: ", {"'euler' is unknown", "velocity_verlet"}},
    {"index: octree\n",
     "case/scene.yaml:8: index.name: ",
     {"'octree' is unknown", "brute, linkcell, multi, bytype, hgrid"}},
    {"index: {name: brute, levels: 3}\n",
     "case/scene.yaml:8: index.levels: ",
     {"exists only with name=hgrid"}},
    {"sync: gossip\n", "case/scene.yaml:8: sync: ", {"'gossip' is unknown", "neighbours"}},
    {"newton: off\nghosts: reduced\n", "case/scene.yaml:9: ghosts: ", {"reduced needs newton: on"}},
    {"walls: {shape: plane}\n", "case/scene.yaml:8: walls: ", {"must be a list of sections"}},
    {"walls:\n  - plane\n", "case/scene.yaml:9: walls[0]: ", {"must be a section"}},
    {"walls:\n  - {shape: plane, normal: [0, 0, 1]}\n",
     "case/scene.yaml:9: walls[0].point: ",
     {"is missing", "three numbers"}},
    {"walls:\n  - {shape: plane, point: [0, 0, 0], normal: [0, 0, 0]}\n",
     "case/scene.yaml:9: walls[0].normal: ",
     {"has no direction"}},
    {"walls:\n  - {shape: plane, point: [0, 0, 0], normal: [0, 0, 1], radius: 3}\n",
     "case/scene.yaml:9: walls[0].radius: ",
     {"exists only with shape=cylinder"}},
    {"walls:\n  - {shape: pyramid}\n",
     "case/scene.yaml:9: walls[0].shape: ",
     {"'pyramid' is unknown", "plane, cylinder, mesh"}},
    {"walls:\n  - {shape: plane, point: [0, 0, 0], normal: [0, 0, 1], material: wood}\n",
     "case/scene.yaml:9: walls[0].material: ",
     {"'wood' is not one of the materials", "known: glass"}},
    {"walls:\n  - {shape: plane, point: [0, 0], normal: [0, 0, 1]}\n",
     "case/scene.yaml:9: walls[0].point: ",
     {"not three numbers"}},
    {"walls:\n  - {name: a, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}\n"
     "  - {name: a, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}\n",
     "case/scene.yaml:10: walls[1].name: ",
     {"'a' is taken already", "by walls[0] (case/scene.yaml:9)"}},
    {"walls:\n  - {name: 'a,b', shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}\n",
     "case/scene.yaml:9: walls[0].name: ",
     {"cannot be part of a column's name", "allowed: text without comma, double quote"}},
    {"observables: {regions: [{name: 'a \"b\"', shape: sphere, centre: [0, 0, 0], radius: 1}]}\n",
     "case/scene.yaml:8: observables.regions[0].name: ",
     {"cannot be part of a column's name"}},
    {"observables: {list: [{name: position, id: 1, label: \"a\\nb\"}]}\n",
     "case/scene.yaml:8: observables.list[0].label: ",
     {"cannot be part of a column's name"}},
    {"observables: {list: [{name: energy, label: a/b}]}\n",
     "case/scene.yaml:8: observables.list[0].label: ",
     {"cannot be part of a column's name", "slash"}},
    {"observables: {list: [{name: energy_kinetic, label: .}]}\n",
     "case/scene.yaml:8: observables.list[0].label: ",
     {"cannot be part of a column's name"}},
    {"observables: {regions: [{name: a/b, shape: sphere, centre: [0, 0, 0], radius: 1}]}\n",
     "case/scene.yaml:8: observables.regions[0].name: ",
     {"cannot be part of a column's name"}},
    {"observables: {grids: [{name: ../a, every: 1, cells: [1, 1, 1]}]}\n",
     "case/scene.yaml:8: observables.grids[0].name: ",
     {"cannot be part of a column's name"}},
    {"observables: {grids: [{name: a, every: 1, cells: [1, 1, 1]}, {name: a, every: 2, cells: [1, 1, 1]}]}\n",
     "case/scene.yaml:8: observables.grids[1].name: ",
     {"'a' is taken already"}},
    {"walls:\n  - shape: plane\n    point: [0, 0, 0]\n    normal: [0, 0, 1]\n    motion:\n      - {kind: "
     "wobble}\n",
     "case/scene.yaml:13: walls[0].motion[0].kind: ",
     {"'wobble' is unknown", "oscillate"}},
    {"walls:\n  - shape: plane\n    point: [0, 0, 0]\n    normal: [0, 0, 1]\n    motion:\n"
     "      - {kind: rotate, direction: [0, 0, 1], rate: 5 Hz}\n",
     "case/scene.yaml:13: walls[0].motion[0].rate: ",
     {"'Hz' is not a unit of angular velocity"}},
    {"walls:\n  - shape: plane\n    point: [0, 0, 0]\n    normal: [0, 0, 1]\n    motion:\n"
     "      - {kind: translate, velocity: [1, 0, 0], start: 2, stop: 1}\n",
     "case/scene.yaml:13: walls[0].motion[0].stop: ",
     {"1 is not after start (2)"}},
    {"groups:\n  - {name: still, motion: frozen}\n",
     "case/scene.yaml:9: groups[0].select: ",
     {"'still' selects nothing"}},
    {"groups:\n  - {name: free, motion: frozen, select: {radius_upto: 1}}\n",
     "case/scene.yaml:9: groups[0].name: ",
     {"taken already"}},
    {"insertions:\n  - {sizes: 1 mm}\n",
     "case/scene.yaml:9: insertions[0].rate: ",
     {"one of rate and mass_rate"}},
    {"insertions:\n  - {sizes: 1 mm, rate: 3, region: {shape: sphere, centre: [1, 0, 0], radius: 1 mm}}\n",
     "case/scene.yaml:9: insertions[0].region: ",
     {"lies outside of the box"}},
    {"deletions:\n  - {region: {shape: box, lower: [0, 0, 0], upper: [1, 1, 0]}}\n",
     "case/scene.yaml:9: deletions[0].region.upper: ",
     {"not above the lower corner"}},
    {"classes: {method: cuts, cuts: [2 mm, 1 mm]}\n", "case/scene.yaml:8: classes.cuts: ", {"must increase"}},
    {"classes: {method: quantiles}\n", "case/scene.yaml:8: classes.count: ", {"is missing", "from 1 to 32"}},
    {"seed:\n", "case/scene.yaml:8: seed: ", {"no value is given"}},
    {"guards: {overlap: explode}\n", "case/scene.yaml:8: guards.overlap: ", {"stop, warn, off"}},
    {"output: {trajectory: {every: {steps: 3, time: 1}}}\n",
     "case/scene.yaml:8: output.trajectory.every: ",
     {"one of the two"}},
    {"output: {trajectory: {every: 1 ms}}\n",
     "case/scene.yaml:8: output.trajectory.every.steps: ",
     {"'1 ms' is a time", "write {time: 1 ms}"}},
    {"observables: {list: [{name: colour}]}\n",
     "case/scene.yaml:8: observables.list[0].name: ",
     {"'colour' is unknown", "momentum"}},
    {"observables: {regions: [{name: z, shape: sphere, centre: [0, 0, 0]}]}\n",
     "case/scene.yaml:8: observables.regions[0].radius: ",
     {"is missing"}},
    {"seed: 18446744073709551616\n", "case/scene.yaml:8: seed: ", {"2^64 - 1"}},
    {"title: *t\n", "case/scene.yaml:8: ", {"no '&t' comes before it"}},
    {"title: \"open\n", "case/scene.yaml:", {"not valid YAML"}},
};

static void check_message(const struct error *error, const char *place, const char *const *says,
                          const char *what) {
    if (error->kind != ERROR_USER)
        fail_msg("%s: kind %d: %s", what, error->kind, error->text);
    if (strncmp(error->text, place, strlen(place)) != 0)
        fail_msg("%s: not at %s: %s", what, place, error->text);
    for (int k = 0; k < 3 && says[k]; k++)
        if (!strstr(error->text, says[k]))
            fail_msg("%s: does not say '%s': %s", what, says[k], error->text);
}

static void bad_lines(void **state) {
    (void)state;
    for (size_t k = 0; k < sizeof(texts) / sizeof(texts[0]); k++) {
        char text[2048];
        struct error error;
        snprintf(text, sizeof(text), "%s%s", GOOD_SCENE, texts[k].lines);
        struct scene *scene = scene_from(&error, text, NULL);
        if (scene)
            fail_msg("accepted: %s", texts[k].lines);
        check_message(&error, texts[k].place, texts[k].says, texts[k].lines);
    }
}

/* Settings of the command line over GOOD_SCENE; the last one is wrong, or combines badly. */
struct bad_setting {
    const char *set[4];
    const char *place, *says[3];
};

static const struct bad_setting settings[] = {
    {{"gravity"}, "command line: --set gravity", {"key=value"}},
    {{"=3"}, "command line: --set =3", {"key=value"}},
    {{"gravty=[0, 0, 0]"}, "command line: ", {"unknown key 'gravty'", "'gravity'"}},
    {{"particles.fiel=x"}, "command line: ", {"unknown key 'particles.fiel'", "file"}},
    {{"walls[0].radius=3"}, "command line: walls[0].shape: ", {"is missing"}},
    {{"walls[1].radius=3"}, "command line: walls[1].radius: ", {"there is no such number: the list has 0"}},
    {{"walls[x].radius=3"}, "command line: walls[x].radius: ", {"nothing in this list is called 'x'"}},
    {{"gravity[3]=1"}, "command line: gravity[3]: ", {"there is no such number"}},
    {{"gravity.z=1"}, "command line: gravity.z: ", {"not a key"}},
    {{"gravity[2]=fast"}, "command line: gravity: ", {"'fast' is not a number"}},
    {{"duration=[1"}, "command line: not valid YAML", {NULL}},
    {{"duration="}, "command line: duration: ", {"'' is not a number"}},
    {{"units=none"}, "case/scene.yaml:1: box.upper: ", {"no units in a dimensionless scene"}},
    {{"units=cgs"}, "command line: units: ", {"'cgs' is unknown", "si, none"}},
    {{"box.upper=[0, 1, 1]"}, "command line: box.upper: ", {"x: 0 is not above"}},
    {{"box.periodic=[true, true]"}, "command line: box.periodic: ", {"not three values"}},
    {{"box.shear=3"}, "command line: box.shear.flow: ", {"x is not periodic", "that box.periodic names"}},
    {{"box.periodic=true", "box.shear={rate: 3, flow: y}"},
     "command line: box.shear.gradient: ",
     {"y is the direction of the flow, too"}},
    {{"box.periodic=true", "box.shear=3", "walls[0]={shape: plane, point: [0, 0, 1 mm], normal: [0, 0, 1]}"},
     "command line: box.shear: ",
     {"does not go with walls", "free grains alone"}},
    {{"box.periodic=true", "box.shear=3", "groups=[{name: still, motion: frozen}]"},
     "command line: box.shear: ",
     {"does not go with groups"}},
    {{"box.periodic=true", "box.shear={rate: 3, offset: 1 mm}",
      "particles={from: random, count: 3, sizes: 1 mm}"},
     "command line: box.shear.offset: ",
     {"random sources"}},
    {{"box.dimension=4"}, "command line: box.dimension: ", {"from 2 to 3"}},
    {{"box.dimension=2", "gravity=[0, 0]", "insertions=[{sizes: 1 mm, rate: 3, velocity: [0, 0, 3]}]"},
     "command line: insertions[0].velocity: ",
     {"z component (3)", "[x, y, 0]"}},
    {{"box.dimension=2", "gravity=[0, 0]", "insertions=[{sizes: 1 mm, rate: 3, omega: [5, 0, 0]}]"},
     "command line: insertions[0].omega: ",
     {"out of the plane", "[0, 0, z]"}},
    {{"box.dimension=2", "gravity=[0, 0]",
      "groups=[{name: a, motion: moving, omega: [0, 2, 0], select: {ids: [1]}}]"},
     "command line: groups[0].omega: ",
     {"out of the plane", "[0, 0, z]"}},
    {{"box.dimension=2", "gravity=[0, 0]",
      "groups=[{name: a, motion: moving, velocity: [0, 2, 1], select: {ids: [1]}}]"},
     "command line: groups[0].velocity: ",
     {"z component (1)"}},
    {{"box.dimension=2", "gravity=[0, 0]", "particles.omega=[1, 0, 0]"},
     "command line: particles.sources[0].omega: ",
     {"out of the plane", "[0, 0, z]"}},
    {{"box.dimension=2", "gravity=[0, 0]", "walls[0]={shape: plane, point: [0, 0, 0], normal: [0, 3, 4]}"},
     "command line: walls[0].normal: ",
     {"z component (0.8)", "[x, y, 0], or along z where the box ends"}},
    {{"box.dimension=2", "gravity=[0, 0]", "walls[0]={shape: plane, point: [0, 0, 1 mm], normal: [0, 0, 1]}"},
     "command line: walls[0].normal: ",
     {"z component (1)", "where the box ends"}},
    {{"box.dimension=2", "gravity=[0, 0]",
      "walls[0]={shape: plane, point: [0, 0, 1 mm], normal: [0, 0, -1]}"},
     "command line: walls[0].normal: ",
     {"z component (-1)", "where the box ends"}},
    {{"box.dimension=2", "gravity=[0, 0]",
      "walls[0]={shape: cylinder, point: [0, 0, 0], axis: [0, 1, 1], radius: 1 mm}"},
     "command line: walls[0].axis: ",
     {"leans out of the plane", "[0, 0, 1] or [x, y, 0]"}},
    {{"box.dimension=2", "gravity=[0, 0]",
      "walls[0]={shape: plane, point: [0, 0, 0], normal: [0, 1], motion: [{kind: translate, velocity: [0, 1, "
      "1]}]}"},
     "command line: walls[0].motion[0].velocity: ",
     {"z component (1)", "[x, y, 0]"}},
    {{"box.dimension=2", "gravity=[0, 0]",
      "walls[0]={shape: plane, point: [0, 0, 0], normal: [0, 1], motion: [{kind: rotate, direction: [0, 1, "
      "1], rate: 1}]}"},
     "command line: walls[0].motion[0].direction: ",
     {"turns out of the plane", "[0, 0, z]"}},
    {{"box.dimension=2", "gravity=[0, 0]",
      "walls[0]={shape: plane, point: [0, 0, 0], normal: [0, 1], motion: [{kind: oscillate_rotation, "
      "direction: [1, 0, 0], angle: 1, frequency: 1}]}"},
     "command line: walls[0].motion[0].direction: ",
     {"turns out of the plane"}},
    {{"box.dimension=2", "gravity=[0, 0]",
      "walls[0]={shape: plane, point: [0, 0, 0], normal: [0, 1], motion: [{kind: oscillate, direction: [0, "
      "0, 1], amplitude: 1, frequency: 1}]}"},
     "command line: walls[0].motion[0].direction: ",
     {"z component"}},
    {{"box.dimension=2", "gravity=[0, 0]",
      "walls[0]={shape: plane, point: [0, 0, 0], normal: [0, 1], motion: [{kind: servo, direction: [0, 0, "
      "1], force: 1, speed_max: 1}]}"},
     "command line: walls[0].motion[0].direction: ",
     {"z component"}},
    {{"walls[0]={shape: plane, point: [0, 0, 0], normal: [0, 0, -1], motion: [{kind: servo, direction: [0, "
      "0, 1], "
      "speed_max: 1}]}"},
     "command line: walls[0].motion[0].kind: ",
     {"either a force or a pressure"}},
    {{"walls[0]={shape: plane, point: [0, 0, 0], normal: [0, 0, -1], motion: [{kind: servo, direction: [0, "
      "0, 1], "
      "force: 1, pressure: 1, speed_max: 1}]}"},
     "command line: walls[0].motion[0].pressure: ",
     {"either a force or a pressure"}},
    {{"walls[0]={shape: plane, point: [0, 0, 0], normal: [0, 0, -1], motion: [{kind: servo, direction: [0, "
      "0, 1], "
      "force: 1, area: 1, speed_max: 1}]}"},
     "command line: walls[0].motion[0].area: ",
     {"goes with a pressure"}},
    {{"walls[0]={shape: plane, point: [0, 0, 0], normal: [0, 1, -1], motion: [{kind: servo, direction: [0, "
      "0, 1], "
      "pressure: 1, speed_max: 1}]}"},
     "command line: walls[0].motion[0].pressure: ",
     {"needs an area"}},
    {{"walls[0]={shape: cylinder, point: [0, 0, 0], axis: [0, 0, 1], radius: 1, motion: [{kind: servo, "
      "direction: [0, 0, "
      "1], pressure: 1, speed_max: 1}]}"},
     "command line: walls[0].motion[0].pressure: ",
     {"needs an area"}},
    {{"box.dimension=2"}, "case/scene.yaml:2: gravity: ", {"z component", "two-dimensional"}},
    {{"box.dimension=2", "gravity=[0, 0]", "box.periodic=[true, true, true]"},
     "command line: box.periodic: ",
     {"z cannot be periodic"}},
    {{"box.periodic=true", "walls[0]={shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}"},
     "command line: walls[0].normal: ",
     {"crosses the periodic direction z"}},
    {{"box.periodic=true",
      "walls[0]={shape: cylinder, point: [5 mm, 5 mm, 0], axis: [0, 0, 1], radius: 6 mm}"},
     "command line: walls[0].radius: ",
     {"crosses the ends of the periodic direction x"}},
    {{"box.periodic=[true, false, false]",
      "walls[0]={shape: cylinder, point: [5 mm, 5 mm, 10 mm], axis: [1, 0, 1], radius: 1 mm}"},
     "command line: walls[0].axis: ",
     {"slants across the periodic direction x", "allowed: an axis along x, or without"}},
    {{"box.periodic=[true, false, false]",
      "walls[0]={shape: cylinder, point: [5 mm, 5 mm, 10 mm], axis: [1, 0, 1], radius: 1 mm, length: 16 mm, "
      "inside: true}"},
     "command line: walls[0].length: ",
     {"crosses the ends of the periodic direction x (0 to 0.01)"}},
    {{"box.periodic=[true, false, false]", "particles={from: random, sizes: 1 mm, count: 3, region: {shape: "
                                           "box, lower: [-5 mm, 0, 0], upper: [10 mm, "
                                           "10 mm, 20 mm]}}"},
     "command line: particles.sources[0].region: ",
     {"reaches from -0.005 to 0.01 in the periodic direction x", "at most the edge of the box, 0.01"}},
    {{"box.periodic=[true, false, false]", "particles={from: lattice, lattice: sc, spacing: 2 mm, sizes: 1 "
                                           "mm, region: {shape: sphere, centre: [5 mm, 5 "
                                           "mm, 5 mm], radius: 6 mm}}"},
     "command line: particles.sources[0].region: ",
     {"overlaps itself"}},
    {{"box.periodic=[false, true, false]", "insertions=[{sizes: 1 mm, rate: 3, region: {shape: box, lower: "
                                           "[0, 0, 0], upper: [10 mm, 10.1 mm, 5 mm]}}]"},
     "command line: insertions[0].region: ",
     {"in the periodic direction y"}},
    {{"box.leave=vanish"}, "command line: box.leave.all: ", {"keep, delete, error"}},
    {{"materials=[]"}, "command line: materials: ", {"is missing"}},
    {{"materials[0]={name: a, density: 1}"}, "command line: materials[0].young: ", {"is missing", "in Pa"}},
    {{"materials[0].poisson=0.7"}, "command line: materials[0].poisson: ", {"0.5"}},
    {{"materials[0].name='glass[1]'"},
     "command line: materials[0].name: ",
     {"cannot be part of a column's name"}},
    {{"materials[0].density=-1"}, "command line: materials[0].density: ", {"> 0"}},
    {{"materials[1]={name: steel, density: 1, young: 1, poisson: 0}", "particles.material=glass",
      "material_pairs[0].between=[glass, glass]"},
     "case/scene.yaml:6: material_pairs: ",
     {"the pair glass, steel is missing"}},
    {{"materials[1]={name: glass, density: 1, young: 1, poisson: 0}"},
     "command line: materials[1].name: ",
     {"'glass' is taken already", "by materials[0] (case/scene.yaml:5)"}},
    {{"materials[1]={name: glass, density: 1, young: 1, poisson: 0}",
      "material_pairs[0].between=[glass, steel]"},
     "command line: materials[1].name: ",
     {"'glass' is taken already"}},
    {{"groups=[{name: a, motion: frozen, select: {ids: [1]}}, {name: a, motion: frozen, select: {ids: "
      "[2]}}]"},
     "command line: groups[1].name: ",
     {"'a' is taken already", "by groups[0] (command line)"}},
    {{"materials[1]={name: steel, density: 1, young: 1, poisson: 0}"},
     "case/scene.yaml:7: particles.sources[0].material: ",
     {"is missing"}},
    {{"material_pairs[1]={restitution: 1}"}, "command line: material_pairs[1].between: ", {"only one entry"}},
    {{"material_pairs[0].between=glass"}, "command line: material_pairs[0].between: ", {"needed: two"}},
    {{"material_pairs[0].between=[glass, wood]"},
     "command line: material_pairs[0].between[1]: ",
     {"'wood'", "known: glass"}},
    {{"material_pairs[0].restitution=1.1"}, "command line: material_pairs[0].restitution: ", {"from 0 to 1"}},
    {{"material_pairs[0].k_n=1e5"},
     "command line: material_pairs[0].k_n: ",
     {"exists only with contact.law=hooke|", "|luding, or with contact.law=hertz|thornton|",
      " & contact.damping=coefficient"}},
    {{"contact.law=hooke"},
     "case/scene.yaml:5: materials[0].young: ",
     {"exists only with contact.law=hertz"}},
    {{"contact.law=hooke", "materials[0]={name: glass, density: 1}",
      "material_pairs[0]={restitution: 1, k_n: 1, k_t: 0}"},
     "command line: material_pairs[0].k_t: ",
     {"out of range", "> 0"}},
    {{"contact.tangential=none"},
     "case/scene.yaml:6: material_pairs[0].friction: ",
     {"exists only with contact.tangential=history"}},
    {{"contact.tangential=none", "contact.rolling=spring"},
     "command line: contact.rolling: ",
     {"tangential=history"}},
    {{"contact.damping=coefficient", "materials[0]={name: glass, density: 1}",
      "material_pairs=[{gamma_n: 3}]"},
     "command line: material_pairs[0].k_n: ",
     {"is missing", "in Pa"}},
    {{"contact.damping=coefficient"},
     "case/scene.yaml:5: materials[0].young: ",
     {"& contact.damping=restitution|viscoelastic|tsuji"}},
    {{"contact={lammps_history: true, lammps_hooke: true}"},
     "command line: contact.lammps_hooke: ",
     {"is an older name of lammps_history"}},
    {{"contact={law: hooke, damping: coefficient, lammps_history: true, end: force}",
      "integrator=velocity_verlet", "materials[0]={name: glass, density: 1}",
      "material_pairs=[{k_n: 1, gamma_n: 3, friction: 0.1}]"},
     "command line: contact.end: ",
     {"goes with end: overlap"}},
    {{"contact.tangential_damping_ratio=2", "contact.tangential_damping_equal=true"},
     "command line: contact.tangential_damping_equal: ",
     {"one of the two"}},
    {{"particles={}", "title=x"}, "command line: particles: ", {"is missing"}},
    {{"particles={file: a.txt}"},
     "command line: particles.format: ",
     {"is missing", "lammps-data, table, h5md"}},
    {{"particles={file: a.txt, format: xyz}"}, "command line: particles.format: ", {"'xyz' is unknown"}},
    {{"particles={file: a.txt, sources: []}"}, "command line: particles: ", {"'file' beside 'sources'"}},
    {{"particles={sources: [{file: a, format: table}, {file: b, format: table}]}", "particles.scale=2"},
     "command line: particles.scale: ",
     {"there are 2 sources"}},
    {{"particles={from: packed, sizes: 1 mm}"},
     "command line: particles.sources[0].count: ",
     {"give count or volume_fraction"}},
    {{"particles={from: packed, sizes: 1 mm, count: 3, volume_fraction: 0.1}"},
     "command line: particles.sources[0].volume_fraction: ",
     {"beside count and a box", "two decide the third"}},
    {{"particles={from: packed, count: 3, sizes: {law: uniform, min: 1 um, max: 2 mm}}"},
     "command line: particles.sources[0].sizes: ",
     {"more than 1000 times the smallest"}},
    {{"particles={from: random, sizes: 1 mm, count: 3, gap: 0.1}"},
     "command line: particles.gap: ",
     {"from=packed"}},
    {{"particles={from: random, sizes: 1 mm}"},
     "command line: particles.sources[0].count: ",
     {"give count or volume_fraction"}},
    {{"particles={from: random, sizes: 1 mm, count: 3, volume_fraction: 0.1}"},
     "command line: particles.sources[0].volume_fraction: ",
     {"one of the two"}},
    {{"particles={from: random, sizes: 1 mm, volume_fraction: 0.5}"},
     "command line: particles.sources[0].volume_fraction: ",
     {"end at 0.382 of the volume"}},
    {{"particles={from: random, count: 3, sizes: {law: uniform, min: 2 mm, max: 1 mm}}"},
     "command line: particles.sources[0].sizes: ",
     {"max (0.001) is not above min (0.002)"}},
    {{"particles={from: random, count: 3, sizes: {law: table, radii: [1, 2], passing: [0, 0.5]}}"},
     "command line: particles.sources[0].sizes: ",
     {"end with 1"}},
    {{"particles={from: random, count: 3, sizes: {law: discrete, radii: [1, 2], weights: [1]}}"},
     "command line: particles.sources[0].sizes: ",
     {"2 radii but 1 weights"}},
    {{"particles={from: random, count: 3, sizes: {law: normal, mean: 1, sigma: 0.1, min: 8, max: 9}}"},
     "command line: particles.sources[0].sizes: ",
     {"of the distribution lies between"}},
    {{"particles={from: lattice, lattice: fcc, spacing: 1 mm, sizes: 1 mm}"},
     "command line: particles.sources[0].spacing: ",
     {"neighbours would overlap"}},
    {{"particles={from: lattice, lattice: square, spacing: 3 mm, sizes: 1 mm}"},
     "command line: particles.sources[0].lattice: ",
     {"not a lattice of 3 dimensions", "sc, fcc, hcp"}},
    {{"contact.tangential=none", "material_pairs=[{restitution: 1}]", "particles.omega=[1, 0, 0]"},
     "command line: particles.sources[0].omega: ",
     {"spin without friction"}},
    {{"duration=~"}, "case/scene.yaml:1: duration: ", {"is missing"}},
    {{"materials=~"}, "case/scene.yaml:1: materials: ", {"is missing"}},
    {{"duratoin=~"}, "command line: ", {"unknown key 'duratoin'", "'duration'"}},
    {{"output.dump.evry=~"}, "command line: output.dump.evry: ", {"not a key"}},
    {{"materials[1]=~"}, "command line: materials[1]: ", {"no such number"}},
    {{"materials[1].young=~"}, "command line: materials[1].young: ", {"no such number", "list has 1"}},
    {{"box={}"}, "command line: box.lower: ", {"is missing"}},
};

static void bad_settings(void **state) {
    (void)state;
    for (size_t k = 0; k < sizeof(settings) / sizeof(settings[0]); k++) {
        struct error error;
        const char *set[5] = {NULL};
        memcpy(set, settings[k].set, sizeof(settings[k].set));
        struct scene *scene = scene_from(&error, GOOD_SCENE, set);
        if (scene)
            fail_msg("accepted: %s", set[0]);
        check_message(&error, settings[k].place, settings[k].says, set[0]);
    }
}

/* Without a length of the run, and with too many of a list. */
static void bad_wholes(void **state) {
    (void)state;
    struct error error;
    struct scene *scene = scene_from(&error, "box: {lower: [0, 0, 0], upper: [1, 1, 1]}\n", NULL);
    assert_null(scene);
    check_message(&error, "case/scene.yaml:1: materials: ", (const char *const[3]){"is missing"},
                  "no materials");
    char text[65536] = GOOD_SCENE "deletions:\n";
    for (int k = 0; k <= DELETIONS_MAX; k++)
        strcat(text, "  - {every: 3}\n");
    assert_null(scene_from(&error, text, NULL));
    check_message(&error,
                  "case/scene.yaml:8: deletions: ", (const char *const[3]){"1001 entries; at most 1000"},
                  "too many");
    assert_null(scene_from(&error, "- a\n- b\n", NULL));
    check_message(&error, "case/scene.yaml:1: ", (const char *const[3]){"must be a section"}, "a list");
}

TEST_MAIN(scene_check, cmocka_unit_test(bad_lines), cmocka_unit_test(bad_settings),
          cmocka_unit_test(bad_wholes))
