/* SPDX-License-Identifier: BSD-3-Clause */
/* Guards: physical nonsense stops the run (or warns, once), naming particles, place and time. */
#include "engine/guards.h"
#include "engine/trip.h"
#include "kernel/particles/spin.h"
#include "kernel/particles/kinds.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Steps between two checks of the balance of energies. */
enum { ENERGY_EVERY = 20, ENERGY_EVERY_AUTO = 100 };

/* By default a run stops if the energy gained without cause exceeds this factor times guards.energy_bound:
 * such a gain is no drift, but energy that grows without bound. */
#define ENERGY_AUTO 10

/* The fastest of the free and moved particles of this rank. */
static size_t fastest_find(const struct particles *particles, double *speed) {
    size_t worst = 0;
    double most = -1;
    const uint8_t *kind = kinds_of(particles);
    for (size_t k = 0; k < particles->owned; k++) {
        if (kind && kind[k] != KIND_GRAIN)
            continue;
        const double *v = particles->state[k].v;
        double v2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        if (v2 > most) {
            most = v2;
            worst = k;
        }
    }
    *speed = sqrt(fmax(most, 0));
    return worst;
}

/* The largest squared speed of the last drift; tells whether all are numbers. */
static double fastest_drift(const struct search *search, int threads, int classes, bool *finite) {
    double fastest = 0;
    *finite = true;
    for (int t = 0; t < threads; t++)
        for (int c = 0; c < classes; c++) {
            *finite = *finite && isfinite(search->speed[t][c]);
            fastest = fmax(fastest, search->speed[t][c]);
        }
    return fastest;
}

/* The smallest radius of grains. */
static double least_radius(const struct size_classes *classes) {
    int first = 0; /* class of grains */
    while (first < classes->count - 1 && classes->kind[first] != KIND_GRAIN)
        first++;
    return classes->radius_min[first];
}

/* A particle that moves by more than the smallest radius in a step may pass through another particle without
 * contact. This check also finds a speed that is not a number. */
static void guard_speed(struct simulation *s) {
    bool finite;
    double fastest = fastest_drift(&s->search, s->threads, s->classes.count, &finite),
           bound = least_radius(&s->classes), speed;
    if (!finite) {
        guards_check_finite(s->particles, &s->box, &s->physics, &s->clock, &s->error);
        return;
    }
    if (s->scene->guards.speed == SCENE_GUARD_OFF || s->classes.count == 0 ||
        !(sqrt(fastest) * s->clock.dt > bound) || s->particles->owned == 0)
        return;
    char text[512], one[TRIP_NAME_MAX];
    size_t worst = fastest_find(s->particles, &speed);
    if (!(speed * s->clock.dt > bound))
        return;
    trip_name(s->particles, &s->box, worst, one);
    snprintf(text, sizeof text,
             "guards.speed: %s moves %.3g in a step, more than the smallest radius %.3g: it may pass through "
             "others unseen (step %llu, t = %.9g)",
             one, speed * s->clock.dt, bound, (unsigned long long)s->clock.step, s->clock.time);
    trip(s->scene->guards.speed, text, &s->error, &s->caller.log, &s->guards.warned[GUARD_SPEED]);
}

void guards_check(struct simulation *s) {
    PHYSICS_EACH (active, &s->physics, guard)
        active->row->guard(&active->context, &s->error);
    guard_speed(s);
}

/* True if position and speed of a particle are finite; the square of the speed is, too, as in integrator_advance. */
static bool state_finite(const struct particle_state *p) {
    const double square[3] = {p->v[0] * p->v[0], p->v[1] * p->v[1], p->v[2] * p->v[2]};
    return trip_finite(p->x, 3) && trip_finite(square, 3);
}

/* What of an owned particle is not finite; NULL: all is. */
static const char *strange_of(const struct particles *p, const double (*omega)[4], size_t k) {
    if (!state_finite(&p->state[k]))
        return "position or velocity";
    if (omega && !trip_finite(omega[k], 3))
        return "angular velocity";
    return trip_finite(p->force + k * (size_t)p->force_stride, p->force_stride) ? NULL : "force or torque";
}

/* Places that are not numbers would break the search, and other numbers spoil one another, so they always stop the run. */
void guards_check_finite(struct particles *p, const struct box *box, const struct physics_set *set,
                         const struct clock *clock, struct error *error) {
    const struct physics_active *obstacles = set->obstacles;
    const double(*omega)[4] = spin_values(p);
    size_t bad = p->owned, count = 0;
#pragma omp parallel for schedule(static) reduction(min : bad) reduction(+ : count)
    for (size_t k = 0; k < p->owned; k++)
        if (strange_of(p, omega, k)) {
            bad = k < bad ? k : bad;
            count++;
        }
    if (obstacles)
        obstacles->row->obstacles->finite(&obstacles->context, error);
    if (count == 0)
        return;
    char one[TRIP_NAME_MAX], others[64] = "";
    trip_name(p, box, bad, one);
    if (count > 1)
        snprintf(others, sizeof others, " (and of %zu more)", count - 1);
    error_set(error, ERROR_PHYSICS,
              "guards.nan: %s of %s%s is not finite at step %llu, t = %.9g: the time step is too large, "
              "particles coincide, or a law or a force of the user's gives no number",
              strange_of(p, omega, bad), one, others, (unsigned long long)clock->step, clock->time);
    for (size_t k = bad; k < p->owned; k++) {
        struct particle_state *state = &p->state[k];
        bool lost = !state_finite(state);
        for (int d = 0; lost && d < 3; d++)
            state->x[d] = state->v[d] = 0;
    }
}

/* Always stops the run, as the unwrapped position of such a particle is lost. */
void guards_check_images(struct particles *particles, const struct box *box, const struct clock *clock,
                         struct error *error) {
    for (size_t k = 0; k < particles->owned; k++) {
        double *x = particles->state[k].x;
        for (int d = 0; d < 3; d++) {
            if (!box->periodic[d] || (x[d] >= 0 && x[d] < box->edge[d]))
                continue;
            error_set(error, ERROR_PHYSICS,
                      "particle %lld has crossed the periodic box in %c more often than 32 bits count, at "
                      "step %llu, "
                      "t = %.9g",
                      (long long)particles->id[k], "xyz"[d], (unsigned long long)clock -> step,
                      clock -> time);
            x[d] = 0;
        }
    }
}

bool guards_prepare(struct simulation *s, struct error *error) {
    const struct scene *scene = s->scene;
    char place[SCENE_PATH_MAX];
    bool mechanical = scene->guards.energy == SCENE_GUARD_AUTO;
    if (scene->guards.energy == SCENE_GUARD_OFF || (mechanical && (s->box.motion.moves || s->caller.force)))
        return true;
    if (s->caller.force)
        return error_set(
            error, ERROR_USER,
            "%s: guards.energy: a force of the calling program does work on the particles, which "
            "is in no balance; allowed here: auto, off",
            scene_place(scene, "guards.energy", place, sizeof place));
    if (s->box.motion.moves)
        return error_set(
            error, ERROR_USER,
            "%s: guards.energy: a box that moves does work on its particles, which is in no balance; "
            "allowed here: auto, off",
            scene_place(scene, "guards.energy", place, sizeof place));
    s->guards.energy.mechanical = mechanical;
    for (int g = 0; g < scene->groups; g++)
        if (scene->group[g].motion == SCENE_MOVING)
            return s->guards.energy.mechanical ||
                   error_set(
                       error, ERROR_USER,
                       "%s: guards.energy: group '%s' moves by order, and what it gives to others is in no "
                       "balance; allowed here: auto, off",
                       scene_place(scene, "guards.energy", place, sizeof place), scene->group[g].name);
    s->sums_each_step = s->sums_each_step || !s->guards.energy.mechanical;
    s->guards.energy.wanted = true;
    if (s->clock.step == 0) /* a resumed run has no sums before its first step */
        guards_check_energy(s);
    return true;
}

bool guards_energy_due(const struct guard_energy *energy, uint64_t step) {
    return energy->wanted && step % (energy->mechanical ? ENERGY_EVERY_AUTO : ENERGY_EVERY) == 0;
}

/* Sums over all ranks of the energies: of grains, then of others. */
enum { WORK = GRAINS_ENERGIES, HELD, GONE, PLAY, ENERGIES };
static void energies_find(const struct physics_set *set, const struct comm *comm, bool mechanical,
                          double energy[ENERGIES]) {
    const struct physics_active *mover = set->mover, *obstacles = set->obstacles;
    struct physics_energy others;
    memset(energy, 0, ENERGIES * sizeof *energy);
    if (mover->row->mover->energies)
        mover->row->mover->energies(&mover->context, mechanical, energy);
    physics_energies(set, &others);
    energy[WORK] = (obstacles ? obstacles->row->obstacles->work(&obstacles->context) : 0) + others.work;
    energy[HELD] = others.held;
    energy[GONE] = others.taken;
    energy[PLAY] = others.play;
    comm_sum(comm, energy, ENERGIES);
}

/* Measures the balance, and the energy in play: the largest value that any form of energy has reached.
 * Potential energy is left out, as its zero is arbitrary. */
static void energy_measure(const struct physics_set *set, const struct comm *comm, bool summed,
                           double *balance, double *in_play) {
    double energy[ENERGIES];
    energies_find(set, comm, !summed, energy);
    double dissipated = energy[GRAINS_TAKEN] - energy[GRAINS_TANGENTIAL] + energy[GONE];
    if (!summed)
        dissipated = 0; /* not summed at each step */
    double mechanical = energy[GRAINS_KINETIC] + energy[GRAINS_ROTATIONAL] + energy[GRAINS_NORMAL] +
                        energy[GRAINS_TANGENTIAL] + energy[HELD];
    *balance = mechanical + energy[GRAINS_GRAVITY] + dissipated - energy[WORK];
    *in_play = fmax(fmax(fabs(dissipated), fabs(energy[WORK])), fmax(energy[HELD], energy[PLAY]));
    for (int k = GRAINS_KINETIC; k <= GRAINS_TANGENTIAL; k++)
        *in_play = k == GRAINS_GRAVITY ? *in_play : fmax(*in_play, fabs(energy[k]));
}

void guards_check_energy(struct simulation *s) {
    struct guard_energy *energy = &s->guards.energy;
    double balance, in_play, speed;
    uint64_t changes = s->sources.inserted + s->sources.deleted;
    physics_full_step(&s->physics);
    energy_measure(&s->physics, s->comm, !energy->mechanical, &balance, &in_play);
    energy->in_play = fmax(energy->in_play, in_play);
    if (!energy->begun || changes != energy->changes || s->sources.last_step > energy->step) {
        energy->gained += energy->begun ? balance - energy->last : 0; /* energy of particles that came */
        energy->start = energy->begun ? energy->start : balance;
        energy->begun = true;
    }
    energy->changes = changes;
    energy->last = balance;
    energy->step = s->clock.step;
    double growth = balance - energy->start - energy->gained;
    if (!isfinite(balance))
        error_set(&s->error, ERROR_PHYSICS,
                  "guards.nan: the energy of contacts or particles is not finite at step %llu, t = %.9g",
                  (unsigned long long)s->clock.step, s->clock.time);
    double bound = s->scene->guards.energy_bound * (energy->mechanical ? ENERGY_AUTO : 1);
    if (energy->mechanical) /* losses of energy are no fault: the lowest balance counts */
        energy->start = fmin(energy->start, balance - energy->gained);
    if (!(growth > bound * energy->in_play) || s->particles->owned == 0)
        return;
    char text[512], one[TRIP_NAME_MAX];
    trip_name(s->particles, &s->box, fastest_find(s->particles, &speed), one);
    snprintf(
        text, sizeof text,
        "guards.energy: energy has grown by %.3g without cause, %.3g of the %.3g in play (bound %g), at step "
        "%llu, t = %.9g; fastest is %s with %.3g: the time step is too large, or a law is given wrongly",
        growth, growth / energy->in_play, energy->in_play, bound, (unsigned long long)s->clock.step,
        s->clock.time, one, speed);
    trip(energy->mechanical ? SCENE_GUARD_STOP : s->scene->guards.energy, text, &s->error, &s->caller.log,
         &s->guards.warned[GUARD_ENERGY]);
}
