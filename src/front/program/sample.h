/* SPDX-License-Identifier: BSD-3-Clause */
/* The record of a run for `scree ablate --error`: at even times the scene's own observables, the energies and
 * momentum, and the positions of some of the particles. Two runs with samples at the same times can be
 * compared. */
#ifndef SCREE_PROGRAM_SAMPLE_H
#define SCREE_PROGRAM_SAMPLE_H

#include "engine/run.h"
#include "data/observe/observables.h"
#include <time.h>

enum { SAMPLE_COLUMNS_MAX = 256, SAMPLE_TRACKED_MAX = 20000 };

/* The record of a run. Every rank holds the same numbers, except for `present` and `position`, which only
 * rank 0 holds. */
struct sample_record {
    int samples;      /* taken, the start included */
    int columns;      /* the scene's own, then those of energies and momentum */
    int own;          /* the scene's own columns */
    char (*name)[64]; /* [columns] */
    char (*unit)[16]; /* [columns] */
    double *time;     /* [samples] */
    double *value;    /* [samples][columns] */
    size_t tracked;   /* particles whose positions are recorded: ids 1, 1 + stride, 1 + 2 stride ... */
    int64_t stride;
    float *present;         /* [samples][tracked]: 1 if the particle exists */
    double (*position)[3];  /* [samples][tracked], not wrapped; length unit */
    double radius_min;      /* of all particles at the start; length unit */
    double mass, speed_max; /* of all free particles at the start; the largest speed over the samples */
    bool closed;            /* no particle comes or goes, or has a prescribed motion: energy must balance */
};

/* A recorder: give `watch` to run_scene. */
struct sampler {
    struct run_watch watch;
    struct sample_record *record; /* filled */
    uint64_t steps_each;          /* steps between samples */
    int samples_max;
    double perturbation; /* largest displacement of particles at the start, over their radius; 0: none */
    uint64_t seed;       /* of the perturbation */
    struct observables *own, *whole;
};

/* Makes a recorder that samples every `steps_each` steps up to `samples` times after the start, into
 * `record`. A scene with more columns of its own than SAMPLE_COLUMNS_MAX is refused (user) when its run
 * begins. */
void sample_create(struct sampler *sampler, struct sample_record *record, uint64_t steps_each, int samples);

/* Frees the recorder, not the record. */
void sample_destroy(struct sampler *sampler);

/* Frees the arrays of a record; the record may be all zero. */
void sample_free(struct sample_record *record);

/* An observer that only measures the processor's time: give `watch` to run_scene. */
struct stopwatch {
    struct run_watch watch;
    struct timespec began;
};

void sample_clock_create(struct stopwatch *stopwatch);

/* Seconds that the processor has spent on this process since its run began, all threads. */
double sample_clock_read(const struct stopwatch *stopwatch);

/* Number of a column of the record by name among the columns from `first` on, or -1. */
int sample_column(const struct sample_record *record, const char *name, int first);

/* Number in `other` of the column with the name of column `column` in `record`, or -1; for example, a scene
 * without friction has no column for spin. */
int sample_column_like(const struct sample_record *other, const struct sample_record *record, int column);

/* Value of a column at a sample. */
static inline double sample_value(const struct sample_record *record, int sample, int column) {
    return record->value[(size_t)sample * (size_t)record->columns + (size_t)column];
}

#endif
