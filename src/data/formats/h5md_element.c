/* SPDX-License-Identifier: BSD-3-Clause */
/* Finds and reads an element of an H5MD file. Read h5md_element.h first. */
#include "data/formats/h5md_element.h"

#include <stdio.h>

bool h5md_find(const struct h5 *h5, const char *group, const char *name, struct h5md_found *found,
               struct error *error) {
    *found = (struct h5md_found){0};
    snprintf(found->dataset, sizeof found->dataset, "%.900s/%s", group, name);
    if (!h5_exists(h5, found->dataset))
        return false;
    found->frames = h5_is_group(h5, found->dataset);
    if (found->frames)
        snprintf(found->dataset, sizeof found->dataset, "%.900s/%s/value", group, name);
    return h5_get_shape(h5, found->dataset, &found->shape, error);
}

uint64_t h5md_found_width(const struct h5md_found *found) {
    int more = found->shape.rank - found->frames - 1; /* dimensions of a row */
    return more == 0 ? 1 : more == 1 ? (uint64_t)found->shape.size[found->frames + 1] : 0;
}

bool h5md_found_read(const struct h5 *h5, const struct h5md_found *found, uint64_t frame,
                     const struct h5_table *rows, void *data, struct error *error) {
    int lead = found->frames;
    hsize_t start[3] = {0}, count[3] = {1, 1, 1};
    start[0] = frame;
    start[lead] = rows->first;
    count[lead] = rows->count;
    count[lead + 1] = rows->width;
    return h5_read_block(h5, found->dataset, rows->type, start, count, data, error);
}
