/* SPDX-License-Identifier: BSD-3-Clause */
/* The rows that hard contacts add to tables: their section of a scene, their field, their observables. */
#include "physics/hard/hard_state.h"
#include "data/observe/observables_kinds.h"
#include "kernel/particles/fields.h"
#include "physics_table.h"
#include "data/scene/schema_rows.h"

/* clang-format off */
static const struct schema_name method_names[] = {
    {"gauss_seidel", HARD_GAUSS_SEIDEL, "sweeps over contacts that begin with the forces of the step before"},
    {"newton", HARD_NEWTON, "Newton's method from those sweeps, for steps whose residual they do not bring below the tolerance"},
    {0}};
#define MODEL_NAME(NAME, name, closed, summary) {#name, HARD_MODEL_##NAME, summary},
static const struct schema_name model_names[] = {HARD_MODEL_TABLE(MODEL_NAME) {0}};
#undef MODEL_NAME
static const struct schema_name restitution_names[] = {
    {"pass", HARD_RESTITUTION_PASS, "sweeps over the impacts alone, behind those over all contacts"},
    {"poisson", HARD_RESTITUTION_POISSON, "Poisson's: the impulse of an impact grows by the part e, and all contacts are solved again: twice the sweeps, and no energy where they converge"},
    {0}};
static const struct schema_row section[] = {
    {.key = "name", .type = SCHEMA_NAME, .names = method_names, .fallback = "gauss_seidel",
     .offset = offsetof(struct hard_options, method), .size = sizeof(int), .help = "method of the solver"},
    {.key = "model", .type = SCHEMA_NAME, .names = model_names, .fallback = "coulomb", .when = "/contact.law:stiff",
     .offset = offsetof(struct hard_options, model), .size = sizeof(int), .help = "what a contact answers: for comparisons, and for bodies; spheres have one answer in all but frictionless and projection"},
    {.key = "restitution", .type = SCHEMA_NAME, .names = restitution_names, .fallback = "pass", .when = "/contact.law:stiff",
     .offset = offsetof(struct hard_options, restitution), .size = sizeof(int), .help = "how impacts rebound"},
    {.key = "sweeps", .type = SCHEMA_INT, .range = "[1, 1000000]", .fallback = "30",
     .offset = offsetof(struct hard_options, sweeps), .size = sizeof(int),
     .help = "largest number of sweeps a step: 10 in flows, 30 at rest"},
    {.key = "steps", .type = SCHEMA_INT, .range = "[1, 1000]", .fallback = "40", .when = "name=newton",
     .offset = offsetof(struct hard_options, steps), .size = sizeof(int),
     .help = "largest number of Newton's steps a step"},
    {.key = "tolerance", .type = SCHEMA_REAL, .range = "[0, 1)", .fallback = "1e-4",
     .offset = offsetof(struct hard_options, tolerance), .size = sizeof(double),
     .help = "residual at which a step is done, looked at every five sweeps; 0: all sweeps. The report counts the steps that do not reach it"},
    {.key = "kappa", .type = SCHEMA_REAL, .range = "(0, inf]", .fallback = "39.478417604357434", .when = "/contact.law:stiff",
     .offset = offsetof(struct hard_options, kappa), .size = sizeof(double),
     .help = "stiffness of a contact x step^2 / mass: 4 pi^2 is a spring whose period is one step; .inf: rigid rows, for tests. More needs as many more sweeps"},
    {.key = "repair", .type = SCHEMA_REAL, .range = "(0, inf]", .fallback = "0.002", .when = "/contact.law:stiff",
     .offset = offsetof(struct hard_options, repair), .size = sizeof(double),
     .help = "largest part of the smaller radius by which a step releases an overlap, with a hundredth of what is above"}};
const struct schema_table hard_schema = {section, sizeof section / sizeof section[0]};

static const struct field velocity = {
    .name = "contact_velocity", .type = FIELD_DOUBLE, .components = 6, .needed_for = "contact.solver",
    .help = "velocity and spin that a solver of contacts sends to copies"};
/* clang-format on */

void hard_fields(struct particles *particles) {
    fields_register(particles, &velocity);
}

static const struct hard *hard_of(const struct output_view *view) {
    return view->own[PHYSICS_hard];
}

static bool known(const struct output_view *view) {
    return hard_of(view) != NULL;
}

/* All ranks have the same numbers. */
static void sweeps(const struct observable_context *context, struct observable_item *item, double *part) {
    (void)item;
    part[0] = known(context->view) ? hard_of(context->view)->last.sweeps : 0.0;
}

static void newton(const struct observable_context *context, struct observable_item *item, double *part) {
    (void)item;
    part[0] = known(context->view) ? hard_of(context->view)->last.steps : 0.0;
}

static void residual(const struct observable_context *context, struct observable_item *item, double *part) {
    (void)item;
    part[0] = known(context->view) ? hard_of(context->view)->last.residual : 0.0;
}

#define INFO(name, text)                                                                                     \
    .info = {name, "contact_solver", "1", text, OBSERVABLE_OF_ALL, 1, "1"}, .parts = 1, .relevant = known,   \
    .combine = OBSERVABLE_MAX
static const struct observable_kind kinds[] = {
    {INFO("contact_sweeps", "sweeps of the solver of contacts in the last step"), .of_rank = sweeps},
    {INFO("contact_newton", "steps of Newton's method of the solver of contacts in the last step"),
     .of_rank = newton},
    {INFO("contact_residual", "residual of the solver of contacts after the last step"),
     .of_rank = residual}};
const struct observable_table hard_observables = {kinds, sizeof kinds / sizeof kinds[0]};
