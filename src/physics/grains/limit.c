/* SPDX-License-Identifier: BSD-3-Clause */
/* Passes the contacts of all ranks to stability.h and iterates. Read grains_own.h first. */
#include "physics/grains/grains_own.h"
#include "engine/physics_set.h"
#include "kernel/particles/material.h"
#include "kernel/particles/spin.h"
#include "base/memory.h"
#include "physics/grains/motion/stability.h"
#include "physics/grains/walls/walls_free.h"
#include "kernel/particles/fields.h"
#include <math.h>
#include <string.h>

/* Sends the sums of copies to their originals, by the exchange of forces: a few components at a time, in the
 * memory of the forces. The forces are restored afterwards. */
static void sums_home(const struct physics_context *context, struct stability *stability) {
    struct particles *p = context->particles;
    struct field_list fields = fields_one(FIELD_FORCE);
    size_t stride = (size_t)p->force_stride, sums = (size_t)stability->sums, bytes;
    size_t width = spin_of(p) ? 6 : 3;
    if (spin_of(p))
        fields.field[fields.count++] = fields_find(p, "torque");
    double *kept = memory_allocate(stability->count * stride, sizeof *kept, "stability of contacts");
    bytes = stability->count * stride * sizeof *kept;
    memcpy(kept, p->force, bytes);
    for (size_t first = 0; first < sums; first += width) {
        size_t part = sums - first < width ? sums - first : width;
        memset(p->force, 0, bytes);
        for (size_t k = 0; k < stability->count; k++)
            for (size_t c = 0; c < part; c++)
                p->force[k * stride + c + c / 3] = stability->sum[k * sums + first + c];
        ghosts_reverse(context->ghosts, p, &fields);
        for (size_t k = 0; k < p->owned; k++)
            for (size_t c = 0; c < part; c++)
                stability->sum[k * sums + first + c] = p->force[k * stride + c + c / 3];
    }
    memcpy(p->force, kept, bytes);
    memory_free(kept);
}

/* Sends the results of originals to their copies, in the memory of the velocity. The velocity is restored
 * afterwards. */
static void local_out(const struct physics_context *context, struct stability *stability) {
    struct particles *p = context->particles;
    struct field_list fields = fields_one(FIELD_VELOCITY);
    struct particle_state *kept = memory_allocate(stability->count, sizeof *kept, "stability of contacts");
    memcpy(kept, p->state, stability->count * sizeof *kept);
    for (size_t k = 0; k < p->owned; k++)
        p->state[k].v[0] = stability->local[k];
    ghosts_forward_begin(context->ghosts, p, &fields);
    ghosts_forward_end(context->ghosts, p);
    for (size_t k = p->owned; k < stability->count; k++)
        stability->local[k] = p->state[k].v[0];
    memcpy(p->state, kept, stability->count * sizeof *kept);
    memory_free(kept);
}

static void walls_give(const struct physics_context *context, struct stability *stability) {
    struct grains *grains = context->self;
    struct force_contact *contacts = NULL;
    int material[WALLS_MAX];
    size_t count = walls_contacts(grains->walls, &grains->contact, &contacts);
    for (int w = 0; w < walls_count(grains->walls); w++)
        material[w] = walls_options(grains->walls, w)->material;
    stability_walls(stability, &grains->contact, contacts, count, material);
    memory_free(contacts);
    if (!walls_have_free(grains->walls))
        return;
    for (int t = 0; t < context->threads; t++)
        stability_free_walls(stability, &grains->contact, grains->walls, t);
    comm_sum(context->comm, stability->wall, stability->walls);
}

/* Members of bodies that turn more easily than their spheres do. */
static void bodies_ease(const struct physics_context *context, struct stability *stability) {
    PHYSICS_EACH (active, context->set, joints)
        for (size_t k = 0; active->row->joints->ease && k < context->particles->owned; k++) {
            struct timestep_body body = TIMESTEP_SPHERE;
            active->row->joints->ease(&active->context, k, NULL, &body);
            stability->local[k] *= body.ease;
        }
}

/* The bound on the largest eigenvalue at step h; the scheme is stable up to 4. */
static double eigenvalue_at(const struct physics_context *context, double h) {
    struct grains *grains = context->self;
    struct stability stability;
    stability_create(&stability, &grains->contact, h);
    stability_pairs(&stability, &grains->contact);
    if (grains->walls)
        walls_give(context, &stability);
    PHYSICS_EACH (active, context->set, joints)
        if (active->row->joints->stiffen)
            active->row->joints->stiffen(&active->context, &stability);
    if (context->ghosts && context->scene->ghosts.newton)
        sums_home(context, &stability);
    stability_solve(&stability, context->particles);
    bodies_ease(context, &stability);
    if (context->ghosts)
        local_out(context, &stability);
    double worst = stability_worst(&stability, &grains->contact);
    PHYSICS_EACH (active, context->set, joints)
        if (active->row->joints->stiffest)
            worst = fmax(worst, active->row->joints->stiffest(&active->context, &stability));
    stability_free(&stability);
    comm_max(context->comm, &worst, 1);
    return worst;
}

/* The eigenvalue is S h^2 + D h; S and D depend on h little or not at all. The root for the springs alone
 * lies above the limit. From there the root of a straight line lies slightly below the limit. */
double limit_of_contacts(const struct physics_context *context, double most) {
    double worst = eigenvalue_at(context, most), h;
    if (worst <= 4)
        return most;
    h = most * sqrt(4 / worst);
    return h * fmin(1, 4 / eigenvalue_at(context, h));
}
