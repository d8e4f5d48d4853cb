/* SPDX-License-Identifier: BSD-3-Clause */
/* One sphere of a source. */
#ifndef SCREE_SCENE_SOURCE_SPHERE_H
#define SCREE_SCENE_SOURCE_SPHERE_H

#include "data/scene/source_batch.h"

/* One sphere of the stream, positions in the user's coordinates. */
struct source_sphere {
    int64_t id;
    double x[3], v[3], omega[3];
    double radius, density; /* density 0: the material's */
    double given;           /* radius by the source: of a body not that of the ball around it */
    int material, group;    /* material -1: as the source says */
    int32_t image[3];
    int shape, variant; /* as in struct source_row; shape 0: material and radius choose */
    double
        orientation[4]; /* of the body that it becomes, in the frame of the entry; all 0: the entry says it */
    double solid;       /* part of the sphere that is solid */
    long line;          /* in the file; for generators the number within the source */
};

/* Row `k` of a batch as a sphere in the user's coordinates; no group yet, the material as the row says. */
struct source_sphere source_sphere_of(const struct source_options *options, const struct source_batch *batch,
                                      size_t k);

/* The centre, box-relative and wrapped; in two dimensions z is that of the plane. False if place or radius make no sense; such a sphere
 * is refused when it is taken. */
bool source_sphere_at(const struct box *box, const struct source_sphere *sphere, double x[3]);

/* True if the source keeps to radii among which this one is not. */
bool source_sphere_left_out(const struct source_options *options, const struct source_sphere *sphere);

/* The random part of the velocity of the sphere with this id (velocity_sigma of its source). */
void source_sphere_shake(const struct scene *scene, int source, int64_t id, double v[3]);

/* Gives a sphere its material, density, velocity (`shake` added to it) and group by source and scene; x becomes its centre,
 * box-relative and wrapped, with the images counted. Fails (user), with the sphere's place in the file, if
 * the sphere is not allowed. */
bool source_sphere_complete(const struct scene *scene, int source, const struct source_batch *batch,
                            const double shake[3], struct source_sphere *sphere, double x[3],
                            struct error *error);

/* Fills `error` with the place of a sphere (line of its file, else its id) and the text; returns false. */
bool source_sphere_fail(const struct scene *scene, int source, const struct source_sphere *sphere,
                        const char *text, struct error *error);

#endif
