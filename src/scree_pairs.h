/* SPDX-License-Identifier: BSD-3-Clause */
/* scree's contact search for other codes.
 *
 *     cc mycode.c $(pkg-config --cflags --libs scree-index)
 *
 * The library libscree-index has this header alone and needs neither MPI nor HDF5; libscree (scree.h) has these
 * functions, too. All functions are plain C. None prints. Only exhausted memory ends the program. */
#ifndef SCREE_PAIRS_H
#define SCREE_PAIRS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version ("0.1.0"). */
const char *scree_version(void);

/* Spheres among which pairs are sought. All arrays are borrowed for the call. */
struct scree_spheres {
    size_t count;           /* up to 2^27 - 1 */
    const double *position; /* count x 3, length unit; in periodic directions within [0, edge) */
    const double
        *radius;    /* count, 1e-100 to 1e100, length unit; radii and coordinates up to 1e15 x the smallest */
    double edge[3]; /* box edges; where periodic, more than 2 r + margin of every sphere */
    bool periodic[3];
    int dimension; /* 2 (all z alike) or 3 */
};

/* Two spheres nearer than r_i + r_j + margin. x_j + image * edge is the place of j that i meets. */
struct scree_pair {
    uint32_t i, j;
    int8_t image[3];
};

/* Finds all pairs. `index` is a name of `scree help index.name` ("hgrid" is good for any sizes); `margin` >=
 * 0 is added to the sum of the radii; `threads` <= 0: as many as OpenMP offers, else up to 1024. On success *pairs is an array
 * of *found entries, to be released by scree_free; each pair stands once, in no particular order. Returns
 * false where the index cannot serve or an argument is out of range, with the reason in `why` (`room` bytes,
 * may be NULL). May be called from several threads at once, on the caller's own data. */
bool scree_pairs(const char *index, const struct scree_spheres *spheres, double margin, int threads,
                 struct scree_pair **pairs, size_t *found, char *why, size_t room);

/* Releases an array that this library allocated; NULL is allowed. */
void scree_free(void *array);

#ifdef __cplusplus
}
#endif

#endif
