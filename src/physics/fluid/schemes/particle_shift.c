/* SPDX-License-Identifier: BSD-3-Clause */
/* Velocities that keep particles apart. Read particle_shift.h first. */
#include "physics/fluid/schemes/particle_shift.h"
#include "physics/fluid/schemes/moving_step.h"
#include <math.h>

/* grad C of a row. */
static void concentration(const struct weights *weights, const struct weights_input *input,
                          const struct weights_options *options, size_t row, double gradient[3]) {
    double usual = kernel_value(&options->kernel, options->spacing);
    for (int d = 0; d < 3; d++)
        gradient[d] = 0;
    for (size_t e = weights->start[row]; e < weights->start[row + 1]; e++) {
        struct correction_tensors_neighbour to;
        weights_neighbour(weights, input, options, e, row, &to);
        double pairing = 1 + 0.2 * kernel_power(to.value / usual, 4);
        for (int d = 0; d < 3; d++)
            gradient[d] += to.strength * pairing * to.e[d];
    }
}

void particle_shift_velocity(const struct weights *weights, const struct weights_input *input,
                             const struct weights_options *options,
                             const struct particle_shift_options *shift, double *drift) {
    double factor = -shift->strength * options->spacing * shift->speed;
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        double s[3], square = 0;
        concentration(weights, input, options, row, s);
        for (int d = 0; d < 3; d++) {
            s[d] *= factor;
            square += s[d] * s[d];
        }
        double size = sqrt(square), part = size > shift->most ? shift->most / size : 1;
        for (size_t d = 0; d < 3; d++)
            drift[3 * (weights->first + row) + d] = part * s[d];
    }
}

/* Adds what a particle needs to end the next step at the least distance from a foot, or, if it is nearer, on its way there. */
static void keep_off_foot(const struct flow *flow, const struct particle_shift_off *off, size_t particle,
                          const struct weights_foot *foot) {
    double w[3], approach = 0, *drift = flow->drift + 3 * particle;
    moving_step_velocity(flow, particle, off->ahead, w);
    for (int d = 0; d < 3; d++)
        approach += foot->normal[d] * (w[d] - foot->velocity[d]);
    double wanted = fmin(off->least, foot->distance + off->most * off->dt);
    double push = (wanted - foot->distance) / off->dt - approach;
    for (int d = 0; d < 3 && push > 0; d++)
        drift[d] += push * foot->normal[d];
}

void particle_shift_keep_off(const struct flow *flow, const struct particle_shift_off *off) {
    const struct weights *weights = flow->weights;
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++)
        for (size_t k = weights->foot_start[row]; k < weights->foot_start[row + 1]; k++)
            if (!weights->foot[k].open)
                keep_off_foot(flow, off, weights->first + row, &weights->foot[k]);
}
