/* SPDX-License-Identifier: BSD-3-Clause */
/* The overlap of the last evaluation against its guard, and the energies of grains. Read grains.h first. */
#include "engine/trip.h"
#include "physics/grains/grains_own.h"
#include "base/memory.h"
#include "kernel/particles/kinds.h"
#include <stdio.h>

/* Particles whose energies one thread adds up at a time. */
enum { ENERGY_CHUNK = 4096 };

/* The name of a partner by id: of a wall (negative id), or of a particle, with its place if this rank knows it. */
static void name_partner(const struct physics_context *context, int64_t id, char text[TRIP_NAME_MAX]) {
    const struct particles *particles = context->particles;
    if (id < 0 && -id <= context->scene->walls) {
        snprintf(text, TRIP_NAME_MAX, "wall '%s'", context->scene->wall[-id - 1].name);
        return;
    }
    for (size_t k = 0; k < particles->owned + particles->ghosts; k++)
        if (particles->id[k] == id) {
            trip_name(particles, context->box, k, text);
            return;
        }
    snprintf(text, TRIP_NAME_MAX, "particle %lld", (long long)id);
}

void grains_guard(const struct physics_context *context, struct error *error) {
    struct grains *grains = context->self;
    const struct scene_guards *guards = &context->scene->guards;
    if (guards->overlap == SCENE_GUARD_OFF || !(grains->sums.overlap_max > guards->overlap_bound))
        return;
    char text[640], one[TRIP_NAME_MAX], other[TRIP_NAME_MAX];
    name_partner(context, grains->sums.overlap_id[0], one);
    name_partner(context, grains->sums.overlap_id[1], other);
    snprintf(text, sizeof text,
             "guards.overlap: %s and %s overlap by %.3g of the smaller radius (bound %g) at step %llu, "
             "t = %.9g",
             one, other, grains->sums.overlap_max, guards->overlap_bound,
             (unsigned long long)context->clock->step, context->clock->time);
    trip(guards->overlap, text, error, context->log, &grains->warned);
}

/* Energy of the free grains among the owned particles [first, last) in gravity; across periodic sides particles
 * go on. */
static double gravity_of(const struct physics_context *context, size_t first, size_t last) {
    const struct particles *particles = context->particles;
    int32_t(*const image)[3] = particles_images(particles);
    const uint8_t *kind = kinds_of(particles);
    const double *g = context->scene->gravity;
    double sum = 0, shift[3] = {0, 0, 0};
    if (g[0] == 0 && g[1] == 0 && g[2] == 0)
        return 0;
    for (size_t k = first; k < last; k++) {
        const struct particle_state *p = &particles->state[k];
        bool counts = p->inverse_mass > 0 && (kind == NULL || kind[k] == KIND_GRAIN);
        if (image)
            box_unwrap(context->box, image[k], shift);
        for (int d = 0; counts && d < 3; d++)
            sum -= g[d] / p->inverse_mass * (p->x[d] + context->box->origin[d] + shift[d]);
    }
    return sum;
}

/* Particles go chunk by chunk, the chunks in order, whatever the number of threads. */
static void motion_energies(const struct physics_context *context, double energy[GRAINS_ENERGIES]) {
    const struct grains *grains = context->self;
    size_t owned = context->particles->owned, chunks = owned / ENERGY_CHUNK + 1;
    double(*part)[GRAINS_GRAVITY + 1] = memory_allocate_zero(chunks, sizeof *part, "energies");
#pragma omp parallel for schedule(static)
    for (size_t c = 0; c < chunks; c++) {
        size_t first = c * ENERGY_CHUNK, last = first + ENERGY_CHUNK < owned ? first + ENERGY_CHUNK : owned;
        integrator_energies(context->particles, &grains->motion, first, last, part[c]);
        part[c][GRAINS_GRAVITY] = gravity_of(context, first, last);
    }
    for (size_t c = 0; c < chunks; c++)
        for (int k = GRAINS_KINETIC; k <= GRAINS_GRAVITY; k++)
            energy[k] += part[c][k];
    memory_free(part);
}

/* Springs that take all of the slip are longer than friction loads them: they do not count in a balance without work. */
void grains_energies(const struct physics_context *context, bool mechanical, double energy[GRAINS_ENERGIES]) {
    const struct grains *grains = context->self;
    const struct law_options *law = &grains->law.options;
    bool longer = law->sliding == LAW_SLIDING_TOTAL || law->lammps_history || law->lammps_granular;
    motion_energies(context, energy);
    energy[GRAINS_NORMAL] = grains->sums.elastic_normal;
    energy[GRAINS_TANGENTIAL] = mechanical && longer ? 0 : grains->sums.elastic_tangential;
    energy[GRAINS_TAKEN] = mechanical ? 0 : grains->taken;
}
