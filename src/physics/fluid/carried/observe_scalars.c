/* SPDX-License-Identifier: BSD-3-Clause */
/* Observables of scalars and of an electrolyte. Read observe_flow.h and scalars.h first. */
#include "physics/fluid/carried/electrolyte_fields.h"
#include "physics/fluid/carried/scalars.h"
#include "physics/fluid/carried/scalars_fields.h"
#include "physics/fluid/coupling/rigid_fields.h"
#include "physics/fluid/observe_flow.h"
#include <math.h>

/* The number of the scalar of a row, from its name. */
static int number_of(const struct observable_item *item) {
    return observables_kind(item->kind)->info.name[7] - '1';
}

/* The values of the item's scalar by particle number; NULL where the run has none. */
static const double *value_of(const struct observable_context *context, const struct observable_item *item) {
    return context->view->own[PHYSICS_fluid] != NULL
               ? scalars_value(context->view->particles, number_of(item))
               : NULL;
}

bool observe_scalar_1(const struct output_view *view) {
    return scalars_value(view->particles, 0) != NULL;
}

bool observe_scalar_2(const struct output_view *view) {
    return scalars_value(view->particles, 1) != NULL;
}

bool observe_scalar_3(const struct output_view *view) {
    return scalars_value(view->particles, 2) != NULL;
}

void observe_scalar_mean(const struct observable_context *context, struct observable_item *item,
                         double *part) {
    const struct fluid *fluid = context->view->own[PHYSICS_fluid];
    const double *value = value_of(context, item);
    for (size_t row = 0; value != NULL && row < fluid->weights.rows; row++) {
        size_t i = fluid->weights.first + row;
        if (!observables_item_counts(context->view, item, i))
            continue;
        double volume = fluid->weights.volume[row] * rigid_fields_free(context->view->particles, i);
        part[0] += volume * value[i];
        part[1] += volume;
    }
}

void observe_scalar_mean_finish(const struct output_view *view, const struct observable_item *item,
                                double *part) {
    (void)view, (void)item;
    part[0] = part[1] > 0 ? part[0] / part[1] : NAN;
}

/* The length of the box along d, or of the item's region, if that is a box, within it. */
static double length_along(const struct output_view *view, const struct observable_item *item, int d) {
    const struct box *box = view->box;
    double lower = box->origin[d], upper = box->origin[d] + box->edge[d];
    if (d >= box->dimension)
        return 1;
    if (item->region != NULL && item->region->shape == OUTPUT_REGION_BOX) {
        lower = fmax(lower, item->region->lower[d]);
        upper = fmin(upper, item->region->upper[d]);
    }
    return upper - lower;
}

void observe_scalar_flux(const struct observable_context *context, struct observable_item *item,
                         double *part) {
    const struct fluid *fluid = context->view->own[PHYSICS_fluid];
    const double(*flux)[3] =
        value_of(context, item) != NULL ? scalars_flux(fluid->scalars, number_of(item)) : NULL;
    for (size_t row = 0; flux != NULL && row < fluid->weights.rows; row++)
        for (int d = 0; observables_item_counts(context->view, item, fluid->weights.first + row) && d < 3;
             d++)
            part[d] += fluid->weights.volume[row] * flux[row][d] / length_along(context->view, item, d);
}

/* The parts: the flow, and what it carries. */
void observe_scalar_carried(const struct observable_context *context, struct observable_item *item,
                            double *part) {
    const struct fluid *fluid = context->view->own[PHYSICS_fluid];
    const double *value = value_of(context, item);
    for (size_t row = 0; value != NULL && row < fluid->weights.rows; row++) {
        size_t i = fluid->weights.first + row;
        const double *u = context->view->particles->state[i].v,
                     volume = fluid->weights.volume[row] * rigid_fields_free(context->view->particles, i);
        for (int d = 0; observables_item_counts(context->view, item, i) && d < 3; d++) {
            part[d] += volume * u[d];
            part[3 + d] += volume * u[d] * value[i];
        }
    }
}

void observe_scalar_carried_finish(const struct output_view *view, const struct observable_item *item,
                                   double *part) {
    double flow = 0, carried = 0;
    (void)view, (void)item;
    for (int d = 0; d < 3; d++) {
        flow += part[d] * part[d];
        carried += part[d] * part[3 + d];
    }
    part[0] = flow > 0 ? carried / flow : NAN;
}

bool observe_charged(const struct output_view *view) {
    return electrolyte_charge(view->particles) != NULL;
}

void observe_charge(const struct observable_context *context, struct observable_item *item, double *part) {
    const struct fluid *fluid = context->view->own[PHYSICS_fluid];
    const double *charge = electrolyte_charge(context->view->particles);
    (void)item;
    for (size_t row = 0; fluid != NULL && charge != NULL && row < fluid->weights.rows; row++)
        part[0] += fluid->weights.volume[row] * charge[fluid->weights.first + row];
}
