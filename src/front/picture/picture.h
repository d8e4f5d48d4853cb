/* SPDX-License-Identifier: BSD-3-Clause */
/* Pictures and films of a run: the particles as shaded spheres and the walls, drawn by POV-Ray, a program of its own.
 * A picture is made in these steps, one file each:
 *
 *     picture_source.h: a frame of a run, and the value that gives each particle its colour
 *         ->  shapes.h: the walls at that time, as triangles and tubes
 *         ->  facets.c: rocks with their faces
 *         ->  camera.h: everything in the coordinates of the camera
 *         ->  paint.h: colours, and the text of the scene for POV-Ray
 *         ->  picture.c: starts POV-Ray and, for a film, ffmpeg */
#ifndef SCREE_PICTURE_PICTURE_H
#define SCREE_PICTURE_PICTURE_H

#include "kernel/comm/comm.h"
#include "base/error.h"
#include <stdbool.h>
#include <stdint.h>

/* The wishes of the user, as on the command line; NULL: the default. */
struct picture_options {
    const char *colour;  /* FIELD or FIELD@FRAME */
    const char *range;   /* "LOW,HIGH" */
    const char *bands;   /* number of bands of colour */
    const char *palette; /* name */
    const char *grey;    /* materials, with commas: drawn in grey, and not cut */
    const char *cut;     /* "y<0,x>1": what fulfils all is taken away */
    const char *view;    /* name, or "AZIMUTH,ELEVATION" in degrees */
    const char *size;    /* "WIDTHxHEIGHT" */
    const char *frame;   /* number, negative from the end */
    const char *rate;    /* frames a second of a film */
    bool bare;           /* no walls, no legend */
};

/* Draws `from` (a folder of a run, or a file of particles) into `out`: .png, .mp4 (each frame), or .pov (the text for
 * POV-Ray alone). Wishes that cannot be fulfilled, unknown fields, and missing programs are a user's error. One rank;
 * tells on standard error what cannot be drawn. */
bool picture_draw(const struct comm *comm, const char *from, const char *out,
                  const struct picture_options *options, struct error *error);

#endif
