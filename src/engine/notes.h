/* SPDX-License-Identifier: BSD-3-Clause */
/* Notes on a scene, which people should read before they trust a run. `scree check` prints the notes, and
 * `scree run` repeats the notes before the first step, and tells at its end what it has seen. A setting that is probably a mistake, but no error,
 * gets a note here. */
#ifndef SCREE_ENGINE_NOTES_H
#define SCREE_ENGINE_NOTES_H

#include "engine/state.h"
#include <stdio.h>

enum {
    NOTES_MAX = 2 * WALLS_MAX + 7 * INSERTIONS_MAX + LAW_MATERIALS_MAX + SOURCES_MAX + 16,
    NOTE_TEXT_MAX = 400
};

/* The smallest box around a set of points, in the user's coordinates; lower above upper: no points. */
struct extent {
    double lower[3], upper[3];
};

/* The extent of a wall: of a mesh, at its place at the start; of a cylinder or a plane, as the scene gives
 * it. A plane that is not perpendicular to an axis has no bounds. */
struct extent notes_wall_extent(const struct simulation *simulation, int wall);

struct note {
    bool warning; /* the run will fail, or its results will be wrong; else: probably a mistake */
    char text[NOTE_TEXT_MAX];
};

/* The notes of a simulation, and the data of the notes; the same on all ranks. */
struct notes {
    struct extent particles; /* of all ranks */
    int64_t outside;         /* centres beyond an open side of the box */
    bool apart[WALLS_MAX];   /* meshes wholly outside of the box */
    char stops[64];          /* guards that would end the run at the expected speed; "": none */
    int count;
    struct note note[NOTES_MAX];
};

/* The distance moved in a step at the expected speed, over the smallest radius. */
double notes_moved(const struct simulation *simulation);

/* Makes all notes, before the first step. Collective. */
void notes_take(const struct simulation *simulation, struct notes *notes);

/* Makes the notes on what a run that began at step `first` has seen, at its end. Any rank, without communication. */
void notes_seen(const struct simulation *simulation, uint64_t first, struct notes *notes);

/* Prints a line each, "NOTE: ..." or "warning: ...", with `before` in front. */
void notes_print(const struct notes *notes, const char *before, FILE *file);

#endif
