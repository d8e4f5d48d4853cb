/* SPDX-License-Identifier: BSD-3-Clause */
/* Conversions between file formats: LAMMPS data, LAMMPS dump, H5MD and checkpoints in; LAMMPS data, dump,
 * H5MD (with XDMF) and the XDMF of an H5MD file out. From a checkpoint only the particles are converted, for
 * inspection, with velocities of the full step. */
#ifndef SCREE_FORMATS_CONVERT_H
#define SCREE_FORMATS_CONVERT_H

#include "kernel/comm/comm.h"
#include "base/error.h"
#include "data/formats/rows.h"
#include <stdbool.h>
#include <stdint.h>

enum convert_format { CONVERT_BY_NAME, CONVERT_LAMMPS_DATA, CONVERT_LAMMPS_DUMP, CONVERT_H5MD, CONVERT_XDMF };

struct convert_options {
    enum convert_format to; /* BY_NAME: .data/.lammps, .lammpstrj/.dump, .h5, .xdmf */
    bool one_frame;         /* only `frame`; else all (a data file holds one: the last) */
    int64_t frame;          /* from 0, negative from the end */
    bool overwrite;         /* false: an existing output is refused */
};

/* The format of a name ("lammps-data", "lammps-dump", "h5md", "xdmf"); BY_NAME if unknown. */
enum convert_format convert_format_find(const char *name);

/* Reads one frame (from 0, negative from the end) of any file that can be converted, rows sorted by id; without ids in
 * the file they count from 1. `frames`: gets the number of frames; NULL where it is known. comm is that of one rank.
 * rows_free releases. */
bool convert_read(const char *in, int64_t frame, const struct comm *comm, struct rows *rows, uint64_t *frames,
                  struct error *error);

/* Reads the values of any field of a checkpoint by its name, by id, ids rising: component `component` (0 ...), or where it is below 0 the length
 * of a vector. memory_free releases both arrays. comm is that of one rank. False (user) where the checkpoint lacks the field. */
struct h5md_values;
bool convert_values(const char *checkpoint, const char *name, int component, const struct comm *comm,
                    struct h5md_values *values, struct error *error);

/* Converts. comm is that of one rank. */
bool convert_file(const char *in, const char *out, const struct convert_options *options,
                  const struct comm *comm, struct error *error);

#endif
