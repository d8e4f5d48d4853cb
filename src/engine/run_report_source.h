/* SPDX-License-Identifier: BSD-3-Clause */
/* Private part of run_report.h: what the getters of rows read, and how they are written; the rows of lists and groups. */
#ifndef SCREE_ENGINE_RUN_REPORT_SOURCE_H
#define SCREE_ENGINE_RUN_REPORT_SOURCE_H

#include "engine/report_part.h"
#include "engine/run_record.h"
#include "engine/run_stages.h"
#include "engine/state.h"
#include "data/observe/report.h"

struct report_source {
    const struct simulation *s;
    const struct run_record *run;
    const struct run_chain *chain; /* NULL: the scene has no stages */
    struct ghosts_counts ghosts;
    struct index_description index;
    struct report_part part;
    double seconds;               /* of the loop of steps, this rank */
    uint64_t memory, memory_most; /* counted bytes of this rank: now, at most */
};

/* A getter by its value, an expression of `of`, the source, and of `k`, the number of the entry. */
#define RUN_REPORT_GETTER(type, name, value)                                                                 \
    static type name(const struct report_source *of, int k) {                                                \
        (void)of;                                                                                            \
        (void)k;                                                                                             \
        return (type)(value);                                                                                \
    }
#define COUNT(name, value) RUN_REPORT_GETTER(uint64_t, name, value)
#define REAL(name, value) RUN_REPORT_GETTER(double, name, value)
#define FLAG(name, value) RUN_REPORT_GETTER(bool, name, value)

/* The same of a text, which may be written into `buffer`. */
#define TEXT(name, value)                                                                                    \
    static const char *name(const struct report_source *of, int k, char *buffer, size_t room) {              \
        (void)of;                                                                                            \
        (void)k;                                                                                             \
        (void)buffer;                                                                                        \
        (void)room;                                                                                          \
        return value;                                                                                        \
    }

/* Of values of the ranks: the sum, the most, the least. Collective. */
static inline uint64_t count_all(const struct report_source *of, uint64_t mine) {
    int64_t sum = (int64_t)mine;
    comm_sum_int(of->s->comm, &sum, 1);
    return (uint64_t)sum;
}

static inline double sum_all(const struct report_source *of, double mine) {
    comm_sum(of->s->comm, &mine, 1);
    return mine;
}

static inline double most(const struct report_source *of, double mine) {
    comm_max(of->s->comm, &mine, 1);
    return mine;
}

static inline double least(const struct report_source *of, double mine) {
    comm_min(of->s->comm, &mine, 1);
    return mine;
}

/* The rows of lists and groups, and the numbers of their entries. */

extern const struct report_row run_report_choice_rows[], run_report_level_rows[], run_report_class_rows[],
    run_report_insertion_rows[], run_report_scene_stage_rows[], run_report_stage_rows[],
    run_report_setup_rows[], run_report_solver_rows[], run_report_contacts_rows[];

int run_report_choices(const struct report_source *source);
int run_report_levels(const struct report_source *source);
int run_report_classes(const struct report_source *source);
int run_report_insertions(const struct report_source *source);
int run_report_scene_stages(const struct report_source *source);
int run_report_stages(const struct report_source *source);
int run_report_solvers(const struct report_source *source);
int run_report_contacts(const struct report_source *source);

#endif
