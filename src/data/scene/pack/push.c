/* SPDX-License-Identifier: BSD-3-Clause */
/* One sweep: the pushes of all pairs, then the moves. Read push.h and relax.h first. */
#include "data/scene/pack/relax.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

/* Unit of a push: `units` of them are the smallest radius times the stiffness of two smallest spheres. */
static const double units = 0x1p26;

struct pushes *push_create(size_t count, double smallest, double gap, int threads) {
    struct pushes *pushes = memory_allocate_zero(1, sizeof *pushes, "pushes");
    pushes->smallest = smallest;
    pushes->gap = gap;
    pushes->sum = memory_allocate_zero(count, sizeof *pushes->sum, "pushes");
    pushes->slot = memory_allocate_zero((size_t)threads, sizeof *pushes->slot, "threads' pushes");
    pushes->threads = threads;
    return pushes;
}

void push_destroy(struct pushes **pushes) {
    if (*pushes == NULL)
        return;
    for (int t = 0; t < (*pushes)->threads; t++)
        memory_free((*pushes)->slot[t]);
    memory_free((*pushes)->slot);
    memory_free((*pushes)->sum);
    memory_free(*pushes);
    *pushes = NULL;
}

/* One pair's push on j, in whole numbers; that on i is the opposite. */
struct pair_push {
    int64_t push[3], stiffness;
    double overlap; /* relative to the smaller radius; negative: apart */
};

/* False if the pair does not push. Only the sign depends on which of the two particles is i: x_j - x_i is
 * taken before the image's shift is added. */
static inline bool pair_pushes(const struct pushes *pushes, const struct particle_state *i,
                               const struct particle_state *j, const double *shift, struct pair_push *pair) {
    double d[3] = {j->x[0] - i->x[0] + shift[0], j->x[1] - i->x[1] + shift[1], j->x[2] - i->x[2] + shift[2]};
    double square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    if (i->inverse_mass + j->inverse_mass == 0)
        return false;
    double sum = i->radius + j->radius, touch = sum * (1 + pushes->gap);
    if (square >= touch * touch)
        return false;
    double distance = sqrt(square), reduced = 2 * i->radius * j->radius / (sum * pushes->smallest);
    double stiffness = reduced * reduced;
    double length = distance > 0 ? stiffness * (touch - distance) / (distance * pushes->smallest) * units : 0;
    for (int c = 0; c < 3; c++)
        pair->push[c] = llrint(length * d[c]);
    pair->stiffness = llrint(stiffness * units);
    pair->overlap = (sum - distance) / fmin(i->radius, j->radius);
    return true;
}

static inline void push_add(struct push_sum *sum, const struct pair_push *pair, int sign) {
    for (int c = 0; c < 3; c++)
        sum->push[c] += sign * pair->push[c];
    sum->stiffness += pair->stiffness;
    sum->stiffest = pair->stiffness > sum->stiffest ? pair->stiffness : sum->stiffest;
}

/* The pairs of a thread; returns the largest overlap. */
static double push_thread(struct pushes *pushes, const struct pack_search *search, int t) {
    const struct pairlist *list = search->list;
    const struct particle_state *state = search->particles->state;
    double largest = 0;
    struct pair_visit pair = pairlist_thread(list, t);
    while (pairlist_each(list, &pair)) {
        struct pair_push push;
        if (!pair_pushes(pushes, &state[pair.i], &state[pair.j], list->shift[pair.image], &push))
            continue;
        largest = fmax(largest, push.overlap);
        push_add(&pushes->sum[pair.i], &push, -1);
        if (pair_gives_both(&pair))
            push_add(&pushes->sum[pair.j], &push, 1);
        else if (pair_gives_slot(&pair))
            push_add(&pushes->slot[t][list->slot_of[pair.j]], &push, 1);
    }
    return largest;
}

/* Room for the busy particles of the present list, zeroed. */
static void prepare_slots(struct pushes *pushes, size_t slots) {
    for (int t = 0; t < pushes->threads; t++) {
        if (slots > pushes->slots)
            pushes->slot[t] =
                memory_resize(pushes->slot[t], slots, sizeof *pushes->slot[t], "threads' pushes");
        if (slots > 0)
            memset(pushes->slot[t], 0, slots * sizeof *pushes->slot[t]);
    }
    pushes->slots = slots > pushes->slots ? slots : pushes->slots;
}

double push_all(struct pushes *pushes, const struct pack_search *search) {
    const struct pairlist *list = search->list;
    double largest = 0;
    prepare_slots(pushes, list->slot_count);
#pragma omp parallel for schedule(static, 1) reduction(max : largest)
    for (int t = 0; t < list->threads; t++)
        largest = fmax(largest, push_thread(pushes, search, t));
    for (size_t s = 0; s < list->slot_count; s++) {
        struct push_sum *sum = &pushes->sum[list->busy[s]];
        for (int t = 0; t < list->threads; t++) {
            const struct push_sum *more = &pushes->slot[t][s];
            for (int c = 0; c < 3; c++)
                sum->push[c] += more->push[c];
            sum->stiffness += more->stiffness;
            sum->stiffest = more->stiffest > sum->stiffest ? more->stiffest : sum->stiffest;
        }
    }
    return largest;
}

/* Moves one particle and returns the square of its displacement. The region acts, too: it may move a particle
 * that no other one pushes. */
static double move_one(const struct pushes *pushes, const struct pile *pile, size_t k,
                       const struct push_sum *sum, double factor) {
    struct particle_state *state = &pile->particles->state[k];
    double stiffness = 2 * fmax((double)sum->stiffest, (double)sum->stiffness / 3);
    double step = stiffness > 0 ? factor * pushes->smallest / stiffness : 0;
    double square = 0, x[3];
    if (state->inverse_mass == 0)
        return 0;
    for (int c = 0; c < 3; c++)
        x[c] = state->x[c] + step * (double)sum->push[c];
    pile_hold(pile, k, x);
    for (int c = 0; c < 3; c++) {
        square += (x[c] - state->x[c]) * (x[c] - state->x[c]);
        state->x[c] = x[c];
    }
    return square;
}

void push_move(struct pushes *pushes, const struct pile *pile, double factor, double largest[CLASS_MAX]) {
    struct particles *particles = pile->particles;
    for (int c = 0; c < CLASS_MAX; c++)
        largest[c] = 0;
#pragma omp parallel
    {
        double mine[CLASS_MAX] = {0};
#pragma omp for schedule(static)
        for (size_t k = 0; k < particles->owned; k++) {
            double square = move_one(pushes, pile, k, &pushes->sum[k], factor);
            double *most = &mine[particles->size_class[k]];
            *most = fmax(*most, square);
            pushes->sum[k] = (struct push_sum){0};
        }
#pragma omp critical(push_largest)
        for (int c = 0; c < CLASS_MAX; c++)
            largest[c] = fmax(largest[c], mine[c]);
    }
    for (int c = 0; c < CLASS_MAX; c++)
        largest[c] = sqrt(largest[c]);
}
