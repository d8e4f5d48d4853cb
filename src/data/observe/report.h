/* SPDX-License-Identifier: BSD-3-Clause */
/* The run report: one plain struct that engine/ fills. report_rows.h describes its entries, report_print.h
 * prints them on the terminal, report_json.h writes DIR/report.json. */
#ifndef SCREE_OBSERVE_REPORT_H
#define SCREE_OBSERVE_REPORT_H

#include "kernel/comm/comm.h"
#include "base/timer.h"
#include "kernel/particles/classes.h"
#include <stdbool.h>

enum {
    REPORT_LEVELS_MAX = CLASS_MAX,
    REPORT_NAME_MAX = 64,
    REPORT_SOLVERS_MAX = 8,
    REPORT_SCENE_STAGES_MAX = 32
};

struct report_level {
    double cell;    /* cell size, length unit; 0: no cells */
    uint64_t cells; /* over all ranks */
    uint64_t particles;
    double radius_min, radius_max;
};

struct report_class {
    double radius_min, radius_max;
    uint64_t particles, ghosts; /* over all ranks */
    double skin;                /* of the class with itself, at the last rebuild; length unit */
    uint64_t bytes;             /* received from other ranks for copies, and sent back, since the start */
};

/* A region in which particles are inserted; counts since the start of the run, over resumes. */
struct report_insertion {
    char name[REPORT_NAME_MAX];
    uint64_t asked, placed;
    uint64_t
        lost; /* of those placed since the last start or resume: outside of the box, which deletes them */
};

/* A stage of the scene that this program has run, wholly or in part. */
struct report_scene_stage {
    char name[REPORT_NAME_MAX];
    uint64_t first, last;      /* numbers of the steps before and at the end */
    double time;               /* simulated time at the end */
    double seconds;            /* wall clock without set-up */
    char end[REPORT_NAME_MAX]; /* why it ended */
};

/* The linear systems of one kind; seconds are the largest of a rank. */
struct report_solver {
    char name[REPORT_NAME_MAX];
    uint64_t rows, entries; /* of the matrix, over all ranks; 0 entries: without a matrix */
    uint64_t solves, iterations;
    uint64_t set_ups, kept; /* preconditioners made; solves of a new matrix with an old preconditioner */
    uint64_t doubtful;      /* solves with a true residual far above the tolerance */
    uint64_t products;      /* of the matrix with a vector, those that are timed */
    double residual;        /* true, relative, of the last solve */
    double residual_worst;
    double seconds_matrix, seconds_set_up, seconds_solve, seconds_products;
};

struct report_stage {
    char name[REPORT_NAME_MAX];
    unsigned use;          /* enum timer_use */
    double min, mean, max; /* seconds, over ranks */
};

/* All counts are over all ranks and since the start of this program, unless said otherwise. */
struct report {
    uint64_t steps;        /* done by this program */
    uint64_t step_last;    /* number of the last step of the run */
    double particle_steps; /* done by this program; 0: steps x particles */
    double time;           /* simulated time at the end */
    double dt;
    uint64_t particles;
    int ranks, threads;
    double threads_working; /* of a rank at a time, mean over the run; 0: all */
    char index[REPORT_NAME_MAX], law[REPORT_NAME_MAX], integrator[REPORT_NAME_MAX];
    bool skin_auto;             /* the run chooses its skin: */
    double skin_factor;         /* on the skin of the scene, at the end */
    uint64_t skin_changes;      /* since the start of the run, over resumes */
    bool newton, reduced;       /* reduced: copies travel only as far as partners do */
    char simd[REPORT_NAME_MAX]; /* instruction set of the force loop */
    int levels;
    struct report_level level[REPORT_LEVELS_MAX];
    char choice[REPORT_NAME_MAX]; /* the index that the choice amounts to; "": the index does not choose */
    char choice_why[8 * REPORT_NAME_MAX];
    uint64_t choices;                         /* made so far, rank 0 */
    double choice_predicted, choice_measured; /* seconds a rebuild, order to pairs, slowest rank */

    uint64_t *ghosts;           /* copies held at the end, one a rank; owned by the report */
    uint64_t *messages, *bytes; /* sent to other ranks in the steps, one a rank; owned by the report */
    uint64_t rebuild_messages, rebuild_bytes; /* of these, at rebuilds; all ranks together */
    int classes;
    struct report_class size_class[CLASS_MAX];
    double imbalance;  /* largest over mean seconds of work */
    double sync_share; /* of all seconds, in communication and in waiting for other ranks */
    char sync[4 * REPORT_NAME_MAX];
    char domain[REPORT_NAME_MAX];
    uint64_t divisions; /* times that the box was divided again */
    int stages;
    struct report_stage stage[TIMER_STAGES_MAX];
    struct report_stage setup_stage[TIMER_STAGES_MAX]; /* before the first step */
    int solvers;
    struct report_solver solver[REPORT_SOLVERS_MAX];
    double seconds; /* wall clock without set-up, largest over ranks */
    double seconds_setup;
    uint64_t pairs;            /* in the last list */
    uint64_t contacts;         /* at the end */
    uint64_t rebuilds, sorts;  /* sorts: rebuilds that sorted the particles */
    double bytes_per_particle; /* counted memory of all ranks / particles */
    uint64_t memory_held;      /* counted memory of all ranks at the end, bytes */
    uint64_t memory_peak;      /* largest peak resident set of a rank, bytes */
    uint64_t inserted, deleted;
    int insertions;
    struct report_insertion *insertion; /* owned */
    int scene_stages;                   /* 0: the scene has none */
    struct report_scene_stage scene_stage[REPORT_SCENE_STAGES_MAX];
    uint64_t seed;
    bool dimensionless;
    bool reproducible;
    char stopped[REPORT_NAME_MAX * 2]; /* why the run ended early; "": it did not */
};

/* Zeros, and arrays of `ranks` entries. */
void report_create(struct report *report, int ranks);
void report_destroy(struct report *report);

/* Fills the values of single ranks (ghosts, messages, bytes, stage, setup_stage, seconds, memory_peak, imbalance,
 * sync_share), each rank giving its own. Collective. */
struct report_mine {
    const struct timers *timers;
    const struct timers *timers_setup; /* the same stages before the first step */
    uint64_t ghosts, messages, bytes;
    double work, waiting; /* seconds */
    double seconds, seconds_setup;
};
void report_gather(struct report *report, const struct comm *comm, const struct report_mine *mine);

/* Mean seconds over ranks of the stages that have all bits `with` and none of `without` (enum timer_use). */
double report_stages(const struct report *report, unsigned with, unsigned without);

/* Particle-steps / seconds. */
double report_speed(const struct report *report);

/* Particle updates per core and second, as Eibl and Ruede define it: particle-steps / (seconds x ranks x
 * threads). */
double report_pupcs(const struct report *report);

#endif
