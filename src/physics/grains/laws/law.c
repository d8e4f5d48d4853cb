/* SPDX-License-Identifier: BSD-3-Clause */
/* From a scene's options and materials to the coefficients of each pair of materials. */
#include "physics/grains/laws/law.h"
#include "base/memory.h"
#include <math.h>
#include <string.h>

struct law_options law_options_default(void) {
    return (struct law_options){.normal = LAW_NORMAL_DEFAULT,
                                .damping = LAW_DAMPING_DEFAULT,
                                .end = LAW_END_FORCE,
                                .tangential = LAW_TANGENTIAL_HISTORY,
                                .rolling = LAW_ROLLING_NONE,
                                .tangential_damping_ratio = 1.0,
                                .synchronised = true};
}

/* Refuses options that do not go together. */
static bool law_check_options(const struct law_options *o, int materials, struct error *error) {
    if (materials < 0 || materials > LAW_MATERIALS_MAX)
        return error_set(error, ERROR_USER, "materials: %d given; allowed are up to %d", materials,
                         LAW_MATERIALS_MAX);
    if (o->lammps_history && o->synchronised)
        return error_set(error, ERROR_USER,
                         "contact: lammps_history goes with the integrator velocity_verlet only");
    if (o->tangential == LAW_FRICTIONLESS && o->rolling != LAW_ROLLING_NONE)
        return error_set(error, ERROR_USER,
                         "contact: rolling resistance needs a tangential spring with history");
    if (!(o->tangential_damping_ratio >= 0.0) || isinf(o->tangential_damping_ratio))
        return error_set(error, ERROR_USER, "contact: tangential_damping_ratio is %g; allowed is 0 or more",
                         o->tangential_damping_ratio);
    return law_check_parts(o, error);
}

/* A finite value of at least `least`, and above it if `open`. */
static bool law_within(double value, double least, bool open) {
    return isfinite(value) && (open ? value > least : value >= least);
}

/* Springs come from young and poisson of the materials, not from k_n and k_t of the pair. */
static bool law_has_moduli(const struct law_options *o) {
    return law_form_of(o)->moduli && !law_damping_form_of(o->damping)->given;
}

static bool law_check_material(const struct law_material *m, const struct law_options *o,
                               struct error *error) {
    if (!law_within(m->density, 0.0, true))
        return error_set(error, ERROR_USER, "material %s: density is %g; allowed is more than 0", m->name,
                         m->density);
    if (!law_has_moduli(o))
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
    bool springs = !law_has_moduli(o) && !law_has_trait(o->normal, "stiff"),
         friction = o->tangential != LAW_FRICTIONLESS;
    bool given = law_damping_form_of(o->damping)->given, rolling = o->rolling != LAW_ROLLING_NONE;
    const struct {
        const char *key;
        double value;
        bool used, open;
    } rows[] = {{"k_n", p->k_n, springs, true},
                {"k_t", p->k_t, springs && friction, true},
                {"gamma_n", p->gamma_n, given, false},
                {"gamma_t", p->gamma_t, given && friction, false},
                {"friction", p->friction, friction, false},
                {"rolling_friction", p->rolling_friction, rolling, false}};
    bool asked = law_damping_form_of(o->damping)->restitution;
    for (size_t r = 0; r < sizeof rows / sizeof rows[0]; r++)
        if (rows[r].used && !law_within(rows[r].value, 0.0, rows[r].open))
            return error_set(error, ERROR_USER, "material pair %s, %s: %s is %g; allowed is %s", a, b,
                             rows[r].key, rows[r].value, rows[r].open ? "more than 0" : "0 or more");
    if (asked && !(p->restitution >= 0.0 && p->restitution <= 1.0))
        return error_set(error, ERROR_USER, "material pair %s, %s: restitution is %g; allowed is 0 to 1", a,
                         b, p->restitution);
    if (law_has_trait(o->normal, "hysteresis") && !(p->extra.k_2 > p->k_n))
        return error_set(error, ERROR_USER, "material pair %s, %s: k_2 is %g; allowed is more than k_n, %g",
                         a, b, p->extra.k_2, p->k_n);
    return law_check_extra(&p->extra, o, (const char *[]){a, b}, error);
}

/* Fills the dampers' coefficients, whose springs are there. */
static void law_damp(const struct law_options *o, const struct law_pair *p, struct law_coefficients *c) {
    const struct law_form *form = law_form_of(o);
    const struct law_damped in = {.restitution = p->restitution,
                                  .gamma_n = p->gamma_n,
                                  .gamma_t = p->gamma_t,
                                  .end = o->end,
                                  .damper = form->damper,
                                  .tangent = form->tangent,
                                  .tangential = o->tangential_damping_ratio,
                                  .ratio = c->k_t / (form->tangent * c->k_n)};
#define CASE(NAME, name, with, summary)                                                                      \
    if (o->damping == LAW_DAMPING_##NAME) {                                                                  \
        c->c_n = damping_##name##_normal(&p->extra.damping_##name, &in);                                     \
        c->c_t = damping_##name##_tangential(&in, c->c_n);                                                   \
    }
    LAW_DAMPING_TABLE(CASE)
#undef CASE
}

static struct law_coefficients law_combine(const struct law_options *o, const struct law_material *a,
                                           const struct law_material *b, const struct law_pair *p) {
    const struct law_form *form = law_form_of(o);
    bool friction = o->tangential != LAW_FRICTIONLESS;
    struct law_coefficients c = {.friction = friction ? p->friction : 0.0,
                                 .rolling_friction = o->rolling ? p->rolling_friction : 0.0};
    if (law_has_trait(o->normal, "stiff"))
        return c;
    c.k_n = p->k_n;
    c.k_t = p->k_t;
    if (law_has_moduli(o))
        form->moduli(a, b, &c);
    if (!friction)
        c.k_t = 0.0;
    law_damp(o, p, &c);
    if (o->tangential_damping_equal)
        c.c_t = c.c_n;
    if (!friction)
        c.c_t = 0.0;
    return c;
}

/* True if contacts need the general loop. */
static bool law_has_parts(const struct law *law) {
    const struct law_options *o = &law->options;
    bool general = law_form_of(o)->unload || o->cohesion != LAW_COHESION_NONE ||
                   o->tangential > LAW_TANGENTIAL_HISTORY || o->twisting != LAW_TWISTING_NONE ||
                   law_damping_form_of(o->damping)->general || o->lammps_granular;
    for (int a = 0; a < law->materials; a++)
        for (int b = 0; b <= a; b++) {
            const struct law_extra *x = law_extra_of(law, a, b);
            general = general || (law->spin && x->static_friction > law_pair_of(law, a, b)->friction) ||
                      law_rolling_general(o->rolling, x);
        }
    return general;
}

/* Gives `count` doubles of the history a place, if wanted. */
static int law_place(int *next, bool wanted, int count) {
    int place = *next;
    *next += wanted ? count : 0;
    return wanted ? place : -1;
}

/* Lays out the history of a contact: vectors first. */
static void law_lay_out(struct law *law) {
    const struct law_options *o = &law->options;
    const struct law_form *form = law_form_of(o);
    bool general = law->general, apart = false;
    int next = 0;
    for (int a = 0; a < law->materials; a++)
        for (int b = 0; b <= a; b++)
            apart = apart || law_extra_of(law, a, b)->static_friction > law_pair_of(law, a, b)->friction;
    law->memory.spring =
        law_place(&next, law->spin && !o->solved && o->tangential != LAW_TANGENTIAL_VISCOUS, 3);
    law->memory.roll =
        law_place(&next, law->spin && !o->solved && law_rolling_form_of(o->rolling)->spring, 3);
    law->history_odd = next;
    law->memory.twist = law_place(&next, !o->solved && o->twisting != LAW_TWISTING_NONE, 1);
    law->memory.held =
        law_place(&next, general && !o->solved && law_cohesion_form_of(o->cohesion)->remembers, 1);
    law->memory.radius = law_place(
        &next, o->tangential == LAW_TANGENTIAL_RESCALE || o->tangential == LAW_TANGENTIAL_RESCALE_FORCE, 1);
    law->memory.slides = law_place(&next, general && law->spin && apart && law->memory.spring >= 0, 1);
    law->memory.past = law_place(&next, form->remembers > 0, form->remembers);
    law->history_components = next;
}

/* Fills the entries of the materials a and b. */
static void law_fill(struct law *law, const struct law_material *material, const struct law_pair *pair, int a,
                     int b) {
    size_t there = law_place_of(law->materials, a, b), back = law_place_of(law->materials, b, a);
    law->pair[there] = law->pair[back] = law_combine(&law->options, &material[a], &material[b], pair);
    law->extra[there] = law->extra[back] = pair->extra;
    law->sticky[there] = law->sticky[back] =
        law_sticky_of(law->options.cohesion, &law->pair[there], &pair->extra);
    law_sticky_widen(law->options.cohesion, &law->widest, &law->sticky[there]);
}

static bool law_is_uniform(const struct law *law) {
    bool uniform = true;
    for (size_t k = 1; k < (size_t)law->materials * (size_t)law->materials; k++)
        uniform = uniform && memcmp(&law->pair[k], law->pair, sizeof *law->pair) == 0 &&
                  memcmp(&law->extra[k], law->extra, sizeof *law->extra) == 0;
    return uniform;
}

bool law_prepare(struct law *law, const struct law_options *options, int materials,
                 const struct law_material *material, const struct law_pair *pair, struct error *error) {
    memset(law, 0, sizeof *law);
    if (!law_check_options(options, materials, error))
        return false;
    for (int a = 0; a < materials; a++)
        if (!law_check_material(&material[a], options, error))
            return false;
    for (int a = 0; a < materials; a++)
        for (int b = a; b < materials; b++)
            if (!law_check_pair(&pair[law_place_of(materials, a, b)], options, material[a].name,
                                material[b].name, error))
                return false;
    size_t entries = materials > 0 ? (size_t)materials * (size_t)materials : 1;
    law->options = *options;
    law->materials = materials;
    law->pair = memory_allocate_zero(entries, sizeof *law->pair, "coefficients of contacts");
    law->extra = memory_allocate_zero(entries, sizeof *law->extra, "coefficients of contacts");
    law->sticky = memory_allocate_zero(entries, sizeof *law->sticky, "coefficients of contacts");
    if (materials == 0)
        return true;
    for (int a = 0; a < materials; a++)
        for (int b = a; b < materials; b++)
            law_fill(law, material, &pair[law_place_of(materials, a, b)], a, b);
    law->moduli = law_has_moduli(options);
    law->uniform = law_is_uniform(law);
    law->spin = options->tangential != LAW_FRICTIONLESS;
    law->general = law_has_parts(law);
    law_lay_out(law);
    return true;
}

void law_free(struct law *law) {
    memory_free(law->pair);
    memory_free(law->extra);
    memory_free(law->sticky);
    *law = (struct law){0};
}
