/* SPDX-License-Identifier: BSD-3-Clause */
/* A step and its checks, for runs and for other programs. Read checked.h first. */
#include "engine/checked.h"
#include "engine/guards.h"
#include "engine/step.h"
#include "engine/timing.h"

enum { FINITE_EVERY = 100 };

void checked_step(struct simulation *s, bool sums, bool rebuild, bool seen) {
    int64_t every = s->scene->step.rebuild_every;
    uint64_t next = s->clock.step + 1;
    s->evaluation.virial = sums || s->servo.on;
    s->evaluation.sums =
        s->evaluation.virial || s->sums_each_step || guards_energy_due(&s->guards.energy, next);
    s->search.sorts = s->search.sorts || rebuild; /* the caller writes the state, or has changed it */
    step_run(s, rebuild || (every > 0 && next % (uint64_t)every == 0));
    if (seen || next % FINITE_EVERY == 0)
        guards_check_finite(s->particles, &s->box, &s->physics, &s->clock, &s->error);
    if (guards_energy_due(&s->guards.energy, next))
        guards_check_energy(s);
    if (timing_due(&s->timing, s->scene, next))
        timing_look(s);
}
