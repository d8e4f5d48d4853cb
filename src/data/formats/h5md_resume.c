/* SPDX-License-Identifier: BSD-3-Clause */
/* Continues a trajectory: data after the step of the checkpoint are cut off, the rest is kept. */
#include "data/formats/h5md_parts.h"
#include "data/formats/h5md_element.h"
#include "data/formats/h5md_head.h"

#include "base/memory.h"

#include <stdio.h>
#include <string.h>

/* Reads a whole series of integers (on every rank); memory_free. */
static int64_t *read_steps(const struct h5 *h5, const char *dataset, uint64_t *count, struct error *error) {
    struct h5_shape shape;
    if (!h5_get_shape(h5, dataset, &shape, error))
        return NULL;
    if (shape.rank != 1 || shape.type != H5T_INTEGER) {
        error_set(error, ERROR_USER, "%s: %s: is not a series of step numbers", h5->path, dataset);
        return NULL;
    }
    hsize_t start = 0;
    int64_t *step = memory_allocate(shape.size[0], sizeof *step, "steps of a file");
    *count = shape.size[0];
    if (h5_read_block(h5, dataset, FIELD_INT64, &start, &shape.size[0], step, error))
        return step;
    memory_free(step);
    return NULL;
}

/* Cuts all datasets of an element to the frames up to `step`. */
static bool cut_element(const struct h5 *h5, const char *group, const struct h5_names *names, int64_t step,
                        struct error *error) {
    char path[FILE_PATH_MAX];
    snprintf(path, sizeof path, "%s/step", group);
    uint64_t count = 0, kept = 0;
    int64_t *steps = read_steps(h5, path, &count, error);
    if (!steps)
        return false;
    while (kept < count && steps[kept] <= step)
        kept++;
    memory_free(steps);
    bool good = true;
    for (size_t k = 0; good && k < names->count; k++) {
        snprintf(path, sizeof path, "%s/%s", group, names->name[k]);
        good = h5_cut_frames(h5, path, kept, error);
    }
    return good;
}

/* Cuts all elements in a group and in the groups below it. */
static bool cut_group(const struct h5 *h5, const char *group, int64_t step, struct error *error) {
    if (!h5_exists(h5, group))
        return true;
    struct h5_names names;
    bool good = h5_list(h5, group, &names, error), element = false;
    for (size_t k = 0; k < names.count; k++)
        element = element || strcmp(names.name[k], "step") == 0;
    if (good && element)
        good = cut_element(h5, group, &names, step, error);
    for (size_t k = 0; good && !element && k < names.count; k++) {
        char path[FILE_PATH_MAX];
        snprintf(path, sizeof path, "%s/%s", group, names.name[k]);
        if (h5_is_group(h5, path))
            good = cut_group(h5, path, step, error);
    }
    memory_free(names.name);
    return good;
}

static bool recall_element(struct h5md *h5md, const struct h5 *h5, const char *name, struct error *error) {
    struct h5md_found found;
    if (!h5md_find(h5, "/particles/all", name, &found, error))
        return error->kind == ERROR_NONE &&
               error_set(error, ERROR_USER, "%s: %s: there is no such object", h5->path, found.dataset);
    const struct h5_shape shape = found.shape;
    int components = (int)h5md_found_width(&found);
    enum field_type type = shape.type == H5T_FLOAT ? FIELD_DOUBLE
                           : shape.bytes == 4      ? FIELD_INT32
                                                   : FIELD_INT64;
    if (components == 0 || h5md->elements == XDMF_COLUMNS_MAX)
        return error_set(error, ERROR_USER, "%s: %s: is not a table of particles", h5->path, found.dataset);
    bool single = h5md->single;
    h5md->single = type == FIELD_DOUBLE && shape.bytes == 4; /* as the file has it */
    h5md_add_element(h5md, name, type, components, found.frames);
    h5md->single = single;
    h5md->rows = shape.size[found.frames];
    if (found.frames)
        h5md->chunk = shape.chunk[1];
    if (strcmp(name, "id") == 0)
        h5md->varying = found.frames;
    return true;
}

static bool recall_elements(struct h5md *h5md, const struct h5 *h5, struct error *error) {
    struct h5_names names;
    bool good = h5_list(h5, "/particles/all", &names, error);
    for (size_t k = 0; good && k < names.count; k++)
        if (strcmp(names.name[k], "box") != 0 && strcmp(names.name[k], "species") != 0)
            good = recall_element(h5md, h5, names.name[k], error);
    memory_free(names.name);
    return good;
}

static bool recall_frames(struct h5md *h5md, const struct h5 *h5, struct error *error) {
    static const char group[] = "/parameters/frames";
    uint64_t count = 0, count_rows = 0;
    int64_t *step = read_steps(h5, "/parameters/frames/step", &count, error);
    int64_t *rows = read_steps(h5, "/parameters/frames/rows", &count_rows, error);
    double *time = memory_allocate(count, sizeof *time, "times of a file");
    hsize_t start = 0, size = count;
    bool good = step && rows && count == count_rows &&
                h5_read_block(h5, "/parameters/frames/time", FIELD_DOUBLE, &start, &size, time, error);
    for (uint64_t k = 0; good && k < count; k++) {
        struct xdmf_frame frame = {.step = (uint64_t)step[k], .rows = (uint64_t)rows[k], .time = time[k]};
        h5md_remember(h5md, &frame);
    }
    memory_free(step);
    memory_free(rows);
    memory_free(time);
    return good || error_set(error, ERROR_USER, "%s: %s: does not list its frames", h5->path, group);
}

/* Finds the number of contact lists in the file, and their rows. */
static bool recall_lists(struct h5md *h5md, const struct h5 *h5, struct error *error) {
    static const char *const datasets[] = {"/connectivity/contacts/value",
                                           "/connectivity/wall_contacts/value"};
    for (int k = 0; k < 2; k++) {
        struct h5_shape shape;
        if (!h5_exists(h5, datasets[k]))
            continue;
        if (!h5_get_shape(h5, datasets[k], &shape, error))
            return false;
        h5md->lists = shape.size[0];
        h5md->list_rows[k] = shape.size[1];
    }
    return true;
}

bool h5md_recall(struct h5md *h5md, const struct h5 *h5, struct error *error) {
    if (!h5_exists(h5, "/parameters/frames"))
        return true;
    return recall_elements(h5md, h5, error) && recall_frames(h5md, h5, error);
}

bool h5md_check_varying(const struct h5md *h5md, const struct h5 *h5, struct error *error) {
    static const char ids[] = "/particles/all/id";
    if (!h5md->varying || !h5_exists(h5, ids) || h5_is_group(h5, ids))
        return true;
    return error_set(
        error, ERROR_USER,
        "%s: was made for particles that stay the same, and now the scene inserts or deletes some "
        "(insertions, deletions, box.leave: delete); resume into another output directory",
        h5->path);
}

bool h5md_resume(struct h5md *h5md, int64_t step, struct error *error) {
    struct h5 h5;
    if (!h5_open(&h5, h5md->path, h5md->comm, true, error))
        return false;
    static const char *const groups[] = {"/particles/all", "/observables", "/connectivity",
                                         "/parameters/frames"};
    bool good = h5md_check_varying(h5md, &h5, error);
    for (size_t k = 0; good && k < sizeof groups / sizeof groups[0]; k++)
        good = cut_group(&h5, groups[k], step, error);
    good = good && h5md_recall(h5md, &h5, error) && recall_lists(h5md, &h5, error) &&
           h5md_write_runs(h5md, &h5, error);
    if (!h5_close(&h5, error) || !good)
        return false;
    h5md->made = true;
    return h5md_update_xdmf(h5md, true, error);
}
