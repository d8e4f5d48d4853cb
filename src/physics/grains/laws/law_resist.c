/* SPDX-License-Identifier: BSD-3-Clause */
/* Sliding, rolling and twisting, one function each. Read law_resist.h first. */
#include "physics/grains/laws/law_resist.h"
#include <string.h>

static const double resist_tiny = 1e-100;

/* A contact on its way through the three. */
struct resist {
    const struct law *law;
    struct law_case kind;
    struct law_step step;
    struct law_general *in;
    const struct law_hold *hold;
    struct law_response *out;
    struct law_vector plane; /* normal of the plane in which springs advance */
};

static struct law_vector vector_at(const double *value) {
    return (struct law_vector){value[0], value[1], value[2]};
}

static void vector_put(double *value, struct law_vector v) {
    value[0] = v.x;
    value[1] = v.y;
    value[2] = v.z;
}

/* The factor by which a tangential spring changes before it advances: with the contact radius on unloading, and
 * where the force is remembered, from force to displacement by the stiffness now. */
static double spring_factor(const struct resist *r, double stiffness) {
    enum law_tangential kind = r->law->options.tangential;
    const double *value = r->in->value;
    int at = r->law->memory.radius;
    double factor = 1.0, a = r->hold->grip->a;
    if (at >= 0 && a < value[at])
        factor = a / value[at];
    if (kind == LAW_TANGENTIAL_FORCE || kind == LAW_TANGENTIAL_RESCALE_FORCE)
        factor /= fmax(stiffness, resist_tiny);
    return factor;
}

/* The limit of a contact that sticks, and of one that slides. */
static struct law_vector slide(struct resist *r, struct law_vector rate, struct law_vector *spring,
                               double stiffness, double damping) {
    const struct law_contact *in = &r->in->contact;
    double kinetic = in->coefficients.friction, hold = fmax(r->in->extra->static_friction, kinetic);
    int at = r->law->memory.slides;
    struct law_vector before = *spring, force;
    struct law_response scrap = {0};
    if (at < 0 || !(hold > kinetic))
        return law_slide(r->kind, r->step, in, rate, spring, stiffness, damping, kinetic * r->hold->press,
                         r->out);
    force = law_slide(r->kind, r->step, in, rate, &before, stiffness, damping, DBL_MAX, &scrap);
    double limit = (r->in->value[at] != 0.0 ? kinetic : hold) * r->hold->press;
    bool slides = law_dot(force, force) > limit * limit;
    r->in->value[at] = slides ? 1.0 : 0.0;
    return law_slide(r->kind, r->step, in, rate, spring, stiffness, damping,
                     (slides ? kinetic : hold) * r->hold->press, r->out);
}

static void resist_slide(struct resist *r) {
    const struct law_contact *in = &r->in->contact;
    double stiffness = r->hold->grip->tangential, damping = in->coefficients.c_t * r->hold->base;
    struct law_vector rate =
        law_add(law_project(in->velocity, r->plane), -1.0, law_cross(in->surface, r->plane));
    struct law_vector force;
    int at = r->law->memory.spring;
    if (at < 0) { /* viscous */
        double size = sqrt(law_dot(rate, rate)), limit = in->coefficients.friction * r->hold->press;
        force = law_scale(-fmin(damping, limit / fmax(size, resist_tiny)), rate);
        r->out->taken -= r->step.dt * law_dot(force, rate);
    } else {
        double factor = spring_factor(r, stiffness);
        struct law_vector spring = law_scale(factor, vector_at(r->in->value + at));
        enum law_tangential kind = r->law->options.tangential;
        bool keeps_force = kind == LAW_TANGENTIAL_FORCE || kind == LAW_TANGENTIAL_RESCALE_FORCE;
        force = slide(r, rate, &spring, stiffness, damping);
        vector_put(r->in->value + at, law_scale(keeps_force ? stiffness : 1.0, spring));
    }
    if (r->law->memory.radius >= 0 && r->step.dt > 0.0)
        r->in->value[r->law->memory.radius] = r->hold->grip->a;
    r->out->force = law_add(r->out->force, 1.0, force);
    r->out->moment = law_cross(force, in->normal);
}

/* The inertia against rolling of two spheres of one density, 1 / (5/(7 m_i r_i^2) + 5/(7 m_j r_j^2)), by their effective
 * mass and radii; that of the sphere at a wall. */
static double rolling_inertia(const double radius[2], double effective, double mass) {
    double a = radius[0], b = radius[1], aa = a * a, bb = b * b;
    if (isinf(a) || isinf(b))
        return 1.4 * mass * effective * effective;
    return 1.4 * mass * (aa * bb) * (aa * a + bb * b) / (aa * aa * a + bb * bb * b);
}

/* Stiffness and damper of rolling, per displacement R* x angle. */
static void rolling_spring(const struct law *law, const struct law_surfaces *s, const struct law_hold *hold,
                           double mass, double *stiffness, double *damping) {
    double friction = s->c->rolling_friction;
    *stiffness = hold->grip->tangential;
    *damping = s->c->c_t * hold->base;
    if (law->options.rolling == LAW_ROLLING_SPRING && s->extra->rolling_stiffness > 0.0) {
        *stiffness = s->extra->rolling_stiffness;
        *damping = s->extra->rolling_damping;
    }
    if (law->options.rolling == LAW_ROLLING_EPSD) {
        double inertia = rolling_inertia(s->radius, s->effective, mass) / (s->effective * s->effective);
        *stiffness = 2.25 * hold->grip->spring * friction * friction;
        *damping = 2.0 * s->extra->rolling_damping_ratio * sqrt(inertia * *stiffness);
    }
    if (law->options.rolling == LAW_ROLLING_CONSTANT)
        *stiffness = *damping = 0.0;
}

static void resist_roll(struct resist *r) {
    const struct law_contact *in = &r->in->contact;
    struct law_surfaces s = {
        &in->coefficients, r->in->extra, {r->in->radius[0], r->in->radius[1]}, in->radius};
    struct law_vector rate = law_scale(in->radius, law_project(in->spin, r->plane)), force;
    double limit = in->coefficients.rolling_friction * r->hold->press, stiffness, damping;
    int at = r->law->memory.roll;
    rolling_spring(r->law, &s, r->hold, in->mass, &stiffness, &damping);
    if (at < 0) {
        force = law_scale(-limit / fmax(sqrt(law_dot(rate, rate)), resist_tiny), rate);
        r->out->taken -= r->step.dt * law_dot(force, rate);
    } else {
        struct law_vector spring = vector_at(r->in->value + at);
        bool epsd = r->law->options.rolling == LAW_ROLLING_EPSD;
        force =
            law_slide(r->kind, r->step, in, rate, &spring, stiffness, epsd ? 0.0 : damping, limit, r->out);
        if (epsd &&
            law_dot(force, force) < limit * limit * (1.0 - 1e-12)) { /* the dashpot rests at the limit */
            force = law_add(force, -damping, rate);
            r->out->taken += r->step.dt * damping * law_dot(rate, rate);
        }
        vector_put(r->in->value + at, spring);
    }
    r->out->rolling = law_add(r->out->rolling, in->radius, force);
}

/* Stiffness, damper and limit of twisting. */
static void twisting_spring(const struct law *law, const struct law_surfaces *s, const struct law_hold *hold,
                            double *stiffness, double *damping, double *friction) {
    double a = hold->grip->a;
    *stiffness = s->extra->twisting_stiffness;
    *damping = s->extra->twisting_damping;
    *friction = s->extra->twisting_friction;
    if (law->options.twisting != LAW_TWISTING_MARSHALL)
        return;
    *stiffness = 0.5 * hold->grip->tangential * a * a;
    *damping = 0.5 * s->c->c_t * hold->base * a * a;
    *friction = 2.0 / 3.0 * a * s->c->friction;
}

static void resist_twist(struct resist *r) {
    const struct law_contact *in = &r->in->contact;
    struct law_surfaces s = {
        &in->coefficients, r->in->extra, {r->in->radius[0], r->in->radius[1]}, in->radius};
    double stiffness, damping, friction, *angle = &r->in->value[r->law->memory.twist];
    twisting_spring(r->law, &s, r->hold, &stiffness, &damping, &friction);
    double rate = law_dot(in->spin, in->normal), trial = *angle + r->step.dt * rate;
    double torque = -stiffness * trial - damping * rate, limit = friction * r->hold->press;
    bool over = fabs(torque) > limit;
    double cut = over ? copysign(limit, r->law->options.lammps_granular ? -rate : torque) : torque;
    double give = fmax(stiffness + damping * r->step.relaxation, resist_tiny), before = *angle;
    *angle = over ? trial + (torque - cut) / give : trial;
    r->out->rolling = law_add(r->out->rolling, cut, in->normal);
    r->out->spring_energy += 0.5 * stiffness * *angle * *angle;
    r->out->taken -= r->step.dt * rate * (cut + 0.5 * stiffness * (*angle - before));
}

void law_resist_forget(const struct law *law, double *value) {
    const struct law_memory *m = &law->memory;
    const int places[] = {m->twist, m->radius, m->slides};
    memset(value, 0, (size_t)law->history_odd * sizeof *value);
    for (size_t k = 0; k < sizeof places / sizeof places[0]; k++)
        if (places[k] >= 0)
            value[places[k]] = 0.0;
}

void law_resist(const struct law *law, struct law_step step, struct law_general *in,
                const struct law_hold *hold, struct law_response *out) {
    struct resist r = {law, law_case_of(&law->options, true), step, in, hold, out, in->contact.normal};
    if (!hold->grip->touches) {
        law_resist_forget(law, in->value);
        return;
    }
    if (law->options.synchronised)
        r.plane = in->contact.half_normal;
    resist_slide(&r);
    if (law->options.rolling != LAW_ROLLING_NONE)
        resist_roll(&r);
    if (law->options.twisting != LAW_TWISTING_NONE)
        resist_twist(&r);
}

void law_resist_stiff(const struct law *law, const struct law_surfaces *s, const struct law_hold *hold,
                      double mass, struct law_stiff *stiff) {
    double limit;
    if (s->c->friction > 0.0) {
        stiff->k_t = law->memory.spring >= 0 ? hold->grip->tangential : 0.0;
        stiff->c_t = s->c->c_t * hold->base;
    }
    if (law->options.rolling != LAW_ROLLING_NONE && s->c->rolling_friction > 0.0)
        rolling_spring(law, s, hold, mass, &stiff->k_r, &stiff->c_r);
    if (law->options.twisting != LAW_TWISTING_NONE) {
        twisting_spring(law, s, hold, &stiff->k_w, &stiff->c_w, &limit);
        if (limit == 0.0)
            stiff->k_w = stiff->c_w = 0.0;
    }
}
