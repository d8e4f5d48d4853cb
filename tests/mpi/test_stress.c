/* SPDX-License-Identifier: BSD-3-Clause */
/* The stress against closed forms: in two dimensions, in regions, and in regions without a volume.
 * Ranks: 1 2 4 */
#include "tests/test.h"

#include "observed.h"

/* In two dimensions a stress is a force over a length, whatever the thickness of the box. */
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

/* Regions for stresses: a corner that reaches beyond the box, a sphere, cylinders along y. */
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

TEAM_MAIN(stress, team_case(flat_stress), team_case(stress_of_regions), team_case(contacts_of_regions),
          team_case(stress_wants_a_volume))
