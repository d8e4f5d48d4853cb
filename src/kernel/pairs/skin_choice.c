/* SPDX-License-Identifier: BSD-3-Clause */
/* The cost of a step as a function of the skin, and its minimum. Read skin_choice.h first. */
#include "kernel/pairs/skin_choice.h"
#include <math.h>

/* A change must save this part of the cost. */
static const double worth = 0.02;

double skin_choice_factor(int64_t octaves) {
    return exp2((double)octaves / 4);
}

void skin_choice_add(struct skin_choice *choice, double used, double steps) {
    double fade = choice->steps > 0 ? choice->steps / (choice->steps + steps) : 0;
    choice->used = fade * choice->used + used;
    choice->steps = fade * choice->steps + steps;
}

static double power(double x, int dimension) {
    return dimension == 2 ? x * x : x * x * x;
}

/* The volume of the shells beyond touch over all pairs of particles, up to a common factor; `scale`: of the
 * skins. */
static double shells(const struct size_classes *classes, int dimension, double scale) {
    double sum = 0;
    for (int a = 0; a < classes->count; a++)
        for (int b = 0; b <= a; b++) {
            if (!classes_meet(classes, a, b))
                continue;
            double skin = classes->skin[a][b];
            double touch = sqrt(classes->radius_min[a] * classes->radius_max[a]) +
                           sqrt(classes->radius_min[b] * classes->radius_max[b]) + classes->margin[a][b] -
                           skin;
            double pairs = (double)classes->population[a] * (double)classes->population[b] / (a == b ? 2 : 1);
            touch = fmax(touch, 0);
            sum += pairs * (power(touch + scale * skin, dimension) - power(touch, dimension));
        }
    return sum;
}

double skin_choice_pairs(const struct size_classes *classes, const struct skin_counts *counts, int64_t now,
                         int64_t octaves) {
    double here = shells(classes, counts->dimension, 1);
    double there = shells(classes, counts->dimension, skin_choice_factor(octaves) / skin_choice_factor(now));
    double touching = fmin(counts->contacts, counts->pairs);
    return here > 0 ? touching + (counts->pairs - touching) * there / here : counts->pairs;
}

double skin_choice_cost(const struct size_classes *classes, const struct skin_counts *counts, int64_t now,
                        int64_t octaves) {
    double pairs = skin_choice_pairs(classes, counts, now, octaves);
    double steps = counts->rate > 0 ? skin_choice_factor(octaves) / counts->rate : INFINITY;
    if (counts->every > 0)
        steps = fmin(steps, counts->every);
    return pairs + (SKIN_PARTICLE * counts->particles + SKIN_PAIR * pairs) / fmax(steps, 1);
}

int64_t skin_choice_best(const struct size_classes *classes, const struct skin_counts *counts, int64_t now,
                         int64_t most) {
    int64_t best = now;
    double present = skin_choice_cost(classes, counts, now, now), least = (1 - worth) * present;
    if (now > most)
        least = INFINITY;
    double room = SKIN_PAIRS_MOST * counts->particles;
    for (int64_t k = now - SKIN_LEAP; k <= now + SKIN_LEAP; k++) {
        if (k < SKIN_LEAST || k > SKIN_MOST || k > most || k == now)
            continue;
        if (k > 0 && k > now && skin_choice_pairs(classes, counts, now, k) > room)
            continue;
        double cost = skin_choice_cost(classes, counts, now, k);
        if (cost < least) {
            least = cost;
            best = k;
        }
    }
    return best;
}
