/* SPDX-License-Identifier: BSD-3-Clause */
/* Speed against error: what a variant's record says beside that of the reference run, which variants are on
 * the front, and the files and the sentence that tell it. Plain numbers; rank 0 alone.
 *
 * Errors are relative. An observable's is the root mean square over the samples of its difference from the
 * reference, or the difference of their means from some time on, where chaos has taken over; over the range
 * that the reference takes (at least a hundredth of the largest range among those of its unit). The
 * trajectory's is the root mean square distance of particles, over the smallest radius, at its largest before
 * the two finest runs are a hundredth of that apart: later chaos decides. */
#ifndef SCREE_APP_SPEED_ERROR_H
#define SCREE_APP_SPEED_ERROR_H

#include "app/sample.h"
#include "app/variant.h"
#include <stdio.h>

enum { SPEED_FINE = 3, SPEED_MEMBERS_MAX = 8 };

/* What all variants are measured by. Made by speed_reference_make, freed by speed_reference_free. */
struct speed_reference {
    struct sample_record fine[SPEED_FINE]; /* of runs at fine steps, each half the one before; the last is the
                                              reference */
    double dt;                             /* its step */
    int horizon;                           /* last sample before chaos takes over */
    double scale[SAMPLE_COLUMNS_MAX];      /* of the scene's own columns */
    double uncertain[SAMPLE_COLUMNS_MAX];  /* error of the reference, as of its two finer steps */
    double order[SAMPLE_COLUMNS_MAX];      /* of convergence; NAN: cannot be told */
    double spread[SAMPLE_COLUMNS_MAX];     /* of runs that differ by a tiny displacement at the start */
    bool judged[SAMPLE_COLUMNS_MAX];       /* counts for the front and the advice */
    bool judge_trajectory;
    double trajectory_uncertain, trajectory_order, trajectory_spread;
    double momentum;    /* scale */
    double mean_from;   /* columns are judged by their mean from this time on; NAN: sample by sample */
    double floor;       /* differences below it mean nothing: the largest spread or error of what is judged */
    int members;        /* of the spread */
    int ranks, threads; /* of the runs that were timed */
};

/* One row of the table. */
struct speed_row {
    struct variant variant;
    double dt, stable; /* time */
    uint64_t steps;
    double seconds;     /* of the fastest of the repeated runs: the processor's where one thread
                           runs alone, else wall clock */
    double cpu_seconds; /* the processor's, all ranks and threads, least of the repeated runs */
    double trajectory, drift, momentum; /* NAN: cannot be told */
    double error[SAMPLE_COLUMNS_MAX];   /* of the scene's own columns */
    double judged;                      /* the largest of those judged */
    int worst;                          /* its column; -1: the trajectory */
    bool on_front;
    char stopped[160]; /* why there is no result; "" if there is one */
};

/* Chooses what is judged: names of columns, separated by commas, and "trajectory"; NULL: the scene's own
 * columns but energies, or, where it has no others, the energies of motion. Fails (user) on unknown names. */
bool speed_judge(struct speed_reference *reference, const char *names, struct error *error);

/* Scales, horizon, order and error of the reference from its three runs. */
void speed_reference_make(struct speed_reference *reference);
void speed_reference_free(struct speed_reference *reference);

/* The spread from the records of `members` runs alike but for a displacement; then the floor. */
void speed_spread(struct speed_reference *reference, const struct sample_record *member, int members);

/* Errors of a run. */
void speed_row_measure(struct speed_row *row, const struct sample_record *record,
                       const struct speed_reference *reference);

/* Marks the rows that no other row beats in both time and error, errors below the floor being equal. */
void speed_front(struct speed_row *row, int rows, const struct speed_reference *reference);

/* True if row `k` is the first of its group. */
bool speed_row_opens_group(const struct speed_row *row, int k);

/* What is told at the end. */
struct speed_report {
    const struct speed_row *row; /* the first is the scene as it is */
    int rows;
    const struct speed_reference *reference;
    const struct variant_facts *facts;
    double tolerance; /* of what is judged, for the advice */
};

/* The fastest row of a group (NULL: of all) within a tolerance of the judged error; -1: none. */
int speed_best(const struct speed_report *report, const char *group, double tolerance);

/* The row of a group (NULL: of all) with the smallest judged error; -1: none has a result. */
int speed_most_exact(const struct speed_report *report, const char *group);

/* Prints what was measured on, how good the reference is, the rows, and the advice: the fastest row within
 * the tolerance, or what is nearest, then each law, and of each other group of settings the fastest likewise.
 */
void speed_print(const struct speed_report *report, FILE *file);

/* Writes DIR/speed_error.csv, a row a variant; DIR/speed_error_reference.csv, a row an observable: scale,
 * error and order of the reference, spread; DIR/speed_error.txt, what speed_print prints; and the plot
 * (speed_plot.h). */
bool speed_write(const struct speed_report *report, const char *directory, struct error *error);

#endif
