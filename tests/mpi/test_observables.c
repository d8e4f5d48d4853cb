/* SPDX-License-Identifier: BSD-3-Clause */
/* Observables against closed forms and plain sums over the whole cloud, columns and their names, refusals,
 * the file and its continuation. Ranks: 1 2 4 */
#include "tests/test.h"

#include "observed.h"

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
    double kinetic = 0, rotational = 0, gravity = 0, momentum[3] = {0}, spin[3] = {0}, centre[3] = {0},
           mass_all = 0, flux = 0, fastest = 0;
    for (int64_t id = 1; id <= PARTICLES; id++) {
        double v[3], w[3], r = f.cloud.radius[id - 1], x[3];
        for (int d = 0; d < 3; d++)
            x[d] = f.cloud.x[id - 1][d] + box.origin[d] + image_of(id, d) * box.edge[d];
        double mass = id == 7 ? 3 * 4.0 / 3 * M_PI * r * r * r : 1 / inverse_mass(id);
        for (int d = 0; d < 3; d++)
            centre[d] += mass * x[d];
        mass_all += mass;
        if (id == 7)
            continue;
        full_step(&f, id, v, w);
        fastest = fmax(fastest, sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
        kinetic += 0.5 * mass * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        rotational += 0.2 * mass * r * r * (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
        gravity -= mass * (0.5 * x[1] - 2 * x[2]);
        for (int d = 0; d < 3; d++)
            momentum[d] += mass * v[d];
        for (int d = 0; d < 3; d++)
            spin[d] += mass * (x[(d + 1) % 3] * v[(d + 2) % 3] - x[(d + 2) % 3] * v[(d + 1) % 3] +
                               0.4 * r * r * w[d]);
        flux += mass * v[0] * v[2];
    }
    int size = team->comm.size;
    expect_near(&f, o, "energy_kinetic", kinetic);
    expect_near(&f, o, "energy_rotational", rotational);
    expect_near(&f, o, "energy_gravity", gravity);
    expect_near(&f, o, "momentum_x", momentum[0]);
    expect_near(&f, o, "momentum_z", momentum[2]);
    expect_near(&f, o, "angular_momentum_x", spin[0]);
    expect_near(&f, o, "angular_momentum_y", spin[1]);
    expect_near(&f, o, "angular_momentum_z", spin[2]);
    expect_near(&f, o, "particles", PARTICLES);
    expect_near(&f, o, "centre_x", centre[0] / mass_all);
    expect_near(&f, o, "centre_y", centre[1] / mass_all);
    expect_near(&f, o, "centre_z", centre[2] / mass_all);
    expect_near(&f, o, "speed_max", fastest);
    expect_near(&f, o, "stress_xz", (flux + 5 * size) / (10.0 * 11 * 12));
    double elastic = size * (size + 1) / 2.0 + 10 * size;
    expect_near(&f, o, "energy_balance", kinetic + rotational + gravity + elastic + (100 - 10) * size);
    team_expect(team, observables_need_sums(o) && observables_need_work(o), "sums are not asked for");
    observables_destroy(&o);
    fixture_free(&f);
    team_finish(team);
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
    for (int turn = 0; turn < 2; turn++) { /* the second time as between rebuilds, beyond the periodic side */
        write_row(&f, o);
        expect_near(&f, o, "count_right", right);
        expect_near(&f, o, "count_right_steel", steel);
        expect_near(&f, o, "count_ball", ball);
        expect_near(&f, o, "count_tube", tube);
        expect_near(&f, o, "solid", solid);
        for (size_t i = 0; i < f.particles->owned; i += 2)
            f.particles->state[i].x[0] += i % 4 ? 10 : -10;
    }
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
        {{.name = "contacts"}, "would be called"},
        {{.name = "momentum", .label = "a_name_of_sixty-two_characters_that_the_component_makes_64_xxx"},
         "label that is shorter"},
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

/* A whole run, and a run that was stopped in the middle of a row and resumed from an earlier time, write the
 * same file. */
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
    /* the file does not accept other columns */
    ask(&f, (struct observable_request){.name = "contacts"});
    struct observables *o = create(&f);
    team_expect(team, !observables_open(o, &team->comm, f.folder.path, 0.4, &error),
                "other columns are accepted");
    team_expect(team, strstr(error.text, "observables.csv") != NULL, "%s", error.text);
    observables_destroy(&o);
    fixture_free(&f);
    team_finish(team);
}

TEAM_MAIN(observables, team_case(sums_over_particles), team_case(contacts_and_default),
          team_case(one_particle), team_case(counts_in_regions), team_case(what_is_unknown_is_refused),
          team_case(the_file_goes_on))
