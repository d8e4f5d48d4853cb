/* SPDX-License-Identifier: BSD-3-Clause */
/* Surfaces of walls from texts. Include after cmocka.h and near.h. */
#ifndef SCREE_TESTS_SURFACE_BY_HAND_H
#define SCREE_TESTS_SURFACE_BY_HAND_H

#include "physics/grains/walls/wall_mesh.h"
#include "tests/physics/grains/walls/mesh_by_hand.h"

static const struct wall_mesh_place as_it_is = {.scale = 1.0};

/* Makes the surface of a text; notes go to `notes` (2048 bytes) if that is not NULL. */
static inline struct wall_mesh *surface(const char *text, size_t size, char *notes) {
    char path[64];
    struct mesh file;
    struct wall_mesh *mesh;
    struct error error = {0};
    hand_file(path, "surface", text, size);
    must(mesh_read(&file, path, "table", &error), &error);
    remove(path);
    FILE *stream = notes ? fmemopen(notes, 2048, "w") : NULL;
    must(wall_mesh_create(&mesh, &file, "M", &as_it_is, stream, &error), &error);
    if (stream)
        fclose(stream);
    mesh_free(&file);
    return mesh;
}

static inline struct wall_mesh *text_surface(struct hand_text *t) {
    struct wall_mesh *mesh = surface(t->text, t->size, NULL);
    memory_free(t->text);
    return mesh;
}

#endif
