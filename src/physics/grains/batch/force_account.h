/* SPDX-License-Identifier: BSD-3-Clause */
/* Sums that the force loop takes of a batch besides the forces: the largest overlap, energies, the virial.
 * Included by force_block.c alone, which is compiled for several instruction sets. */
#ifndef SCREE_BATCH_FORCE_ACCOUNT_H
#define SCREE_BATCH_FORCE_ACCOUNT_H

#include "physics/grains/batch/force_kernel.h"

/* Updates the largest overlap so far, relative to the smaller radius, and the ids of its particles. */
static inline void force_watch(const struct particles *particles, const struct force_batch *restrict b,
                               struct force_sums *sums) {
    const struct walk_batch *restrict w = &b->walk;
    double largest = sums->overlap_max;
    int above = 0;
#pragma omp simd reduction(| : above)
    for (int k = 0; k < w->padded; k++)
        above |=
            b->overlap[k] > largest * (w->radius[0][k] < w->radius[1][k] ? w->radius[0][k] : w->radius[1][k]);
    for (int k = 0; above && k < w->count; k++) {
        double relative = b->overlap[k] / fmin(w->radius[0][k], w->radius[1][k]);
        if (relative <= sums->overlap_max)
            continue;
        sums->overlap_max = relative;
        sums->overlap_id[0] = particles->id[w->i[k]];
        sums->overlap_id[1] = particles->id[w->j[k]];
    }
}

/* Weighted sum over the batch, in an order that all instruction sets keep. */
static inline double force_weighted(const struct force_batch *b, const double *restrict value,
                                    const double *restrict weight) {
    double lane[FORCE_LANES] = {0.0}, sum = 0.0;
    for (int k = 0; k < b->walk.padded; k += FORCE_LANES)
        for (int l = 0; l < FORCE_LANES; l++)
            lane[l] += weight[k + l] * value[k + l];
    for (int l = 0; l < FORCE_LANES; l++)
        sum += lane[l];
    return sum;
}

/* force_add_virial without rounding, and the energy of the contact. */
static inline void force_add_exact(struct force_exact *exact, double weight, double energy, const double d[3],
                                   const double f[3]) {
    double term[6] = {0};
    force_add_virial(term, weight, d, f);
    for (int c = 0; c < 6; c++)
        exact_add(&exact->sum[c], term[c]);
    exact_add(&exact->sum[6], weight * energy);
}

/* Energies of the batch, and if wanted the virial. */
static inline void force_account(const struct force_context *context, struct force_thread *thread) {
    const struct force_batch *b = &thread->batch;
    struct force_sums *sums = &thread->sums;
    double weight[FORCE_BATCH];
    walk_weigh(&b->walk, weight);
    sums->elastic_normal += force_weighted(b, b->energy[0], weight);
    sums->elastic_tangential += force_weighted(b, b->energy[1], weight);
    sums->taken += force_weighted(b, b->energy[2], weight);
    for (int k = 0; context->want_virial && k < b->walk.count; k++)
        force_add_virial(sums->virial, weight[k], b->walk.record[k], b->walk.share[k]);
    for (int k = 0; context->want_virial && thread->exact && k < b->walk.count; k++)
        force_add_exact(thread->exact, weight[k], b->energy[0][k], b->walk.record[k], b->walk.share[k]);
}

/* Writes down the work of each contact of the batch. */
static inline void force_put_work(const struct walk_task *task, const struct force_batch *b) {
    const struct force_context *context = task->work->context;
    for (int k = 0; k < b->walk.count; k++)
        context->pair_work[task->pair_base + b->walk.pair[k]] =
            (struct force_work){b->energy[2][k], b->energy[1][k]};
}

#endif
