/* SPDX-License-Identifier: BSD-3-Clause */
/* The springs, dampers and first impulses of a row. Read contacts.h and row.h first. */
#include "physics/hard/contacts.h"

/* The part of an overlap that a rigid row wants away in a step. */
static const double rigid_repair = 0.2;

/* Rows begin with the impulses of the last step where there are at least so many sweeps a kappa, else with a part of them:
 * stiff rows that do not converge would swing. */
static const double warm_sweeps = 0.75, warm_part = 0.8;

/* Surfaces touch up to a gap of this part of the smaller radius: rounding. */
static const double touch = 1e-9;

/* Turns a vector of the tangent plane into that of `normal`, with its length. */
static void turn(const double old[3], const double normal[3], double out[3]) {
    double along = vector_dot(old, normal), before = vector_dot(old, old), after = 0.0;
    for (int d = 0; d < 3; d++)
        out[d] = old[d] - along * normal[d];
    after = vector_dot(out, out);
    for (int d = 0; d < 3 && after > 0.0; d++)
        out[d] *= sqrt(before / after);
}

/* Springs of a contact by kappa. */
static void stiffen_rigid(struct hard_row *row, const struct hard_terms *terms, const struct hard_pace *pace,
                          const struct hard_body *a, const struct hard_body *b, double smaller) {
    double share = pace->dt / (pace->duration * terms->kappa);
    row->soft_n = hard_push(row, a, b) * share;
    row->soft_t = hard_slide(row, a, b) * share;
    row->bias = row->gap / pace->dt;
    if (isinf(terms->kappa) && row->gap < 0.0)
        row->bias *= rigid_repair;
    row->release = terms->repair * smaller / pace->dt;
}

/* Springs of a contact by the law. `radius`: of the contact, effective. */
static void stiffen_law(struct hard_row *row, const struct hard_terms *terms, const struct hard_term *term,
                        const struct hard_pace *pace, double push, double radius) {
    double k = term->stiffness, h = pace->duration, mass = push > 0.0 ? 1.0 / push : 0.0;
    row->release = INFINITY;
    row->bias = row->gap / pace->dt;
    if (terms->hertz) {
        row->hertz = h * k * sqrt(radius);
        row->damper = h * term->damper * sqrt(mass * k * sqrt(radius));
        row->shear = h * pace->dt * term->tangential * sqrt(radius);
        row->deep = fmax(0.0, -row->gap);
        return;
    }
    double c = term->damper * sqrt(mass * k);
    row->soft_n = 1.0 / (h * (k * pace->dt + c));
    row->damper = h * c;
    row->soft_t = term->tangential > 0.0 ? 1.0 / (h * pace->dt * term->tangential) : 0.0;
    if (row->gap < 0.0)
        row->bias = row->gap / (pace->dt + c / k);
}

/* True if the step is too long to show the impact that the row begins: a rigid one, or one by the law that lasts less than
 * two steps (Hertz: 2.9432 times the largest overlap over the speed). */
static bool is_brief(const struct hard_row *row, const struct hard_term *term, const struct hard_pace *pace,
                     double push) {
    double speed = row->approach, mass = push > 0.0 ? 1.0 / push : 0.0, lasts = 0.0;
    if (row->hertz > 0.0)
        lasts = 2.9432 * pow(1.25 * mass * speed * speed * pace->duration / row->hertz, 0.4) / speed;
    else if (term->stiffness > 0.0)
        lasts = M_PI * sqrt(mass / term->stiffness);
    return lasts < 2.0 * pace->dt;
}

/* The stiffness of a row's normal spring in units of the step. */
static double kappa_of(const struct hard_row *row, const struct hard_pace *pace, double push) {
    double share = push * pace->dt / pace->duration;
    if (row->hertz > 0.0)
        return share * pace->dt * 1.5 * row->hertz * sqrt(row->deep);
    return row->soft_n > 0.0 ? share / row->soft_n : INFINITY;
}

/* Rolling and twisting begin with `keep` times the couple of the last step. */
static void resist_make(struct hard_row *row, const struct hard_term *term, const struct hard_pace *pace,
                        double effective, const struct hard_couple *memory, double keep) {
    struct hard_resist *resist = row->resist;
    double h = pace->duration;
    *resist = (struct hard_resist){.radius = effective,
                                   .roll_friction = term->rolling,
                                   .twist_friction = term->twisting / effective,
                                   .hold.twist = h * memory->twist};
    if (term->rolls.row == LAW_SOLVED_TANGENTIAL)
        resist->roll_soft = -1.0;
    else if (term->rolls.row == LAW_SOLVED_SPRING)
        resist->roll_soft = 1.0 / (h * pace->dt * term->rolls.stiffness);
    if (term->twist_stiffness > 0.0)
        resist->twist_soft = effective * effective / (h * pace->dt * term->twist_stiffness);
    turn(memory->roll, row->normal, resist->hold.roll);
    resist->now.twist = keep * resist->hold.twist;
    for (int d = 0; d < 3; d++) {
        resist->hold.roll[d] *= h;
        resist->now.roll[d] = keep * resist->hold.roll[d];
    }
}

/* True if the row begins an impact. `pull`: of the surfaces once they touch. */
static bool is_impact(const struct hard_row *row, const struct hard_term *term, const struct hard_pace *pace,
                      const struct hard_ends *ends, double pull) {
    double slowest = HARD_IMPACT_SPEED * pace->dt * (pace->fall + pull * ends->light);
    return ends->memory->push <= 0.0 && row->approach > slowest && is_brief(row, term, pace, ends->light);
}

/* The cohesion of surfaces that touch, or were pressed together in the last step. */
static void pull_make(struct hard_row *row, const struct hard_terms *terms, const struct hard_pace *pace,
                      double pull, double smaller, const struct hard_memory *memory) {
    if (row->impact || (row->gap > touch * smaller && !(memory->push > 0.0)))
        return;
    row->pull = pace->duration * pull;
    row->press = terms->press * row->pull;
}

void hard_row_finish(struct hard_row *row, const struct hard_problem *problem, const struct hard_terms *terms,
                     const struct hard_term *term, const struct hard_pace *pace,
                     const struct hard_ends *ends) {
    const struct hard_memory *memory = ends->memory;
    const struct hard_body *a = &problem->body[row->body[0]], *b = &problem->body[row->body[1]];
    const double *radius = ends->radius;
    double u[3], smaller = ends->size, push = hard_push(row, a, b);
    double effective = isinf(radius[1]) ? radius[0] : radius[0] * radius[1] / (radius[0] + radius[1]);
    row->friction = term->friction;
    row->restitution = term->restitution;
    if (term->stiffness > 0.0)
        stiffen_law(row, terms, term, pace, ends->light, effective);
    else
        stiffen_rigid(row, terms, pace, a, b, smaller);
    hard_velocity(row, a, b, u);
    row->approach = -vector_dot(u, row->normal);
    double keep = pace->sweeps >= warm_sweeps * kappa_of(row, pace, push) ? 1.0 : warm_part;
    turn(memory->rub, row->normal, row->hold);
    double pull = term->pull * effective;
    row->impact = is_impact(row, term, pace, ends, pull);
    pull_make(row, terms, pace, pull, smaller, memory);
    if (row->impact && terms->poisson) { /* until they touch: a gap would take the rebound */
        row->bias = fmin(0.0, row->bias);
        row->soft_n = row->soft_t = 0.0;
    }
    if (row->resist)
        resist_make(row, term, pace, effective, ends->couple, row->impact ? 0.0 : keep);
    if (row->resist && row->resist->roll_soft < 0.0 &&
        !(row->hertz > 0.0)) /* of one kappa, each with its own inertia */
        row->resist->roll_soft = term->stiffness > 0.0 || row->soft_t <= 0.0
                                     ? row->soft_t
                                     : row->soft_t * hard_resist_roll(row, a, b) / hard_slide(row, a, b);
    for (int d = 0; d < 3; d++) {
        row->hold[d] *= pace->duration;
        row->q[d] = row->impact ? 0.0 : keep * row->hold[d];
    }
    row->p = row->impact ? 0.0 : keep * pace->duration * memory->push;
}
