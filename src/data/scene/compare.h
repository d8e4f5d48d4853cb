/* SPDX-License-Identifier: BSD-3-Clause */
/* The differences between two effective scenes. */
#ifndef SCREE_SCENE_COMPARE_H
#define SCREE_SCENE_COMPARE_H

#include "base/error.h"
#include <stddef.h>

/* A key whose value differs. Elements of lists that have a name bear it: "walls[floor].radius". */
struct scene_change {
    char *key;
    char *then, *now; /* values as in the text; NULL: not there */
};

/* All zero: none. scene_changes_free releases. */
struct scene_changes {
    size_t count;
    struct scene_change *change;
};

/* Compares two texts of scene_echo, in the order of the second, then the keys that the second lacks. Elements
 * of lists are matched by their names, or by the materials between which they hold, else by their places.
 * False with a user's error where a text cannot be parsed; `file` names it in the message. One thread. */
bool scene_compare(const char *file, const char *then, const char *now, struct scene_changes *changes,
                   struct error *error);

void scene_changes_free(struct scene_changes *changes);

#endif
