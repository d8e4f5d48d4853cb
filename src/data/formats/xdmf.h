/* SPDX-License-Identifier: BSD-3-Clause */
/* The XDMF file that lets ParaView open an H5MD trajectory: a collection in time of point sets, each pointing
 * into the HDF5 file. The XDMF file is written again each time, whole or not at all. */
#ifndef SCREE_FORMATS_XDMF_H
#define SCREE_FORMATS_XDMF_H

#include "base/error.h"
#include <stdbool.h>
#include <stdint.h>

enum { XDMF_COLUMNS_MAX = 32 };

/* An array of the particles in the HDF5 file. */
struct xdmf_column {
    const char *name;
    const char *dataset; /* path in the HDF5 file */
    bool integer;
    int bytes; /* of one number: 4 or 8 */
    int components;
    bool frames; /* one table a frame, else one for all */
};

struct xdmf_frame {
    uint64_t step, rows; /* rows present */
    double time;
};

struct xdmf_content {
    const char *h5; /* name of the HDF5 file, beside the XDMF file */
    int columns;    /* one of them named "position" */
    const struct xdmf_column *column;
    uint64_t rows; /* rows of the tables */
    uint64_t frames;
    const struct xdmf_frame *frame;
};

/* Writes the file. One rank. */
bool xdmf_write(const char *path, const struct xdmf_content *content, struct error *error);

#endif
