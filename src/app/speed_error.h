/* Speed against error: what a variant's record says beside that of the reference run, which variants are on
 * the front, and the files and the sentence that tell it. Plain numbers; rank 0 alone.
 *
 * Errors are relative. An observable's is the root mean square over the samples of its difference from the
 * reference, over the range that the reference takes (at least a hundredth of the largest range among those
 * of its unit). The trajectory's is the root mean square distance of particles, over the smallest radius, at
 * its largest before the two finest runs are a hundredth of that apart: later chaos decides. */
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
    double momentum; /* scale */
    double floor;    /* differences below it mean nothing: the largest spread or error of what is judged */
    int members;     /* of the spread */
};

/* One row of the table. */
struct speed_row {
    struct variant variant;
    double dt, stable; /* time */
    uint64_t steps;
    double seconds;                     /* the fastest of the repeated runs; see speed_error.csv in docs */
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

/* The fastest row within a tolerance of the judged error; -1: none. */
int speed_best(const struct speed_row *row, int rows, double tolerance);

/* The row with the smallest judged error. */
int speed_most_exact(const struct speed_row *row, int rows);

/* Writes DIR/speed_error.csv, a row a variant; DIR/speed_error_reference.csv, a row an observable: scale,
 * error and order of the reference, spread; DIR/speed_error.gp, and DIR/speed_error.svg by gnuplot, if it is
 * found. */
bool speed_write(const struct speed_row *row, int rows, const struct speed_reference *reference,
                 const char *directory, struct error *error);

/* Prints how good the reference is; a row; the sentence of advice: the fastest row within the tolerance, or
 * what is nearest. */
void speed_print_reference(const struct speed_reference *reference, FILE *file);
void speed_print_row(const struct speed_row *row, const struct speed_reference *reference, FILE *file);
struct speed_rows {
    const struct speed_row *row;
    int count;
};
void speed_print_advice(struct speed_rows rows, const struct speed_reference *reference, double tolerance,
                        const struct variant_facts *facts, FILE *file);

#endif
