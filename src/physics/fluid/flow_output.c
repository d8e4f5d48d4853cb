/* SPDX-License-Identifier: BSD-3-Clause */
/* Vorticity and the force of viscosity, for output. */
#include "physics/fluid/flow_output.h"
#include "base/memory.h"

/* Adds b x (u_j - u_i), in two dimensions of b = (b_x, b_y, 0). */
static void add_curl(const double *b, int dimension, const double difference[3], double curl[3]) {
    double bz = dimension == 3 ? b[2] : 0;
    curl[0] += b[1] * difference[2] - bz * difference[1];
    curl[1] += bz * difference[0] - b[0] * difference[2];
    curl[2] += b[0] * difference[1] - b[1] * difference[0];
}

void flow_vorticity(const struct flow *flow) {
    const struct weights *weights = flow->weights;
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        const double *own = flow_velocity_of(flow, row);
        double curl[3] = {0}, difference[3];
        size_t wall = weights->wall_start[row], walls = weights_walls(weights, row);
        for (size_t e = weights->start[row]; e < weights->start[row + 1]; e++) {
            const double *other = flow->velocity + pair_partner(weights->partner[e]) * flow->velocity_stride;
            if (e >= walls)
                operators_mirror(weights, wall++, flow_velocity(flow), own, difference);
            else
                for (int d = 0; d < 3; d++)
                    difference[d] = other[d] - own[d];
            add_curl(weights_vector(weights, e), weights->dimension, difference, curl);
        }
        for (size_t d = 0; d < 3; d++)
            flow->predicted[3 * (weights->first + row) + d] = curl[d];
    }
}

void flow_viscous(const struct flow *flow, double share, double *force) {
    const struct weights *weights = flow->weights;
    double(*laplacian)[3] = memory_allocate(weights->rows, sizeof *laplacian, "viscous forces");
    operators_laplacian_velocity(weights, flow_velocity(flow), laplacian);
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++)
        for (size_t d = 0; d < 3; d++)
            force[3 * (weights->first + row) + d] = share * laplacian[row][d];
    memory_free(laplacian);
}
