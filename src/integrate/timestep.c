#include "integrate/timestep.h"
#include <math.h>

enum { TIMESTEP_CONTACTS = 4 };

static const double timestep_overlap_relative = 1e-3;

/* A pair of sizes that may meet. */
struct timestep_meeting {
    double inverse_mass; /* 1/m* */
    double radius;       /* R* */
    double radius_min;   /* the smaller one */
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

static struct timestep_meeting timestep_meet(const struct timestep_kind *a, double radius_a,
                                             const struct timestep_kind *b, double radius_b) {
    struct timestep_meeting meeting = {0.0, 0.0, INFINITY};
    const struct timestep_kind *kind[2] = {a, b};
    const double radius[2] = {radius_a, radius_b};
    double curvature = 0.0;
    for (int side = 0; side < 2; side++) {
        if (kind[side]->wall)
            continue;
        double relative = radius[side] / kind[side]->radius_min;
        meeting.inverse_mass += 1.0 / (kind[side]->mass_min * relative * relative * relative);
        curvature += 1.0 / radius[side];
        meeting.radius_min = fmin(meeting.radius_min, radius[side]);
    }
    meeting.radius = 1.0 / curvature;
    return meeting;
}

/* Limits of one contact, compared with what was found so far. */
static void timestep_consider(struct timestep_limits *limits, const struct timestep_input *input, int a,
                              int b, const struct timestep_meeting *meeting) {
    const struct law_options *options = &input->law->options;
    const struct law_coefficients *c = &input->law->pair[a][b];
    double mass = 1.0 / meeting->inverse_mass, scale = 1.0, tangent = c->k_n, duration;
    if (options->normal == LAW_HERTZ) {
        double least = input->overlap_relative > 0.0 ? input->overlap_relative : timestep_overlap_relative;
        double stiffness = c->k_n * sqrt(meeting->radius); /* F = this x overlap^(3/2) */
        double reached = pow(1.25 * mass * input->speed_max * input->speed_max / stiffness, 0.4);
        double overlap = fmax(reached, least * meeting->radius_min);
        scale = sqrt(meeting->radius * overlap);
        tangent = 1.5 * c->k_n * scale;
        duration = 2.94328 * overlap / sqrt(0.8 * stiffness * pow(overlap, 2.5) / mass);
    } else {
        duration = M_PI * sqrt(mass / c->k_n);
    }
    double base = options->damping == LAW_DAMPING_COEFFICIENT ? mass : sqrt(mass * c->k_n * scale);
    double many = input->contacts > 0 ? input->contacts : TIMESTEP_CONTACTS;
    double stable = timestep_bound(tangent, c->c_n * base, many * meeting->inverse_mass);
    if (input->law->spin) {
        double turning = options->rolling != LAW_ROLLING_NONE ? 6.0 : 3.5;
        stable = fmin(stable,
                      timestep_bound(c->k_t * scale, c->c_t * base, turning * many * meeting->inverse_mass));
    }
    limits->contact_time = fmin(limits->contact_time, duration);
    if (stable >= limits->stable)
        return;
    limits->stable = stable;
    limits->frequency = sqrt(tangent / mass);
    limits->damping_ratio = 0.5 * c->c_n * base / sqrt(tangent * mass);
    limits->material_a = a;
    limits->material_b = b;
}

/* All sizes of two kinds: the extremes decide, as stiffness and mass are monotonic in the radii. */
static void timestep_consider_kinds(struct timestep_limits *limits, const struct timestep_input *input,
                                    const struct timestep_kind *a, const struct timestep_kind *b) {
    if (a->wall && b->wall)
        return;
    const double radius_a[2] = {a->radius_min, a->radius_max}, radius_b[2] = {b->radius_min, b->radius_max};
    for (int p = 0; p < 2; p++)
        for (int q = 0; q < 2; q++) {
            struct timestep_meeting meeting = timestep_meet(a, radius_a[p], b, radius_b[q]);
            timestep_consider(limits, input, a->material, b->material, &meeting);
        }
}

/* Rayleigh's time pi r sqrt(density / G) / (0.1631 nu + 0.8766). */
static double timestep_rayleigh(const struct law_material *m, double radius) {
    double shear = m->young / (2.0 * (1.0 + m->poisson));
    return M_PI * radius * sqrt(m->density / shear) / (0.1631 * m->poisson + 0.8766);
}

void timestep_limits(struct timestep_limits *limits, const struct timestep_input *input) {
    *limits = (struct timestep_limits){.stable = INFINITY, .contact_time = INFINITY};
    bool hertz = input->law->options.normal == LAW_HERTZ;
    double rayleigh = INFINITY;
    for (int k = 0; k < input->kinds; k++) {
        const struct timestep_kind *a = &input->kind[k];
        for (int l = k; l < input->kinds; l++)
            timestep_consider_kinds(limits, input, a, &input->kind[l]);
        if (hertz && !a->wall)
            rayleigh = fmin(rayleigh, timestep_rayleigh(&input->material[a->material], a->radius_min));
    }
    limits->rayleigh = isfinite(rayleigh) ? rayleigh : 0.0;
}
