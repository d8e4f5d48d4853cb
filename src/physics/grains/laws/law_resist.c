/* SPDX-License-Identifier: BSD-3-Clause */
/* Sliding, rolling and twisting, one function each. Read law_resist.h first. */
#include "physics/grains/laws/law_resist.h"
#include <string.h>

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
    enum law_tangential kind = r->law->options.tangential;
    double stiffness = r->hold->grip->tangential, damping = in->coefficients.c_t * r->hold->base;
    double a = r->hold->grip->a;
    struct law_vector rate = law_slip_rate(in, r->plane), force;
    int at = r->law->memory.spring, radius = r->law->memory.radius;
    if (at < 0) { /* viscous */
        force = law_dash(r->step, rate, damping, in->coefficients.friction * r->hold->press, r->out);
    } else {
        double factor = law_spring_factor(kind, a, radius < 0 ? 0.0 : r->in->value[radius], stiffness);
        struct law_vector spring = law_scale(factor, vector_at(r->in->value + at));
        force = slide(r, rate, &spring, stiffness, damping);
        vector_put(r->in->value + at, law_scale(law_keeps_force(kind) ? stiffness : 1.0, spring));
    }
    if (radius >= 0 && r->step.dt > 0.0)
        r->in->value[radius] = a;
    r->out->force = law_add(r->out->force, 1.0, force);
    r->out->moment = law_cross(force, in->normal);
}

/* What resistances see of a contact. */
static struct law_touch touch_of(const struct law_surfaces *s, const struct law_hold *hold, double mass) {
    return (struct law_touch){s->c, {s->radius[0], s->radius[1], s->effective}, hold->grip, hold->base, mass};
}

static struct law_resistance rolling_of(const struct law *law, const struct law_surfaces *s,
                                        const struct law_hold *hold, double mass) {
    const struct law_touch touch = touch_of(s, hold, mass);
#define CASE(NAME, name, with, summary)                                                                      \
    if (law->options.rolling == LAW_ROLLING_##NAME)                                                          \
        return rolling_##name##_resist(&s->extra->rolling_##name, &touch);
    LAW_ROLLING_PARTS(CASE)
#undef CASE
    return (struct law_resistance){0};
}

static void resist_roll(struct resist *r) {
    const struct law_contact *in = &r->in->contact;
    struct law_surfaces s = {
        &in->coefficients, r->in->extra, {r->in->radius[0], r->in->radius[1]}, in->radius};
    struct law_vector rate = law_scale(in->radius, law_project(in->spin, r->plane)), force;
    double limit = in->coefficients.rolling_friction * r->hold->press;
    int at = r->law->memory.roll;
    struct law_resistance rolling = rolling_of(r->law, &s, r->hold, in->mass);
    if (at < 0) {
        force = law_dash(r->step, rate, INFINITY, limit, r->out);
    } else {
        struct law_vector spring = vector_at(r->in->value + at);
        force = law_roll(r->kind, r->step, in, rate, &spring,
                         law_rolling_form_of(r->law->options.rolling)->rests, rolling, limit, r->out);
        vector_put(r->in->value + at, spring);
    }
    r->out->rolling = law_add(r->out->rolling, in->radius, force);
}

static struct law_resistance twisting_of(const struct law *law, const struct law_surfaces *s,
                                         const struct law_hold *hold, double mass) {
    const struct law_touch touch = touch_of(s, hold, mass);
#define CASE(NAME, name, with, summary)                                                                      \
    if (law->options.twisting == LAW_TWISTING_##NAME)                                                        \
        return twisting_##name##_resist(&s->extra->twisting_##name, &touch);
    LAW_TWISTING_PARTS(CASE)
#undef CASE
    return (struct law_resistance){0};
}

static void resist_twist(struct resist *r) {
    const struct law_contact *in = &r->in->contact;
    struct law_surfaces s = {
        &in->coefficients, r->in->extra, {r->in->radius[0], r->in->radius[1]}, in->radius};
    struct law_resistance twisting = twisting_of(r->law, &s, r->hold, in->mass);
    double torque =
        law_twist(r->step, law_dot(in->spin, in->normal), &r->in->value[r->law->memory.twist], twisting,
                  twisting.limit * r->hold->press, r->law->options.lammps_granular, r->out);
    r->out->rolling = law_add(r->out->rolling, torque, in->normal);
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
    if (s->c->friction > 0.0) {
        stiff->k_t = law->memory.spring >= 0 ? hold->grip->tangential : 0.0;
        stiff->c_t = s->c->c_t * hold->base;
    }
    if (law->options.rolling != LAW_ROLLING_NONE && s->c->rolling_friction > 0.0) {
        struct law_resistance rolling = rolling_of(law, s, hold, mass);
        stiff->k_r = rolling.stiffness;
        stiff->c_r = rolling.damping;
    }
    struct law_resistance twisting = twisting_of(law, s, hold, mass);
    if (twisting.limit != 0.0) {
        stiff->k_w = twisting.stiffness;
        stiff->c_w = twisting.damping;
    }
}
