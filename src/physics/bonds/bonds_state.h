/* SPDX-License-Identifier: BSD-3-Clause */
/* The state of the bonds of this rank, for the files of this folder. */
#ifndef SCREE_BONDS_BONDS_STATE_H
#define SCREE_BONDS_BONDS_STATE_H

#include "physics/bonds/bonds.h"
#include "engine/physics.h"
#include <stdio.h>

/* The end of a bond, a row of the table of broken bonds. */
struct bonds_event {
    uint64_t step;
    double time;
    int64_t id[2];
    double x[3]; /* the middle of the bond, box-relative */
    double tensile, shear;
    int32_t end; /* enum bond_end */
    int32_t unused;
};

struct bonds_events {
    size_t count, capacity;
    struct bonds_event *event;
};

/* What a row needs beside itself, until the next rebuild. */
struct bonds_link {
    uint32_t partner; /* number of the partner, owned or a copy; BONDS_NOBODY: it is not here */
    uint8_t lower;    /* the carrier has the lower id */
    uint8_t end;      /* enum bond_end: all others than WHOLE act no more */
    struct bond_section section;
};
#define BONDS_NOBODY UINT32_MAX

/* Sums of a thread over the bonds whose lower id it carries. */
struct bonds_sums {
    double stored, taken;
    double broken[BOND_ENDS];
    struct bonds_events events;
};

struct bonds {
    const struct bonds_options *options;
    const struct physics_context *context;
    struct history_rows rows;
    struct bonds_link *link; /* one a row */
    size_t links;            /* allocated */
    struct bonds_sums *sums; /* a thread each */
    double stored, taken; /* this rank's part: energy in the bonds now; taken by dampers and broken bonds */
    double broken[BOND_ENDS];
    struct bonds_events events; /* not written yet */
    int64_t made;               /* 1: the bonds have been made */
    uint64_t made_step;
    struct error error;
    char path[FILE_PATH_MAX]; /* of the table of broken bonds; "": no files */
    FILE *file;               /* rank 0 */
};

/* bonds_links.c: the first entry that fits two particles of these materials and groups; -1: none. */
int bonds_entry_of(const struct bonds_options *options, const int material[2], const int group[2]);

/* The section of the bond of two particles by an entry. */
struct bond_section bonds_section(const struct bonds *bonds, int entry, uint32_t i, uint32_t j);

/* Compacts the rows (those that ended leave) before a rebuild, and finds the partners of all after it. */
void bonds_compact(struct bonds *bonds);
void bonds_link_all(struct bonds *bonds);

/* bonds_act.c: the bonds of the particles of a thread. */
void bonds_act(const struct physics_context *context, int thread);

/* make.c: makes the bonds, with errors in bonds->error. Collective. bonds_list_good reads the list alone, for
 * its mistakes. */
void bonds_make(struct bonds *bonds);
bool bonds_list_good(const char *path, struct error *error);

/* bonds_table.c: the table of broken bonds. */
void bonds_events_add(struct bonds_events *events, const struct bonds_event *event);
bool bonds_table_open(const struct physics_context *context, const char *directory, int64_t step,
                      struct error *error);
bool bonds_table_write(const struct physics_context *context, struct error *error);

/* bonds_fields.c: number of bonds of each particle, and its group, which copies know too; NULL without bonds. */
double *bonds_numbers(const struct particles *particles);
uint8_t *bonds_groups(const struct particles *particles);

#endif
