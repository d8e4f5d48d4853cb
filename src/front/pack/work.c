/* SPDX-License-Identifier: BSD-3-Clause */
/* The common part of all packings: spheres at random places, relaxed until none overlap. Read pack.h
 * first. */
#include "front/pack/work.h"

#include "base/random.h"

#include <math.h>

void work_add(struct pack_work *work, int64_t id, double radius) {
    size_t k = particles_append(work->particles);
    work->particles->id[k] = id;
    work->particles->state[k].radius = radius;
}

bool work_place(struct pack_work *work, struct error *error) {
    struct particles *particles = work->particles;
    double part = work->container.shape == PACK_MESH ? 1 + work->options->gap : 1, homeless = 0;
#pragma omp parallel for schedule(dynamic, 64) reduction(max : homeless)
    for (size_t k = 0; k < particles->owned; k++) {
        struct particle_state *state = &particles->state[k];
        struct random_sequence random =
            random_sequence((uint64_t)work->options->seed, RANDOM_POSITION, (uint64_t)particles->id[k]);
        if (!container_draw(&work->container, part * state->radius, &random, state->x))
            homeless = fmax(homeless, state->radius);
    }
    return homeless == 0 ||
           error_set(
               error, ERROR_USER,
               "%s: no place inside was found for a sphere of radius %g: smaller spheres are needed, or a "
               "larger mesh (scaled=)",
               work->options->file, homeless);
}

struct relay {
    const struct pack_hook *hook;
    const char *what;
};

static void relay_show(void *context, const struct relax_state *state) {
    const struct relay *relay = context;
    relay->hook->show(relay->hook->context, relay->what, state);
}

bool work_relax(struct pack_work *work, const char *what, struct error *error) {
    const struct pack_options *o = work->options;
    struct relay relay = {.hook = work->hook, .what = what};
    struct relax_options options = {.gap = o->gap,
                                    .bound = o->overlap,
                                    .sweeps = (int)o->sweeps,
                                    .threads = work->threads,
                                    .show = work->hook ? relay_show : NULL,
                                    .context = &relay};
    struct relax_state state;
    bool good = relax_run(work->particles, &work->container, &options, &state, error);
    work->report->sweeps += state.sweep;
    return good;
}
