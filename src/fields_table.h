/* SPDX-License-Identifier: BSD-3-Clause */
/* The fields that grains have in some scenes: one row each, with the function of their owner that registers
 * them, and the condition in terms of `scene` (data/scene/scene.h) and `law` (physics/grains/laws/law.h). kernel/particles/fields.h has
 * the recipe. scene_register registers those of a scene, frame_register_all all of them: for the pages, for
 * help, and for files that other scenes wrote. A physics registers by itself the fields that only some of its scenes have, in
 * its `create`: for these the condition is `false`. */
#ifndef SCREE_FIELDS_TABLE_H
#define SCREE_FIELDS_TABLE_H

#define FIELDS_TABLE(ROW)                                                                                    \
    ROW(spin_register, law->spin)                                                                            \
    ROW(material_register, scene->materials > 1)                                                             \
    ROW(groups_register, scene->groups > 1)                                                                  \
    ROW(particles_count_images, scene->box.periodic[0] || scene->box.periodic[1] || scene->box.periodic[2])  \
    ROW(fluid_scalars_register, false)                                                                       \
    ROW(fluid_electrolyte_register, false)                                                                   \
    ROW(rocks_register, false)

struct particles;
#define FIELDS_DECLARE(register_fields, needed) void register_fields(struct particles *particles);
FIELDS_TABLE(FIELDS_DECLARE)
#undef FIELDS_DECLARE

#endif
