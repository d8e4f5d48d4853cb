/* SPDX-License-Identifier: BSD-3-Clause */
/* LAMMPS's text files, conversions between formats, and the text of info about the files.
 * Ranks: 1 2 4 */
#include "tests/test.h"

#include "cloud.h"
#include "base/memory.h"
#include "folder.h"
#include "data/formats/checkpoint.h"
#include "data/formats/convert.h"
#include "data/formats/dump.h"
#include "data/formats/h5md_read.h"
#include "data/formats/info.h"
#include "data/formats/lammps_data.h"
#include "kernel/particles/fields.h"
#include "team.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { PARTICLES = 111, STAMP = 5 };

static const struct box box = {
    .dimension = 3, .origin = {-5, 100, 0.5}, .edge = {10, 11, 12}, .periodic = {true, false, false}};

struct fixture {
    struct team *team;
    struct folder folder;
    char path[FOLDER_MAX + 64];
    struct cloud cloud;
    struct particles *particles;
    struct integrator_context motion;
    struct output_view view;
};

static void fixture_make(struct fixture *f, struct team *team, unsigned features) {
    *f = (struct fixture){.team = team};
    folder_make(&f->folder, &team->comm);
    folder_file(&f->folder, "dump.lammpstrj", f->path);
    cloud_make(&f->cloud, &box, CLOUD_CONTINUOUS, PARTICLES, 2);
    f->particles = particles_with(features, 0);
    for (size_t k = 0; k < f->cloud.n; k++)
        if (k * 7 % 5 % (size_t)team->comm.size == (size_t)team->comm.rank)
            cloud_append(&f->cloud, k, STAMP, f->particles);
    for (size_t i = 0; i < f->particles->owned; i++)
        f->particles->state[i].inverse_mass = 0.5;
    f->motion = (struct integrator_context){.dimension = 3, .groups = 1};
    f->view = (struct output_view){
        .comm = &team->comm, .particles = f->particles, .box = &f->cloud.box, .motion = &f->motion};
}

static void fixture_free(struct fixture *f) {
    particles_destroy(&f->particles);
    cloud_free(&f->cloud);
    folder_remove(&f->folder, &f->team->comm);
}

static void write_frames(struct fixture *f, int64_t resume, int first, int last) {
    static const struct output_fields all = {0};
    struct error error = {0};
    struct dump *dump = NULL;
    team_expect(f->team, dump_open(&dump, &f->team->comm, f->path, resume, &error), "%s", error.text);
    for (int step = first; dump && step < last; step++) {
        f->view.step = (uint64_t)step;
        struct frame frame;
        frame_create(&frame, &f->view, &all);
        team_expect(f->team, dump_write(dump, &frame, &error), "%s", error.text);
        frame_free(&frame);
    }
    team_expect(f->team, dump_close(&dump, &error), "%s", error.text);
}

/* A number rounded to fifteen digits. */
static bool near(double a, double b) {
    return fabs(a - b) <= 1e-14 * (fabs(a) + fabs(b));
}

static void expect_rows(struct fixture *f, const struct rows *rows) {
    struct team *team = f->team;
    team_expect(team, rows->count == PARTICLES, "%zu rows", rows->count);
    for (size_t k = 0; k < rows->count; k++) {
        int64_t id = (int64_t)k + 1;
        team_expect(team, rows->id[k] == id, "row %zu holds id %d", k, (int)rows->id[k]);
        team_expect(team, near(rows->radius[k], f->cloud.radius[k]), "radius of %d", (int)id);
        if (rows->mass)
            team_expect(team, near(rows->mass[k], 2), "mass of %d", (int)id);
        for (int d = 0; d < 3; d++) {
            team_expect(team, near(rows->position[k][d], f->cloud.x[k][d] + box.origin[d]), "position of %d",
                        (int)id);
            team_expect(team, rows->velocity[k][d] == cloud_value(id, cloud_code("velocity"), d, STAMP),
                        "velocity");
            if (spin_of(f->particles))
                team_expect(team,
                            rows->angular_velocity[k][d] ==
                                cloud_value(id, cloud_code("angular_velocity"), d, STAMP),
                            "angular velocity of %d", (int)id);
        }
    }
    for (int d = 0; d < 3; d++)
        team_expect(team,
                    near(rows->lower[d], box.origin[d]) && near(rows->upper[d], box.origin[d] + box.edge[d]),
                    "box %d", d);
}

static void dump_comes_back(void **state) {
    struct team *team = *state;
    for (unsigned features = 0; features <= WITH_SPIN; features++) {
        struct fixture f;
        struct rows rows;
        struct error error = {0};
        uint64_t frames = 0;
        fixture_make(&f, team, features);
        write_frames(&f, -1, 0, 3);
        if (team->comm.rank == 0) {
            team_expect(team, dump_frames(f.path, &frames, &error) && frames == 3, "%d frames: %s",
                        (int)frames, error.text);
            if (team_expect(team, dump_read(f.path, -2, &rows, &error), "%s", error.text)) {
                team_expect(team, rows.step == 1 && rows.periodic[0] && !rows.periodic[1], "step %d",
                            (int)rows.step);
                team_expect(team, (rows.angular_velocity != NULL) == (features != 0), "angular velocities");
                expect_rows(&f, &rows);
                rows_free(&rows);
            }
            team_expect(team, !dump_read(f.path, 3, &rows, &error), "frame 3 is there");
        }
        fixture_free(&f);
        team_finish(team);
    }
}

static char *read_text(const char *path, size_t *length) {
    FILE *file = fopen(path, "r");
    char *text = memory_allocate_zero(1 << 20, 1, "test");
    *length = file ? fread(text, 1, (1 << 20) - 1, file) : 0;
    if (file)
        fclose(file);
    return text;
}

static void dump_goes_on(void **state) {
    struct team *team = *state;
    struct fixture f;
    size_t whole_length = 0, length = 0;
    char *whole = NULL, *text = NULL;
    fixture_make(&f, team, WITH_SPIN);
    write_frames(&f, -1, 0, 6);
    if (team->comm.rank == 0)
        whole = read_text(f.path, &whole_length);
    write_frames(&f, -1, 0, 5);
    if (team->comm.rank == 0 && truncate(f.path, (off_t)(whole_length * 5 / 6 - 100)) != 0)
        team_expect(team, false, "truncate");
    write_frames(&f, 2, 3, 6); /* the last frame is torn; the checkpoint is of step 2 */
    if (team->comm.rank == 0) {
        text = read_text(f.path, &length);
        team_expect(team, length == whole_length && memcmp(text, whole, length) == 0, "%zu bytes, not %zu",
                    length, whole_length);
    }
    memory_free(whole);
    memory_free(text);
    fixture_free(&f);
    team_finish(team);
}

/* dump -> data -> h5 -> dump and back to numbers, by one rank. */
static void conversions_close_the_circle(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct comm self = folder_self();
    struct error error = {0};
    fixture_make(&f, team, WITH_SPIN);
    write_frames(&f, -1, 0, 2);
    static const char *const names[] = {"a.data", "b.h5", "c.lammpstrj", "d.h5", "e.data"};
    char from[FOLDER_MAX + 64], to[FOLDER_MAX + 64];
    struct convert_options options = {0};
    for (int k = 0; team->comm.rank == 0 && k < 5; k++) {
        folder_file(&f.folder, k ? names[k - 1] : "dump.lammpstrj", from);
        folder_file(&f.folder, names[k], to);
        team_expect(team, convert_file(from, to, &options, &self, &error), "%s", error.text);
    }
    if (team->comm.rank == 0) {
        struct rows rows;
        if (team_expect(team, lammps_data_read(to, &rows, &error), "%s", error.text)) {
            expect_rows(&f, &rows);
            rows_free(&rows);
        }
        team_expect(team, !convert_file(from, to, &options, &self, &error), "written over");
        team_expect(team, strstr(error.text, "there already") != NULL, "%s", error.text);
        error = (struct error){0};
        folder_file(&f.folder, "frames.h5", to);
        uint64_t frames = 0;
        team_expect(team, convert_file(f.path, to, &options, &self, &error), "%s", error.text);
        team_expect(team, h5md_read_frames(to, NULL, &frames, &error) && frames == 2, "%d frames: %s",
                    (int)frames, error.text);
        folder_file(&f.folder, "again.xdmf", from);
        team_expect(team, convert_file(to, from, &options, &self, &error), "%s", error.text);
        size_t length;
        char *text = read_text(from, &length);
        team_expect(team, strstr(text, "frames.h5:/particles/all/position/value") != NULL, "%s", text);
        memory_free(text);
    }
    fixture_free(&f);
    team_finish(team);
}

/* A checkpoint as data, H5MD and dump: the particles, with the velocities of the checkpoint. */
static void checkpoint_is_converted(void **state) {
    struct team *team = *state;
    static const char *const names[] = {"a.data", "a.h5", "a.lammpstrj"};
    for (unsigned features = 0; features <= WITH_ALL; features += WITH_ALL) {
        struct fixture f;
        struct comm self = folder_self();
        struct error error = {0};
        fixture_make(&f, team, features);
        struct checkpoint checkpoint = {.numbers = {.step = 70, .time = 0.25},
                                        .particles = f.particles,
                                        .box = &f.cloud.box,
                                        .law = "hertz",
                                        .scene = "title: a test\n"};
        team_expect(team,
                    checkpoint_write(&team->comm, f.folder.path, CHECKPOINT_STOPPED, &checkpoint, 0, &error),
                    "%s", error.text);
        char from[FOLDER_MAX + 64], to[FOLDER_MAX + 64];
        folder_file(&f.folder, "checkpoint-70-stopped.h5", from);
        for (int k = 0; team->comm.rank == 0 && k < 3; k++) {
            struct convert_options options = {0};
            struct h5md_read_options first = {0};
            struct rows rows = {0};
            folder_file(&f.folder, names[k], to);
            bool good = convert_file(from, to, &options, &self, &error) &&
                        (k == 0   ? lammps_data_read(to, &rows, &error)
                         : k == 1 ? h5md_read(to, &first, NULL, &rows, &error)
                                  : dump_read(to, 0, &rows, &error));
            if (!team_expect(team, good, "%s: %s", names[k], error.text))
                continue;
            team_expect(team, k == 0 || rows.step == 70, "%s: step %d", names[k], (int)rows.step);
            team_expect(team, k != 1 || rows.time == 0.25, "%s: time %g", names[k], rows.time);
            for (size_t i = 0; features > 0 && i < rows.count; i++)
                team_expect(team,
                            rows.image &&
                                rows.image[i][0] == cloud_value(rows.id[i], cloud_code("image"), 0, STAMP),
                            "%s: image of row %zu", names[k], i);
            expect_rows(&f, &rows);
            rows_free(&rows);
        }
        if (team->comm.rank == 0) {
            struct h5md_read_options first = {0};
            struct rows rows;
            team_expect(team, !h5md_read(from, &first, NULL, &rows, &error), "read as H5MD");
            team_expect(team, strstr(error.text, "scree convert") != NULL, "%s", error.text);
        }
        fixture_free(&f);
        team_finish(team);
    }
}

/* Data files: a correct file, then the same file with one mistake. */

static const char good_data[] =
    "a title\n\n2 atoms\n1 atom types\n\n0 10 xlo xhi\n0 10 ylo yhi\n-1 1 zlo zhi\n\nAtoms # sphere\n\n"
    "2 1 2.0 3.0 1 2 0.5 0 -1 2\n1 1 1.0 3.0 4 5 -0.5\n\nVelocities\n\n1 1 2 3 4 5 6\n2 0 0 0 0 0 0\n";

static void write_text(const char *path, const char *text) {
    FILE *file = fopen(path, "w");
    fputs(text, file);
    fclose(file);
}

static void data_file_is_read(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct rows rows;
    struct error error = {0};
    fixture_make(&f, team, 0);
    if (team->comm.rank == 0) {
        write_text(f.path, good_data);
        if (team_expect(team, lammps_data_read(f.path, &rows, &error), "%s", error.text)) {
            team_expect(team, rows.count == 2 && rows.id[0] == 2 && rows.radius[0] == 1, "first row");
            team_expect(team, fabs(rows.mass[1] - 3 * M_PI / 6) < 1e-15, "mass %g", rows.mass[1]);
            team_expect(team, rows.velocity[1][2] == 3 && rows.angular_velocity[1][0] == 4, "velocity");
            team_expect(team, rows.image[0][2] == 2 && rows.position[1][2] == -0.5 && rows.lower[2] == -1,
                        "places");
            rows_free(&rows);
        }
    }
    fixture_free(&f);
    team_finish(team);
}

static void wrong_data_is_refused(void **state) {
    struct team *team = *state;
    static const struct {
        const char *old, *new, *expected;
    } cases[] = {
        {"2 atoms", "3 atoms", ":15: the section before this has 2 lines"},
        {"2 atoms", "many atoms", ":3: "},
        {"2 atoms\n", "\n", "N atoms"},
        {"2 atoms", "20000000 atoms", "too short"},
        {"0 10 ylo yhi\n", "", "ylo yhi"},
        {"0 10 ylo yhi", "10 0 ylo yhi", ":7: "},
        {"-1 1 zlo zhi\n", "-1 1 zlo zhi\n1 0 1 xy xz yz\n", "several tilts"},
        {"# sphere", "# full", "\"full\""},
        {"1 1 1.0 3.0 4 5 -0.5", "1 1 1.0 3.0 4 5", ":13: "},
        {"1 1 1.0 3.0 4 5 -0.5", "1 1 1.0 3.0 4 five -0.5", ":13: "},
        {"1 1 1.0 3.0 4 5 -0.5", "1 1 1.0 3.0 4 nan -0.5", ":13: "},
        {"1 1 1.0 3.0 4 5 -0.5", "1 1 -1.0 3.0 4 5 -0.5", "positive"},
        {"1 1 1.0 3.0 4 5 -0.5", "1 2 1.0 3.0 4 5 -0.5", "type"},
        {"1 1 1.0 3.0 4 5 -0.5", "2 1 1.0 3.0 4 5 -0.5", "has the id of particle"},
        {"1 1 2 3 4 5 6", "9 1 2 3 4 5 6", "id 9"},
        {"1 1 2 3 4 5 6", "1 1 2 3 4", ":17: "},
        {"Velocities", "Speeds", "Speeds"},
    };
    struct fixture f;
    fixture_make(&f, team, 0);
    for (size_t k = 0; team->comm.rank == 0 && k < sizeof cases / sizeof cases[0]; k++) {
        char text[1024];
        const char *place = strstr(good_data, cases[k].old);
        snprintf(text, sizeof text, "%.*s%s%s", (int)(place - good_data), good_data, cases[k].new,
                 place + strlen(cases[k].old));
        write_text(f.path, text);
        struct rows rows;
        struct error error = {0};
        team_expect(team, !lammps_data_read(f.path, &rows, &error), "case %zu is accepted", k);
        team_expect(team,
                    error.kind == ERROR_USER && strstr(error.text, f.path) &&
                        strstr(error.text, cases[k].expected),
                    "case %zu: %s", k, error.text);
    }
    fixture_free(&f);
    team_finish(team);
}

static void wrong_dumps_are_refused(void **state) {
    struct team *team = *state;
    static const char good[] =
        "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp ff\n0 2\n0 2\n0 4\n"
        "ITEM: ATOMS id type diameter xs ys zs\n7 2 1.0 0.5 0.25 0.5\n";
    static const struct {
        const char *old, *new, *expected;
    } cases[] = {
        {"5\n", "five\n", ":2: "},          {"1\nITEM: BOX", "2\nITEM: BOX", ":10: "},
        {"0 4\n", "4 0\n", ":8: "},         {"pp pp ff", "xy xz yz pp pp ff", ":6: "},
        {"xs ys zs", "a b c", "x y z"},     {"0.25 0.5\n", "0.25\n", ":10: "},
        {"7 2 1.0", "0 2 1.0", "column 1"}, {"7 2 1.0", "7 0 1.0", "column 2"},
        {"0.25", "inf", "column 5"},        {"ITEM: NUMBER", "ITEM: NOMBER", ":3: "},
    };
    struct fixture f;
    fixture_make(&f, team, 0);
    for (size_t k = 0; team->comm.rank == 0 && k <= sizeof cases / sizeof cases[0]; k++) {
        char text[1024];
        bool right = k == sizeof cases / sizeof cases[0];
        const char *place = right ? good : strstr(good, cases[k].old);
        snprintf(text, sizeof text, "%.*s%s%s", (int)(place - good), good, right ? "" : cases[k].new,
                 place + (right ? 0 : strlen(cases[k].old)));
        write_text(f.path, text);
        struct rows rows;
        struct error error = {0};
        bool read = dump_read(f.path, 0, &rows, &error);
        team_expect(team, read == right, "case %zu: %s", k, error.text);
        if (right && read) {
            team_expect(team, rows.id[0] == 7 && rows.material[0] == 1 && rows.radius[0] == 0.5, "id %d",
                        (int)rows.id[0]);
            team_expect(team, rows.position[0][0] == 1 && rows.position[0][2] == 2 && rows.step == 5,
                        "scaled place");
            rows_free(&rows);
        } else if (!right) {
            team_expect(team, strstr(error.text, f.path) && strstr(error.text, cases[k].expected),
                        "case %zu: %s", k, error.text);
        }
    }
    fixture_free(&f);
    team_finish(team);
}

static void expect_info(struct fixture *f, const char *path, const char *const *expected, int n) {
    struct comm self = folder_self();
    struct error error = {0};
    char *text = NULL;
    size_t size;
    FILE *memory = open_memstream(&text, &size);
    team_expect(f->team, info_print(path, &self, memory, &error), "%s", error.text);
    fclose(memory);
    for (int k = 0; k < n; k++)
        team_expect(f->team, strstr(text, expected[k]) != NULL, "\"%s\" is not in\n%s", expected[k], text);
    free(text);
}

static void info_tells_what_it_is(void **state) {
    struct team *team = *state;
    struct fixture f;
    struct comm self = folder_self();
    struct error error = {0};
    fixture_make(&f, team, WITH_SPIN);
    write_frames(&f, -1, 0, 4);
    if (team->comm.rank == 0) {
        char path[FOLDER_MAX + 64];
        static const char *const dump[] = {"LAMMPS dump", "frames     4", "particles  111", "radii",
                                           "100 ... 111, open"};
        expect_info(&f, f.path, dump, 5);
        struct convert_options options = {0};
        folder_file(&f.folder, "a.h5", path);
        team_expect(team, convert_file(f.path, path, &options, &self, &error), "%s", error.text);
        static const char *const h5md[] = {"H5MD", "frames     4", "steps      0 ... 3", "angular_velocity",
                                           "-5 ... 5, periodic"};
        expect_info(&f, path, h5md, 5);
        folder_file(&f.folder, "a.data", path);
        write_text(path, good_data);
        static const char *const data[] = {"LAMMPS data", "particles  2", "0.5 ... 1"};
        expect_info(&f, path, data, 3);
        write_text(path, "nothing of the kind\n");
        team_expect(team, !info_print(path, &self, stdout, &error), "a text is something");
        team_expect(team, strstr(error.text, "is none of") != NULL, "%s", error.text);
    }
    fixture_free(&f);
    team_finish(team);
}

TEAM_MAIN(dump, team_case(dump_comes_back), team_case(dump_goes_on), team_case(conversions_close_the_circle),
          team_case(checkpoint_is_converted), team_case(data_file_is_read), team_case(wrong_data_is_refused),
          team_case(wrong_dumps_are_refused), team_case(info_tells_what_it_is))
