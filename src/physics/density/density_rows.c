/* SPDX-License-Identifier: BSD-3-Clause */
/* The rows that number density adds to tables: its section of a scene, its field, its observables. */
#include "physics/density/density.h"
#include "data/observe/observables_kinds.h"
#include "kernel/particles/fields.h"
#include "physics_table.h"
#include "data/scene/schema_rows.h"
#include <math.h>

/* clang-format off */
static const struct schema_row section[] = {
    {.key = "support", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", .required = true, .example = "3 mm",
     .offset = offsetof(struct density_options, support), .size = sizeof(double),
     .help = "distance from which on the kernel, Wendland's C2, is zero"}};
const struct schema_table density_schema = {section, 1};

static const struct field number_density = {
    .name = "number_density", .type = FIELD_DOUBLE, .components = 1, .use = FIELD_OUTPUT, .unit = "m-3",
    .needed_for = "number_density", .help = "sum of the kernel over all particles within its support"};
/* clang-format on */

void density_fields(struct particles *particles) {
    fields_register(particles, &number_density);
}

static bool known(const struct output_view *view) {
    return fields_values(view->particles, &number_density) != NULL;
}

static void add(const struct output_view *view, const struct observable_item *item, size_t i, double *part) {
    const double *value = fields_values(view->particles, &number_density);
    (void)item;
    part[0] += value ? value[i] : 0.0;
    part[1] += 1.0;
}

static void take_least(const struct observable_context *context, struct observable_item *item, double *part) {
    const double *value = fields_values(context->view->particles, &number_density);
    (void)item;
    for (size_t i = 0; value && i < context->view->particles->owned; i++)
        part[1] = fmax(part[1], 1.0 / value[i]);
    part[0] = 1.0;
}

static void take_most(const struct observable_context *context, struct observable_item *item, double *part) {
    const double *value = fields_values(context->view->particles, &number_density);
    (void)item;
    for (size_t i = 0; value && i < context->view->particles->owned; i++)
        part[0] = fmax(part[0], value[i]);
    part[1] = part[0] > 0.0;
}

static void divide(const struct output_view *view, const struct observable_item *item, double *part) {
    (void)view, (void)item;
    part[0] = part[1] > 0.0 ? part[0] / part[1] : NAN;
}

#define INFO(word, text)                                                                                     \
    .info = {"number_density_" word, "number_density", "1/m3", text, OBSERVABLE_OF_ALL, 1, "1/m2"},          \
    .parts = 2, .relevant = known, .finish = divide
static const struct observable_kind kinds[] = {
    {INFO("min", "least number density"), .combine = OBSERVABLE_MAX, .of_rank = take_least},
    {INFO("mean", "mean number density"), .of_particle = add, .of_all_kinds = true},
    {INFO("max", "largest number density"), .combine = OBSERVABLE_MAX, .of_rank = take_most}};
const struct observable_table density_observables = {kinds, 3};
