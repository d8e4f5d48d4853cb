/* SPDX-License-Identifier: BSD-3-Clause */
/* Forces on bodies, foot by foot. Read forces.h first. */
#include "fluid/forces.h"
#include "core/memory.h"

#include <string.h>

/* Adds the share of one wall entry. */
static void add_entry(const struct flow *flow, size_t row, size_t entry, size_t wall, double viscosity,
                      struct forces_part *part) {
    const struct weights *weights = flow->weights;
    double volume = weights->volume[row], difference[3],
           push = 2 * volume * flow->pressure[weights->first + row];
    operators_mirror(weights, wall, flow_velocity(flow), flow_velocity_of(flow, row), difference);
    for (int d = 0; d < weights->dimension; d++) {
        part->viscous[d] -= volume * viscosity * weights_scalar(weights, entry) *
                            (difference[d] - weights_turn(weights, wall, d));
        part->pressure[d] += push * weights_vector(weights, entry)[d];
    }
}

void forces_feet(const struct flow *flow, double viscosity, struct forces_part *part) {
    const struct weights *weights = flow->weights;
    memset(part, 0, weights->foot_start[weights->rows] * sizeof *part);
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        size_t e = weights_walls(weights, row);
        for (size_t k = weights->wall_start[row]; k < weights->wall_start[row + 1]; k++, e++)
            add_entry(flow, row, e, k, viscosity, &part[weights->wall_foot[k]]);
    }
}

void forces_free(struct forces *forces) {
    memory_free(forces->part);
    memory_free(forces->grain);
    *forces = (struct forces){0};
}
