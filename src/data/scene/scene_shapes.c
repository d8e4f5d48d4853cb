/* SPDX-License-Identifier: BSD-3-Clause */
/* Finds shapes by name. Read scene_shapes.h first. */
#include "data/scene/scene_shapes.h"

#include "base/memory.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

void scene_shapes_free(struct scene_shapes **shapes) {
    if (*shapes == NULL)
        return;
    memory_free((*shapes)->entry);
    memory_free((*shapes)->shape);
    output_shapes_free(&(*shapes)->drawn);
    memory_free(*shapes);
    *shapes = NULL;
}

/* The names of all entries, parted by commas. */
static void names_list(const struct scene_shapes *shapes, char *text, size_t room) {
    size_t used = 0;
    text[0] = '\0';
    for (int k = 0; k < shapes->entries && used + 1 < room; k++)
        used += (size_t)snprintf(text + used, room - used, "%s%s", k ? ", " : "", shapes->entry[k].name);
}

int scene_shapes_find(const struct scene_shapes *shapes, const char *name, char *why, size_t room) {
    int found = -1, count = 0;
    char names[900];
    for (int k = 0; shapes && k < shapes->entries; k++)
        if (strcmp(shapes->entry[k].name, name) == 0) {
            found = k;
            count++;
        }
    if (shapes)
        names_list(shapes, names, sizeof names);
    if (shapes == NULL)
        snprintf(why, room, "'%s', and the scene has no section bodies; needed: an entry of this name there",
                 name);
    else if (count == 0)
        snprintf(why, room, "no entry of bodies has the name '%s'; allowed: %s", name, names);
    else if (count > 1)
        snprintf(why, room,
                 "%d entries of bodies have the name '%s'; names must differ where a source uses them", count,
                 name);
    return count == 1 ? found : -1;
}

bool scene_shapes_may_turn(const double q[4], int dimension) {
    const double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    return isfinite(square) && square > 0 && (dimension == 3 || (q[1] == 0 && q[2] == 0));
}
