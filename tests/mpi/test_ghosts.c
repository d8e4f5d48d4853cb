/* SPDX-License-Identifier: BSD-3-Clause */
/* The plan carries values forward, and describes itself. Sums back: test_ghosts_sums.c.
 * Ranks: 1 2 3 4 8 Long: 27 */
#include "tests/test.h"

#include "base/memory.h"
#include "fixture.h"
#include "kernel/particles/fields.h"

#include <math.h>
#include <omp.h>
#include <string.h>

enum { PARTICLES = 240 };

/* All fields of use `use` of all copies are those of stamp `stamp`; positions are shifted ones. */
static void expect_values(struct fixture *fixture, unsigned use, unsigned stamp) {
    struct particles *particles = fixture->particles;
    for (size_t g = particles->owned; g < particles->owned + particles->ghosts; g++) {
        int64_t id = particles->id[g];
        unsigned code = ghosts_image(fixture->ghosts, g - particles->owned);
        double shift[IMAGE_CODES][4];
        box_image_shifts(&fixture->cloud.box, shift);
        for (int d = 0; d < 3; d++)
            team_expect(fixture->team,
                        particles->state[g].x[d] == fixture->cloud.x[id - 1][d] + shift[code][d],
                        "position of the copy of %lld", (long long)id);
        for (int f = 0; f < fields_count(particles); f++) {
            const struct field *field = fields_get(particles, f);
            if (!cloud_stamped(field) || !(field->use & use))
                continue;
            for (int c = 0; c < field->components; c++)
                team_expect(fixture->team,
                            cloud_get(particles, f, c, g) ==
                                cloud_value(id, cloud_code(field->name), c, stamp),
                            "%s of the copy of %lld", field->name, (long long)id);
        }
    }
}

/* Sends the fields of each step. */
static void send_forward(struct fixture *fixture) {
    struct field_list fields = fields_with(fixture->particles, FIELD_FORWARD);
    ghosts_forward_begin(fixture->ghosts, fixture->particles, &fields);
    ghosts_forward_end(fixture->ghosts, fixture->particles);
}

/* New places nearby and new values for all owned particles. */
static void move(struct fixture *fixture, unsigned stamp) {
    struct particles *particles = fixture->particles;
    for (size_t k = 0; k < fixture->cloud.n; k++)
        for (int d = 0; d < 3; d++)
            fixture->cloud.x[k][d] += 0.001 * (cloud_value((int64_t)k, d, 0, stamp) - 100);
    for (size_t i = 0; i < particles->owned; i++) {
        memcpy(particles->state[i].x, fixture->cloud.x[particles->id[i] - 1], 3 * sizeof(double));
        for (int f = 0; f < fields_count(particles); f++) {
            const struct field *field = fields_get(particles, f);
            for (int c = 0; cloud_stamped(field) && c < field->components; c++)
                cloud_set(particles, f, c, i,
                          cloud_value(particles->id[i], cloud_code(field->name), c, stamp));
        }
    }
}

static void values_forward(void **state) {
    struct team *team = *state;
    for (int s = 0; s < SCENES; s++) {
        struct fixture fixture;
        fixture_make(&fixture, team, s, PARTICLES);
        fixture_rebuild(&fixture);
        expect_values(&fixture, FIELD_GHOST, FIXTURE_STAMP);
        for (unsigned stamp = FIXTURE_STAMP + 1; stamp < FIXTURE_STAMP + 4; stamp++) {
            move(&fixture, stamp);
            send_forward(&fixture);
            expect_values(&fixture, FIELD_FORWARD, stamp);
        }
        fixture_free(&fixture);
    }
    team_finish(team);
}

/* Copies that are put back to the places of their originals stay at these places when values come. */
static void values_in_place(void **state) {
    struct team *team = *state;
    for (int s = SCENE_BOULDERS; s <= SCENE_BOULDERS_SLABS; s++) {
        struct fixture fixture;
        fixture_make(&fixture, team, s, PARTICLES);
        struct ghosts_options options = {.in_place = true};
        ghosts_destroy(&fixture.ghosts);
        fixture.ghosts = ghosts_create(&team->comm, fixture.domain, &fixture.cloud.box, &options);
        fixture_rebuild(&fixture);
        const struct particles *particles = fixture.particles;
        int64_t beyond = 0;
        for (size_t g = 0; g < particles->ghosts; g++)
            beyond += ghosts_image(fixture.ghosts, g) != 0;
        comm_sum_int(&team->comm, &beyond, 1);
        team_expect(team, team->comm.size == 1 || beyond > 0, "no copy crosses the box's sides");
        ghosts_unshift(fixture.ghosts, fixture.particles);
        for (unsigned stamp = FIXTURE_STAMP; stamp < FIXTURE_STAMP + 3; stamp++) {
            if (stamp > FIXTURE_STAMP) {
                move(&fixture, stamp);
                send_forward(&fixture);
            }
            for (size_t g = particles->owned; g < particles->owned + particles->ghosts; g++)
                team_expect(team,
                            memcmp(particles->state[g].x, fixture.cloud.x[particles->id[g] - 1],
                                   sizeof particles->state[g].x) == 0,
                            "the copy of %lld stands elsewhere", (long long)particles->id[g]);
        }
        fixture_free(&fixture);
    }
    team_finish(team);
}

/* Enough particles that threads share the work: the same copies in the same order, the same values. */
static void threads_do_not_matter(void **state) {
    struct team *team = *state;
    struct fixture fixture;
    fixture_make(&fixture, team, SCENE_EQUAL, 20000);
    struct particles *particles = fixture.particles;
    fixture_rebuild(&fixture);
    size_t first = particles->owned, n = particles->ghosts;
    int64_t *id = memory_allocate(n, sizeof *id, "test");
    uint8_t *image = memory_allocate(n, 1, "test");
    for (size_t g = 0; g < n; g++) {
        id[g] = particles->id[first + g];
        image[g] = (uint8_t)ghosts_image(fixture.ghosts, g);
    }
    int before = omp_get_max_threads();
    omp_set_num_threads(3);
    fixture_rebuild(&fixture);
    team_expect(team, particles->ghosts == n && particles->owned == first, "%zu copies instead of %zu",
                particles->ghosts, n);
    for (size_t g = 0; g < n && g < particles->ghosts; g++)
        team_expect(team, particles->id[first + g] == id[g] && ghosts_image(fixture.ghosts, g) == image[g],
                    "copy %zu is another", g);
    expect_values(&fixture, FIELD_GHOST, FIXTURE_STAMP);
    move(&fixture, FIXTURE_STAMP + 1);
    send_forward(&fixture);
    expect_values(&fixture, FIELD_FORWARD, FIXTURE_STAMP + 1);
    omp_set_num_threads(before);
    memory_free(id);
    memory_free(image);
    fixture_free(&fixture);
    team_finish(team);
}

/* A list of one field: the others of the copies, and their positions, stay. */
static void one_field_forward(void **state) {
    struct team *team = *state;
    for (int s = 0; s < SCENES; s++) {
        struct fixture fixture;
        fixture_make(&fixture, team, s, PARTICLES);
        fixture_rebuild(&fixture);
        struct particles *particles = fixture.particles;
        struct ghosts_counts before, after;
        double(*x)[3] = memory_allocate(particles->ghosts, sizeof *x, "test");
        for (size_t g = 0; g < particles->ghosts; g++)
            memcpy(x[g], particles->state[particles->owned + g].x, sizeof *x);
        move(&fixture, FIXTURE_STAMP + 1);
        int strain = fields_find(particles, "strain"), flux = fields_find(particles, "flux");
        const struct field_list fields = fields_one(strain);
        ghosts_count(fixture.ghosts, &before);
        ghosts_forward_begin(fixture.ghosts, particles, &fields);
        ghosts_forward_end(fixture.ghosts, particles);
        ghosts_count(fixture.ghosts, &after);
        for (size_t g = 0; g < particles->ghosts; g++) {
            size_t at = particles->owned + g;
            int64_t id = particles->id[at];
            for (int c = 0; c < 5; c++)
                team_expect(team,
                            cloud_get(particles, strain, c, at) ==
                                cloud_value(id, cloud_code("strain"), c, FIXTURE_STAMP + 1),
                            "strain of the copy of %lld", (long long)id);
            for (int c = 0; c < 3; c++)
                team_expect(team,
                            cloud_get(particles, flux, c, at) ==
                                cloud_value(id, cloud_code("flux"), c, FIXTURE_STAMP),
                            "flux of the copy of %lld", (long long)id);
            team_expect(team, memcmp(x[g], particles->state[at].x, sizeof *x) == 0, "a copy moved");
        }
        team_expect(team, (after.bytes - before.bytes) % (5 * sizeof(double)) == 0, "bytes");
        memory_free(x);
        fixture_free(&fixture);
    }
    team_finish(team);
}

static void originals(void **state) {
    struct team *team = *state;
    struct fixture fixture;
    fixture_make(&fixture, team, SCENE_BIDISPERSE, PARTICLES);
    fixture_rebuild(&fixture);
    size_t count, at = 0;
    const uint32_t *border = ghosts_originals(fixture.ghosts, &count);
    for (size_t i = 0; i < fixture.particles->owned; i++) {
        bool needed = false;
        for (int turn = 0; turn < 27 * team->comm.size; turn++) {
            int image[3];
            needed =
                needed || (fixture_image(&fixture, turn % 27, image) &&
                           fixture_needs(&fixture, turn / 27, (size_t)fixture.particles->id[i] - 1, image));
        }
        if (needed)
            team_expect(team, at < count && border[at] == i, "particle %zu is missing", i);
        at += needed;
    }
    team_expect(team, at == count, "%zu originals instead of %zu", count, at);
    fixture_free(&fixture);
    team_finish(team);
}

/* Copies of odd ids alone are in use: in a step only they get values and send forces back. */
static void used_copies_travel(void **state) {
    struct team *team = *state;
    struct fixture fixture;
    fixture_make(&fixture, team, SCENE_BIDISPERSE, PARTICLES);
    fixture_rebuild(&fixture);
    struct particles *p = fixture.particles;
    const struct field_list velocity = fields_one(FIELD_VELOCITY), force = fields_one(FIELD_FORCE);
    const size_t total = p->owned + p->ghosts;
    size_t count;
    uint8_t *used = memory_allocate_zero(p->ghosts, 1, "test");
    double *sum = memory_allocate_zero(p->owned, sizeof *sum, "test");
    const size_t stride = (size_t)p->force_stride;
    for (size_t k = 0; k < p->ghosts; k++)
        used[k] = p->id[p->owned + k] % 2 != 0;
    ghosts_use(fixture.ghosts, p, used);
    for (size_t i = 0; i < total; i++) {
        p->state[i].v[0] = i < p->owned ? 1000.0 + (double)p->id[i] : -1;
        p->force[i * stride] = i < p->owned ? 0 : 1;
    }
    ghosts_step_begin(fixture.ghosts, p, &velocity);
    ghosts_forward_end(fixture.ghosts, p);
    for (size_t i = p->owned; i < total; i++) {
        double expected = p->id[i] % 2 != 0 ? 1000.0 + (double)p->id[i] : -1;
        team_expect(team, p->state[i].v[0] == expected, "copy %zu has the velocity %g", i, p->state[i].v[0]);
    }
    ghosts_step_reverse(fixture.ghosts, p, &force);
    for (size_t i = 0; i < p->owned; i++) {
        sum[i] = p->force[i * stride];
        p->force[i * stride] = 0;
    }
    ghosts_reverse(fixture.ghosts, p, &force);
    for (size_t i = 0; i < p->owned; i++) {
        double expected = p->id[i] % 2 != 0 ? p->force[i * stride] : 0;
        team_expect(team, sum[i] == expected, "particle %zu got %g", i, sum[i]);
    }
    const uint32_t *original = ghosts_step_originals(fixture.ghosts, &count);
    for (size_t k = 0; k < count; k++)
        team_expect(team, p->id[original[k]] % 2 != 0, "particle %u travels", original[k]);
    memory_free(used);
    memory_free(sum);
    fixture_free(&fixture);
    team_finish(team);
}

/* The largest distance of a copy's place from the subdomain of this rank, as ghosts_around tells; 0 where none has a bound. */
static double depth_of_copies(const struct fixture *fixture, const double lower[3]) {
    double low[3], high[3], depth = 0;
    ghosts_around(fixture->ghosts, &fixture->cloud.classes, low, high);
    for (int d = 0; d < 3; d++)
        depth = isfinite(low[d]) ? lower[d] - low[d] : depth;
    return depth;
}

/* One particle of one rank lies outside by a known vector: copies reach farther by its length, if all ranks can have it. */
static void outside_by_a_vector(void **state) {
    static const double far[2] = {0.002, 0.4}; /* a little; more than a quarter of the reach */
    struct team *team = *state;
    for (int turn = 0; turn < 4; turn++) {
        struct fixture fixture;
        fixture_make(&fixture, team, SCENE_EQUAL + turn / 2 * BRICKS, PARTICLES);
        fixture_rebuild(&fixture);
        struct particles *particles = fixture.particles;
        const struct size_classes *classes = &fixture.cloud.classes;
        double lower[3], upper[3], square = 0;
        domain_bounds(fixture.domain, team->comm.rank, lower, upper);
        team_expect(team, !ghosts_let_stay(fixture.ghosts, particles, classes, false), "none was to stay");
        double most = depth_of_copies(&fixture, lower),
               vector[3] = {far[turn % 2], 1.5 * far[turn % 2], 3 * far[turn % 2]};
        if (team->comm.rank == team->comm.size - 1 && particles->owned > 0)
            for (int d = 0; d < 3; d++) {
                double out = d == 1 ? lower[d] - vector[d] : upper[d] + vector[d];
                square += fixture_wraps(&fixture, d) ? 0 : vector[d] * vector[d];
                particles->state[0].x[d] = fixture_wraps(&fixture, d) ? particles->state[0].x[d] : out;
            }
        double all[3] = {sqrt(square), most, -domain_clearance(fixture.domain)};
        comm_max(&team->comm, all, 3);
        bool may = all[0] <= 0.25 * (all[1] - classes->radius_max[0]) && all[1] + 2 * all[0] < -all[2];
        bool stays = ghosts_let_stay(fixture.ghosts, particles, classes, true);
        team_expect(team, stays == (may || team->comm.size == 1), "turn %d: %d instead of %d", turn, stays,
                    may);
        double more = depth_of_copies(&fixture, lower) - most, expected = stays && most > 0 ? all[0] : 0;
        team_expect(team, fabs(more - expected) <= 2e-6 * (expected + 1e-6), "turn %d: %g instead of %g",
                    turn, more, expected);
        fixture_free(&fixture);
    }
    team_finish(team);
}

static void counts(void **state) {
    struct team *team = *state;
    struct fixture fixture;
    fixture_make(&fixture, team, SCENE_BIDISPERSE, PARTICLES);
    fixture_rebuild(&fixture);
    struct ghosts_counts before, after;
    ghosts_count(fixture.ghosts, &before);
    uint64_t classes = 0;
    for (int c = 0; c < CLASS_MAX; c++)
        classes += before.ghosts_class[c];
    team_expect(team, before.ghosts == fixture.particles->ghosts && classes == before.ghosts,
                "%llu copies, %llu by class", (unsigned long long)before.ghosts, (unsigned long long)classes);
    team_expect(team, before.neighbours < (uint64_t)team->comm.size, "neighbours");
    send_forward(&fixture);
    ghosts_count(fixture.ghosts, &after);
    int64_t sums[3] = {(int64_t)(after.bytes - before.bytes), (int64_t)(after.messages - before.messages), 0};
    for (size_t g = 0; g < fixture.particles->ghosts; g++) {
        size_t k = (size_t)fixture.particles->id[fixture.particles->owned + g] - 1;
        sums[2] += domain_owner(fixture.domain, fixture.cloud.x[k]) != team->comm.rank;
    }
    team_expect(team, (uint64_t)sums[1] <= after.neighbours, "%lld messages in one exchange",
                (long long)sums[1]);
    comm_sum_int(&team->comm, sums, 3);
    const struct field_list fields = fields_with(fixture.particles, FIELD_FORWARD);
    int64_t each = (int64_t)fields_packed_bytes(fixture.particles, &fields);
    team_expect(team, sums[0] == each * sums[2], "%lld bytes for %lld copies", (long long)sums[0],
                (long long)sums[2]);
    fixture_free(&fixture);
    team_finish(team);
}

TEAM_MAIN(ghosts, team_case(values_forward), team_case(values_in_place), team_case(threads_do_not_matter),
          team_case(one_field_forward), team_case(originals), team_case(used_copies_travel),
          team_case(outside_by_a_vector), team_case(counts))
