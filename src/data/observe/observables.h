/* SPDX-License-Identifier: BSD-3-Clause */
/* Observables: numbers about the whole run, a row at a time, in DIR/observables.csv. One registry row an
 * observable: name, unit, how the part of one rank is found and how parts combine. observables_kinds.h has
 * the recipe for adding one. Velocities are those of the full step. */
#ifndef SCREE_OBSERVE_OBSERVABLES_H
#define SCREE_OBSERVE_OBSERVABLES_H

#include "data/formats/h5md.h"
#include "data/formats/output.h"

/* The objects that the `target` of a request may name. */
enum observable_target {
    OBSERVABLE_OF_ALL,      /* nothing: the whole run */
    OBSERVABLE_OF_WALL,     /* a wall; "": every wall */
    OBSERVABLE_OF_PARTICLE, /* the particle `id`, called `label` in the columns ("ball" gives ball_z[m]) */
    OBSERVABLE_OF_REGION,   /* a region, or "": every region; a material after a slash counts that alone
                               ("zone/glass") */
    OBSERVABLE_OF_ALL_OR_REGION, /* a region in the same way, or "": the whole run */
    OBSERVABLE_OF_EXPRESSION,    /* `of` and `where` of the request */
    OBSERVABLE_OF_PLANE,         /* a plane; "": every plane */
    OBSERVABLE_OF_BODY           /* a wall, or a group of grains; "": every wall and every group */
};

/* A row of the registry, for help texts and docs. */
struct observable_info {
    const char *name;   /* "energy_kinetic" */
    const char *family; /* a name that stands for several rows ("energy"); "" if none */
    const char *unit;   /* as in a column's head: "J", "kg m/s", "1" */
    const char *help;
    enum observable_target target;
    int components;        /* columns without a selection: 1, 3 or 6, or as the row says */
    const char *unit_flat; /* where the box has two dimensions; NULL: the same */
};

int observables_count(void);
const struct observable_info *observables_get(int k);

struct observables;

/* Resolves the requests (unknown names, walls, regions, a particle without its id, two columns of one name, a
 * name of OUTPUT_NAME_MAX characters or more: a user's error that names the allowed values) and lays out the
 * columns. Every rank alike. `view` is borrowed for the call only. No file is touched. */
bool observables_create(struct observables **observables, const struct observables_options *options,
                        const struct output_view *view, const struct output_run *run, struct error *error);
void observables_destroy(struct observables **observables);

/* True if DIR/observables.csv has the header of these observables, or is not there or empty. Changes nothing; one rank. */
bool observables_suit(const struct observables *observables, const char *directory, struct error *error);

/* Opens DIR/observables.csv and writes the header; on a resume (`resume_time` >= 0) rows after that time are
 * cut off, and the header must be the same. Rank 0 handles the file; all ranks get the same result.
 * Collective. */
bool observables_open(struct observables *observables, const struct comm *comm, const char *directory,
                      double resume_time, struct error *error);

/* True if a column needs force_sums beyond contacts and overlap: the force evaluation before needs want_sums.
 */
bool observables_need_sums(const struct observables *observables);

/* True if a column shows dissipated energy: then every force evaluation needs want_sums, and the caller adds
 * up force_sums.taken. */
bool observables_need_work(const struct observables *observables);

/* Computes one row and, where opened, writes and flushes it. Collective. */
bool observables_write(struct observables *observables, const struct output_view *view, struct error *error);

/* Number of columns without the time, their names ("energy_kinetic", "ball_z"), units, and the values of the
 * last row (on every rank). */
int observables_columns(const struct observables *observables);
const char *observables_column_name(const struct observables *observables, int column);
const char *observables_column_unit(const struct observables *observables, int column);
const double *observables_values(const struct observables *observables);

/* The last row as h5md_add_observables wants it; borrows the arrays of observables. */
void observables_row(const struct observables *observables, const struct output_view *view,
                     struct h5md_observables *row);

#endif
