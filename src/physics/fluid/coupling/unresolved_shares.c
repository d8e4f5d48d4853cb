/* SPDX-License-Identifier: BSD-3-Clause */
/* Shares of fluid particles around grains. Read unresolved_shares.h first. */
#include "physics/fluid/coupling/unresolved_shares.h"
#include "base/memory.h"
#include "physics/fluid/fluid_state.h"
#include "kernel/particles/kinds.h"
#include <math.h>
#include <string.h>

void unresolved_shares_destroy(struct unresolved **unresolved) {
    struct unresolved *dust = *unresolved;
    if (dust == NULL)
        return;
    memory_free(dust->share);
    memory_free(dust->of);
    memory_free(dust->end);
    memory_free(dust->seen);
    memory_free(dust->body);
    memory_free(dust->resist);
    memory_free(dust->slope);
    memory_free(dust);
    *unresolved = NULL;
}

bool unresolved_shares_has(const struct physics_context *context, size_t i) {
    const struct particles *p = context->particles;
    const struct fluid_options *options = context->options;
    return kinds_of(p)[i] == KIND_GRAIN && p->state[i].radius <= options->grains.unresolved;
}

/* The shares of grain i; false if there is no fluid around it. `kind`: of all particles. */
static bool shares_of(const struct physics_context *context, const uint8_t *kind, size_t i) {
    const struct fluid *fluid = context->self;
    const struct particle_state *state = context->particles->state;
    const double reach = fluid->support * fluid->support, *x = state[i].x;
    struct unresolved *dust = fluid->dust;
    size_t first = fluid->pairs.start[i], last = first;
    double sum = 0;
    for (size_t e = first; e < fluid->pairs.start[i + 1]; e++) {
        uint32_t partner = fluid->pairs.partner[e], j = pair_partner(partner);
        const double *shift = context->list[0]->shift[pair_image(partner)];
        double square = 0;
        for (int d = 0; d < context->box->dimension; d++) {
            double to = state[j].x[d] - x[d] + shift[d];
            square += to * to;
        }
        if (kind[j] != KIND_FLUID || !(square < reach))
            continue;
        dust->of[last] = j;
        sum += dust->share[last++] = kernel_value(&fluid->weigh.kernel, sqrt(square));
    }
    for (size_t e = first; e < last; e++)
        dust->share[e] /= sum;
    dust->end[i] = last;
    return sum > 0;
}

void unresolved_shares_mean(const struct fluid *fluid, size_t i, struct operators_values value, int count,
                            double *mean) {
    const struct unresolved *dust = fluid->dust;
    memset(mean, 0, (size_t)count * sizeof *mean);
    for (size_t e = fluid->pairs.start[i]; e < dust->end[i]; e++)
        for (int k = 0; k < count; k++)
            mean[k] += dust->share[e] * value.value[value.stride * dust->of[e] + (size_t)k];
}

/* Room for the pairs of the owned particles. */
static void reserve(struct unresolved *dust, const struct pair_rows *pairs, size_t owned) {
    static const char what[] = "grains in a fluid";
    dust->share = memory_resize(dust->share, pairs->start[owned], sizeof *dust->share, what);
    dust->of = memory_resize(dust->of, pairs->start[owned], sizeof *dust->of, what);
    dust->end = memory_resize(dust->end, owned, sizeof *dust->end, what);
    dust->seen = memory_resize(dust->seen, owned, sizeof *dust->seen, what);
}

void unresolved_shares_make(const struct physics_context *context) {
    struct fluid *fluid = context->self;
    const struct particles *p = context->particles;
    const uint8_t *kind = kinds_of(p);
    size_t lost = SIZE_MAX;
    if (fluid->dust == NULL)
        fluid->dust = memory_allocate_zero(1, sizeof *fluid->dust, "grains in a fluid");
    reserve(fluid->dust, &fluid->pairs, p->owned);
#pragma omp parallel for schedule(static) reduction(min : lost)
    for (size_t i = 0; i < p->owned; i++)
        if (unresolved_shares_has(context, i) && !shares_of(context, kind, i))
            lost = i < lost ? i : lost;
        else if (unresolved_shares_has(context, i))
            unresolved_shares_mean(fluid, i, flow_velocity(&fluid->flow), 3, fluid->dust->seen[i]);
    int64_t worst = lost == SIZE_MAX ? -1 : p->id[lost];
    comm_max_int(context->comm, &worst, 1);
    if (worst >= 0)
        error_set(&fluid->error, ERROR_PHYSICS,
                  "fluid.grains.unresolved: grain %lld has no fluid around it in step %llu, t = %.9g",
                  (long long)worst, (unsigned long long)context->clock->step, context->clock->time);
}
