/* SPDX-License-Identifier: BSD-3-Clause */
/* Particles from files: what is read, and what is refused with file, line and column. */
#include "tests/scene_by_hand.h"

#include <math.h>
#include <unistd.h>

static const char *const file_name = "test_source.txt";

#define SOURCE_SCENE                                                                                         \
    "box: {lower: [0, 0, 0], upper: [1, 1, 1], leave: error}\n"                                              \
    "duration: 1\n"                                                                                          \
    "contact: {law: hooke}\n"                                                                                \
    "materials: [{name: glass, density: 2500}, {name: steel, density: 8000}]\n"                              \
    "material_pairs: [{restitution: 0.5, k_n: 1e5}]\n"                                                       \
    "particles: {file: test_source.txt, format: table}\n"

/* Parses SOURCE_SCENE with settings in this folder, and reads its particles; NULL with an error. */
static struct particles *read_source(struct error *error, const char *data, const char *const *settings,
                                     struct scene_census *census) {
    struct scene_setting set[16] = {{NULL}};
    int sets = 0;
    for (; settings && settings[sets]; sets++)
        set[sets].text = settings[sets];
    write_file(file_name, data);
    *error = (struct error){0};
    struct scene *scene = scene_parse("test_source.yaml", SOURCE_SCENE, set, sets, error);
    if (!scene)
        return NULL;
    struct particles *particles = particles_with(WITH_ALL, 0);
    struct scene_share share = {.size = 1};
    if (!scene_particles(scene, &share, particles, census, error))
        particles_destroy(&particles);
    scene_free(&scene);
    remove(file_name);
    return particles;
}

static struct particles *good_source(const char *data, const char *const *settings,
                                     struct scene_census *census) {
    struct error error;
    struct particles *particles = read_source(&error, data, settings, census);
    if (!particles)
        fail_msg("%s", error.text);
    return particles;
}

static void reads_headers(void **state) {
    (void)state;
    static const char *const set[] = {"particles.material=glass", NULL};
    static const char *const files[] = {
        "Radius[mm] PosX[m]\tPosY[m] PosZ[m]\r\n 2 0.5 0.25 0.125\r\n\r\n3 0.1 0.2 0.3\r\n",
        "# radius x y z\n2e-3, 0.5, 0.25, 0.125 # the first\n3e-3; 0.1; 0.2; 0.3",
        "z(cm) y x diameter\n12.5 0.25 0.5 0.004\n30 0.2 0.1 0.006\n",
    };
    for (int k = 0; k < 3; k++) {
        struct scene_census census;
        struct particles *p = good_source(files[k], set, &census);
        assert_int_equal(p->owned, 2);
        assert_true(p->state[0].radius == 0.002 && p->state[1].radius == 0.003);
        assert_true(p->state[0].x[0] == 0.5 && p->state[0].x[1] == 0.25 && p->state[0].x[2] == 0.125);
        assert_true(p->state[1].x[2] == 0.3);
        assert_true(p->id[0] == 1 && p->id[1] == 2);
        assert_true(fabs(1 / p->state[0].inverse_mass - 2500 * 4 * M_PI / 3 * 8e-9) < 1e-18);
        assert_int_equal(census.particles, 2);
        particles_destroy(&p);
    }
}

static void reads_columns(void **state) {
    (void)state;
    static const char *const set[] = {"particles.columns=[id, material, x, y, z, radius, vx, vy, vz, "
                                      "omega_x, omega_y, omega_z, density, skip]",
                                      "particles.velocity=[0, 0, -1]", NULL};
    struct particles *p = good_source(
        "7 2 .1 .2 .3 .01 1 2 3 4 5 6 1000 99\n5 glass .4 .5 .6 .02 0 0 0 0 0 0 2000 x\n", set, NULL);
    assert_int_equal(p->owned, 2);
    assert_true(p->id[0] == 7 && p->id[1] == 5);
    assert_true(material_numbers(p)[0] == 1 && material_numbers(p)[1] == 0);
    assert_true(p->state[0].v[0] == 1 && p->state[0].v[2] == 2 && spin_of(p)[0][2] == 6);
    assert_true(fabs(p->state[0].inverse_mass * particles_sphere_mass(0.01, 1000) - 1) < 1e-12);
    particles_destroy(&p);
}

static void selects_and_maps(void **state) {
    (void)state;
    const char *data =
        "radius x y z type\n.01 .1 .1 .1 1\n.02 .3 .3 .3 2\n.01 .5 .5 .5 2\n.04 .7 .7 .7 1\n.01 1 2 3\n";
    static const char *const set[] = {"particles.rows=3",
                                      "particles.skip_rows=1",
                                      "particles.types=[steel, glass]",
                                      "particles.radius_upto=0.03",
                                      "particles.scale=0.5",
                                      "particles.offset=[0.1, 0, 0]",
                                      "particles.radius_above=6 mm",
                                      NULL};
    struct particles *p = good_source(data, set, NULL);
    /* rows 2 to 4 have radii .01, .005, .02 after scaling */
    assert_int_equal(p->owned, 2);
    assert_true(p->state[0].radius == 0.01 && p->state[0].x[0] == 0.25 && p->state[0].x[1] == 0.15);
    assert_true(material_numbers(p)[0] == 0 && material_numbers(p)[1] == 1);
    particles_destroy(&p);
    static const char *const override[] = {"particles.rows=4", "particles.material=steel",
                                           "particles.density=1", NULL};
    p = good_source(data, override, NULL);
    assert_int_equal(p->owned, 4);
    assert_int_equal(material_numbers(p)[0], 1);
    assert_true(fabs(p->state[3].inverse_mass * particles_sphere_mass(0.04, 1) - 1) < 1e-12);
    particles_destroy(&p);
}

/* A first row that begins with a text is no header; the units of a header hold where the scene gives none. */
static void tells_headers_from_rows(void **state) {
    (void)state;
    static const char *const material[] = {"particles.columns=[material, radius, x, y, z]", NULL};
    struct particles *p = good_source("steel .01 .1 .2 .3\nglass .02 .4 .5 .6\n", material, NULL);
    assert_int_equal(p->owned, 2);
    assert_true(material_numbers(p)[0] == 1 && p->state[0].radius == 0.01 && material_numbers(p)[1] == 0);
    particles_destroy(&p);
    static const char *const skipped[] = {"particles.columns=[skip, radius, x, y, z]",
                                          "particles.material=glass", NULL};
    p = good_source("a .01 .1 .2 .3\nb .02 .4 .5 .6\n", skipped, NULL);
    assert_int_equal(p->owned, 2);
    particles_destroy(&p);
    static const char *const named[] = {"particles.columns=[skip, diameter, x, y(cm), z]",
                                        "particles.material=glass", NULL};
    static const char *const files[] = {"Number Width[mm] East(mm) North[mm] Up\n1 20 250 50 .125\n",
                                        "# id d[mm] x[mm] y[mm] z\n1 20 250 50 .125\n"};
    for (int k = 0; k < 2; k++) {
        p = good_source(files[k], named, NULL);
        assert_int_equal(p->owned, 1);
        assert_true(p->state[0].radius == 0.01 && p->state[0].x[0] == 0.25 && p->state[0].x[1] == 0.5 &&
                    p->state[0].x[2] == 0.125);
        particles_destroy(&p);
    }
    static const char *const whole[] = {"particles.columns=[radius(mm), x(m), y(m), z(m)]",
                                        "particles.material=glass", NULL};
    p = good_source("Radius [mm] X [m] Y [m] Z [m]\n2 .1 .2 .3\n", whole, NULL);
    assert_true(p->owned == 1 && p->state[0].radius == 0.002);
    particles_destroy(&p);
}

/* Periodic directions wrap and count; ids of a second file follow those of the first. */
static void wraps_and_numbers(void **state) {
    (void)state;
    static const char *const set[] = {
        "box.periodic=[true, false, false]",
        "particles={sources: [{file: test_source.txt, format: table, material: glass},"
        " {file: test_source.txt, format: table, material: steel, offset: [0, 0, 0.5], ids: new},"
        " {from: single, position: [0.9, 0.9, 0.9], radius: 0.01, material: glass, id: 77},"
        " {from: single, position: [0.8, 0.9, 0.9], radius: 0.01, material: glass}]}",
        NULL};
    struct scene_census census;
    struct particles *p = good_source("id radius x y z\n3 .01 2.25 .1 .1\n9 .01 -.25 .3 .1\n", set, &census);
    assert_int_equal(p->owned, 6);
    assert_true(fabs(p->state[0].x[0] - 0.25) < 1e-15 && particles_images(p)[0][0] == 2);
    assert_true(fabs(p->state[1].x[0] - 0.75) < 1e-15 && particles_images(p)[1][0] == -1);
    assert_true(p->id[0] == 3 && p->id[1] == 9 && p->id[2] == 1 && p->id[3] == 2 && p->id[4] == 77 &&
                p->id[5] == 4);
    assert_int_equal(census.id_max, 77);
    assert_int_equal(census.material[1], 2);
    particles_destroy(&p);
}

/* A group selects by the place to which a centre is wrapped. */
static void selects_where_it_wraps(void **state) {
    (void)state;
    static const char *const set[] = {
        "box={lower: [-1, 0, 0], upper: [1, 1, 1], periodic: [true, false, false]}",
        "particles.material=glass",
        "groups=[{name: left, select: {region: {shape: box, lower: [-1, 0, 0], upper: [0, 1, 1]}}}]", NULL};
    struct particles *p = good_source(
        "radius x y z\n.01 1.25 .1 .1\n.01 -.25 .2 .1\n.01 -1.25 .3 .1\n.01 0 .4 .1\n", set, NULL);
    assert_int_equal(p->owned, 4);
    assert_true(groups_of(p)[0] == 1 && groups_of(p)[1] == 1 && groups_of(p)[2] == 0 && groups_of(p)[3] == 0);
    particles_destroy(&p);
}

static void keeps_what_left(void **state) {
    (void)state;
    static const char *const set[] = {"box.leave=keep", "particles.material=glass", NULL};
    struct particles *p = good_source("radius x y z\n.01 -3 .1 .1\n", set, NULL);
    assert_true(p->state[0].x[0] == -3);
    particles_destroy(&p);
}

/* Lines may be of any length: no number is cut off, neither of a row nor of a header or comment. */
static void reads_long_lines(void **state) {
    (void)state;
    static const char *const set[] = {"particles.material=glass", NULL};
    for (int length = 1000; length <= 100000; length += length < 1040 ? 1 : 33000) {
        static char text[200100];
        snprintf(text, sizeof(text), "radius x%*sy z\n.01 .5 .25%*s.125\n", length, "", length, "");
        struct particles *p = good_source(text, set, NULL);
        assert_int_equal(p->owned, 1);
        assert_true(p->state[0].x[1] == 0.25 && p->state[0].x[2] == 0.125);
        particles_destroy(&p);
        snprintf(text, sizeof(text), "#%*sradius x y z\n.01 .5 .25 .125#%*s\n", length, "", length, "x");
        p = good_source(text, set, NULL);
        assert_true(p->owned == 1 && p->state[0].x[2] == 0.125);
        particles_destroy(&p);
    }
}

#define WITH_SINGLE(id, rest)                                                                                \
    "particles={sources: [{from: single, position: [0.9, 0.9, 0.9], radius: 0.01, material: glass, id: " id  \
    "}, {file: test_source.txt, format: table, material: glass" rest "}, "                                   \
    "{from: lattice, lattice: sc, spacing: 0.1, count: 4, sizes: 0.02, material: glass, "                    \
    "region: {shape: box, lower: [0.5, 0.5, 0.5], upper: [0.8, 0.8, 0.8]}}]}"

/* Ids of files and of the scene stand; new ids leave them out, in the order of the sources. */
static void keeps_ids(void **state) {
    (void)state;
    static const struct {
        const char *set, *data;
        int64_t id[7];
    } cases[] = {
        {WITH_SINGLE("9", ""), "id radius x y z\n3 .01 .1 .1 .1\n1 .01 .2 .1 .1\n", {9, 3, 1, 2, 4, 5, 6}},
        {WITH_SINGLE("2", ""), "radius x y z\n.01 .1 .1 .1\n.01 .2 .1 .1\n", {2, 1, 3, 4, 5, 6, 7}},
        {WITH_SINGLE("0", ""),
         "id radius x y z\n1000 .01 .1 .1 .1\n1 .01 .2 .1 .1\n",
         {2, 1000, 1, 3, 4, 5, 6}},
        {WITH_SINGLE("7", ", ids: new"),
         "id radius x y z\n7 .01 .1 .1 .1\n1 .01 .2 .1 .1\n",
         {7, 1, 2, 3, 4, 5, 6}},
        {WITH_SINGLE("1", ", radius_above: 0.02"),
         "id radius x y z\n8 .03 .1 .1 .1\n2 .01 .2 .1 .1\n9 .03 .3 .1 .1\n",
         {1, 8, 9, 2, 3, 4, 5}},
    };
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        const char *const set[] = {cases[c].set, NULL};
        struct scene_census census;
        struct particles *p = good_source(cases[c].data, set, &census);
        int64_t most = 0;
        assert_int_equal(p->owned, 7);
        for (size_t k = 0; k < 7; k++) {
            assert_int_equal(p->id[k], cases[c].id[k]);
            most = p->id[k] > most ? p->id[k] : most;
        }
        assert_int_equal(census.id_max, most);
        particles_destroy(&p);
    }
}

/* Ids end at 2^62. */
static void refuses_large_ids(void **state) {
    (void)state;
    static const char *const good[] = {WITH_SINGLE("4611686018427387904", ""), NULL};
    static const char *const large[] = {WITH_SINGLE("4611686018427387905", ""), NULL};
    static const char *const twice[] = {WITH_SINGLE("7", ""), NULL};
    struct error error;
    struct particles *p = good_source("radius x y z\n.01 .1 .1 .1\n", good, NULL);
    assert_true(p->owned == 6 && p->id[0] == (int64_t)1 << 62 && p->id[1] == 1);
    particles_destroy(&p);
    assert_null(read_source(&error, "radius x y z\n.01 .1 .1 .1\n", large, NULL));
    assert_non_null(
        strstr(error.text, "particles.sources[0].position: particle 4611686018427387905: ids must"));
    assert_null(read_source(&error, "id radius x y z\n7 .01 .1 .1 .1\n", twice, NULL));
    assert_non_null(
        strstr(error.text, "test_source.txt:2: has the id of particle 7, command line; `ids: new`"));
}

struct bad_data {
    const char *data;
    const char *set[2];
    const char *place, *says;
};

#define HEAD "radius x y z\n.01 .1 .1 .1\n"

static const struct bad_data bad[] = {
    {"", {NULL}, "test_source.txt: ", "holds no particles"},
    {"radius x y z\n", {NULL}, "test_source.txt:1: ", "holds no particles"},
    {".01 .1 .1 .1\n", {NULL}, "test_source.yaml:6: particles.sources[0].columns: ", "no header line"},
    {"radius x y colour\n.01 .1 .1 .1\n",
     {NULL},
     "test_source.txt:1: ",
     "'colour' is not a column; known: id radius"},
    {"radius x y x\n.01 .1 .1 .1\n", {NULL}, "test_source.txt:1: ", "'x' is there twice"},
    {"radius x y\n.01 .1 .1\n", {NULL}, "test_source.txt:1: ", "no column 'z"},
    {"x y z\n.1 .1 .1\n", {NULL}, "test_source.txt:1: ", "one column must be the radius"},
    {"radius[kg] x y z\n.01 .1 .1 .1\n",
     {NULL},
     "test_source.txt:1: ",
     "column 'radius[kg]': not a unit of it"},
    {HEAD "5 .01 .1 .1 0 .06\n", {NULL}, "test_source.txt:3: ", "6 values where there are 4 columns"},
    {HEAD ".01 .2 .2\n", {NULL}, "test_source.txt:3: ", "3 values where there are 4 columns"},
    {HEAD ".01 .2 abc .2\n", {NULL}, "test_source.txt:3: ", "column 3 (y): 'abc' is not a number"},
    {HEAD ".01 .2 .2e .2\n", {NULL}, "test_source.txt:3: ", "column 3 (y): '.2e' is not a number"},
    {HEAD "\n.01 nan .2 .2\n", {NULL}, "test_source.txt:4: ", "column 2 (x): 'nan' is not finite"},
    {HEAD ".01 .2 inf .2\n", {NULL}, "test_source.txt:3: ", "is not finite"},
    {HEAD ".01 .2 1e999 .2\n", {NULL}, "test_source.txt:3: ", "is not finite"},
    {HEAD "0 .2 .2 .2\n", {NULL}, "test_source.txt:3: ", "the radius must be > 0"},
    {HEAD "-.1 .2 .2 .2\n", {NULL}, "test_source.txt:3: ", "the radius must be > 0"},
    {HEAD ".01 .2 .2 1.2\n", {NULL}, "test_source.txt:3: ", "z = 1.2 lies outside of the box (0 to 1)"},
    {HEAD ".01 .2 .2 .2\n.02 .1 .1 .1\n",
     {NULL},
     "test_source.txt:4: ",
     "its centre coincides with that of particle 1, line 2"},
    {"id radius x y z\n5 .01 .1 .1 .1\n5 .01 .2 .2 .2\n",
     {NULL},
     "test_source.txt:3: ",
     "has the id of particle 5, line 2"},
    {"id radius x y z\n0 .01 .1 .1 .1\n",
     {NULL},
     "test_source.txt:2: ",
     "column 1 (id): '0' is not a whole number from 1"},
    {"id radius x y z\n1.5 .01 .1 .1 .1\n", {NULL}, "test_source.txt:2: ", "'1.5' is not a whole number"},
    {"type radius x y z\n3 .01 .1 .1 .1\n",
     {"particles.material=~"},
     "test_source.txt:2: ",
     "type 3, but the scene has 2 materials"},
    {"density radius x y z\n-3 .01 .1 .1 .1\n", {NULL}, "test_source.txt:2: ", "the density must be > 0"},
    {HEAD, {"particles.rows=3"}, "test_source.txt:2: ", "the file has 1 rows; `rows` asks for 3"},
    {HEAD, {"particles.skip_rows=3"}, "test_source.txt:2: ", "ends within the rows that are skipped"},
    {HEAD,
     {"particles.radius_above=1"},
     "test_source.yaml:6: particles.sources[0].radius_upto: ",
     "no particle of test_source.txt"},
    {HEAD,
     {"particles.columns=[radius, x, y, z, vx]"},
     "test_source.txt:2: ",
     "4 values where there are 5 columns"},
    {HEAD,
     {"particles.columns=[radius, x, y, q]"},
     "command line: particles.sources[0].columns: ",
     "'q' is not a column"},
    {"radius[kg] x y z\n.01 .1 .1 .1\n",
     {"particles.columns=[radius, x, y, z]"},
     "test_source.txt:1: ",
     "column 'radius[kg]': not a unit of it"},
    {"radius [mm] x y z\n.01 .1 .1 .1\n",
     {"particles.columns=[radius, x, y, z]"},
     "test_source.txt:1: ",
     "header '[mm]': not a word for each column"},
    {"radius x y 7\n.01 .1 .1 .1\n",
     {"particles.columns=[radius, x, y, z]"},
     "test_source.txt:1: ",
     "column 1 (radius): 'radius' is not a number"},
    {HEAD, {"particles.file=absent.txt"}, "absent.txt: cannot be read", "No such file"},
    {HEAD, {"particles.file=."}, ".: cannot be read", "directory"},
    {HEAD, {"box.periodic=true"}, NULL, NULL},
    {HEAD ".6 .5 .5 .5\n",
     {"box.periodic=true"},
     "test_source.txt:3: ",
     "the diameter (1.2) is not smaller than the periodic box in x (1)"},
    {HEAD ".01 1e30 .5 .5\n", {"box.periodic=true"}, "test_source.txt:3: ", "too many box lengths"},
    {HEAD,
     {"groups=[{name: g, select: {ids: [7]}}]"},
     "command line: groups[0].select: ",
     "no particle belongs to the group 'g'"},
};

static void refuses(void **state) {
    (void)state;
    for (size_t k = 0; k < sizeof(bad) / sizeof(bad[0]); k++) {
        struct error error;
        const char *set[4] = {"particles.material=glass", bad[k].set[0], NULL};
        struct particles *p = read_source(&error, bad[k].data, set, NULL);
        if (!bad[k].place) { /* the good one among them */
            assert_non_null(p);
            particles_destroy(&p);
            continue;
        }
        if (p)
            fail_msg("accepted: %s", bad[k].data);
        if (error.kind != ERROR_USER || strncmp(error.text, bad[k].place, strlen(bad[k].place)) != 0 ||
            !strstr(error.text, bad[k].says))
            fail_msg("%s instead of %s%s", error.text, bad[k].place, bad[k].says);
    }
}

/* Types without a map: by number, and refused where there is no such material. */
static void refuses_types(void **state) {
    (void)state;
    struct error error;
    struct particles *p =
        read_source(&error, "type radius x y z\n2 .01 .1 .1 .1\n3 .01 .2 .2 .2\n", NULL, NULL);
    assert_null(p);
    assert_non_null(strstr(error.text, "test_source.txt:3: type 3, but the scene has 2 materials"));
    static const char *const set[] = {"particles.types=[glass]", NULL};
    assert_null(read_source(&error, "type radius x y z\n2 .01 .1 .1 .1\n", set, NULL));
    assert_non_null(strstr(error.text, "test_source.txt:2: type 2, but `types` names 1 materials"));
    assert_null(read_source(&error, HEAD, NULL, NULL));
    assert_non_null(strstr(error.text, "test_source.txt:2: has no material"));
    static const char *const none[] = {"units=none", "particles.material=glass", NULL};
    assert_null(read_source(&error, "radius[m] x y z\n.01 .1 .1 .1\n", none, NULL));
    assert_non_null(strstr(error.text, "test_source.txt:1: column 'radius[m]' has a unit"));
    static const char *const named[] = {"units=none", "particles.material=glass",
                                        "particles.columns=[radius, x, y, z]", NULL};
    assert_null(read_source(&error, "radius[m] x y z\n.01 .1 .1 .1\n", named, NULL));
    assert_non_null(strstr(error.text, "test_source.txt:1: column 'radius[m]' has a unit"));
}

static void lammps_data(void **state) {
    (void)state;
    static const char *const set[] = {"particles.format=lammps-data", NULL};
    struct error error;
#define LAMMPS_HEAD                                                                                          \
    "comment\n\n2 atoms\n2 atom types\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n\nAtoms # sphere\n\n"
    struct particles *p = good_source(
        LAMMPS_HEAD
        "4 2 0.02 500 .5 .5 .5\n2 1 0.04 600 .7 .7 .7\n\nVelocities\n\n2 1 2 3 0 0 1\n4 0 0 0 0 0 0\n",
        set, NULL);
    assert_int_equal(p->owned, 2);
    size_t four = p->id[0] == 4 ? 0 : 1;
    assert_true(p->id[four] == 4 && p->id[1 - four] == 2);
    assert_true(material_numbers(p)[four] == 1 && p->state[four].radius == 0.01);
    assert_true(p->state[1 - four].v[2] == 3 && spin_of(p)[1 - four][2] == 1);
    assert_true(fabs(p->state[1 - four].inverse_mass * particles_sphere_mass(0.02, 600) - 1) < 1e-12);
    particles_destroy(&p);
    static const char *const cases[][2] = {
        {LAMMPS_HEAD "4 3 0.02 500 .5 .5 .5\n2 1 0.04 600 .7 .7 .7\n", "test_source.txt"},
        {LAMMPS_HEAD "4 2 0 500 .5 .5 .5\n2 1 0.04 600 .7 .7 .7\n", "test_source.txt"},
        {LAMMPS_HEAD "4 2 0.02 500 .5 .5 .5\n4 1 0.04 600 .7 .7 .7\n", "4"},
        {LAMMPS_HEAD "4 2 0.02 500 .5 .5 .5\n", "test_source.txt"},
        {LAMMPS_HEAD "4 2 0.02 500 .5 .5 x\n2 1 0.04 600 .7 .7 .7\n", "test_source.txt:11"},
        {LAMMPS_HEAD "4 2 0.02 500 .5 .5 1.5\n2 1 0.04 600 .7 .7 .7\n", "lies outside of the box"},
    };
    for (size_t k = 0; k < sizeof(cases) / sizeof(cases[0]); k++) {
        p = read_source(&error, cases[k][0], set, NULL);
        if (p)
            fail_msg("accepted case %zu", k);
        assert_int_equal(error.kind, ERROR_USER);
        if (!strstr(error.text, cases[k][1]))
            fail_msg("case %zu: %s", k, error.text);
    }
}

TEST_MAIN(source, cmocka_unit_test(reads_headers), cmocka_unit_test(reads_columns),
          cmocka_unit_test(selects_and_maps), cmocka_unit_test(tells_headers_from_rows),
          cmocka_unit_test(wraps_and_numbers), cmocka_unit_test(selects_where_it_wraps),
          cmocka_unit_test(keeps_what_left), cmocka_unit_test(reads_long_lines), cmocka_unit_test(keeps_ids),
          cmocka_unit_test(refuses_large_ids), cmocka_unit_test(refuses), cmocka_unit_test(refuses_types),
          cmocka_unit_test(lammps_data))
