/* SPDX-License-Identifier: BSD-3-Clause */
/* Private part of what reads H5MD files: an element of a group of particles, as the file has it. */
#ifndef SCREE_FORMATS_H5MD_ELEMENT_H
#define SCREE_FORMATS_H5MD_ELEMENT_H

#include "data/formats/h5.h"

/* A dataset with one table a frame, or one table for all frames. */
struct h5md_found {
    char dataset[FILE_PATH_MAX];
    bool frames;
    struct h5_shape shape; /* frames, if there are frames; rows; values of a row, if there are several */
};

/* Finds GROUP/NAME. Returns false without an error if there is no such element. */
bool h5md_find(const struct h5 *h5, const char *group, const char *name, struct h5md_found *found,
               struct error *error);

/* The values of a row by the shape, 1 if the table has one value a row; 0 if the element is no table of rows. */
uint64_t h5md_found_width(const struct h5md_found *found);

/* Reads `count` rows from row `first` on, of `width` values each, in one frame. */
bool h5md_found_read(const struct h5 *h5, const struct h5md_found *found, uint64_t frame,
                     const struct h5_table *rows, void *data, struct error *error);

#endif
