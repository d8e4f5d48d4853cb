/* SPDX-License-Identifier: BSD-3-Clause */
/* Finds the files of a run and reads particles and values. Read picture_source.h first. */
#include "front/picture/picture_source.h"

#include "base/memory.h"
#include "data/formats/checkpoint.h"
#include "data/formats/convert.h"
#include "data/formats/frame.h"
#include "data/formats/h5.h"
#include "data/formats/h5md_read.h"
#include "data/formats/info.h"
#include "data/scene/scene_read.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static bool find_file(struct source *source, const char *from, struct error *error) {
    struct stat found;
    if (stat(from, &found) != 0)
        return error_set(error, ERROR_USER, "%s: there is no such file or folder", from);
    if (!S_ISDIR(found.st_mode)) {
        snprintf(source->path, sizeof source->path, "%s", from);
        return true;
    }
    if (!file_join(source->path, from, "trajectory.h5", error))
        return false;
    if (file_size(source->path) >= 0 || checkpoint_find(from, 0, source->path))
        return true;
    if (!file_join(source->path, from, "dump.lammpstrj", error))
        return false;
    return file_size(source->path) >= 0 ||
           error_set(error, ERROR_USER,
                     "%s: holds nothing to draw: no trajectory.h5, no checkpoint, no dump.lammpstrj", from);
}

/* The text of the scene in a trajectory or checkpoint; NULL: none. */
static char *read_scene(struct source *source, enum info_kind kind, struct error *error) {
    static const char place[] = "/parameters/scene";
    char *text = NULL;
    struct h5 h5;
    if (kind == INFO_H5MD && h5_open(&h5, source->path, NULL, false, error)) {
        if (h5_exists(&h5, place))
            text = h5_read_string(&h5, place, error);
        h5_close(&h5, error);
    }
    struct checkpoint_loaded loaded;
    if (kind == INFO_CHECKPOINT && checkpoint_read_head(source->comm, source->path, &loaded, error)) {
        text = loaded.scene;
        loaded.scene = NULL;
        source->walls = loaded.walls;
        source->wall = loaded.wall;
        loaded.wall = NULL;
        checkpoint_loaded_free(&loaded);
    }
    return text;
}

bool picture_source_open(struct source *source, const struct comm *comm, const char *from,
                         struct error *error) {
    struct rows rows;
    enum info_kind kind;
    *source = (struct source){.comm = comm};
    if (!find_file(source, from, error) || !info_kind(source->path, &kind, error))
        return false;
    source->h5md = kind == INFO_H5MD;
    source->checkpoint = kind == INFO_CHECKPOINT;
    if (!convert_read(source->path, -1, comm, &rows, &source->frames, error))
        return false;
    rows_free(&rows);
    struct error unreadable = {0};
    char *text = read_scene(source, kind, &unreadable);
    /* The scene of a stage has the changes of the stages up to it, so that they do not fit it once more; without stages
     * a scene needs an end, here any. */
    static const struct scene_setting alone[] = {{"stages=[]"}, {"step.count=~"}, {"duration=1"}};
    if (text)
        source->scene = scene_parse(source->path, text, alone, 3, &unreadable);
    if (unreadable.kind != ERROR_NONE)
        fprintf(stderr, "scree: the scene of the run cannot be read, so walls are not drawn: %s\n",
                unreadable.text);
    memory_free(text);
    return true;
}

char *picture_source_scene(const struct comm *comm, const char *from, struct error *error) {
    struct source source = {.comm = comm};
    enum info_kind kind;
    if (!find_file(&source, from, error) || !info_kind(source.path, &kind, error))
        return NULL;
    char *text = read_scene(&source, kind, error);
    memory_free(source.wall);
    return text;
}

void picture_source_close(struct source *source) {
    memory_free(source->wall);
    if (source->scene)
        scene_free(&source->scene);
}

bool picture_source_frame(const struct source *source, const char *text, int64_t *frame,
                          struct error *error) {
    char *end;
    *frame = (int64_t)source->frames - 1;
    if (text == NULL)
        return true;
    int64_t wanted = strtoll(text, &end, 10);
    *frame = wanted < 0 ? wanted + (int64_t)source->frames : wanted;
    if (end == text || *end != '\0')
        return error_set(error, ERROR_USER, "command line: frame '%s': must be a whole number", text);
    return (*frame >= 0 && *frame < (int64_t)source->frames) ||
           error_set(error, ERROR_USER, "%s: has %" PRIu64 " frames, frame %s is wanted", source->path,
                     source->frames, text);
}

/* The last frame before `frame` that has particles; -1: none. */
static int64_t frame_before(const struct source *source, int64_t frame) {
    while (--frame >= 0) {
        struct error ignored = {0};
        struct rows rows;
        if (!convert_read(source->path, frame, source->comm, &rows, NULL, &ignored))
            continue;
        bool full = rows.count > 0;
        rows_free(&rows);
        if (full)
            return frame;
    }
    return -1;
}

bool picture_source_read(const struct source *source, int64_t frame, struct rows *rows, struct error *error) {
    if (!convert_read(source->path, frame, source->comm, rows, NULL, error))
        return false;
    if (rows->position && rows->radius && rows->count > 0)
        return true;
    bool empty = rows->count == 0;
    rows_free(rows);
    int64_t full = empty ? frame_before(source, frame) : -1;
    if (full >= 0)
        return error_set(error, ERROR_USER,
                         "%s: frame %" PRId64 " has no particles; the last one before it that has some: "
                         "--frame %" PRId64,
                         source->path, frame, full);
    return error_set(error, ERROR_USER, "%s: frame %" PRId64 " has no %s", source->path, frame,
                     empty ? "particles" : "positions and radii");
}

static double length_of(const double v[3]) {
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* The value of a row in a field that every kind of file can have; false: no such field. */
static bool common_value(const struct rows *rows, const char *name, size_t k, double *value) {
    bool axis = name[0] >= 'x' && name[0] <= 'z' && name[1] == '\0';
    if (axis)
        *value = rows->position[k][name[0] - 'x'];
    else if (strcmp(name, "radius") == 0)
        *value = rows->radius[k];
    else if (strcmp(name, "speed") == 0 && rows->velocity)
        *value = length_of(rows->velocity[k]);
    else if (strcmp(name, "spin") == 0 && rows->angular_velocity)
        *value = length_of(rows->angular_velocity[k]);
    else if (strcmp(name, "mass") == 0 && rows->mass)
        *value = rows->mass[k];
    else if (strcmp(name, "material") == 0 && rows->material)
        *value = rows->material[k];
    else if (strcmp(name, "id") == 0)
        *value = (double)rows->id[k];
    else
        return false;
    return true;
}

/* The default field of a frame. */
static const char *usual_field(const struct rows *rows) {
    double low = INFINITY, high = 0;
    bool materials = false;
    for (size_t k = 0; k < rows->count; k++) {
        low = fmin(low, rows->radius[k]);
        high = fmax(high, rows->radius[k]);
        materials = materials || (rows->material && rows->material[k] != rows->material[0]);
    }
    return materials ? "material" : high > 1.05 * low ? "radius" : rows->velocity ? "speed" : "z";
}

/* The unit of a field, "" where it is not known. */
static void find_unit(const struct source *source, const char *name, char unit[SOURCE_WORD_MAX]) {
    static const char *const own[][2] = {{"x", "m"},       {"y", "m"},        {"z", "m"},
                                         {"speed", "m/s"}, {"spin", "rad/s"}, {"radius", "m"},
                                         {"mass", "kg"},   {"id", ""},        {"material", ""}};
    unit[0] = '\0';
    if (source->scene == NULL || source->scene->units == SCENE_UNITS_NONE)
        return;
    for (size_t k = 0; k < sizeof own / sizeof own[0]; k++)
        if (strcmp(own[k][0], name) == 0) {
            snprintf(unit, SOURCE_WORD_MAX, "%s", own[k][1]);
            return;
        }
    struct particles *all = particles_create(0);
    frame_register_all(all);
    char plain[SOURCE_WORD_MAX];
    snprintf(plain, sizeof plain, "%.*s", (int)strcspn(name, "."), name);
    int field = fields_find(all, plain);
    const char *found = field >= 0 ? frame_field_get(fields_get(all, field)).unit : NULL;
    if (found && strcmp(found, "1") != 0)
        snprintf(unit, SOURCE_WORD_MAX, "%s", found);
    particles_destroy(&all);
}

bool picture_source_choose(const struct source *source, const char *text, const struct rows *rows,
                           struct picture_source_field *field, struct error *error) {
    const char *given = text ? text : usual_field(rows), *at = strchr(given, '@');
    char unit[SOURCE_WORD_MAX];
    double value;
    *field = (struct picture_source_field){.other = at != NULL};
    snprintf(field->name, sizeof field->name, "%.*s", (int)(at ? at - given : (long)strlen(given)), given);
    if (at && !picture_source_frame(source, at + 1, &field->frame, error))
        return false;
    if (!source->h5md && !source->checkpoint && !common_value(rows, field->name, 0, &value))
        return error_set(
            error, ERROR_USER,
            "command line: --colour %s: %s has no such field; files other than trajectory.h5 and checkpoints "
            "have at most x, y, z, radius, speed, spin, mass, material, id",
            field->name, source->path);
    find_unit(source, field->name, unit);
    snprintf(field->label, sizeof field->label, "%s%s%s%s", given, unit[0] ? " (" : "", unit,
             unit[0] ? ")" : "");
    return true;
}

/* The place of an id in ids that rise; count: none. */
static size_t find_id(const int64_t *id, size_t count, int64_t wanted) {
    size_t low = 0, high = count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (id[middle] < wanted)
            low = middle + 1;
        else
            high = middle;
    }
    return low < count && id[low] == wanted ? low : count;
}

/* Values of any field of the file. */
static bool field_values(const struct source *source, int64_t frame, const char *name, int component,
                         struct h5md_values *values, struct error *error) {
    return source->checkpoint ? convert_values(source->path, name, component, source->comm, values, error)
                              : h5md_read_values(source->path, frame, name, component, values, error);
}

/* Values by id, ids rising: those of the frame that the field is of. */
static bool read_values(const struct source *source, const struct picture_source_field *field, int64_t frame,
                        struct h5md_values *values, struct error *error) {
    struct rows rows;
    double value;
    if (!picture_source_read(source, frame, &rows, error))
        return false;
    if (common_value(&rows, field->name, 0, &value)) {
        *values = (struct h5md_values){.count = rows.count};
        values->id = memory_allocate(rows.count, sizeof *values->id, "ids");
        values->value = memory_allocate(rows.count, sizeof *values->value, "values");
        for (size_t k = 0; k < rows.count; k++) {
            values->id[k] = rows.id[k];
            common_value(&rows, field->name, k, &values->value[k]);
        }
        rows_free(&rows);
        return true;
    }
    rows_free(&rows);
    if (field->numbered)
        return field_values(source, frame, field->name, field->component, values, error);
    const char *dot = strchr(field->name, '.');
    char plain[SOURCE_WORD_MAX];
    snprintf(plain, sizeof plain, "%.*s", (int)strcspn(field->name, "."), field->name);
    int component = dot && dot[1] >= 'x' && dot[1] <= 'z' && dot[2] == '\0' ? dot[1] - 'x' : -1;
    if (dot && component < 0)
        return error_set(error, ERROR_USER, "command line: --colour %s: the component must be x, y or z",
                         field->name);
    return field_values(source, frame, plain, component, values, error);
}

double *picture_source_values(const struct source *source, const struct picture_source_field *field,
                              int64_t frame, const struct rows *rows, struct error *error) {
    struct h5md_values values = {0};
    if (!read_values(source, field, field->other ? field->frame : frame, &values, error))
        return NULL;
    double *value = memory_allocate(rows->count, sizeof *value, "colours");
    for (size_t k = 0; k < rows->count; k++) {
        size_t at = find_id(values.id, values.count, rows->id[k]);
        value[k] = at < values.count ? values.value[at] : NAN;
    }
    memory_free(values.id);
    memory_free(values.value);
    return value;
}
