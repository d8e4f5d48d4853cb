/* SPDX-License-Identifier: BSD-3-Clause */
/* Starting MPI, agreement on errors, collective helpers. Ranks: 1 2 3 4 8 */
#include "tests/test.h"

#include "kernel/comm/comm.h"
#include "base/memory.h"
#include "team.h"

#include <stdio.h>
#include <string.h>

/* An error of one rank, in turn of each rank. */
static void agree_on_the_error_of_one(void **state) {
    struct team *team = *state;
    for (int bad = 0; bad < team->comm.size; bad++) {
        struct error error = {0};
        if (team->comm.rank == bad)
            error_set(&error, ERROR_USER, "scene.yaml:%d: wrong", bad);
        char text[64];
        snprintf(text, sizeof text, "scene.yaml:%d: wrong", bad);
        bool none = comm_agree(&team->comm, &error);
        team_expect(team, !none && error.kind == ERROR_USER, "kind %d", error.kind);
        team_expect(team, strcmp(error.text, text) == 0, "'%s' instead of '%s'", error.text, text);
    }
    team_finish(team);
}

static void agree_on_the_lowest_of_several(void **state) {
    struct team *team = *state;
    struct error error = {0};
    int lowest = team->comm.size / 2;
    if (team->comm.rank >= lowest)
        error_set(&error, team->comm.rank == lowest ? ERROR_SYSTEM : ERROR_USER, "of rank %d",
                  team->comm.rank);
    char text[64];
    snprintf(text, sizeof text, "of rank %d", lowest);
    team_expect(team, !comm_agree(&team->comm, &error), "agreed that all is well");
    team_expect(team, error.kind == ERROR_SYSTEM && strcmp(error.text, text) == 0, "%d '%s'", error.kind,
                error.text);
    team_finish(team);
}

static void agree_that_all_is_well(void **state) {
    struct team *team = *state;
    struct error error = {0};
    team_expect(team, comm_agree(&team->comm, &error) && error.kind == ERROR_NONE, "error '%s'", error.text);
    team_finish(team);
}

static void two_largest(void **state) {
    struct team *team = *state;
    const struct comm *comm = &team->comm;
    int n = comm->size;
    double r = comm->rank, values[3][2] = {{r, r - 3}, {5, 1}, {r == 0 ? 9 : 2, r == 0 ? 8 : 1}};
    comm_max_two(comm, values, 3);
    team_expect(team, values[0][0] == n - 1 && values[0][1] == (n > 1 ? n - 2 : -3), "of ranks: %g %g",
                values[0][0], values[0][1]);
    team_expect(team, values[1][0] == 5 && values[1][1] == (n > 1 ? 5 : 1), "of equals: %g %g", values[1][0],
                values[1][1]);
    team_expect(team, values[2][0] == 9 && values[2][1] == 8, "of one rank: %g %g", values[2][0],
                values[2][1]);
    team_finish(team);
}

static void reductions(void **state) {
    struct team *team = *state;
    const struct comm *comm = &team->comm;
    int n = comm->size;
    double r = comm->rank;
    double sum[2] = {r, 1}, max[2] = {r, -r}, min[2] = {r, -r}, later[2] = {r * r, -r};
    int64_t isum[2] = {comm->rank, (int64_t)1 << 40}, imax[2] = {comm->rank, -comm->rank};
    comm_sum(comm, sum, 2);
    comm_max(comm, max, 2);
    comm_min(comm, min, 2);
    comm_sum_int(comm, isum, 2);
    comm_max_int(comm, imax, 2);
    struct comm_reduction reduction;
    comm_max_begin(comm, later, 2, &reduction);
    int64_t scan = comm_scan(comm, comm->rank + 1);
    comm_max_end(&reduction);
    team_expect(team, sum[0] == n * (n - 1) / 2.0 && sum[1] == n, "sum %g %g", sum[0], sum[1]);
    team_expect(team, max[0] == n - 1 && max[1] == 0, "max %g %g", max[0], max[1]);
    team_expect(team, min[0] == 0 && min[1] == 1 - n, "min %g %g", min[0], min[1]);
    team_expect(team, isum[0] == n * (n - 1) / 2 && isum[1] == n * ((int64_t)1 << 40), "integer sum");
    team_expect(team, imax[0] == n - 1 && imax[1] == 0, "integer max");
    team_expect(team, later[0] == (n - 1.0) * (n - 1.0) && later[1] == 0, "max in halves %g", later[0]);
    team_expect(team, scan == comm->rank * (comm->rank + 1) / 2, "scan %lld", (long long)scan);
    team_finish(team);
}

static void broadcast_and_gather_all(void **state) {
    struct team *team = *state;
    const struct comm *comm = &team->comm;
    char text[100] = "";
    if (comm->rank == 0)
        strcpy(text, "from rank 0");
    comm_broadcast(comm, text, sizeof text);
    team_expect(team, strcmp(text, "from rank 0") == 0, "'%s'", text);
    int32_t mine[3] = {comm->rank, 2 * comm->rank, -comm->rank};
    int32_t(*all)[3] = memory_allocate((size_t)comm->size, sizeof *all, "test");
    comm_gather_all(comm, mine, sizeof mine, all);
    for (int k = 0; k < comm->size; k++)
        team_expect(team, all[k][0] == k && all[k][1] == 2 * k && all[k][2] == -k, "from rank %d", k);
    memory_free(all);
    team_finish(team);
}

/* Rank r gives 5 r bytes of value r, so rank 0 gives none. */
static void gather_varying(void **state) {
    struct team *team = *state;
    const struct comm *comm = &team->comm;
    size_t bytes = 5 * (size_t)comm->rank;
    unsigned char *mine = memory_allocate(bytes, 1, "test");
    memset(mine, comm->rank, bytes);
    size_t *counts = memory_allocate((size_t)comm->size, sizeof *counts, "test");
    void *all;
    size_t total = comm_gather_varying(comm, mine, bytes, &all, counts);
    size_t expected = comm->rank == 0 ? 5 * (size_t)comm->size * ((size_t)comm->size - 1) / 2 : 0;
    team_expect(team, total == expected, "%zu bytes instead of %zu", total, expected);
    team_expect(team, (all == NULL) == (comm->rank != 0), "data on rank %d", comm->rank);
    const unsigned char *byte = all;
    for (size_t r = 0; comm->rank == 0 && r < (size_t)comm->size; r++) {
        team_expect(team, counts[r] == 5 * r, "count of rank %zu", r);
        for (size_t k = 0; k < counts[r]; k++)
            team_expect(team, *byte++ == r, "byte %zu of rank %zu", k, r);
    }
    memory_free(all);
    memory_free(mine);
    memory_free(counts);
    team_finish(team);
}

TEAM_MAIN(comm, team_case(agree_on_the_error_of_one), team_case(agree_on_the_lowest_of_several),
          team_case(agree_that_all_is_well), team_case(reductions), team_case(two_largest),
          team_case(broadcast_and_gather_all), team_case(gather_varying))
