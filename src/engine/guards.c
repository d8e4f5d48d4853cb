/* SPDX-License-Identifier: BSD-3-Clause */
/* Guards: physical nonsense stops the run (or warns, once), naming particles, place and time. */
#include "engine/guards.h"
#include "particles/spin.h"
#include "core/memory.h"
#include "particles/kinds.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Steps between two checks of the balance of energies. */
enum { ENERGY_EVERY = 20, ENERGY_EVERY_AUTO = 100 };

/* Particles whose energies one thread adds up at a time. */
enum { ENERGY_CHUNK = 4096 };

/* By default a run stops if the energy gained without cause exceeds this factor times guards.energy_bound:
 * such a gain is no drift, but energy that grows without bound. */
#define ENERGY_AUTO 10

/* Stops or warns. */
static void guard_trip(struct simulation *s, enum scene_guard guard, int which, const char *text) {
    if (guard == SCENE_GUARD_STOP) {
        error_set(&s->error, ERROR_PHYSICS, "%s", text);
    } else if (guard == SCENE_GUARD_WARN && !(s->guards.warned & 1u << which)) {
        s->guards.warned |= 1u << which;
        log_tell(&s->caller.log, "warning: %s (said once)", text);
    }
}

/* "particle 5 at (1, 2, 3)" in the user's coordinates. */
static void name_at(const struct simulation *s, size_t k, char *text, size_t room) {
    const double *x = s->particles->state[k].x, *origin = s->box.origin;
    snprintf(text, room, "particle %lld at (%.6g, %.6g, %.6g)", (long long)s->particles->id[k],
             x[0] + origin[0], x[1] + origin[1], x[2] + origin[2]);
}

/* As name_at, for a partner by id: a wall (negative id) by its name. */
static void name_partner(const struct simulation *s, int64_t id, char *text, size_t room) {
    if (id < 0 && -id <= s->scene->walls) {
        snprintf(text, room, "wall '%s'", s->scene->wall[-id - 1].name);
        return;
    }
    for (size_t k = 0; k < s->particles->owned + s->particles->ghosts; k++)
        if (s->particles->id[k] == id) {
            name_at(s, k, text, room);
            return;
        }
    snprintf(text, room, "particle %lld", (long long)id);
}

static void guard_overlap(struct simulation *s) {
    if (s->scene->guards.overlap == SCENE_GUARD_OFF ||
        !(s->grains.sums.overlap_max > s->scene->guards.overlap_bound))
        return;
    char text[640], one[160], other[160];
    name_partner(s, s->grains.sums.overlap_id[0], one, sizeof one);
    name_partner(s, s->grains.sums.overlap_id[1], other, sizeof other);
    snprintf(text, sizeof text,
             "guards.overlap: %s and %s overlap by %.3g of the smaller radius (bound %g) at step %llu, "
             "t = %.9g",
             one, other, s->grains.sums.overlap_max, s->scene->guards.overlap_bound,
             (unsigned long long)s->clock.step, s->clock.time);
    guard_trip(s, s->scene->guards.overlap, 0, text);
}

/* The fastest of the free and moved particles of this rank. */
static size_t fastest_find(const struct simulation *s, double *speed) {
    size_t worst = 0;
    double most = -1;
    const uint8_t *kind = kinds_of(s->particles);
    for (size_t k = 0; k < s->particles->owned; k++) {
        if (kind && kind[k] != KIND_GRAIN)
            continue;
        const double *v = s->particles->state[k].v;
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
static double fastest_drift(const struct simulation *s, bool *finite) {
    double fastest = 0;
    *finite = true;
    for (int t = 0; t < s->threads; t++)
        for (int c = 0; c < s->classes.count; c++) {
            *finite = *finite && isfinite(s->grains.speed[t][c]);
            fastest = fmax(fastest, s->grains.speed[t][c]);
        }
    return fastest;
}

/* The smallest radius of grains. */
static double least_radius(const struct simulation *s) {
    int first = 0; /* class of grains */
    while (first < s->classes.count - 1 && s->classes.kind[first] != KIND_GRAIN)
        first++;
    return s->classes.radius_min[first];
}

/* A particle that moves by more than the smallest radius in a step may pass through another particle without
 * contact. This check also finds a speed that is not a number. */
static void guard_speed(struct simulation *s) {
    bool finite;
    double fastest = fastest_drift(s, &finite), bound = least_radius(s), speed;
    if (!finite) {
        guards_check_finite(s);
        return;
    }
    if (s->scene->guards.speed == SCENE_GUARD_OFF || s->classes.count == 0 ||
        !(sqrt(fastest) * s->clock.dt > bound) || s->particles->owned == 0)
        return;
    char text[512], one[160];
    size_t worst = fastest_find(s, &speed);
    if (!(speed * s->clock.dt > bound))
        return;
    name_at(s, worst, one, sizeof one);
    snprintf(text, sizeof text,
             "guards.speed: %s moves %.3g in a step, more than the smallest radius %.3g: it may pass through "
             "others unseen (step %llu, t = %.9g)",
             one, speed * s->clock.dt, bound, (unsigned long long)s->clock.step, s->clock.time);
    guard_trip(s, s->scene->guards.speed, 1, text);
}

void guards_step(struct simulation *s, const char *text) {
    if (s->comm->rank > 0 && s->scene->guards.step == SCENE_GUARD_WARN)
        return;
    guard_trip(s, s->scene->guards.step, 3, text);
}

void guards_check(struct simulation *s) {
    if (!s->ahead) { /* the next step then ends complete, as guards_calm finds the overlap, too */
        guard_overlap(s);
        guard_speed(s);
    }
    s->guards.overlap_known = true;
}

bool guards_calm(const struct simulation *s) {
    bool finite;
    double move = sqrt(fastest_drift(s, &finite)) * s->clock.dt, least = least_radius(s);
    double walls = fmax(s->search.skin->growth[s->classes.count], 0);
    double overlap = s->grains.sums.overlap_max + (move + fmax(move, walls)) / least;
    return finite && !(move > least) && s->guards.overlap_known &&
           (s->scene->guards.overlap == SCENE_GUARD_OFF || overlap < s->scene->guards.overlap_bound);
}

/* True if the sum of these numbers is finite. */
static bool all_finite(const double *value, int count) {
    double sum = 0;
    for (int k = 0; k < count; k++)
        sum += value[k];
    return isfinite(sum);
}

/* True if position and speed of a particle are finite; the square of the speed is, too, as in integrator_advance. */
static bool state_finite(const struct particle_state *p) {
    const double square[3] = {p->v[0] * p->v[0], p->v[1] * p->v[1], p->v[2] * p->v[2]};
    return all_finite(p->x, 3) && all_finite(square, 3);
}

/* What of an owned particle is not finite; NULL: all is. */
static const char *strange_of(const struct particles *p, const double (*omega)[4], size_t k) {
    if (!state_finite(&p->state[k]))
        return "position or velocity";
    if (omega && !all_finite(omega[k], 3))
        return "angular velocity";
    return all_finite(p->force + k * (size_t)p->force_stride, p->force_stride) ? NULL : "force or torque";
}

/* The pose of a wall, and the force on it. */
static void guard_walls(struct simulation *s) {
    double force[WALLS_MAX][6];
    if (s->grains.walls == NULL)
        return;
    walls_forces(s->grains.walls, force);
    for (int w = 0; w < walls_count(s->grains.walls); w++) {
        struct wall_pose pose;
        walls_pose(s->grains.walls, w, &pose);
        bool place = all_finite(pose.rotation, 9) && all_finite(pose.translation, 3) &&
                     all_finite(pose.velocity, 3) && all_finite(pose.omega, 3);
        if (!place || !all_finite(force[w], 6))
            error_set(&s->error, ERROR_PHYSICS,
                      "guards.nan: %s wall '%s' is not finite at step %llu, t = %.9g",
                      place ? "the force on" : "the motion of", s->scene->wall[w].name,
                      (unsigned long long)s->clock.step, s->clock.time);
    }
}

/* Places that are not numbers would break the search, and other numbers spoil one another, so they always stop the run. */
void guards_check_finite(struct simulation *s) {
    const struct particles *p = s->particles;
    const double(*omega)[4] = spin_values(p);
    size_t bad = p->owned, count = 0;
#pragma omp parallel for schedule(static) reduction(min : bad) reduction(+ : count)
    for (size_t k = 0; k < p->owned; k++)
        if (strange_of(p, omega, k)) {
            bad = k < bad ? k : bad;
            count++;
        }
    guard_walls(s);
    if (count == 0)
        return;
    char one[160], others[64] = "";
    name_at(s, bad, one, sizeof one);
    if (count > 1)
        snprintf(others, sizeof others, " (and of %zu more)", count - 1);
    error_set(&s->error, ERROR_PHYSICS,
              "guards.nan: %s of %s%s is not finite at step %llu, t = %.9g: the time step is too large, "
              "particles coincide, or a law or a force of the user's gives no number",
              strange_of(p, omega, bad), one, others, (unsigned long long)s->clock.step, s->clock.time);
    for (size_t k = bad; k < p->owned; k++) {
        struct particle_state *state = &p->state[k];
        bool lost = !state_finite(state);
        for (int d = 0; lost && d < 3; d++)
            state->x[d] = state->v[d] = 0;
    }
}

/* Always stops the run, as the unwrapped position of such a particle is lost. */
void guards_check_images(struct simulation *s) {
    const struct box *box = &s->box;
    for (size_t k = 0; k < s->particles->owned; k++) {
        double *x = s->particles->state[k].x;
        for (int d = 0; d < 3; d++) {
            if (!box->periodic[d] || (x[d] >= 0 && x[d] < box->edge[d]))
                continue;
            error_set(&s->error, ERROR_PHYSICS,
                      "particle %lld has crossed the periodic box in %c more often than 32 bits count, at "
                      "step %llu, "
                      "t = %.9g",
                      (long long)s->particles->id[k], "xyz"[d], (unsigned long long)s -> clock.step,
                      s->clock.time);
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
    s->grains.sums_each_step = s->grains.sums_each_step || !s->guards.energy.mechanical;
    s->guards.energy.wanted = true;
    if (s->clock.step == 0) /* a resumed run has no sums before its first step */
        guards_check_energy(s);
    return true;
}

bool guards_energy_due(const struct simulation *s, uint64_t step) {
    const struct guard_energy *energy = &s->guards.energy;
    return energy->wanted && step % (energy->mechanical ? ENERGY_EVERY_AUTO : ENERGY_EVERY) == 0;
}

/* Energies of all grains, in this order. */
enum { KINETIC, ROTATIONAL, GRAVITY, ELASTIC_NORMAL, ELASTIC_TANGENTIAL, TAKEN, WORK, HELD, GONE, ENERGIES };

/* Energy of the free grains among the owned particles [first, last) in gravity; across periodic sides particles
 * go on. */
static double gravity_of(const struct simulation *s, size_t first, size_t last) {
    int32_t(*const image)[3] = particles_images(s->particles);
    const uint8_t *kind = kinds_of(s->particles);
    const double *g = s->grains.motion.gravity;
    double sum = 0, shift[3] = {0, 0, 0};
    if (g[0] == 0 && g[1] == 0 && g[2] == 0)
        return 0;
    for (size_t k = first; k < last; k++) {
        const struct particle_state *p = &s->particles->state[k];
        bool counts = p->inverse_mass > 0 && (kind == NULL || kind[k] == KIND_GRAIN);
        if (image)
            box_unwrap(&s->box, image[k], shift);
        for (int d = 0; counts && d < 3; d++)
            sum -= g[d] / p->inverse_mass * (p->x[d] + s->box.origin[d] + shift[d]);
    }
    return sum;
}

/* Sums over all ranks. Particles go chunk by chunk, the chunks in order, whatever the number of threads. */
static void energies_find(const struct simulation *s, double energy[ENERGIES]) {
    size_t owned = s->particles->owned, chunks = owned / ENERGY_CHUNK + 1;
    double(*part)[3] = memory_allocate_zero(chunks, sizeof *part, "energies");
#pragma omp parallel for schedule(static)
    for (size_t c = 0; c < chunks; c++) {
        size_t first = c * ENERGY_CHUNK, last = first + ENERGY_CHUNK < owned ? first + ENERGY_CHUNK : owned;
        integrator_energies(s->particles, &s->grains.motion, first, last, part[c]);
        part[c][GRAVITY] = gravity_of(s, first, last);
    }
    memset(energy, 0, ENERGIES * sizeof *energy);
    for (size_t c = 0; c < chunks; c++)
        for (int k = KINETIC; k <= GRAVITY; k++)
            energy[k] += part[c][k];
    memory_free(part);
    energy[ELASTIC_NORMAL] = s->grains.sums.elastic_normal;
    energy[ELASTIC_TANGENTIAL] = s->grains.sums.elastic_tangential;
    energy[TAKEN] = s->grains.taken;
    energy[WORK] = (s->grains.walls ? walls_work(s->grains.walls) : 0) + physics_work(&s->physics);
    physics_energy(&s->physics, &energy[HELD], &energy[GONE]);
    comm_sum(s->comm, energy, ENERGIES);
}

/* Measures the balance, and the energy in play: the largest value that any form of energy has reached.
 * Potential energy is left out, as its zero is arbitrary. */
static void energy_measure(const struct simulation *s, double *balance, double *in_play) {
    const struct law_options *law = &s->grains.law.options;
    double energy[ENERGIES];
    energies_find(s, energy);
    double dissipated = energy[TAKEN] - energy[ELASTIC_TANGENTIAL] + energy[GONE];
    if (s->guards.energy.mechanical) {
        dissipated = 0; /* not summed at each step */
        if (law->sliding == LAW_SLIDING_TOTAL || law->lammps_history || law->lammps_granular)
            energy[ELASTIC_TANGENTIAL] =
                0; /* springs that take all of the slip are longer than friction loads
                                               them */
    }
    double mechanical = energy[KINETIC] + energy[ROTATIONAL] + energy[ELASTIC_NORMAL] +
                        energy[ELASTIC_TANGENTIAL] + energy[HELD];
    *balance = mechanical + energy[GRAVITY] + dissipated - energy[WORK];
    *in_play = fmax(fmax(fabs(dissipated), fabs(energy[WORK])), energy[HELD]);
    for (int k = KINETIC; k <= ELASTIC_TANGENTIAL; k++)
        *in_play = k == GRAVITY ? *in_play : fmax(*in_play, fabs(energy[k]));
}

void guards_check_energy(struct simulation *s) {
    struct guard_energy *energy = &s->guards.energy;
    double balance, in_play, speed;
    uint64_t changes = s->sources.inserted + s->sources.deleted;
    physics_full_step(&s->physics);
    energy_measure(s, &balance, &in_play);
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
    char text[512], one[160];
    name_at(s, fastest_find(s, &speed), one, sizeof one);
    snprintf(
        text, sizeof text,
        "guards.energy: energy has grown by %.3g without cause, %.3g of the %.3g in play (bound %g), at step "
        "%llu, t = %.9g; fastest is %s with %.3g: the time step is too large, or a law is given wrongly",
        growth, growth / energy->in_play, energy->in_play, bound, (unsigned long long)s->clock.step,
        s->clock.time, one, speed);
    guard_trip(s, energy->mechanical ? SCENE_GUARD_STOP : s->scene->guards.energy, 2, text);
}
