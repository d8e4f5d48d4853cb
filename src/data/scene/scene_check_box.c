/* SPDX-License-Identifier: BSD-3-Clause */
/* Refuses what a box in motion cannot have. Read scene_check.h first. */
#include "data/scene/scene_check.h"

#include <math.h>

/* Sections that a box in motion does not go together with. */
static bool check_alone(const struct scene *scene, const char *key, struct error *error) {
    static const char why[] = "does not go with %s: allowed are free grains alone";
    if (scene->walls > 0)
        return scene_fail(scene, error, key, why, "walls");
    if (scene->groups > 1)
        return scene_fail(scene, error, key, why, "groups");
    if (scene->insertions > 0)
        return scene_fail(scene, error, key, why, "insertions");
    return true;
}

static bool check_strain(const struct scene *scene, struct error *error) {
    for (int d = 0; d < 3; d++)
        if (scene->strain.rate[d] != 0 && !scene->box.periodic[d])
            return scene_fail(
                scene, error, "box.strain.rate",
                "the box is open along %c, where nothing carries the strain to the particles; allowed: 0 "
                "along %c, or box.periodic along %c, or walls that move (walls[].motion)",
                "xyz"[d], "xyz"[d], "xyz"[d]);
    return check_alone(scene, "box.strain", error);
}

/* A target of the shear stress. */
static bool check_stress_shear(const struct scene *scene, int count, struct error *error) {
    static const char *const key[3] = {"box.stress.xy", "box.stress.xz", "box.stress.yz"};
    for (int k = 0; k < 3; k++) {
        const int plane[2] = {k / 2, 1 + (k + 1) / 2};
        if (isnan(scene->stress.shear[k]))
            continue;
        if (count > 1)
            return scene_fail(scene, error, key[k],
                              "one shear stress has a target at most: the box shears in one plane. Along the "
                              "principal directions normal stresses alone do the same");
        if (scene->box.dimension == 2 && plane[1] == 2)
            return scene_fail(scene, error, key[k], "a box of two dimensions has no stress along z");
        for (int side = 0; side < 2; side++)
            if (!scene->box.periodic[plane[side]])
                return scene_fail(scene, error, key[k],
                                  "%c is not periodic; allowed: directions that box.periodic names",
                                  "xyz"[plane[side]]);
        if (scene->shear_given && scene->shear.flow + scene->shear.gradient != k + 1)
            return scene_fail(scene, error, key[k],
                              "box.shear shears another plane: its flow and gradient are %c and %c",
                              "xyz"[scene->shear.flow], "xyz"[scene->shear.gradient]);
    }
    return true;
}

static bool check_stress(const struct scene *scene, struct error *error) {
    static const char *const key[3] = {"box.stress.xx", "box.stress.yy", "box.stress.zz"};
    const struct scene_stress *stress = &scene->stress;
    bool given = false, pressure = !isnan(stress->pressure);
    for (int d = 0; d < scene->box.dimension; d++) {
        bool own = !isnan(stress->normal[d]);
        given = given || own;
        if ((own || pressure) && !scene->box.periodic[d])
            return scene_fail(scene, error, own ? key[d] : "box.stress.pressure",
                              "%c is not periodic, so that its edge cannot change", "xyz"[d]);
        if ((own || pressure) && scene->strain_given && scene->strain.rate[d] != 0)
            return scene_fail(scene, error, own ? key[d] : "box.stress.pressure",
                              "the edge along %c has a rate by box.strain, too", "xyz"[d]);
    }
    if (scene->box.dimension == 2 && !isnan(stress->normal[2]))
        return scene_fail(scene, error, key[2], "a box of two dimensions has no stress along z");
    int sheared = 0;
    for (int k = 0; k < 3; k++)
        sheared += !isnan(stress->shear[k]);
    if (given && pressure)
        return scene_fail(scene, error, "box.stress.pressure", "allowed is either pressure, or xx, yy, zz");
    if (!given && !pressure && sheared == 0)
        return scene_fail(scene, error, "box.stress",
                          "needed is pressure, or one or more of xx, yy, zz, or one of xy, xz, yz");
    return check_stress_shear(scene, sheared, error) && check_alone(scene, "box.stress", error);
}

static bool check_shear(const struct scene *scene, struct error *error) {
    const struct scene_shear *shear = &scene->shear;
    if (shear->flow == shear->gradient)
        return scene_fail(scene, error, "box.shear.gradient", "%c is the direction of the flow, too",
                          "xyz"[shear->flow]);
    for (int d = 0; d < 3; d++)
        if ((d == shear->flow || d == shear->gradient) && !scene->box.periodic[d])
            return scene_fail(scene, error, d == shear->flow ? "box.shear.flow" : "box.shear.gradient",
                              "%c is not periodic; allowed: directions that box.periodic names", "xyz"[d]);
    for (int k = 0; k < scene->sources && shear->offset != 0; k++)
        if (scene->source[k].kind == SOURCE_RANDOM || scene->source[k].kind == SOURCE_PACKED)
            return scene_fail(scene, error, "box.shear.offset",
                              "random sources and packed ones place their particles at offset 0");
    return check_alone(scene, "box.shear", error);
}

/* Densities of discs: in a plane, and where grains alone have masses by them. */
static bool check_density(const struct scene *scene, struct error *error) {
    if (scene->box.dimension != 2)
        return scene_fail(scene, error, "box.density", "area needs box.dimension: 2");
    if (scene->physics_given[PHYSICS_bodies])
        return scene_fail(scene, error, "box.density", "area together with bodies: not built yet");
    return true;
}

bool scene_check_box(const struct scene *scene, struct error *error) {
    return (scene->box.density == BOX_DENSITY_VOLUME || check_density(scene, error)) &&
           (!scene->shear_given || check_shear(scene, error)) &&
           (!scene->strain_given || check_strain(scene, error)) &&
           (!scene->stress_given || check_stress(scene, error));
}
