/* SPDX-License-Identifier: BSD-3-Clause */
/* The options of the output in a scene. Plain structs by value: scene/ fills the structs, engine/ passes them
 * to the writers. An interval is given in steps or in simulated time; if both are zero, the output is never
 * written. */
#ifndef SCREE_FORMATS_OUTPUT_OPTIONS_H
#define SCREE_FORMATS_OUTPUT_OPTIONS_H

#include "base/file.h"
#include <stdbool.h>
#include <stdint.h>

enum {
    OUTPUT_NAME_MAX = 64,
    OUTPUT_FIELDS_MAX = 64,
    OUTPUT_REGIONS_MAX = 32,
    OUTPUT_PLANES_MAX = 16,
    OUTPUT_EXPRESSION_MAX = 256,
    OUTPUT_GRIDS_MAX = 8,
    OUTPUT_REQUESTS_MAX = 64
};

/* An interval of output: every so many steps, or the first step at or after each multiple of a time. */
struct output_interval {
    uint64_t steps; /* 0: by time */
    double time;    /* time unit; 0: by steps */
};

/* True if the step that ends at `time`, after a step of length dt (> 0), is due. The start (step 0) is always
 * due, unless both members of the interval are 0. */
bool output_interval_due(const struct output_interval *interval, uint64_t step, double time, double dt);

/* True if either form is given. */
bool output_interval_set(const struct output_interval *interval);

/* A list of particle fields by name (names in frame.h); an empty list means all fields of the scene. */
struct output_fields {
    int count;
    char name[OUTPUT_FIELDS_MAX][OUTPUT_NAME_MAX];
};

enum output_precision { OUTPUT_DOUBLE, OUTPUT_SINGLE };

/* DIR/trajectory.h5 and .xdmf. */
struct trajectory_options {
    struct output_interval every;
    struct output_fields fields;
    bool xdmf;                       /* default true */
    bool units;                      /* H5MD's attributes `unit`; default true */
    int precision;                   /* enum output_precision */
    int64_t deflate;                 /* 0: not compressed; 1 to 9 */
    struct output_interval contacts; /* the contact list, in the same file */
};

/* DIR/dump.lammpstrj. */
struct dump_options {
    struct output_interval every;
    struct output_fields fields;
};

/* DIR/walls-STEP.vtp, walls.pvd and walls.xdmf. */
struct wall_frames_options {
    struct output_interval every;
};

/* DIR/contact-problem-STEP.hdf5 (contact_problem.h). */
struct contact_problems_options {
    struct output_interval every;
};

/* DIR/checkpoint-STEP.h5. */
struct checkpoint_options {
    uint64_t every_steps; /* 0: not by steps */
    double every_minutes; /* wall clock; 0: not by time */
    int keep;             /* number of checkpoints to keep, >= 1; default 2 */
    bool at_end;          /* a checkpoint after the last step; default true */
};

enum output_region_shape { OUTPUT_REGION_BOX, OUTPUT_REGION_SPHERE, OUTPUT_REGION_CYLINDER };

/* A part of space, in the user's coordinates: a particle is inside if its centre is inside (lower bounds
 * included, upper bounds excluded). */
struct output_region {
    char name[OUTPUT_NAME_MAX];
    enum output_region_shape shape;
    double lower[3], upper[3]; /* BOX; -INFINITY and INFINITY leave a side open */
    double centre[3];          /* SPHERE; CYLINDER: a point of the axis, the middle */
    double axis[3];            /* CYLINDER, any length > 0 */
    double radius;             /* SPHERE, CYLINDER; length unit */
    double length;             /* CYLINDER, in total; 0: infinite */
};

/* A plane that particles cross, in the user's coordinates. */
struct output_plane {
    char name[OUTPUT_NAME_MAX];
    double point[3];
    double normal[3]; /* crossings along it count as positive; any length > 0 */
};

/* One requested observable. The meaning of `target`, `id` and `components` depends on the observable
 * (observables.h). */
struct observable_request {
    char name[OUTPUT_NAME_MAX];   /* row of the registry, or one of its group names such as "energy" */
    char label[OUTPUT_NAME_MAX];  /* first part of the column names; "": the target's name */
    char target[OUTPUT_NAME_MAX]; /* name of a wall, region or material; "": all of them */
    int64_t id;                   /* particle */
    unsigned components;          /* bits 1 x, 2 y, 4 z; 0: all */
    char of[OUTPUT_EXPRESSION_MAX], where[OUTPUT_EXPRESSION_MAX]; /* expressions over particles; "": none */
    char unit[OUTPUT_NAME_MAX];                                   /* of the expression */
    int directions; /* numbers given in `cells`: 3, or 0 without */
    int64_t cells[3];
};

enum output_kernel { OUTPUT_KERNEL_CELLS, OUTPUT_KERNEL_GAUSS };

/* Fields on a grid, DIR/grid-NAME.csv (data/observe/observables_grid.h). */
struct output_grid {
    char name[OUTPUT_NAME_MAX];
    struct output_interval every;
    double lower[3], upper[3]; /* user's coordinates; NAN: the box */
    int directions;            /* numbers given in `cells`: 3 */
    int64_t cells[3];
    enum output_kernel kernel;
    double width; /* GAUSS: standard deviation, length unit */
};

/* DIR/observables.csv. */
struct observables_options {
    struct output_interval every;
    int count;
    struct observable_request request[OUTPUT_REQUESTS_MAX]; /* none: energies, momentum, contacts */
    int regions;
    struct output_region region[OUTPUT_REGIONS_MAX];
    int planes;
    struct output_plane plane[OUTPUT_PLANES_MAX];
    int grids;
    struct output_grid grid[OUTPUT_GRIDS_MAX];
};

enum progress_mode { PROGRESS_AUTO, PROGRESS_BAR, PROGRESS_LINES, PROGRESS_OFF };

/* Progress on the terminal. AUTO: a bar on a terminal, otherwise a line every few seconds. */
struct progress_options {
    enum progress_mode mode;
};

struct output_options {
    struct trajectory_options trajectory;
    struct dump_options dump;
    struct wall_frames_options walls;
    struct contact_problems_options contact_problems;
    struct checkpoint_options checkpoint;
    struct observables_options observables;
    struct progress_options progress;
};

/* The defaults: no periodic output, xdmf and the checkpoint at the end on, keep 2, progress AUTO. */
struct output_options output_options_default(void);

#endif
