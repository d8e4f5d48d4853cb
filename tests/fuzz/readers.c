/* SPDX-License-Identifier: BSD-3-Clause */
/* The readers of text under libFuzzer (clang): what a user may hand over as a file or on the command line is
 * read, or refused with a message, and nothing else happens. The environment names the reader:
 * SCREE_FUZZ=dump. See run.sh.
 *
 * HDF5 files are not among these: a checkpoint is guarded by checksums, and what lies behind them is HDF5's
 * own reading. */
#include "base/memory.h"
#include "base/numbers.h"
#include "data/formats/dump.h"
#include "data/formats/frame.h"
#include "data/formats/info.h"
#include "data/formats/lammps_data.h"
#include "data/scene/scene_particles.h"
#include "data/scene/scene_read.h"
#include "physics/grains/walls/mesh.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int LLVMFuzzerInitialize(int *argc, char ***argv);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* An input: its bytes, as a text where it is one, and as a file. */
struct input {
    const uint8_t *data;
    size_t size;
    char text[1 << 16]; /* ended by a zero byte */
    char path[64];
};

static const char frame[] = "box: {lower: [0, 0, 0], upper: [1, 1, 1]}\n"
                            "step: {count: 1}\n"
                            "contact: {law: hooke}\n"
                            "materials: [{name: glass, density: 1}, {name: steel, density: 2}]\n"
                            "material_pairs: [{restitution: 0.5, k_n: 1}]\n"
                            "particles: {file: %s, format: %s}\n";

/* Ends the program, which libFuzzer reports with the input. */
static void complain(const char *what, const char *text) {
    fprintf(stderr, "%s\n%s\n", what, text);
    abort();
}

/* A refusal says why. */
static void refused(const struct error *error) {
    if (error->kind == ERROR_NONE || error->text[0] == '\0')
        complain("refused without a message", "");
}

/* Looks at all that a reader gave, so that the sanitizers see what it left unset or too short. */
static void look_at(const struct rows *rows) {
    volatile double sum = 0;
    for (size_t k = 0; k < rows->count; k++) {
        for (int d = 0; d < 3; d++) {
            sum += rows->position ? rows->position[k][d] : 0;
            sum += rows->velocity ? rows->velocity[k][d] : 0;
            sum += rows->angular_velocity ? rows->angular_velocity[k][d] : 0;
            sum += rows->image ? rows->image[k][d] : 0;
        }
        sum += rows->radius ? rows->radius[k] : 0;
        sum += rows->mass ? rows->mass[k] : 0;
        sum += rows->id ? (double)rows->id[k] : 0;
        sum += rows->material ? rows->material[k] : 0;
    }
    (void)sum;
}

/* What is echoed is the same scene. */
static void fuzz_scene(const struct input *input) {
    struct error error = {0};
    struct scene *scene = scene_parse("case/scene.yaml", input->text, NULL, 0, &error);
    if (scene == NULL) {
        refused(&error);
        return;
    }
    char *echo = scene_echo(scene), *again = NULL;
    struct scene *second = scene_parse("echo.yaml", echo, NULL, 0, &error);
    if (second == NULL)
        complain(error.text, echo);
    again = scene_echo(second);
    if (strcmp(echo, again) != 0)
        complain(echo, again);
    memory_free(again);
    memory_free(echo);
    scene_free(&second);
    scene_free(&scene);
}

/* --set KEY=VALUE, lines apart. */
static void fuzz_setting(const struct input *input) {
    enum { SETTINGS_MAX = 8 };
    struct scene_setting setting[SETTINGS_MAX];
    char text[sizeof frame + 40], lines[sizeof input->text], *rest = lines;
    struct error error = {0};
    int settings = 0;
    snprintf(text, sizeof text, frame, "/dev/null", "table");
    strcpy(lines, input->text);
    for (char *line; settings < SETTINGS_MAX && (line = strtok_r(rest, "\n", &rest)) != NULL;)
        setting[settings++].text = line;
    struct scene *scene = scene_parse("scene.yaml", text, setting, settings, &error);
    if (scene == NULL)
        refused(&error);
    scene_free(&scene);
}

static void print_info(const struct input *input) {
    static const char hdf5[] = "\211HDF", checkpoint[] = "scree checkpoint";
    struct error error = {0};
    const struct comm none = {0};
    FILE *nowhere = fopen("/dev/null", "w");
    if (nowhere && strncmp(input->text, hdf5, 4) != 0 && strncmp(input->text, checkpoint, 16) != 0 &&
        !info_print(input->path, &none, nowhere, &error))
        refused(&error);
    if (nowhere)
        fclose(nowhere);
}

static void fuzz_lammps_data(const struct input *input) {
    struct rows rows;
    struct error error = {0};
    if (lammps_data_read(input->path, &rows, &error)) {
        look_at(&rows);
        rows_free(&rows);
        print_info(input);
    } else {
        refused(&error);
    }
}

static void fuzz_dump(const struct input *input) {
    for (int64_t frame_number = -1; frame_number <= 0; frame_number++) {
        struct rows rows;
        struct error error = {0};
        if (dump_read(input->path, frame_number, &rows, &error)) {
            look_at(&rows);
            rows_free(&rows);
        } else {
            refused(&error);
        }
    }
    print_info(input);
}

static void fuzz_mesh(const struct input *input) {
    struct mesh mesh;
    struct error error = {0};
    if (mesh_read(&mesh, input->path, "auto", &error)) {
        volatile double last = mesh.corner[mesh.count - 1][8];
        (void)last;
        mesh_free(&mesh);
    } else {
        refused(&error);
    }
}

static void fuzz_numbers(const struct input *input) {
    struct numbers numbers;
    struct error error = {0};
    if (numbers_read(&numbers, input->path, 7, &error)) {
        volatile double sum = 0;
        for (size_t k = 0; k < numbers.rows * 7; k++)
            sum += numbers.value[k];
        (void)sum;
        numbers_free(&numbers);
    } else {
        refused(&error);
    }
}

/* A file of particles, up to the particles. */
static void fuzz_source(const struct input *input, const char *format) {
    char text[sizeof frame + 80];
    struct error error = {0};
    snprintf(text, sizeof text, frame, input->path, format);
    struct scene *scene = scene_parse("scene.yaml", text, NULL, 0, &error);
    if (scene == NULL)
        complain(error.text, text);
    struct particles *particles = particles_create(0);
    frame_register_all(particles);
    struct scene_share share = {.size = 1};
    struct scene_census census;
    if (!scene_particles(scene, &share, particles, &census, &error))
        refused(&error);
    particles_destroy(&particles);
    scene_free(&scene);
}

static void fuzz_table(const struct input *input) {
    fuzz_source(input, "table");
}

static void fuzz_source_data(const struct input *input) {
    fuzz_source(input, "lammps-data");
}

static const struct reader {
    const char *name;
    void (*read)(const struct input *input);
    bool text; /* takes a text, not a file */
} readers[] = {
    {"scene", fuzz_scene, true},
    {"setting", fuzz_setting, true},
    {"lammps-data", fuzz_lammps_data, false},
    {"source-data", fuzz_source_data, false},
    {"dump", fuzz_dump, false},
    {"mesh", fuzz_mesh, false},
    {"numbers", fuzz_numbers, false},
    {"table", fuzz_table, false},
};

static const struct reader *chosen(void) {
    const char *name = getenv("SCREE_FUZZ");
    for (size_t k = 0; name && k < sizeof readers / sizeof readers[0]; k++)
        if (strcmp(readers[k].name, name) == 0)
            return &readers[k];
    return NULL;
}

int LLVMFuzzerInitialize(int *argc, char ***argv) {
    (void)argc;
    (void)argv;
    if (chosen() == NULL) {
        fprintf(stderr, "SCREE_FUZZ names no reader; known:");
        for (size_t k = 0; k < sizeof readers / sizeof readers[0]; k++)
            fprintf(stderr, " %s", readers[k].name);
        fprintf(stderr, "\n");
        exit(2);
    }
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const struct reader *reader = chosen();
    static struct input input;
    if (size >= sizeof input.text)
        return 0;
    input.data = data;
    input.size = size;
    if (size > 0)
        memcpy(input.text, data, size);
    input.text[size] = '\0';
    if (reader->text && strlen(input.text) != size)
        return 0; /* a file with a zero byte is no text, and no argument can hold one */
    if (!reader->text) {
        snprintf(input.path, sizeof input.path, "input-%d", (int)getpid());
        FILE *file = fopen(input.path, "wb");
        if (file == NULL || fwrite(data, 1, size, file) != size || fclose(file) != 0)
            complain("the input cannot be written to", input.path);
    }
    reader->read(&input);
    if (!reader->text)
        remove(input.path);
    return 0;
}
