/* The simulation box. Everything inside the program is box-relative: the box's lower corner is the origin, so
 * a scene far from zero loses no digits. Only scene/ and output/ add or subtract `origin`. */
#ifndef SCREE_PARTICLES_BOX_H
#define SCREE_PARTICLES_BOX_H

#include <math.h>
#include <stdbool.h>

/* What happens to a particle whose centre leaves through an open side. */
enum box_leave { BOX_KEEP, BOX_DELETE, BOX_ERROR };

struct box {
    int dimension;              /* 2 or 3; in 2D nothing moves in z and the box is one particle thick */
    double origin[3];           /* lower corner in the user's coordinates, length unit */
    double edge[3];             /* edge lengths, > 0, length unit */
    bool periodic[3];           /* per direction; never set for z in 2D */
    enum box_leave leave[3][2]; /* per direction, lower and upper side; ignored where periodic */
};

/* A periodic shift of a separation is a code of 5 bits: 0 is no shift, else it names one of the 26 vectors of
 * {-1, 0, 1}^3. The code of the opposite shift is (27 - code) % 27. */
enum { BOX_IMAGE_CODES = 27 };

/* The code of the image vector (sx, sy, sz), each -1, 0 or 1. */
static inline unsigned box_image_code(int sx, int sy, int sz) {
    return (unsigned)((sx + 1) + 3 * (sy + 1) + 9 * (sz + 1) + 14) % 27u;
}

/* The image vector of a code. */
static inline void box_image_vector(unsigned code, int image[3]) {
    int place = (int)(code + 13) % 27;
    image[0] = place % 3 - 1;
    image[1] = place / 3 % 3 - 1;
    image[2] = place / 9 - 1;
}

/* The opposite of an image code. */
static inline unsigned box_image_opposite(unsigned code) {
    return (27u - code) % 27u;
}

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
 * BOX_IMAGE_CODES rows of 4 doubles, the fourth 0. */
void box_image_shifts(const struct box *box, double shift[BOX_IMAGE_CODES][4]);

#endif
