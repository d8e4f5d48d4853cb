/* SPDX-License-Identifier: BSD-3-Clause */
/* The particles of a frame of a run, and one value of each. */
#ifndef SCREE_PICTURE_PICTURE_SOURCE_H
#define SCREE_PICTURE_PICTURE_SOURCE_H

#include "base/file.h"
#include "data/formats/checkpoint_state.h"
#include "data/formats/rows.h"
#include "data/scene/scene.h"

enum { SOURCE_WORD_MAX = 64 };

struct source {
    char path[FILE_PATH_MAX];
    const struct comm *comm;
    bool h5md, checkpoint; /* any field of such files can be read */
    uint64_t frames;
    struct scene *scene; /* of the run; NULL: the file does not tell, or the scene cannot be read here */
    int walls;
    struct checkpoint_wall *wall; /* poses of walls, of a checkpoint; owned */
};

/* Finds the file to draw: `from` itself or, in a folder, trajectory.h5, else the newest checkpoint, else
 * dump.lammpstrj. picture_source_close releases. One rank, as all below. */
bool picture_source_open(struct source *source, const struct comm *comm, const char *from,
                         struct error *error);
void picture_source_close(struct source *source);

/* The text of the effective scene of a run, from the file that picture_source_open would take; memory_free releases. NULL: the
 * file does not tell, or the error is filled. */
char *picture_source_scene(const struct comm *comm, const char *from, struct error *error);

/* The number of a frame that is given as text, negative from the end; NULL: the last. */
bool picture_source_frame(const struct source *source, const char *text, int64_t *frame, struct error *error);

/* Reads a frame (0 ... frames - 1); positions and radii are there. rows_free releases. */
bool picture_source_read(const struct source *source, int64_t frame, struct rows *rows, struct error *error);

/* The field that gives the colour. */
struct picture_source_field {
    char name[SOURCE_WORD_MAX]; /* "speed", "x", "force.z", any field of the trajectory ... */
    char label[2 * SOURCE_WORD_MAX];
    bool other;    /* of another frame */
    int64_t frame; /* that frame */
    bool
        numbered; /* `component` is the one to take; else it stands behind a dot of the name, or the length is taken */
    int component;
};

/* Reads "FIELD" or "FIELD@FRAME"; NULL: the material if there are several, else the radius if radii differ, else the
 * speed. `rows` is any frame. */
bool picture_source_choose(const struct source *source, const char *text, const struct rows *rows,
                           struct picture_source_field *field, struct error *error);

/* The value of each row of a frame, NAN where the other frame lacks the particle; memory_free releases. NULL: error
 * filled. */
double *picture_source_values(const struct source *source, const struct picture_source_field *field,
                              int64_t frame, const struct rows *rows, struct error *error);

#endif
