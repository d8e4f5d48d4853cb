/* SPDX-License-Identifier: BSD-3-Clause */
/* Connected regions of fluid on a lattice that ranks share, against labels that spread over the whole lattice on each rank.
 * Ranks: 1 2 3 4 8 */
#include "tests/test.h"

#include "base/memory.h"
#include "physics/fluid/lattice/regions.h"
#include "team.h"

#include <stdlib.h>
#include <string.h>

/* The whole lattice on this rank. */
struct whole {
    int64_t count[3], all;
    bool periodic;
    uint8_t *fluid;
    int64_t *label; /* lowest number of the region; -1: not fluid */
};

/* True with probability part, from the number of a node. */
static bool draw(int64_t number, double part) {
    uint64_t h = ((uint64_t)number + 1) * 0x9E3779B97F4A7C15u;
    h = (h ^ (h >> 29)) * 0xBF58476D1CE4E5B9u;
    return (double)((h ^ (h >> 32)) >> 11) * 0x1p-53 < part;
}

/* Random nodes; or, with part 0, a channel that winds up and down through all planes, between walls every fourth node
 * along x. */
static bool is_fluid(const struct whole *whole, int64_t number, double part) {
    int64_t x = number % whole->count[0], last = whole->all / whole->count[0] - 1,
            up = number / whole->count[0];
    if (part > 0)
        return draw(number, part);
    if (x % 4 > 0)
        return true;
    return x > 0 && up == (x % 8 > 0 ? last : 0);
}

/* Gives `node` the lowest label of the neighbour in a direction; true if that changed it. */
static bool take(struct whole *whole, int64_t node, int d, int step) {
    int64_t at[3] = {node % whole->count[0], node / whole->count[0] % whole->count[1],
                     node / whole->count[0] / whole->count[1]};
    at[d] += step;
    if (whole->periodic)
        at[d] = (at[d] + whole->count[d]) % whole->count[d];
    if (at[d] < 0 || at[d] >= whole->count[d])
        return false;
    int64_t next = at[0] + whole->count[0] * (at[1] + whole->count[1] * at[2]);
    if (!whole->fluid[next] || whole->label[next] >= whole->label[node])
        return false;
    whole->label[node] = whole->label[next];
    return true;
}

static void gradient_correction_make(struct whole *whole, double part) {
    bool changed = true;
    whole->all = whole->count[0] * whole->count[1] * whole->count[2];
    whole->fluid = memory_allocate((size_t)whole->all, 1, "test");
    whole->label = memory_allocate((size_t)whole->all, sizeof *whole->label, "test");
    for (int64_t node = 0; node < whole->all; node++) {
        whole->fluid[node] = is_fluid(whole, node, part);
        whole->label[node] = whole->fluid[node] ? node : -1;
    }
    while (changed) {
        changed = false;
        for (int64_t node = 0; node < whole->all; node++)
            for (int k = 0; whole->fluid[node] && k < 6; k++)
                changed |= take(whole, node, k / 2, k % 2 ? 1 : -1);
    }
}

/* How many nodes have each label. */
static int64_t *sizes_of(const struct whole *whole) {
    int64_t *size = memory_allocate_zero((size_t)whole->all, sizeof *size, "test");
    for (int64_t node = 0; node < whole->all; node++)
        if (whole->fluid[node])
            size[whole->label[node]]++;
    return size;
}

/* The number of a region: how many are larger, or as large with a lower label. */
static int32_t rank_of(const struct whole *whole, const int64_t *size, int64_t label) {
    int32_t rank = 0;
    for (int64_t other = 0; other < whole->all; other++)
        rank += size[other] > size[label] || (size[other] == size[label] && size[other] > 0 && other < label);
    return rank;
}

static void compare(struct team *team, const struct nodes *nodes, const struct regions *regions,
                    const struct whole *whole) {
    int64_t *size = sizes_of(whole), largest = 0, fluid = 0, pocket = 0, bad = 0;
    for (int64_t k = 0; k < whole->all; k++)
        largest = size[k] > largest ? size[k] : largest;
    int32_t count = 0;
    for (int64_t k = 0; k < whole->all; k++) {
        bool kept = size[k] > 0 && (double)size[k] >= REGIONS_POCKET * (double)largest;
        count += kept;
        *(kept ? &fluid : &pocket) += size[k];
    }
    int32_t *number = memory_allocate((size_t)whole->all, sizeof *number, "test");
    for (int64_t k = 0; k < whole->all; k++)
        number[k] = size[k] > 0 ? rank_of(whole, size, k) : -1;
    for (int64_t node = 0; node < nodes->all; node++) {
        int64_t at = nodes_number(nodes, node);
        if (!nodes_own(nodes, node) || !whole->fluid[at])
            continue;
        int32_t wanted = number[whole->label[at]];
        bad += wanted < count ? nodes->state[node] != NODES_FLUID || nodes->owner[node] != wanted
                              : nodes->state[node] != NODES_SOLID || nodes->owner[node] != REGIONS_NOBODY;
    }
    team_expect(team, regions->count == count && regions->fluid == fluid && regions->pocket == pocket,
                "%d regions of %d, %d nodes of %d in pockets", regions->count, count, (int)regions->pocket,
                (int)pocket);
    team_expect(team, bad == 0, "%d nodes of this rank are wrong", (int)bad);
    memory_free(number);
    memory_free(size);
}

static void try(struct team *team, int dimension, int64_t edge, bool periodic, double part) {
    struct whole whole = {.count = {edge, edge + 1, dimension == 3 ? edge + 2 : 1}, .periodic = periodic};
    const struct box box = {
        .dimension = dimension, .edge = {1, 1, 1}, .periodic = {periodic, periodic, periodic}};
    struct nodes nodes = {
        .dimension = dimension, .spacing = 1, .support = 2.2, .box = &box, .comm = &team->comm};
    nodes.lattice = (struct arrangement){.dimension = dimension, .step = {1, 1, 1}, .volume = 1};
    gradient_correction_make(&whole, part);
    memcpy(nodes.whole, whole.count, sizeof nodes.whole);
    nodes_deal(&nodes);
    nodes.state = memory_allocate((size_t)nodes.all, sizeof *nodes.state, "test");
    nodes.owner = memory_allocate_zero((size_t)nodes.all, sizeof *nodes.owner, "test");
    int64_t own = 0;
    for (int64_t node = 0; node < nodes.all; node++) {
        nodes.state[node] = whole.fluid[nodes_number(&nodes, node)] ? NODES_FLUID : NODES_SOLID;
        own += nodes_own(&nodes, node);
        if (nodes_own(&nodes, node))
            team_expect(team, nodes_rank_of(&nodes, nodes_plane(&nodes, node)) == team->comm.rank,
                        "the rank of a plane");
    }
    comm_sum_int(&team->comm, &own, 1);
    team_expect(team, own == whole.all, "each node has one owner");
    struct regions regions = regions_find(&nodes);
    compare(team, &nodes, &regions, &whole);
    nodes_free(&nodes);
    memory_free(whole.fluid);
    memory_free(whole.label);
}

static void regions_are_those_of_the_whole(void **state) {
    struct team *team = *state;
    for (int periodic = 0; periodic < 2; periodic++) {
        try(team, 2, 30, periodic, 0.55);
        try(team, 2, 30, periodic, 0.62);
        try(team, 2, 5, periodic, 0.6); /* fewer planes than ranks */
        try(team, 3, 10, periodic, 0.3);
        try(team, 3, 10, periodic, 0.35);
    }
    team_finish(team);
}

static void a_channel_winds_through_all_ranks(void **state) {
    struct team *team = *state;
    try(team, 2, 24, false, 0);
    try(team, 3, 16, false, 0);
    team_finish(team);
}

static void without_fluid(void **state) {
    struct team *team = *state;
    try(team, 2, 12, true, 1e-300);
    team_finish(team);
}

TEAM_MAIN(regions, team_case(regions_are_those_of_the_whole), team_case(a_channel_winds_through_all_ranks),
          team_case(without_fluid))
