/* SPDX-License-Identifier: BSD-3-Clause */
/* One step of hard contacts: free velocities, rows, sweeps of Gauss and Seidel, restitution, forces.
 *
 * Particles have positions x(n) and velocities v(n-1/2). Their velocities without contacts are v* = v(n-1/2) + dt (f/m + g), those
 * with contacts v(n+1/2) solve the contact problem at x(n), and the force of the contacts is m (v(n+1/2) - v*) / dt: the
 * integrator, which kicks and drifts by forces, then moves grains as Moreau and Jean's scheme does. */
#ifndef SCREE_HARD_HARD_SOLVE_H
#define SCREE_HARD_HARD_SOLVE_H

#include "kernel/comm/comm.h"
#include "physics/hard/border.h"
#include "physics/hard/contacts.h"
#include "physics/hard/hard.h"
#include "physics/hard/newton.h"

/* What a step begins with. Borrowed. */
struct hard_input {
    struct hard_scene scene;
    struct particles *particles; /* forces of others are there; those of contacts are added */
    bool prescribed;             /* some grains move as given, or are at rest; the same on all ranks */
    const double (*omega)[4];    /* NULL: particles do not turn */
    double gravity[3];
    int dimension;
    double dt, duration; /* duration: dt, or half of it in the first evaluation of a run */
};

/* What came of it. Overlap, contacts, energies and virial are this rank's part. */
struct hard_result {
    int sweeps;
    int steps, iterations; /* of Newton's method, and of its linear solver */
    double residual;
    uint64_t rows;
    double fastest; /* largest speed of grains without their contacts */
    double
        overlap; /* largest over the smaller radius, at the start of the step; `overlap_id` its particles, a wall
                        is -(number + 1) */
    int64_t overlap_id[2];
    double approach;  /* largest speed at which two that touch still approach */
    size_t contacts;  /* with a force */
    double lost;      /* energy that contacts took of grains, without that of walls */
    double stored[2]; /* in the springs and cohesions of contacts: normal, tangential */
    double virial[6];
};

struct hard_solver {
    const struct comm *comm; /* borrowed */
    struct hard_options options;
    struct hard_terms terms;
    struct hard_pairs pairs;
    struct hard_contacts contacts;
    struct hard_problem problem;
    struct hard_border border;
    struct hard_clumps clumps;
    struct hard_rocks rocks;
    struct hard_newton newton;
    bool exact;      /* Newton's method has met the residual of the last step */
    double duration; /* of the impulses of the last step */
    double reach;    /* the pair list has all gaps up to this one */
    int threads;
};

/* What the present speeds ask of the reach: those of grains up to `fastest`, and those of walls. */
double hard_solver_wants(const struct hard_input *input, double fastest);

/* Solves a step, and adds the forces of contacts to particles and walls. Collective. */
void hard_solver_step(struct hard_solver *solver, const struct hard_input *input, struct hard_result *result);

/* Lists the contacts of the last step that push or pull, those of pairs or those with walls; allocates (memory_free). One thread. */
size_t hard_solver_list(const struct hard_solver *solver, const struct particles *particles, bool walls,
                        struct force_contact **contacts);

/* At least the largest speed of the particles, and of points of rocks, over all ranks. Collective. */
double hard_solver_fastest(const struct hard_solver *solver, const struct particles *particles);

#endif
