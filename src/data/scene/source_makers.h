/* SPDX-License-Identifier: BSD-3-Clause */
/* Makers of particles, one a kind of source, and what they share: for scene_particles.c. */
#ifndef SCREE_DATA_SCENE_SOURCE_MAKERS_H
#define SCREE_DATA_SCENE_SOURCE_MAKERS_H

#include "data/scene/placegrid.h"
#include "data/scene/scene_share.h"
#include "data/scene/source_batch.h"
#include "data/scene/source_sphere.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Spheres on a lattice. */

/* Places spheres on a lattice, cell by cell, into an empty batch. Fails (user) where they
 * are too many or too few. */
bool lattice_make(const struct scene *scene, int source, struct source_batch *batch, struct error *error);

/* Spheres at random places. */

/* Places the spheres of all random sources, the largest of all first, without touching each other, spheres in
 * `grid` (which receives the new ones) or taken places (share->taken). Fills batch[S] for each random source S;
 * the caller frees the batches, also after a failure. Each sphere's places depend on seed, source and its
 * number alone. */
bool scatter_make(const struct scene *scene, const struct scene_share *share, struct placegrid *grid,
                  struct source_batch *batch, struct error *error);

/* Plain tables of particles. */

/* Reads the table of a source of kind SOURCE_FILE into an empty batch. Fails with file, line, column. */
bool table_read(const struct scene *scene, int source, struct source_batch *batch, struct error *error);

/* Sets `names` if the table has a column of shapes. */
bool table_names_shapes(const struct scene *scene, int source, bool *names, struct error *error);

/* Bodies of files. */

/* After an H5MD file has been read: fills batch->form and the orientations, and takes out the rows of members, if the file has
 * bodies. Fails (user) where the scene lacks their shapes. */
bool source_bodies_take(const struct scene *scene, int source, struct source_batch *batch,
                        struct error *error);

/* Ids of the particles of a scene. An id that a file or the scene names stands. The particles without one are
 * numbered from 1 on, in the order of the sources; the numbers leave out all ids that are named. So the ids
 * depend on the scene alone, and a new id clashes with no other. */

/* Zeroed: no id is named yet. */
struct source_ids {
    int64_t *named; /* by all sources; sorted by source_ids_begin */
    size_t count, passed;
    int64_t last; /* new id */
};

/* Collects the ids that the sources name; `batch`: those of all sources, in their order. One thread. */
void source_ids_begin(struct source_ids *ids, const struct scene *scene, const struct source_batch *batch);

/* The id of row `row`; new ids are given in the order of the calls. */
int64_t source_ids_give(struct source_ids *ids, const struct source_options *options,
                        const struct source_batch *batch, size_t row);

void source_ids_free(struct source_ids *ids);

/* Finds keys that occur twice in a stream: keys are collected, sorted once, and neighbours compared. */

struct unique_entry {
    uint64_t key;          /* a hash: equal keys count as equal things */
    int64_t id;            /* of the particle */
    uint32_t line, source; /* place of the entry; order among equal keys */
};

/* Zeroed: empty. */
struct unique {
    struct unique_entry *entry;
    size_t count, capacity;
};

/* Makes room for `capacity` entries. */
void unique_reserve(struct unique *unique, size_t capacity);
void unique_add(struct unique *unique, const struct unique_entry *entry);

/* Sorts, and gives the first two entries of one key (in the order of source and line); false if all differ.
 */
bool unique_find_twice(struct unique *unique, const struct unique_entry **first,
                       const struct unique_entry **second);

void unique_free(struct unique *unique);

/* Inside of scene/: the lines of a plain table and their words, whatever their lengths. */

/* A walk over the lines of a text. A copy of the struct walks on its own in `at` and `number`, but shares the
 * three buffers. */
struct table_lines {
    const char *at; /* the rest of the text; borrowed */
    long number;    /* of the line last taken, from 1; 0: none yet */
    char *line;     /* the line last taken, without comment; owned, as are the next two */
    char *comment;  /* the last comment that stood alone and was kept; "" before */
    char *words;    /* of table_lines_words */
};

/* Begins at the start of a text, which must live until table_lines_close. */
void table_lines_open(struct table_lines *lines, const char *text);
void table_lines_close(struct table_lines *lines);

/* Takes the next line with something on it; false at the end of the text. Comments (# to the end) are cut
 * off; one that stands alone is kept in `comment` if `keep_comment`. */
bool table_lines_next(struct table_lines *lines, bool keep_comment);

/* A copy of one of the lines, good until the next call, to be cut by table_lines_word. */
char *table_lines_words(const struct table_lines *lines, const char *line);

/* Cuts the next word off a line (blanks, tabs, commas and semicolons stand between words); NULL at its end.
 */
char *table_lines_word(char **line);

/* Number of words on a line. */
int table_lines_count(const char *line);

#endif
