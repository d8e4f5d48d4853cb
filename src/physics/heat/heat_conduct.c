/* SPDX-License-Identifier: BSD-3-Clause */
/* Heat between two bodies: through their contact and through gas, for one pair and for batches. Read heat.h first. */
#include "kernel/particles/material.h"
#include "physics/grains/grains.h"
#include "physics/grains/laws/law_grip.h"
#include "physics/heat/heat_state.h"
#include <math.h>

double heat_contact_radius(const struct heat *heat, const int material[2], const double radius[2],
                           double effective, double gap, const double *record) {
    const struct law *law = grains_contact(heat->context)->law;
    struct law_surfaces surfaces = {law_pair_of(law, material[0], material[1]),
                                    law_extra_of(law, material[0], material[1]),
                                    {radius[0], radius[1]},
                                    effective};
    return law_grip_radius(law, &surfaces, -gap, record);
}

double heat_through_contact(const struct heat *heat, const int material[2], double a) {
    double one = heat->conductivity[material[0]], other = heat->conductivity[material[1]];
    return 4.0 * one * other / (one + other) * heat->narrow * a;
}

double heat_through_gas(const struct heat *heat, double effective, double gap) {
    const struct heat_gas *gas = &heat->options->gas;
    if (!(gas->conductivity > 0.0 && gap < gas->distance))
        return 0.0;
    return 2.0 * M_PI * gas->conductivity * effective * log(gas->distance / fmax(gap, gas->roughness));
}

/* A near pair of the batch. */
struct heat_pair {
    int material[2];
    double radius[2], effective, gap;
};

static struct heat_pair pair_of(const struct heat *heat, const struct walk_batch *batch, int k) {
    const double *d = batch->record[k], r = batch->radius[0][k], other = batch->radius[1][k];
    return (struct heat_pair){
        .material = {material_of(heat->material, batch->i[k]), material_of(heat->material, batch->j[k])},
        .radius = {r, other},
        .effective = r * other / (r + other),
        .gap = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) - d[3]};
}

/* The heat of pair k of a batch that exchanges h over one kelvin. */
static void flow_of(const struct heat *heat, struct walk_batch *batch, int k, double h) {
    double over = heat->conductance ? 1.0 : heat->temperature[batch->j[k]] - heat->temperature[batch->i[k]];
    batch->out[0][k] = h * over;
    batch->out[1][k] = heat->conductance ? h : -h * over;
}

static void compute(const struct walk_task *task, struct walk_batch *batch) {
    const struct heat *heat = task->work->context;
    for (int k = 0; k < batch->padded; k++) {
        struct heat_pair pair = pair_of(heat, batch, k);
        double h = heat_through_gas(heat, pair.effective, pair.gap);
        if (heat->contact_walk == NULL && pair.gap < 0.0)
            h += heat_through_contact(
                heat, pair.material,
                heat_contact_radius(heat, pair.material, pair.radius, pair.effective, pair.gap, NULL));
        flow_of(heat, batch, k, h);
    }
}

/* Contacts that remember their state. Gas between surfaces that touch across a gap, a neck, is as between others that
 * touch. */
static void compute_contacts(const struct walk_task *task, struct walk_batch *batch) {
    const struct heat *heat = task->work->context;
    const struct force_context *contact = grains_contact(heat->context);
    const struct history_part *part = history_part_of(contact->history, contact->list, task->pair_base);
    for (int k = 0; k < batch->count; k++) {
        struct heat_pair pair = pair_of(heat, batch, k);
        const double *record = history_record(contact->history, part, batch->pair[k]);
        double a = heat_contact_radius(heat, pair.material, pair.radius, pair.effective, pair.gap, record);
        double h = heat_through_contact(heat, pair.material, a);
        if (a > 0.0 && pair.gap > 0.0)
            h += heat_through_gas(heat, pair.effective, 0.0) -
                 heat_through_gas(heat, pair.effective, pair.gap);
        flow_of(heat, batch, k, h);
    }
}

const struct walk_client heat_contacts_client = {.name = "heat_contacts",
                                                 .memory = sizeof(struct walk_batch),
                                                 .scatter = WALK_VALUES,
                                                 .values = 1,
                                                 .compute = compute_contacts};

const struct walk_client heat_pairs_client = {.name = "heat",
                                              .memory = sizeof(struct walk_batch),
                                              .scatter = WALK_VALUES,
                                              .values = 1,
                                              .compute = compute};
