/* Inside of scene/: what the kinds of particle source share. Each fills a batch, in the user's coordinates;
 * source_sphere.c turns their rows into spheres, source.c spheres into particles. */
#ifndef SCREE_SCENE_SOURCE_PARTS_H
#define SCREE_SCENE_SOURCE_PARTS_H

#include "formats/rows.h"
#include "scene/finish.h"
#include "scene/placegrid.h"
#include "scene/scene.h"

/* The largest id: what insertions add never overflows. */
#define SOURCE_ID_MAX ((int64_t)1 << 62)

/* The most spheres that a source makes: each rank draws all of them. */
enum { SOURCE_SPHERES_MAX = 200000000 };

/* The spheres of one source. */
struct source_batch {
    struct rows rows;     /* position and radius always; mass 0: not given */
    uint32_t *line;       /* line of each row in its file; NULL: the row has no line */
    bool materials_named; /* rows.material is a number of the scene's materials, not a type of the file */
};

/* One sphere of the stream, positions in the user's coordinates. */
struct source_sphere {
    int64_t id; /* 0: the next free one */
    double x[3], v[3], omega[3];
    double radius, density; /* density 0: the material's */
    int material, group;    /* material -1: as the source says */
    int32_t image[3];
    long line; /* in the file; for generators the number within the source */
};

void source_batch_free(struct source_batch *batch);

/* A region with REGION_ALL resolved to the box, and how it is asked. */
struct region source_region(const struct scene *scene, const struct region *region,
                            struct region_space *space);

/* "particles.sources[S].KEY" */
const char *source_key(int source, const char *key, char *text, size_t room);

/* Row `k` of a batch as a sphere in the user's coordinates; no group yet, the material as the row says. */
struct source_sphere source_sphere_of(const struct source_options *options, const struct source_batch *batch,
                                      size_t k);

/* Gives a sphere what source and scene say: material, density, velocity, group; and its centre, box-relative
 * and wrapped, with the images counted, as x. Fails (user), with the sphere's place in the file, where it
 * cannot be. */
bool source_sphere_complete(const struct scene *scene, int source, const struct source_batch *batch,
                            struct source_sphere *sphere, double x[3], struct error *error);

/* Fills `error` with the place of a sphere (line of its file, else its id) and the text; returns false. */
bool source_sphere_fail(const struct scene *scene, int source, const struct source_sphere *sphere,
                        const char *text, struct error *error);

/* Reads a plain table. Fails with file, line, column. */
bool table_read(const struct scene *scene, int source, struct source_batch *batch, struct error *error);

/* Places spheres on a lattice, cell by cell. */
bool lattice_make(const struct scene *scene, int source, struct source_batch *batch, struct error *error);

/* Places spheres at random, largest first, without touching each other, those in `grid` (which receives them)
 * or what share->taken names. Each sphere's place depends on seed, source and its number alone. */
bool packing_make(const struct scene *scene, int source, const struct scene_share *share,
                  struct placegrid *grid, struct source_batch *batch, struct error *error);

#endif
