/* SPDX-License-Identifier: BSD-3-Clause */
/* Packed sources of a scene: what they promise, against brute force. */
#include "base/memory.h"
#include "data/scene/packed.h"
#include "data/scene/region.h"
#include "tests/scene_by_hand.h"

#include <math.h>
#include <omp.h>

/* A scene of two materials in a box from -1 to 9 (z: 11); `rest`: its particles, and more. */
static struct scene *scene_with(const char *box, const char *rest) {
    char text[4096];
    snprintf(text, sizeof text,
             "units: none\nseed: 5\nbox: {%s}\nstep: {count: 1}\ncontact: {law: hooke}\n"
             "materials: [{name: a, density: 1}, {name: b, density: 2}]\n"
             "material_pairs: [{restitution: 1, k_n: 1}]\n%s\n",
             box, rest);
    return good_scene(text, NULL);
}

#define BOX "lower: [-1, -1, -1], upper: [9, 9, 11]"
#define FLAT "dimension: 2, lower: [-1, -1, 0], upper: [9, 9, 0]"

/* The smallest gap between surfaces over all pairs, as part of the smaller radius; pairs of the ids up to `still` are left out. */
static double smallest_gap(const struct box *box, const struct particles *p, int64_t still) {
    double smallest = INFINITY;
    for (size_t i = 0; i < p->owned; i++)
        for (size_t j = 0; j < i; j++) {
            const struct particle_state *a = &p->state[i], *b = &p->state[j];
            if (p->id[i] <= still && p->id[j] <= still)
                continue;
            double gap = sqrt(box_distance2(box, a->x, b->x)) - a->radius - b->radius;
            smallest = fmin(smallest, gap / fmin(a->radius, b->radius));
        }
    return smallest;
}

static double solid_of(const struct scene *scene, const struct particles *p, int material) {
    double sum = 0;
    for (size_t k = 0; k < p->owned; k++)
        if (material_numbers(p)[k] == material)
            sum += scene->box.dimension == 2 ? M_PI * pow(p->state[k].radius, 2)
                                             : 4 * M_PI / 3 * pow(p->state[k].radius, 3);
    return sum;
}

/* Regions of any shape, across a periodic side, too: spheres lie inside, do not overlap, and fill the fraction. */
static void fills_regions(void **state) {
    (void)state;
    static const struct {
        const char *box, *region;
        double fraction;
    } cases[] = {
        {BOX, "{shape: all}", 0.5},
        {BOX ", periodic: true", "{shape: all}", 0.55},
        {BOX ", periodic: [true, false, false]", "{shape: box, lower: [4, 0, 0], upper: [13, 8, 9]}", 0.5},
        {BOX ", periodic: true", "{shape: sphere, centre: [9, 4, 4], radius: 4}", 0.45},
        {BOX, "{shape: cylinder, centre: [4, 4, 5], axis: [1, 1, 2], radius: 3, length: 8}", 0.45},
        {FLAT ", periodic: [true, true, false]", "{shape: all}", 0.75},
        {FLAT, "{shape: sphere, centre: [4, 4, 0], radius: 5}", 0.7},
    };
    for (size_t c = 0; c < sizeof cases / sizeof cases[0]; c++) {
        char particles[512];
        snprintf(
            particles, sizeof particles,
            "particles: {from: packed, material: a, volume_fraction: %g, region: %s, sizes: {law: uniform, "
            "min: 0.3, max: 0.6}}",
            cases[c].fraction, cases[c].region);
        struct scene *scene = scene_with(cases[c].box, particles);
        struct particles *p = scene_all(scene, NULL);
        struct region_space space;
        struct region region = source_region(scene, &scene->source[0].region, &space);
        double volume = region_volume(&region, &space), most = solid_of(scene, p, 0);
        assert_true(smallest_gap(&scene->box, p, 0) > -1e-12);
        assert_true(fabs(most / volume - cases[c].fraction) < 0.6 / volume);
        for (size_t k = 0; k < p->owned; k++) {
            bool inside = false;
            for (int image = 0; image < 27; image++) {
                double x[3];
                for (int d = 0, n = image; d < 3; d++, n /= 3)
                    x[d] = scene->box.origin[d] + p->state[k].x[d] +
                           (scene->box.periodic[d] ? (n % 3 - 1) * scene->box.edge[d] : 0);
                inside = inside || region_contains(&region, &space, x, p->state[k].radius * (1 - 1e-9));
            }
            if (!inside)
                fail_msg("case %zu: a sphere is out", c);
        }
        particles_destroy(&p);
        scene_free(&scene);
    }
}

/* Single spheres, overlapping ones too, and those of a lattice stay; two packed sources and a random one share what is left. */
static const char several[] =
    "particles:\n  sources:\n"
    "  - {from: single, position: [2, 2, 2], radius: 2, material: b}\n"
    "  - {from: single, position: [4, 2, 2], radius: 1.5, material: b}\n"
    "  - {from: lattice, lattice: sc, spacing: 2, sizes: 1, material: b, region: {shape: box, lower: [-1, "
    "-1, 9], "
    "upper: [9, 9, 11]}}\n"
    "  - {from: packed, sizes: {law: uniform, min: 0.3, max: 0.6}, volume_fraction: 0.2, material: a}\n"
    "  - {from: packed, sizes: 0.2, count: 300, material: a, velocity_sigma: 2}\n"
    "  - {from: packed, meets: yield, sizes: 0.15, count: 500, material: b, region: {shape: box, lower: [0, "
    "0, 3], "
    "upper: [9, 9, 9]}}\n"
    "  - {from: random, sizes: 0.1, count: 50, material: a}\n";

static void meets_others(void **state) {
    (void)state;
    enum { STILL = 27 };
    struct scene *scene = scene_with(BOX ", periodic: [true, true, false]", several);
    struct scene_census census;
    struct particles *p = scene_all(scene, &census);
    assert_true(smallest_gap(&scene->box, p, STILL) > -1e-12);
    assert_true(census.material[1] == STILL + 500 && census.material[0] > 350);
    size_t small = 0, random = 0;
    double momentum[3] = {0};
    for (size_t k = 0; k < p->owned; k++) {
        const struct particle_state *s = &p->state[k];
        if (p->id[k] <= 2)
            assert_true(s->x[0] == (p->id[k] == 1 ? 3 : 5) && s->x[1] == 3 && s->x[2] == 3);
        small += s->radius == 0.2;
        random += s->radius == 0.1;
        for (int d = 0; d < 3; d++)
            momentum[d] += s->v[d];
    }
    assert_true(small == 300 && random == 50);
    for (int d = 0; d < 3; d++)
        assert_true(fabs(momentum[d]) < 1e-9);
    particles_destroy(&p);
    scene_free(&scene);
}

/* A ball in the middle of the box, as a wall. */
static bool ball(void *context, const double x[3], double radius) {
    const double *middle = context;
    double square = 0;
    for (int d = 0; d < 3; d++)
        square += (x[d] - middle[d]) * (x[d] - middle[d]);
    return square < (3 + radius) * (3 + radius);
}

static void keeps_clear_of_walls(void **state) {
    (void)state;
    struct scene *scene =
        scene_with(BOX, "particles: {from: packed, material: a, sizes: 0.4, volume_fraction: 0.35}");
    double middle[3] = {5, 5, 6};
    struct packed_report report;
    struct scene_share share = {.size = 1, .taken = ball, .context = middle, .packed = &report};
    struct particles *p = particles_with(WITH_ALL, 0);
    struct error error = {0};
    assert_true(scene_particles(scene, &share, p, NULL, &error));
    assert_true(smallest_gap(&scene->box, p, 0) > -1e-12);
    for (size_t k = 0; k < p->owned; k++)
        assert_false(ball(middle, p->state[k].x, p->state[k].radius));
    assert_true(report.sweeps > 1 && report.overlap == 0 && report.started == 0);
    particles_destroy(&p);
    scene_free(&scene);
}

/* The particles in the order of their ids. */
static struct particle_state *by_id(const struct particles *p, struct particle_state *all) {
    for (size_t k = 0; k < p->owned; k++)
        all[p->id[k] - 1] = p->state[k];
    return all;
}

/* The same bits for any number of ranks and threads. */
static void same_on_any_layout(void **state) {
    (void)state;
    struct scene *scene = scene_with(BOX ", periodic: [true, true, false]", several);
    int threads = omp_get_max_threads();
    struct particles *whole = scene_all(scene, NULL);
    size_t bytes = whole->owned * sizeof(struct particle_state);
    struct particle_state *first = memory_allocate_zero(whole->owned, sizeof *first, "spheres");
    struct particle_state *again = memory_allocate_zero(whole->owned, sizeof *again, "spheres");
    by_id(whole, first);
    for (int size = 1; size <= 3; size++) {
        size_t total = 0;
        memset(again, 0, bytes);
        omp_set_num_threads(size);
        for (int rank = 0; rank < size; rank++) {
            struct scene_share share = {.rank = rank, .size = size};
            struct particles *p = particles_with(WITH_ALL, 0);
            struct error error = {0};
            assert_true(scene_particles(scene, &share, p, NULL, &error));
            by_id(p, again);
            total += p->owned;
            particles_destroy(&p);
        }
        assert_int_equal(total, whole->owned);
        assert_memory_equal(first, again, bytes);
    }
    omp_set_num_threads(threads);
    memory_free(first);
    memory_free(again);
    particles_destroy(&whole);
    scene_free(&scene);
}

/* Count and fraction without a box give a cube, or a square, which the effective scene states. */
static void finds_the_box(void **state) {
    (void)state;
    static const char *const boxes[] = {"periodic: true", "dimension: 2, periodic: [true, true, false]"};
    for (int k = 0; k < 2; k++) {
        struct scene *scene = scene_with(
            boxes[k], "particles: {from: packed, material: a, count: 300, volume_fraction: 0.5, sizes: {law: "
                      "power, min: 1, max: 3, exponent: -2}}");
        struct particles *p = scene_all(scene, NULL);
        assert_float_equal(solid_of(scene, p, 0) / pow(scene->box.edge[0], 3 - k), 0.5, 1e-12);
        assert_true(scene->box.edge[1] == scene->box.edge[0] && scene->box_lower[0] == 0);
        assert_true(smallest_gap(&scene->box, p, 0) > -1e-12);
        char *text = scene_echo(scene);
        struct scene *again = good_scene(text, NULL);
        struct particles *q = scene_all(again, NULL);
        assert_int_equal(p->owned, q->owned);
        assert_memory_equal(p->state, q->state, p->owned * sizeof *p->state);
        memory_free(text);
        particles_destroy(&p);
        particles_destroy(&q);
        scene_free(&scene);
        scene_free(&again);
    }
}

/* What cannot be is refused, with its key. */
static void refusals(void **state) {
    (void)state;
    static const char *const bad[][3] = {
        {BOX, "sizes: 0.5, volume_fraction: 0.8, sweeps: 30", "sources[0].from: after 30 sweeps"},
        {BOX, "sizes: 0.5, count: 5000", "sources[0].count: the spheres' volume is"},
        {BOX ", periodic: true", "sizes: 4.5, count: 1", "at least 2.5 times as wide"},
        {BOX, "sizes: 5.5, count: 1", "sources[0].region: the region is too small for spheres of radius 5.5"},
        {BOX, "sizes: 0.1, count: 150000000", "fewer than 134217728"},
        {BOX, "sizes: 0.3, count: 2000, meets: yield, region: {shape: sphere, centre: [4, 4, 4], radius: 2}",
         "sources[0].from: the spheres do not fit between those of other sources"}};
    for (size_t k = 0; k < sizeof bad / sizeof bad[0]; k++) {
        char text[512];
        struct error error = {0};
        struct scene_share share = {.size = 1};
        struct particles *p = particles_with(WITH_ALL, 0);
        snprintf(text, sizeof text, "particles: {from: packed, material: a, %s}", bad[k][1]);
        struct scene *scene = scene_with(bad[k][0], text);
        assert_false(scene_particles(scene, &share, p, NULL, &error));
        assert_int_equal(error.kind, ERROR_USER);
        if (!strstr(error.text, bad[k][2]))
            fail_msg("no '%s' in: %s", bad[k][2], error.text);
        particles_destroy(&p);
        scene_free(&scene);
    }
}

TEST_MAIN(packed, cmocka_unit_test(fills_regions), cmocka_unit_test(meets_others),
          cmocka_unit_test(keeps_clear_of_walls), cmocka_unit_test(same_on_any_layout),
          cmocka_unit_test(finds_the_box), cmocka_unit_test(refusals))
