/* SPDX-License-Identifier: BSD-3-Clause */
/* The weight of a particle beside a body. Read layer.h first. */
#include "physics/fluid/carried/layer.h"
#include <math.h>

/* The smallest difference of both shifts. */
#define APART 1e-3

/* The integral of a step from 0 to 1 that is averaged over a length of 1. */
static double ramp(double x) {
    if (x < -0.5)
        return 0;
    return x < 0.5 ? 0.5 * (x + 0.5) * (x + 0.5) : x;
}

/* S(x) of a blur w. */
static double step(double x, double blur) {
    return (ramp(x + 0.5 * blur) - ramp(x - 0.5 * blur)) / blur;
}

double layer_part(double distance, double gap) {
    if (!(gap > 1 + APART))
        return 1;
    double blur = fmax(fmin(LAYER_BLUR, gap - 1 - APART), APART), near = 0.5 * (1 + blur),
           far = fmax(fmin(LAYER_SHIFT, gap - near), near + APART), much = far / (far - near);
    double part = much * step(distance - near, blur) + (1 - much) * step(distance - far, blur);
    if (gap - distance < LAYER_REACH)
        part += much * step(gap - distance - near, blur) + (1 - much) * step(gap - distance - far, blur) - 1;
    return fmax(part, LAYER_LEAST);
}
