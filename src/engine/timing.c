/* SPDX-License-Identifier: BSD-3-Clause */
/* The time step of a run: given, or a fraction of the stable step; a step above the stable step is refused.
 * The stable step depends on the speeds of the particles at the start, so a resume with the same rule keeps
 * the step of the checkpoint. */
#include "engine/timing.h"
#include "particles/material.h"
#include "engine/guards.h"
#include "engine/overlaps.h"
#include "particles/kinds.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Contacts are checked every so many steps; the time step may be at most this part of the stable step. */
enum { LOOK_EVERY = 500 };
#define LOOK_PART 0.9

/* The largest speed expected of an impact, however long the run: from the scene, else the speed of the fastest particle
 * now, or of an insertion, or of a fall through the box. */
static double speed_expected(const struct simulation *s, const struct sorts *sorts) {
    const struct scene *scene = s->scene;
    double fall = 0;
    if (scene->step.speed_max > 0)
        return scene->step.speed_max;
    for (int d = 0; d < 3; d++)
        if (!scene->box.periodic[d])
            fall += 2 * fabs(scene->gravity[d]) * scene->box.edge[d];
    return sqrt(fmax(fall, sorts->fastest));
}

static void limits_find(struct simulation *s, const struct sorts *sorts) {
    struct timestep_kind kind[SORTS_MAX + LAW_MATERIALS_MAX];
    int n = 0;
    for (int k = 0; k < SORTS_MAX; k++)
        if (sorts->radius_max[k] > 0) {
            double least = sorts->radius_min[k];
            kind[n++] = (struct timestep_kind){.material = sorts_material(k),
                                               .radius_min = least,
                                               .radius_max = sorts->radius_max[k],
                                               .mass_min = sorts->lightest[k] * (least * least * least)};
        }
    for (int m = 0; m < s->scene->materials; m++)
        if (sorts->fixed[m] > 0)
            kind[n++] = (struct timestep_kind){.material = m, .wall = true};
    timestep_limits(&s->timing.limits, &(struct timestep_input){.law = &s->grains.law,
                                                                .kinds = n,
                                                                .kind = kind,
                                                                .material = s->scene->material,
                                                                .speed_max = speed_expected(s, sorts),
                                                                .contacts = s->scene->step.contacts,
                                                                .dimension = s->box.dimension});
}

static void dt_set(struct simulation *s, double dt) {
    s->clock.dt = s->grains.motion.dt = s->grains.contact.dt = dt;
}

static bool dt_allowed(const struct simulation *s, struct error *error) {
    char place[SCENE_PATH_MAX], why[256];
    if (s->clock.dt <= s->timing.limits.stable || s->scene->step.force)
        return true;
    const char *other = physics_limit_why(&s->physics, s->timing.limits.stable);
    if (other)
        snprintf(why, sizeof why, "%s", other);
    else if (s->timing.limits.stable < s->timing.expected)
        snprintf(why, sizeof why, "of the contacts that there are at the start");
    else
        snprintf(why, sizeof why, "contact between materials '%s' and '%s', damping ratio %.3g",
                 s->scene->material[s->timing.limits.material_a].name,
                 s->scene->material[s->timing.limits.material_b].name, s->timing.limits.damping_ratio + 0.0);
    return error_set(error, ERROR_USER,
                     "%s: step.dt: the time step %.6g is above the stable one, %.6g (%s); allowed: up to "
                     "that, or step.force: true",
                     scene_place(s->scene, "step.dt", place, sizeof place), s->clock.dt,
                     s->timing.limits.stable, why);
}

bool timing_choose(struct simulation *s, struct error *error) {
    const struct scene_step *step = &s->scene->step;
    char place[SCENE_PATH_MAX];
    struct sorts sorts;
    sorts_collect(s, &sorts);
    limits_find(s, &sorts);
    if (!isfinite(s->timing.limits.stable))
        s->timing.limits.stable = physics_limit(&s->physics, INFINITY);
    s->timing.expected = s->timing.limits.stable;
    if (step->dt > 0) {
        s->clock.dt = step->dt;
    } else {
        double fraction = step->fraction > 0 ? step->fraction : timestep_default_fraction();
        if (!isfinite(s->timing.limits.stable))
            return error_set(
                error, ERROR_USER,
                "%s: step.dt is needed: without free particles that touch there is no stable time "
                "step to take a fraction of",
                scene_place(s->scene, "step", place, sizeof place));
        bool goes_on = s->resumed.fraction == fraction && s->resumed.dt <= s->timing.limits.stable;
        s->clock.dt_fraction = fraction;
        s->clock.dt = goes_on ? s->resumed.dt : fraction * s->timing.limits.stable;
    }
    dt_set(s, s->clock.dt);
    overlaps_expect(s, &sorts);
    return dt_allowed(s, error);
}

/* Changes the length of steps from now on. */
static void dt_change(struct simulation *s, double dt) {
    s->clock.step_base = s->clock.step;
    s->clock.time_base = s->clock.time;
    dt_set(s, dt);
}

bool timing_contacts(struct simulation *s, struct error *error) {
    s->timing.limits.stable = physics_limit(&s->physics, s->timing.limits.stable);
    if (!isfinite(s->timing.limits.stable))
        return true;
    if (s->clock.dt_fraction > 0 && s->clock.dt > s->clock.dt_fraction * s->timing.limits.stable &&
        (s->resumed.dt != s->clock.dt || s->clock.dt > s->timing.limits.stable))
        dt_change(s, s->clock.dt_fraction * s->timing.limits.stable);
    return dt_allowed(s, error);
}

bool timing_due(const struct simulation *s, uint64_t step) {
    return step % LOOK_EVERY == 0 && isfinite(s->timing.limits.stable) && !s->scene->step.force &&
           s->scene->guards.step != SCENE_GUARD_OFF;
}

void timing_look(struct simulation *s) {
    double stable = physics_limit(&s->physics, s->clock.dt / LOOK_PART), before = s->clock.dt;
    char text[256];
    s->timing.limits.stable = fmin(s->timing.limits.stable, stable);
    if (s->clock.dt <= LOOK_PART * stable)
        return;
    if (s->clock.dt_fraction > 0) {
        struct integrator_context shift = s->grains.motion;
        dt_change(s, fmin(s->clock.dt_fraction, LOOK_PART) * stable);
        shift.dt = s->clock.dt - before; /* moves velocities to half a new step back */
        struct kind_span grains = {0, s->particles->owned};
        if (kinds_of(s->particles))
            grains = kinds_span(s->particles, &s->classes, KIND_GRAIN);
        integrator_stagger(s->particles, &shift, grains.first, grains.end);
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
    guards_step(s, text);
}
