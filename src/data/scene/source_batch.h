/* SPDX-License-Identifier: BSD-3-Clause */
/* The common part of the kinds of particle source. Each kind (table.h, lattice.h, packed.h, scatter.h) fills a batch,
 * in the user's coordinates; source_sphere.h turns the rows of a batch into spheres, scene_particles.h
 * spheres into particles. */
#ifndef SCREE_SCENE_SOURCE_BATCH_H
#define SCREE_SCENE_SOURCE_BATCH_H

#include "data/formats/rows.h"
#include "data/scene/scene.h"

/* The largest id: so the ids of inserted particles never overflow. */
#define SOURCE_ID_MAX ((int64_t)1 << 62)

/* The most spheres that a source makes: each rank draws all of them. */
enum { SOURCE_SPHERES_MAX = 200000000 };

/* What a row becomes, where its file says so. */
struct source_row {
    int shape;    /* number of the entry of bodies + 1 (struct source_form); -1: it stays a sphere */
    int variant;  /* number of the shape in the entry + 1; 0: the id chooses */
    double ball;  /* radius of the grain over that of the row */
    double solid; /* part of the grain that is solid */
};

/* The spheres of one source. */
struct source_batch {
    struct rows
        rows; /* position and radius always; mass 0: not given; orientation: of bodies, in the frame of their entries, all 0: not
                         given */
    bool materials_named;    /* rows.material is a number of the scene's materials, not a type of the file */
    struct source_row *form; /* of each row; NULL: the source says it of all */
};

/* Frees the arrays of a batch. */
void source_batch_free(struct source_batch *batch);

/* A region with REGION_ALL resolved to the box, and the space of the region. */
struct region source_region(const struct scene *scene, const struct region *region,
                            struct region_space *space);

/* Fails (user) if `count` particles of `bytes` bytes do not fit into the memory that this process can still get. SOURCE_BYTES: the
 * least that a run holds of a particle of its own. */
enum { SOURCE_BYTES = 250 };
bool source_room(double count, double bytes, struct error *error);

/* "particles.sources[S].KEY" */
const char *source_key(int source, const char *key, char *text, size_t room);

#endif
