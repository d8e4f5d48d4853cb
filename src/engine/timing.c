/* SPDX-License-Identifier: BSD-3-Clause */
/* The time step of a run: given, or a fraction of the stable step; a step above the stable step is refused.
 * The stable step depends on the speeds of the particles at the start, so a resume with the same rule keeps
 * the step of the checkpoint. */
#include "engine/timing.h"
#include "contact/material.h"
#include "engine/guards.h"
#include "particles/kinds.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Contacts are checked every so many steps; the time step may be at most this part of the stable step. */
enum { LOOK_EVERY = 500 };
#define LOOK_PART 0.9

/* The sorts of grains present: this rank's free particles, and the particles of insertions. Particles of
 * one material may differ in density, and are divided into sorts by powers of two of the density. At every
 * size a sort counts with its least density if that is the worst case, else with its largest density. */
enum { DENSITIES = 16, SORTS = LAW_MATERIALS_MAX * DENSITIES };
struct sorts {
    double radius_min[SORTS], radius_max[SORTS];
    double lightest[SORTS], heaviest[SORTS]; /* mass / radius^3 */
    double fixed[LAW_MATERIALS_MAX]; /* 1: particles with prescribed motion, or walls, of the material */
};

static double cube(double x) {
    return x * x * x;
}

/* The sort of a grain whose material has this density. */
static int kind_of(int material, double density, double radius, double mass) {
    double power = floor(log2(mass / particles_sphere_mass(radius, density))) + DENSITIES / 2;
    return material * DENSITIES + (int)fmin(fmax(power, 0), DENSITIES - 1);
}

static void sorts_put(struct sorts *sorts, int kind, double radius, double mass) {
    sorts->radius_min[kind] = fmin(sorts->radius_min[kind], radius);
    sorts->radius_max[kind] = fmax(sorts->radius_max[kind], radius);
    sorts->lightest[kind] = fmin(sorts->lightest[kind], mass / cube(radius));
    sorts->heaviest[kind] = fmax(sorts->heaviest[kind], mass / cube(radius));
}

/* Adds the sorts of an insertion. */
static void sorts_insert(const struct simulation *s, struct sorts *sorts,
                         const struct insertion_options *options) {
    double radius[2], usual = s->scene->material[options->material].density;
    double density = options->density > 0 ? options->density : usual;
    sizes_bounds(&options->sizes, &radius[0], &radius[1]);
    for (int k = 0; k < 2; k++) {
        double mass = particles_sphere_mass(radius[k], density);
        sorts_put(sorts, kind_of(options->material, usual, radius[k], mass), radius[k], mass);
    }
}

static void sorts_collect(const struct simulation *s, struct sorts *sorts) {
    *sorts = (struct sorts){0};
    if (s->scene->materials == 0) /* nothing touches */
        return;
    for (int k = 0; k < SORTS; k++)
        sorts->radius_min[k] = sorts->lightest[k] = INFINITY;
    const uint8_t *number = material_numbers(s->particles), *sort = kinds_of(s->particles);
    for (size_t k = 0; k < s->particles->owned; k++) {
        const struct particle_state *p = &s->particles->state[k];
        if (sort && sort[k] != KIND_GRAIN)
            continue;
        int material = material_of(number, k);
        double density = s->scene->material[material].density;
        if (p->inverse_mass > 0)
            sorts_put(sorts, kind_of(material, density, p->radius, 1 / p->inverse_mass), p->radius,
                      1 / p->inverse_mass);
        else
            sorts->fixed[material] = 1;
    }
    for (int k = 0; k < s->scene->insertions; k++)
        sorts_insert(s, sorts, &s->scene->insertion[k]);
    for (int w = 0; w < s->scene->walls; w++)
        sorts->fixed[s->scene->wall[w].material] = 1;
    comm_min(s->comm, sorts->radius_min, SORTS);
    comm_min(s->comm, sorts->lightest, SORTS);
    comm_max(s->comm, sorts->radius_max, SORTS);
    comm_max(s->comm, sorts->heaviest, SORTS);
    comm_max(s->comm, sorts->fixed, LAW_MATERIALS_MAX);
}

/* The largest speed expected: from the scene, else the speed of the fastest particle now, or of a fall
 * through the box. */
static double speed_expected(const struct simulation *s) {
    const struct scene *scene = s->scene;
    double fall = 0, fastest = 0;
    if (scene->step.speed_max > 0)
        return scene->step.speed_max;
    for (int d = 0; d < 3; d++)
        if (!scene->box.periodic[d])
            fall += 2 * fabs(scene->gravity[d]) * scene->box.edge[d];
    const uint8_t *kind = kinds_of(s->particles);
    for (size_t k = 0; k < s->particles->owned; k++) {
        const double *v = s->particles->state[k].v;
        if (kind && kind[k] != KIND_GRAIN)
            continue;
        double own = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        fastest = fmax(fastest, s->box.motion.moves ? skin_speed2(&s->box, &s->particles->state[k], 0) : own);
    }
    comm_max(s->comm, &fastest, 1);
    return sqrt(fmax(fall, fastest));
}

/* Overlap over the smaller radius, if the largest particles of two kinds meet at a speed, without damping. */
static double overlap_of(const struct law *law, const struct timestep_kind *a, const struct timestep_kind *b,
                         const double heaviest[2], double speed) {
    double mass[2] = {INFINITY, INFINITY}, radius[2] = {INFINITY, INFINITY};
    const struct timestep_kind *kind[2] = {a, b};
    for (int k = 0; k < 2; k++)
        if (!kind[k]->wall) {
            radius[k] = kind[k]->radius_max;
            mass[k] = heaviest[k] * cube(radius[k]);
        }
    double m = 1 / (1 / mass[0] + 1 / mass[1]), r = 1 / (1 / radius[0] + 1 / radius[1]);
    int p = a->material, q = b->material;
    double overlap = law_impact_of(&law->options, &law->pair[p][q], &law->extra[p][q], m, r, speed);
    return overlap / fmin(radius[0], radius[1]);
}

static double overlap_expected(const struct simulation *s, const double *heaviest,
                               const struct timestep_input *input) {
    double most = 0;
    for (int a = 0; a < input->kinds; a++)
        for (int b = a; b < input->kinds; b++)
            if (!input->kind[a].wall || !input->kind[b].wall)
                most = fmax(most, overlap_of(&s->grains.law, &input->kind[a], &input->kind[b],
                                             (double[2]){heaviest[a], heaviest[b]}, input->speed_max));
    return most;
}

static void limits_find(struct simulation *s) {
    struct sorts sorts;
    struct timestep_kind kind[SORTS + LAW_MATERIALS_MAX];
    double heaviest[SORTS + LAW_MATERIALS_MAX];
    int n = 0;
    s->timing.speed_expected = speed_expected(s);
    if (s->grains.law.options.solved) {
        s->timing.limits = (struct timestep_limits){.stable = INFINITY};
        return;
    }
    sorts_collect(s, &sorts);
    for (int k = 0; k < SORTS; k++)
        if (sorts.radius_max[k] > 0) {
            heaviest[n] = sorts.heaviest[k];
            kind[n++] = (struct timestep_kind){.material = k / DENSITIES,
                                               .radius_min = sorts.radius_min[k],
                                               .radius_max = sorts.radius_max[k],
                                               .mass_min = sorts.lightest[k] * cube(sorts.radius_min[k])};
        }
    for (int m = 0; m < s->scene->materials; m++)
        if (sorts.fixed[m] > 0) {
            heaviest[n] = 0;
            kind[n++] = (struct timestep_kind){.material = m, .wall = true};
        }
    struct timestep_input input = {.law = &s->grains.law,
                                   .kinds = n,
                                   .kind = kind,
                                   .material = s->scene->material,
                                   .speed_max = s->timing.speed_expected,
                                   .contacts = s->scene->step.contacts,
                                   .dimension = s->box.dimension};
    timestep_limits(&s->timing.limits, &input);
    s->timing.overlap_expected = overlap_expected(s, heaviest, &input);
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
    limits_find(s);
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
