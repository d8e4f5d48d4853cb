/* SPDX-License-Identifier: BSD-3-Clause */
/* The common part of all packings: spheres at random places, relaxed until none overlap. Read pack.h
 * first. */
#include "pack/work.h"

#include "core/random.h"

void work_add(struct pack_work *work, int64_t id, double radius) {
    struct random_sequence random =
        random_sequence((uint64_t)work->options->seed, RANDOM_POSITION, (uint64_t)id);
    size_t k = particles_append(work->particles);
    struct particle_state *state = &work->particles->state[k];
    work->particles->id[k] = id;
    state->radius = radius;
    for (int c = 0; c < 3; c++) {
        double room = work->box.periodic[c] ? 0 : radius;
        state->x[c] = room + (work->box.edge[c] - 2 * room) * random_uniform(&random);
    }
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
    bool good = relax_run(work->particles, &work->box, &options, &state, error);
    work->report->sweeps += state.sweep;
    return good;
}
