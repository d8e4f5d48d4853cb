/* SPDX-License-Identifier: BSD-3-Clause */
/* The rows that contacts of walls add to tables: their section of a scene and their observable. Read blocks.h first. */
#include "physics/blocks/blocks_state.h"
#include "data/observe/observables_kinds.h"
#include "data/scene/schema_rows.h"
#include "physics_table.h"

/* One row a key, packed to the line: */
/* clang-format off */
static const struct schema_row pair_rows[] = {
    {.key = "walls", .type = SCHEMA_REFS, .target = "walls", ARRAY_AT(struct blocks_pair_options, wall, walls),
     .help = "the two walls: boxes, cylinders (from outside), closed convex meshes, or one of these and a plane", .example = "[drum, roller]"},
};
static const struct schema_table pair_table = TABLE(pair_rows);

static const struct schema_row section[] = {
    {.key = "rounding", .type = SCHEMA_REAL, .unit = "m", .range = "(0, inf)", AT(struct blocks_options, rounding),
     .help = "radius of edges and corners of boxes and meshes, in the law, too; faces stay; needed where one is in a pair", .example = "2 mm"},
    {.key = "pairs", .type = SCHEMA_LIST, .sub = &pair_table, .required = true, ARRAY_AT(struct blocks_options, pair, pairs),
     .help = "pairs of walls that touch; all others go through each other. A pair has forces while one of both is free"},
};
const struct schema_table blocks_schema = TABLE(section);
/* clang-format on */

_Static_assert(sizeof(struct blocks_options) <= PHYSICS_OPTIONS_MAX * sizeof(double), "room in struct scene");

void blocks_fields(struct particles *particles) {
    (void)particles;
}

static bool known(const struct output_view *view) {
    return view->own[PHYSICS_blocks] != NULL;
}

/* All ranks have the same number. */
static void touching(const struct observable_context *context, struct observable_item *item, double *part) {
    const struct blocks *blocks = context->view->own[PHYSICS_blocks];
    (void)item;
    for (int p = 0; blocks && p < blocks->pairs; p++)
        part[0] += blocks->pair[p].points > 0;
}

static const struct observable_kind kinds[] = {
    {.info = {"wall_contacts", "", "", "number of pairs of walls that touch", OBSERVABLE_OF_ALL, 1, ""},
     .parts = 1,
     .relevant = known,
     .combine = OBSERVABLE_MAX,
     .of_rank = touching}};
const struct observable_table blocks_observables = {kinds, sizeof kinds / sizeof kinds[0]};
