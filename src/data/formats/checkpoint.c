/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes and reads checkpoints: opens the file, and hands it to their parts (checkpoint_parts.h). The checksum of a dataset
 * that is written comes from memory. Then the closed file is compared with the checksums, so only a whole file is renamed.
 * What is read agrees with the table of the file; the shape of each dataset is still checked, as the file may come from a
 * different program. */
#include "data/formats/checkpoint.h"
#include "data/formats/checkpoint_parts.h"
#include "data/formats/checkpoint_names.h"

#include "base/memory.h"
#include "base/file.h"

#include <inttypes.h>
#include <string.h>
#include <unistd.h>

/* The bytes of the file to be written, with some spare. */
static uint64_t estimate_bytes(const struct checkpoint_io *io) {
    const struct checkpoint *c = io->written;
    uint64_t rows = (c->history ? c->history->count : 0) + (c->wall_history ? c->wall_history->count : 0);
    uint64_t carried = 0;
    for (int k = 0; c->carried && k < PHYSICS_COUNT; k++)
        if (c->carried[k])
            carried += c->carried[k]->count * 8 * (checkpoint_history_width(c->carried[k]->components) + 4);
    const struct field_list fields = fields_with(c->particles, FIELD_RESTART);
    uint64_t each = fields_packed_bytes(c->particles, &fields) + 8;
    each += c->motion ? checkpoint_full_width(c->particles) * sizeof(double) : 0;
    int64_t bytes = (int64_t)(c->particles->owned * each + carried +
                              rows * 8 * (checkpoint_history_width(c->history_components) + 4));
    comm_sum_int(io->comm, &bytes, 1);
    uint64_t ranks = (uint64_t)io->comm->size, walls = c->walls ? (uint64_t)walls_count(c->walls) : 0;
    uint64_t numbers = c->restart ? c->restart->count : 0, texts = 0;
    uint64_t of_ranks = ranks * (numbers + CHECKPOINT_CUT + 1) * sizeof(double);
    for (size_t k = 0; c->lineage && k < c->lineage->count; k++)
        texts += strlen(c->lineage->run[k].scene) + 1;
    uint64_t of_walls = walls * (CHECKPOINT_POSE * sizeof(double) + WALL_NAME_MAX);
    return (uint64_t)bytes + of_ranks + of_walls + strlen(c->scene) + texts + numbers * OUTPUT_NAME_MAX +
           (1 << 16);
}

/* Lists the numbers by name. */
static void numbers_list(const struct checkpoint_io *io, struct checkpoint_loaded *state) {
    const struct checkpoint *c = io->written;
    const struct checkpoint_numbers *n = &c->numbers;
    struct restart all = {0};
    struct checkpoint_core core = {.step = (int64_t)n->step,
                                   .seed = (int64_t)n->seed,
                                   .next_id = n->next_id,
                                   .ranks = io->comm->size,
                                   .history_components = c->history_components,
                                   .particles = (int64_t)io->total,
                                   .grid = {n->grid[0], n->grid[1], n->grid[2]},
                                   .time = n->time,
                                   .dt = n->dt};
    checkpoint_core_list(&core, &all);
    for (size_t k = 0; c->restart && k < c->restart->count; k++) {
        const struct restart_number *row = &c->restart->row[k];
        restart_add(&all, row->kind, row->optional, row->value, "%s", row->name);
    }
    restart_pack(&all, &state->restart);
    restart_free(&all);
}

/* Names and poses of walls; forces are sums over ranks. */
static void walls_list(const struct checkpoint_io *io, struct checkpoint_loaded *state) {
    const struct walls *walls = io->written->walls;
    state->walls = walls ? walls_count(walls) : 0;
    state->wall = memory_allocate_zero((size_t)state->walls, sizeof *state->wall, "walls of a checkpoint");
    for (int k = 0; k < state->walls; k++) {
        walls_pose(walls, k, &state->wall[k].pose);
        comm_sum(io->comm, state->wall[k].pose.force, 6);
        snprintf(state->wall[k].name, WALL_NAME_MAX, "%s", walls_options(walls, k)->name);
    }
}

static struct checkpoint_kind *kinds_list(int count) {
    return memory_allocate_zero((size_t)count, sizeof(struct checkpoint_kind), "kinds of a checkpoint");
}

/* The state to write, in the form in which it is read; state_free releases. */
static void state_list(const struct checkpoint_io *io, struct checkpoint_loaded *state) {
    const struct checkpoint *c = io->written;
    *state = (struct checkpoint_loaded){.box = *c->box,
                                        .tree = (struct domain_tree *)c->tree,
                                        .ranks = io->comm->size,
                                        .history_components = c->history_components,
                                        .materials = c->materials,
                                        .material = kinds_list(c->materials),
                                        .groups = c->groups,
                                        .group = kinds_list(c->groups),
                                        .scene = (char *)c->scene,
                                        .law = (char *)c->law};
    if (c->history)
        state->history = *c->history;
    if (c->wall_history)
        state->wall_history = *c->wall_history;
    if (c->lineage)
        state->lineage = *c->lineage;
    for (int k = 0; c->carried && k < PHYSICS_COUNT; k++)
        if (c->carried[k])
            state->carried[k] = *c->carried[k];
    for (int k = 0; k < c->materials; k++) {
        snprintf(state->material[k].name, OUTPUT_NAME_MAX, "%s", c->material[k].name);
        state->material[k].density = c->material[k].density;
    }
    for (int k = 0; k < c->groups; k++)
        snprintf(state->group[k].name, OUTPUT_NAME_MAX, "%s", c->group[k]);
    numbers_list(io, state);
    walls_list(io, state);
}

static void state_free(struct checkpoint_loaded *state) {
    restart_values_free(&state->restart);
    memory_free(state->material);
    memory_free(state->group);
    memory_free(state->wall);
}

static bool put_all(struct checkpoint_io *io, struct error *error) {
    struct checkpoint_loaded state;
    state_list(io, &state);
    bool good = checkpoint_head(io, &state, error) &&
                checkpoint_rows(io, (struct particles *)io->written->particles, &state, error);
    state_free(&state);
    return good;
}

/* Writes all data to the temporary file and compares the bytes of the file with the checksums. */
static bool write_file(struct checkpoint_io *io, const char *temporary, uint64_t bytes, struct error *error) {
    if (!h5_create(&io->h5, temporary, io->comm, CHECKPOINT_BLOCK, error))
        return false;
    if (io->comm->rank == 0)
        file_reserve(temporary, bytes, error);
    bool good = comm_agree(io->comm, error) && put_all(io, error);
    good = h5_close(&io->h5, error) && good;
    return good && checkpoint_table_write(&io->file.table, io->comm, temporary, error) &&
           checkpoint_verify(io->comm, temporary, error);
}

bool checkpoint_write(const struct comm *comm, const char *directory, const char *suffix,
                      const struct checkpoint *checkpoint, int keep, struct error *error) {
    struct checkpoint_io io = {
        .comm = comm, .written = checkpoint, .h5 = {.file = -1}, .file = {.handle = -1}};
    int64_t total = (int64_t)checkpoint->particles->owned;
    io.count = checkpoint->particles->owned;
    io.first = (uint64_t)comm_scan(comm, total);
    comm_sum_int(comm, &total, 1);
    io.total = (uint64_t)total;
    char name[OUTPUT_NAME_MAX], path[FILE_PATH_MAX], temporary[FILE_PATH_MAX + 8];
    snprintf(name, sizeof name, "checkpoint-%" PRIu64 "%.20s.h5", checkpoint->numbers.step, suffix);
    uint64_t bytes = estimate_bytes(&io);
    if (file_join(path, directory, name, error) && comm->rank == 0)
        file_check_room(path, 0, bytes, error);
    if (!comm_agree(comm, error))
        return false;
    snprintf(temporary, sizeof temporary, "%s.part", path);
    bool good = write_file(&io, temporary, bytes, error);
    if (good && comm->rank == 0 && file_settle(temporary, path, error) && keep > 0 && suffix[0] == '\0')
        checkpoint_delete_old(directory, checkpoint->numbers.step, keep);
    good = comm_agree(comm, error);
    if (!good && comm->rank == 0)
        unlink(temporary);
    return good;
}

bool checkpoint_verify(const struct comm *comm, const char *path, struct error *error) {
    struct checkpoint_file file;
    if (!checkpoint_file_open(&file, comm, path, error))
        return false;
    bool good = checkpoint_file_compare(&file, error);
    checkpoint_file_close(&file);
    return good;
}

/* Reads the rows of this rank's particles, and compares the rest of the file. */
static bool get_rows(struct checkpoint_io *io, struct particles *particles, struct checkpoint_loaded *state,
                     struct error *error) {
    particles_reserve(particles, io->count);
    for (uint64_t i = 0; i < io->count; i++)
        particles_append(particles);
    return checkpoint_rows(io, particles, state, error) && checkpoint_file_compare(&io->file, error);
}

static bool read_file(struct checkpoint_io *io, const char *path, struct particles *particles,
                      struct checkpoint_loaded *loaded, struct error *error) {
    *loaded = (struct checkpoint_loaded){0};
    if (!checkpoint_file_open(&io->file, io->comm, path, error))
        return false;
    bool good =
        checkpoint_head(io, loaded, error) && (particles == NULL || get_rows(io, particles, loaded, error));
    checkpoint_file_close(&io->file);
    if (!good)
        checkpoint_loaded_free(loaded);
    return good;
}

bool checkpoint_read(const struct comm *comm, const char *path, struct particles *particles,
                     struct checkpoint_loaded *loaded, struct error *error) {
    struct checkpoint_io io = {.comm = comm, .h5 = {.file = -1}};
    return read_file(&io, path, particles, loaded, error);
}

bool checkpoint_read_full(const struct comm *comm, const char *path, struct particles *particles,
                          struct checkpoint_loaded *loaded, struct error *error) {
    struct checkpoint_io io = {.comm = comm, .h5 = {.file = -1}, .full = true};
    return read_file(&io, path, particles, loaded, error);
}

bool checkpoint_read_head(const struct comm *comm, const char *path, struct checkpoint_loaded *loaded,
                          struct error *error) {
    return checkpoint_read(comm, path, NULL, loaded, error);
}

void checkpoint_loaded_free(struct checkpoint_loaded *loaded) {
    history_rows_free(&loaded->history);
    history_rows_free(&loaded->wall_history);
    for (int k = 0; k < PHYSICS_COUNT; k++)
        history_rows_free(&loaded->carried[k]);
    domain_tree_destroy(&loaded->tree);
    restart_values_free(&loaded->restart);
    lineage_free(&loaded->lineage);
    memory_free(loaded->wall);
    memory_free(loaded->material);
    memory_free(loaded->group);
    memory_free(loaded->law);
    memory_free(loaded->scene);
    *loaded = (struct checkpoint_loaded){0};
}
