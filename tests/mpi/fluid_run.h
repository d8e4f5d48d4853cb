/* SPDX-License-Identifier: BSD-3-Clause */
/* A simulation with a fluid, whose units a test calls one by one: shared by the tests of units that need particles, walls and copies. */
#ifndef SCREE_TESTS_MPI_FLUID_RUN_H
#define SCREE_TESTS_MPI_FLUID_RUN_H

#include "engine/physics_set.h"
#include "physics/fluid/fluid_state.h"

struct simulation;

struct fluid_run {
    struct scene *scene;
    struct simulation *simulation;
    const struct physics_context *context; /* of the fluid */
    struct fluid *fluid;
    struct clock *clock; /* of the simulation */
    struct error error;
};

/* Makes the simulation of a scene, whose fluid has its weights and has made no step: the clock shows the first step. With `solvers` those
 * of a flow in time are there, too. False, with an error, if it cannot be made; fluid_run_free follows all the same. Collective, as all here. */
bool fluid_run_make(struct fluid_run *run, const struct comm *comm, const char *text, bool solvers);
void fluid_run_free(struct fluid_run *run);

/* The same in a test of a team (team.h): ends the test where PETSc is not there, and notes a failure. */
#define fluid_run_begin(run, team, scene_text, solvers)                                                      \
    (solve_available() ? (void)0 : team_skip(team, "PETSc is not there"),                                    \
     team_expect(team, fluid_run_make(run, &(team)->comm, scene_text, solvers), "%s", (run)->error.text))

/* The momentum of the fluid in direction d: density times volume times velocity, of all rows of all ranks. */
double fluid_run_momentum(const struct fluid_run *run, int d);

#endif
