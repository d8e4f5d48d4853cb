/* Checkpoints: the same state back on the same layout, bit for bit, and on any other; nothing that is cut
 * off, changed or foreign is accepted; what cannot be written leaves the old one whole. Ranks: 1 2 3 4 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include "cloud.h"
#include "core/memory.h"
#include "core/random.h"
#include "folder.h"
#include "output/checkpoint.h"
#include "output/checkpoint_table.h"
#include "particles/fields.h"
#include "team.h"

#include <hdf5.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

enum { PARTICLES = 150, STAMP = 5, COMPONENTS = 3 };

static const struct box box = {.dimension = 3,
                               .origin = {-5, 100, 0.5},
                               .edge = {10, 11, 12},
                               .periodic = {true, false, true},
                               .leave = {{0}, {BOX_DELETE, BOX_ERROR}}};

struct fixture {
    struct team *team;
    struct comm comm; /* of those who write */
    struct folder folder;
    struct cloud cloud;
    struct particles *particles;
    struct history_rows history;
    struct wall_rows wall_history;
    struct checkpoint checkpoint;
};

/* Rows of history that follow from the ids: particle id has id % 4 rows, and id % 3 rows of walls. */
static double row_value(int64_t id, size_t row, int component) {
    struct random_sequence random = random_sequence(7, RANDOM_TEST, (uint64_t)id * 8 + row);
    random.draw = (uint32_t)component;
    return random_uniform(&random) - 0.5;
}

static void make_history(struct fixture *f) {
    struct particles *p = f->particles;
    f->history.start = memory_allocate(p->owned + 1, sizeof *f->history.start, "test");
    f->wall_history.start = memory_allocate(p->owned + 1, sizeof *f->wall_history.start, "test");
    f->history.row = memory_allocate_zero(4 * p->owned, sizeof *f->history.row, "test");
    f->wall_history.row = memory_allocate_zero(3 * p->owned, sizeof *f->wall_history.row, "test");
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
            struct wall_row *row = &f->wall_history.row[f->wall_history.count++];
            *row = (struct wall_row){.id = id, .wall = (int32_t)k, .patch = (int32_t)(id % 5)};
            for (int c = 0; c < COMPONENTS; c++)
                row->value[c] = row_value(id, k, 20 + c);
        }
        f->history.start[i + 1] = f->history.count;
        f->wall_history.start[i + 1] = f->wall_history.count;
    }
}

/* Deals the particles out unevenly: rank r of P gets those with k^2 mod (2 P - 1) / 2 = r. */
static int owner_of(size_t k, int size) {
    return (int)(k * k % (size_t)(2 * size - 1)) / 2 % size;
}

static void fixture_make(struct fixture *f, struct team *team, const struct comm *comm, unsigned features) {
    *f = (struct fixture){.team = team, .comm = *comm};
    folder_make(&f->folder, &team->comm);
    cloud_make(&f->cloud, &box, CLOUD_CONTINUOUS, PARTICLES, 2);
    f->particles = particles_create(features, 0);
    for (size_t k = 0; k < f->cloud.n; k++)
        if (owner_of(k, comm->size) == comm->rank)
            cloud_append(&f->cloud, k, STAMP, f->particles);
    make_history(f);
    f->checkpoint = (struct checkpoint){
        .numbers = {.step = 1200, .time = 0.1 + 0.2, .dt = 1e-6 / 3, .seed = UINT64_MAX - 5, .next_id = 777},
        .particles = f->particles,
        .box = &f->cloud.box,
        .history_components = COMPONENTS,
        .history = &f->history,
        .wall_history = &f->wall_history,
        .scene = "title: a test\n"};
    f->checkpoint.numbers.counter[3] = 1ull << 60;
    f->checkpoint.numbers.sum[1] = 0.1 * (comm->rank + 1);
}

static void fixture_free(struct fixture *f) {
    history_rows_free(&f->history);
    wall_rows_free(&f->wall_history);
    particles_destroy(&f->particles);
    cloud_free(&f->cloud);
    folder_remove(&f->folder, &f->team->comm);
}

static char *path_of(const struct fixture *f, const char *name, char path[FOLDER_MAX + 64]) {
    return folder_file(&f->folder, name, path);
}

static void expect_numbers(struct fixture *f, const struct checkpoint_loaded *l, const struct comm *reader) {
    const struct checkpoint_numbers *n = &f->checkpoint.numbers;
    struct team *team = f->team;
    team_expect(team, l->numbers.step == n->step && l->numbers.time == n->time && l->numbers.dt == n->dt,
                "moment");
    team_expect(team, l->numbers.seed == n->seed && l->numbers.next_id == n->next_id, "seed and next id");
    team_expect(team, l->numbers.counter[3] == 1ull << 60 && l->numbers.counter[0] == 0, "counters");
    team_expect(team, l->total == PARTICLES, "%d particles", (int)l->total);
    team_expect(team, l->history_components == COMPONENTS, "components");
    team_expect(team, strcmp(l->scene, "title: a test\n") == 0, "scene \"%s\"", l->scene);
    team_expect(team, memcmp(l->box.origin, box.origin, sizeof box.origin) == 0, "origin");
    team_expect(team, memcmp(l->box.edge, box.edge, sizeof box.edge) == 0, "edge");
    team_expect(team, memcmp(l->box.periodic, box.periodic, sizeof box.periodic) == 0, "periodic");
    team_expect(team, memcmp(l->box.leave, box.leave, sizeof box.leave) == 0, "leave");
    if (l->same_layout) {
        team_expect(team, l->numbers.sum[1] == n->sum[1], "own sum %g", l->numbers.sum[1]);
        return;
    }
    double total = 0, expected = 0;
    total = l->numbers.sum[1];
    comm_sum(reader, &total, 1);
    for (int r = 0; r < l->ranks; r++)
        expected += 0.1 * (r + 1);
    team_expect(team, total > expected - 1e-12 && total < expected + 1e-12, "sum %g", total);
}

/* The fields and history of a particle that was read are those that the cloud gives its id. */
static void expect_particle(struct fixture *f, const struct particles *p, const struct checkpoint_loaded *l,
                            size_t i) {
    struct team *team = f->team;
    int64_t id = p->id[i];
    if (!team_expect(team, id >= 1 && id <= PARTICLES, "id %d", (int)id))
        return;
    team_expect(team, memcmp(p->state[i].x, f->cloud.x[id - 1], 3 * sizeof(double)) == 0, "position of %d",
                (int)id);
    team_expect(team, p->state[i].radius == f->cloud.radius[id - 1], "radius of %d", (int)id);
    for (int field = 0; field < fields_count(); field++) {
        if (!cloud_stamped(field) || !fields_present(p, field) || !(fields_get(field)->use & FIELD_RESTART))
            continue;
        for (int c = 0; c < fields_get(field)->components; c++)
            team_expect(team, cloud_get(p, field, c, i) == cloud_value(id, field, c, STAMP), "%s of %d",
                        fields_get(field)->name, (int)id);
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
        const struct wall_row *row = &l->wall_history.row[l->wall_history.start[i] + k];
        team_expect(team, row->id == id && row->wall == (int32_t)k && row->patch == id % 5, "wall %zu of %d",
                    k, (int)id);
        team_expect(team, row->value[2] == row_value(id, k, 22), "wall history %zu of %d", k, (int)id);
    }
}

/* Reads with `reader`; on the writers' layout the order must be the same too. */
static void expect_whole(struct fixture *f, const char *path, const struct comm *reader, unsigned features) {
    struct checkpoint_loaded l;
    struct error error = {0};
    struct particles *p = particles_create(features, 0);
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

static void comes_back_on_the_same_layout(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    char path[FOLDER_MAX + 64];
    fixture_make(&f, team, &team->comm, PARTICLE_FEATURES_ALL);
    team_expect(team, checkpoint_write(&f.comm, f.folder.path, "", &f.checkpoint, 2, &error), "%s",
                error.text);
    team_expect(team, folder_count(&f.folder) == 1, "%d files", folder_count(&f.folder));
    expect_whole(&f, path_of(&f, "checkpoint-1200.h5", path), &team->comm, PARTICLE_FEATURES_ALL);
    fixture_free(&f);
    team_finish(team);
}

static void comes_back_on_other_layouts(void **state) {
    struct team *team = *state;
    struct comm self = folder_self();
    struct fixture f;
    struct error error = {0};
    char path[FOLDER_MAX + 64];
    /* all write, each reads the whole by itself */
    fixture_make(&f, team, &team->comm, PARTICLE_FEATURES_ALL);
    team_expect(team, checkpoint_write(&f.comm, f.folder.path, "", &f.checkpoint, 2, &error), "%s",
                error.text);
    expect_whole(&f, path_of(&f, "checkpoint-1200.h5", path), &self, PARTICLE_FEATURES_ALL);
    fixture_free(&f);
    /* all but the last write (or the only one), all read */
    struct comm some = folder_first(&team->comm, team->comm.size > 1 ? team->comm.size - 1 : 1);
    bool writes = team->comm.rank < some.size;
    fixture_make(&f, team, writes ? &some : &self, PARTICLE_FEATURES_ALL);
    f.comm.size = some.size;
    if (writes)
        team_expect(team, checkpoint_write(&some, f.folder.path, "", &f.checkpoint, 2, &error), "%s",
                    error.text);
    team_finish(team);
    expect_whole(&f, path_of(&f, "checkpoint-1200.h5", path), &team->comm, PARTICLE_FEATURES_ALL);
    fixture_free(&f);
    folder_first_free(&some);
    team_finish(team);
}

static void features_may_change(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    struct checkpoint_loaded l;
    char path[FOLDER_MAX + 64];
    fixture_make(&f, team, &team->comm, PARTICLE_FEATURES_ALL);
    team_expect(team, checkpoint_write(&f.comm, f.folder.path, "", &f.checkpoint, 2, &error), "%s",
                error.text);
    struct particles *p = particles_create(0, 0);
    path_of(&f, "checkpoint-1200.h5", path);
    team_expect(team, checkpoint_read(&f.comm, path, p, &l, &error), "%s", error.text);
    for (size_t i = 0; i < p->owned; i++) {
        /* what was held moves freely now, with the mass of its density */
        double w = cloud_value(p->id[i], fields_find("inverse_mass"), 0, STAMP);
        double density = cloud_value(p->id[i], fields_find("density"), 0, STAMP);
        double expected = w > 0 ? w : 1 / particles_sphere_mass(p->state[i].radius, density);
        team_expect(team, p->state[i].inverse_mass == expected, "mass of %d", (int)p->id[i]);
    }
    checkpoint_loaded_free(&l);
    particles_destroy(&p);
    fixture_free(&f);
    team_finish(team);
}

static void no_particles_at_all(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    struct checkpoint_loaded l;
    char path[FOLDER_MAX + 64];
    fixture_make(&f, team, &team->comm, PARTICLE_SPIN);
    f.particles->owned = 0;
    f.history.count = f.wall_history.count = 0;
    team_expect(team, checkpoint_write(&f.comm, f.folder.path, "", &f.checkpoint, 2, &error), "%s",
                error.text);
    struct particles *p = particles_create(PARTICLE_SPIN, 0);
    path_of(&f, "checkpoint-1200.h5", path);
    team_expect(team, checkpoint_read(&f.comm, path, p, &l, &error), "%s", error.text);
    team_expect(team, p->owned == 0 && l.total == 0 && l.numbers.next_id == 777, "%d particles",
                (int)l.total);
    checkpoint_loaded_free(&l);
    particles_destroy(&p);
    fixture_free(&f);
    team_finish(team);
}

/* Two planes that have moved: each comes back by its name. */
static void wall_poses_come_back(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    struct law law = {0};
    struct law_options options = law_options_default();
    static const struct law_material material = {
        .name = "glass", .density = 2500, .young = 1e7, .poisson = 0.2};
    static struct law_pair pair[LAW_MATERIALS_MAX][LAW_MATERIALS_MAX];
    pair[0][0] = (struct law_pair){.restitution = 0.5, .friction = 0.3};
    team_expect(team, law_prepare(&law, &options, 1, &material, pair, &error), "%s", error.text);
    struct wall_motion drift = {.kind = WALL_TRANSLATE, .stop = 10, .velocity = {1, 0, 0.25}};
    struct wall_motion turn = {
        .kind = WALL_ROTATE, .stop = 10, .direction = {0, 0, 1}, .point = {0, 105, 6}, .rate = 0.5};
    struct wall_options planes[2] = {{.name = "floor",
                                      .shape = WALL_PLANE,
                                      .point = {0, 105, 1},
                                      .normal = {0, 0, 1},
                                      .motions = 1,
                                      .motion = {drift}},
                                     {.name = "side",
                                      .shape = WALL_PLANE,
                                      .point = {-4, 105, 6},
                                      .normal = {1, 0, 0},
                                      .motions = 1,
                                      .motion = {turn}}};
    fixture_make(&f, team, &team->comm, PARTICLE_SPIN);
    struct walls *walls = NULL;
    if (team_expect(team, walls_create(&walls, planes, 2, &law, &f.cloud.box, 1, &error, NULL), "%s",
                    error.text)) {
        for (int step = 0; step < 8; step++)
            walls_advance(walls, 0.125 * step, 0.125, NULL);
        f.checkpoint.walls = walls;
        struct checkpoint_loaded l;
        char path[FOLDER_MAX + 64];
        team_expect(team, checkpoint_write(&f.comm, f.folder.path, "", &f.checkpoint, 2, &error), "%s",
                    error.text);
        path_of(&f, "checkpoint-1200.h5", path);
        if (team_expect(team, checkpoint_read_head(&f.comm, path, &l, &error), "%s", error.text)) {
            team_expect(team, l.walls == 2, "%d walls", l.walls);
            for (int w = 0; w < l.walls; w++) {
                struct wall_pose now;
                walls_pose(walls, w, &now);
                team_expect(team, strcmp(l.wall[w].name, planes[w].name) == 0, "wall %d is %s", w,
                            l.wall[w].name);
                team_expect(team, memcmp(&l.wall[w].pose, &now, sizeof now) == 0, "pose of wall %d", w);
            }
            team_expect(team, l.walls < 1 || l.wall[0].pose.translation[2] == 0.25,
                        "the floor has not moved");
            checkpoint_loaded_free(&l);
        }
        walls_destroy(&walls);
    }
    fixture_free(&f);
    team_finish(team);
}

static void head_is_read_alone(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    struct checkpoint_loaded l;
    char path[FOLDER_MAX + 64];
    fixture_make(&f, team, &team->comm, PARTICLE_SPIN);
    team_expect(team, checkpoint_write(&f.comm, f.folder.path, "", &f.checkpoint, 2, &error), "%s",
                error.text);
    path_of(&f, "checkpoint-1200.h5", path);
    if (team_expect(team, checkpoint_read_head(&f.comm, path, &l, &error), "%s", error.text)) {
        expect_numbers(&f, &l, &f.comm);
        team_expect(team, l.features == PARTICLE_SPIN, "features %u", l.features);
        checkpoint_loaded_free(&l);
    }
    fixture_free(&f);
    team_finish(team);
}

static void old_ones_are_deleted(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    char path[OUTPUT_PATH_MAX], expected[FOLDER_MAX + 64];
    fixture_make(&f, team, &team->comm, 0);
    team_expect(team, !checkpoint_find_newest(f.folder.path, path), "there is one");
    static const uint64_t steps[] = {100, 90, 1000, 1100};
    for (int k = 0; k < 4; k++) {
        f.checkpoint.numbers.step = steps[k];
        team_expect(
            team,
            checkpoint_write(&f.comm, f.folder.path, k == 2 ? "-stopped" : "", &f.checkpoint, 2, &error),
            "%s", error.text);
    }
    f.checkpoint.numbers.step = 1200;
    team_expect(team, checkpoint_write(&f.comm, f.folder.path, "", &f.checkpoint, 2, &error), "%s",
                error.text);
    if (team->comm.rank == 0) {
        static const char *const names[] = {"checkpoint-90.h5", "checkpoint-100.h5",
                                            "checkpoint-1000-stopped.h5", "checkpoint-1100.h5",
                                            "checkpoint-1200.h5"};
        for (int k = 0; k < 5; k++)
            team_expect(team, (access(path_of(&f, names[k], expected), F_OK) == 0) == (k >= 2), "%s",
                        names[k]);
        team_expect(team, checkpoint_find_newest(f.folder.path, path), "none is found");
        team_expect(team, strcmp(path, expected) == 0, "the newest is %s", path);
    }
    fixture_free(&f);
    team_finish(team);
}

/* Damage. */

struct bytes {
    unsigned char *data;
    size_t size;
};

static struct bytes read_bytes(const char *path) {
    struct bytes bytes = {0};
    FILE *file = fopen(path, "rb");
    fseek(file, 0, SEEK_END);
    bytes.size = (size_t)ftell(file);
    rewind(file);
    bytes.data = memory_allocate(bytes.size, 1, "test");
    if (fread(bytes.data, 1, bytes.size, file) != bytes.size)
        error_fatal("%s cannot be read", path);
    fclose(file);
    return bytes;
}

static void write_bytes(const char *path, const struct bytes *bytes, size_t size) {
    FILE *file = fopen(path, "wb");
    if (fwrite(bytes->data, 1, size, file) != size || fclose(file) != 0)
        error_fatal("%s cannot be written", path);
}

/* The file as it stands must be refused by one message that names it. */
static void expect_refused(struct fixture *f, const char *path, const char *what, size_t place) {
    struct comm self = folder_self();
    struct error error = {0};
    struct checkpoint_loaded l;
    struct particles *p = particles_create(0, 0);
    bool good = checkpoint_read(&self, path, p, &l, &error);
    team_expect(f->team, !good, "%s at %zu is not noticed", what, place);
    team_expect(f->team,
                good || (error.kind == ERROR_USER && strstr(error.text, path) && !strchr(error.text, '\n')),
                "%s at %zu: %s", what, place, error.text);
    if (good)
        checkpoint_loaded_free(&l);
    particles_destroy(&p);
}

/* One rank writes; then many copies, each damaged in one place. */
static void make_victim(struct fixture *f, struct team *team, struct bytes *bytes,
                        char path[FOLDER_MAX + 64]) {
    struct comm self = folder_self();
    struct error error = {0};
    fixture_make(f, team, &self, PARTICLE_FEATURES_ALL);
    if (team->comm.rank != 0)
        return;
    team_expect(team, checkpoint_write(&self, f->folder.path, "", &f->checkpoint, 2, &error), "%s",
                error.text);
    *bytes = read_bytes(path_of(f, "checkpoint-1200.h5", path));
    path_of(f, "victim.h5", path);
}

static void any_cut_is_noticed(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct bytes bytes = {0};
    char path[FOLDER_MAX + 64];
    make_victim(&f, team, &bytes, path);
    for (size_t size = 0; size < bytes.size; size += size < 64 ? 1 : size < 9000 ? 131 : 997) {
        write_bytes(path, &bytes, size);
        expect_refused(&f, path, "a cut", size);
    }
    if (bytes.size > 0) {
        write_bytes(path, &bytes, bytes.size - 1);
        expect_refused(&f, path, "a cut", bytes.size - 1);
    }
    memory_free(bytes.data);
    fixture_free(&f);
    team_finish(team);
}

static void any_flip_is_noticed(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct bytes bytes = {0};
    char path[FOLDER_MAX + 64];
    make_victim(&f, team, &bytes, path);
    size_t flips = 0;
    for (size_t k = 0; k < bytes.size; k += 29) {
        write_bytes(path, &bytes, bytes.size);
        FILE *file = fopen(path, "r+b");
        fseek(file, (long)k, SEEK_SET);
        fputc(bytes.data[k] ^ (1 << (k / 29) % 8), file);
        fclose(file);
        expect_refused(&f, path, "a flipped bit", k);
        flips++;
    }
    team_expect(team, team->comm.rank != 0 || flips > 1000, "only %zu flips", flips);
    memory_free(bytes.data);
    fixture_free(&f);
    team_finish(team);
}

/* The message names the dataset whose bytes were changed. */
static void the_dataset_is_named(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct bytes bytes = {0};
    struct comm self = folder_self();
    struct checkpoint_table table;
    char path[FOLDER_MAX + 64];
    make_victim(&f, team, &bytes, path);
    for (int k = 0; bytes.size > 0; k++) {
        struct error error = {0};
        write_bytes(path, &bytes, bytes.size);
        team_expect(team, checkpoint_table_read(&table, &self, path, &error), "%s", error.text);
        if (k == table.entries)
            break;
        if (table.entry[k].bytes == 0)
            continue;
        bytes.data[table.entry[k].offset + table.entry[k].bytes - 1] ^= 0x40;
        write_bytes(path, &bytes, bytes.size);
        bytes.data[table.entry[k].offset + table.entry[k].bytes - 1] ^= 0x40;
        team_expect(team, !checkpoint_verify(&self, path, &error), "%s is not missed", table.entry[k].name);
        team_expect(team, strstr(error.text, table.entry[k].name) != NULL, "%s: %s", table.entry[k].name,
                    error.text);
    }
    memory_free(bytes.data);
    fixture_free(&f);
    team_finish(team);
}

static void foreign_files_are_refused(void **state) {
    struct team *team = *state;
    struct fixture f;
    char path[FOLDER_MAX + 64];
    struct comm self = folder_self();
    fixture_make(&f, team, &self, 0);
    if (team->comm.rank == 0) {
        path_of(&f, "other.h5", path);
        expect_refused(&f, path, "a missing file", 0);
        expect_refused(&f, f.folder.path, "a folder", 0);
        static const char *const texts[] = {"", "scree", "a text\n", "scree checkpoint 1\n",
                                            "scree checkpoint 9\n"};
        for (size_t k = 0; k < sizeof texts / sizeof texts[0]; k++) {
            FILE *file = fopen(path, "w");
            fputs(texts[k], file);
            for (int line = 0; k > 2 && line < 1000; line++)
                fputs("more of it\n", file);
            fclose(file);
            expect_refused(&f, path, "a text", k);
        }
        hid_t file = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
        H5Fclose(file);
        expect_refused(&f, path, "another HDF5 file", 0);
    }
    fixture_free(&f);
    team_finish(team);
}

/* No room: the message says so, the old checkpoint stays, nothing is left behind. */
static void what_does_not_fit_leaves_the_old_one(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    char path[FOLDER_MAX + 64];
    fixture_make(&f, team, &team->comm, PARTICLE_FEATURES_ALL);
    team_expect(team, checkpoint_write(&f.comm, f.folder.path, "", &f.checkpoint, 1, &error), "%s",
                error.text);
    struct rlimit limit, small;
    getrlimit(RLIMIT_FSIZE, &limit);
    signal(SIGXFSZ, SIG_IGN);
    small = limit;
    small.rlim_cur = 20000;
    setrlimit(RLIMIT_FSIZE, &small);
    f.checkpoint.numbers.step = 1300;
    team_expect(team, !checkpoint_write(&f.comm, f.folder.path, "", &f.checkpoint, 1, &error), "it fits");
    setrlimit(RLIMIT_FSIZE, &limit);
    team_expect(team,
                error.kind == ERROR_SYSTEM && strstr(error.text, "checkpoint-1300.h5") &&
                    strstr(error.text, "File too large"),
                "%s", error.text);
    team_expect(team, folder_count(&f.folder) == 1, "%d files", folder_count(&f.folder));
    f.checkpoint.numbers.step = 1200;
    expect_whole(&f, path_of(&f, "checkpoint-1200.h5", path), &f.comm, PARTICLE_FEATURES_ALL);
    fixture_free(&f);
    team_finish(team);
}

static void a_missing_folder_is_named(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    fixture_make(&f, team, &team->comm, 0);
    team_expect(team, !checkpoint_write(&f.comm, "/nowhere/at all", "", &f.checkpoint, 1, &error),
                "written to nowhere");
    team_expect(team, strstr(error.text, "/nowhere/at all") != NULL, "%s", error.text);
    fixture_free(&f);
    team_finish(team);
}

int main(int argc, char **argv) {
    struct team team;
    team_start(&team, &argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_prestate(comes_back_on_the_same_layout, &team),
        cmocka_unit_test_prestate(comes_back_on_other_layouts, &team),
        cmocka_unit_test_prestate(features_may_change, &team),
        cmocka_unit_test_prestate(no_particles_at_all, &team),
        cmocka_unit_test_prestate(wall_poses_come_back, &team),
        cmocka_unit_test_prestate(head_is_read_alone, &team),
        cmocka_unit_test_prestate(old_ones_are_deleted, &team),
        cmocka_unit_test_prestate(any_cut_is_noticed, &team),
        cmocka_unit_test_prestate(any_flip_is_noticed, &team),
        cmocka_unit_test_prestate(the_dataset_is_named, &team),
        cmocka_unit_test_prestate(foreign_files_are_refused, &team),
        cmocka_unit_test_prestate(what_does_not_fit_leaves_the_old_one, &team),
        cmocka_unit_test_prestate(a_missing_folder_is_named, &team),
    };
    int failed = cmocka_run_group_tests_name("checkpoint", tests, NULL, NULL);
    return team_stop(&team) || failed;
}
