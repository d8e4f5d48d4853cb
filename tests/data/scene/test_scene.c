/* SPDX-License-Identifier: BSD-3-Clause */
/* What a scene becomes: option structs, defaults, derived values, the echo. */
#include "tests/scene_by_hand.h"
#include "tests/own_law.h"
#include "data/scene/scene_text.h"

#include "physics/grains/motion/timestep.h"

#include <math.h>
#include <unistd.h>

static void fills_options(void **state) {
    (void)state;
    struct scene *scene = good_scene(GOOD_SCENE, NULL);
    assert_int_equal(scene->units, SCENE_UNITS_SI);
    assert_int_equal(scene->box.dimension, 3);
    assert_true(scene->box.edge[2] == 0.02 && scene->box.origin[2] == 0);
    assert_int_equal(scene->box.leave[2][1], BOX_KEEP);
    assert_true(scene->gravity[2] == -9.81);
    assert_true(scene->duration == 1e-3);
    assert_true(scene->step.dt == 0);
    assert_true(scene->step.fraction == timestep_default_fraction());
    assert_int_equal(scene->step.count, -1);
    assert_string_equal(scene->integrator, "synchronised_verlet");
    assert_true(scene->law.synchronised);
    assert_int_equal(scene->law.normal, LAW_HERTZ);
    assert_int_equal(scene->law.tangential, LAW_TANGENTIAL_HISTORY);
    assert_int_equal(scene->materials, 1);
    assert_true(scene->material[0].young == 70e9);
    assert_true(scene_law_pair(scene, 0, 0)->friction == 0.3);
    assert_int_equal(scene->groups, 1);
    assert_string_equal(scene->group[0].name, "free");
    assert_int_equal(scene->sources, 1);
    assert_true(scene->source[0].position[0] == 0.005);
    assert_int_equal(scene->source[0].material, 0);
    assert_string_equal(scene->index.name, "auto");
    assert_true(scene->ghosts.newton && scene->ghosts.reduced);
    assert_false(scene->classes.skin_given);
    assert_true(scene->classes.skin_relative == 0.3);
    assert_true(scene->output.trajectory.xdmf);
    assert_int_equal(scene->output.checkpoint.keep, 2);
    assert_true(scene->output.checkpoint.at_end);
    assert_int_equal(scene->seed, 1);
    scene_free(&scene);
    assert_null(scene);
}

/* The option structs that modules define defaults for agree with those of the schema. */
static void agrees_with_modules(void **state) {
    (void)state;
    struct scene *scene = good_scene(GOOD_SCENE, NULL);
    struct law_options law = law_options_default();
    assert_int_equal(scene->law.normal, law.normal);
    assert_int_equal(scene->law.damping, law.damping);
    assert_int_equal(scene->law.end, law.end);
    assert_int_equal(scene->law.tangential, law.tangential);
    assert_int_equal(scene->law.rolling, law.rolling);
    struct classes_options classes = classes_options_default();
    assert_int_equal(scene->classes.method, classes.method);
    assert_true(scene->classes.skin_relative == classes.skin_relative);
    struct output_options output = output_options_default();
    assert_int_equal(scene->output.checkpoint.keep, output.checkpoint.keep);
    assert_int_equal(scene->output.checkpoint.at_end, output.checkpoint.at_end);
    assert_int_equal(scene->output.trajectory.xdmf, output.trajectory.xdmf);
    assert_int_equal(scene->output.progress.mode, output.progress.mode);
    assert_true(index_registry_find(scene->index.name) != NULL);
    scene_free(&scene);
}

static void settings_override(void **state) {
    (void)state;
    static const char *const set[] = {
        "step.dt=0.5 us",
        "gravity[2]=0",
        "materials[0].density=1 t/m3",
        "newton=off",
        "index=multi",
        "particles.radius=2 mm",
        "walls[0]={name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 2]}",
        "walls[0].name=ground",
        "box.leave=delete",
        "box.leave.z_upper=error",
        "skin=0.1 mm",
        NULL};
    struct scene *scene = good_scene(GOOD_SCENE, set);
    assert_true(scene->step.dt == 5e-7 && scene->step.fraction == 0);
    assert_true(scene->gravity[2] == 0);
    assert_true(scene->material[0].density == 1000);
    assert_false(scene->ghosts.newton);
    assert_string_equal(scene->index.name, "multi");
    assert_true(scene->source[0].radius == 0.002);
    assert_int_equal(scene->walls, 1);
    assert_string_equal(scene->wall[0].name, "ground");
    assert_true(scene->wall[0].normal[2] == 1);
    assert_int_equal(scene->box.leave[0][0], BOX_DELETE);
    assert_int_equal(scene->box.leave[2][1], BOX_ERROR);
    assert_true(scene->classes.skin_given && scene->classes.skin == 1e-4);
    char place[64];
    assert_string_equal(scene_place(scene, "step.dt", place, sizeof(place)), "command line");
    assert_string_equal(scene_place(scene, "materials[0].young", place, sizeof(place)), "case/scene.yaml:5");
    assert_int_equal(scene_wall(scene, "ground"), 0);
    assert_int_equal(scene_material(scene, "glass"), 0);
    assert_int_equal(scene_wall(scene, "none"), -1);
    scene_free(&scene);
}

/* Whatever else is asked for, a trajectory can be read back. */
static void trajectories_read_back(void **state) {
    (void)state;
    static const char *const sets[][2] = {{"output.trajectory.fields=[force]"},
                                          {"output.trajectory.fields=[radius, force, position]"},
                                          {"output.dump.fields=[force]"}};
    static const char *const names[][4] = {
        {"force", "position", "radius", ""}, {"radius", "force", "position", ""}, {""}};
    for (int k = 0; k < 3; k++) {
        struct scene *scene = good_scene(GOOD_SCENE, sets[k]);
        const struct output_fields *fields = &scene->output.trajectory.fields;
        assert_int_equal(fields->count, k < 2 ? 3 : 0);
        for (int f = 0; f < fields->count; f++)
            assert_string_equal(fields->name[f], names[k][f]);
        assert_int_equal(scene->output.dump.fields.count, k < 2 ? 0 : 1);
        scene_free(&scene);
    }
}

/* What is taken out makes room for its alternative; what is not there may be taken out, too. */
static void settings_take_out(void **state) {
    (void)state;
    static const char *const set[] = {
        "step={fraction: 0.1, count: 3}",
        "step.fraction=~",
        "step.dt=1 us",
        "contact.law=hooke",
        "materials[0].young=~",
        "materials[0].poisson=null",
        "material_pairs[0].k_n=1e5",
        "walls=[{name: a, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}, {name: "
        "b, shape: plane, point: [0, 0, 1], normal: [0, 0, -1]}]",
        "walls[0]=~",
        "output.dump.every=~",
        "particles.velocity=~",
        "title='~'",
        NULL};
    struct scene *scene = good_scene(GOOD_SCENE, set);
    assert_true(scene->step.dt == 1e-6 && scene->step.fraction == 0 && scene->step.count == 3);
    assert_true(scene_law_pair(scene, 0, 0)->k_n == 1e5);
    assert_int_equal(scene->walls, 1);
    assert_string_equal(scene->wall[0].name, "b");
    assert_string_equal(scene->title, "~");
    scene_free(&scene);
}

#define RICH_SCENE                                                                                           \
    "title: 'quotes \" and : # and\ttabs'\n"                                                                 \
    "seed: 18446744073709551615\n"                                                                           \
    "box: {lower: [-1, -1, -1], upper: [1, 1, 1], periodic: [true, false, false], leave: {all: error, "      \
    "z_lower: delete}}\n"                                                                                    \
    "gravity: [0.1, 0, -9.81]\n"                                                                             \
    "step: {count: 1e6, dt: 1.7e-7, force: on}\n"                                                            \
    "contact: {law: hooke, rolling: spring, tangential_damping_ratio: 0.3333333333333333}\n"                 \
    "materials: [{name: a b, density: 2500}, {name: steel, density: 7800}]\n"                                \
    "material_pairs:\n"                                                                                      \
    "  - {restitution: 0.1, friction: 0.7, k_n: 1e5, rolling_friction: 0.05}\n"                              \
    "  - {between: [steel, a b], restitution: 0.9, k_n: 2e5, k_t: 1e5}\n"                                    \
    "groups:\n"                                                                                              \
    "  - {name: pushed, motion: moving, velocity: [1, 0, 0], omega: [0, 0, 3 rpm], select: {ids: [1, 5], "   \
    "material: steel}}\n"                                                                                    \
    "  - {name: still, motion: frozen, select: {region: {shape: sphere, centre: [0, 0, 0], radius: 10 cm}, " \
    "radius_upto: 1 cm}}\n"                                                                                  \
    "walls:\n"                                                                                               \
    "  - {shape: cylinder, point: [0, 0, 0], axis: [0, 3, 4], radius: 0.5, material: steel, inside: no,\n"   \
    "     motion: [{kind: rotate, direction: [1, 1, 1], rate: 20 rpm, stop: 4 s},\n"                         \
    "              {kind: oscillate, direction: [0, 0, 7], amplitude: 1 mm, frequency: 50 Hz, phase: 90 "    \
    "deg},\n"                                                                                                \
    "              {kind: servo, direction: [0, 0, 1], force: 1 kN, speed_max: 1 cm/s}]}\n"                  \
    "  - {name: m, shape: mesh, file: part.stl, material: a b, scale: 0.001, motion: [{kind: table, file: "  \
    "/t.txt}]}\n"                                                                                            \
    "particles:\n"                                                                                           \
    "  sources:\n"                                                                                           \
    "    - {file: ../p.txt, format: table, columns: [x, y, z, radius], rows: 7, types: [steel, a b]}\n"      \
    "    - {from: lattice, lattice: hcp, spacing: 30 mm, jitter: 0.5, material: steel, group: pushed,\n"     \
    "       sizes: {law: discrete, radii: [5 mm, 8 mm], weights: [2, 1], by: number}}\n"                     \
    "    - {from: random, material: a b, volume_fraction: 0.1, velocity_sigma: 0.3,\n"                       \
    "       region: {shape: cylinder, centre: [0, 0, 0], axis: [0, 1, 1], radius: 0.2, length: 0.4},\n"      \
    "       sizes: {law: table, radii: [1 mm, 2 mm, 4 mm], passing: [0, 0.3, 1]}}\n"                         \
    "insertions: [{sizes: 3 mm, rate: 100, material: steel, stop: 3, region: {shape: box, lower: [0, 0, "    \
    "0], upper: [1, 1, 1]}}]\n"                                                                              \
    "deletions: [{every: 7, region: {shape: sphere, centre: [0, 0, -1], radius: 1}}]\n"                      \
    "index: {name: hgrid, levels: 3, level_cells: [0.01, 0, 0.1]}\n"                                         \
    "classes: {method: cuts, cuts: [1 cm, 2 cm]}\n"                                                          \
    "ghosts: reduced\n"                                                                                      \
    "output: {trajectory: {every: {time: 1 ms}, fields: [position, radius], contacts: 100}, checkpoint: "    \
    "{minutes: 30}}\n"                                                                                       \
    "observables:\n"                                                                                         \
    "  every: 10\n"                                                                                          \
    "  regions: [{name: zone, shape: box, lower: [0, -.inf, 0]}]\n"                                          \
    "  list: [{name: position, id: 3, label: ball, components: z}, {name: energy}, {name: count, target: "   \
    "zone/steel}]\n"

/* The echo reads back to the same echo, and to the same values. */
static void echo_reads_back(void **state) {
    (void)state;
    static const char *const texts[] = {GOOD_SCENE, RICH_SCENE};
    for (int k = 0; k < 2; k++) {
        struct scene *scene = good_scene(texts[k], NULL);
        char *echo = scene_echo(scene);
        struct error error = {0};
        struct scene *again = scene_parse("elsewhere/out.yaml", echo, NULL, 0, &error);
        if (!again)
            fail_msg("%s\n%s", error.text, echo);
        char *second = scene_echo(again);
        assert_string_equal(echo, second);
        assert_memory_equal(&scene->box, &again->box, sizeof(scene->box));
        assert_memory_equal(&scene->step, &again->step, sizeof(scene->step));
        assert_memory_equal(&scene->law, &again->law, sizeof(scene->law));
        assert_memory_equal(scene->law_pair, again->law_pair,
                            (size_t)scene->materials * (size_t)scene->materials * sizeof(*scene->law_pair));
        assert_memory_equal(scene->material, again->material, sizeof(scene->material));
        assert_memory_equal(scene->group, again->group, sizeof(scene->group));
        assert_memory_equal(scene->insertion, again->insertion,
                            (size_t)scene->insertions * sizeof(*scene->insertion));
        assert_memory_equal(scene->deletion, again->deletion,
                            (size_t)scene->deletions * sizeof(*scene->deletion));
        assert_memory_equal(&scene->index, &again->index, sizeof(scene->index));
        assert_memory_equal(&scene->classes, &again->classes, sizeof(scene->classes));
        assert_memory_equal(&scene->output, &again->output, sizeof(scene->output));
        assert_int_equal(scene->seed, again->seed);
        assert_string_equal(scene->title, again->title);
        memory_free(echo);
        memory_free(second);
        scene_free(&scene);
        scene_free(&again);
    }
}

static void rich_values(void **state) {
    (void)state;
    struct scene *scene = good_scene(RICH_SCENE, NULL);
    char working[SCENE_PATH_MAX];
    assert_non_null(getcwd(working, sizeof(working)));
    assert_string_equal(scene->wall[1].file, "case/part.stl");
    assert_string_equal(scene->wall[1].motion[0].table, "/t.txt");
    assert_string_equal(scene->source[0].file, "case/../p.txt");
    assert_string_equal(scene->wall[0].name, "wall1");
    assert_true(scene->wall[0].axis[1] == 0.6 && scene->wall[0].axis[2] == 0.8);
    assert_true(fabs(scene->wall[0].motion[0].rate - 20 * 2 * M_PI / 60) < 1e-14);
    assert_true(isinf(scene->wall[0].motion[1].stop) && scene->wall[0].motion[0].stop == 4);
    assert_true(scene->wall[0].motion[1].direction[2] == 1);
    assert_true(scene_law_pair(scene, 0, 1)->k_n == 2e5 && scene_law_pair(scene, 1, 0)->k_t == 1e5);
    assert_true(scene_law_pair(scene, 1, 1)->k_n == 1e5 && scene_law_pair(scene, 1, 1)->k_t == 1e5 * 2 / 7);
    assert_int_equal(scene->step.count, 1000000);
    assert_int_equal(scene->source[0].type_material[0], 1);
    assert_int_equal(scene->source[1].group, 1);
    assert_int_equal(scene->group[1].id_count, 2);
    assert_true(scene->group[1].selects && scene->group[2].selects && scene->group[2].by_region);
    assert_true(scene->ghosts.reduced);
    assert_int_equal(scene->output.trajectory.fields.count, 2);
    assert_int_equal(scene->output.trajectory.contacts.steps, 100);
    assert_int_equal(scene->output.observables.request[0].components, 4);
    assert_true(isinf(scene->output.observables.region[0].lower[1]));
    struct law law = {.spin = true};
    struct particles *all = particles_with(WITH_ALL, 0), *particles = particles_create(0);
    scene_register(scene, &law, particles);
    assert_int_equal(fields_count(particles), fields_count(all));
    particles_destroy(&all);
    particles_destroy(&particles);
    struct integrator_context context;
    scene_integrator(scene, &context);
    assert_int_equal(context.groups, 3);
    assert_false(context.motion[0].prescribed);
    assert_true(context.motion[1].prescribed && context.motion[1].velocity[0] == 1);
    assert_true(context.motion[2].prescribed && context.motion[2].velocity[0] == 0);
    scene_free(&scene);
}

/* A frictionless scene of one material in an open box needs no field beyond the least. */
static void fields_are_what_is_needed(void **state) {
    (void)state;
    static const char *const set[] = {"contact.tangential=none", "material_pairs=[{restitution: 0.5}]", NULL};
    struct scene *scene = good_scene(GOOD_SCENE, set);
    struct law law = {.spin = false};
    struct particles *particles = particles_create(0);
    scene_register(scene, &law, particles);
    assert_int_equal(fields_count(particles), FIELD_FIRST_COUNT);
    particles_destroy(&particles);
    scene_free(&scene);
}

/* Walls never meet: a pair of materials that only walls have need not be given. */
static void pairs_of_walls(void **state) {
    (void)state;
    static const char *const set[] = {
        "materials[1]={name: steel, density: 1, young: 1, poisson: 0}",
        "walls=[{shape: plane, point: [0, 0, 0], normal: [0, 0, 1], material: steel}]",
        "material_pairs=[{between: [glass, glass], restitution: 0.5},"
        " {between: [glass, steel], restitution: 0.6}]",
        "particles.material=glass", NULL};
    struct scene *scene = good_scene(GOOD_SCENE, set);
    assert_true(scene_law_pair(scene, 0, 1)->restitution == 0.6);
    OWN_LAW law;
    struct error error = {0};
    if (!law_prepare(&law, &scene->law, scene->materials, scene->material, scene->law_pair, &error))
        fail_msg("%s", error.text);
    scene_free(&scene);
}

static void two_dimensions(void **state) {
    (void)state;
    struct scene *scene =
        good_scene("units: none\n"
                   "box: {dimension: 2, lower: [0, 0], upper: [4, 3], periodic: [true, false]}\n"
                   "gravity: [0, -1]\n"
                   "step: {count: 1}\n"
                   "contact: {law: hooke, tangential: none}\n"
                   "materials: [{name: a, density: 1}]\n"
                   "material_pairs: [{restitution: 1, k_n: 1}]\n"
                   "particles: {from: lattice, lattice: square, spacing: 1, sizes: 0.5}\n",
                   NULL);
    assert_true(scene->box.edge[2] == 3 && scene->box.origin[2] == -1.5);
    assert_true(scene->box.periodic[0] && !scene->box.periodic[1] && !scene->box.periodic[2]);
    struct scene_census census;
    struct particles *particles = scene_all(scene, &census);
    assert_int_equal(census.particles, 12);
    for (size_t i = 0; i < particles->owned; i++)
        assert_true(particles->state[i].x[2] == 1.5);
    particles_destroy(&particles);
    scene_free(&scene);
}

static void box_from_data_file(void **state) {
    (void)state;
    write_file(
        "test_scene.data",
        "comment\n\n2 atoms\n1 atom types\n\n-1 3 xlo xhi\n0 4 ylo yhi\n0 5 zlo zhi\n\nAtoms # sphere\n\n"
        "1 1 2 1.5 0.5 1 1\n2 1 1 1.5 2.5 2 2\n\nVelocities\n\n1 1 2 3 4 5 6\n2 0 0 0 0 0 0\n");
    static const char text[] =
        "units: none\nbox: {periodic: true}\nstep: {count: 1}\ncontact: {law: hooke}\n"
        "materials: [{name: a, density: 1}]\nmaterial_pairs: [{restitution: 1, k_n: 1}]\n"
        "particles: {file: test_scene.data, format: lammps-data}\n";
    struct error error = {0};
    struct scene *scene = scene_parse("test_scene.yaml", text, NULL, 0, &error);
    if (!scene)
        fail_msg("%s", error.text);
    assert_true(scene->box.origin[0] == -1 && scene->box.edge[0] == 4 && scene->box.edge[2] == 5);
    struct particles *particles = scene_all(scene, NULL);
    assert_int_equal(particles->owned, 2);
    assert_true(particles->state[0].x[0] == 1.5 && particles->state[0].radius == 1);
    assert_true(fabs(1 / particles->state[0].inverse_mass - 4 * M_PI / 3 * 1.5) < 1e-12);
    assert_true(particles->state[0].v[2] == 3 && spin_of(particles)[0][0] == 4);
    particles_destroy(&particles);
    scene_free(&scene);
    static const struct scene_setting no_file[] = {{"particles=~"}, {"particles.sources=[]"}};
    for (int k = 0; k < 2; k++) {
        error = (struct error){0};
        assert_null(scene_parse("test_scene.yaml", text, &no_file[k], 1, &error));
        assert_int_equal(error.kind, ERROR_USER);
        assert_non_null(strstr(error.text, "box.lower: is missing; needed: three numbers"));
    }
    static const struct scene_setting one_corner[] = {{"box.lower=[-9, -9, -9]"}, {"box.upper=[9, 9, 9]"}};
    for (int k = 0; k < 2; k++) {
        error = (struct error){0};
        assert_null(scene_parse("test_scene.yaml", text, &one_corner[k], 1, &error));
        assert_int_equal(error.kind, ERROR_USER);
        assert_non_null(strstr(error.text, k == 0 ? "box.upper: is missing beside box.lower"
                                                  : "box.lower: is missing beside box.upper"));
    }
    remove("test_scene.data");
}

static void reads_texts(void **state) {
    (void)state;
    struct error error = {0};
    char *text;
    size_t length;
    write_file("test_scene.txt", "abc\n");
    assert_true(scene_read_text("test_scene.txt", &text, &length, &error));
    assert_int_equal(length, 4);
    assert_string_equal(text, "abc\n");
    memory_free(text);
    remove("test_scene.txt");
    assert_false(scene_read_text("test_scene.txt", &text, &length, &error));
    assert_int_equal(error.kind, ERROR_USER);
    assert_non_null(strstr(error.text, "test_scene.txt: cannot be read"));
    error = (struct error){0};
    assert_false(scene_read_text(".", &text, &length, &error));
    assert_int_equal(error.kind, ERROR_USER);
}

TEST_MAIN(scene, cmocka_unit_test(fills_options), cmocka_unit_test(agrees_with_modules),
          cmocka_unit_test(settings_override), cmocka_unit_test(settings_take_out),
          cmocka_unit_test(trajectories_read_back), cmocka_unit_test(echo_reads_back),
          cmocka_unit_test(rich_values), cmocka_unit_test(fields_are_what_is_needed),
          cmocka_unit_test(pairs_of_walls), cmocka_unit_test(two_dimensions),
          cmocka_unit_test(box_from_data_file), cmocka_unit_test(reads_texts))
