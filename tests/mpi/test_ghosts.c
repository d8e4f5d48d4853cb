/* Copies against their definition, which every rank can apply to all particles: exactly the copies that the
 * rule demands, no pair without its partner, values forward, sums back. Ranks: 1 2 3 4 8 27 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include "cloud.h"
#include "comm/ghosts.h"
#include "core/memory.h"
#include "index/index.h"
#include "particles/fields.h"
#include "team.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PARTICLES = 240, STAMP = 3 };

struct scene {
    struct box box;
    enum cloud_radii radii;
    bool newton, reduced;
    bool slabs; /* a grid of ranks along x alone */
};

#define PERIODIC                                                                                             \
    {                                                                                                        \
        .dimension = 3, .edge = {10, 11, 12}, .periodic = { true, true, true }                               \
    }
#define OPEN                                                                                                 \
    {                                                                                                        \
        .dimension = 3, .edge = { 10, 11, 12 }                                                               \
    }
#define MIXED                                                                                                \
    {                                                                                                        \
        .dimension = 3, .edge = {10, 20, 12}, .periodic = { false, true, false }                             \
    }
#define FLAT                                                                                                 \
    {                                                                                                        \
        .dimension = 2, .edge = {10, 11, 1}, .periodic = { true, false, false }                              \
    }

static const struct scene scenes[] = {
    {PERIODIC, CLOUD_EQUAL, true, true, false},      {PERIODIC, CLOUD_BIDISPERSE, true, true, false},
    {PERIODIC, CLOUD_BIDISPERSE, true, false, true}, {PERIODIC, CLOUD_BIDISPERSE, false, false, false},
    {PERIODIC, CLOUD_CONTINUOUS, true, true, true},  {PERIODIC, CLOUD_CONTINUOUS, false, false, false},
    {PERIODIC, CLOUD_BOULDERS, true, true, false},   {PERIODIC, CLOUD_BOULDERS, true, true, true},
    {PERIODIC, CLOUD_BOULDERS, true, false, false},  {PERIODIC, CLOUD_BOULDERS, false, false, false},
    {OPEN, CLOUD_BIDISPERSE, true, true, false},     {OPEN, CLOUD_BOULDERS, true, true, false},
    {OPEN, CLOUD_BOULDERS, false, false, true},      {MIXED, CLOUD_BIDISPERSE, true, true, false},
    {MIXED, CLOUD_BOULDERS, true, true, true},       {MIXED, CLOUD_CONTINUOUS, false, false, false},
    {FLAT, CLOUD_BIDISPERSE, true, true, false},     {FLAT, CLOUD_BOULDERS, true, true, false},
    {FLAT, CLOUD_BOULDERS, false, false, false},
};
enum { SCENES = sizeof scenes / sizeof scenes[0] };

struct fixture {
    struct team *team;
    const struct scene *scene;
    struct cloud cloud;
    struct domain *domain;
    struct ghosts *ghosts;
    struct particles *particles;
};

static void fixture_make(struct fixture *fixture, struct team *team, const struct scene *scene) {
    fixture->team = team;
    fixture->scene = scene;
    cloud_make(&fixture->cloud, &scene->box, scene->radii, PARTICLES, 5);
    int size = team->comm.size;
    struct domain_options options = {{scene->slabs ? size : 0, 0, 0}};
    struct error error = {0};
    fixture->domain = domain_create(&team->comm, &scene->box, &options, &error);
    assert_non_null(fixture->domain);
    struct ghosts_options ghosts = {.newton = scene->newton, .reduced = scene->reduced};
    fixture->ghosts = ghosts_create(&team->comm, fixture->domain, &fixture->cloud.box, &ghosts);
    fixture->particles = particles_create(PARTICLE_FEATURES_ALL, 0);
    for (size_t k = 0; k < fixture->cloud.n; k++)
        if (k % (size_t)size == (size_t)team->comm.rank)
            cloud_append(&fixture->cloud, k, STAMP, fixture->particles);
}

static void fixture_free(struct fixture *fixture) {
    ghosts_destroy(&fixture->ghosts);
    particles_destroy(&fixture->particles);
    domain_destroy(&fixture->domain);
    cloud_free(&fixture->cloud);
}

static void rebuild(struct fixture *fixture) {
    struct particles *particles = fixture->particles;
    ghosts_drop(fixture->ghosts, particles);
    for (size_t i = 0; i < particles->owned; i++)
        memcpy(particles->state[i].x, fixture->cloud.x[particles->id[i] - 1], 3 * sizeof(double));
    ghosts_migrate(fixture->ghosts, particles, NULL);
    particles_classify(particles, &fixture->cloud.classes);
    ghosts_make(fixture->ghosts, particles, &fixture->cloud.classes);
}

static bool wraps(const struct fixture *fixture, int d) {
    bool wrap[3];
    domain_wrap(fixture->domain, wrap);
    return wrap[d];
}

/* Images along d that copies may have. */
static int images(const struct fixture *fixture, int d) {
    return fixture->scene->box.periodic[d] && !wraps(fixture, d) ? 1 : 0;
}

static double distance_to(const struct fixture *fixture, int rank, size_t k, const int image[3]) {
    double lower[3], upper[3], squared = 0;
    domain_bounds(fixture->domain, rank, lower, upper);
    for (int d = 0; d < 3; d++) {
        double y = fixture->cloud.x[k][d] + image[d] * fixture->scene->box.edge[d];
        double gap = y < lower[d] ? lower[d] - y : y > upper[d] ? y - upper[d] : 0;
        squared += wraps(fixture, d) ? 0 : gap * gap;
    }
    return sqrt(squared);
}

/* Does the rank that owns a particle of class c compute its pair with one of class a? */
static bool computes(const struct scene *scene, int c, int a) {
    return !scene->newton || !scene->reduced || c <= a;
}

/* The rule. */
static bool needs(const struct fixture *fixture, int rank, size_t k, const int image[3]) {
    const struct size_classes *classes = &fixture->cloud.classes;
    int a = classes_of(classes, fixture->cloud.radius[k]);
    double distance = distance_to(fixture, rank, k, image);
    bool self = domain_owner(fixture->domain, fixture->cloud.x[k]) == rank && image[0] == 0 &&
                image[1] == 0 && image[2] == 0;
    for (int c = 0; c < classes->count; c++)
        if (computes(fixture->scene, c, a) && !self &&
            distance <= fixture->cloud.radius[k] + classes->radius_max[c] + classes->margin[a][c])
            return true;
    return false;
}

/* Goes through all images of copies: 27 turns, those that exist here. */
static bool image_of_turn(const struct fixture *fixture, int turn, int image[3]) {
    int vector[3] = {turn % 3 - 1, turn / 3 % 3 - 1, turn / 9 - 1};
    for (int d = 0; d < 3; d++) {
        image[d] = vector[d];
        if (abs(vector[d]) > images(fixture, d))
            return false;
    }
    return true;
}

/* The local number of the copy of particle k under an image, or of k itself if it is owned here and the image
 * is 0; -1 if there is none. *count copies were found. */
static long find_copy(const struct fixture *fixture, size_t k, const int image[3], int *count) {
    const struct particles *particles = fixture->particles;
    unsigned code = box_image_code(image[0], image[1], image[2]);
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
        if (!image_of_turn(fixture, turn, image))
            continue;
        int needed = needs(fixture, fixture->team->comm.rank, k, image) ? 1 : 0;
        find_copy(fixture, k, image, &count);
        team_expect(fixture->team, count == needed,
                    "scene %d: particle %zu, image %d %d %d: %d copies, not %d",
                    (int)(fixture->scene - scenes), k + 1, image[0], image[1], image[2], count, needed);
        expected += (size_t)needed;
    }
    return expected;
}

static void exact_set_of_copies(void **state) {
    struct team *team = *state;
    for (int s = 0; s < SCENES; s++) {
        struct fixture fixture;
        fixture_make(&fixture, team, &scenes[s]);
        for (uint64_t seed = 1; seed < 3; seed++) {
            cloud_scatter(&fixture.cloud, seed);
            rebuild(&fixture);
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
    double cut =
        cloud->radius[i] + cloud->radius[j] +
        classes->margin[classes_of(classes, cloud->radius[i])][classes_of(classes, cloud->radius[j])];
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
                image[d] = wraps(fixture, d) ? 0 : image[d];
            long found = find_copy(fixture, j, image, &count);
            pairs++;
            if (!team_expect(fixture->team, found >= 0, "scene %d: pair %zu %zu, image %d %d %d: no partner",
                             (int)(fixture->scene - scenes), i + 1, j + 1, image[0], image[1], image[2]))
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
        fixture_make(&fixture, team, &scenes[s]);
        rebuild(&fixture);
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

/* All fields of use `use` of all copies are those of stamp `stamp`; positions are shifted ones. */
static void expect_values(struct fixture *fixture, unsigned use, unsigned stamp) {
    struct particles *particles = fixture->particles;
    for (size_t g = particles->owned; g < particles->owned + particles->ghosts; g++) {
        int64_t id = particles->id[g];
        unsigned code = ghosts_image(fixture->ghosts, g - particles->owned);
        double shift[BOX_IMAGE_CODES][4];
        box_image_shifts(&fixture->cloud.box, shift);
        for (int d = 0; d < 3; d++)
            team_expect(fixture->team,
                        particles->state[g].x[d] == fixture->cloud.x[id - 1][d] + shift[code][d],
                        "position of the copy of %lld", (long long)id);
        for (int f = 0; f < fields_count(); f++) {
            if (!cloud_stamped(f) || !(fields_get(f)->use & use))
                continue;
            for (int c = 0; c < fields_get(f)->components; c++)
                team_expect(fixture->team, cloud_get(particles, f, c, g) == cloud_value(id, f, c, stamp),
                            "%s of the copy of %lld", fields_get(f)->name, (long long)id);
        }
    }
}

/* New places nearby and new values for all owned particles. */
static void move(struct fixture *fixture, unsigned stamp) {
    struct particles *particles = fixture->particles;
    for (size_t k = 0; k < fixture->cloud.n; k++)
        for (int d = 0; d < 3; d++)
            fixture->cloud.x[k][d] += 0.001 * (cloud_value((int64_t)k, d, 0, stamp) - 100);
    for (size_t i = 0; i < particles->owned; i++) {
        memcpy(particles->state[i].x, fixture->cloud.x[particles->id[i] - 1], 3 * sizeof(double));
        for (int f = 0; f < fields_count(); f++)
            for (int c = 0; cloud_stamped(f) && c < fields_get(f)->components; c++)
                cloud_set(particles, f, c, i, cloud_value(particles->id[i], f, c, stamp));
    }
}

static void values_forward(void **state) {
    struct team *team = *state;
    for (int s = 0; s < SCENES; s++) {
        struct fixture fixture;
        fixture_make(&fixture, team, &scenes[s]);
        rebuild(&fixture);
        expect_values(&fixture, FIELD_GHOST, STAMP);
        for (unsigned stamp = STAMP + 1; stamp < STAMP + 4; stamp++) {
            move(&fixture, stamp);
            ghosts_forward_begin(fixture.ghosts, fixture.particles);
            ghosts_forward_end(fixture.ghosts, fixture.particles);
            expect_values(&fixture, FIELD_FORWARD, stamp);
        }
        fixture_free(&fixture);
    }
    team_finish(team);
}

/* What the copy of particle k on a rank under an image sends back: whole numbers, so that sums are exact. */
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
            if (image_of_turn(fixture, turn, image) && needs(fixture, rank, k, image))
                sum += share(k, rank, box_image_code(image[0], image[1], image[2]), component);
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
        fixture_make(&fixture, team, &scenes[s]);
        rebuild(&fixture);
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
        ghosts_reverse(fixture.ghosts, particles);
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

/* Forces that are no whole numbers give the same bits each time. */
static void sums_are_reproducible(void **state) {
    struct team *team = *state;
    double *first = NULL;
    for (int turn = 0; turn < 3; turn++) {
        struct fixture fixture;
        fixture_make(&fixture, team, &scenes[6]);
        rebuild(&fixture);
        struct particles *particles = fixture.particles;
        size_t values = particles->owned * (size_t)particles->force_stride;
        for (size_t i = 0; i < particles->owned + particles->ghosts; i++)
            for (int c = 0; c < 6; c++)
                *force_at(particles, i, c) =
                    1.0 / (1 + share((size_t)particles->id[i], team->comm.rank, 0, c));
        ghosts_reverse(fixture.ghosts, particles);
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

/* Boulders larger than half the box: somebody holds two images of one, somebody a copy of his own. */
static void several_images_on_one_rank(void **state) {
    struct team *team = *state;
    if (team->comm.size == 1)
        skip();
    struct fixture fixture;
    fixture_make(&fixture, team, &scenes[7]);
    rebuild(&fixture);
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

static void originals(void **state) {
    struct team *team = *state;
    struct fixture fixture;
    fixture_make(&fixture, team, &scenes[1]);
    rebuild(&fixture);
    size_t count, at = 0;
    const uint32_t *border = ghosts_originals(fixture.ghosts, &count);
    for (size_t i = 0; i < fixture.particles->owned; i++) {
        bool needed = false;
        for (int turn = 0; turn < 27 * team->comm.size; turn++) {
            int image[3];
            needed = needed || (image_of_turn(&fixture, turn % 27, image) &&
                                needs(&fixture, turn / 27, (size_t)fixture.particles->id[i] - 1, image));
        }
        if (needed)
            team_expect(team, at < count && border[at] == i, "particle %zu is missing", i);
        at += needed;
    }
    team_expect(team, at == count, "%zu originals instead of %zu", count, at);
    fixture_free(&fixture);
    team_finish(team);
}

static void counts(void **state) {
    struct team *team = *state;
    struct fixture fixture;
    fixture_make(&fixture, team, &scenes[1]);
    rebuild(&fixture);
    struct ghosts_counts before, after;
    ghosts_count(fixture.ghosts, &before);
    uint64_t classes = 0;
    for (int c = 0; c < CLASS_MAX; c++)
        classes += before.ghosts_class[c];
    team_expect(team, before.ghosts == fixture.particles->ghosts && classes == before.ghosts,
                "%llu copies, %llu by class", (unsigned long long)before.ghosts, (unsigned long long)classes);
    team_expect(team, before.neighbours < (uint64_t)team->comm.size, "neighbours");
    ghosts_forward_begin(fixture.ghosts, fixture.particles);
    ghosts_forward_end(fixture.ghosts, fixture.particles);
    ghosts_count(fixture.ghosts, &after);
    int64_t sums[3] = {(int64_t)(after.bytes - before.bytes), (int64_t)(after.messages - before.messages), 0};
    for (size_t g = 0; g < fixture.particles->ghosts; g++) {
        size_t k = (size_t)fixture.particles->id[fixture.particles->owned + g] - 1;
        sums[2] += domain_owner(fixture.domain, fixture.cloud.x[k]) != team->comm.rank;
    }
    team_expect(team, (uint64_t)sums[1] <= after.neighbours, "%lld messages in one exchange",
                (long long)sums[1]);
    comm_sum_int(&team->comm, sums, 3);
    int64_t each = (int64_t)fields_packed_bytes(fixture.particles, FIELD_FORWARD);
    team_expect(team, sums[0] == each * sums[2], "%lld bytes for %lld copies", (long long)sums[0],
                (long long)sums[2]);
    fixture_free(&fixture);
    team_finish(team);
}

int main(int argc, char **argv) {
    struct team team;
    team_start(&team, &argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_prestate(exact_set_of_copies, &team),
        cmocka_unit_test_prestate(no_pair_without_partner, &team),
        cmocka_unit_test_prestate(values_forward, &team),
        cmocka_unit_test_prestate(sums_back, &team),
        cmocka_unit_test_prestate(sums_are_reproducible, &team),
        cmocka_unit_test_prestate(several_images_on_one_rank, &team),
        cmocka_unit_test_prestate(originals, &team),
        cmocka_unit_test_prestate(counts, &team),
    };
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    return team_stop(&team) + failed;
}
