/* SPDX-License-Identifier: BSD-3-Clause */
/* The state of a flow on rows of weights, as the schemes (projection.h, steady.h) see it: plain arrays by
 * particle number, owned particles and copies, and a way to bring copies up to date. Nothing here knows scenes
 * or physics; flow_fields.c fills a flow from the fields of a set of particles, tests fill it by hand. */
#ifndef SCREE_SCHEMES_FLOW_H
#define SCREE_SCHEMES_FLOW_H

#include "kernel/comm/comm.h"
#include "physics/fluid/operators/operators.h"

/* The arrays whose copies a scheme brings up to date. */
enum flow_array {
    FLOW_VELOCITY,
    FLOW_PRESSURE,
    FLOW_PREDICTED,
    FLOW_INCREMENT,
    FLOW_ROW,
    FLOW_GRADIENT,
    FLOW_VOLUME,
    FLOW_WHOLE,
    FLOW_MOBILITY
};

/* All borrowed. Values of fluid particles alone are used. */
struct flow {
    const struct comm *comm;
    struct timers *timers; /* gets the stage "assembly"; NULL: none */
    const struct weights *weights;
    double *velocity; /* u, length/time: 3 components, velocity_stride doubles from one to the next */
    size_t velocity_stride;
    double *pressure;  /* p, pressure, without that of the driving force */
    double *predicted; /* 3 components: u* of a step; scratch of the coupled solver */
    double *increment; /* phi of a step; scratch */
    double *
        advection_before; /* 3 components: (u . grad) u of the step before, or drift_advection; copies have none */
    /* Of particles that move (moving_step.h), 3 components each; NULL where they rest. Copies have the gradient alone. */
    double *velocity_before; /* u of the step before */
    double *drift;           /* velocity of the particle less that of the fluid there, w - u */
    double *drift_advection; /* (drift . grad) u */
    double *gradient;        /* grad p; scratch of a step */
    const double (*body)[3]; /* by row: force/volume beside that of the drive; NULL: none */
    const double *resist;    /* by row: drag at the end of a step over inertia, a of projection.h; NULL: 0 */
    const double *mobility;  /* k of projection.h, by particle number, of copies, too; NULL: 1 */
    /* by particle number, of copies, too: volume flow of the fluid and its velocity, where grains take a part of the room; NULL: both are `velocity` */
    const double (*carried)[2][3];
    int64_t *row;          /* global number of a fluid particle's row (flow_number) */
    bool pressed;          /* a pressure is given at an open side of each region: it has no free constant */
    int regions;           /* connected regions of the fluid on all ranks, >= 1 */
    const int32_t *region; /* by row of the weights; NULL with one region */
    /* Sends an array's values to the copies. NULL: there are none. Collective. */
    void (*forward)(const struct flow *flow, enum flow_array array);
    const void *context;
};

/* Numbers the rows over all ranks, rank after rank, in the copies too. Returns their number. Collective. */
int64_t flow_number(const struct flow *flow);

/* Brings the copies of an array up to date. Collective. */
void flow_forward(const struct flow *flow, enum flow_array array);

/* The arrays as operators see them. */
struct operators_values flow_velocity(const struct flow *flow);
struct operators_values flow_pressure(const struct flow *flow);
struct operators_values flow_predicted(const struct flow *flow);
struct operators_values flow_increment(const struct flow *flow);
struct operators_values flow_drift(const struct flow *flow);
struct operators_values flow_gradient(const struct flow *flow);

/* The velocity of a row's particle. */
static inline double *flow_velocity_of(const struct flow *flow, size_t row) {
    return flow->velocity + (flow->weights->first + row) * flow->velocity_stride;
}

/* The mean velocity over the volume of the fluid, and that volume; `value` is by particle number. Collective. */
void flow_mean(const struct flow *flow, struct operators_values value, double mean[3], double *volume);

#endif
