/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes the small parts: numbers by name, the division of the box, box, law, materials, groups, walls, and
 * the runs that led to this state. */
#include "data/formats/checkpoint_head.h"
#include "data/formats/checkpoint_names.h"

#include "base/memory.h"

#include <assert.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

/* Writes the numbers of one kind: names and values; the values of sums in one row for each rank. */
static bool put_kind(struct checkpoint_writing *w, const struct restart *restart, enum restart_kind kind,
                     struct error *error) {
    size_t count = restart_count(restart, kind);
    enum field_type type = kind == RESTART_INTEGER ? FIELD_INT64 : FIELD_DOUBLE;
    if (count == 0)
        return true;
    char(*name)[OUTPUT_NAME_MAX] = memory_allocate_zero(count, sizeof *name, "restart numbers");
    uint64_t *value = memory_allocate_zero(count, sizeof *value, "restart numbers");
    restart_pack(restart, kind, name, value);
    bool good = checkpoint_put_common(w, checkpoint_name_datasets[kind], FIELD_UINT8, count, OUTPUT_NAME_MAX,
                                      name, error);
    if (good && kind == RESTART_SUM)
        good = checkpoint_put_of_ranks(w, checkpoint_value_datasets[kind], type, count, value, error);
    else if (good)
        good = checkpoint_put_common(w, checkpoint_value_datasets[kind], type, count, 0, value, error);
    memory_free(name);
    memory_free(value);
    return good;
}

static bool put_numbers(struct checkpoint_writing *w, struct error *error) {
    const struct checkpoint *c = w->checkpoint;
    const struct checkpoint_numbers *n = &c->numbers;
    struct restart all = {0};
    struct checkpoint_core core = {.step = (int64_t)n->step,
                                   .seed = (int64_t)n->seed,
                                   .next_id = n->next_id,
                                   .ranks = w->comm->size,
                                   .history_components = c->history_components,
                                   .particles = (int64_t)w->total,
                                   .grid = {n->grid[0], n->grid[1], n->grid[2]},
                                   .time = n->time,
                                   .dt = n->dt};
    int64_t owned = (int64_t)c->particles->owned;
    checkpoint_core_list(&core, &all);
    for (size_t k = 0; c->restart && k < c->restart->count; k++) {
        const struct restart_number *row = &c->restart->row[k];
        restart_add(&all, row->kind, row->optional, row->value, "%s", row->name);
    }
    bool good = true;
    for (int kind = 0; good && kind < RESTART_KINDS; kind++)
        good = put_kind(w, &all, (enum restart_kind)kind, error);
    restart_free(&all);
    return good && checkpoint_put_of_ranks(w, "/run/particles_of_ranks", FIELD_INT64, 0, &owned, error);
}

static bool put_tree(struct checkpoint_writing *w, struct error *error) {
    const struct domain_tree *tree = w->checkpoint->tree;
    if (tree == NULL || tree->ranks < 2)
        return true;
    uint64_t cuts = (uint64_t)tree->ranks - 1;
    double(*row)[CHECKPOINT_CUT] = memory_allocate(cuts, sizeof *row, "cuts of a bisection");
    for (uint64_t k = 0; k < cuts; k++) {
        row[k][0] = tree->cut[k].at;
        row[k][1] = tree->cut[k].middle;
        row[k][2] = tree->cut[k].axis;
    }
    bool good = checkpoint_put_common(w, CHECKPOINT_CUTS, FIELD_DOUBLE, cuts, CHECKPOINT_CUT, row, error);
    memory_free(row);
    return good;
}

/* Writes a string by HDF5, on all ranks. */
static bool put_text(struct checkpoint_writing *w, const char *name, const char *text, struct error *error) {
    struct h5_table row = {.rows = 1, .count = w->comm->rank == 0, .first = w->comm->rank > 0};
    return h5_write_string(&w->h5, name, text, error) &&
           checkpoint_enter(w, name, &row, strlen(text) + 1, text, error);
}

static bool put_surroundings(struct checkpoint_writing *w, struct error *error) {
    const struct checkpoint *c = w->checkpoint;
    double lengths[6];
    int32_t sides[CHECKPOINT_SIDES] = {c->box->dimension};
    for (int d = 0; d < 3; d++) {
        lengths[d] = c->box->origin[d];
        lengths[3 + d] = c->box->edge[d];
        sides[1 + d] = c->box->periodic[d];
        sides[4 + 2 * d] = (int32_t)c->box->leave[d][0];
        sides[5 + 2 * d] = (int32_t)c->box->leave[d][1];
    }
    return checkpoint_put_common(w, "/box/origin_edge", FIELD_DOUBLE, 6, 0, lengths, error) &&
           checkpoint_put_common(w, "/box/sides", FIELD_INT32, CHECKPOINT_SIDES, 0, sides, error) &&
           put_text(w, "/scene", c->scene, error) && put_text(w, "/law", c->law, error);
}

static bool put_names(struct checkpoint_writing *w, struct error *error) {
    const struct checkpoint *c = w->checkpoint;
    char material[LAW_MATERIALS_MAX][OUTPUT_NAME_MAX] = {{0}};
    double density[LAW_MATERIALS_MAX];
    for (int k = 0; k < c->materials; k++) {
        snprintf(material[k], sizeof material[k], "%s", c->material[k].name);
        density[k] = c->material[k].density;
    }
    char group[INTEGRATOR_GROUPS_MAX][OUTPUT_NAME_MAX] = {{0}};
    for (int k = 0; k < c->groups; k++)
        snprintf(group[k], sizeof group[k], "%s", c->group[k]);
    uint64_t materials = (uint64_t)c->materials, groups = (uint64_t)c->groups;
    return checkpoint_put_common(w, CHECKPOINT_MATERIALS, FIELD_UINT8, materials, OUTPUT_NAME_MAX, material,
                                 error) &&
           checkpoint_put_common(w, CHECKPOINT_DENSITIES, FIELD_DOUBLE, materials, 0, density, error) &&
           checkpoint_put_common(w, CHECKPOINT_GROUPS, FIELD_UINT8, groups, OUTPUT_NAME_MAX, group, error);
}

static bool put_walls(struct checkpoint_writing *w, struct error *error) {
    static_assert(sizeof(struct wall_pose) == CHECKPOINT_POSE * sizeof(double), "a pose is doubles alone");
    const struct walls *walls = w->checkpoint->walls;
    uint64_t count = walls ? (uint64_t)walls_count(walls) : 0;
    double(*pose)[CHECKPOINT_POSE] = memory_allocate_zero(count, sizeof *pose, "wall poses");
    char(*name)[WALL_NAME_MAX] = memory_allocate_zero(count, sizeof *name, "wall names");
    for (uint64_t k = 0; k < count; k++) {
        struct wall_pose now;
        walls_pose(walls, (int)k, &now);
        comm_sum(w->comm, now.force, 6);
        memcpy(pose[k], &now, sizeof now);
        snprintf(name[k], sizeof name[k], "%s", walls_options(walls, (int)k)->name);
    }
    bool good = checkpoint_put_common(w, "/walls/name", FIELD_UINT8, count, WALL_NAME_MAX, name, error) &&
                checkpoint_put_common(w, "/walls/pose", FIELD_DOUBLE, count, CHECKPOINT_POSE, pose, error);
    memory_free(pose);
    memory_free(name);
    return good;
}

/* Writes the lineage: steps, names of programs, and the texts of the scenes one after another, each ended by
 * a zero. */
static bool put_lineage(struct checkpoint_writing *w, struct error *error) {
    const struct lineage *lineage = w->checkpoint->lineage;
    size_t count = lineage ? lineage->count : 0, bytes = 0, at = 0;
    int64_t *step = memory_allocate(count, sizeof *step, "runs of a state");
    char(*program)[2][OUTPUT_NAME_MAX] = memory_allocate_zero(count, sizeof *program, "runs of a state");
    for (size_t k = 0; k < count; k++)
        bytes += strlen(lineage->run[k].scene) + 1;
    char *text = memory_allocate(bytes, 1, "runs of a state");
    for (size_t k = 0; k < count; k++) {
        const struct lineage_run *run = &lineage->run[k];
        step[k] = (int64_t)run->step;
        snprintf(program[k][0], OUTPUT_NAME_MAX, "%s", run->version);
        snprintf(program[k][1], OUTPUT_NAME_MAX, "%s", run->revision);
        memcpy(text + at, run->scene, strlen(run->scene) + 1);
        at += strlen(run->scene) + 1;
    }
    bool good = checkpoint_put_common(w, CHECKPOINT_RUN_STEPS, FIELD_INT64, count, 0, step, error) &&
                checkpoint_put_common(w, CHECKPOINT_RUN_PROGRAMS, FIELD_UINT8, count, 2 * OUTPUT_NAME_MAX,
                                      program, error) &&
                checkpoint_put_common(w, CHECKPOINT_RUN_SCENES, FIELD_UINT8, bytes, 0, text, error);
    memory_free(step);
    memory_free(program);
    memory_free(text);
    return good;
}

bool checkpoint_put_head(struct checkpoint_writing *w, struct error *error) {
    return put_numbers(w, error) && put_tree(w, error) && put_surroundings(w, error) && put_names(w, error) &&
           put_walls(w, error) && put_lineage(w, error);
}
