/* SPDX-License-Identifier: BSD-3-Clause */
/* Counts the particles and copies that each rank of a layout would hold. Read check_parts.h first. */
#include "front/program/check_parts.h"
#include "kernel/comm/copies.h"
#include "kernel/comm/domain_grid.h"
#include "base/memory.h"
#include "engine/load_balance.h"
#include <math.h>
#include <stdio.h>

/* Bricks, and what they hold. */
struct bricks {
    const struct box *box;
    int grid[3];
    uint64_t *owned, *copies;
};

/* The brick of a coordinate along axis d, without regard to sides. */
static int brick_at(const struct bricks *bricks, int d, double x) {
    double at = floor(x / bricks->box->edge[d] * bricks->grid[d]);
    return (int)fmin(fmax(at, -bricks->grid[d]), 2 * bricks->grid[d] - 1);
}

/* Squared distance along axis d from x to brick k, an image of a brick if k lies beyond a side. */
static double apart2(const struct bricks *bricks, int d, int k, double x) {
    double width = bricks->box->edge[d] / bricks->grid[d], low = k * width - x, high = x - (k + 1) * width;
    bool first = !bricks->box->periodic[d] && k == 0,
         last = !bricks->box->periodic[d] && k == bricks->grid[d] - 1;
    double apart = fmax(first ? 0 : low, last ? 0 : high);
    return apart > 0 ? apart * apart : 0;
}

/* Counts a particle at its brick, and its copies at all bricks and images within `reach` of its centre. */
static void count(const struct bricks *bricks, const double position[3], double reach) {
    int low[3], high[3], own[3];
    double x[3];
    for (int d = 0; d < 3; d++) {
        const int n = bricks->grid[d];
        double edge = bricks->box->edge[d];
        x[d] = bricks->box->periodic[d] ? position[d] - floor(position[d] / edge) * edge : position[d];
        own[d] = brick_at(bricks, d, x[d]);
        own[d] = own[d] < 0 ? 0 : own[d] >= n ? n - 1 : own[d];
        low[d] = n == 1 ? own[d] : brick_at(bricks, d, x[d] - reach);
        high[d] = n == 1 ? own[d] : brick_at(bricks, d, x[d] + reach);
        if (!bricks->box->periodic[d]) {
            low[d] = low[d] < 0 ? 0 : low[d] >= n ? n - 1 : low[d];
            high[d] = high[d] < 0 ? 0 : high[d] >= n ? n - 1 : high[d];
        }
    }
    for (int k = low[2]; k <= high[2]; k++)
        for (int j = low[1]; j <= high[1]; j++)
            for (int i = low[0]; i <= high[0]; i++) {
                const int *n = bricks->grid;
                bool home = i == own[0] && j == own[1] && k == own[2];
                double far2 =
                    apart2(bricks, 0, i, x[0]) + apart2(bricks, 1, j, x[1]) + apart2(bricks, 2, k, x[2]);
                int brick = (i + n[0]) % n[0] + n[0] * ((j + n[1]) % n[1] + n[1] * ((k + n[2]) % n[2]));
                bricks->owned[brick] += home;
                bricks->copies[brick] += !home && far2 <= reach * reach;
            }
}

static void fill(const struct bricks *bricks, const struct particles *particles,
                 const struct size_classes *classes, bool reduced) {
    double reach[CLASS_MAX];
    copies_reach(classes, reduced, reach);
    for (size_t k = 0; k < particles->owned; k++) {
        const struct particle_state *p = &particles->state[k];
        double far = reach[particles->size_class[k]];
        count(bricks, p->x, isfinite(far) ? p->radius + far : 0);
    }
}

static void print_range(const char *what, const uint64_t *value, int n) {
    uint64_t least = value[0], most = value[0], sum = 0;
    for (int k = 0; k < n; k++) {
        least = value[k] < least ? value[k] : least;
        most = value[k] > most ? value[k] : most;
        sum += value[k];
    }
    printf("  %-22s %llu to %llu, %.1f on average\n", what, (unsigned long long)least,
           (unsigned long long)most, (double)sum / n);
}

static void print(const struct bricks *bricks, size_t particles, int ranks, int threads) {
    uint64_t most = 0, owned = 0;
    for (int k = 0; k < ranks; k++) {
        uint64_t here = bricks->owned[k] + bricks->copies[k];
        most = here > most ? here : most;
        owned = bricks->owned[k] > owned ? bricks->owned[k] : owned;
    }
    double each = particles ? (double)memory_in_use() / (double)particles : 0;
    printf("\non %d rank%s of %d thread%s (%lld cores)\n", ranks, ranks == 1 ? "" : "s", threads,
           threads == 1 ? "" : "s", (long long)ranks * threads);
    printf("  %-22s %d x %d x %d\n", "bricks", bricks->grid[0], bricks->grid[1], bricks->grid[2]);
    print_range("particles of a rank", bricks->owned, ranks);
    print_range("copies of a rank", bricks->copies, ranks);
    printf("  %-22s about %.1f MiB on the fullest rank\n", "memory", each * (double)most / 1048576);
    printf("  %-22s %.0f on the fullest rank\n", "particles of a thread", (double)owned / threads);
    if ((double)owned * ranks > 1.3 * (double)particles)
        printf("  the fullest rank has %.2g times the mean: domain: bisection divides the particles more "
               "evenly\n",
               (double)owned * ranks / (double)particles);
}

bool layout_print(const struct simulation *s, int ranks, int threads, struct error *error) {
    struct bricks bricks = {.box = &s->box};
    double *density = load_map(s->particles, &s->box, s->comm);
    bool good = domain_grid_choose(ranks, &s->box, s->scene->domain.grid, density, bricks.grid);
    memory_free(density);
    if (!good)
        return domain_grid_refuse(ranks, &s->box, s->scene->domain.grid, error);
    bricks.owned = memory_allocate_zero((size_t)ranks, sizeof *bricks.owned, "layout");
    bricks.copies = memory_allocate_zero((size_t)ranks, sizeof *bricks.copies, "layout");
    fill(&bricks, s->particles, &s->classes, s->scene->ghosts.reduced);
    print(&bricks, s->particles->owned, ranks, threads);
    memory_free(bricks.owned);
    memory_free(bricks.copies);
    return true;
}
