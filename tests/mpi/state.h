/* SPDX-License-Identifier: BSD-3-Clause */
/* The state of a run for tests of checkpoints. Include after cmocka.h. */
#ifndef SCREE_TESTS_MPI_STATE_H
#define SCREE_TESTS_MPI_STATE_H

#include "cloud.h"
#include "base/memory.h"
#include "base/random.h"
#include "folder.h"
#include "data/formats/checkpoint.h"
#include "data/formats/checkpoint_table.h"
#include "kernel/particles/fields.h"
#include "team.h"

#include <stdlib.h>
#include <string.h>

enum { PARTICLES = 150, STAMP = 5, COMPONENTS = 3 };

static const struct box box = {.dimension = 3,
                               .origin = {-5, 100, 0.5},
                               .edge = {10, 11, 12},
                               .periodic = {true, false, true},
                               .leave = {{0}, {BOX_DELETE, BOX_ERROR}}};

struct fixture {
    struct team *team;
    struct comm comm; /* of the ranks that write */
    struct folder folder;
    struct cloud cloud;
    struct particles *particles;
    struct history_rows history;
    struct history_rows wall_history;
    struct checkpoint checkpoint;
    struct restart restart;
    struct lineage lineage;
    int64_t count; /* numbers under names */
    double real, part;
};

/* Rows of history that follow from the ids: particle id has id % 4 rows, and id % 3 rows of walls. */
static inline double row_value(int64_t id, size_t row, int component) {
    struct random_sequence random = random_sequence(7, RANDOM_TEST, (uint64_t)id * 8 + row);
    random.draw = (uint32_t)component;
    return random_uniform(&random) - 0.5;
}

static inline void make_history(struct fixture *f) {
    struct particles *p = f->particles;
    f->history.start = memory_allocate(p->owned + 1, sizeof *f->history.start, "test");
    f->wall_history.start = memory_allocate(p->owned + 1, sizeof *f->wall_history.start, "test");
    f->history.row = memory_allocate_zero(4 * p->owned, sizeof *f->history.row, "test");
    f->wall_history.row = memory_allocate_zero(3 * p->owned, sizeof *f->wall_history.row, "test");
    f->history.components = f->wall_history.components = COMPONENTS;
    f->history.start[0] = f->wall_history.start[0] = 0;
    for (size_t i = 0; i < p->owned; i++) {
        int64_t id = p->id[i];
        for (size_t k = 0; k < (size_t)(id % 4); k++) {
            struct history_row *row = &f->history.row[f->history.count++];
            *row = (struct history_row){.id = id, .partner = id + 1 + (int64_t)k};
            for (int c = 0; c < COMPONENTS; c++)
                row->value[c] = row_value(id, k, c);
            for (int d = 0; d < 3; d++)
                row->separation[d] = row_value(id, k, 10 + d);
        }
        for (size_t k = 0; k < (size_t)(id % 3); k++) {
            struct history_row *row = &f->wall_history.row[f->wall_history.count++];
            *row = (struct history_row){.id = id, .partner = wall_row_partner((int)k, (int32_t)(id % 5))};
            for (int c = 0; c < COMPONENTS; c++)
                row->value[c] = row_value(id, k, 20 + c);
        }
        f->history.start[i + 1] = f->history.count;
        f->wall_history.start[i + 1] = f->wall_history.count;
    }
}

/* Deals the particles out unevenly: rank r of P gets the particles k with k^2 mod (2 P - 1) / 2 = r. */
static inline int owner_of(size_t k, int size) {
    return (int)(k * k % (size_t)(2 * size - 1)) / 2 % size;
}

static inline void list_numbers(struct restart *restart, int64_t *count, double *real, double *part) {
    restart_add(restart, RESTART_INTEGER, false, count, "count of %s", "something");
    restart_add(restart, RESTART_SUM, false, part, "a sum");
    restart_add(restart, RESTART_REAL, false, real, "a real");
}

/* As many materials and groups as the stamps of the cloud have numbers. */
enum { MATERIALS = 32 };
static struct law_material material[MATERIALS];
static char material_name[MATERIALS][16];
static const char *group[MATERIALS];

static inline void make_names(void) {
    for (int k = 0; k < MATERIALS; k++) {
        snprintf(material_name[k], sizeof material_name[k], "kind %d", k);
        snprintf(material[k].name, sizeof material[k].name, "%s", material_name[k]);
        material[k].density = 1000 + k;
        group[k] = material_name[k];
    }
}

static inline void fixture_make(struct fixture *f, struct team *team, const struct comm *comm,
                                unsigned features) {
    *f = (struct fixture){.team = team, .comm = *comm};
    folder_make(&f->folder, &team->comm);
    cloud_make(&f->cloud, &box, CLOUD_CONTINUOUS, PARTICLES, 2);
    f->particles = particles_with(features, 0);
    for (size_t k = 0; k < f->cloud.n; k++)
        if (owner_of(k, comm->size) == comm->rank)
            cloud_append(&f->cloud, k, STAMP, f->particles);
    for (size_t i = 0; i < f->particles->owned; i++) {
        uint8_t *number = material_numbers(f->particles), *member = groups_of(f->particles);
        if (number)
            number[i] %= MATERIALS;
        if (member)
            member[i] %= MATERIALS;
    }
    make_history(f);
    make_names();
    f->checkpoint = (struct checkpoint){
        .numbers = {.step = 1200, .time = 0.1 + 0.2, .dt = 1e-6 / 3, .seed = UINT64_MAX - 5, .next_id = 777},
        .particles = f->particles,
        .box = &f->cloud.box,
        .history_components = COMPONENTS,
        .history = &f->history,
        .wall_history = &f->wall_history,
        .law = "hooke",
        .materials = MATERIALS,
        .groups = MATERIALS,
        .material = material,
        .group = group,
        .scene = "title: a test\n",
        .restart = &f->restart,
        .lineage = &f->lineage};
    f->count = 1ll << 60;
    f->real = 1e-300 / 3;
    f->part = 0.1 * (comm->rank + 1);
    list_numbers(&f->restart, &f->count, &f->real, &f->part);
    lineage_add(&f->lineage, 0, "0.1", "abc", "title: the first\n");
    lineage_add(&f->lineage, 700, "0.2", "def", "title: a test\n");
}

static inline void fixture_free(struct fixture *f) {
    history_rows_free(&f->history);
    history_rows_free(&f->wall_history);
    restart_free(&f->restart);
    lineage_free(&f->lineage);
    particles_destroy(&f->particles);
    cloud_free(&f->cloud);
    folder_remove(&f->folder, &f->team->comm);
}

static inline char *path_of(const struct fixture *f, const char *name, char path[FOLDER_MAX + 64]) {
    return folder_file(&f->folder, name, path);
}

static inline void expect_names(struct fixture *f, const struct checkpoint_loaded *l) {
    struct team *team = f->team;
    team_expect(team, strcmp(l->law, "hooke") == 0, "law %s", l->law);
    team_expect(team, l->materials == MATERIALS && l->groups == MATERIALS, "%d materials, %d groups",
                l->materials, l->groups);
    for (int k = 0; k < MATERIALS; k++)
        team_expect(team,
                    strcmp(l->material[k].name, group[k]) == 0 && l->material[k].density == 1000 + k &&
                        strcmp(l->group[k].name, group[k]) == 0,
                    "material or group %d", k);
    if (!team_expect(team, l->lineage.count == 2, "%zu runs", l->lineage.count))
        return;
    for (size_t k = 0; k < 2; k++) {
        const struct lineage_run *then = &f->lineage.run[k], *now = &l->lineage.run[k];
        team_expect(team,
                    then->step == now->step && strcmp(then->version, now->version) == 0 &&
                        strcmp(then->revision, now->revision) == 0 && strcmp(then->scene, now->scene) == 0,
                    "run %zu", k);
    }
}

static inline void expect_numbers(struct fixture *f, const struct checkpoint_loaded *l,
                                  const struct comm *reader) {
    const struct checkpoint_numbers *n = &f->checkpoint.numbers;
    struct team *team = f->team;
    team_expect(team, l->numbers.step == n->step && l->numbers.time == n->time && l->numbers.dt == n->dt,
                "moment");
    team_expect(team, l->numbers.seed == n->seed && l->numbers.next_id == n->next_id, "seed and next id");
    struct restart list = {0};
    struct error error = {0};
    int64_t count = 0;
    double real = 0, part = 0;
    list_numbers(&list, &count, &real, &part);
    team_expect(team, restart_take(&list, &l->restart, "test", &error), "%s", error.text);
    restart_free(&list);
    team_expect(team, count == f->count && real == f->real, "numbers under names");
    expect_names(f, l);
    team_expect(team, l->total == PARTICLES, "%d particles", (int)l->total);
    team_expect(team, l->history_components == COMPONENTS, "components");
    team_expect(team, strcmp(l->scene, "title: a test\n") == 0, "scene \"%s\"", l->scene);
    team_expect(team, memcmp(l->box.origin, box.origin, sizeof box.origin) == 0, "origin");
    team_expect(team, memcmp(l->box.edge, box.edge, sizeof box.edge) == 0, "edge");
    team_expect(team, memcmp(l->box.periodic, box.periodic, sizeof box.periodic) == 0, "periodic");
    team_expect(team, memcmp(l->box.leave, box.leave, sizeof box.leave) == 0, "leave");
    if (l->same_layout) {
        team_expect(team, part == f->part, "own sum %g", part);
        return;
    }
    double total = 0, expected = 0;
    total = part;
    comm_sum(reader, &total, 1);
    for (int r = 0; r < l->ranks; r++)
        expected += 0.1 * (r + 1);
    team_expect(team, total > expected - 1e-12 && total < expected + 1e-12, "sum %g", total);
}

/* The value that the fixture gives a field: the stamp, which for materials and groups is an existing number. */
static inline double value_of(int64_t id, const struct field *field, int component) {
    double value = cloud_value(id, cloud_code(field->name), component, STAMP);
    bool number = strcmp(field->name, "material") == 0 || strcmp(field->name, "group") == 0;
    return number ? (int)value % MATERIALS : value;
}

/* The fields and history of a particle that was read are those that the cloud gives its id. */
static inline void expect_particle(struct fixture *f, const struct particles *p,
                                   const struct checkpoint_loaded *l, size_t i) {
    struct team *team = f->team;
    int64_t id = p->id[i];
    if (!team_expect(team, id >= 1 && id <= PARTICLES, "id %d", (int)id))
        return;
    team_expect(team, memcmp(p->state[i].x, f->cloud.x[id - 1], 3 * sizeof(double)) == 0, "position of %d",
                (int)id);
    team_expect(team, p->state[i].radius == f->cloud.radius[id - 1], "radius of %d", (int)id);
    for (int f = 0; f < fields_count(p); f++) {
        const struct field *field = fields_get(p, f);
        if (!cloud_stamped(field) || !(field->use & FIELD_RESTART))
            continue;
        for (int c = 0; c < field->components; c++)
            team_expect(team, cloud_get(p, f, c, i) == value_of(id, field, c), "%s of %d", field->name,
                        (int)id);
    }
    size_t rows = l->history.start[i + 1] - l->history.start[i];
    size_t wall_rows = l->wall_history.start[i + 1] - l->wall_history.start[i];
    team_expect(team, rows == (size_t)(id % 4) && wall_rows == (size_t)(id % 3), "rows of %d", (int)id);
    for (size_t k = 0; k < rows; k++) {
        const struct history_row *row = &l->history.row[l->history.start[i] + k];
        team_expect(team, row->id == id && row->partner == id + 1 + (int64_t)k, "partner %zu of %d", k,
                    (int)id);
        for (int c = 0; c < 3; c++)
            team_expect(
                team, row->value[c] == row_value(id, k, c) && row->separation[c] == row_value(id, k, 10 + c),
                "history %zu of %d", k, (int)id);
        team_expect(team, row->value[5] == 0, "unused component");
    }
    for (size_t k = 0; k < wall_rows; k++) {
        const struct history_row *row = &l->wall_history.row[l->wall_history.start[i] + k];
        team_expect(team, row->id == id && wall_row_wall(row) == (int)k && wall_row_feature(row) == id % 5,
                    "wall %zu of %d", k, (int)id);
        team_expect(team, row->value[2] == row_value(id, k, 22), "wall history %zu of %d", k, (int)id);
    }
}

/* Reads with `reader`; on the writers' layout the order must be the same too. */
static inline void expect_whole(struct fixture *f, const char *path, const struct comm *reader,
                                unsigned features) {
    struct checkpoint_loaded l;
    struct error error = {0};
    struct particles *p = particles_with(features, 0);
    if (team_expect(f->team, checkpoint_read(reader, path, p, &l, &error), "%s", error.text)) {
        bool same = reader->size == f->comm.size;
        team_expect(f->team, l.same_layout == same && l.ranks == f->comm.size, "layout");
        expect_numbers(f, &l, reader);
        int64_t total = (int64_t)p->owned;
        comm_sum_int(reader, &total, 1);
        team_expect(f->team, total == PARTICLES, "%d particles", (int)total);
        for (size_t i = 0; i < p->owned; i++)
            expect_particle(f, p, &l, i);
        if (same) {
            team_expect(f->team, p->owned == f->particles->owned, "number of particles");
            for (size_t i = 0; i < p->owned && i < f->particles->owned; i++)
                team_expect(f->team, p->id[i] == f->particles->id[i], "order at %zu", i);
        }
        checkpoint_loaded_free(&l);
    }
    particles_destroy(&p);
}

#endif
