/* SPDX-License-Identifier: BSD-3-Clause */
/* Forces on bodies, foot by foot. Read surface_forces.h first. */
#include "physics/fluid/operators/surface_forces.h"
#include "base/memory.h"

#include <math.h>
#include <string.h>

/* What a gradient of the pressure that is made whole has more than that of the fluid neighbours: `extra`, [rows]. */
static void extra_make(const struct flow *flow, double (*extra)[3]) {
    struct weights plain = *flow->weights;
    double(*part)[3] = memory_allocate(plain.rows, sizeof *part, "forces");
    plain.whole = NULL;
    operators_gradient(&plain, flow_pressure(flow), part);
    operators_gradient(flow->weights, flow_pressure(flow), extra);
    for (size_t row = 0; row < plain.rows; row++)
        for (int d = 0; d < 3; d++)
            extra[row][d] -= part[row][d];
    memory_free(part);
}

/* Adds to the bodies of a row the force of `extra`, by their shares of the sum of |b|. */
static void add_extra(const struct weights *weights, size_t row, const double extra[3],
                      struct surface_forces_part *part) {
    double all = 0;
    for (int pass = 0; pass < 2; pass++) {
        size_t e = weights_walls(weights, row);
        for (size_t k = weights->wall_start[row]; k < weights->wall_start[row + 1]; k++, e++) {
            const double *b = weights_vector(weights, e);
            double size = 0;
            for (int d = 0; d < weights->dimension; d++)
                size += b[d] * b[d];
            if (weights_foot_of(weights, k)->open)
                continue;
            all += pass == 0 ? sqrt(size) : 0;
            for (int d = 0; d < weights->dimension && pass == 1; d++)
                part[weights->wall_foot[k]].pressure[d] += weights->volume[row] * extra[d] * sqrt(size) / all;
        }
    }
}

void surface_forces_torque(const struct surface_forces_part *part, const double lever[3], double torque[3]) {
    double force[3];
    for (int d = 0; d < 3; d++)
        force[d] = part->viscous[d] + part->pressure[d];
    for (int d = 0; d < 3; d++)
        torque[d] = part->couple[d] + lever[(d + 1) % 3] * force[(d + 2) % 3] -
                    lever[(d + 2) % 3] * force[(d + 1) % 3];
}

/* Adds the couple of the slip at one wall entry; `own` is u_i. */
static void add_couple(const struct weights *weights, size_t entry, const struct weights_foot *foot,
                       double strength, const double *own, double couple[3]) {
    double slip[3] = {0}, b[3] = {0}, across = 0, part = weights->slip / (foot->distance + weights->slip);
    for (int d = 0; d < weights->dimension; d++) {
        b[d] = weights_vector(weights, entry)[d];
        slip[d] = own[d] - foot->velocity[d];
        across += slip[d] * foot->normal[d];
    }
    for (int d = 0; d < weights->dimension; d++)
        slip[d] = part * (slip[d] - across * foot->normal[d]);
    for (int d = 0; d < 3; d++)
        couple[d] += strength * (b[(d + 1) % 3] * slip[(d + 2) % 3] - b[(d + 2) % 3] * slip[(d + 1) % 3]);
}

/* Adds the share of one wall entry. */
static void add_entry(const struct flow *flow, size_t row, size_t entry, size_t wall, double viscosity,
                      struct surface_forces_part *part) {
    const struct weights *weights = flow->weights;
    double volume = weights->volume[row], difference[3],
           push = 2 * volume * flow->pressure[weights->first + row];
    operators_mirror(weights, wall, flow_velocity(flow), flow_velocity_of(flow, row), difference);
    for (int d = 0; d < weights->dimension; d++) {
        part->viscous[d] -= volume * viscosity * weights_scalar(weights, entry) *
                            (difference[d] - weights_turn(weights, wall, d));
        part->pressure[d] += push * weights_vector(weights, entry)[d];
    }
    if (weights->slip > 0 && !weights_foot_of(weights, wall)->open)
        add_couple(weights, entry, weights_foot_of(weights, wall), 2 * volume * viscosity,
                   flow_velocity_of(flow, row), part->couple);
}

void surface_forces_feet(const struct flow *flow, double viscosity, struct surface_forces_part *part) {
    const struct weights *weights = flow->weights;
    double(*extra)[3] = NULL;
    memset(part, 0, weights->foot_start[weights->rows] * sizeof *part);
    if (weights->whole != NULL) {
        extra = memory_allocate(weights->rows, sizeof *extra, "forces");
        extra_make(flow, extra);
    }
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        size_t e = weights_walls(weights, row);
        for (size_t k = weights->wall_start[row]; k < weights->wall_start[row + 1]; k++, e++)
            add_entry(flow, row, e, k, viscosity, &part[weights->wall_foot[k]]);
        if (extra != NULL)
            add_extra(weights, row, extra[row], part);
    }
    memory_free(extra);
}

void surface_forces_free(struct forces *forces) {
    memory_free(forces->part);
    memory_free(forces->grain);
    *forces = (struct forces){0};
}
