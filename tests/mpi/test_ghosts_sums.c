/* SPDX-License-Identifier: BSD-3-Clause */
/* The plan carries sums of copies back to the originals.
 * Ranks: 1 2 3 4 8 Long: 27 */
#include "tests/test.h"

#include "base/memory.h"
#include "fixture.h"
#include "kernel/particles/fields.h"

#include <string.h>

enum { PARTICLES = 240 };

static void send_reverse(struct fixture *fixture) {
    struct field_list fields = fields_with(fixture->particles, FIELD_REVERSE);
    ghosts_reverse(fixture->ghosts, fixture->particles, &fields);
}

/* The numbers that the copy of particle k on a rank under an image sends back: whole numbers, so that sums
 * are exact. */
static double share(size_t k, int rank, unsigned code, int component) {
    return cloud_value((int64_t)k + 1, rank, component + 6 * (int)code, 77);
}

/* Force and torque that particle k must have in the end: its own, and the shares of all its copies. */
static double expected_sum(const struct fixture *fixture, size_t k, int component) {
    double sum = cloud_value((int64_t)k + 1, 0, component, 76);
    if (!fixture->scene->newton)
        return sum;
    for (int rank = 0; rank < fixture->team->comm.size; rank++) {
        for (int turn = 0; turn < 27; turn++) {
            int image[3];
            if (fixture_image(fixture, turn, image) && fixture_needs(fixture, rank, k, image))
                sum += share(k, rank, image_code(image[0], image[1], image[2]), component);
        }
    }
    return sum;
}

static double *force_at(const struct particles *particles, size_t i, int component) {
    return &particles->force[i * (size_t)particles->force_stride + (size_t)(component + component / 3)];
}

static void sums_back(void **state) {
    struct team *team = *state;
    for (int s = 0; s < SCENES; s++) {
        struct fixture fixture;
        fixture_make(&fixture, team, s, PARTICLES);
        fixture_rebuild(&fixture);
        struct particles *particles = fixture.particles;
        for (size_t g = 0; g < particles->ghosts; g++)
            for (int c = 0; c < 6; c++) {
                double *force = force_at(particles, particles->owned + g, c);
                size_t k = (size_t)particles->id[particles->owned + g] - 1;
                team_expect(team, *force == 0, "a new copy has the force %g", *force);
                *force = share(k, team->comm.rank, ghosts_image(fixture.ghosts, g), c);
            }
        for (size_t i = 0; i < particles->owned; i++)
            for (int c = 0; c < 6; c++)
                *force_at(particles, i, c) = cloud_value(particles->id[i], 0, c, 76);
        send_reverse(&fixture);
        for (size_t i = 0; i < particles->owned; i++)
            for (int c = 0; c < 6; c++) {
                double sum = expected_sum(&fixture, (size_t)particles->id[i] - 1, c);
                team_expect(team, *force_at(particles, i, c) == sum, "scene %d: sum %g instead of %g", s,
                            *force_at(particles, i, c), sum);
            }
        fixture_free(&fixture);
    }
    team_finish(team);
}

/* Sums of fields that are no forces, of one and of five components, alone and together with forces. */
static void any_sums_back(void **state) {
    struct team *team = *state;
    static const char *const names[] = {"heat", "moment", "torque"};
    for (int n = 0; n < 3; n++) {
        struct fixture fixture;
        fixture_make(&fixture, team, SCENE_BOULDERS, PARTICLES);
        fixture_rebuild(&fixture);
        struct particles *particles = fixture.particles;
        int f = fields_find(particles, names[n]), other = fields_find(particles, names[(n + 1) % 3]);
        int components = fields_get(particles, f)->components;
        struct field_list fields = fields_one(f);
        if (n == 1)
            fields = fields_with(particles, FIELD_REVERSE);
        for (size_t i = 0; i < particles->owned + particles->ghosts; i++) {
            bool copy = i >= particles->owned;
            size_t k = (size_t)particles->id[i] - 1;
            unsigned code = copy ? ghosts_image(fixture.ghosts, i - particles->owned) : 0;
            team_expect(team, !copy || cloud_get(particles, f, components - 1, i) == 0, "a copy begins at 0");
            for (int c = 0; c < components; c++)
                cloud_set(particles, f, c, i,
                          copy ? share(k, team->comm.rank, code, c)
                               : cloud_value(particles->id[i], 0, c, 76));
            cloud_set(particles, other, 0, i, 5);
        }
        ghosts_reverse(fixture.ghosts, particles, &fields);
        for (size_t i = 0; i < particles->owned; i++) {
            for (int c = 0; c < components; c++)
                team_expect(team,
                            cloud_get(particles, f, c, i) ==
                                expected_sum(&fixture, (size_t)particles->id[i] - 1, c),
                            "%s of %lld", names[n], (long long)particles->id[i]);
            team_expect(team, n == 1 || cloud_get(particles, other, 0, i) == 5, "%s was sent",
                        names[(n + 1) % 3]);
        }
        fixture_free(&fixture);
    }
    team_finish(team);
}

/* Forces that are no whole numbers give the same bits each time. */
static void sums_are_reproducible(void **state) {
    struct team *team = *state;
    double *first = NULL;
    for (int turn = 0; turn < 3; turn++) {
        struct fixture fixture;
        fixture_make(&fixture, team, SCENE_BOULDERS, PARTICLES);
        fixture_rebuild(&fixture);
        struct particles *particles = fixture.particles;
        size_t values = particles->owned * (size_t)particles->force_stride;
        for (size_t i = 0; i < particles->owned + particles->ghosts; i++)
            for (int c = 0; c < 6; c++)
                *force_at(particles, i, c) =
                    1.0 / (1 + share((size_t)particles->id[i], team->comm.rank, 0, c));
        send_reverse(&fixture);
        if (first == NULL) {
            first = memory_allocate(values, sizeof *first, "test");
            memcpy(first, particles->force, values * sizeof *first);
        }
        for (size_t i = 0; i < particles->owned; i++)
            for (int c = 0; c < 6; c++) {
                size_t at = (size_t)(force_at(particles, i, c) - particles->force);
                team_expect(team, first[at] == particles->force[at], "turn %d: other bits", turn);
            }
        fixture_free(&fixture);
    }
    memory_free(first);
    team_finish(team);
}

TEAM_MAIN(ghosts_sums, team_case(sums_back), team_case(any_sums_back), team_case(sums_are_reproducible))
