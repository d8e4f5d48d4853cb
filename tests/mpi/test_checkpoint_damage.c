/* SPDX-License-Identifier: BSD-3-Clause */
/* Checkpoints that are cut off, changed or foreign are refused; a checkpoint that cannot be written leaves the
 * old checkpoint whole. Ranks: 1 2 3 4 */
#include "tests/test.h"

#include "state.h"

#include <hdf5.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

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

/* The present file must be refused by one message that names the file. */
static void expect_refused(struct fixture *f, const char *path, const char *what, size_t place) {
    struct comm self = folder_self();
    struct error error = {0};
    struct checkpoint_loaded l;
    struct particles *p = particles_create(0);
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
    fixture_make(f, team, &self, WITH_ALL);
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
    for (size_t size = 0; size < bytes.size; size += size < 64 ? 1 : size < 9000 ? 263 : 1997) {
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
    for (size_t k = 0; k < bytes.size; k += 61) {
        write_bytes(path, &bytes, bytes.size);
        FILE *file = fopen(path, "r+b");
        fseek(file, (long)k, SEEK_SET);
        fputc(bytes.data[k] ^ (1 << (k / 61) % 8), file);
        fclose(file);
        expect_refused(&f, path, "a flipped bit", k);
        flips++;
    }
    team_expect(team, team->comm.rank != 0 || flips > 500, "only %zu flips", flips);
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

/* No room: the message reports the lack of room, the old checkpoint stays, no other file is left. */
static void what_does_not_fit_leaves_the_old_one(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct error error = {0};
    char path[FOLDER_MAX + 64];
    fixture_make(&f, team, &team->comm, WITH_ALL);
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
    expect_whole(&f, path_of(&f, "checkpoint-1200.h5", path), &f.comm, WITH_ALL);
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

TEAM_MAIN(checkpoint_damage, team_case(any_cut_is_noticed), team_case(any_flip_is_noticed),
          team_case(the_dataset_is_named), team_case(foreign_files_are_refused),
          team_case(what_does_not_fit_leaves_the_old_one), team_case(a_missing_folder_is_named))
