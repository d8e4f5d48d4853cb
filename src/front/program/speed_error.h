/* SPDX-License-Identifier: BSD-3-Clause */
/* Speed against error: compares a variant's record with the record of the reference run, finds the variants
 * on the front, and writes the result to files and in a sentence. Plain numbers; only rank 0.
 *
 * Errors are relative. The error of an observable is the root mean square, over the samples, of the
 * difference from the reference or, if chaos has taken over, the difference of the means from some time on.
 * The error is divided by the range of the observable in the reference (at least a hundredth of the largest
 * range of an observable in the same unit). The error of the trajectory is the root mean square distance of
 * particles over the smallest radius: the largest value before the distance of the two finest runs reaches a
 * hundredth of the smallest radius. Later chaos decides. */
#ifndef SCREE_PROGRAM_SPEED_ERROR_H
#define SCREE_PROGRAM_SPEED_ERROR_H

#include "front/program/sample.h"
#include "front/program/variant.h"
#include <stdio.h>

enum { SPEED_FINE = 3, SPEED_MEMBERS_MAX = 8 };

/* The reference for all variants. Made by speed_reference_make, freed by speed_reference_free. */
struct speed_reference {
    struct sample_record fine[SPEED_FINE]; /* of runs at fine steps, each half the one before; the last is the
                                              reference */
    double dt;                             /* time step of the reference */
    int horizon;                           /* last sample before chaos takes over */
    double scale[SAMPLE_COLUMNS_MAX];      /* of the scene's own columns */
    double uncertain[SAMPLE_COLUMNS_MAX];  /* error of the reference, from the two finest runs */
    double order[SAMPLE_COLUMNS_MAX];      /* of convergence; NAN: unknown */
    double spread[SAMPLE_COLUMNS_MAX];     /* of runs that differ by a tiny displacement at the start */
    bool judged[SAMPLE_COLUMNS_MAX];       /* the column counts for the front and the advice */
    bool judge_trajectory;
    double trajectory_uncertain, trajectory_order, trajectory_spread;
    double momentum;    /* scale */
    double mean_from;   /* columns are judged by their mean from this time on; NAN: sample by sample */
    double floor;       /* smaller differences mean nothing: largest spread or error of judged columns */
    int members;        /* of the spread */
    int ranks, threads; /* of the timed runs */
};

/* One row of the table. */
struct speed_row {
    struct variant variant;
    double dt, stable; /* time */
    uint64_t steps;
    double seconds;     /* of the fastest of the repeated runs: the processor's where one thread
                           runs alone, else wall clock */
    double cpu_seconds; /* the processor's, all ranks and threads, least of the repeated runs */
    double trajectory, drift, momentum; /* NAN: unknown */
    double error[SAMPLE_COLUMNS_MAX];   /* of the scene's own columns */
    double judged;                      /* the largest of the judged errors */
    int worst;                          /* the column of the largest judged error; -1: the trajectory */
    bool on_front;
    char stopped[160]; /* the reason for a missing result; "": there is a result */
};

/* Chooses the judged columns: names of columns, separated by commas, and "trajectory". NULL: the scene's own
 * columns without energies or, if the scene has no other columns, the energies of motion. Fails (user) on
 * unknown names. */
bool speed_judge(struct speed_reference *reference, const char *names, struct error *error);

/* Scales, horizon, order and error of the reference from its three runs. */
void speed_reference_make(struct speed_reference *reference);
void speed_reference_free(struct speed_reference *reference);

/* Finds the spread from the records of `members` runs that differ only by a displacement at the start; then
 * the floor. */
void speed_spread(struct speed_reference *reference, const struct sample_record *member, int members);

/* Finds the errors of a run. */
void speed_row_measure(struct speed_row *row, const struct sample_record *record,
                       const struct speed_reference *reference);

/* Marks the rows that no other row beats in both time and error; errors below the floor count as equal. */
void speed_front(struct speed_row *row, int rows, const struct speed_reference *reference);

/* True if row `k` is the first of its group. */
bool speed_row_opens_group(const struct speed_row *row, int k);

/* The data of the final report. */
struct speed_report {
    const struct speed_row *row; /* the first is the scene as it is */
    int rows;
    const struct speed_reference *reference;
    const struct variant_facts *facts;
    double tolerance; /* of the judged error, for the advice */
};

/* The fastest row of a group (NULL: of all) within a tolerance of the judged error; -1: none. */
int speed_best(const struct speed_report *report, const char *group, double tolerance);

/* The row of a group (NULL: of all) with the smallest judged error; -1: none has a result. */
int speed_most_exact(const struct speed_report *report, const char *group);

/* Prints the machine of the timed runs, the quality of the reference, the rows, and the advice: the fastest
 * row within the tolerance, or else the nearest row; then each law, and likewise the fastest row of each
 * other group of settings. */
void speed_print(const struct speed_report *report, FILE *file);

/* Writes DIR/speed_error.csv, a row a variant; DIR/speed_error_reference.csv, a row an observable: scale,
 * error and order of the reference, spread; DIR/speed_error.txt, the text of speed_print; and the plot
 * (speed_plot). */
bool speed_write(const struct speed_report *report, const char *directory, struct error *error);

/* The picture of speed against error. This code places the labels, as gnuplot would print labels on top of
 * each other. */

/* Writes DIR/speed_error.gp, and DIR/speed_error.svg by gnuplot (a warning if gnuplot is not found). Errors
 * below the floor are drawn on the floor. Each point of the front has a label; other points have one if there
 * is room. Only rank 0. Fails (system) if the script cannot be written. */
bool speed_plot(const struct speed_report *report, const char *directory, struct error *error);

#endif
