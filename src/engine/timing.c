/* SPDX-License-Identifier: BSD-3-Clause */
/* The time step of a run: given, or a fraction of the stable step; a step above the stable step is refused.
 * The stable step depends on the speeds of the particles at the start, so a resume with the same rule keeps
 * the step of the checkpoint. */
#include "engine/timing.h"
#include "engine/trip.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Contacts are checked every so many steps; the time step may be at most this part of the stable step. */
enum { LOOK_EVERY = 500 };
#define LOOK_PART 0.9

/* The fraction of the stable step that a run takes if its scene gives none. */
static double default_fraction(const struct physics_active *mover) {
    return mover->row->mover->fraction ? mover->row->mover->fraction() : 1;
}

static void dt_set(struct clock *clock, struct evaluation *evaluation, const struct physics_set *set,
                   double dt) {
    clock->dt = evaluation->dt = dt;
    physics_prepare(set);
}

/* Writes what sets the stable time step. Collective. */
static void why_find(struct timing *timing, const struct physics_set *set) {
    const struct physics_mover *mover = set->mover->row->mover;
    const char *other = physics_limit_why(set, timing->stable);
    char *why = timing->why;
    size_t room = sizeof timing->why;
    if (other)
        snprintf(why, room, "%s", other);
    else if (timing->stable < timing->expected)
        snprintf(why, room, "of the contacts that there are at the start");
    else if (mover->why)
        mover->why(&set->mover->context, why, room);
    else
        snprintf(why, room, "of the motion of grains");
}

static bool dt_allowed(struct timing *timing, const struct physics_set *set, const struct scene *scene,
                       double dt, struct error *error) {
    char place[SCENE_PATH_MAX];
    if (isfinite(timing->stable))
        why_find(timing, set);
    if (dt <= timing->stable || scene->step.force)
        return true;
    if (scene->step.fraction > 1)
        return error_set(
            error, ERROR_USER,
            "%s: step.fraction: %g of the stable time step, %.6g (%s), is more than all of it; allowed: "
            "up to 1, or step.force: true",
            scene_place(scene, "step.fraction", place, sizeof place), scene->step.fraction, timing->stable,
            timing->why);
    return error_set(error, ERROR_USER,
                     "%s: step.dt: the time step %.6g is above the stable one, %.6g (%s); allowed: up to "
                     "that, or step.force: true",
                     scene_place(scene, "step.dt", place, sizeof place), dt, timing->stable, timing->why);
}

bool timing_choose(struct simulation *s, struct error *error) {
    const struct scene_step *step = &s->scene->step;
    char place[SCENE_PATH_MAX];
    const struct physics_active *mover = s->physics.mover;
    s->timing.stable = mover->row->mover->expected ? mover->row->mover->expected(&mover->context) : INFINITY;
    if (!isfinite(s->timing.stable))
        s->timing.stable = physics_limit(&s->physics, INFINITY, false);
    s->timing.expected = s->timing.stable;
    if (step->dt > 0) {
        s->clock.dt = step->dt;
    } else {
        double fraction = step->fraction > 0 ? step->fraction : default_fraction(mover);
        if (!isfinite(s->timing.stable))
            return error_set(
                error, ERROR_USER,
                "%s: step.dt is needed: without free particles that touch there is no stable time "
                "step to take a fraction of",
                scene_place(s->scene, "step", place, sizeof place));
        bool goes_on = s->resumed.fraction == fraction && s->resumed.dt <= s->timing.stable;
        s->clock.dt_fraction = fraction;
        s->clock.dt = goes_on ? s->resumed.dt : fraction * s->timing.stable;
    }
    dt_set(&s->clock, &s->evaluation, &s->physics, s->clock.dt);
    return dt_allowed(&s->timing, &s->physics, s->scene, s->clock.dt, error);
}

/* Changes the length of steps from now on. */
static void dt_change(struct clock *clock, struct evaluation *evaluation, const struct physics_set *set,
                      double dt) {
    clock->step_base = clock->step;
    clock->time_base = clock->time;
    dt_set(clock, evaluation, set, dt);
}

bool timing_contacts(struct simulation *s, struct error *error) {
    s->timing.stable = physics_limit(&s->physics, s->timing.stable, false);
    if (!isfinite(s->timing.stable))
        return true;
    if (s->clock.dt_fraction > 0 && s->clock.dt > s->clock.dt_fraction * s->timing.stable &&
        (s->resumed.dt != s->clock.dt || s->clock.dt > s->timing.stable))
        dt_change(&s->clock, &s->evaluation, &s->physics, s->clock.dt_fraction * s->timing.stable);
    return dt_allowed(&s->timing, &s->physics, s->scene, s->clock.dt, error);
}

bool timing_due(const struct timing *timing, const struct scene *scene, uint64_t step) {
    return step % LOOK_EVERY == 0 && isfinite(timing->stable) && !scene->step.force &&
           scene->guards.step != SCENE_GUARD_OFF;
}

void timing_look(struct simulation *s) {
    double stable = physics_limit(&s->physics, s->clock.dt / LOOK_PART, true), before = s->clock.dt;
    char text[256];
    s->timing.stable = fmin(s->timing.stable, stable);
    if (s->clock.dt <= LOOK_PART * stable)
        return;
    if (s->clock.dt_fraction > 0) {
        const struct physics_active *mover = s->physics.mover;
        dt_change(&s->clock, &s->evaluation, &s->physics, fmin(s->clock.dt_fraction, LOOK_PART) * stable);
        if (mover->row->mover->stagger) /* to half a new step back */
            mover->row->mover->stagger(&mover->context, s->clock.dt - before);
        if (s->comm->rank == 0)
            log_tell(&s->caller.log,
                     "note: contacts have become stiffer: the time step is %.4g from step %llu on, "
                     "it was %.4g",
                     s->clock.dt, (unsigned long long)s->clock.step, before);
        return;
    }
    snprintf(
        text, sizeof text,
        "guards.step: the time step %.6g is %.3g of what is surely stable for the contacts at step %llu, "
        "t = %.9g: energy may grow",
        s->clock.dt, s->clock.dt / stable, (unsigned long long)s->clock.step, s->clock.time);
    if (s->comm->rank == 0 || s->scene->guards.step != SCENE_GUARD_WARN) /* one rank warns */
        trip(s->scene->guards.step, text, &s->error, &s->caller.log, &s->guards.warned[GUARD_STEP]);
}
