/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows of the schema: stages, and the conditions that end a stage. */
#include "data/scene/schema_sections.h"
#include "data/scene/scene.h"
#include "data/scene/schema_output.h"

/* One row a key, packed to the line: */
/* clang-format off */

static const struct schema_row condition_rows[] = {
    {.key = "name", .type = SCHEMA_CHOICE, .choice = schema_observable_choice, .required = true, .with_target = true,
     AT(struct scene_condition, request.name), .help = "the observable; NAME/TARGET gives its target, too",
     .example = "unbalanced_force"},
    {.key = "target", .type = SCHEMA_TEXT, .fallback = "", AT(struct scene_condition, request.target),
     .help = "wall, region, plane or group, `region/material` for one material", .example = "lid"},
    {.key = "id", .type = SCHEMA_LONG, .range = "[0, inf)", .fallback = "0", AT(struct scene_condition, request.id),
     .help = "id of the observed particle", .example = "25001"},
    {.key = "component", .type = SCHEMA_NAME, .names = schema_components, .fallback = "all",
     AT(struct scene_condition, request.components), .help = "the one component of a vector that counts", .example = "z"},
    {.key = "of", .type = SCHEMA_TEXT, .fallback = "", AT(struct scene_condition, request.of),
     .help = "expression of sum, mean, largest and least, as in observables.list", .example = "vz"},
    {.key = "where", .type = SCHEMA_TEXT, .fallback = "", AT(struct scene_condition, request.where),
     .help = "expression that selects the particles", .example = "z > 0.1"},
    {.key = "at_least", .type = SCHEMA_REAL, AT(struct scene_condition, at_least),
     .help = "the condition holds if the observable is not below this, in the base units of the observable", .example = "500"},
    {.key = "at_most", .type = SCHEMA_REAL, AT(struct scene_condition, at_most),
     .help = "the condition holds if the observable is not above this; with at_least, too: between the two", .example = "0.01"},
};
static const struct schema_table condition_table = TABLE(condition_rows);

static const struct schema_row stage_rows[] = {
    {.key = "name", .type = SCHEMA_TEXT, .required = true, .in_column = SCHEMA_COLUMN_NAME, AT(struct scene_stage, name),
     .help = "name of the stage for messages and the report", .example = "pour"},
    {.key = "duration", .type = SCHEMA_REAL, .unit = "s", .range = "(0, inf]", AT(struct scene_stage, duration),
     .help = "simulated time from the beginning of the stage to its end; with until: at the latest", .example = "0.5 s"},
    {.key = "until", .type = SCHEMA_LIST, .sub = &condition_table,
     ARRAY_AT(struct scene_stage, condition, conditions),
     .help = "observables that end the stage, as soon as all of them are where they should be"},
    {.key = "after", .type = SCHEMA_REAL, .unit = "s", .range = "[0, inf)", .fallback = "0", AT(struct scene_stage, after),
     .help = "time of the stage before which `until` does not count: grains that are about to fall are at rest, too", .example = "20 ms"},
    {.key = "every", .type = SCHEMA_LONG, .range = "[1, inf)", .fallback = "100", AT(struct scene_stage, every),
     .help = "steps between two looks at the observables of `until`"},
    {.key = "set", .type = SCHEMA_KEYS, AT(struct scene_stage, set),
     .help = "changes of the scene from this stage on, as with --set: full keys, elements of lists by number or name, ~ takes out; "
             "not in the first stage, which is the scene itself. Gravity, walls and their contacts, motions of groups, materials' coefficients, "
             "insertions, deletions, the motion of the box, walls of heat, guards, the step, and the intervals of output may change",
     .example = "{gravity: [0, 0, -1.6], \"walls[gate]\": ~}"},
};
const struct schema_table schema_stages = TABLE(stage_rows);
