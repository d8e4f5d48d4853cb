/* SPDX-License-Identifier: BSD-3-Clause */
/* Colours, the rocks of a frame, and the text of a picture in the language of POV-Ray. */
#ifndef SCREE_PICTURE_PAINT_H
#define SCREE_PICTURE_PAINT_H

#include "data/formats/rows.h"
#include "front/picture/camera.h"
#include "front/picture/shapes.h"
#include "front/picture/picture_source.h"
#include "physics/bodies/bodies.h"
#include <stdio.h>

/* The shapes of the rocks of a run (physics/bodies/rock.h), as what POV-Ray draws of them: faces, and edges and corners with their rounding. */

struct facets {
    int shapes;
    struct clump *shape; /* by number; those of clumps are empty */
};

/* Makes the shapes once, for all frames. None where the scene has none, or is NULL; and, with a user's error, where one cannot be
 * made. facets_free releases. */
bool facets_make(struct facets *facets, const struct scene *scene, struct error *error);
void facets_free(struct facets *facets);

/* True if the rows of a frame tell the orientations of rocks, or there are none; else a user's error. */
bool facets_told(const struct facets *facets, const char *path, const struct rows *rows, struct error *error);

/* The number of the shape of row k; -1: it is no rock. */
int facets_shape(const struct facets *facets, const struct rows *rows, size_t k);

/* Declares the shapes: R0, R1, ... */
void facets_declare(FILE *out, const struct facets *facets);

/* Writes row k, without its texture; false: it is a sphere, or drawn as one. */
bool facets_write(FILE *out, const struct facets *facets, const struct camera *camera,
                  const struct rows *rows, size_t k);

enum { PAINT_BANDS_MAX = 128, PAINT_GREY = -1, PAINT_WORD_MAX = 64 };

/* What each value is painted with. */
struct paint {
    double low, high; /* values of the first and the last colour */
    int bands;
    double band[PAINT_BANDS_MAX][3]; /* red, green, blue, 0 ... 255 */
    char label[2 * PAINT_WORD_MAX];
    int names; /* materials by name; 0: the legend has numbers */
    char name[PAINT_BANDS_MAX][PAINT_WORD_MAX];
};

/* Fills the bands from a palette; unknown names are a user's error that lists the palettes. NULL: "scree". */
bool paint_bands(struct paint *paint, const char *palette, int bands, struct error *error);

/* What a picture shows. */
struct paint_scene {
    const struct camera *camera;
    const struct paint *paint;
    const struct rows *rows;
    const int *band;             /* of each row; PAINT_GREY, or PAINT_GREY - 1: not drawn */
    const struct facets *facets; /* of rocks */
    const struct shapes *shapes; /* NULL: none */
    bool soft;                   /* shadows with soft edges, which take four times as long */
};

/* The band of a value; PAINT_GREY for NAN. */
int paint_band(const struct paint *paint, double value);

/* Writes the picture. */
void paint_write(FILE *out, const struct paint_scene *scene);

#endif
