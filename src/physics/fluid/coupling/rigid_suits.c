/* SPDX-License-Identifier: BSD-3-Clause */
/* What does not go with rigid grains. Read rigid_suits.h first. */
#include "physics/fluid/coupling/rigid_suits.h"
#include "physics/bodies/bodies.h"
#include "physics/fluid/coupling/lubrication.h"
#include "physics/fluid/coupling/unresolved_grains.h"
#include "physics/fluid/fluid.h"
#include <math.h>
#include <stdio.h>

static bool refuse(const struct physics_context *context, const char *key, const char *why,
                   const char *allowed, struct error *error) {
    return scene_fail(context->scene, error, key,
                      "%s does not go with fluid.grains.coupling: rigid; allowed with it: %s", why, allowed);
}

/* Lubrication acts down to a roughness below the gaps where it begins. */
static bool lubrication_suits(const struct physics_context *context, struct error *error) {
    const struct fluid_options *options = context->options;
    const double reach = LUBRICATION_REACH * options->spacing;
    if (isnan(options->grains.lubrication))
        return true;
    if (options->grains.hydraulic < 1)
        return refuse(context, "fluid.grains.lubrication", "lubrication beside hydraulic < 1",
                      "one of the two", error);
    return options->grains.lubrication < reach ||
           scene_fail(context->scene, error, "fluid.grains.lubrication",
                      "with a roughness of %g no gap has lubrication; allowed: less than %g spacings, %g",
                      options->grains.lubrication, LUBRICATION_REACH, reach);
}

/* The fluid in a body has the surface, the centre and the moments of its shape. */
static bool bodies_suit(const struct physics_context *context, struct error *error) {
    const struct fluid_options *options = context->options;
    const struct scene *scene = context->scene;
    const struct bodies_options *bodies =
        scene->physics_given[PHYSICS_bodies] ? (const void *)scene->physics[PHYSICS_bodies] : NULL;
    if (bodies != NULL && options->grains.hydraulic < 1)
        return scene_fail(scene, error, "fluid.grains.hydraulic",
                          "bodies have the surface of their shapes; allowed with them: 1");
    if (bodies != NULL && bodies->rocks > 0 && !isnan(options->grains.lubrication))
        return scene_fail(scene, error, "fluid.grains.lubrication",
                          "the faces of rocks have no lubrication; allowed with it: grains and clumps");
    for (int k = 0; bodies != NULL && k < bodies->clumps; k++) {
        char key[64];
        snprintf(key, sizeof key, "bodies.clumps[%d]", k);
        if (bodies->clump[k].centre_given > 0 || bodies->clump[k].inertia_given > 0)
            return refuse(context, key, "a given centre or inertia", "those of the shape", error);
    }
    return true;
}

/* No surface of a grain has a value of its own. */
static bool scalars_suit_grains(const struct physics_context *context, struct error *error) {
    const struct fluid_options *options = context->options;
    for (int k = 0; k < options->scalars; k++)
        for (int g = 0; g < options->scalar[k].givens; g++) {
            char key[64];
            snprintf(key, sizeof key, "fluid.scalars[%d].given[%d].group", k, g);
            if (options->scalar[k].given[g].at.group >= 0)
                return refuse(context, key, "a value given at grains", "wall, side", error);
        }
    return true;
}

bool rigid_suits(const struct physics_context *context, struct error *error) {
    const struct fluid_options *options = context->options;
    if (!fluid_rigid(options) && context->scene->physics_given[PHYSICS_hard])
        return scene_fail(context->scene, error, "fluid",
                          "a fluid around grains with contact.solver needs coupling: rigid (fluid.grains)");
    if (!fluid_rigid(options) && !isnan(options->grains.lubrication))
        return scene_fail(context->scene, error, "fluid.grains.lubrication",
                          "lubrication needs coupling: rigid (fluid.grains)");
    if (!fluid_rigid(options) && context->scene->physics_given[PHYSICS_bodies])
        return scene_fail(context->scene, error, "fluid",
                          "a fluid around bodies needs coupling: rigid (fluid.grains)");
    if (!fluid_rigid(options) && options->grains.hydraulic < 1)
        return scene_fail(context->scene, error, "fluid.grains.hydraulic",
                          "a radius of its own needs coupling: rigid (fluid.grains); allowed with others: 1");
    if (!fluid_rigid(options))
        return true;
    if (!lubrication_suits(context, error))
        return false;
    if (options->time != FLUID_TRANSIENT)
        return refuse(context, "fluid.time", "a steady flow", "transient", error);
    if (options->motion.name != FLUID_FIXED)
        return refuse(context, "fluid.motion", "a fluid of particles that move", "fixed", error);
    if (unresolved_any(options))
        return refuse(context, "fluid.grains.unresolved", "a fluid that leaves grains unresolved",
                      "no such key", error);
    if (options->electrolytes > 0)
        return refuse(context, "fluid.electrolyte", "an electrolyte", "none", error);
    if (fluid_slip(options) > 0)
        return refuse(context, "fluid.walls.velocity", "slip", "no_slip", error);
    if (options->fill.arrangement != FLUID_CUBIC)
        return refuse(context, "fluid.fill.arrangement", "this lattice", "cubic", error);
    if (options->fill.jitter > 0)
        return refuse(context, "fluid.fill.jitter", "a displaced lattice", "0", error);
    return scalars_suit_grains(context, error) && bodies_suit(context, error);
}
