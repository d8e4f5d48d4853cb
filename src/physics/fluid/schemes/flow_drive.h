/* SPDX-License-Identifier: BSD-3-Clause */
/* What drives a flow: a force on each volume of the fluid, in a periodic direction minus the mean gradient of
 * pressure. The scene gives the force, or a pressure drop over the box, or a mass flow, to which the force is
 * fitted: step by step, or for a steady Stokes flow, which is linear, by scaling. A table over time may give a factor of the force or
 * the drop. */
#ifndef SCREE_SCHEMES_FLOW_DRIVE_H
#define SCREE_SCHEMES_FLOW_DRIVE_H

#include "engine/physics.h"
#include "base/numbers.h"
#include "physics/fluid/schemes/flow.h"
#include "physics/fluid/fluid.h"

/* The force now, and what the next step of a given mass flow must know. */
struct drive {
    double force[3];      /* force/volume */
    double mean_before;   /* mean velocity of the fluid along the axis, before the last step */
    int64_t steps;        /* adjusted so far */
    struct numbers table; /* rows of time and factor, owned; no rows: none */
};

/* True if the keys of the drive go together and with the box; else a user's error with the key. */
bool flow_drive_suits(const struct physics_context *context, struct error *error);

/* The force at the start: that of the scene; with a mass flow the body force as a first guess, 0 if none. Reads the table; an error goes
 * to `error`. */
struct drive flow_drive_begin(const struct fluid_options *options, const struct box *box,
                              struct error *error);
void flow_drive_free(struct drive *drive);

/* The numbers of a restart: none where the scene alone says the force, which may then change at a resume. */
void flow_drive_restart(struct drive *drive, const struct fluid_options *options, struct restart *list);

/* The force of the next step. With a table that of a time. With a given mass flow half of what would bring the mean velocity to its goal in
 * one step if the resistance stayed as in the last one. Else nothing changes. Collective. */
void flow_drive_adjust(struct drive *drive, const struct fluid_options *options, const struct box *box,
                       const struct flow *flow, double time, double dt);

/* The factor of a table at a time; 1 without rows. Any thread. */
double flow_drive_factor(const struct numbers *table, bool repeat, double time);

/* With a given mass flow: scales force, velocity and pressure of a steady flow between walls at rest. False,
 * with an error, if nothing flows. Collective. */
bool flow_drive_scale(struct drive *drive, const struct fluid_options *options, const struct box *box,
                      const struct flow *flow, struct error *error);

#endif
