/* SPDX-License-Identifier: BSD-3-Clause */
/* The limits of the step, pair of materials by pair. Read timestep.h first; the formulas are in
 * docs/physics.md. */
#include "physics/grains/motion/timestep.h"
#include "base/memory.h"
#include "physics/grains/laws/law_general.h"
#include <math.h>

/* Contacts of a particle with its like at a time, in three dimensions and in two. */
enum { TIMESTEP_CONTACTS_3D = 12, TIMESTEP_CONTACTS_2D = 6 };

/* Contacts along faces at a time: a rock lies on one and carries another. */
enum { TIMESTEP_SEATS = 2 };

static const double timestep_overlap_relative = 1e-3;

/* A kind at its smallest or largest radius, with the largest stiffness that its contacts may give. */
struct timestep_side {
    const struct timestep_kind *kind;
    double radius, inverse_mass;     /* of a wall: infinite, 0 */
    double curved;                   /* radius of the surface at contacts */
    double stiffness, damping;       /* local values: 1/time^2, 1/time */
    double stable;                   /* least step that a partner alone would set */
    double frequency, damping_ratio; /* of one contact with this partner */
    int partner;                     /* material of this partner */
};

/* Two sides that may meet. */
struct timestep_meeting {
    double mass, radius, overlap; /* m*, R* */
    struct timestep_springs springs;
};

double timestep_default_fraction(void) {
    return 0.15;
}

double timestep_bound(double stiffness, double damping, double inverse_mass) {
    double square = stiffness * inverse_mass, rate = 0.5 * damping * inverse_mass; /* w^2, zeta w */
    if (square <= 0.0 && rate <= 0.0)
        return INFINITY;
    /* 2 (sqrt(w^2 + rate^2) - rate) / w^2 without the difference */
    return 2.0 / (sqrt(square + rate * rate) + rate);
}

/* Surfaces of a pair of materials by their effective radius: those of two like spheres. */
static struct law_surfaces timestep_surfaces(const struct law *law, int a, int b, double radius) {
    return (struct law_surfaces){
        law_pair_of(law, a, b), law_extra_of(law, a, b), {2.0 * radius, 2.0 * radius}, radius};
}

/* Those of a law with parts. */
static struct timestep_springs timestep_general(const struct law *law, const struct law_surfaces *surfaces,
                                                double mass, double overlap) {
    struct law_stiff s = law_general_stiff(law, surfaces, mass, overlap);
    return (struct timestep_springs){s.k_n, s.k_t, s.k_r, s.c_n, s.c_t, s.c_r, s.k_w, s.c_w};
}

struct timestep_springs timestep_springs(const struct law *law, int a, int b, double mass, double radius,
                                         double overlap) {
    const struct law_options *options = &law->options;
    const struct law_coefficients *c = law_pair_of(law, a, b);
    if (law->general) {
        struct law_surfaces surfaces = timestep_surfaces(law, a, b, radius);
        return timestep_general(law, &surfaces, mass, overlap);
    }
    struct law_springs springs = law_springs_of(options, c, law_extra_of(law, a, b), radius, overlap);
    bool given = law_damping_form_of(options->damping)->given;
    double base = given ? mass * springs.contact : sqrt(mass * springs.stiffness);
    struct timestep_springs s = {.k_n = springs.tangent, .c_n = c->c_n * base};
    if (law->spin && c->friction > 0.0) {
        s.k_t = springs.tangential;
        s.c_t = c->c_t * base;
    }
    if (law->spin && options->rolling != LAW_ROLLING_NONE && c->rolling_friction > 0.0) {
        s.k_r = springs.tangential;
        s.c_r = c->c_t * base;
    }
    return s;
}

static struct timestep_meeting timestep_meet(const struct timestep_input *input,
                                             const struct timestep_side *a, const struct timestep_side *b) {
    const struct law *law = input->law;
    struct timestep_meeting m = {.mass = 1.0 / (a->inverse_mass + b->inverse_mass),
                                 .radius = 1.0 / (1.0 / a->curved + 1.0 / b->curved)};
    int p = a->kind->material, q = b->kind->material;
    double least = input->overlap_relative > 0.0 ? input->overlap_relative : timestep_overlap_relative;
    double reached = law_impact_of(&law->options, law_pair_of(law, p, q), law_extra_of(law, p, q), m.mass,
                                   m.radius, input->speed_max);
    if (law->general) {
        struct law_surfaces surfaces = timestep_surfaces(law, p, q, m.radius);
        reached += law_grip_rest(&law->options, &surfaces);
    }
    m.overlap = fmax(reached, least * fmin(a->radius, b->radius));
    m.springs = timestep_springs(law, p, q, m.mass, m.radius, m.overlap);
    return m;
}

/* Contacts that `a` may have with the like of b: N with its own, more where it is larger; by default fewer
 * where it is smaller, down to a quarter with walls. */
static double timestep_contacts(const struct timestep_input *input, const struct timestep_side *a,
                                const struct timestep_side *b) {
    bool plane = input->dimension == 2;
    double ratio = 0.5 * (1.0 + a->radius / b->radius), room = plane ? ratio : ratio * ratio;
    if (input->contacts > 0)
        return input->contacts * fmax(1.0, room);
    return plane ? fmax(3.0, TIMESTEP_CONTACTS_2D * room) : TIMESTEP_CONTACTS_3D * room;
}

/* The local stiffness over 1/mass of n contacts with springs k_n, k_t, k_r (the last one times (R* / r)^2):
 * the largest of three on one side, of pushing and of turning (docs/physics.md). Dampers likewise. */
static double timestep_local(int dimension, double n, double k_n, double k_t, double k_r) {
    const double turn = 1.0 / TIMESTEP_INERTIA;
    double single = fmax(k_n, (1.0 + turn) * k_t + turn * k_r);
    double even = n / (dimension == 2 ? 2.0 : 3.0); /* sum of n n^T along any direction, if spread evenly */
    double along = dimension == 2 ? fmax(even, fmin(n, 3.0)) : fmax(even, fmin(n, 4.0));
    double across = dimension == 2 ? n : fmax(2.0 * even, fmin(n, 8.0));
    double push = fmax(along * k_n + (n - along) * k_t, even * k_n + (n - even) * k_t);
    return fmax(fmin(n, 3.0) * single, fmax(push, across * turn * (k_t + k_r)));
}

/* The inverse mass of a free wall against all spheres of a radius that can lie on it, densely packed: modes of pushing and of
 * turning do not add up where contacts are spread evenly. */
static double timestep_yield_of(const struct timestep_input *input, const struct timestep_yield *yield,
                                double radius) {
    double count = input->dimension == 2 ? yield->area / (2.0 * radius)
                                         : yield->area / (2.0 * sqrt(3.0) * radius * radius);
    return fmax(yield->one, count * yield->all);
}

/* The local stiffness and damper of `a` among the like of b, compared with the largest so far. */
static void timestep_surround(const struct timestep_input *input, struct timestep_side *a,
                              const struct timestep_side *b, const struct timestep_meeting *meeting) {
    const struct timestep_springs *s = &meeting->springs;
    double n = timestep_contacts(input, a, b), share = meeting->radius / a->radius,
           square = a->radius * a->radius;
    if (a->inverse_mass == 0.0)
        return;
    if (a->kind->wall) {
        double yield = timestep_yield_of(input, &a->kind->yield, b->radius);
        a->stiffness = fmax(a->stiffness, yield * fmax(s->k_n, s->k_t));
        a->damping = fmax(a->damping, yield * fmax(s->c_n, s->c_t));
        return;
    }
    const double ease = a->kind->body.ease, *seat = a->kind->body.seat;
    double stiffness =
        timestep_local(input->dimension, n, s->k_n, s->k_t, s->k_r * share * share + s->k_w / square);
    double damping =
        timestep_local(input->dimension, n, s->c_n, s->c_t, s->c_r * share * share + s->c_w / square);
    stiffness =
        a->inverse_mass * fmax(ease * stiffness, TIMESTEP_SEATS * (seat[0] * s->k_n + seat[2] * s->k_t));
    damping = a->inverse_mass * fmax(ease * damping, TIMESTEP_SEATS * (seat[1] * s->c_n + seat[2] * s->c_t));
    double stable = timestep_bound(stiffness, damping, 1.0);
    a->stiffness = fmax(a->stiffness, stiffness);
    a->damping = fmax(a->damping, damping);
    if (stable >= a->stable)
        return;
    a->stable = stable;
    a->frequency = sqrt(s->k_n / meeting->mass);
    a->damping_ratio = 0.5 * s->c_n / sqrt(s->k_n * meeting->mass);
    a->partner = b->kind->material;
}

/* The extremes of each kind's sizes decide, as stiffness and mass are monotonic in the radii. */
static int timestep_sides(const struct timestep_input *input, struct timestep_side *side) {
    int n = 0;
    for (int k = 0; k < input->kinds; k++) {
        const struct timestep_kind *kind = &input->kind[k];
        const double radius[2] = {kind->radius_min, kind->radius_max};
        int ends = kind->wall || !(kind->radius_max > kind->radius_min) ? 1 : 2;
        for (int e = 0; e < ends; e++) {
            struct timestep_side s = {.kind = kind,
                                      .radius = INFINITY,
                                      .curved = INFINITY,
                                      .inverse_mass = kind->wall ? kind->yield.one : 0.0,
                                      .stable = INFINITY};
            double relative = radius[e] / kind->radius_min;
            if (!kind->wall) {
                s.radius = radius[e];
                s.curved = radius[e] * kind->body.curved;
                s.inverse_mass = 1.0 / (kind->mass_min * relative * relative * relative);
            }
            side[n++] = s;
        }
    }
    return n;
}

/* Lowers the limits for two sides that may meet, each among its stiffest partners. */
static void timestep_consider(struct timestep_limits *limits, const struct timestep_side *a,
                              const struct timestep_side *b) {
    double stable = timestep_bound(a->stiffness + b->stiffness, a->damping + b->damping, 1.0);
    const struct timestep_side *stiff = a->stable <= b->stable ? a : b;
    if (stable >= limits->stable)
        return;
    limits->stable = stable;
    limits->frequency = stiff->frequency;
    limits->damping_ratio = stiff->damping_ratio;
    limits->material_a = stiff->kind->material < stiff->partner ? stiff->kind->material : stiff->partner;
    limits->material_b = stiff->kind->material < stiff->partner ? stiff->partner : stiff->kind->material;
}

/* Rayleigh's time pi r sqrt(density / G) / (0.1631 nu + 0.8766). */
static double timestep_rayleigh(const struct law_material *m, double radius, double mass) {
    double shear = m->young / (2.0 * (1.0 + m->poisson));
    double density = mass / (4.0 / 3.0 * M_PI * radius * radius * radius);
    return M_PI * radius * sqrt(density / shear) / (0.1631 * m->poisson + 0.8766);
}

static bool timestep_meets(const struct timestep_side *a, const struct timestep_side *b) {
    return a->inverse_mass + b->inverse_mass > 0.0 && !(a->kind->wall && b->kind->wall);
}

void timestep_limits(struct timestep_limits *limits, const struct timestep_input *input) {
    const struct law *law = input->law;
    struct timestep_side *side = memory_allocate(2 * (size_t)input->kinds, sizeof *side, "sorts of grains");
    int n = timestep_sides(input, side);
    double rayleigh = INFINITY;
    *limits = (struct timestep_limits){.stable = INFINITY, .contact_time = INFINITY};
    for (int a = 0; a < n; a++)
        for (int b = a; b < n; b++) {
            if (!timestep_meets(&side[a], &side[b]))
                continue;
            struct timestep_meeting meeting = timestep_meet(input, &side[a], &side[b]);
            timestep_surround(input, &side[a], &side[b], &meeting);
            if (a != b)
                timestep_surround(input, &side[b], &side[a], &meeting);
            int p = side[a].kind->material, q = side[b].kind->material;
            limits->contact_time =
                fmin(limits->contact_time,
                     law_duration_of(&law->options, law_pair_of(law, p, q), law_extra_of(law, p, q),
                                     meeting.mass, meeting.radius, meeting.overlap));
        }
    for (int a = 0; a < n; a++)
        for (int b = a; b < n; b++)
            if (timestep_meets(&side[a], &side[b]))
                timestep_consider(limits, &side[a], &side[b]);
    memory_free(side);
    for (int k = 0; k < input->kinds; k++)
        if (input->law->moduli && !input->kind[k].wall)
            rayleigh = fmin(rayleigh, timestep_rayleigh(&input->material[input->kind[k].material],
                                                        input->kind[k].radius_min, input->kind[k].mass_min));
    limits->rayleigh = isfinite(rayleigh) ? rayleigh : 0.0;
}
