/* SPDX-License-Identifier: BSD-3-Clause */
/* Sums over the nodes of grains. Read rigid_sums.h first. */
#include "physics/fluid/coupling/rigid_sums.h"
#include "physics/fluid/coupling/rigid_bodies.h"
#include "base/vector.h"
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

/* The sums of walls: with the gain, and with phi, whose parts in a node are in the ratio of those of the gain. */
static void moments_of_walls(const struct rigid_work *work) {
    struct rigid *rigid = work->rigid;
    rigid_walls_clear(&rigid->walls);
    if (rigid->walls.bodies == 0)
        return;
    const double *filled = rigid_fields_solid(work->context->particles) + work->fluid->weights.first;
    for (size_t k = 0; k < rigid->solid.parts; k++) {
        const struct solid_part *part = &rigid->solid.part[k];
        int wall = solid_wall(part->grain);
        if (wall < 0)
            continue;
        double mass = mass_of(work, part), phi = filled[part->row];
        rigid_grains_add(&rigid->walls.wall[wall].sums, mass, part->arm);
        rigid_grains_add(&rigid->walls.wall[wall].whole, mass * phi / solid_gain(phi, work->kappa),
                         part->arm);
    }
}

void rigid_sums_moments(const struct rigid_work *work) {
    struct rigid *rigid = work->rigid;
    double(*load)[6] = fluid_load(work->context->particles);
    moments_of_walls(work);
    for (int round = 0; round < 2; round++) {
        sums_clear(work);
        for (size_t k = 0; k < rigid->solid.parts; k++) {
            const struct solid_part *part = &rigid->solid.part[k];
            struct rigid_grains_sums one = {0};
            if (solid_wall(part->grain) >= 0)
                continue;
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
    struct rigid_walls *walls = &work->rigid->walls;
    double(*load)[6] = fluid_load(work->context->particles);
    sums_clear(work);
    rigid_walls_clear_momenta(walls);
    for (size_t node = 0; node < solid->nodes; node++)
        for (size_t k = solid->start[node]; k < solid->start[node + 1]; k++) {
            const struct solid_part *part = &solid->part[k];
            int wall = solid_wall(part->grain);
            double mass = mass_of(work, part),
                   *to = wall >= 0 ? walls->wall[wall].momenta : load[part->grain];
            for (int d = 0; d < 3; d++) {
                int next = (d + 1) % 3, last = (d + 2) % 3;
                to[d] += mass * v[node][d];
                to[3 + d] += mass * (part->arm[next] * v[node][last] - part->arm[last] * v[node][next]);
            }
        }
    sums_bring(work);
}

/* The sums of a sphere in the fluid are at least the mean over this. */
#define GRAIN_WHOLE 1.1

/* What a grain has that the fluid in it has not: where it is lighter, or smaller to the fluid, by the mean of a sphere alone over all lattices, and by the present sums of a body. */
static struct rigid_grains_own own_of(const struct rigid_work *work, size_t i,
                                      const struct rigid_inertia *inertia) {
    const struct physics_context *context = work->context;
    const struct fluid_options *options = work->fluid->options;
    const struct rigid_grains_sums *sums = &work->rigid->sums[i - work->grains.first];
    const double hydraulic = options->grains.hydraulic;
    const bool small = hydraulic < 1, light = small || inertia->mass < inertia->displaced;
    struct rigid_grains_own own = {.dimension = context->box->dimension, .turns = inertia->turns};
    double volume = 0, second = 0;
    if (!inertia->body) { /* at an open side a part of it may lie outside of the fluid */
        solid_mean(hydraulic * context->particles->state[i].radius, options->spacing, work->kappa,
                   context->box->dimension, &volume, &second);
        volume = fmin(options->density * volume, GRAIN_WHOLE * sums->mass);
        second = fmin(options->density * second, GRAIN_WHOLE * fmax(sums->second[0], sums->second[2]));
    }
    own.mass = inertia->mass - (!light ? inertia->displaced : inertia->body ? sums->mass : volume);
    own.late_mass = fmin(0.5 * own.mass, 0);
    own.mass -= own.late_mass;
    for (int k = 0; k < 6; k++) {
        bool swings = inertia->body ? light : small || inertia->own[k] < inertia->fluid[k];
        own.inertia[k] = inertia->own[k] - (!swings         ? inertia->fluid[k]
                                            : inertia->body ? sums->second[k]
                                            : k < 3         ? second
                                                            : 0);
        own.late_inertia[k] =
            inertia->body ? (light ? 0.5 * own.inertia[k] : 0) : fmin(0.5 * own.inertia[k], 0);
        own.inertia[k] -= own.late_inertia[k];
    }
    return own;
}

/* The right-hand side of the equations of a grain that the fluid moves: `load` are the momenta of v. */
static void momentum_of(const struct rigid_work *work, size_t i, const struct rigid_inertia *inertia,
                        const struct rigid_grains_own *own, double momentum[6]) {
    const struct physics_context *context = work->context;
    const double *load = fluid_load(context->particles)[i],
                 *before = rigid_fields_motion(context->particles)[i],
                 *impulse = rigid_fields_impulse(context->particles)[i];
    double weight = inertia->mass - inertia->displaced, spin[3], late[3], top[3] = {0};
    rigid_grains_spin(own->inertia, before + 3, spin);
    rigid_grains_spin(own->late_inertia, before + 9, late);
    if (inertia->body) /* its inertia turns with it */
        vector_cross(before + 3, spin, top);
    for (int d = 0; d < 3; d++) {
        momentum[d] = load[d] + own->mass * before[d] - own->late_mass * before[6 + d] +
                      weight * context->scene->gravity[d] * work->dt + impulse[d];
        momentum[3 + d] = load[3 + d] + spin[d] - late[d] + impulse[3 + d] - work->dt * top[d];
    }
}

void rigid_sums_motions(const struct rigid_work *work) {
    const struct physics_context *context = work->context;
    struct particles *p = context->particles;
    double(*found)[6] = rigid_fields_found(p);
    for (size_t i = work->grains.first; i < work->grains.end; i++) {
        if (rigid_bodies_member(p, i))
            continue;
        struct rigid_inertia inertia =
            rigid_bodies_inertia(context, (const double(*)[2])work->rigid->section, i);
        if (!inertia.moves) {
            rigid_bodies_given(context, i, found[i]);
            continue;
        }
        struct rigid_grains_own own = own_of(work, i, &inertia);
        double momentum[6];
        momentum_of(work, i, &inertia, &own, momentum);
        rigid_grains_solve(&work->rigid->sums[i - work->grains.first], &own, momentum, found[i]);
    }
    if (context->ghosts == NULL)
        return;
    struct field_list list = fields_one(rigid_fields_found_handle(p));
    ghosts_forward_begin(context->ghosts, p, &list);
    ghosts_forward_end(context->ghosts, p);
}

/* The load of a grain, and its new motion. */
static void load_of(const struct rigid_work *work, size_t i) {
    struct particles *p = work->context->particles;
    const struct rigid_grains_sums *sums = &work->rigid->sums[i - work->grains.first];
    double *load = fluid_load(p)[i], *motion = rigid_fields_motion(p)[i], given[6], change[6], spin[3],
           late[3];
    const double *found = rigid_fields_found(p)[i];
    struct rigid_inertia inertia =
        rigid_bodies_inertia(work->context, (const double(*)[2])work->rigid->section, i);
    struct rigid_grains_own own = own_of(work, i, &inertia), whole = {.mass = inertia.displaced};
    memcpy(whole.inertia, inertia.fluid, sizeof whole.inertia);
    if (inertia.moves) {
        whole.mass = inertia.mass - own.mass;
        for (int k = 0; k < 6; k++)
            whole.inertia[k] = inertia.own[k] - own.inertia[k];
    } else {
        own = (struct rigid_grains_own){0};
    }
    for (int d = 0; d < 6; d++)
        change[d] = found[d] - motion[d];
    rigid_grains_momentum(sums, found, given);
    rigid_grains_spin(whole.inertia, change + 3, spin);
    rigid_grains_spin(own.late_inertia, motion + 9, late);
    for (int d = 0; d < 3; d++) {
        load[d] = (load[d] - given[d] + whole.mass * change[d] - own.late_mass * motion[6 + d]) / work->dt;
        load[3 + d] = (load[3 + d] - given[3 + d] + spin[d] - late[d]) / work->dt;
    }
    memcpy(motion, found, sizeof change);
    memcpy(motion + 6, change, sizeof change);
}

void rigid_sums_loads(const struct rigid_work *work) {
    for (size_t i = work->grains.first; i < work->grains.end; i++)
        if (!rigid_bodies_member(work->context->particles, i))
            load_of(work, i);
    rigid_walls_loads(&work->rigid->walls, work->context, work->dt, work->fluid->drive.force);
}
