/* SPDX-License-Identifier: BSD-3-Clause */
/* The camera: a direction of view, and a distance from which all that must be seen is in the picture. */
#ifndef SCREE_PICTURE_CAMERA_H
#define SCREE_PICTURE_CAMERA_H

#include "base/error.h"
#include <stdbool.h>

enum { CAMERA_SIZE = 100 }; /* half the size of what is seen, in units of the camera */

struct camera {
    int width, height;         /* pixels */
    double tangent[2];         /* of half the angle of view, across and up */
    double axis[3][3];         /* right, up, forward; user's coordinates */
    double lower[3], upper[3]; /* of what must be seen: user's coordinates */
    double low[3], high[3];    /* and along the axes */
    double scale, distance;    /* of camera_settle: units of the camera over length; units of the camera */
    bool legend;               /* room on the right */
};

/* Reads "WIDTHxHEIGHT" (NULL: 1280x960) and the view: front, back, left, right, top, corner, or
 * "AZIMUTH,ELEVATION" in degrees, azimuth 0: along +y, to the right: along -x (NULL: corner, in two dimensions top). */
bool camera_aim(struct camera *camera, const char *size, const char *view, int dimension,
                struct error *error);

/* Adds a sphere, or with radius 0 a point, to what must be seen. */
void camera_include(struct camera *camera, const double x[3], double radius);

/* Chooses scale and distance. */
void camera_settle(struct camera *camera);

/* The place of a point: to the right, up, and away from the camera; not `x` itself. */
void camera_place(const struct camera *camera, const double x[3], double place[3]);

/* True if a plane through `x` turns its side `normal` to the camera. */
bool camera_faces(const struct camera *camera, const double x[3], const double normal[3]);

#endif
