/* SPDX-License-Identifier: BSD-3-Clause */
/* Sums over the nodes of grains. Read rigid_sums.h first. */
#include "physics/fluid/coupling/rigid_sums.h"
#include "kernel/particles/spin.h"
#include "physics/fluid/coupling/grain_coupling.h"
#include "physics/fluid/coupling/rigid_fields.h"
#include "physics/fluid/fluid_fields.h"
#include "physics/fluid/fluid_state.h"
#include <math.h>
#include <string.h>

/* Sets the sums of grains, owned ones and copies, to 0. */
static void sums_clear(const struct rigid_work *work) {
    struct particles *p = work->context->particles;
    double(*load)[6] = fluid_load(p);
    memset(load + work->grains.first, 0, (work->grains.end - work->grains.first) * sizeof *load);
    memset(load + p->owned, 0, p->ghosts * sizeof *load);
}

/* Adds the sums of copies to those of the originals. Collective. */
static void sums_bring(const struct rigid_work *work) {
    struct field_list list = fields_one(fluid_load_handle(work->context->particles));
    if (work->context->ghosts != NULL)
        ghosts_sum(work->context->ghosts, work->context->particles, &list);
}

static double mass_of(const struct rigid_work *work, const struct solid_part *part) {
    return work->fluid->options->density * work->fluid->weights.volume[part->row] * part->share;
}

void rigid_sums_moments(const struct rigid_work *work) {
    struct rigid *rigid = work->rigid;
    double(*load)[6] = fluid_load(work->context->particles);
    for (int round = 0; round < 2; round++) {
        sums_clear(work);
        for (size_t k = 0; k < rigid->solid.parts; k++) {
            const struct solid_part *part = &rigid->solid.part[k];
            struct rigid_grains_sums one = {0};
            rigid_grains_add(&one, mass_of(work, part), part->arm);
            double *to = load[part->grain];
            for (int d = 0; d < 6; d++)
                to[d] += round == 1 ? one.second[d] : d == 0 ? one.mass : d < 4 ? one.first[d - 1] : 0;
        }
        sums_bring(work);
        for (size_t i = work->grains.first; i < work->grains.end; i++) {
            struct rigid_grains_sums *sums = &rigid->sums[i - work->grains.first];
            if (round == 1) {
                memcpy(sums->second, load[i], sizeof sums->second);
                continue;
            }
            sums->mass = load[i][0];
            memcpy(sums->first, load[i] + 1, sizeof sums->first);
        }
    }
}

void rigid_sums_momenta(const struct rigid_work *work, const double (*v)[3]) {
    const struct solid_field *solid = &work->rigid->solid;
    double(*load)[6] = fluid_load(work->context->particles);
    sums_clear(work);
    for (size_t node = 0; node < solid->nodes; node++)
        for (size_t k = solid->start[node]; k < solid->start[node + 1]; k++) {
            const struct solid_part *part = &solid->part[k];
            double mass = mass_of(work, part), *to = load[part->grain];
            for (int d = 0; d < 3; d++) {
                int next = (d + 1) % 3, last = (d + 2) % 3;
                to[d] += mass * v[node][d];
                to[3 + d] += mass * (part->arm[next] * v[node][last] - part->arm[last] * v[node][next]);
            }
        }
    sums_bring(work);
}

/* What a grain has that the fluid in it has not; `held`: its motion is given. */
static struct rigid_grains_own own_of(const struct rigid_work *work, size_t i, double *displaced,
                                      double *moment) {
    const struct physics_context *context = work->context;
    const struct fluid_options *options = work->fluid->options;
    const struct particle_state *state = &context->particles->state[i];
    int dimension = context->box->dimension;
    double r = state->radius, mass = state->inverse_mass > 0 ? 1 / state->inverse_mass : 0,
           inertia = 0.4 * mass * r * r, volume, second;
    *displaced = options->density * grain_displaced(context, r);
    *moment = (dimension == 2 ? 0.5 : 0.4) * *displaced * r * r;
    struct rigid_grains_own own = {.dimension = dimension, .turns = spin_of(context->particles) != NULL};
    solid_mean(r, options->spacing, work->kappa, dimension, &volume, &second);
    own.mass = mass - (mass >= *displaced ? *displaced : options->density * volume);
    own.inertia = inertia - (inertia >= *moment ? *moment : options->density * second);
    own.late_mass = fmin(0.5 * own.mass, 0);
    own.late_inertia = fmin(0.5 * own.inertia, 0);
    own.mass -= own.late_mass;
    own.inertia -= own.late_inertia;
    return own;
}

/* The right-hand side of the equations of a grain that the fluid moves: `load` are the momenta of v. */
static void momentum_of(const struct rigid_work *work, size_t i, const struct rigid_grains_own *own,
                        double displaced, double momentum[6]) {
    const struct physics_context *context = work->context;
    const double *load = fluid_load(context->particles)[i],
                 *before = rigid_fields_motion(context->particles)[i],
                 *impulse = rigid_fields_impulse(context->particles)[i];
    double weight = 1 / context->particles->state[i].inverse_mass - displaced;
    for (int d = 0; d < 3; d++) {
        momentum[d] = load[d] + own->mass * before[d] - own->late_mass * before[6 + d] +
                      weight * context->scene->gravity[d] * work->dt + impulse[d];
        momentum[3 + d] =
            load[3 + d] + own->inertia * before[3 + d] - own->late_inertia * before[9 + d] + impulse[3 + d];
    }
}

/* The given motion of a grain that the fluid does not move. */
static void motion_given(const struct rigid_work *work, size_t i, double motion[6]) {
    const struct particles *p = work->context->particles;
    double(*spin)[4] = spin_of(p);
    memcpy(motion, p->state[i].v, 3 * sizeof *motion);
    memset(motion + 3, 0, 3 * sizeof *motion);
    if (spin != NULL)
        memcpy(motion + 3, spin[i], 3 * sizeof *motion);
}

void rigid_sums_motions(const struct rigid_work *work) {
    const struct physics_context *context = work->context;
    struct particles *p = context->particles;
    double(*found)[6] = rigid_fields_found(p);
    for (size_t i = work->grains.first; i < work->grains.end; i++) {
        double displaced, moment, momentum[6];
        struct rigid_grains_own own = own_of(work, i, &displaced, &moment);
        if (!grain_moves(context, i)) {
            motion_given(work, i, found[i]);
            continue;
        }
        momentum_of(work, i, &own, displaced, momentum);
        rigid_grains_solve(&work->rigid->sums[i - work->grains.first], &own, momentum, found[i]);
    }
    if (context->ghosts == NULL)
        return;
    struct field_list list = fields_one(rigid_fields_found_handle(p));
    ghosts_forward_begin(context->ghosts, p, &list);
    ghosts_forward_end(context->ghosts, p);
}

void rigid_sums_loads(const struct rigid_work *work) {
    struct particles *p = work->context->particles;
    for (size_t i = work->grains.first; i < work->grains.end; i++) {
        const struct rigid_grains_sums *sums = &work->rigid->sums[i - work->grains.first];
        double *load = fluid_load(p)[i], *motion = rigid_fields_motion(p)[i], displaced, moment, given[6];
        const double *found = rigid_fields_found(p)[i];
        struct rigid_grains_own own = own_of(work, i, &displaced, &moment), whole = {0};
        bool moves = grain_moves(work->context, i);
        double mass = moves ? 1 / p->state[i].inverse_mass : 0,
               inertia = 0.4 * mass * p->state[i].radius * p->state[i].radius;
        whole.mass = moves ? mass - own.mass : displaced;
        whole.inertia = moves ? inertia - own.inertia : moment;
        own.late_mass = moves ? own.late_mass : 0;
        own.late_inertia = moves ? own.late_inertia : 0;
        rigid_grains_momentum(sums, found, given);
        for (int d = 0; d < 3; d++) {
            load[d] =
                (load[d] - given[d] + whole.mass * (found[d] - motion[d]) - own.late_mass * motion[6 + d]) /
                work->dt;
            load[3 + d] = (load[3 + d] - given[3 + d] + whole.inertia * (found[3 + d] - motion[3 + d]) -
                           own.late_inertia * motion[9 + d]) /
                          work->dt;
        }
        for (int d = 0; d < 6; d++) {
            motion[6 + d] = found[d] - motion[d];
            motion[d] = found[d];
        }
    }
}
