/* SPDX-License-Identifier: BSD-3-Clause */
/* Single grains and bodies alike. Read rigid_bodies.h first. */
#include "physics/fluid/coupling/rigid_bodies.h"
#include "base/memory.h"
#include "base/vector.h"
#include "kernel/particles/spin.h"
#include "physics/bodies/bodies_fields.h"
#include "physics/bodies/bodies_links.h"
#include "physics/bodies/bodies_parts.h"
#include "base/rotor.h"
#include "physics/fluid/coupling/grain_coupling.h"
#include <math.h>
#include <string.h>

static const struct bodies_links *links_of(const struct physics_context *context) {
    return bodies_of(context->set)->links;
}

static bool is_body(const struct particles *p, size_t i) {
    return kinds_of(p)[i] == KIND_BODY;
}

static const struct bodies_row *row_of(const struct physics_context *context, size_t i) {
    const struct bodies_links *links = links_of(context);
    return &links->row[links->pose_of[i]];
}

static const double *turn_of(const struct physics_context *context, size_t i) {
    const struct bodies_links *links = links_of(context);
    return links->pose[links->pose_of[i]].turn;
}

struct kind_span rigid_bodies_span(const struct physics_context *context) {
    struct kind_span grains = kinds_span(context->particles, context->classes, KIND_GRAIN),
                     bodies = kinds_span(context->particles, context->classes, KIND_BODY);
    return bodies.end > bodies.first ? (struct kind_span){grains.first, bodies.end} : grains;
}

bool rigid_bodies_member(const struct particles *particles, size_t i) {
    const int64_t *body = carried_by(particles);
    return body != NULL && body[i] >= 0;
}

uint32_t rigid_bodies_carrier(const struct physics_context *context, size_t i, double arm[3],
                              double *distance) {
    const struct bodies_links *links = links_of(context);
    const struct bodies_row *row = row_of(context, i);
    const double *turn = turn_of(context, i);
    const struct solid *core = &row->clump->core;
    double offset[3], own[3];
    *distance = sqrt(vector_dot(arm, arm)) - context->particles->state[i].radius;
    rotor_turn(turn, links->offset[i], offset);
    for (int d = 0; d < 3; d++)
        arm[d] += offset[d];
    if (core->corners == 0)
        return row->particle;
    rotor_turn_back(turn, arm, own);
    for (int d = 0; d < 3; d++)
        own[d] /= row->scale;
    *distance = -row->scale * (solid_depth(core, own) + row->clump->rounding);
    return row->particle;
}

/* a = R diag(b) R^T. */
static void tensor_turn(const double turn[9], const double b[3], double a[6]) {
    static const int at[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
    for (int k = 0; k < 6; k++) {
        a[k] = 0;
        for (int d = 0; d < 3; d++)
            a[k] += turn[3 * at[k][0] + d] * b[d] * turn[3 * at[k][1] + d];
    }
}

static void tensor_even(double value, double a[6]) {
    for (int k = 0; k < 6; k++)
        a[k] = k < 3 ? value : 0;
}

static struct rigid_inertia inertia_of_grain(const struct physics_context *context, size_t i) {
    const struct fluid_options *options = context->options;
    const struct particle_state *state = &context->particles->state[i];
    double r = state->radius;
    struct rigid_inertia inertia = {.moves = grain_moves(context, i),
                                    .turns = spin_of(context->particles) != NULL,
                                    .mass = state->inverse_mass > 0 ? 1 / state->inverse_mass : 0,
                                    .displaced = options->density * grain_displaced(context, r)};
    tensor_even(0.4 * inertia.mass * r * r, inertia.own);
    tensor_even((context->box->dimension == 2 ? 0.5 : 0.4) * inertia.displaced * r * r, inertia.fluid);
    return inertia;
}

/* The plane section of a clump of two dimensions in its own frame: area, and second moment about the centre. */
static void section_of(const struct clump *clump, double section[2]) {
    enum { POINTS = 512 };
    const double step = 2 * clump->extent / POINTS;
    for (int k = 0; k < POINTS * POINTS; k++) {
        double x = (k % POINTS + 0.5) * step - clump->extent, y = (k / POINTS + 0.5) * step - clump->extent;
        bool in = false;
        for (int s = 0; s < clump->spheres && !in; s++) {
            const struct clump_sphere *sphere = &clump->sphere[s];
            in = hypot(x - sphere->centre[0], y - sphere->centre[1]) < sphere->radius;
        }
        section[0] += in ? step * step : 0;
        section[1] += in ? step * step * (x * x + y * y) : 0;
    }
}

double (*rigid_bodies_sections(const struct physics_context *context))[2] {
    const struct bodies *bodies = bodies_of(context->set);
    if (bodies == NULL)
        return NULL;
    double(*section)[2] = memory_allocate_zero((size_t)bodies->shapes, sizeof *section, "bodies in a fluid");
    for (int k = 0; k < bodies->shapes && context->box->dimension == 2; k++)
        section_of(&bodies->clump[k], section[k]);
    return section;
}

static struct rigid_inertia inertia_of_body(const struct physics_context *context, const double (*section)[2],
                                            size_t i) {
    const struct fluid_options *options = context->options;
    const struct bodies_row *row = row_of(context, i);
    const struct clump *clump = row->clump;
    struct rigid_inertia inertia = {
        .body = true, .moves = row->motion == NULL, .turns = true, .mass = row->mass};
    double moment[3], filled = clump->filled > 0 ? clump->filled : 1, scale = row->scale;
    tensor_turn(turn_of(context, i), row->inertia, inertia.own);
    if (context->box->dimension == 2) {
        const double *flat = section[bodies_part(context->particles)[i]];
        inertia.displaced = options->density * flat[0] * scale * scale;
        tensor_even(options->density * flat[1] * pow(scale, 4), inertia.fluid);
        return inertia;
    }
    inertia.displaced = options->density * filled * clump->volume * scale * scale * scale;
    for (int d = 0; d < 3; d++)
        moment[d] = inertia.displaced * clump->gyration[d] * scale * scale;
    tensor_turn(turn_of(context, i), moment, inertia.fluid);
    return inertia;
}

struct rigid_inertia rigid_bodies_inertia(const struct physics_context *context, const double (*section)[2],
                                          size_t i) {
    return is_body(context->particles, i) ? inertia_of_body(context, section, i)
                                          : inertia_of_grain(context, i);
}

void rigid_bodies_contact(const struct physics_context *context, size_t i, double force[6]) {
    const struct particles *p = context->particles;
    const double *on = p->force + i * (size_t)p->force_stride;
    const bool turns = spin_of(p) != NULL;
    if (is_body(p, i)) {
        bodies_motion_force(links_of(context), context, links_of(context)->pose_of[i], force, force + 3);
        for (int d = 0; d < 6 && context->box->dimension == 2; d++)
            force[d] = d >= 2 && d <= 4 ? 0 : force[d];
        return;
    }
    for (int d = 0; d < 3; d++) {
        force[d] = on[d];
        force[3 + d] = turns ? on[4 + d] : 0;
    }
}

void rigid_bodies_turn(const struct physics_context *context, size_t i, const double torque[3], double time,
                       double change[3]) {
    const struct particle_state *state = &context->particles->state[i];
    double spin[3];
    if (!is_body(context->particles, i)) {
        for (int d = 0; d < 3; d++)
            change[d] = time * torque[d] * 2.5 * state->inverse_mass / (state->radius * state->radius);
        return;
    }
    for (int d = 0; d < 3; d++)
        spin[d] = time * torque[d];
    rotor_velocity(turn_of(context, i), spin, row_of(context, i)->inertia, change);
}

void rigid_bodies_motion(const struct physics_context *context, size_t i, double motion[6]) {
    const struct particles *p = context->particles;
    double(*spin)[4] = spin_of(p);
    memset(motion, 0, 6 * sizeof *motion);
    if (is_body(p, i)) {
        memcpy(motion, bodies_velocity(p)[i], 3 * sizeof *motion);
        rotor_velocity(turn_of(context, i), bodies_spin(p)[i], row_of(context, i)->inertia, motion + 3);
        return;
    }
    memcpy(motion, p->state[i].v, 3 * sizeof *motion);
    if (spin != NULL)
        memcpy(motion + 3, spin[i], 3 * sizeof *motion);
}

void rigid_bodies_set(const struct physics_context *context, size_t i, const double motion[6]) {
    const struct particles *p = context->particles;
    double(*spin)[4] = spin_of(p);
    const int dimension = context->box->dimension;
    if (is_body(p, i)) {
        const double *turn = turn_of(context, i), *inertia = row_of(context, i)->inertia;
        double own[3];
        memcpy(bodies_velocity(p)[i], motion, (size_t)dimension * sizeof *motion);
        rotor_turn_back(turn, motion + 3, own);
        for (int d = 0; d < 3; d++)
            own[d] *= inertia[d];
        rotor_turn(turn, own, bodies_spin(p)[i]);
        return;
    }
    memcpy(p->state[i].v, motion, (size_t)dimension * sizeof *motion);
    if (spin != NULL)
        memcpy(spin[i], motion + 3, 3 * sizeof *motion);
}

void rigid_bodies_given(const struct physics_context *context, size_t i, double motion[6]) {
    const struct integrator_motion *given =
        is_body(context->particles, i) ? row_of(context, i)->motion : NULL;
    if (given == NULL) {
        rigid_bodies_motion(context, i, motion);
        return;
    }
    memcpy(motion, given->velocity, 3 * sizeof *motion);
    memcpy(motion + 3, given->omega, 3 * sizeof *motion);
}
