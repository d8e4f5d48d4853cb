#include "formats/h5md_parts.h"

#include "core/memory.h"
#include "files/file.h"

#include <stdio.h>
#include <string.h>

bool h5md_open(struct h5md **h5md, const struct comm *comm, const char *path, const struct h5md_head *head,
               int64_t resume_step, struct error *error) {
    *h5md = NULL;
    size_t length = strlen(path);
    if (length < 4 || length + 3 > FILE_PATH_MAX || strcmp(path + length - 3, ".h5") != 0)
        return error_set(error, ERROR_USER, "%.200s: the name of an H5MD file must end in .h5", path);
    struct h5md *made = memory_allocate_zero(1, sizeof *made, "H5MD writer");
    made->comm = comm;
    made->dimensionless = head->dimensionless;
    made->varying = head->varying;
    made->xdmf = head->xdmf;
    made->seed = head->seed;
    snprintf(made->path, sizeof made->path, "%s", path);
    snprintf(made->xdmf_path, sizeof made->xdmf_path, "%.*s.xdmf", (int)(length - 3), path);
    made->lineage = head->lineage;
    *h5md = made;
    int64_t present = comm->rank == 0 && resume_step >= 0 && file_size(path) >= 0;
    comm_max_int(comm, &present, 1);
    if (present && !h5md_resume(made, resume_step, error)) {
        struct error ignored = {0};
        made->kept = 0;
        made->xdmf = false;
        h5md_close(h5md, &ignored);
        return false;
    }
    return true;
}

bool h5md_update_xdmf(struct h5md *h5md, bool last, struct error *error) {
    /* long series: not at each frame, so that the work stays in proportion to the frames */
    bool due = h5md->frames > h5md->xdmf_frames + h5md->frames / 1000;
    if (h5md->xdmf && h5md->frames > 0 && (due || (last && h5md->frames != h5md->xdmf_frames))) {
        const char *slash = strrchr(h5md->path, '/');
        struct xdmf_column column[XDMF_COLUMNS_MAX];
        for (int k = 0; k < h5md->elements; k++)
            column[k] = h5md->element[k].shown;
        struct xdmf_content content = {.h5 = slash ? slash + 1 : h5md->path,
                                       .columns = h5md->elements,
                                       .column = column,
                                       .rows = h5md->rows,
                                       .frames = h5md->frames,
                                       .frame = h5md->frame};
        if (h5md->comm->rank == 0)
            xdmf_write(h5md->xdmf_path, &content, error);
        h5md->xdmf_frames = h5md->frames;
    }
    return comm_agree(h5md->comm, error);
}

void h5md_add_observables(struct h5md *h5md, const struct h5md_observables *row) {
    size_t columns = (size_t)row->columns;
    if (h5md->kept == h5md->kept_room) {
        h5md->kept_room = h5md->kept_room ? 2 * h5md->kept_room : 64;
        size_t room = h5md->kept_room;
        h5md->kept_step = memory_resize(h5md->kept_step, room, sizeof *h5md->kept_step, "observables");
        h5md->kept_time = memory_resize(h5md->kept_time, room, sizeof *h5md->kept_time, "observables");
        h5md->kept_value =
            memory_resize(h5md->kept_value, room * columns, sizeof *h5md->kept_value, "observables");
    }
    h5md->observables = row->columns;
    h5md->observable_name = row->name;
    h5md->observable_unit = row->unit;
    h5md->kept_step[h5md->kept] = row->step;
    h5md->kept_time[h5md->kept] = row->time;
    memcpy(h5md->kept_value + h5md->kept * columns, row->value, columns * sizeof *row->value);
    h5md->kept++;
}

static void observable_group(const struct h5md *h5md, int column, char group[2 * OUTPUT_NAME_MAX]) {
    snprintf(group, (size_t)2 * OUTPUT_NAME_MAX, "/observables/%s", h5md->observable_name[column]);
}

/* Makes the groups of all columns; they share step and time. */
static bool make_observables(struct h5md *h5md, const struct h5 *h5, struct error *error) {
    char first[2 * OUTPUT_NAME_MAX], group[2 * OUTPUT_NAME_MAX], value[2 * OUTPUT_NAME_MAX + 8];
    observable_group(h5md, 0, first);
    for (int c = 0; c < h5md->observables; c++) {
        observable_group(h5md, c, group);
        snprintf(value, sizeof value, "%s/value", group);
        if (!h5md_make_element(h5md, h5, group, c > 0 ? first : NULL, error) ||
            !h5_make_series(h5, value, FIELD_DOUBLE, error) ||
            !h5md_write_unit(h5md, h5, value, h5md->observable_unit[c], error))
            return false;
    }
    return true;
}

/* Forgets waiting rows that the file has already, as after a resume. */
static bool drop_known(struct h5md *h5md, const struct h5 *h5, const char *dataset, struct error *error) {
    if (h5md->observed == 0)
        return true;
    int64_t last;
    hsize_t start = h5md->observed - 1, count = 1;
    if (!h5_read_block(h5, dataset, FIELD_INT64, &start, &count, &last, error))
        return false;
    size_t known = 0, columns = (size_t)h5md->observables;
    while (known < h5md->kept && (int64_t)h5md->kept_step[known] <= last)
        known++;
    h5md->kept -= known;
    memmove(h5md->kept_step, h5md->kept_step + known, h5md->kept * sizeof *h5md->kept_step);
    memmove(h5md->kept_time, h5md->kept_time + known, h5md->kept * sizeof *h5md->kept_time);
    memmove(h5md->kept_value, h5md->kept_value + known * columns,
            h5md->kept * columns * sizeof *h5md->kept_value);
    return true;
}

bool h5md_write_observables(struct h5md *h5md, const struct h5 *h5, struct error *error) {
    if (h5md->kept == 0)
        return true;
    char group[2 * OUTPUT_NAME_MAX], dataset[2 * OUTPUT_NAME_MAX + 8];
    observable_group(h5md, 0, group);
    bool present = h5_exists(h5, group);
    if (!present && !make_observables(h5md, h5, error))
        return false;
    snprintf(dataset, sizeof dataset, "%s/step", group);
    struct h5_shape shape;
    if (!h5_get_shape(h5, dataset, &shape, error))
        return false;
    h5md->observed = shape.size[0];
    if (!drop_known(h5md, h5, dataset, error))
        return false;
    bool good = h5_write_series(h5, dataset, FIELD_INT64, h5md->observed, h5md->kept, h5md->kept_step, error);
    snprintf(dataset, sizeof dataset, "%s/time", group);
    good = good &&
           h5_write_series(h5, dataset, FIELD_DOUBLE, h5md->observed, h5md->kept, h5md->kept_time, error);
    double *series = memory_allocate(h5md->kept, sizeof *series, "observables");
    for (int c = 0; good && c < h5md->observables; c++) {
        for (uint64_t k = 0; k < h5md->kept; k++)
            series[k] = h5md->kept_value[k * (uint64_t)h5md->observables + (uint64_t)c];
        observable_group(h5md, c, group);
        snprintf(dataset, sizeof dataset, "%s/value", group);
        good = h5_write_series(h5, dataset, FIELD_DOUBLE, h5md->observed, h5md->kept, series, error);
    }
    memory_free(series);
    if (good) {
        h5md->observed += h5md->kept;
        h5md->kept = 0;
    }
    return good;
}

/* Observables that still wait, if there is a file to put them into. */
bool h5md_flush(struct h5md *h5md, struct error *error) {
    if (h5md->kept == 0 || !h5md->made)
        return true;
    struct h5 h5;
    if (!h5md_reserve(h5md, 1 << 16, error) || !h5_open(&h5, h5md->path, h5md->comm, true, error))
        return false;
    h5md_write_observables(h5md, &h5, error);
    return h5_close(&h5, error);
}

bool h5md_close(struct h5md **h5md, struct error *error) {
    struct h5md *h = *h5md;
    if (!h)
        return true;
    bool good = h5md_flush(h, error) && h5md_update_xdmf(h, true, error);
    memory_free(h->frame);
    memory_free(h->kept_step);
    memory_free(h->kept_time);
    memory_free(h->kept_value);
    memory_free(h);
    *h5md = NULL;
    return good;
}
