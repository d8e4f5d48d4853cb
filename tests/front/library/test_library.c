/* SPDX-License-Identifier: BSD-3-Clause */
/* The public library: pairs of a cloud against all pairs. */
#include "tests/test.h"

#include "base/random.h"
#include "scree.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SPHERES = 600 };

struct cloud {
    double position[SPHERES][3], radius[SPHERES];
    struct scree_spheres spheres;
};

static void cloud_fill(struct cloud *c) {
    for (int k = 0; k < SPHERES; k++) {
        struct random_sequence random = random_sequence(3, RANDOM_TEST, (uint64_t)k);
        for (int d = 0; d < 3; d++)
            c->position[k][d] = 12 * random_uniform(&random);
        c->radius[k] = k < 3 ? 4 : 0.2 + 0.3 * random_uniform(&random);
    }
    c->spheres =
        (struct scree_spheres){SPHERES, c->position[0], c->radius, {12, 12, 12}, {true, true, false}, 3};
}

static size_t count_all(const struct cloud *c, double margin) {
    size_t n = 0;
    for (int i = 0; i < SPHERES; i++)
        for (int j = i + 1; j < SPHERES; j++)
            for (int image = 0; image < 9; image++) {
                double shift[3] = {12 * (image % 3 - 1), 12 * (image / 3 - 1), 0}, d2 = 0;
                for (int d = 0; d < 3; d++)
                    d2 += pow(c->position[j][d] + shift[d] - c->position[i][d], 2);
                n += sqrt(d2) <= c->radius[i] + c->radius[j] + margin;
            }
    return n;
}

static void test_every_index_finds_all_pairs(void **state) {
    (void)state;
    static struct cloud c;
    const char *const names[] = {"brute", "linkcell", "multi", "bytype", "hgrid"};
    cloud_fill(&c);
    size_t all = count_all(&c, 0.1);
    assert_true(all > 300);
    for (int k = 0; k < 5; k++) {
        struct scree_pair *pairs = NULL;
        size_t found = 0;
        char why[300] = "";
        assert_true(scree_pairs(names[k], &c.spheres, 0.1, 2, &pairs, &found, why, sizeof why));
        assert_int_equal(found, all);
        for (size_t p = 0; p < found; p++) {
            double d2 = 0;
            for (int d = 0; d < 3; d++)
                d2 +=
                    pow(c.position[pairs[p].j][d] + 12.0 * pairs[p].image[d] - c.position[pairs[p].i][d], 2);
            assert_true(sqrt(d2) <= c.radius[pairs[p].i] + c.radius[pairs[p].j] + 0.1 + 1e-12);
        }
        scree_free(pairs);
    }
}

static void test_nonsense_is_refused_with_a_reason(void **state) {
    (void)state;
    static struct cloud c;
    struct scree_pair *pairs = NULL;
    size_t found = 0;
    char why[300] = "";
    cloud_fill(&c);
    assert_false(scree_pairs("octree", &c.spheres, 0.1, 1, &pairs, &found, why, sizeof why));
    assert_non_null(strstr(why, "hgrid"));
    c.radius[7] = 6;
    assert_false(scree_pairs("hgrid", &c.spheres, 0.1, 1, &pairs, &found, why, sizeof why));
    assert_non_null(strstr(why, "sphere 7"));
    c.radius[7] = NAN;
    assert_false(scree_pairs("hgrid", &c.spheres, 0.1, 1, &pairs, &found, NULL, 0));
}

static const char single[] =
    "units: none\nbox: {lower: [0, 0, 0], upper: [9, 9, 9]}\nstep: {dt: 0.001, count: 5}\n"
    "contact: {law: hooke}\nmaterials: [{name: a, density: 1}]\nmaterial_pairs: [{k_n: 1, restitution: 1}]\n"
    "particles: {from: single, position: [4, 4, 4], radius: 1}\n"
    "observables: {list: [{name: momentum}]}\n";

/* Calls that a force must not make, and those that it may. */
static void force_that_runs(void *context, struct scree_simulation *simulation) {
    int *refused = context;
    struct scree_error error;
    struct scree_field field;
    double values[8];
    struct scree_simulation *same = simulation;
    *refused += !scree_step(simulation, 1, &error) && error.status == SCREE_USER;
    *refused += !scree_observe(simulation, values, NULL);
    *refused += !scree_checkpoint(simulation, ".", NULL);
    scree_destroy(&same);
    *refused += same != NULL;
    assert_true(scree_field(simulation, "force", &field));
    assert_true(scree_steps_left(simulation) <= 5 && scree_columns(simulation) <= 3);
    assert_non_null(scree_scene(simulation));
}

static void test_a_simulation_refuses_what_its_header_does_not_allow(void **state) {
    (void)state;
    int refused = 0;
    struct scree_error error;
    struct scree_options options = {.force = force_that_runs, .force_context = &refused};
    struct scree_simulation *simulation = scree_create(NULL, single, &options, &error);
    if (simulation == NULL)
        fail_msg("%s", error.text);
    assert_int_equal(refused, 4); /* in the first forces */
    assert_true(scree_step(simulation, 2, &error));
    assert_int_equal(refused, 12);
    assert_int_equal(scree_step_number(simulation), 2);
    assert_int_equal(scree_columns(simulation), 3);
    assert_non_null(scree_column_name(simulation, 2));
    assert_null(scree_column_name(simulation, 100000));
    assert_null(scree_column_unit(simulation, -1));
    assert_null(scree_field_name(simulation, 100000));
    assert_null(scree_row(simulation, 100000));
    assert_false(scree_field(simulation, NULL, &(struct scree_field){0}));
    assert_false(scree_add(simulation, NULL, 1, &error));
    assert_false(
        scree_add(simulation, &(struct scree_particle){.position = {1, 1, NAN}, .radius = 1}, 1, &error));
    assert_false(scree_checkpoint(simulation, NULL, &error));
    scree_destroy(&simulation);
    assert_null(simulation);
    scree_destroy(&simulation);
    scree_destroy(NULL);
    assert_false(scree_step(simulation, 1, &error));
    assert_int_equal(error.status, SCREE_USER);
    assert_true(scree_particles(simulation) == 0 && scree_steps_left(simulation) == 0 &&
                scree_columns(simulation) == 0);
    assert_string_equal(scree_stage(simulation), "");
    scree_changed(simulation);
    scree_delete(simulation, NULL, 1);
    const char *const none[] = {NULL};
    options = (struct scree_options){.set = none, .sets = 1};
    assert_null(scree_create(NULL, single, &options, &error));
    assert_null(scree_create(NULL, NULL, NULL, &error));
}

static void test_a_rock_too_large_for_the_box_is_refused(void **state) {
    (void)state;
    static const char rocks[] =
        "units: none\nbox: {lower: [0, 0, 0], upper: [9, 9, 9], periodic: true}\n"
        "step: {dt: 0.001, count: 5}\ncontact: {law: hooke}\nmaterials: [{name: a, density: 1}]\n"
        "material_pairs: [{k_n: 1, restitution: 1}]\n"
        "particles: {from: single, position: [4, 4, 4], radius: 1}\n"
        "bodies: {shapes: [{name: rock, random: {corners: 12}}]}\n";
    struct scree_error error;
    struct scree_particle grain = {.position = {1, 1, 1}, .radius = 4.6};
    struct scree_simulation *simulation = scree_create(NULL, rocks, NULL, &error);
    if (simulation == NULL)
        fail_msg("%s", error.text);
    assert_false(scree_add(simulation, &grain, 1, &error));
    assert_non_null(
        strstr(error.text, "the rock 'rock' has a ball of radius 4.6, as large as a periodic edge"));
    grain.radius = 0.5;
    assert_true(scree_add(simulation, &grain, 1, &error) && scree_step(simulation, 1, &error));
    scree_destroy(&simulation);
}

static void test_lengths_beyond_numbers_are_refused(void **state) {
    (void)state;
    static struct cloud c;
    struct scree_pair *pairs = NULL;
    size_t found = 0;
    char why[400] = "";
    for (int k = 0; k < 4; k++) {
        cloud_fill(&c);
        c.spheres.periodic[0] = c.spheres.periodic[1] = false;
        c.radius[9] = k == 0 ? 1e-320 : k == 1 ? 1e300 : c.radius[9];
        c.position[9][k == 2 ? 0 : 2] = k < 2 ? 1 : k == 2 ? 1e300 : -1e17;
        assert_false(scree_pairs("hgrid", &c.spheres, 0.1, 1, &pairs, &found, why, sizeof why));
        assert_non_null(strstr(why, "sphere "));
    }
    assert_false(scree_pairs(NULL, &c.spheres, 0.1, 1, &pairs, &found, why, sizeof why));
    assert_false(scree_pairs("hgrid", NULL, 0.1, 1, &pairs, &found, why, sizeof why));
    assert_false(scree_pairs("hgrid", &c.spheres, 0.1, 1, NULL, &found, why, sizeof why));
}

TEST_MAIN(library, cmocka_unit_test(test_every_index_finds_all_pairs),
          cmocka_unit_test(test_nonsense_is_refused_with_a_reason),
          cmocka_unit_test(test_a_simulation_refuses_what_its_header_does_not_allow),
          cmocka_unit_test(test_a_rock_too_large_for_the_box_is_refused),
          cmocka_unit_test(test_lengths_beyond_numbers_are_refused))
