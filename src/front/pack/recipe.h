/* SPDX-License-Identifier: BSD-3-Clause */
/* What `scree pack` makes: the scene that a law and its keys stand for. Its packed sources make the spheres. */
#ifndef SCREE_PACK_RECIPE_H
#define SCREE_PACK_RECIPE_H

#include "base/error.h"
#include "data/scene/scene.h"
#include "front/pack/hull.h"
#include "front/pack/laws.h"

enum recipe_shape { RECIPE_CUBE, RECIPE_BOX, RECIPE_CYLINDER, RECIPE_SPHERE, RECIPE_MESH };

struct recipe {
    const struct laws_row *law;
    struct scene *scene; /* owned; without units, as all lengths here */
    enum recipe_shape shape;
    double radius, length; /* CYLINDER, SPHERE */
    const char *file;      /* MESH; borrowed */
    double scaled;
    struct hull *hull; /* MESH: region of the source; owned */
    bool settles;      /* the spheres then fall along -z and come to rest on each other */
    double friction;   /* of the spheres while they fall */
    double broad;      /* of the law sand */
};

/* Makes the recipe from the law's name and texts KEY=VALUE (borrowed). Values of keys that a scene has are checked by the schema. Fails (user) and
 * names what is allowed. recipe_free frees, after a failure, too. One thread. */
bool recipe_read(struct recipe *recipe, const char *law, const char *const *setting, int settings,
                 struct error *error);
void recipe_free(struct recipe *recipe);

/* The region that the spheres fill, and its space. */
struct region recipe_region(const struct recipe *recipe, struct region_space *space);

/* Writes shape and size in words, as in "a cube of edge 20, periodic". */
void recipe_describe(const struct recipe *recipe, char *text, size_t size);

#endif
