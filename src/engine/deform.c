/* SPDX-License-Identifier: BSD-3-Clause */
/* Moves the box, and tells the other parts. Read deform.h first. */
#include "engine/deform.h"
#include "base/memory.h"
#include "kernel/particles/kinds.h"
#include <assert.h>
#include <math.h>
#include <string.h>

/* The servo of the shear: packings are far softer in shear than the modulus from which impedances come. */
enum { SHEAR_GAIN = 4, SHEAR_INERTIA = 4 };

static const char offset_name[] = "box: offset of the shear";

/* The stress that the shear follows; no number: none. */
static double shear_target(const struct scene *scene, const struct box *box) {
    const struct box_motion *motion = &box->motion;
    return motion->shears ? scene->stress.shear[motion->flow + motion->gradient - 1] : NAN;
}

void deform_prepare(struct box_servo *servo, const struct box *box, const struct scene *scene,
                    struct skin *skin, int threads) {
    servo->on = scene->stress_given;
    servo->threads = threads;
    servo->drift = box->motion.shear;
    servo->shears = servo->on && !isnan(shear_target(scene, box));
    if (box->motion.moves)
        skin_follow(skin, box);
    if (servo->on && scene->reproducible)
        servo->exact = memory_allocate_zero((size_t)threads, sizeof *servo->exact, "sums of the stress");
}

void deform_free(struct box_servo *servo) {
    memory_free(servo->exact);
}

void deform_start(const struct box *now, const struct scene *scene, struct particles *particles) {
    struct box box = *now;
    if (!box.motion.moves)
        return;
    if (!scene->shear.profile)
        box.motion.slide = 0;
    if (!scene->strain.profile)
        memset(box.motion.speed, 0, sizeof box.motion.speed);
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < particles->owned; k++) {
        double flow[3];
        box_flow(&box, particles->state[k].x, flow);
        for (int d = 0; d < 3; d++)
            particles->state[k].v[d] += flow[d];
    }
}

/* Sums of this rank's terms, as exact_add would do one by one, over all ranks: the same on any layout. */
static void sum_exactly(const struct comm *comm, struct exact *sum, int n, double value[]) {
    static_assert(sizeof *sum == EXACT_WORDS * sizeof(int64_t), "words alone are summed");
    comm_sum_int(comm, sum->word, n * EXACT_WORDS);
    for (int c = 0; c < n; c++)
        value[c] = exact_value(&sum[c]);
}

void deform_begin(struct box_servo *servo, const struct box *box, const struct scene *scene,
                  const struct particles *particles, const struct comm *comm) {
    struct exact exact[3] = {0};
    double sum[3];
    if (!servo->on || servo->mass > 0) /* of a checkpoint */
        return;
    const uint8_t *kind = kinds_of(particles);
    for (size_t k = 0; k < particles->owned; k++) {
        const struct particle_state *state = &particles->state[k];
        if (kind && kind[k] != KIND_GRAIN) /* a body is there by its members */
            continue;
        exact_add(&exact[0], state->inverse_mass > 0 ? 1 / state->inverse_mass : 0);
        exact_add(&exact[1], 4.0 / 3 * M_PI * state->radius * state->radius * state->radius);
        exact_add(&exact[2], 1);
    }
    sum_exactly(comm, exact, 3, sum);
    servo->mass = sum[0];
    double diameter = cbrt(6 / M_PI * sum[1] / fmax(sum[2], 1)), density = sum[0] / sum[1];
    if (box->dimension == 2) /* mass over area */
        density *= 2.0 / 3 * diameter;
    servo->bound = scene->stress.inertia / (diameter * sqrt(density));
}

static double volume_of(const struct box *box) {
    return box->edge[0] * box->edge[1] * (box->dimension == 2 ? 1 : box->edge[2]);
}

/* Mass times the squares and products of the velocity of a particle relative to the mean flow. */
static void flux_of(const struct box *box, const struct particle_state *state, double flux[6]) {
    static const int row[6] = {0, 1, 2, 0, 0, 1}, column[6] = {0, 1, 2, 1, 2, 2};
    double flow[3], v[3];
    box_flow(box, state->x, flow);
    for (int d = 0; d < 3; d++)
        v[d] = state->v[d] - flow[d];
    for (int c = 0; c < 6; c++)
        flux[c] = state->inverse_mass > 0 ? v[row[c]] * v[column[c]] / state->inverse_mass : 0;
}

/* The sums of stress_sum, the same on any layout. */
static void stress_exactly(const struct box_servo *servo, const struct box *box,
                           const struct particles *particles, const struct physics_active *mover,
                           const struct comm *comm, double sum[STRESS_SUMS]) {
    struct exact(*exact)[STRESS_SUMS] = servo->exact;
    const size_t threads = (size_t)servo->threads;
#pragma omp parallel for schedule(static, 1)
    for (size_t t = 0; t < threads; t++) {
        size_t first = particles->owned * t / threads;
        size_t last = particles->owned * (t + 1) / threads;
        for (size_t k = first; k < last; k++) {
            double flux[6];
            flux_of(box, &particles->state[k], flux);
            for (int c = 0; c < 6; c++)
                exact_add(&exact[t][c], flux[c]);
        }
    }
    for (size_t t = 1; t < threads; t++)
        for (int c = 0; c < STRESS_SUMS; c++)
            exact_join(&exact[0][c], &exact[t][c]);
    if (mover->row->mover->stress)
        mover->row->mover->stress(&mover->context, exact[0], sum);
    sum_exactly(comm, exact[0], STRESS_SUMS, sum);
    memset(exact, 0, threads * sizeof *exact);
}

/* Sums over all ranks: stress times volume (6), and the elastic energy. */
static void stress_sum(const struct box_servo *servo, const struct box *box,
                       const struct particles *particles, const struct physics_active *mover,
                       const struct comm *comm, double sum[STRESS_SUMS]) {
    if (servo->exact) {
        stress_exactly(servo, box, particles, mover, comm, sum);
        return;
    }
    memset(sum, 0, STRESS_SUMS * sizeof *sum);
    if (mover->row->mover->stress)
        mover->row->mover->stress(&mover->context, NULL, sum);
    for (size_t k = 0; k < particles->owned; k++) {
        double flux[6];
        flux_of(box, &particles->state[k], flux);
        for (int c = 0; c < 6; c++)
            sum[c] += flux[c];
    }
    comm_sum(comm, sum, STRESS_SUMS);
}

static double limited(double rate, double bound) {
    return fmin(fmax(rate, -bound), bound);
}

/* What the servo knows of the packing. */
struct packing {
    double density, modulus, pressure;
};

/* The rate of an edge at which the stress is `excess` above its target; `scale` is a stress of the size of the
 * target. */
static double rate_of(const struct box_servo *servo, const struct packing *packing, double excess,
                      double scale, double edge) {
    double impedance = sqrt(packing->density * fmax(packing->modulus, scale));
    return limited(impedance > 0 ? excess / impedance / edge : 0, servo->bound * sqrt(scale));
}

/* Sets the rate of the shear, by a shear stress and its target (no number: none) over a step. */
static void shear_control(struct box_servo *servo, struct box *box, const struct packing *packing,
                          double stress, double target, double dt) {
    struct box_motion *motion = &box->motion;
    if (isnan(target)) {
        servo->drift = motion->shear;
        return;
    }
    double scale = fmax(fabs(target), packing->pressure), bound = servo->bound * sqrt(fmax(scale, 0)),
           longest = 0;
    double excess = stress - target;
    for (int d = 0; d < box->dimension; d++)
        longest = fmax(longest, box->edge[d]);
    double more = dt * excess / (SHEAR_INERTIA * packing->density * longest * longest);
    servo->drift = limited(servo->drift + more, bound);
    motion->shear =
        limited(servo->drift + SHEAR_GAIN * rate_of(servo, packing, excess, fmax(scale, 0), longest), bound);
}

void deform_flow(struct box *box, struct particles *particles) {
    double change[4];
    struct fields_flow flow[FIELDS_MAX];
    const int flows = fields_flowing(particles, flow);
    const uint8_t *kind = kinds_of(particles);
    if (!box_follow(box, change))
        return;
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < particles->owned; k++) {
        double more[3];
        box_accelerate(box, change, particles->state[k].x, more);
        for (int d = 0; d < 3; d++)
            particles->state[k].v[d] += more[d];
        for (int f = 0; f < flows; f++)
            for (int d = 0; d < 3 && (!flow[f].kinds || (flow[f].kinds >> kind[k] & 1)); d++)
                flow[f].value[k][d] += more[d];
    }
}

void deform_control(struct simulation *s) {
    const struct scene_stress *wanted = &s->scene->stress;
    const struct box_motion *motion = &s->box.motion;
    int n = s->box.dimension;
    double sum[STRESS_SUMS], *stretch = s->box.motion.stretch, work = 0, longest = 0,
                             volume = volume_of(&s->box);
    stress_sum(&s->servo, &s->box, s->particles, s->physics.mover, s->comm, sum);
    for (int d = 0; d < n; d++) {
        work += sum[d];
        longest = fmax(longest, s->box.edge[d]);
    }
    double mean = work / volume / n;
    const struct packing packing = {.density = s->servo.mass / volume,
                                    .modulus = sum[6] > 0 ? 0.3 * work * work / (sum[6] * volume) : 0,
                                    .pressure = mean};
    for (int d = 0; d < n; d++) {
        double target = wanted->normal[d];
        if (!isnan(wanted->pressure))
            stretch[d] = rate_of(&s->servo, &packing, mean - wanted->pressure, wanted->pressure, longest);
        else if (!isnan(target))
            stretch[d] = rate_of(&s->servo, &packing, sum[d] / volume - target, target, s->box.edge[d]);
    }
    shear_control(&s->servo, &s->box, &packing,
                  motion->shears ? sum[2 + motion->flow + motion->gradient] / volume : 0,
                  shear_target(s->scene, &s->box), s->evaluation.dt);
}

/* Stops the run before an edge is too short for its particles. */
static void check_edges(const struct box *box, const struct size_classes *classes, const struct clock *clock,
                        struct error *error) {
    double reach = 0;
    for (int a = 0; a < classes->count; a++)
        for (int b = 0; b <= a; b++)
            if (classes_meet(classes, a, b))
                reach = fmax(reach, classes->radius_max[a] + classes->radius_max[b] + classes->margin[a][b]);
    for (int d = 0; d < box->dimension; d++) {
        double least = 1.01 * reach * (box->motion.shears && d == box->motion.flow ? 2 : 1);
        if (box->periodic[d] && box->motion.stretch[d] < 0 && box->edge[d] <= least)
            error_set(
                error, ERROR_PHYSICS,
                "box: the %c edge has shrunk to %.6g, too short for the particles, which need more than "
                "%.6g, at step %llu, t = %.9g",
                'x' + d, box->edge[d], least, (unsigned long long)clock->step, clock->time);
    }
}

void deform_advance(struct box *box, struct interactions *interactions, const struct size_classes *classes,
                    const struct clock *clock, struct error *error) {
    box_advance(box, clock->dt);
    check_edges(box, classes, clock, error);
    interactions_follow(interactions, box);
}

void deform_settle(struct box *box, struct domain *domain) {
    box_settle(box);
    domain_follow(domain, box);
}

void deform_restart(struct box *box, struct box_servo *servo, struct restart *restart) {
    restart_add(restart, RESTART_REAL, true, &box->motion.offset, "%s", offset_name);
    restart_add(restart, RESTART_REAL, true, &box->motion.turns, "box: turns of the shear");
    for (int d = 0; d < 3; d++)
        restart_add(restart, RESTART_REAL, true, &box->edge[d], "box: edge %c", 'x' + d);
    restart_add(restart, RESTART_REAL, true, &box->motion.slide, "box: speed of the shear");
    for (int d = 0; d < 3; d++)
        restart_add(restart, RESTART_REAL, true, &box->motion.speed[d], "box: speed of edge %c", 'x' + d);
    if (!servo->on)
        return;
    for (int d = 0; d < 3; d++)
        restart_add(restart, RESTART_REAL, true, &box->motion.stretch[d], "box: rate of edge %c", 'x' + d);
    restart_add(restart, RESTART_REAL, true, &servo->mass, "box: mass of the particles");
    restart_add(restart, RESTART_REAL, true, &servo->bound, "box: bound of the rates");
    restart_add(restart, RESTART_REAL, true, &servo->drift, "box: drift of the shear");
    if (servo->shears)
        restart_add(restart, RESTART_REAL, true, &box->motion.shear, "box: rate of the shear");
}

bool deform_moved(const struct restart_values *values) {
    for (size_t k = 0; k < values->count[RESTART_REAL]; k++)
        if (strcmp(values->name[RESTART_REAL][k], offset_name) == 0)
            return true;
    return false;
}

bool deform_check(const struct box *box, const struct restart_values *values, const char *path,
                  struct error *error) {
    for (size_t k = 0; k < values->count[RESTART_REAL]; k++) {
        double offset;
        if (strcmp(values->name[RESTART_REAL][k], offset_name) != 0)
            continue;
        memcpy(&offset, &values->value[RESTART_REAL][k], sizeof offset);
        if (!box->motion.moves || (!box->motion.shears && offset != 0))
            return error_set(error, ERROR_USER,
                             "%s: it was written for a box that moves: box.shear, box.strain or box.stress "
                             "must stay; a rate of 0 holds the box",
                             path);
    }
    return true;
}
