#include "contact/law.h"
#include <float.h>
#include <math.h>
#include <string.h>

struct law_options law_options_default(void) {
    return (struct law_options){.normal = LAW_HERTZ,
                                .damping = LAW_DAMPING_RESTITUTION,
                                .end = LAW_END_FORCE,
                                .tangential = LAW_TANGENTIAL_HISTORY,
                                .rolling = LAW_ROLLING_NONE,
                                .tangential_damping_ratio = 1.0,
                                .synchronised = true};
}

/* Restitution of a linear spring-dashpot that ends at zero force (Schwager and Poeschel 2007, their three
 * cases written as one with acos and acosh). */
static double law_restitution_end_force(double zeta) {
    if (zeta < 1.0)
        return exp(-2.0 * zeta * acos(zeta) / sqrt(1.0 - zeta * zeta));
    if (zeta > 1.0)
        return exp(-2.0 * zeta * acosh(zeta) / sqrt(zeta * zeta - 1.0));
    return exp(-2.0);
}

double law_hooke_damping_ratio(double restitution, enum law_end end) {
    if (end == LAW_END_OVERLAP) {
        double logarithm = log(restitution);
        return restitution > 0.0 ? -logarithm / hypot(M_PI, logarithm) : 1.0;
    }
    double target = fmax(restitution, LAW_RESTITUTION_LEAST);
    double low = 0.0, high = 100.0;
    while (high - low > 4.0 * DBL_EPSILON * high) {
        double middle = 0.5 * (low + high);
        if (law_restitution_end_force(middle) > target)
            low = middle;
        else
            high = middle;
    }
    return restitution >= 1.0 ? 0.0 : 0.5 * (low + high);
}

double law_end_friction(double restitution, enum law_end end) {
    if (end == LAW_END_FORCE)
        return 0.0;
    double left = law_restitution_end_force(law_hooke_damping_ratio(restitution, LAW_END_OVERLAP));
    return 2.0 * (left - restitution) / (1.0 + restitution);
}

double law_hertz_alpha(double restitution, enum law_end end) {
    return sqrt(5.0) * law_hooke_damping_ratio(restitution, end);
}

/* Refuses options that do not go together. */
static bool law_check_options(const struct law_options *o, int materials, struct error *error) {
    if (materials < 1 || materials > LAW_MATERIALS_MAX)
        return error_set(error, ERROR_USER, "materials: %d given; allowed are 1 to %d", materials,
                         LAW_MATERIALS_MAX);
    if (o->normal == LAW_HERTZ && o->damping == LAW_DAMPING_COEFFICIENT)
        return error_set(error, ERROR_USER,
                         "contact: damping by coefficients goes with hooke only; hertz takes a restitution");
    if (o->normal == LAW_HERTZ && o->lammps_hooke)
        return error_set(error, ERROR_USER, "contact: lammps_hooke goes with hooke only");
    if (o->lammps_hooke && o->synchronised)
        return error_set(error, ERROR_USER,
                         "contact: lammps_hooke goes with the integrator velocity_verlet only");
    if (o->tangential == LAW_FRICTIONLESS && o->rolling != LAW_ROLLING_NONE)
        return error_set(error, ERROR_USER,
                         "contact: rolling resistance needs a tangential spring with history");
    if (!(o->tangential_damping_ratio >= 0.0) || isinf(o->tangential_damping_ratio))
        return error_set(error, ERROR_USER, "contact: tangential_damping_ratio is %g; allowed is 0 or more",
                         o->tangential_damping_ratio);
    return true;
}

/* A finite value of at least `least`, and above it if `open`. */
static bool law_within(double value, double least, bool open) {
    return isfinite(value) && (open ? value > least : value >= least);
}

static bool law_check_material(const struct law_material *m, const struct law_options *o,
                               struct error *error) {
    if (!law_within(m->density, 0.0, true))
        return error_set(error, ERROR_USER, "material %s: density is %g; allowed is more than 0", m->name,
                         m->density);
    if (o->normal != LAW_HERTZ)
        return true;
    if (!law_within(m->young, 0.0, true))
        return error_set(error, ERROR_USER, "material %s: young is %g; allowed is more than 0", m->name,
                         m->young);
    if (!(m->poisson > -1.0 && m->poisson <= 0.5))
        return error_set(error, ERROR_USER, "material %s: poisson is %g; allowed is above -1 up to 0.5",
                         m->name, m->poisson);
    return true;
}

/* Refuses coefficients of a pair that are out of range; each key only where the options use it. */
static bool law_check_pair(const struct law_pair *p, const struct law_options *o, const char *a,
                           const char *b, struct error *error) {
    bool hooke = o->normal == LAW_HOOKE, friction = o->tangential != LAW_FRICTIONLESS;
    bool given = o->damping == LAW_DAMPING_COEFFICIENT, rolling = o->rolling != LAW_ROLLING_NONE;
    const struct {
        const char *key;
        double value;
        bool used, open;
    } rows[] = {{"k_n", p->k_n, hooke, true},
                {"k_t", p->k_t, hooke && friction, true},
                {"gamma_n", p->gamma_n, given, false},
                {"gamma_t", p->gamma_t, given && friction, false},
                {"friction", p->friction, friction, false},
                {"rolling_friction", p->rolling_friction, rolling, false}};
    for (size_t r = 0; r < sizeof rows / sizeof rows[0]; r++)
        if (rows[r].used && !law_within(rows[r].value, 0.0, rows[r].open))
            return error_set(error, ERROR_USER, "material pair %s, %s: %s is %g; allowed is %s", a, b,
                             rows[r].key, rows[r].value, rows[r].open ? "more than 0" : "0 or more");
    if (!given && !(p->restitution >= 0.0 && p->restitution <= 1.0))
        return error_set(error, ERROR_USER, "material pair %s, %s: restitution is %g; allowed is 0 to 1", a,
                         b, p->restitution);
    return true;
}

/* E* and G* of two materials: 1/E* = sum (1 - nu^2)/E, 1/G* = sum (2 - nu)/G with G = E/(2 (1 + nu)). */
static double law_young_effective(const struct law_material *a, const struct law_material *b) {
    return 1.0 / ((1.0 - a->poisson * a->poisson) / a->young + (1.0 - b->poisson * b->poisson) / b->young);
}

static double law_shear_effective(const struct law_material *a, const struct law_material *b) {
    return 1.0 / ((2.0 - a->poisson) * 2.0 * (1.0 + a->poisson) / a->young +
                  (2.0 - b->poisson) * 2.0 * (1.0 + b->poisson) / b->young);
}

static struct law_coefficients law_combine(const struct law_options *o, const struct law_material *a,
                                           const struct law_material *b, const struct law_pair *p) {
    bool hertz = o->normal == LAW_HERTZ, friction = o->tangential != LAW_FRICTIONLESS;
    struct law_coefficients c = {.friction = friction ? p->friction : 0.0,
                                 .rolling_friction = o->rolling ? p->rolling_friction : 0.0};
    c.k_n = hertz ? 4.0 / 3.0 * law_young_effective(a, b) : p->k_n;
    if (friction)
        c.k_t = hertz ? 8.0 * law_shear_effective(a, b) : p->k_t;
    if (o->damping == LAW_DAMPING_COEFFICIENT) {
        c.c_n = p->gamma_n;
        c.c_t = p->gamma_t;
    } else {
        double tangent = hertz ? 1.5 * c.k_n : c.k_n;
        c.c_n = hertz ? law_hertz_alpha(p->restitution, o->end)
                      : 2.0 * law_hooke_damping_ratio(p->restitution, o->end);
        c.c_t = o->tangential_damping_ratio * c.c_n * sqrt(c.k_t / tangent);
    }
    if (o->tangential_damping_equal)
        c.c_t = c.c_n;
    if (!friction)
        c.c_t = 0.0;
    return c;
}

bool law_prepare(struct law *law, const struct law_options *options, int materials,
                 const struct law_material *material,
                 struct law_pair pair[LAW_MATERIALS_MAX][LAW_MATERIALS_MAX], struct error *error) {
    memset(law, 0, sizeof *law);
    if (!law_check_options(options, materials, error))
        return false;
    for (int a = 0; a < materials; a++)
        if (!law_check_material(&material[a], options, error))
            return false;
    for (int a = 0; a < materials; a++)
        for (int b = a; b < materials; b++) {
            if (!law_check_pair(&pair[a][b], options, material[a].name, material[b].name, error))
                return false;
            law->pair[a][b] = law_combine(options, &material[a], &material[b], &pair[a][b]);
            law->pair[b][a] = law->pair[a][b];
        }
    law->options = *options;
    law->materials = materials;
    law->uniform = true;
    for (int a = 0; a < materials; a++)
        for (int b = 0; b < materials; b++)
            law->uniform =
                law->uniform && memcmp(&law->pair[a][b], &law->pair[0][0], sizeof law->pair[a][b]) == 0;
    law->spin = options->tangential != LAW_FRICTIONLESS;
    law->history_components = !law->spin ? 0 : options->rolling != LAW_ROLLING_NONE ? 6 : 3;
    return true;
}
