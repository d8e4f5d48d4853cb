/* SPDX-License-Identifier: BSD-3-Clause */
/* The simulation box. Everything inside the program is box-relative: the box's lower corner is the origin, so
 * a scene far from zero loses no digits. Only scene/ and output/ add or subtract `origin`. */
#ifndef SCREE_PARTICLES_BOX_H
#define SCREE_PARTICLES_BOX_H

#include "core/image.h"
#include <math.h>
#include <stdbool.h>

/* Treatment of a particle whose centre leaves through an open side. */
enum box_leave { BOX_KEEP, BOX_DELETE, BOX_ERROR };

struct box {
    int dimension;              /* 2 or 3; in 2D nothing moves in z and the box is one particle thick */
    double origin[3];           /* lower corner in the user's coordinates, length unit */
    double edge[3];             /* edge lengths, > 0, length unit */
    bool periodic[3];           /* per direction; never set for z in 2D */
    enum box_leave leave[3][2]; /* per direction, lower and upper side; ignored where periodic */
};

/* Smallest squared distance of two points of the box over their periodic images. */
static inline double box_distance2(const struct box *box, const double a[3], const double b[3]) {
    double sum = 0;
    for (int d = 0; d < 3; d++) {
        double gap = fabs(a[d] - b[d]);
        if (box->periodic[d])
            gap = fmin(gap, fabs(box->edge[d] - gap));
        sum += gap * gap;
    }
    return sum;
}

/* Fills shift[code] with the vector (length unit) that image `code` adds to a position; shift has
 * IMAGE_CODES rows of 4 doubles, the fourth 0. */
void box_image_shifts(const struct box *box, double shift[IMAGE_CODES][4]);

#endif
