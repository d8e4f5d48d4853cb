/* SPDX-License-Identifier: BSD-3-Clause */
/* Copies against their definition, which every rank can apply to all particles: exactly the copies that the
 * rule demands, and no pair without its partner. Ranks: 1 2 3 4 8 Long: 27 */
#include "tests/test.h"

#include "base/memory.h"
#include "fixture.h"
#include "index/index.h"

enum { PARTICLES = 240 };

/* The local number of the copy of particle k under an image, or of k itself if k is owned here and the image
 * is 0; -1 if there is no copy. *count copies were found. */
static long find_copy(const struct fixture *fixture, size_t k, const int image[3], int *count) {
    const struct particles *particles = fixture->particles;
    unsigned code = image_code(image[0], image[1], image[2]);
    long found = -1;
    *count = 0;
    for (size_t g = 0; g < particles->ghosts; g++) {
        if (particles->id[particles->owned + g] != (int64_t)k + 1 || ghosts_image(fixture->ghosts, g) != code)
            continue;
        found = (long)(particles->owned + g);
        ++*count;
    }
    for (size_t i = 0; found < 0 && code == 0 && i < particles->owned; i++)
        if (particles->id[i] == (int64_t)k + 1)
            found = (long)i;
    return found;
}

static size_t expect_copies_of(struct fixture *fixture, size_t k) {
    size_t expected = 0;
    for (int turn = 0; turn < 27; turn++) {
        int image[3], count;
        if (!fixture_image(fixture, turn, image))
            continue;
        int needed = fixture_needs(fixture, fixture->team->comm.rank, k, image) ? 1 : 0;
        find_copy(fixture, k, image, &count);
        team_expect(
            fixture->team, count == needed, "scene %d: particle %zu, image %d %d %d: %d copies, not %d",
            (int)(fixture->scene - fixture_scenes), k + 1, image[0], image[1], image[2], count, needed);
        expected += (size_t)needed;
    }
    return expected;
}

static void exact_set_of_copies(void **state) {
    struct team *team = *state;
    for (int s = 0; s < SCENES; s++) {
        struct fixture fixture;
        fixture_make(&fixture, team, s, PARTICLES);
        for (uint64_t seed = 1; seed < 3; seed++) {
            cloud_scatter(&fixture.cloud, seed);
            fixture_rebuild(&fixture);
            size_t expected = 0;
            for (size_t k = 0; k < fixture.cloud.n; k++)
                expected += expect_copies_of(&fixture, k);
            team_expect(team, fixture.particles->ghosts == expected, "scene %d: %zu copies instead of %zu", s,
                        fixture.particles->ghosts, expected);
            char why[256] = "";
            team_expect(team, ghosts_valid(fixture.ghosts, fixture.particles, why, sizeof why), "%s", why);
            team_expect(team, particles_valid(fixture.particles, why, sizeof why), "%s", why);
        }
        fixture_free(&fixture);
    }
    team_finish(team);
}

static bool is_pair(const struct fixture *fixture, size_t i, size_t j, const int image[3]) {
    const struct cloud *cloud = &fixture->cloud;
    const struct size_classes *classes = &cloud->classes;
    double margin =
        classes->margin[classes_of(classes, cloud->radius[i])][classes_of(classes, cloud->radius[j])];
    if (margin == INDEX_NOT_WANTED)
        return false;
    double cut = cloud->radius[i] + cloud->radius[j] + margin;
    double squared = 0;
    for (int d = 0; d < 3; d++) {
        double x = cloud->x[j][d] + image[d] * cloud->box.edge[d] - cloud->x[i][d];
        squared += x * x;
    }
    return squared <= cut * cut;
}

/* Every pair that this rank computes for an owned particle i finds its partner here, at the right place. */
static size_t expect_partners_of(struct fixture *fixture, size_t i) {
    const struct cloud *cloud = &fixture->cloud;
    size_t pairs = 0;
    for (size_t j = 0; j < cloud->n; j++) {
        bool home = index_pair_home(cloud->radius[i], (int64_t)i, cloud->radius[j], (int64_t)j);
        for (int turn = 0; turn < 27 && j != i; turn++) {
            int image[3] = {turn % 3 - 1, turn / 3 % 3 - 1, turn / 9 - 1}, count;
            bool exists = true;
            for (int d = 0; d < 3; d++)
                exists = exists && (image[d] == 0 || cloud->box.periodic[d]);
            if (!exists || !is_pair(fixture, i, j, image) || (fixture->scene->newton && !home))
                continue;
            for (int d = 0; d < 3; d++)
                image[d] = fixture_wraps(fixture, d) ? 0 : image[d];
            long found = find_copy(fixture, j, image, &count);
            pairs++;
            if (!team_expect(fixture->team, found >= 0, "scene %d: pair %zu %zu, image %d %d %d: no partner",
                             (int)(fixture->scene - fixture_scenes), i + 1, j + 1, image[0], image[1],
                             image[2]))
                continue;
            for (int d = 0; d < 3; d++)
                team_expect(fixture->team,
                            fixture->particles->state[found].x[d] ==
                                cloud->x[j][d] + image[d] * cloud->box.edge[d],
                            "copy of %zu stands at %g", j + 1, fixture->particles->state[found].x[d]);
        }
    }
    return pairs;
}

static void no_pair_without_partner(void **state) {
    struct team *team = *state;
    for (int s = 0; s < SCENES; s++) {
        struct fixture fixture;
        fixture_make(&fixture, team, s, PARTICLES);
        fixture_rebuild(&fixture);
        int64_t pairs = 0;
        for (size_t k = 0; k < fixture.cloud.n; k++)
            if (domain_owner(fixture.domain, fixture.cloud.x[k]) == team->comm.rank)
                pairs += (int64_t)expect_partners_of(&fixture, k);
        comm_sum_int(&team->comm, &pairs, 1);
        team_expect(team, pairs > 10, "scene %d: only %lld pairs", s, (long long)pairs);
        fixture_free(&fixture);
    }
    team_finish(team);
}

/* Only its owner knows a particle that meets no particle. */
static void no_copies_for_nobody(void **state) {
    struct team *team = *state;
    struct fixture fixture;
    int64_t copies[2] = {0, 0};
    fixture_make(&fixture, team, SCENE_UNWANTED, PARTICLES);
    fixture_rebuild(&fixture);
    const struct particles *particles = fixture.particles;
    for (size_t g = particles->owned; g < particles->owned + particles->ghosts; g++)
        copies[particles->size_class[g] == fixture.cloud.classes.count - 1]++;
    comm_sum_int(&team->comm, copies, 2);
    team_expect(team, copies[1] == 0, "%lld copies of particles that meet nobody", (long long)copies[1]);
    team_expect(team, team->comm.size == 1 || copies[0] > 0, "no copies at all");
    fixture_free(&fixture);
    team_finish(team);
}

/* Boulders larger than half the box: some rank holds two images of a boulder, and some rank a copy of a
 * boulder of its own. */
static void several_images_on_one_rank(void **state) {
    struct team *team = *state;
    if (team->comm.size == 1)
        team_skip(team, "on one rank the index wraps, and there are no copies");
    struct fixture fixture;
    fixture_make(&fixture, team, SCENE_BOULDERS_SLABS, PARTICLES);
    fixture_rebuild(&fixture);
    const struct particles *particles = fixture.particles;
    int64_t found[2] = {0, 0};
    for (size_t k = 0; k < 2; k++) {
        int copies = 0;
        bool own = domain_owner(fixture.domain, fixture.cloud.x[k]) == team->comm.rank;
        for (size_t g = particles->owned; g < particles->owned + particles->ghosts; g++)
            copies += particles->id[g] == (int64_t)k + 1;
        found[0] += copies > 1;
        found[1] += own && copies > 0;
    }
    comm_sum_int(&team->comm, found, 2);
    team_expect(team, found[0] > 0, "nobody has several images of a boulder");
    team_expect(team, team->comm.size > 2 || found[1] > 0, "nobody has a copy of his own boulder");
    fixture_free(&fixture);
    team_finish(team);
}

TEAM_MAIN(copies, team_case(exact_set_of_copies), team_case(no_pair_without_partner),
          team_case(no_copies_for_nobody), team_case(several_images_on_one_rank))
