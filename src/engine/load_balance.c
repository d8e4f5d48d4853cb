/* SPDX-License-Identifier: BSD-3-Clause */
/* The load of ranks, and the division of the box that follows it.
 *
 * Bricks are laid once, by the particles at the start; a bisection follows the load. A resume on as many
 * ranks keeps the division of the checkpoint.
 *
 * The weight of a particle is its cost in time. By pairs: 1, plus 1/2 for each pair in the row of the
 * particle (both about right for the force loop). By time: the same weight, scaled by the seconds that the
 * rank took for its whole weight. By particles: 1. The bisection is made again if the largest load exceeds
 * the mean by the threshold, but not if the last division could do no better: a plane cannot cut through a
 * particle. The imbalance that the last division reached is forgotten slowly, as particles come and move. */
#include "engine/load_balance.h"
#include "kernel/comm/balance.h"
#include "kernel/comm/domain_grid.h"
#include "base/memory.h"
#include <math.h>
#include <string.h>

/* Factor on the remembered imbalance above 1 of the last division, at each rebuild: a new division is tried
 * after some twenty rebuilds. */
static const double remembered = 0.995;

/* Weights of the owned particles by the last pair list; returns their sum. */
static double weights_by_pairs(const struct pairlist *list, size_t owned, double *weight) {
    double sum = 0;
    for (size_t k = 0; k < owned; k++)
        weight[k] = 1;
    struct pair_visit pair = pairlist_all(list);
    while (pairlist_each(list, &pair))
        if (pair.i < owned)
            weight[pair.i] += 0.5;
    for (size_t k = 0; k < owned; k++)
        sum += weight[k];
    return sum;
}

/* Divides the box by the positions that migration will use; false if the division stays as it is. */
static bool divide(struct ranks *ranks, const struct particles *particles, const struct box *box,
                   const struct comm *comm, const double *weight) {
    size_t owned = particles->owned;
    double(*x)[3] = memory_allocate(owned, sizeof *x, "positions");
    for (size_t k = 0; k < owned; k++)
        for (int d = 0; d < 3; d++) {
            x[k][d] = particles->state[k].x[d];
            if (!isfinite(x[k][d]))
                x[k][d] = 0; /* a guard will stop the run */
            else if (box->periodic[d])
                x[k][d] -= floor(x[k][d] / box->edge[d]) * box->edge[d];
        }
    struct balance_load load = {owned, (const double(*)[3])x, weight};
    bool divided = balance_divide(ranks->domain, comm, box, &load);
    domain_wrap(ranks->domain, ranks->wrap);
    memory_free(x);
    return divided;
}

/* The bin along axis d that contains a coordinate. */
static size_t density_bin(const struct box *box, int d, double x) {
    double at = x / box->edge[d];
    at = box->periodic[d] ? at - floor(at) : at;
    return (size_t)fmin(fmax(at * DOMAIN_DENSITY_BINS, 0), DOMAIN_DENSITY_BINS - 1);
}

double *load_map(const struct particles *particles, const struct box *box, const struct comm *comm) {
    enum { BINS = DOMAIN_DENSITY_BINS };
    double *density = memory_allocate_zero((size_t)BINS * BINS * BINS, sizeof *density, "map of particles");
    for (size_t k = 0; k < particles->owned; k++) {
        const double *x = particles->state[k].x;
        size_t bin[3];
        for (int d = 0; d < 3; d++)
            bin[d] = density_bin(box, d, x[d]);
        density[bin[0] + BINS * (bin[1] + BINS * bin[2])]++;
    }
    comm_sum(comm, density, BINS * BINS * BINS);
    return density;
}

/* True if a checkpoint's grid serves this run, too. */
static bool grid_serves(const int wanted[3], int ranks, const int grid[3]) {
    for (int d = 0; d < 3; d++)
        if (grid[d] < 1 || (wanted[d] != 0 && wanted[d] != grid[d]))
            return false;
    return (int64_t)grid[0] * grid[1] * grid[2] == ranks;
}

void load_lay(struct ranks *ranks, const struct particles *particles, const struct box *box,
              const struct comm *comm, const int wanted[3], const int resumed[3]) {
    int grid[3];
    if (ranks->alone || domain_bisects(ranks->domain))
        return;
    if (grid_serves(wanted, comm->size, resumed)) {
        memcpy(grid, resumed, sizeof grid);
    } else {
        double *density = load_map(particles, box, comm);
        domain_grid_choose(comm->size, box, wanted, density, grid);
        memory_free(density);
    }
    domain_lay(ranks->domain, grid);
    domain_wrap(ranks->domain, ranks->wrap);
}

void load_begin(struct ranks *ranks, const struct particles *particles, const struct box *box,
                const struct comm *comm) {
    if (ranks->alone || !domain_bisects(ranks->domain) || ranks->load.begun)
        return;
    ranks->load.begun = true;
    double *weight = memory_allocate(particles->owned, sizeof *weight, "weights");
    for (size_t k = 0; k < particles->owned; k++)
        weight[k] = 1;
    divide(ranks, particles, box, comm, weight);
    memory_free(weight);
}

void load_restore(struct ranks *ranks, struct domain_tree *tree, bool fresh, double reached) {
    domain_divide(ranks->domain, tree);
    domain_wrap(ranks->domain, ranks->wrap);
    ranks->load.begun = true;
    ranks->load.fresh = fresh;
    ranks->load.reached = reached;
}

/* The largest load over the mean. */
static double imbalance_of(const struct comm *comm, double load) {
    double sum = load, most = load;
    comm_sum(comm, &sum, 1);
    comm_max(comm, &most, 1);
    return sum > 0 ? most * comm->size / sum : 1;
}

void load_balance(struct simulation *s) {
    const struct domain_options *options = &s->scene->domain;
    if (s->ranks.alone || !domain_bisects(s->ranks.domain) || options->threshold == 0)
        return;
    size_t owned = s->particles->owned;
    double *weight = memory_allocate(owned, sizeof *weight, "weights");
    double sum = weights_by_pairs(s->search.list, owned, weight), load = sum;
    if (options->weights == DOMAIN_WEIGHTS_PARTICLES) {
        load = (double)owned;
        for (size_t k = 0; k < owned; k++)
            weight[k] = 1;
    } else if (options->weights == DOMAIN_WEIGHTS_TIME) {
        double seconds = timer_sum(&s->timers, TIMER_WORK, 0);
        load = fmax(seconds - s->ranks.load.seconds, 1e-9);
        s->ranks.load.seconds = seconds;
        for (size_t k = 0; k < owned; k++)
            weight[k] *= load / sum;
    }
    double imbalance = imbalance_of(s->comm, load);
    if (s->ranks.load.fresh)
        s->ranks.load.reached = imbalance;
    else
        s->ranks.load.reached = 1 + remembered * (s->ranks.load.reached - 1);
    s->ranks.load.fresh = false;
    if (imbalance > options->threshold && imbalance > 1.05 * s->ranks.load.reached) {
        s->ranks.load.fresh = divide(&s->ranks, s->particles, &s->box, s->comm, weight);
        s->ranks.load.divisions += s->ranks.load.fresh;
        s->ranks.load.reached = imbalance;
    }
    memory_free(weight);
}
