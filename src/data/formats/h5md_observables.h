/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows of observables in the H5MD file. */
#ifndef SCREE_FORMATS_H5MD_OBSERVABLES_H
#define SCREE_FORMATS_H5MD_OBSERVABLES_H

#include "base/error.h"
#include <stdbool.h>
#include <stdint.h>

struct h5md;
struct h5;

/* Keeps a row of observables (`columns` values, the same columns each time; names and units are borrowed as
 * long as h5md lives), until the next frame or the end writes the row to /observables/NAME. All ranks call
 * alike. */
struct h5md_observables {
    int columns;
    const char *const *name;
    const char *const *unit;
    const double *value;
    uint64_t step;
    double time;
};
void h5md_add_observables(struct h5md *h5md, const struct h5md_observables *row);

/* Writes the waiting rows to the open file; private to the writer. Collective. */
bool h5md_write_observables(struct h5md *h5md, const struct h5 *h5, struct error *error);

#endif
