/* SPDX-License-Identifier: BSD-3-Clause */
/* The normal law of options, be it a row of the table or a file of the user's (law.h). */
#include "physics/grains/laws/law_user.h"

const struct law_form *law_form_of(const struct law_options *options) {
    return options->user ? &options->user->form : law_row_get(options->normal)->form;
}

static struct scree_law_springs user_springs(const struct law_user *user, const struct law_coefficients *c,
                                             const struct law_extra *extra, double radius, double overlap) {
    struct scree_law_contact contact = {overlap, radius, c->k_n, c->k_t, {0.0}};
    for (int p = 0; p < user->law->parameters; p++)
        contact.parameter[p] = extra->parameter[p];
    return user->law->one(contact);
}

struct law_springs law_springs_of(const struct law_options *options, const struct law_coefficients *c,
                                  const struct law_extra *extra, double radius, double overlap) {
    if (options->user == NULL)
        return law_springs(options->normal, c, radius, overlap);
    struct scree_law_springs s = user_springs(options->user, c, extra, radius, overlap);
    return (struct law_springs){.force = s.force,
                                .stiffness = s.stiffness,
                                .tangent = s.tangent,
                                .tangential = s.tangential,
                                .contact = s.contact,
                                .energy = s.energy};
}

double law_impact_of(const struct law_options *options, const struct law_coefficients *c,
                     const struct law_extra *extra, double mass, double radius, double speed) {
    if (options->user == NULL)
        return law_form_of(options)->impact(c, mass, radius, speed);
    double energy = 0.5 * mass * speed * speed, low = 0.0, high = 1e-6 * radius;
    for (int k = 0; k < 200 && law_springs_of(options, c, extra, radius, high).energy < energy; k++)
        high *= 2.0;
    for (int k = 0; k < 60; k++) {
        double middle = 0.5 * (low + high);
        if (law_springs_of(options, c, extra, radius, middle).energy < energy)
            low = middle;
        else
            high = middle;
    }
    return speed > 0.0 ? high : 0.0;
}

/* Twice the time from touch to `overlap`: with overlap = most sin(angle) the integrand is finite. */
double law_duration_of(const struct law_options *options, const struct law_coefficients *c,
                       const struct law_extra *extra, double mass, double radius, double overlap) {
    enum { PARTS = 256 };
    if (options->user == NULL)
        return law_form_of(options)->duration(c, mass, radius, overlap);
    double most = law_springs_of(options, c, extra, radius, overlap).energy, time = 0.0;
    for (int k = 0; k < PARTS; k++) {
        double angle = 0.5 * M_PI * (k + 0.5) / PARTS;
        double left = most - law_springs_of(options, c, extra, radius, overlap * sin(angle)).energy;
        time += overlap * cos(angle) * sqrt(0.5 * mass / law_most(left, 1e-300));
    }
    return 2.0 * time * 0.5 * M_PI / PARTS;
}
