/* SPDX-License-Identifier: BSD-3-Clause */
/* The simulation box. Everything inside the program is box-relative: the box's lower corner is the origin, so
 * a scene far from zero loses no digits. Only scene/ and output/ add or subtract `origin`. */
#ifndef SCREE_PARTICLES_BOX_H
#define SCREE_PARTICLES_BOX_H

#include "base/image.h"
#include <math.h>
#include <stdbool.h>
#include <stdint.h>

/* Treatment of a particle whose centre leaves through an open side. */
enum box_leave { BOX_KEEP, BOX_DELETE, BOX_ERROR };

/* The motion of a periodic box. Images of a particle lie at x + n_d (edge of d), and an image one edge up the
 * gradient of a shear also at `offset` along the flow (Lees and Edwards, J. Phys. C 5 (1972) 1921). The lower
 * corner stays. Images move with the box: they have velocities of their own, `speed` and `slide`. If these
 * velocities change, each particle gets the change of the mean flow at its place (box_accelerate), so that a
 * particle and its image go on as images of each other. */
struct box_motion {
    bool moves; /* the box shears or strains; else all members are 0 */
    bool shears;
    int flow, gradient; /* directions of the shear, unlike */
    double shear;       /* wanted rate, 1/time */
    double offset;      /* length; within half an edge of the flow after box_settle */
    double turns;       /* edges that box_settle has taken off the offset since the start */
    double stretch[3];  /* wanted rate of each edge, 1/time */
    double speed[3];    /* change of each edge, length/time */
    double slide;       /* change of the offset, length/time */
};

/* What densities of a scene mean: mass over the volume of a sphere; in two dimensions also over the area of its disc. */
enum box_density { BOX_DENSITY_VOLUME, BOX_DENSITY_AREA };

struct box {
    int dimension;              /* 2 or 3; in 2D nothing moves in z and the box is one particle thick */
    double origin[3];           /* lower corner in the user's coordinates, length unit */
    double edge[3];             /* edge lengths, > 0, length unit */
    bool periodic[3];           /* per direction; never set for z in 2D */
    enum box_leave leave[3][2]; /* per direction, lower and upper side; ignored where periodic */
    struct box_motion motion;
    enum box_density density; /* AREA in 2D alone */
};

/* Smallest squared distance of two points of the box at rest over their periodic images. */
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

/* The same for the velocity (length/time) that an image adds to that of its original. */
void box_image_velocities(const struct box *box, double velocity[IMAGE_CODES][4]);

/* The vector (length unit) that `image`, in edges of the box, adds to a position. */
static inline void box_shift(const struct box *box, const int32_t image[3], double shift[3]) {
    for (int d = 0; d < 3; d++)
        shift[d] = image[d] * box->edge[d];
    if (box->motion.shears)
        shift[box->motion.flow] += image[box->motion.gradient] * box->motion.offset;
}

/* The image whose shift is a vector, up to less than half an edge. */
void box_images(const struct box *box, const double vector[3], int32_t image[3]);

/* The velocity (length/time) that `image` adds to that of its original. */
static inline void box_drift(const struct box *box, const int image[3], double drift[3]) {
    for (int d = 0; d < 3; d++)
        drift[d] = image[d] * box->motion.speed[d];
    if (box->motion.shears)
        drift[box->motion.flow] += image[box->motion.gradient] * box->motion.slide;
}

/* The vector that leads from the wrapped position of a particle to where it would be if it had never been
 * wrapped; `crossed` as counted by particles_wrap. */
void box_unwrap(const struct box *box, const int32_t crossed[3], double shift[3]);

/* The change of the velocity (length/time) on that way. */
void box_unwrap_velocity(const struct box *box, const int32_t crossed[3], double change[3]);

/* Brings a box-relative position into the box, up to rounding. The velocity becomes that of the image in the box; NULL: no
 * velocity goes with the position. */
void box_wrap(const struct box *box, double x[3], double velocity[3]);

/* The velocity (length/time) of the mean flow at a box-relative position: that of a shear is 0 in the middle
 * of the box, that of a strain at the lower corner. Any thread. */
void box_flow(const struct box *box, const double x[3], double velocity[3]);

/* Sets the velocities of the images to the wanted rates. `change` gets the changes of speed (0..2) and slide (3);
 * false if all are 0. */
bool box_follow(struct box *box, double change[4]);

/* The change of velocity of a particle at x where the velocities of the images change. */
void box_accelerate(const struct box *box, const double change[4], const double x[3], double velocity[3]);

/* The rates of the mean flow, added up: no difference of velocities is larger than this times the distance. */
double box_rate(const struct box *box);

/* Moves the box by dt. */
void box_advance(struct box *box, double dt);

/* Takes whole edges off the offset, so that images up to one edge away are the near ones. Only at a rebuild,
 * as the images of pairs change. */
void box_settle(struct box *box);

/* The deformation since `then`, of the same box: a point that moved with the mean flow from x came to
 * x + u, and u is the result. */
void box_affine(const struct box *now, const struct box *then, const double x[3], double u[3]);

/* By which part of itself a vector can have become shorter in the deformation since `then`: 1 less the
 * smallest singular value of the deformation, at least 0. */
double box_nearing(const struct box *now, const struct box *then);

/* True if particles may leave through an open side and be deleted. */
bool box_may_lose(const struct box *box);

#endif
