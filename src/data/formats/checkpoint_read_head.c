/* SPDX-License-Identifier: BSD-3-Clause */
/* Reads the small parts: the counterpart of checkpoint_head.c. */
#include "data/formats/checkpoint_read_head.h"
#include "data/formats/checkpoint_names.h"

#include "base/memory.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

bool checkpoint_get_common(struct checkpoint_reading *r, const char *name, enum field_type type,
                           uint64_t rows, uint64_t width, void *data, struct error *error) {
    size_t row_bytes = checkpoint_type_bytes(type) * (width ? width : 1);
    return checkpoint_file_read_common(&r->file, name, row_bytes, rows, data, error);
}

/* The number of rows of a dataset with `row_bytes` bytes a row; 0 without such a dataset. */
static uint64_t rows_of(const struct checkpoint_reading *r, const char *name, size_t row_bytes) {
    const struct checkpoint_entry *entry = checkpoint_file_find(&r->file, name);
    return entry ? entry->bytes / row_bytes : 0;
}

/* A text that every rank reads; memory_free. NULL on failure. */
static char *get_text(struct checkpoint_reading *r, const char *name, struct error *error) {
    const struct checkpoint_entry *entry = checkpoint_file_find(&r->file, name);
    uint64_t length = entry ? entry->bytes : 0;
    char *text = memory_allocate_zero(length + 1, 1, "text of a file");
    if (checkpoint_file_read_common(&r->file, name, length, 1, text, error))
        return text;
    memory_free(text);
    return NULL;
}

/* Reads the sums: each rank gets its own part, or rank 0 gets the total. */
static bool get_sums(struct checkpoint_reading *r, uint64_t ranks, size_t count, double *sum,
                     struct error *error) {
    double *all = memory_allocate_zero(ranks * count, sizeof *all, "sums of ranks");
    bool good = checkpoint_get_common(r, checkpoint_value_datasets[RESTART_SUM], FIELD_DOUBLE, ranks, count,
                                      all, error);
    uint64_t rank = (uint64_t)r->comm->rank;
    if (good && ranks == (uint64_t)r->comm->size)
        memcpy(sum, all + rank * count, count * sizeof *sum);
    else if (good && rank == 0)
        for (uint64_t k = 0; k < ranks * count; k++)
            sum[k % count] += all[k];
    memory_free(all);
    return good;
}

static bool get_kind(struct checkpoint_reading *r, enum restart_kind kind, struct error *error) {
    struct restart_values *values = &r->loaded->restart;
    enum field_type type = kind == RESTART_INTEGER ? FIELD_INT64 : FIELD_DOUBLE;
    size_t count = rows_of(r, checkpoint_name_datasets[kind], OUTPUT_NAME_MAX);
    if (count == 0)
        return true;
    values->count[kind] = count;
    values->name[kind] = memory_allocate(count, sizeof *values->name[kind], "restart numbers");
    values->value[kind] = memory_allocate_zero(count, sizeof *values->value[kind], "restart numbers");
    if (!checkpoint_get_common(r, checkpoint_name_datasets[kind], FIELD_UINT8, count, OUTPUT_NAME_MAX,
                               values->name[kind], error))
        return false;
    if (kind != RESTART_SUM)
        return checkpoint_get_common(r, checkpoint_value_datasets[kind], type, count, 0, values->value[kind],
                                     error);
    double *sum = memory_allocate_zero(count, sizeof *sum, "sums");
    bool good = get_sums(r, (uint64_t)r->loaded->ranks, count, sum, error);
    memcpy(values->value[kind], sum, count * sizeof *sum);
    memory_free(sum);
    return good;
}

/* Reads the numbers that every checkpoint has. */
static bool get_core(struct checkpoint_reading *r, struct error *error) {
    struct checkpoint_loaded *l = r->loaded;
    struct checkpoint_core core = {0};
    struct restart list = {0};
    checkpoint_core_list(&core, &list);
    bool good = restart_take(&list, &l->restart, r->file.path, error);
    restart_free(&list);
    l->numbers = (struct checkpoint_numbers){.step = (uint64_t)core.step,
                                             .time = core.time,
                                             .dt = core.dt,
                                             .seed = (uint64_t)core.seed,
                                             .next_id = core.next_id};
    for (int d = 0; d < 3; d++)
        l->numbers.grid[d] = (int)core.grid[d];
    l->total = (uint64_t)core.particles;
    l->same_layout = core.ranks == r->comm->size;
    if (good && (core.ranks < 1 || core.ranks > INT_MAX || core.history_components < 0 ||
                 core.history_components > HISTORY_COMPONENTS_MAX))
        return error_set(error, ERROR_USER, "%s: /run/integers: holds impossible numbers", r->file.path);
    l->ranks = (int)core.ranks;
    l->history_components = (int)core.history_components;
    return good;
}

static bool get_numbers(struct checkpoint_reading *r, struct error *error) {
    return get_kind(r, RESTART_INTEGER, error) && get_kind(r, RESTART_REAL, error) && get_core(r, error) &&
           get_kind(r, RESTART_SUM, error);
}

/* A double as an int; -1 if the double is negative or too large. */
static int small_integer(double x) {
    return x >= 0 && x <= INT_MAX ? (int)x : -1;
}

/* Reads the division of the box, if the box was divided by a bisection among as many ranks. */
static bool get_tree(struct checkpoint_reading *r, struct error *error) {
    static const double lowest[3] = {-INFINITY, -INFINITY, -INFINITY},
                        highest[3] = {INFINITY, INFINITY, INFINITY};
    int ranks = r->loaded->ranks;
    if (!r->loaded->same_layout || ranks < 2 || !checkpoint_file_find(&r->file, CHECKPOINT_CUTS))
        return true;
    size_t cuts = (size_t)ranks - 1;
    double(*row)[CHECKPOINT_CUT] = memory_allocate_zero(cuts, sizeof *row, "cuts of a bisection");
    struct domain_cut *cut = memory_allocate(cuts, sizeof *cut, "cuts of a bisection");
    bool good = checkpoint_get_common(r, CHECKPOINT_CUTS, FIELD_DOUBLE, cuts, CHECKPOINT_CUT, row, error);
    for (size_t k = 0; k < cuts; k++)
        cut[k] = (struct domain_cut){row[k][0], small_integer(row[k][1]), small_integer(row[k][2])};
    if (good && !(r->loaded->tree = domain_tree_from_cuts(ranks, cut, lowest, highest)))
        good =
            error_set(error, ERROR_USER, "%s: %s: holds impossible numbers", r->file.path, CHECKPOINT_CUTS);
    memory_free(row);
    memory_free(cut);
    return good;
}

static bool get_surroundings(struct checkpoint_reading *r, struct error *error) {
    struct checkpoint_loaded *l = r->loaded;
    double lengths[6];
    int32_t sides[CHECKPOINT_SIDES];
    if (!checkpoint_get_common(r, "/box/origin_edge", FIELD_DOUBLE, 6, 0, lengths, error) ||
        !checkpoint_get_common(r, "/box/sides", FIELD_INT32, CHECKPOINT_SIDES, 0, sides, error))
        return false;
    l->box.dimension = sides[0];
    for (int d = 0; d < 3; d++) {
        l->box.origin[d] = lengths[d];
        l->box.edge[d] = lengths[3 + d];
        l->box.periodic[d] = sides[1 + d] != 0;
        l->box.leave[d][0] = (enum box_leave)sides[4 + 2 * d];
        l->box.leave[d][1] = (enum box_leave)sides[5 + 2 * d];
    }
    l->scene = get_text(r, "/scene", error);
    l->law = l->scene ? get_text(r, "/law", error) : NULL;
    return l->law != NULL;
}

/* Reads a list of `count` names. */
static bool get_names(struct checkpoint_reading *r, const char *dataset, uint64_t count,
                      struct checkpoint_kind *kind, struct error *error) {
    char(*name)[OUTPUT_NAME_MAX] = memory_allocate(count, sizeof *name, "names of a checkpoint");
    bool good = checkpoint_get_common(r, dataset, FIELD_UINT8, count, OUTPUT_NAME_MAX, name, error);
    for (uint64_t k = 0; good && k < count; k++)
        memcpy(kind[k].name, name[k], OUTPUT_NAME_MAX - 1);
    memory_free(name);
    return good;
}

static bool get_materials_groups(struct checkpoint_reading *r, struct error *error) {
    struct checkpoint_loaded *l = r->loaded;
    uint64_t materials = rows_of(r, CHECKPOINT_MATERIALS, OUTPUT_NAME_MAX);
    uint64_t groups = rows_of(r, CHECKPOINT_GROUPS, OUTPUT_NAME_MAX);
    if (materials > LAW_MATERIALS_MAX || groups > INTEGRATOR_GROUPS_MAX)
        return error_set(error, ERROR_USER, "%s: has more materials or groups than this version knows",
                         r->file.path);
    l->materials = (int)materials;
    l->groups = (int)groups;
    l->material = memory_allocate_zero(materials, sizeof *l->material, "materials of a checkpoint");
    l->group = memory_allocate_zero(groups, sizeof *l->group, "groups of a checkpoint");
    double density[LAW_MATERIALS_MAX];
    bool good = get_names(r, CHECKPOINT_MATERIALS, materials, l->material, error) &&
                checkpoint_get_common(r, CHECKPOINT_DENSITIES, FIELD_DOUBLE, materials, 0, density, error) &&
                get_names(r, CHECKPOINT_GROUPS, groups, l->group, error);
    for (uint64_t k = 0; good && k < materials; k++)
        l->material[k].density = density[k];
    return good;
}

static bool get_walls(struct checkpoint_reading *r, struct error *error) {
    struct checkpoint_loaded *l = r->loaded;
    uint64_t count = rows_of(r, "/walls/name", WALL_NAME_MAX);
    if (count > WALLS_MAX)
        return error_set(error, ERROR_USER, "%s: has more walls than this version knows", r->file.path);
    l->walls = (int)count;
    l->wall = memory_allocate_zero(count, sizeof *l->wall, "walls of a checkpoint");
    double(*pose)[CHECKPOINT_POSE] = memory_allocate(count, sizeof *pose, "wall poses");
    char(*name)[WALL_NAME_MAX] = memory_allocate(count, sizeof *name, "wall names");
    bool good = checkpoint_get_common(r, "/walls/pose", FIELD_DOUBLE, count, CHECKPOINT_POSE, pose, error) &&
                checkpoint_get_common(r, "/walls/name", FIELD_UINT8, count, WALL_NAME_MAX, name, error);
    for (uint64_t k = 0; good && k < count; k++) {
        memcpy(&l->wall[k].pose, pose[k], sizeof l->wall[k].pose);
        if (r->comm->rank > 0) /* rank 0 holds sums over ranks */
            memset(l->wall[k].pose.force, 0, sizeof l->wall[k].pose.force);
        memcpy(l->wall[k].name, name[k], WALL_NAME_MAX - 1);
    }
    memory_free(pose);
    memory_free(name);
    return good;
}

static bool get_lineage(struct checkpoint_reading *r, struct error *error) {
    uint64_t count = rows_of(r, CHECKPOINT_RUN_STEPS, sizeof(int64_t));
    uint64_t bytes = rows_of(r, CHECKPOINT_RUN_SCENES, 1), at = 0;
    int64_t *step = memory_allocate(count, sizeof *step, "runs of a state");
    char(*program)[2][OUTPUT_NAME_MAX] = memory_allocate(count, sizeof *program, "runs of a state");
    char *text = memory_allocate_zero(bytes + 1, 1, "runs of a state");
    bool good = checkpoint_get_common(r, CHECKPOINT_RUN_STEPS, FIELD_INT64, count, 0, step, error) &&
                checkpoint_get_common(r, CHECKPOINT_RUN_PROGRAMS, FIELD_UINT8, count, 2 * OUTPUT_NAME_MAX,
                                      program, error) &&
                checkpoint_get_common(r, CHECKPOINT_RUN_SCENES, FIELD_UINT8, bytes, 0, text, error);
    for (uint64_t k = 0; good && k < count && at < bytes; k++) {
        program[k][0][OUTPUT_NAME_MAX - 1] = program[k][1][OUTPUT_NAME_MAX - 1] = '\0';
        lineage_add(&r->loaded->lineage, (uint64_t)step[k], program[k][0], program[k][1], text + at);
        at += strlen(text + at) + 1;
    }
    memory_free(step);
    memory_free(program);
    memory_free(text);
    return good;
}

bool checkpoint_get_head(struct checkpoint_reading *r, struct error *error) {
    return get_numbers(r, error) && get_tree(r, error) && get_surroundings(r, error) &&
           get_materials_groups(r, error) && get_walls(r, error) && get_lineage(r, error);
}
