/* SPDX-License-Identifier: BSD-3-Clause */
/* The state of hard contacts in a run, for the seam to the engine (hard_physics.c), its checks of a scene (hard_check.c) and the
 * observables (hard_rows.c). */
#ifndef SCREE_HARD_HARD_STATE_H
#define SCREE_HARD_HARD_STATE_H

#include "base/file.h"
#include "engine/report_part.h"
#include "physics/hard/hard_solve.h"
#include <stdio.h>

struct error;
struct physics_context;

/* Over all ranks, of what is free to move and of what insertions will bring: the smallest radius of a sphere, or of the sphere
 * inside a rock, and the least and the largest mass of a single grain or a whole body. */
struct hard_sizes {
    double smallest, light, heavy; /* INFINITY, INFINITY, 0: there are none */
};

struct hard {
    const struct physics_context *context;
    struct hard_solver solver;
    struct hard_result last; /* of the last step */
    int wall_material[WALLS_MAX];
    struct hard_sizes sizes;
    double stiffness; /* kappa / dt^2 of rigid contacts now, which follows the scene's; 0: no step yet */
    /* Since this program began. */
    uint64_t refined, steps,
        iterations; /* solves by Newton's method that took steps, its steps, those of its linear solver */
    uint64_t solves, sweeps, unmet; /* unmet: with a residual above the tolerance */
    double worst;                   /* residual */
    struct report_contacts most;
    bool warned;                   /* of a residual */
    char directory[FILE_PATH_MAX]; /* of the run */
    int64_t written;               /* step of the last file of output.contact_problems; -1: none */
};

/* Collective. */
struct hard_sizes hard_sizes_find(const struct physics_context *context);

/* How contacts answer; allocates terms->pair. */
void hard_terms_make(struct hard_terms *terms, const struct physics_context *context,
                     const struct hard_options *options);

/* What the springs of rigid contacts cost: the speed of news, the overlap of the heaviest grain on one of the lightest, and that
 * of the lightest when the heaviest lands on a bed of them at the expected speed. A ball that has sunk in by half of the radius of
 * grains touches about as many as its radius is theirs: n springs of kappa m / dt^2 stop M = n^3 m within v dt n / sqrt(kappa). */
struct hard_price {
    double news, overlap, impact;
};
bool hard_has_price(const struct hard *hard);
struct hard_price hard_price_of(const struct physics_context *context);

/* The report, the notes before a run, what the run has seen, and the words of `scree check`: struct physics. */
struct notes;
struct report_part;
void hard_report(const struct physics_context *context, struct report_part *part);
void hard_notes(const struct physics_context *context, struct notes *notes);
void hard_seen(const struct physics_context *context, uint64_t first, struct notes *notes);
void hard_print(const struct physics_context *context, FILE *file);

/* Refuses what the solver does not know yet: the `check` of struct physics. */
bool hard_check(const struct physics_context *context, struct error *error);

/* The files of output.contact_problems: struct physics_table. */
bool hard_file_open(const struct physics_context *context, const char *directory, int64_t step,
                    struct error *error);
bool hard_file_write(const struct physics_context *context, struct error *error);

#endif
