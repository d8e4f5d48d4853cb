/* What the force loop notes of a batch beside forces: the largest overlap, energies, the virial. Included by
 * force_block.c alone, which is compiled for several instruction sets. */
#ifndef SCREE_CONTACT_FORCE_ACCOUNT_H
#define SCREE_CONTACT_FORCE_ACCOUNT_H

#include "contact/force_kernel.h"

/* How many of the batch's contacts, which run in the order of pairs, lie before pair `end` of the list. */
static inline int force_before(const struct force_task *task, size_t end) {
    const struct force_batch *b = &task->thread->batch;
    int low = 0, high = b->count;
    while (low < high) {
        int middle = (low + high) / 2;
        if (b->pair[middle] + task->pair_base < end)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* The largest overlap so far, relative to the smaller radius, and whose. */
static inline void force_watch(const struct force_task *task) {
    const struct force_batch *restrict b = &task->thread->batch;
    struct force_sums *sums = &task->thread->sums;
    double largest = sums->overlap_max;
    int above = 0;
#pragma omp simd reduction(| : above)
    for (int k = 0; k < b->padded; k++)
        above |=
            b->overlap[k] > largest * (b->radius[0][k] < b->radius[1][k] ? b->radius[0][k] : b->radius[1][k]);
    for (int k = 0; above && k < b->count; k++) {
        double relative = b->overlap[k] / fmin(b->radius[0][k], b->radius[1][k]);
        if (relative <= sums->overlap_max)
            continue;
        sums->overlap_max = relative;
        sums->overlap_id[0] = task->context->particles->id[b->i[k]];
        sums->overlap_id[1] = task->context->particles->id[b->j[k]];
    }
}

/* What each contact of the batch counts in sums over contacts: a one-sided pair half, what pads nothing. */
static inline void force_weigh(const struct force_task *task, double *weight) {
    int count = task->thread->batch.count;
    int both = force_before(task, task->block->one_sided), one = force_before(task, task->block->slotted);
    for (int k = 0; k < FORCE_BATCH; k++)
        weight[k] = k >= count ? 0.0 : k >= both && k < one ? 0.5 : 1.0;
}

/* Weighted sum over the batch, in an order that all instruction sets keep. */
static inline double force_weighted(const struct force_batch *b, const double *restrict value,
                                    const double *restrict weight) {
    double lane[FORCE_LANES] = {0.0}, sum = 0.0;
    for (int k = 0; k < b->padded; k += FORCE_LANES)
        for (int l = 0; l < FORCE_LANES; l++)
            lane[l] += weight[k + l] * value[k + l];
    for (int l = 0; l < FORCE_LANES; l++)
        sum += lane[l];
    return sum;
}

/* Energies of the batch. */
static inline void force_account(const struct force_task *task, const double *weight) {
    const struct force_batch *b = &task->thread->batch;
    struct force_sums *sums = &task->thread->sums;
    sums->elastic_normal += force_weighted(b, b->energy[0], weight);
    sums->elastic_tangential += force_weighted(b, b->energy[1], weight);
    sums->taken += force_weighted(b, b->energy[2], weight);
}

/* Virial of the batch. */
static void force_account_virial(const struct force_task *task, const double *weight) {
    const struct force_batch *b = &task->thread->batch;
    struct force_sums *sums = &task->thread->sums;
    for (int k = 0; k < b->count; k++)
        force_add_virial(sums->virial, weight[k], b->record[k], b->share[k]);
}

static inline void force_sum(const struct force_task *task) {
    double weight[FORCE_BATCH];
    if (!task->energies)
        return;
    force_weigh(task, weight);
    force_account(task, weight);
    if (task->context->want_virial)
        force_account_virial(task, weight);
}

#endif
