/* Inside of scene/: what the kinds of particle source share. Each fills a batch, in the user's coordinates;
 * source.c turns batches into particles. */
#ifndef SCREE_SCENE_SOURCE_PARTS_H
#define SCREE_SCENE_SOURCE_PARTS_H

#include "output/rows.h"
#include "scene/finish.h"
#include "scene/placegrid.h"
#include "scene/scene.h"

/* The spheres of one source. */
struct source_batch {
    struct rows rows;     /* position and radius always; mass 0: not given */
    uint32_t *line;       /* line of each row in its file; NULL: the row has no line */
    bool materials_named; /* rows.material is a number of the scene's materials, not a type of the file */
};

void source_batch_free(struct source_batch *batch);

/* A region with REGION_ALL resolved to the box, and how it is asked. */
struct region source_region(const struct scene *scene, const struct region *region,
                            struct region_space *space);

/* "particles.sources[S].KEY" */
const char *source_key(int source, const char *key, char *text, size_t room);

/* Reads a plain table. Fails with file, line, column. */
bool table_read(const struct scene *scene, int source, struct source_batch *batch, struct error *error);

/* Places spheres on a lattice, cell by cell. */
bool lattice_make(const struct scene *scene, int source, struct source_batch *batch, struct error *error);

/* Places spheres at random, largest first, without touching each other or those in `grid` (which receives
 * them). Each sphere's place depends on seed, source and its number alone. */
bool packing_make(const struct scene *scene, int source, struct placegrid *grid, struct source_batch *batch,
                  struct error *error);

#endif
