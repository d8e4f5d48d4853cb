/* SPDX-License-Identifier: BSD-3-Clause */
/* Scenes with very many entries, and sources that ask for too much: answered in a moment. */
#include "tests/scene_by_hand.h"

#include <math.h>
#include <time.h>

/* Seconds of this processor since the start of the program. */
static double seconds(void) {
    return (double)clock() / CLOCKS_PER_SEC;
}

/* Seconds that it takes to refuse a scene of a first line and `count` times a pattern with a number, the best
 * of three, or of one where sanitizers make all slow. */
static double time_refusal(const char *first, const char *pattern, const char *last, int count) {
    size_t room = strlen(first) + strlen(last) + (strlen(pattern) + 12) * (size_t)count + 1;
    char *text = memory_allocate(room, 1, "test");
    char *end = text + sprintf(text, "%s", first);
    for (int k = 0; k < count; k++) {
        end += sprintf(end, "%.*s%d", (int)strcspn(pattern, "@"), pattern, k);
        end += sprintf(end, "%s", strchr(pattern, '@') + 1);
    }
    sprintf(end, "%s", last);
    double best = INFINITY;
    int tries = getenv("SCREE_SHORT") ? 1 : 3;
    for (int k = 0; k < tries; k++) {
        struct error error;
        double began = seconds();
        assert_null(scene_from(&error, text, NULL));
        best = fmin(best, seconds() - began);
        assert_int_equal(error.kind, ERROR_USER);
    }
    memory_free(text);
    return best;
}

/* Eight times the entries take eight times the instructions, and with caches and new pages up to some 35 times the
 * time. Who compares each with all others would take 64 times the time, and seconds. */
static void time_grows_with_entries(void **state) {
    (void)state;
    static const char *const cases[][3] = {
        {"", "k@: 1\n", ""},
        {"particles:\n", "  k@: 1\n", ""},
        {"particles: {", "k@: 1, ", "k: 1}\n"},
        {"walls:\n", "  - {name: k@}\n", ""},
        {"walls:\n", "  - k@\n", ""},
        {"gravity: [", "@, ", "0]\n"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        int entries = getenv("SCREE_SHORT") ? 2500 : 10000;
        double few = time_refusal(cases[k][0], cases[k][1], cases[k][2], entries);
        double many = time_refusal(cases[k][0], cases[k][1], cases[k][2], 8 * entries);
        if (!(many < 48 * few + 0.5))
            fail_msg("case %zu: %.3g s for %d entries, %.3g s for eight times as many", k, few, entries,
                     many);
    }
}

/* A text of millions of values is refused where it has become too long, whatever follows. */
static void refuses_long_texts(void **state) {
    (void)state;
    static const char entry[] = "  - {name: m, density: 1}\n";
    struct error error;
    char *text = memory_allocate(64 + 50000 * sizeof entry, 1, "test"),
         *end = text + sprintf(text, "materials:\n");
    for (int k = 0; k < 50000; k++)
        end += sprintf(end, "%s", entry);
    sprintf(end, "  - {name: [\n"); /* not YAML: is never read */
    assert_null(scene_from(&error, text, NULL));
    assert_non_null(strstr(error.text, ":40001: more than 200000 keys and values up to here"));
    memory_free(text);
}

/* What a source would have to work on for minutes is refused at once, and names what is possible. */
static void refuses_too_much(void **state) {
    (void)state;
#define SOURCE(text) "particles={material: glass, from: " text "}"
    static const char *const cases[][2] = {
        {SOURCE("lattice, lattice: sc, spacing: 5 um, sizes: 2 um"),
         "spacing: gives about 1.6e+10 spheres; at most 200000000"},
        {SOURCE("lattice, lattice: fcc, spacing: 8 um, sizes: 2 um"), "spacing: gives about 5.5e+09 spheres"},
        {SOURCE("lattice, lattice: sc, spacing: 1e-200, sizes: 1e-201"),
         "spacing: gives about 1e+45 spheres"},
        {SOURCE("lattice, lattice: sc, spacing: 5 um, sizes: 2 um, count: 300000000"),
         "count: gives about 3e+08 spheres"},
        {SOURCE("lattice, lattice: sc, spacing: 2 um, sizes: 1 um, region: {shape: cylinder, centre: [5 mm, "
                "5 mm, 10 mm], "
                "axis: [1, 1, 1], radius: 50 um, length: 9 mm}"),
         "too many to look at"},
        {SOURCE("random, volume_fraction: 0.3, sizes: 4 um"),
         "volume_fraction: needs about 2.2e+09 spheres; at most 200000000"},
        {SOURCE("random, volume_fraction: 0.3, sizes: {law: power, min: 1 um, max: 100 um, exponent: -4}"),
         "volume_fraction: needs about"},
        {SOURCE("random, volume_fraction: 0.3, sizes: {law: lognormal, mean: 4 um, width: 0.2, min: 1 um, "
                "max: 9 um}"),
         "volume_fraction: needs about"},
        {SOURCE("random, count: 200000001, sizes: 1 um"), "count: more than 200000000 spheres"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        const char *const set[] = {cases[k][0], NULL};
        struct scene *scene = good_scene(GOOD_SCENE, set);
        struct particles *particles = particles_with(WITH_ALL, 0);
        struct scene_share share = {.size = 1};
        struct error error = {0};
        double began = seconds();
        assert_false(scene_particles(scene, &share, particles, NULL, &error));
        if (error.kind != ERROR_USER || !strstr(error.text, cases[k][1]))
            fail_msg("case %zu: %s", k, error.text);
        if (seconds() - began > 10)
            fail_msg("case %zu is refused after %.3g s", k, seconds() - began);
        particles_destroy(&particles);
        scene_free(&scene);
    }
}

/* A few spheres of a fine lattice are found without a walk over all of its places. */
static void takes_few_of_many(void **state) {
    (void)state;
    const char *const set[] = {SOURCE("lattice, lattice: sc, spacing: 5 um, sizes: 2 um, count: 1000"), NULL};
    struct scene *scene = good_scene(GOOD_SCENE, set);
    struct particles *particles = scene_all(scene, NULL);
    assert_int_equal(particles->owned, 1000);
    particles_destroy(&particles);
    scene_free(&scene);
}

struct told {
    int calls;
    double part;
};

static void count_calls(void *context, const char *what, double part) {
    struct told *told = context;
    assert_true(part > 0 && part <= 1 && part >= (strcmp(what, "spheres placed") == 0 ? 0 : told->part));
    told->calls++;
    told->part = part;
}

/* Whoever places many spheres tells how far it is. */
static void tells_progress(void **state) {
    (void)state;
    const char *const set[] = {SOURCE("random, volume_fraction: 0.05, sizes: 100 um"), NULL};
    struct scene *scene = good_scene(GOOD_SCENE, set);
    struct particles *particles = particles_with(WITH_ALL, 0);
    struct told told = {0};
    struct scene_share share = {.size = 1, .context = &told, .progress = count_calls};
    struct error error = {0};
    assert_true(scene_particles(scene, &share, particles, NULL, &error));
    assert_true(particles->owned > 20000 && told.calls >= 8 && told.part > 0.8);
    particles_destroy(&particles);
    scene_free(&scene);
}

TEST_MAIN(scene_large, cmocka_unit_test(time_grows_with_entries), cmocka_unit_test(refuses_long_texts),
          cmocka_unit_test(refuses_too_much), cmocka_unit_test(takes_few_of_many),
          cmocka_unit_test(tells_progress))
