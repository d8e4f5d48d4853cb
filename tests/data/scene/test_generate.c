/* SPDX-License-Identifier: BSD-3-Clause */
/* Particles that the program makes itself: lattices and random packings. */
#include "tests/scene_by_hand.h"

#include <math.h>

/* A box of 8 x 10 x 12 in units of nothing, one material of density 1. */
static struct scene *scene_with(const char *box, const char *particles) {
    char text[2048];
    snprintf(text, sizeof(text),
             "units: none\nseed: 5\nbox: {lower: [-1, 0, 2], upper: [7, 10, 14]%s}\nstep: {count: "
             "1}\ncontact: {law: hooke}\n"
             "materials: [{name: a, density: 1}, {name: b, density: 2}]\nmaterial_pairs: [{restitution: 1, "
             "k_n: 1}]\n"
             "groups: [{name: g, motion: frozen, select: {region: {shape: sphere, centre: [3, 5, 8], radius: "
             "3}}}]\n%s",
             box, particles);
    return good_scene(text, NULL);
}

/* The smallest gap between surfaces over all pairs, periodic images counted. */
static double smallest_gap(const struct box *box, const struct particles *p) {
    double smallest = INFINITY;
    for (size_t i = 0; i < p->owned; i++)
        for (size_t j = 0; j < i; j++) {
            double sum = 0;
            for (int d = 0; d < 3; d++) {
                double gap = fabs(p->state[i].x[d] - p->state[j].x[d]);
                gap = box->periodic[d] ? fmin(gap, box->edge[d] - gap) : gap;
                sum += gap * gap;
            }
            smallest = fmin(smallest, sqrt(sum) - p->state[i].radius - p->state[j].radius);
        }
    return smallest;
}

/* All spheres lie inside the box where it is not periodic. */
static void assert_inside(const struct box *box, const struct particles *p) {
    for (size_t i = 0; i < p->owned; i++)
        for (int d = 0; d < box->dimension; d++) {
            double margin = box->periodic[d] ? 0 : p->state[i].radius * (1 - 1e-6);
            assert_true(p->state[i].x[d] >= margin && p->state[i].x[d] <= box->edge[d] - margin);
        }
}

static void check_lattice(const char *box, const char *kind, uint64_t places) {
    char text[256];
    snprintf(text, sizeof(text),
             "particles: {from: lattice, lattice: %s, spacing: 1, sizes: 0.5, material: a}\n", kind);
    struct scene *scene = scene_with(box, text);
    struct scene_census census;
    struct particles *particles = scene_all(scene, &census);
    assert_int_equal(census.particles, places);
    assert_true(fabs(smallest_gap(&scene->box, particles)) < 1e-9);
    assert_inside(&scene->box, particles);
    particles_destroy(&particles);
    scene_free(&scene);
}

static void lattices(void **state) {
    (void)state;
    check_lattice("", "sc", 8 * 10 * 12);
    check_lattice(", periodic: true", "sc", 8 * 10 * 12);
    /* whole cells of sqrt(2): 5 x 7 x 8, four spheres each */
    check_lattice(", periodic: true", "fcc", 4 * 5 * 7 * 8);
    /* cells of 1 x sqrt(3) x sqrt(8/3): 8 x 5 x 7, four spheres each */
    check_lattice(", periodic: true", "hcp", 4 * 8 * 5 * 7);
}

/* Small spheres far apart: the lattice goes on up to the open side that still has room for one. */
static void lattice_fills_an_open_box(void **state) {
    (void)state;
    struct scene_census census;
    struct scene *scene =
        scene_with("", "particles: {from: lattice, lattice: sc, spacing: 0.75, sizes: 0.1, material: a}\n");
    struct particles *p = scene_all(scene, &census);
    uint64_t expected = 1;
    for (int d = 0; d < 3; d++)
        expected *= (uint64_t)floor((scene->box.edge[d] - 0.2) / 0.75 + 1e-9) + 1;
    assert_int_equal(census.particles, expected);
    assert_inside(&scene->box, p);
    particles_destroy(&p);
    scene_free(&scene);
}

/* Equal spheres of fcc and hcp have twelve neighbours at one spacing; sc six. */
static void neighbours_of_lattices(void **state) {
    (void)state;
    static const char *const kinds[] = {"sc", "fcc", "hcp"};
    static const double boxes[][3] = {{6, 6, 6},
                                      {4 * M_SQRT2, 4 * M_SQRT2, 4 * M_SQRT2},
                                      {6, 4 * 1.7320508075688772, 4 * 1.6329931618554521}};
    static const int expected[] = {6, 12, 12};
    for (int k = 0; k < 3; k++) {
        char text[1024];
        snprintf(text, sizeof(text),
                 "units: none\nbox: {lower: [0, 0, 0], upper: [%.17g, %.17g, %.17g], periodic: true}\nstep: "
                 "{count: 1}\ncontact: {law: hooke}\n"
                 "materials: [{name: a, density: 1}]\nmaterial_pairs: [{restitution: 1, k_n: 1}]\n"
                 "particles: {from: lattice, lattice: %s, spacing: 1, sizes: 0.5}\n",
                 boxes[k][0], boxes[k][1], boxes[k][2], kinds[k]);
        struct scene *scene = good_scene(text, NULL);
        struct particles *p = scene_all(scene, NULL);
        for (size_t i = 0; i < p->owned; i++) {
            int neighbours = 0;
            for (size_t j = 0; j < p->owned; j++) {
                double sum = 0;
                for (int d = 0; d < 3 && j != i; d++) {
                    double gap = fabs(p->state[i].x[d] - p->state[j].x[d]);
                    gap = fmin(gap, scene->box.edge[d] - gap);
                    sum += gap * gap;
                }
                neighbours += j != i && sum < 1.0001;
            }
            assert_int_equal(neighbours, expected[k]);
        }
        particles_destroy(&p);
        scene_free(&scene);
    }
}

static void jitter_keeps_apart(void **state) {
    (void)state;
    struct scene *scene = scene_with(", periodic: [true, false, false]",
                                     "particles: {from: lattice, lattice: sc, spacing: 1, sizes: {law: "
                                     "uniform, min: 0.2, max: 0.4}, jitter: 1, material: b}\n");
    struct scene_census census;
    struct particles *p = scene_all(scene, &census);
    double gap = smallest_gap(&scene->box, p);
    assert_true(gap > 0 && gap < 0.3);
    assert_inside(&scene->box, p);
    double moved = 0;
    for (size_t i = 0; i < p->owned; i++)
        moved = fmax(moved, fabs(p->state[i].x[0] - floor(p->state[i].x[0]) - 1.0 / 12));
    assert_true(moved > 0.03 && moved < 0.06);
    assert_int_equal(census.material[1], census.particles);
    assert_true(fabs(1 / p->state[0].inverse_mass - particles_sphere_mass(p->state[0].radius, 2)) < 1e-12 ||
                p->state[0].inverse_mass == 0);
    particles_destroy(&p);
    scene_free(&scene);
}

static void lattice_in_region(void **state) {
    (void)state;
    struct scene *scene = scene_with(
        "", "particles: {from: lattice, lattice: hcp, spacing: 0.4, sizes: 0.15, material: a, count: 300,\n"
            "  region: {shape: sphere, centre: [3, 5, 8], radius: 2}}\n");
    struct scene_census census;
    struct particles *p = scene_all(scene, &census);
    assert_int_equal(census.particles, 300);
    for (size_t i = 0; i < p->owned; i++) {
        double dx = p->state[i].x[0] - 4, dy = p->state[i].x[1] - 5, dz = p->state[i].x[2] - 6;
        assert_true(sqrt(dx * dx + dy * dy + dz * dz) + 0.15 <= 2 + 1e-9);
    }
    particles_destroy(&p);
    scene_free(&scene);
}

/* Each particle has a velocity of its own, by its id: normal in each direction, and none twice. */
static void velocities(void **state) {
    (void)state;
    struct scene *scene = scene_with("", "particles: {from: lattice, lattice: sc, spacing: 0.75, sizes: 0.1, "
                                         "material: a, velocity_sigma: 2, velocity: [1, 0, 0]}\n");
    struct particles *p = scene_all(scene, NULL);
    double sum[3] = {0}, squares[3] = {0}, n = 0;
    for (size_t i = 0; i < p->owned; i++) {
        const double *v = p->state[i].v;
        if (groups_of(p)[i] > 0) /* frozen */
            continue;
        n++;
        for (int d = 0; d < 3; d++) {
            sum[d] += v[d];
            squares[d] += v[d] * v[d];
            for (size_t j = 0; j < i; j++)
                assert_true(v[d] != p->state[j].v[d]);
        }
    }
    assert_true(n > 1000);
    for (int d = 0; d < 3; d++) {
        double mean = sum[d] / n;
        assert_true(fabs(mean - (d == 0)) < 4 * 2 / sqrt(n));
        assert_true(fabs(sqrt(squares[d] / n - mean * mean) / 2 - 1) < 4 / sqrt(2 * n));
    }
    particles_destroy(&p);
    scene_free(&scene);
}

#define RANDOM_PARTICLES                                                                                     \
    "particles:\n  sources:\n"                                                                               \
    "    - {from: single, position: [3, 5, 8], radius: 1.5, material: b, velocity: [0, 0, -5]}\n"            \
    "    - {from: random, sizes: {law: power, min: 0.1, max: 1, exponent: -3}, volume_fraction: 0.25, "      \
    "material: a, velocity_sigma: 2}\n"

static void random_packing(void **state) {
    (void)state;
    static const char *const boxes[] = {"", ", periodic: true", ", periodic: [true, true, false]"};
    for (int k = 0; k < 3; k++) {
        struct scene *scene = scene_with(boxes[k], RANDOM_PARTICLES);
        struct scene_census census;
        struct particles *p = scene_all(scene, &census);
        assert_true(smallest_gap(&scene->box, p) >= 0);
        assert_inside(&scene->box, p);
        double ball = 4 * M_PI / 3 * 1.5 * 1.5 * 1.5;
        assert_true(fabs((census.volume - ball) / (8 * 10 * 12) - 0.25) < 2e-3);
        assert_true(census.radius_max == 1.5 && census.radius_min < 0.11);
        assert_true(p->id[0] == 1 && p->id[1] == 2 && census.id_max == (int64_t)census.particles);
        double mean = 0;
        for (size_t i = 1; i < p->owned; i++)
            mean += p->state[i].v[0] * p->state[i].v[0] / (double)(p->owned - 1);
        assert_true(fabs(mean - 4) < 0.5);
        particles_destroy(&p);
        scene_free(&scene);
    }
}

/* Large spheres find room although their source comes last, and beside a ball whose source comes last; ids follow
 * the sources. */
static void largest_of_all_sources_first(void **state) {
    (void)state;
    struct scene *scene = scene_with(", periodic: true",
                                     "particles:\n  sources:\n"
                                     "    - {from: random, sizes: 0.35, volume_fraction: 0.14, material: a}\n"
                                     "    - {from: random, sizes: 1.5, count: 9, material: b}\n"
                                     "    - {from: single, position: [3, 5, 8], radius: 1.9, material: b}\n");
    struct scene_census census;
    struct particles *p = scene_all(scene, &census);
    assert_true(smallest_gap(&scene->box, p) >= 0);
    size_t n = p->owned;
    assert_true(n > 700 && p->state[n - 1].radius == 1.9 && p->id[n - 1] == (int64_t)n);
    assert_true(p->state[0].radius == 0.35 && p->id[0] == 1 && p->state[n - 2].radius == 1.5);
    particles_destroy(&p);
    scene_free(&scene);
}

static void random_discs(void **state) {
    (void)state;
    struct scene *scene = good_scene(
        "units: none\nbox: {dimension: 2, lower: [0, 0], upper: [20, 20], periodic: true}\nstep: {count: 1}\n"
        "contact: {law: hooke}\nmaterials: [{name: a, density: 1}]\nmaterial_pairs: [{restitution: 1, k_n: "
        "1}]\n"
        "particles: {from: random, sizes: 0.5, volume_fraction: 0.5}\n",
        NULL);
    struct scene_census census;
    struct particles *p = scene_all(scene, &census);
    assert_int_equal(census.particles, 255); /* 0.5 * 400 / (pi / 4) = 254.6 */
    assert_true(smallest_gap(&scene->box, p) >= 0);
    particles_destroy(&p);
    scene_free(&scene);
}

/* What random placement cannot reach is refused with what it did reach. */
static void says_what_it_reached(void **state) {
    (void)state;
    struct scene *scene = scene_with(
        "", "particles: {from: random, sizes: 0.4, volume_fraction: 0.37, material: a, attempts: 300}\n");
    struct particles *p = particles_with(WITH_ALL, 0);
    struct scene_share share = {.size = 1};
    struct error error = {0};
    assert_false(scene_particles(scene, &share, p, NULL, &error));
    assert_int_equal(error.kind, ERROR_USER);
    assert_non_null(strstr(error.text, "particles.sources[0].volume_fraction"));
    assert_non_null(strstr(error.text, "of 0.37"));
    assert_non_null(strstr(error.text, "0.382"));
    particles_destroy(&p);
    scene_free(&scene);
}

static bool is_left(void *context, const double x[3]) {
    return x[0] < *(const double *)context;
}

/* Shares of several ranks together are what one rank makes, bit by bit; and `mine` gives a rank what lies in
 * it. */
static void ranks_agree(void **state) {
    (void)state;
    struct scene *scene = scene_with(", periodic: true", RANDOM_PARTICLES);
    struct scene_census census, again;
    struct particles *all = scene_all(scene, &census);
    size_t seen = 0;
    for (int rank = 0; rank < 3; rank++) {
        struct particles *part = particles_with(WITH_ALL, 0);
        struct scene_share share = {.rank = rank, .size = 3};
        struct error error = {0};
        assert_true(scene_particles(scene, &share, part, &again, &error));
        assert_memory_equal(&census, &again, sizeof(census));
        for (size_t i = 0; i < part->owned; i++) {
            size_t j = (size_t)part->id[i] - 1;
            assert_memory_equal(&part->state[i], &all->state[j], sizeof(part->state[i]));
            assert_memory_equal(spin_of(part)[i], spin_of(all)[j], sizeof(spin_of(part)[i]));
        }
        seen += part->owned;
        particles_destroy(&part);
    }
    assert_int_equal(seen, all->owned);
    double border = 3;
    struct particles *left = particles_with(WITH_ALL, 0);
    struct scene_share share = {.rank = 0, .size = 2, .mine = is_left, .context = &border};
    struct error error = {0};
    assert_true(scene_particles(scene, &share, left, &again, &error));
    size_t expected = 0;
    for (size_t i = 0; i < all->owned; i++)
        expected += all->state[i].x[0] < border;
    assert_int_equal(left->owned, expected);
    assert_true(expected > 0 && expected < all->owned);
    assert_int_equal(again.particles, census.particles);
    particles_destroy(&left);
    particles_destroy(&all);
    scene_free(&scene);
}

static void groups_select(void **state) {
    (void)state;
    struct scene *scene = scene_with("", RANDOM_PARTICLES);
    struct scene_census census;
    struct particles *p = scene_all(scene, &census);
    uint64_t inside = 0;
    for (size_t i = 0; i < p->owned; i++) {
        double dx = p->state[i].x[0] - 4, dy = p->state[i].x[1] - 5, dz = p->state[i].x[2] - 6;
        bool in = sqrt(dx * dx + dy * dy + dz * dz) <= 3;
        assert_int_equal(groups_of(p)[i], in);
        assert_int_equal(p->state[i].inverse_mass == 0, in);
        assert_true(fabs(groups_mass(p, i) -
                         particles_sphere_mass(p->state[i].radius, material_numbers(p)[i] ? 2 : 1)) < 1e-12);
        inside += in;
    }
    assert_int_equal(census.group[1], inside);
    assert_true(inside > 1 && inside < census.particles);
    particles_destroy(&p);
    scene_free(&scene);
}

TEST_MAIN(generate, cmocka_unit_test(lattices), cmocka_unit_test(lattice_fills_an_open_box),
          cmocka_unit_test(neighbours_of_lattices), cmocka_unit_test(jitter_keeps_apart),
          cmocka_unit_test(lattice_in_region), cmocka_unit_test(velocities), cmocka_unit_test(random_packing),
          cmocka_unit_test(largest_of_all_sources_first), cmocka_unit_test(random_discs),
          cmocka_unit_test(says_what_it_reached), cmocka_unit_test(ranks_agree),
          cmocka_unit_test(groups_select))
