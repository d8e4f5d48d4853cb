/* SPDX-License-Identifier: BSD-3-Clause */
/* The law and the walls in checkpoints: struct physics_record. Read grains.h first. */
#include "physics/grains/grains_own.h"
#include <string.h>

/* Gives all forces on walls to the first rank, as a resume does, so that the continued run has the same
 * sums. */
static void wall_forces_gather(const struct physics_context *context, struct walls *walls) {
    double force[WALLS_MAX][6];
    walls_forces(walls, force);
    comm_sum(context->comm, force[0], 6 * walls_count(walls));
    if (context->comm->rank > 0)
        memset(force, 0, sizeof force);
    walls_set_forces(walls, force);
}

static void save(const struct physics_context *context, const struct history_rows *rows,
                 struct checkpoint *checkpoint) {
    struct grains *grains = context->self;
    if (grains->walls && context->comm->size > 1)
        wall_forces_gather(context, grains->walls);
    law_title(&grains->law.options, grains->title);
    checkpoint->law = grains->title;
    checkpoint->wall_history = rows->start && checkpoint->history_components > 0 ? rows : NULL;
    checkpoint->walls = grains->walls;
    checkpoint->motion = &grains->motion;
}

static bool fits(const struct physics_context *context, const char *path,
                 const struct checkpoint_loaded *loaded, struct error *error) {
    const struct grains *grains = context->self;
    char law[LAW_TITLE_MAX];
    law_title(&grains->law.options, law);
    return strcmp(loaded->law, law) == 0 ||
           error_set(error, ERROR_USER,
                     "%s: it was written with contact.law %s, the scene has %s: "
                     "contact.law must stay",
                     path, loaded->law, law);
}

/* Finds walls by their names: the scene may have other walls, or the same walls in another order. */
static void rows_rename(const struct scene *scene, const struct checkpoint_loaded *loaded) {
    const struct history_rows *rows = &loaded->wall_history;
    for (size_t k = 0; k < rows->count; k++) {
        struct history_row *row = &rows->row[k];
        int wall = wall_row_wall(row);
        bool known = wall >= 0 && wall < loaded->walls;
        row->partner =
            wall_row_partner(known ? scene_wall(scene, loaded->wall[wall].name) : -1, wall_row_feature(row));
    }
}

static void resume(const struct physics_context *context, struct checkpoint_loaded *loaded,
                   struct history_rows *rows) {
    struct grains *grains = context->self;
    if (grains->walls == NULL)
        return;
    walls_set_work(grains->walls, grains->wall_work);
    for (int k = 0; k < loaded->walls; k++) {
        int wall = scene_wall(context->scene, loaded->wall[k].name);
        if (wall >= 0)
            walls_set_pose(grains->walls, wall, &loaded->wall[k].pose);
    }
    rows_rename(context->scene, loaded);
    if (grains->law.history_components == 0)
        return;
    *rows = loaded->wall_history;
    loaded->wall_history = (struct history_rows){0};
}

const struct physics_record grains_record = {.save = save, .fits = fits, .resume = resume};
