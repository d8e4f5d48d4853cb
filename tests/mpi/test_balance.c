/* SPDX-License-Identifier: BSD-3-Clause */
/* Division of the box by load: even loads with many particles, a complete division with few.
 *
 * Ranks: 1 2 3 4 8 Long: 27 */
#include "tests/test.h"

#include "kernel/comm/balance.h"
#include "base/memory.h"
#include "base/random.h"
#include "team.h"

#include <math.h>

enum { MOST = 20000 };

/* Particles of all ranks, the same on every rank, and a box that is divided by these particles. */
struct crowd {
    struct team *team;
    struct box box;
    struct domain *domain;
    double (*x)[3], (*mine)[3], *weight, *my_weight;
    size_t count;
};

/* Particles crowd at the lower ends; those of 16 weigh 5 times as much as others. */
static void crowd_make(struct crowd *crowd, struct team *team, size_t count) {
    struct domain_options options = {.kind = DOMAIN_BISECTION};
    struct error error = {0};
    *crowd = (struct crowd){
        .team = team, .box = {.dimension = 3, .periodic = {true, false, true}}, .count = count};
    crowd->x = memory_allocate(count, sizeof *crowd->x, "test");
    crowd->mine = memory_allocate(count, sizeof *crowd->mine, "test");
    crowd->weight = memory_allocate(count, sizeof *crowd->weight, "test");
    crowd->my_weight = memory_allocate(count, sizeof *crowd->my_weight, "test");
    for (int d = 0; d < 3; d++)
        crowd->box.edge[d] = 7 + d;
    for (size_t k = 0; k < count; k++) {
        struct random_sequence sequence = random_sequence(3, RANDOM_TEST, k);
        for (int d = 0; d < 3; d++)
            crowd->x[k][d] = crowd->box.edge[d] * pow(random_uniform(&sequence), 2);
        crowd->weight[k] = k % 16 == 0 ? 5 : 1;
    }
    crowd->domain = domain_create(&team->comm, &crowd->box, &options, &error);
    assert_non_null(crowd->domain);
}

static void crowd_free(struct crowd *crowd) {
    domain_destroy(&crowd->domain);
    memory_free(crowd->x);
    memory_free(crowd->mine);
    memory_free(crowd->weight);
    memory_free(crowd->my_weight);
}

/* This rank's particles; returns their weight. */
static double crowd_share(struct crowd *crowd, size_t *count) {
    double sum = 0;
    *count = 0;
    for (size_t k = 0; k < crowd->count; k++) {
        if (domain_owner(crowd->domain, crowd->x[k]) != crowd->team->comm.rank)
            continue;
        for (int d = 0; d < 3; d++)
            crowd->mine[*count][d] = crowd->x[k][d];
        crowd->my_weight[(*count)++] = crowd->weight[k];
        sum += crowd->weight[k];
    }
    return sum;
}

static bool crowd_divide(struct crowd *crowd) {
    size_t count;
    crowd_share(crowd, &count);
    struct balance_load load = {count, (const double(*)[3])crowd->mine, crowd->my_weight};
    return balance_divide(crowd->domain, &crowd->team->comm, &crowd->box, &load);
}

/* Ranks agree on the owner of each particle, and each particle is within its owner's bounds. */
static void expect_whole(struct crowd *crowd) {
    size_t count;
    double lower[3], upper[3];
    crowd_share(crowd, &count);
    int64_t total = (int64_t)count;
    comm_sum_int(&crowd->team->comm, &total, 1);
    team_expect(crowd->team, total == (int64_t)crowd->count, "%lld particles of %zu have an owner",
                (long long)total, crowd->count);
    domain_bounds(crowd->domain, crowd->team->comm.rank, lower, upper);
    for (int d = 0; d < 3; d++)
        team_expect(crowd->team,
                    (lower[d] == -INFINITY || lower[d] >= 0) && lower[d] <= crowd->box.edge[d] &&
                        (upper[d] == INFINITY || upper[d] <= crowd->box.edge[d]) && upper[d] >= 0,
                    "%g ... %g is not in the box", lower[d], upper[d]);
    for (size_t k = 0; k < count; k++)
        for (int d = 0; d < 3; d++)
            team_expect(crowd->team, crowd->mine[k][d] >= lower[d] && crowd->mine[k][d] <= upper[d],
                        "%g is not in %g ... %g", crowd->mine[k][d], lower[d], upper[d]);
}

static void need_zoltan(struct team *team) {
    struct error error = {0};
    if (!balance_available(&error))
        team_skip(team, "there are only bricks");
}

static void many_are_shared_evenly(void **state) {
    struct team *team = *state;
    need_zoltan(team);
    struct crowd crowd;
    size_t count;
    crowd_make(&crowd, team, MOST);
    team_expect(team, crowd_divide(&crowd), "not divided");
    expect_whole(&crowd);
    double most = crowd_share(&crowd, &count), sum = most;
    comm_max(&team->comm, &most, 1);
    comm_sum(&team->comm, &sum, 1);
    team_expect(team, most * team->comm.size < 1.1 * sum, "largest over mean load %g",
                most * team->comm.size / sum);
    crowd_free(&crowd);
    team_finish(team);
}

/* Fewer particles than ranks, or one particle that weighs more than all others: the result is still a
 * division of the box. */
static void few_have_one_owner_each(void **state) {
    struct team *team = *state;
    need_zoltan(team);
    for (size_t count = 0; count < 12; count++) {
        struct crowd crowd;
        crowd_make(&crowd, team, count);
        for (int turn = 0; turn < 2; turn++) {
            int64_t divided = crowd_divide(&crowd);
            int64_t most = divided;
            comm_max_int(&team->comm, &most, 1);
            team_expect(team, divided == most, "ranks differ in whether %zu particles were divided", count);
            expect_whole(&crowd);
            if (count > 0)
                crowd.weight[0] = 1000;
        }
        crowd_free(&crowd);
    }
    team_finish(team);
}

TEAM_MAIN(balance, team_case(many_are_shared_evenly), team_case(few_have_one_owner_each))
