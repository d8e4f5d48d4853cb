/* SPDX-License-Identifier: BSD-3-Clause */
/* What people should look at again before they trust a run: `scree check` shows it, and `scree run` repeats
 * it before the first step. Whatever is seldom meant, and no error, gets its note here. */
#ifndef SCREE_ENGINE_NOTES_H
#define SCREE_ENGINE_NOTES_H

#include "engine/state.h"
#include <stdio.h>

enum { NOTES_MAX = WALLS_MAX + 16, NOTE_TEXT_MAX = 320 };

/* The smallest box around something, in the user's coordinates; lower above upper: nothing. */
struct extent {
    double lower[3], upper[3];
};

/* A wall: a mesh at its place at the start; a cylinder and a plane as the scene gives them, a plane that is
 * not square to an axis without bounds. */
struct extent notes_wall_extent(const struct simulation *simulation, int wall);

struct note {
    bool warning; /* the run will fail, or its results will be wrong; else: seldom meant */
    char text[NOTE_TEXT_MAX];
};

/* The notes of a simulation, and what they were made from; the same on all ranks. */
struct notes {
    struct extent particles; /* of all ranks */
    int64_t outside;         /* centres beyond an open side of the box */
    bool apart[WALLS_MAX];   /* meshes wholly outside of the box */
    char stops[64];          /* guards that would end the run at the expected speed; "": none */
    int count;
    struct note note[NOTES_MAX];
};

/* The way of a step at the expected speed, over the smallest radius. */
double notes_moved(const struct simulation *simulation);

/* Makes all notes, before the first step. Collective. */
void notes_take(const struct simulation *simulation, struct notes *notes);

/* Prints a line each, "NOTE: ..." or "warning: ...", with `before` in front. */
void notes_print(const struct notes *notes, const char *before, FILE *file);

#endif
