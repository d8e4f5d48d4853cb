/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes or reads the small parts: numbers by name, the division of the box, box, law, materials, groups, walls, and
 * the runs that led to this state. */
#include "data/formats/checkpoint_parts.h"
#include "data/formats/checkpoint_names.h"

#include "base/memory.h"

#include <assert.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The sums: each rank gets its own part, or rank 0 gets the total. */
static bool sums(struct checkpoint_io *io, int ranks, size_t count, void *value, struct error *error) {
    const char *name = checkpoint_value_datasets[RESTART_SUM];
    double *sum = value;
    if (io->written)
        return checkpoint_io_of_ranks(io, name, FIELD_DOUBLE, ranks, count, sum, error);
    double *all = memory_allocate_zero((size_t)ranks * count, sizeof *all, "sums of ranks");
    bool good = checkpoint_io_of_ranks(io, name, FIELD_DOUBLE, ranks, count, all, error);
    if (good && ranks == io->comm->size)
        memcpy(sum, all + (size_t)io->comm->rank * count, count * sizeof *sum);
    else if (good && io->comm->rank == 0)
        for (size_t k = 0; k < (size_t)ranks * count; k++)
            sum[k % count] += all[k];
    memory_free(all);
    return good;
}

/* The numbers of one kind: names and values. */
static bool kind_of_numbers(struct checkpoint_io *io, enum restart_kind kind, struct checkpoint_loaded *state,
                            struct error *error) {
    struct restart_values *values = &state->restart;
    const char *name = checkpoint_name_datasets[kind], *value = checkpoint_value_datasets[kind];
    size_t count = checkpoint_io_count(io, name, OUTPUT_NAME_MAX, values->count[kind]);
    if (count == 0)
        return true;
    if (io->written == NULL)
        restart_values_allocate(values, kind, count);
    if (!checkpoint_io_common(io, name, FIELD_UINT8, count, OUTPUT_NAME_MAX, values->name[kind], error))
        return false;
    if (kind == RESTART_SUM)
        return sums(io, state->ranks, count, values->value[kind], error);
    return checkpoint_io_common(io, value, kind == RESTART_INTEGER ? FIELD_INT64 : FIELD_DOUBLE, count, 0,
                                values->value[kind], error);
}

/* Takes the numbers that every checkpoint has from those that were read. */
static bool core_take(struct checkpoint_io *io, struct checkpoint_loaded *state, struct error *error) {
    struct checkpoint_core core = {0};
    struct restart list = {0};
    checkpoint_core_list(&core, &list);
    bool good = restart_take(&list, &state->restart, io->file.path, error);
    restart_free(&list);
    state->numbers = (struct checkpoint_numbers){.step = (uint64_t)core.step,
                                                 .time = core.time,
                                                 .dt = core.dt,
                                                 .seed = (uint64_t)core.seed,
                                                 .next_id = core.next_id};
    for (int d = 0; d < 3; d++)
        state->numbers.grid[d] = (int)core.grid[d];
    state->total = io->total = (uint64_t)core.particles;
    state->same_layout = core.ranks == io->comm->size;
    if (good && (core.ranks < 1 || core.ranks > INT_MAX || core.history_components < 0 ||
                 core.history_components > HISTORY_COMPONENTS_MAX))
        return error_set(error, ERROR_USER, "%s: /run/integers: holds impossible numbers", io->file.path);
    state->ranks = (int)core.ranks;
    state->history_components = (int)core.history_components;
    return good;
}

/* The numbers of particles of ranks; when read, this rank's share in them. */
static bool shares(struct checkpoint_io *io, const struct checkpoint_loaded *state, struct error *error) {
    static const char name[] = "/run/particles_of_ranks";
    int64_t mine = (int64_t)io->count;
    if (io->written)
        return checkpoint_io_of_ranks(io, name, FIELD_INT64, state->ranks, 0, &mine, error);
    uint64_t size = (uint64_t)io->comm->size, rank = (uint64_t)io->comm->rank;
    io->first = io->total / size * rank + (rank < io->total % size ? rank : io->total % size);
    io->count = io->total / size + (rank < io->total % size);
    if (!state->same_layout)
        return true;
    int64_t *owned = memory_allocate(size, sizeof *owned, "particles of ranks");
    bool good = checkpoint_io_of_ranks(io, name, FIELD_INT64, state->ranks, 0, owned, error);
    io->first = 0;
    for (uint64_t k = 0; good && k < rank; k++)
        io->first += (uint64_t)owned[k];
    io->count = good ? (uint64_t)owned[rank] : 0;
    memory_free(owned);
    if (good && io->first + io->count > io->total)
        error_set(error, ERROR_USER, "%s: %s: does not fit the number of particles", io->file.path, name);
    return comm_agree(io->comm, error);
}

static bool numbers(struct checkpoint_io *io, struct checkpoint_loaded *state, struct error *error) {
    return kind_of_numbers(io, RESTART_INTEGER, state, error) &&
           kind_of_numbers(io, RESTART_REAL, state, error) && (io->written || core_take(io, state, error)) &&
           kind_of_numbers(io, RESTART_SUM, state, error) && shares(io, state, error);
}

/* A double as an int; -1 if the double is negative or too large. */
static int small_integer(double x) {
    return x >= 0 && x <= INT_MAX ? (int)x : -1;
}

/* The division of the box by a bisection; it is read if there are as many ranks. */
static bool cuts(struct checkpoint_io *io, struct checkpoint_loaded *state, struct error *error) {
    static const double lowest[3] = {-INFINITY, -INFINITY, -INFINITY},
                        highest[3] = {INFINITY, INFINITY, INFINITY};
    bool there =
        io->written ? state->tree != NULL : state->same_layout && checkpoint_io_has(io, CHECKPOINT_CUTS);
    if (!there || state->ranks < 2)
        return true;
    size_t count = (size_t)state->ranks - 1;
    double(*row)[CHECKPOINT_CUT] = memory_allocate_zero(count, sizeof *row, "cuts of a bisection");
    for (size_t k = 0; io->written && k < count; k++) {
        row[k][0] = state->tree->cut[k].at;
        row[k][1] = state->tree->cut[k].middle;
        row[k][2] = state->tree->cut[k].axis;
    }
    bool good = checkpoint_io_common(io, CHECKPOINT_CUTS, FIELD_DOUBLE, count, CHECKPOINT_CUT, row, error);
    if (good && io->written == NULL) {
        struct domain_cut *cut = memory_allocate(count, sizeof *cut, "cuts of a bisection");
        for (size_t k = 0; k < count; k++)
            cut[k] = (struct domain_cut){row[k][0], small_integer(row[k][1]), small_integer(row[k][2])};
        state->tree = domain_tree_from_cuts(state->ranks, cut, lowest, highest);
        memory_free(cut);
        good = state->tree || error_set(error, ERROR_USER, "%s: %s: holds impossible numbers", io->file.path,
                                        CHECKPOINT_CUTS);
    }
    memory_free(row);
    return good;
}

static bool surroundings(struct checkpoint_io *io, struct checkpoint_loaded *state, struct error *error) {
    struct box *box = &state->box;
    double lengths[6];
    int32_t sides[CHECKPOINT_SIDES] = {box->dimension};
    for (int d = 0; d < 3; d++) {
        lengths[d] = box->origin[d];
        lengths[3 + d] = box->edge[d];
        sides[1 + d] = box->periodic[d];
        sides[4 + 2 * d] = (int32_t)box->leave[d][0];
        sides[5 + 2 * d] = (int32_t)box->leave[d][1];
    }
    if (!checkpoint_io_common(io, "/box/origin_edge", FIELD_DOUBLE, 6, 0, lengths, error) ||
        !checkpoint_io_common(io, "/box/sides", FIELD_INT32, CHECKPOINT_SIDES, 0, sides, error))
        return false;
    box->dimension = sides[0];
    for (int d = 0; d < 3; d++) {
        box->origin[d] = lengths[d];
        box->edge[d] = lengths[3 + d];
        box->periodic[d] = sides[1 + d] != 0;
        box->leave[d][0] = (enum box_leave)sides[4 + 2 * d];
        box->leave[d][1] = (enum box_leave)sides[5 + 2 * d];
    }
    return checkpoint_io_text(io, "/scene", &state->scene, error) &&
           checkpoint_io_text(io, "/law", &state->law, error);
}

/* A list of names. */
static bool names(struct checkpoint_io *io, const char *dataset, int count, struct checkpoint_kind *kind,
                  struct error *error) {
    char(*name)[OUTPUT_NAME_MAX] = memory_allocate_zero((size_t)count, sizeof *name, "names of a checkpoint");
    for (int k = 0; io->written && k < count; k++)
        memcpy(name[k], kind[k].name, sizeof name[k]);
    bool good = checkpoint_io_common(io, dataset, FIELD_UINT8, (uint64_t)count, OUTPUT_NAME_MAX, name, error);
    for (int k = 0; good && k < count; k++)
        memcpy(kind[k].name, name[k], OUTPUT_NAME_MAX - 1);
    memory_free(name);
    return good;
}

static bool materials_groups(struct checkpoint_io *io, struct checkpoint_loaded *state, struct error *error) {
    uint64_t materials =
        checkpoint_io_count(io, CHECKPOINT_MATERIALS, OUTPUT_NAME_MAX, (uint64_t)state->materials);
    uint64_t groups = checkpoint_io_count(io, CHECKPOINT_GROUPS, OUTPUT_NAME_MAX, (uint64_t)state->groups);
    double density[LAW_MATERIALS_MAX];
    if (materials > LAW_MATERIALS_MAX || groups > INTEGRATOR_GROUPS_MAX)
        return error_set(error, ERROR_USER, "%s: has more materials or groups than this version knows",
                         io->file.path);
    if (io->written == NULL) {
        state->materials = (int)materials;
        state->groups = (int)groups;
        state->material =
            memory_allocate_zero(materials, sizeof *state->material, "materials of a checkpoint");
        state->group = memory_allocate_zero(groups, sizeof *state->group, "groups of a checkpoint");
    }
    for (uint64_t k = 0; k < materials; k++)
        density[k] = state->material[k].density;
    bool good = names(io, CHECKPOINT_MATERIALS, state->materials, state->material, error) &&
                checkpoint_io_common(io, CHECKPOINT_DENSITIES, FIELD_DOUBLE, materials, 0, density, error) &&
                names(io, CHECKPOINT_GROUPS, state->groups, state->group, error);
    for (uint64_t k = 0; good && k < materials; k++)
        state->material[k].density = density[k];
    return good;
}

static bool walls(struct checkpoint_io *io, struct checkpoint_loaded *state, struct error *error) {
    static_assert(sizeof(struct wall_pose) == CHECKPOINT_POSE * sizeof(double), "a pose is doubles alone");
    uint64_t count = checkpoint_io_count(io, "/walls/name", WALL_NAME_MAX, (uint64_t)state->walls);
    if (count > WALLS_MAX)
        return error_set(error, ERROR_USER, "%s: has more walls than this version knows", io->file.path);
    if (io->written == NULL) {
        state->walls = (int)count;
        state->wall = memory_allocate_zero(count, sizeof *state->wall, "walls of a checkpoint");
    }
    double(*pose)[CHECKPOINT_POSE] = memory_allocate(count, sizeof *pose, "wall poses");
    char(*name)[WALL_NAME_MAX] = memory_allocate_zero(count, sizeof *name, "wall names");
    for (uint64_t k = 0; io->written && k < count; k++) {
        memcpy(pose[k], &state->wall[k].pose, sizeof pose[k]);
        memcpy(name[k], state->wall[k].name, sizeof name[k]);
    }
    bool good = checkpoint_io_common(io, "/walls/name", FIELD_UINT8, count, WALL_NAME_MAX, name, error) &&
                checkpoint_io_common(io, "/walls/pose", FIELD_DOUBLE, count, CHECKPOINT_POSE, pose, error);
    for (uint64_t k = 0; good && io->written == NULL && k < count; k++) {
        memcpy(&state->wall[k].pose, pose[k], sizeof state->wall[k].pose);
        if (io->comm->rank > 0) /* rank 0 holds sums over ranks */
            memset(state->wall[k].pose.force, 0, sizeof state->wall[k].pose.force);
        memcpy(state->wall[k].name, name[k], WALL_NAME_MAX - 1);
    }
    memory_free(pose);
    memory_free(name);
    return good;
}

/* The bytes of the texts of scenes, each ended by a zero. */
static uint64_t scenes_bytes(const struct lineage *lineage) {
    uint64_t bytes = 0;
    for (size_t k = 0; k < lineage->count; k++)
        bytes += strlen(lineage->run[k].scene) + 1;
    return bytes;
}

/* The lineage: steps, names of programs, and the texts of the scenes one after another. */
static bool runs(struct checkpoint_io *io, struct checkpoint_loaded *state, struct error *error) {
    struct lineage *lineage = &state->lineage;
    uint64_t count = checkpoint_io_count(io, CHECKPOINT_RUN_STEPS, sizeof(int64_t), lineage->count);
    uint64_t bytes = checkpoint_io_count(io, CHECKPOINT_RUN_SCENES, 1, scenes_bytes(lineage)), at = 0;
    int64_t *step = memory_allocate(count, sizeof *step, "runs of a state");
    char(*program)[2][OUTPUT_NAME_MAX] = memory_allocate_zero(count, sizeof *program, "runs of a state");
    char *text = memory_allocate_zero(bytes + 1, 1, "runs of a state");
    for (uint64_t k = 0; io->written && k < count; at += strlen(text + at) + 1, k++) {
        step[k] = (int64_t)lineage->run[k].step;
        snprintf(program[k][0], OUTPUT_NAME_MAX, "%s", lineage->run[k].version);
        snprintf(program[k][1], OUTPUT_NAME_MAX, "%s", lineage->run[k].revision);
        memcpy(text + at, lineage->run[k].scene, strlen(lineage->run[k].scene) + 1);
    }
    bool good = checkpoint_io_common(io, CHECKPOINT_RUN_STEPS, FIELD_INT64, count, 0, step, error) &&
                checkpoint_io_common(io, CHECKPOINT_RUN_PROGRAMS, FIELD_UINT8, count, 2 * OUTPUT_NAME_MAX,
                                     program, error) &&
                checkpoint_io_common(io, CHECKPOINT_RUN_SCENES, FIELD_UINT8, bytes, 0, text, error);
    for (uint64_t k = 0; good && io->written == NULL && k < count && at < bytes; k++) {
        program[k][0][OUTPUT_NAME_MAX - 1] = program[k][1][OUTPUT_NAME_MAX - 1] = '\0';
        lineage_add(lineage, (uint64_t)step[k], program[k][0], program[k][1], text + at);
        at += strlen(text + at) + 1;
    }
    memory_free(step);
    memory_free(program);
    memory_free(text);
    return good;
}

bool checkpoint_head(struct checkpoint_io *io, struct checkpoint_loaded *state, struct error *error) {
    return numbers(io, state, error) && cuts(io, state, error) && surroundings(io, state, error) &&
           materials_groups(io, state, error) && walls(io, state, error) && runs(io, state, error);
}
