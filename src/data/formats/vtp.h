/* SPDX-License-Identifier: BSD-3-Clause */
/* Polygons with values, as a file of VTK's XML format (.vtp): text, then raw arrays, each behind its length in 8 bytes. ParaView opens such
 * files, and a list of them with their times (.pvd). */
#ifndef SCREE_FORMATS_VTP_H
#define SCREE_FORMATS_VTP_H

#include "base/error.h"
#include <stdint.h>
#include <stdio.h>

/* One array. Borrowed. */
struct vtp_array {
    const char *name, *type; /* of VTK: "Float64", "Int64" */
    int bytes, components;   /* of a number; of a row */
    uint64_t rows;
    const void *data;
};

struct vtp_content {
    double time;
    int arrays; /* points, corners of all polygons one after another, ends of the polygons among these, then values of polygons */
    const struct vtp_array *array;
    const char *scalars, *vectors; /* values that ParaView shows first; NULL: none */
    size_t head;                   /* bytes of the text, filled with blanks; 0: as many as it has */
};

/* Writes the file. Errors of the stream are found when it is closed. */
void vtp_write(FILE *file, const struct vtp_content *content);

/* Place of the length of array k behind the text. */
uint64_t vtp_place(const struct vtp_array *array, int k);

#endif
