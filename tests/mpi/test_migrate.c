/* SPDX-License-Identifier: BSD-3-Clause */
/* Migration from any rank to any rank: no particle is lost, all fields and rows migrate, in a known order.
 * Ranks: 1 2 3 4 8
 * Long: 27 */
#include "tests/test.h"

#include "cloud.h"
#include "kernel/comm/ghosts.h"
#include "base/memory.h"
#include "kernel/particles/fields.h"
#include "team.h"

#include <string.h>

enum { PARTICLES = 400, STAMP = 3 };

static const struct box boxes[] = {
    {.dimension = 3, .edge = {10, 11, 12}, .periodic = {true, true, true}},
    {.dimension = 3, .edge = {10, 11, 12}, .periodic = {false, true, false}},
    {.dimension = 2, .edge = {10, 11, 1}, .periodic = {true, false, false}},
};
enum { BOXES = sizeof boxes / sizeof boxes[0] };

/* Rows of a second kind, 24 bytes each. */
struct other_row {
    int64_t id, number;
    double value;
};

struct fixture {
    struct team *team;
    struct cloud cloud;
    struct domain *domain;
    struct ghosts *ghosts;
    struct particles *particles;
};

static void fixture_make(struct fixture *fixture, struct team *team, const struct box *box,
                         unsigned features) {
    fixture->team = team;
    cloud_make(&fixture->cloud, box, CLOUD_BIDISPERSE, PARTICLES, 1);
    struct domain_options options = {.grid = {0, 0, 0}};
    struct error error = {0};
    fixture->domain = domain_create(&team->comm, box, &options, &error);
    assert_non_null(fixture->domain);
    struct ghosts_options ghosts = {.newton = true, .reduced = true};
    fixture->ghosts = ghosts_create(&team->comm, fixture->domain, &fixture->cloud.box, &ghosts);
    fixture->particles = particles_with(features, 0);
    for (size_t k = 0; k < fixture->cloud.n; k++)
        if (k % (size_t)team->comm.size == (size_t)team->comm.rank)
            cloud_append(&fixture->cloud, k, STAMP, fixture->particles);
}

static void fixture_free(struct fixture *fixture) {
    ghosts_destroy(&fixture->ghosts);
    particles_destroy(&fixture->particles);
    domain_destroy(&fixture->domain);
    cloud_free(&fixture->cloud);
}

/* All particles take the places that the cloud now gives them. */
static void follow_cloud(struct fixture *fixture) {
    struct particles *particles = fixture->particles;
    for (size_t i = 0; i < particles->owned; i++)
        memcpy(particles->state[i].x, fixture->cloud.x[particles->id[i] - 1], 3 * sizeof(double));
}

/* Checks every field of all particles owned here, and that each particle is owned by the right rank alone. */
static void expect_all(struct fixture *fixture) {
    struct team *team = fixture->team;
    struct particles *particles = fixture->particles;
    const struct cloud *cloud = &fixture->cloud;
    size_t expected = 0;
    for (size_t k = 0; k < cloud->n; k++)
        expected += domain_owner(fixture->domain, cloud->x[k]) == team->comm.rank;
    team_expect(team, particles->owned == expected, "%zu particles instead of %zu", particles->owned,
                expected);
    uint8_t *seen = memory_allocate_zero(cloud->n, 1, "test");
    for (size_t i = 0; i < particles->owned; i++) {
        int64_t id = particles->id[i];
        if (!team_expect(team, id >= 1 && id <= (int64_t)cloud->n && !seen[id - 1], "id %lld", (long long)id))
            break;
        seen[id - 1] = 1;
        const double *x = cloud->x[id - 1];
        team_expect(team, memcmp(x, particles->state[i].x, 3 * sizeof *x) == 0, "position of %lld",
                    (long long)id);
        team_expect(team, domain_owner(fixture->domain, x) == team->comm.rank, "%lld is elsewhere",
                    (long long)id);
        team_expect(team, particles->state[i].radius == cloud->radius[id - 1], "radius of %lld",
                    (long long)id);
        for (int f = 0; f < fields_count(particles); f++) {
            const struct field *field = fields_get(particles, f);
            if (!cloud_stamped(field) || !(field->use & FIELD_MIGRATE))
                continue;
            for (int c = 0; c < field->components; c++)
                team_expect(
                    team, cloud_get(particles, f, c, i) == cloud_value(id, cloud_code(field->name), c, STAMP),
                    "%s of %lld", field->name, (long long)id);
        }
    }
    memory_free(seen);
}

static void fields_travel(void **state) {
    struct team *team = *state;
    for (int b = 0; b < BOXES; b++) {
        for (unsigned features = 0; features <= (WITH_ALL | WITH_OTHERS); features += 5) {
            struct fixture fixture;
            fixture_make(&fixture, team, &boxes[b], features);
            for (uint64_t seed = 1; seed < 5; seed++) {
                cloud_scatter(&fixture.cloud, seed);
                follow_cloud(&fixture);
                ghosts_migrate(fixture.ghosts, fixture.particles, NULL);
                expect_all(&fixture);
            }
            fixture_free(&fixture);
        }
    }
    team_finish(team);
}

/* All particles gather on one rank, and leave this rank again. */
static void all_in_one_place(void **state) {
    struct team *team = *state;
    struct fixture fixture;
    fixture_make(&fixture, team, &boxes[0], WITH_ALL);
    for (int round = 0; round < 3; round++) {
        for (size_t k = 0; k < fixture.cloud.n; k++)
            for (int d = 0; d < 3; d++)
                fixture.cloud.x[k][d] = (round == 1 ? 0.99 : 0.01) * fixture.cloud.box.edge[d];
        follow_cloud(&fixture);
        ghosts_migrate(fixture.ghosts, fixture.particles, NULL);
        expect_all(&fixture);
    }
    fixture_free(&fixture);
    team_finish(team);
}

/* First the particles that stay, the last of which take the places of the particles that leave; then the
 * arrivals by source rank, in their order there. */
static void order_of_arrivals(void **state) {
    struct team *team = *state;
    struct fixture fixture;
    fixture_make(&fixture, team, &boxes[0], 0);
    const size_t size = (size_t)team->comm.size, before = fixture.particles->owned;
    int64_t *expected = memory_allocate(fixture.cloud.n + before, sizeof *expected, "test");
    size_t stay = 0, at = 0;
    for (size_t k = 0; k < before; k++) {
        bool here = domain_owner(fixture.domain, fixture.particles->state[k].x) == team->comm.rank;
        expected[k] = here ? fixture.particles->id[k] : 0;
        stay += here;
    }
    for (size_t last = stay; at < stay; at++) {
        if (expected[at] != 0)
            continue;
        while (expected[last] == 0)
            last++;
        expected[at] = expected[last++];
    }
    ghosts_migrate(fixture.ghosts, fixture.particles, NULL);
    for (size_t source = 0; source < size; source++)
        for (size_t k = source; source != (size_t)team->comm.rank && k < fixture.cloud.n; k += size)
            if (domain_owner(fixture.domain, fixture.cloud.x[k]) == team->comm.rank)
                expected[at++] = (int64_t)k + 1;
    team_expect(team, at == fixture.particles->owned, "%zu particles instead of %zu",
                fixture.particles->owned, at);
    for (size_t k = 0; k < at && k < fixture.particles->owned; k++)
        team_expect(team, fixture.particles->id[k] == expected[k], "particle %lld is not at place %zu",
                    (long long)expected[k], k);
    memory_free(expected);
    fixture_free(&fixture);
    team_finish(team);
}

static size_t rows_of(int64_t id, int set) {
    return (size_t)((id * 7 + set) % 4);
}

static struct history_row history_row(int64_t id, size_t r) {
    struct history_row row = {.id = id, .partner = 100 * id + (int64_t)r};
    for (int c = 0; c < HISTORY_COMPONENTS_MAX; c++)
        row.value[c] = (double)(id * 10 + c) + 0.1 * (double)r;
    for (int d = 0; d < 3; d++)
        row.separation[d] = -(double)id - d;
    return row;
}

static void make_rows(const struct particles *particles, struct migrate_rows rows[2]) {
    for (int s = 0; s < 2; s++) {
        rows[s].row_bytes = s == 0 ? sizeof(struct history_row) : sizeof(struct other_row);
        rows[s].start = memory_allocate(particles->owned + 1, sizeof(size_t), "test");
        rows[s].row = memory_allocate(4 * particles->owned, rows[s].row_bytes, "test");
        rows[s].count = 0;
        for (size_t i = 0; i < particles->owned; i++) {
            int64_t id = particles->id[i];
            rows[s].start[i] = rows[s].count;
            for (size_t r = 0; r < rows_of(id, s); r++) {
                struct history_row history = history_row(id, r);
                struct other_row other = {id, (int64_t)r, 0.5 * (double)id};
                memcpy((char *)rows[s].row + rows[s].row_bytes * rows[s].count++,
                       s == 0 ? (const void *)&history : (const void *)&other, rows[s].row_bytes);
            }
        }
        rows[s].start[particles->owned] = rows[s].count;
    }
}

static void expect_rows(struct team *team, const struct particles *particles,
                        const struct migrate_rows rows[2]) {
    for (int s = 0; s < 2; s++) {
        size_t at = 0;
        for (size_t i = 0; i < particles->owned; i++) {
            int64_t id = particles->id[i];
            team_expect(team, rows[s].start[i] == at, "set %d: rows of %lld begin at %zu", s, (long long)id,
                        rows[s].start[i]);
            for (size_t r = 0; r < rows_of(id, s) && at < rows[s].count; r++, at++) {
                struct history_row history = history_row(id, r);
                struct other_row other = {id, (int64_t)r, 0.5 * (double)id};
                const void *expected = s == 0 ? (const void *)&history : (const void *)&other;
                const char *row = (const char *)rows[s].row + at * rows[s].row_bytes;
                team_expect(team, memcmp(row, expected, rows[s].row_bytes) == 0, "set %d: row %zu of %lld", s,
                            r, (long long)id);
            }
        }
        team_expect(team, rows[s].count == at && rows[s].start[particles->owned] == at,
                    "set %d: %zu rows instead of %zu", s, rows[s].count, at);
    }
}

static void rows_travel(void **state) {
    struct team *team = *state;
    struct fixture fixture;
    fixture_make(&fixture, team, &boxes[1], WITH_SPIN);
    struct migrate_rows rows[2] = {{0}};
    make_rows(fixture.particles, rows);
    for (uint64_t seed = 1; seed < 5; seed++) {
        cloud_scatter(&fixture.cloud, seed);
        follow_cloud(&fixture);
        ghosts_migrate_rows(fixture.ghosts, fixture.particles, &(struct migrate_places){0}, rows, 2);
        expect_all(&fixture);
        expect_rows(team, fixture.particles, rows);
    }
    /* The history alone, as contacts hand over the history */
    struct history_rows history = {.start = rows[0].start, .row = rows[0].row, .count = rows[0].count};
    cloud_scatter(&fixture.cloud, 9);
    follow_cloud(&fixture);
    struct migrate_rows again[2] = {{0}};
    ghosts_migrate(fixture.ghosts, fixture.particles, &history);
    make_rows(fixture.particles, again);
    bool same = history.count == again[0].count &&
                memcmp(history.row, again[0].row, history.count * sizeof *history.row) == 0;
    team_expect(team, same, "history rows by themselves");
    memory_free(history.start);
    memory_free(history.row);
    memory_free(rows[1].start);
    memory_free(rows[1].row);
    for (int s = 0; s < 2; s++) {
        memory_free(again[s].start);
        memory_free(again[s].row);
    }
    fixture_free(&fixture);
    team_finish(team);
}

static void counts(void **state) {
    struct team *team = *state;
    struct fixture fixture;
    fixture_make(&fixture, team, &boxes[0], 0);
    size_t leave = 0;
    for (size_t i = 0; i < fixture.particles->owned; i++)
        leave += domain_owner(fixture.domain, fixture.particles->state[i].x) != team->comm.rank;
    ghosts_migrate(fixture.ghosts, fixture.particles, NULL);
    struct ghosts_counts counts;
    ghosts_count(fixture.ghosts, &counts);
    team_expect(team, counts.migrated == leave, "%llu migrated instead of %zu",
                (unsigned long long)counts.migrated, leave);
    const struct field_list fields = fields_with(fixture.particles, FIELD_MIGRATE);
    size_t least = leave * fields_packed_bytes(fixture.particles, &fields);
    team_expect(team, counts.bytes >= least && counts.bytes <= least + 8 * counts.messages, "%llu bytes",
                (unsigned long long)counts.bytes);
    team_expect(team, counts.messages < (uint64_t)team->comm.size, "%llu messages",
                (unsigned long long)counts.messages);
    fixture_free(&fixture);
    team_finish(team);
}

TEAM_MAIN(migrate, team_case(fields_travel), team_case(all_in_one_place), team_case(order_of_arrivals),
          team_case(rows_travel), team_case(counts))
