/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows of observables, kept in memory until the file is opened again. */
#include "data/formats/h5md_observables.h"
#include "data/formats/h5md_file.h"

#include "base/memory.h"

#include <stdio.h>
#include <string.h>

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

/* Makes the groups of all columns; the groups share step and time. */
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

/* Drops waiting rows that the file already has, for example after a resume. */
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
