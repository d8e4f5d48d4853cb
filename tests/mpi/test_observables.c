/* Observables against closed forms and plain sums over the whole cloud, columns and their names, refusals,
 * the file and going on with it. Ranks: 1 2 4 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include "cloud.h"
#include "core/memory.h"
#include "folder.h"
#include "output/observables_kinds.h"
#include "particles/fields.h"
#include "team.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PARTICLES = 123, STAMP = 5 };

static const struct box box = {
    .dimension = 3, .origin = {-5, 100, 0.5}, .edge = {10, 11, 12}, .periodic = {true, false, false}};

struct fixture {
    struct team *team;
    struct folder folder;
    struct cloud cloud;
    struct particles *particles;
    struct integrator_context motion;
    struct force_sums sums;
    struct law_material material[2];
    struct output_view view;
    struct output_run run;
    struct observables_options options;
};

static double value_of(int64_t id, const char *field, int component) {
    return cloud_value(id, fields_find(field), component, STAMP);
}

/* Particle 7 is held: its inverse mass is 0. */
static double inverse_mass(int64_t id) {
    return id == 7 ? 0 : 1 / (1 + value_of(id, "inverse_mass", 0));
}

static void fixture_make(struct fixture *f, struct team *team) {
    *f = (struct fixture){.team = team};
    folder_make(&f->folder, &team->comm);
    cloud_make(&f->cloud, &box, CLOUD_CONTINUOUS, PARTICLES, 2);
    f->particles = particles_create(PARTICLE_FEATURES_ALL, 0);
    for (size_t k = 0; k < f->cloud.n; k++)
        if (k * 7 % 5 % (size_t)team->comm.size == (size_t)team->comm.rank)
            cloud_append(&f->cloud, k, STAMP, f->particles);
    struct particles *p = f->particles;
    for (size_t i = 0; i < p->owned; i++) {
        p->group[i] = 0;
        p->material[i] = p->id[i] % 2;
        p->density[i] = 3;
        p->state[i].inverse_mass = inverse_mass(p->id[i]);
        p->image[i][0] = (int32_t)(p->id[i] % 3) - 1;
        p->image[i][1] = p->image[i][2] = 0;
    }
    f->motion = (struct integrator_context){
        .dt = 0.25, .gravity = {0, 0.5, -2}, .dimension = box.dimension, .groups = 1};
    f->sums = (struct force_sums){.elastic_normal = 1 + team->comm.rank,
                                  .elastic_tangential = 10,
                                  .virial = {1, 2, 3, 4, 5, 6},
                                  .overlap_max = 0.01 * (1 + team->comm.rank),
                                  .contact_sides = 14,
                                  .contacts = 7};
    snprintf(f->material[0].name, sizeof f->material[0].name, "glass");
    snprintf(f->material[1].name, sizeof f->material[1].name, "steel");
    f->view = (struct output_view){.comm = &team->comm,
                                   .particles = p,
                                   .box = &f->cloud.box,
                                   .motion = &f->motion,
                                   .sums = &f->sums,
                                   .taken = 100,
                                   .step = 0};
    f->run = (struct output_run){.directory = f->folder.path, .materials = 2, .material = f->material};
}

static void fixture_free(struct fixture *f) {
    particles_destroy(&f->particles);
    cloud_free(&f->cloud);
    folder_remove(&f->folder, &f->team->comm);
}

static void ask(struct fixture *f, struct observable_request request) {
    f->options.request[f->options.count++] = request;
}

static struct observables *create(struct fixture *f) {
    struct observables *o = NULL;
    struct error error = {0};
    bool good = observables_create(&o, &f->options, &f->view, &f->run, &error);
    team_expect(f->team, good, "%s", error.text);
    return o;
}

/* The value of a column of the last row. */
static double column(struct fixture *f, const struct observables *o, const char *name) {
    for (int c = 0; c < observables_columns(o); c++)
        if (strcmp(observables_column_name(o, c), name) == 0)
            return observables_values(o)[c];
    team_expect(f->team, false, "there is no column %s", name);
    return NAN;
}

static void expect_near(struct fixture *f, const struct observables *o, const char *name, double expected) {
    double value = column(f, o, name), scale = fabs(expected) > 1 ? fabs(expected) : 1;
    team_expect(f->team, fabs(value - expected) <= 1e-12 * scale, "%s is %.17g, not %.17g", name, value,
                expected);
}

static void write_row(struct fixture *f, struct observables *o) {
    struct error error = {0};
    team_expect(f->team, observables_write(o, &f->view, &error), "%s", error.text);
}

/* Full-step velocity and angular velocity of a free particle by their formulas. */
static void full_step(const struct fixture *f, int64_t id, double v[3], double w[3]) {
    double r = f->cloud.radius[id - 1];
    for (int d = 0; d < 3; d++) {
        v[d] = value_of(id, "velocity", d) +
               0.5 * f->motion.dt * (value_of(id, "force", d) * inverse_mass(id) + f->motion.gravity[d]);
        w[d] = value_of(id, "angular_velocity", d) +
               0.5 * f->motion.dt * value_of(id, "torque", d) * 2.5 * inverse_mass(id) / (r * r);
    }
}

static void sums_over_particles(void **state) {
    struct team *team = *state;
    struct fixture f;
    fixture_make(&f, team);
    static const char *const names[] = {"energy_kinetic",   "energy_rotational", "energy_gravity", "momentum",
                                        "angular_momentum", "particles",         "speed_max",      "centre",
                                        "stress",           "energy_balance"};
    for (size_t k = 0; k < sizeof names / sizeof names[0]; k++) {
        struct observable_request request = {0};
        snprintf(request.name, sizeof request.name, "%s", names[k]);
        ask(&f, request);
    }
    struct observables *o = create(&f);
    write_row(&f, o);
    double kinetic = 0, rotational = 0, gravity = 0, momentum[3] = {0}, spin_z = 0, centre = 0, mass_all = 0,
           flux = 0;
    for (int64_t id = 1; id <= PARTICLES; id++) {
        double v[3], w[3], r = f.cloud.radius[id - 1], x[3];
        for (int d = 0; d < 3; d++)
            x[d] = f.cloud.x[id - 1][d] + box.origin[d] + (d == 0 ? (double)(id % 3 - 1) * box.edge[0] : 0);
        double mass = id == 7 ? 3 * 4.0 / 3 * M_PI * r * r * r : 1 / inverse_mass(id);
        centre += mass * x[0];
        mass_all += mass;
        if (id == 7)
            continue;
        full_step(&f, id, v, w);
        kinetic += 0.5 * mass * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        rotational += 0.2 * mass * r * r * (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
        gravity -= mass * (0.5 * x[1] - 2 * x[2]);
        for (int d = 0; d < 3; d++)
            momentum[d] += mass * v[d];
        spin_z += mass * (x[0] * v[1] - x[1] * v[0] + 0.4 * r * r * w[2]);
        flux += mass * v[0] * v[2];
    }
    int size = team->comm.size;
    expect_near(&f, o, "energy_kinetic", kinetic);
    expect_near(&f, o, "energy_rotational", rotational);
    expect_near(&f, o, "energy_gravity", gravity);
    expect_near(&f, o, "momentum_x", momentum[0]);
    expect_near(&f, o, "momentum_z", momentum[2]);
    expect_near(&f, o, "angular_momentum_z", spin_z);
    expect_near(&f, o, "particles", PARTICLES);
    expect_near(&f, o, "centre_x", centre / mass_all);
    expect_near(&f, o, "stress_xz", (flux + 5 * size) / (10.0 * 11 * 12));
    double elastic = size * (size + 1) / 2.0 + 10 * size;
    expect_near(&f, o, "energy_balance", kinetic + rotational + gravity + elastic + (100 - 10) * size);
    team_expect(team, observables_need_sums(o) && observables_need_work(o), "sums are not asked for");
    observables_destroy(&o);
    fixture_free(&f);
    team_finish(team);
}

/* In two dimensions a stress is a force over a length, however thick the box is said to be. */
static void flat_stress(void **state) {
    struct team *team = *state;
    struct fixture f;
    fixture_make(&f, team);
    f.cloud.box.dimension = f.motion.dimension = 2;
    ask(&f, (struct observable_request){.name = "stress"});
    ask(&f, (struct observable_request){.name = "solid_volume"});
    f.options.regions = 1;
    f.options.region[0] = (struct output_region){.name = "middle"};
    double first = 0;
    for (int turn = 0; turn < 2; turn++) {
        f.cloud.box.edge[2] = turn ? 0.01 : 12;
        struct observables *o = create(&f);
        write_row(&f, o);
        double flux = 0;
        for (int64_t id = 1; id <= PARTICLES; id++) {
            double v[3], w[3];
            full_step(&f, id, v, w);
            flux += id == 7 ? 0 : v[0] * v[1] / inverse_mass(id);
        }
        expect_near(&f, o, "stress_xy", (flux + 4 * team->comm.size) / (10.0 * 11));
        first = turn ? first : column(&f, o, "stress_xx");
        expect_near(&f, o, "stress_xx", first);
        team_expect(team, strcmp(observables_column_unit(o, 0), "N/m") == 0, "unit %s",
                    observables_column_unit(o, 0));
        team_expect(team, strcmp(observables_column_unit(o, 6), "m3") == 0, "unit %s of spheres in a plane",
                    observables_column_unit(o, 6));
        observables_destroy(&o);
    }
    fixture_free(&f);
    team_finish(team);
}

/* Regions for stresses: the corner of the box that reaches beyond it, a sphere, cylinders along y. */
static void make_regions(struct fixture *f) {
    f->options.regions = 4;
    f->options.region[0] = (struct output_region){.name = "right",
                                                  .shape = OUTPUT_REGION_BOX,
                                                  .lower = {0, -INFINITY, 3},
                                                  .upper = {INFINITY, 200, INFINITY}};
    f->options.region[1] = (struct output_region){
        .name = "ball", .shape = OUTPUT_REGION_SPHERE, .centre = {0, 105, 6}, .radius = 4};
    f->options.region[2] = (struct output_region){.name = "tube",
                                                  .shape = OUTPUT_REGION_CYLINDER,
                                                  .centre = {0, 105, 6},
                                                  .axis = {0, 3, 0},
                                                  .radius = 3,
                                                  .length = 6};
    f->options.region[3] = f->options.region[2];
    snprintf(f->options.region[3].name, sizeof f->options.region[3].name, "pipe");
    f->options.region[3].length = 0;
}

/* The particles of a region over its volume: the kinetic part. */
static void stress_of_regions(void **state) {
    struct team *team = *state;
    static const char *const names[] = {"stress_right_xz", "stress_ball_xz", "stress_tube_xz",
                                        "stress_pipe_xz"};
    static const double volume[] = {5.0 * 11 * 9.5, 4 * M_PI / 3 * 64, M_PI * 9 * 6, M_PI * 9 * 11};
    struct fixture f;
    fixture_make(&f, team);
    make_regions(&f);
    for (int k = 0; k < 4; k++) {
        struct observable_request request = {.name = "stress"};
        snprintf(request.target, sizeof request.target, "%s", f.options.region[k].name);
        ask(&f, request);
    }
    ask(&f, (struct observable_request){.name = "stress", .target = "right/steel"});
    struct observables *o = create(&f);
    team_expect(team, !observables_need_sums(o), "sums are asked for");
    write_row(&f, o);
    double flux[4] = {0}, steel = 0;
    for (int64_t id = 1; id <= PARTICLES; id++) {
        double v[3], w[3], x[3];
        for (int d = 0; d < 3; d++)
            x[d] = f.cloud.x[id - 1][d] + box.origin[d];
        full_step(&f, id, v, w);
        for (int k = 0; k < 4 && id != 7; k++)
            if (observables_region_contains(&f.options.region[k], x)) {
                flux[k] += v[0] * v[2] / inverse_mass(id);
                steel += k == 0 && id % 2 == 1 ? v[0] * v[2] / inverse_mass(id) : 0;
            }
    }
    for (int k = 0; k < 4; k++)
        expect_near(&f, o, names[k], flux[k] / volume[k]);
    expect_near(&f, o, "stress_right_steel_xz", steel / volume[0]);
    observables_destroy(&o);
    fixture_free(&f);
    team_finish(team);
}

/* Contacts count half for each particle in the region, those with walls whole, also where a particle stands
 * beyond a periodic side. */
static void contacts_of_regions(void **state) {
    struct team *team = *state;
    struct fixture f;
    fixture_make(&f, team);
    make_regions(&f);
    const struct observable_kind *kind = NULL;
    for (int k = 0; k < observables_kinds_count(); k++)
        if (strcmp(observables_get(k)->name, "stress") == 0)
            kind = observables_kind(k);
    struct observable_item item = {.region = &f.options.region[0], .material = -1};
    struct particles *p = f.particles;
    struct force_contact contact[20], wall[20];
    double expected[2] = {0}, part[6] = {0};
    int64_t inside[3] = {0};
    for (size_t k = 0; k < 20; k++) {
        size_t i = k % p->owned, j = (k * 3 + 1) % p->owned;
        contact[k] = (struct force_contact){
            .number_i = i, .number_j = j, .branch = {1, 2, (double)k}, .force = {(double)k, 5, -3}};
        wall[k] = contact[k];
        wall[k].number_j = SIZE_MAX;
        int sides = 0;
        for (int side = 0; side < 2; side++) {
            const double *x = p->state[side ? j : i].x;
            sides += x[0] >= 5 && x[2] >= 2.5;
        }
        bool here = p->state[i].x[0] >= 5 && p->state[i].x[2] >= 2.5;
        inside[sides]++;
        expected[0] += (0.5 * sides + here) * (double)k;
        expected[1] += (0.5 * sides + here) * 0.5 * ((double)(k * k) - 3);
    }
    comm_max_int(&team->comm, inside, 3);
    team_expect(team, inside[0] > 0 && inside[1] > 0 && inside[2] > 0, "the list tests nothing");
    for (size_t i = 0; i < p->owned; i += 2)
        p->state[i].x[0] += i % 4 ? 10 : -10;
    struct contact_list list = {.particle_count = 20, .wall_count = 20, .particle = contact, .wall = wall};
    struct observable_context context = {.view = &f.view, .contacts = &list};
    kind->of_rank(&context, &item, part);
    team_expect(team, fabs(part[0] - expected[0]) < 1e-9, "xx is %g, not %g", part[0], expected[0]);
    team_expect(team, fabs(part[4] - expected[1]) < 1e-9, "xz is %g, not %g", part[4], expected[1]);
    fixture_free(&f);
    team_finish(team);
}

/* Regions whose volume is not known. */
static void stress_wants_a_volume(void **state) {
    struct team *team = *state;
    for (int k = 0; k < 5; k++) {
        struct fixture f;
        struct observables *o = NULL;
        struct error error = {0};
        fixture_make(&f, team);
        make_regions(&f);
        static const char *const names[] = {"right", "ball", "tube", "pipe", "ball"};
        if (k == 0)
            f.options.region[0].lower[0] = 6; /* beyond the box */
        if (k == 1)
            f.options.region[1].radius = 5.5;
        if (k == 2)
            f.options.region[2].centre[0] = 3;
        if (k == 3)
            f.options.region[3].axis[0] = 1; /* tilted, without end */
        if (k == 4) {
            f.cloud.box.dimension = 2; /* misses the plane */
            f.options.region[1].centre[2] = 6.5 + 4;
        }
        struct observable_request request = {.name = "stress"};
        snprintf(request.target, sizeof request.target, "%s", names[k]);
        ask(&f, request);
        team_expect(team, !observables_create(&o, &f.options, &f.view, &f.run, &error), "case %d", k);
        team_expect(team, strstr(error.text, names[k]) && strstr(error.text, "volume"), "%s", error.text);
        fixture_free(&f);
        team_finish(team);
    }
}

static void contacts_and_default(void **state) {
    struct team *team = *state;
    struct fixture f;
    fixture_make(&f, team);
    struct observables *o = create(&f);
    write_row(&f, o);
    int size = team->comm.size;
    expect_near(&f, o, "contacts", 7 * size);
    expect_near(&f, o, "energy_elastic_normal", size * (size + 1) / 2.0);
    column(&f, o, "momentum_y");
    column(&f, o, "energy_dissipated");
    for (int c = 0; c < observables_columns(o); c++)
        team_expect(team, !strstr(observables_column_name(o, c), "tangential"),
                    "a scene without history shows %s", observables_column_name(o, c));
    observables_destroy(&o);
    ask(&f, (struct observable_request){.name = "overlap_max"});
    o = create(&f);
    write_row(&f, o);
    expect_near(&f, o, "overlap_max", 0.01 * size);
    team_expect(team, !observables_need_sums(o), "sums are asked for");
    observables_destroy(&o);
    fixture_free(&f);
    team_finish(team);
}

static void one_particle(void **state) {
    struct team *team = *state;
    struct fixture f;
    fixture_make(&f, team);
    ask(&f, (struct observable_request){.name = "position", .label = "ball", .id = 41, .components = 4});
    ask(&f, (struct observable_request){.name = "velocity", .label = "ball", .id = 41, .components = 5});
    ask(&f, (struct observable_request){.name = "force", .id = 41});
    struct observables *o = create(&f);
    static const char *const expected[] = {"ball_z",        "ball_vx",       "ball_vz",
                                           "particle41_fx", "particle41_fy", "particle41_fz"};
    team_expect(team, observables_columns(o) == 6, "%d columns", observables_columns(o));
    for (int c = 0; c < 6 && c < observables_columns(o); c++)
        team_expect(team, strcmp(observables_column_name(o, c), expected[c]) == 0, "column %s",
                    observables_column_name(o, c));
    team_expect(team, strcmp(observables_column_unit(o, 1), "m/s") == 0, "unit %s",
                observables_column_unit(o, 1));
    for (int turn = 0; turn < 2; turn++) { /* the second time its place is known */
        double v[3], w[3];
        write_row(&f, o);
        full_step(&f, 41, v, w);
        expect_near(&f, o, "ball_z", f.cloud.x[40][2] + 0.5);
        expect_near(&f, o, "ball_vx", v[0]);
        expect_near(&f, o, "particle41_fy", value_of(41, "force", 1));
    }
    /* renumbered, then gone */
    size_t n = f.particles->owned;
    uint32_t *order = memory_allocate(n, sizeof *order, "test");
    for (size_t k = 0; k < n; k++)
        order[k] = (uint32_t)(n - 1 - k);
    particles_reorder(f.particles, order);
    memory_free(order);
    write_row(&f, o);
    expect_near(&f, o, "ball_z", f.cloud.x[40][2] + 0.5);
    uint8_t *remove = memory_allocate_zero(n, 1, "test");
    for (size_t k = 0; k < n; k++)
        remove[k] = f.particles->id[k] == 41;
    particles_remove(f.particles, remove);
    memory_free(remove);
    write_row(&f, o);
    team_expect(team, isnan(column(&f, o, "ball_z")), "a deleted ball has a place");
    observables_destroy(&o);
    fixture_free(&f);
    team_finish(team);
}

static void counts_in_regions(void **state) {
    struct team *team = *state;
    struct fixture f;
    fixture_make(&f, team);
    f.options.regions = 3;
    f.options.region[0] = (struct output_region){.name = "right",
                                                 .shape = OUTPUT_REGION_BOX,
                                                 .lower = {0, -INFINITY, 3},
                                                 .upper = {INFINITY, INFINITY, INFINITY}};
    f.options.region[1] = (struct output_region){
        .name = "ball", .shape = OUTPUT_REGION_SPHERE, .centre = {0, 105, 6}, .radius = 4};
    f.options.region[2] = (struct output_region){.name = "tube",
                                                 .shape = OUTPUT_REGION_CYLINDER,
                                                 .centre = {0, 105, 6},
                                                 .axis = {0, 3, 0},
                                                 .radius = 3,
                                                 .length = 6};
    ask(&f, (struct observable_request){.name = "count"});
    ask(&f, (struct observable_request){.name = "count", .target = "right/steel"});
    ask(&f, (struct observable_request){.name = "solid_volume", .target = "ball", .label = "solid"});
    struct observables *o = create(&f);
    write_row(&f, o);
    double right = 0, steel = 0, ball = 0, tube = 0, solid = 0;
    for (int64_t id = 1; id <= PARTICLES; id++) {
        const double *c = f.cloud.x[id - 1];
        double x = c[0] - 5, y = c[1] + 100, z = c[2] + 0.5, r = f.cloud.radius[id - 1];
        bool in_ball = x * x + (y - 105) * (y - 105) + (z - 6) * (z - 6) < 16;
        right += x >= 0 && z >= 3;
        steel += x >= 0 && z >= 3 && id % 2 == 1;
        ball += in_ball;
        solid += in_ball ? 4.0 / 3 * M_PI * r * r * r : 0;
        tube += x * x + (z - 6) * (z - 6) < 9 && y >= 102 && y < 108;
    }
    team_expect(team, steel > 0 && tube > 0 && ball > 0 && right > steel, "the cloud tests nothing");
    expect_near(&f, o, "count_right", right);
    expect_near(&f, o, "count_right_steel", steel);
    expect_near(&f, o, "count_ball", ball);
    expect_near(&f, o, "count_tube", tube);
    expect_near(&f, o, "solid", solid);
    observables_destroy(&o);
    fixture_free(&f);
    team_finish(team);
}

static void what_is_unknown_is_refused(void **state) {
    struct team *team = *state;
    static const struct {
        struct observable_request request;
        const char *expected; /* in the message */
    } cases[] = {
        {{.name = "enegry"}, "energy_kinetic"},
        {{.name = "wall_force", .target = "lid"}, "there is no wall \"lid\""},
        {{.name = "position", .label = "ball"}, "id of a particle"},
        {{.name = "count", .target = "left"}, "there are: right"},
        {{.name = "count", .target = "right/wood"}, "glass, steel"},
        {{.name = "momentum", .target = "right"}, "takes no target"},
        {{.name = "contacts"}, "two columns"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        struct fixture f;
        struct observables *o = NULL;
        struct error error = {0};
        fixture_make(&f, team);
        f.options.regions = 1;
        f.options.region[0] = (struct output_region){.name = "right"};
        ask(&f, (struct observable_request){.name = "contacts"});
        ask(&f, cases[k].request);
        team_expect(team, !observables_create(&o, &f.options, &f.view, &f.run, &error),
                    "case %zu is accepted", k);
        team_expect(team, error.kind == ERROR_USER && strstr(error.text, cases[k].expected), "case %zu: %s",
                    k, error.text);
        team_expect(team, o == NULL, "case %zu leaves something", k);
        fixture_free(&f);
        team_finish(team);
    }
}

static void read_csv(const struct fixture *f, char *text, size_t size) {
    char path[FOLDER_MAX + 64];
    FILE *file = fopen(folder_file(&f->folder, "observables.csv", path), "r");
    size_t length = file ? fread(text, 1, size - 1, file) : 0;
    text[length] = '\0';
    if (file)
        fclose(file);
}

/* A whole run, and one that was stopped in the middle of a row and resumed from an earlier time: the same
 * file. */
static void the_file_goes_on(void **state) {
    struct team *team = *state;
    struct fixture f;
    fixture_make(&f, team);
    ask(&f, (struct observable_request){.name = "particles"});
    ask(&f, (struct observable_request){.name = "position", .label = "ball", .id = 3, .components = 4});
    struct error error = {0};
    char whole[4096] = "", resumed[4096] = "", path[FOLDER_MAX + 64];
    for (int part = 0; part < 3; part++) {
        int first = part == 2 ? 4 : 0, last = part == 1 ? 6 : 9;
        struct observables *o = create(&f);
        double resume = part == 2 ? 0.1 * 4 : -1;
        team_expect(team, observables_open(o, &team->comm, f.folder.path, resume, &error), "%s", error.text);
        for (int step = first; step < last; step++) {
            f.view.step = (uint64_t)step;
            f.view.time = 0.1 * step;
            write_row(&f, o);
        }
        observables_destroy(&o);
        if (team->comm.rank == 0 && part == 0)
            read_csv(&f, whole, sizeof whole);
        if (team->comm.rank == 0 && part == 1) {
            FILE *file = fopen(folder_file(&f.folder, "observables.csv", path), "a");
            fputs("0.6,12", file);
            fclose(file);
        }
    }
    if (team->comm.rank == 0) {
        read_csv(&f, resumed, sizeof resumed);
        team_expect(team, strncmp(whole, "time[s],particles[1],ball_z[m]\n0,123,", 37) == 0, "%.60s", whole);
        team_expect(team, strcmp(whole, resumed) == 0, "whole:\n%s\nresumed:\n%s", whole, resumed);
    }
    /* other columns do not go into this file */
    ask(&f, (struct observable_request){.name = "contacts"});
    struct observables *o = create(&f);
    team_expect(team, !observables_open(o, &team->comm, f.folder.path, 0.4, &error),
                "other columns are accepted");
    team_expect(team, strstr(error.text, "observables.csv") != NULL, "%s", error.text);
    observables_destroy(&o);
    fixture_free(&f);
    team_finish(team);
}

int main(int argc, char **argv) {
    struct team team;
    team_start(&team, &argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_prestate(sums_over_particles, &team),
        cmocka_unit_test_prestate(flat_stress, &team),
        cmocka_unit_test_prestate(stress_of_regions, &team),
        cmocka_unit_test_prestate(contacts_of_regions, &team),
        cmocka_unit_test_prestate(stress_wants_a_volume, &team),
        cmocka_unit_test_prestate(contacts_and_default, &team),
        cmocka_unit_test_prestate(one_particle, &team),
        cmocka_unit_test_prestate(counts_in_regions, &team),
        cmocka_unit_test_prestate(what_is_unknown_is_refused, &team),
        cmocka_unit_test_prestate(the_file_goes_on, &team),
    };
    int failed = cmocka_run_group_tests_name("observables", tests, NULL, NULL);
    return team_stop(&team) || failed;
}
