/* SPDX-License-Identifier: BSD-3-Clause */
/* Notes on a scene, which people should read before they trust a run. `scree check` prints the notes, and
 * `scree run` repeats the notes before the first step, and tells at its end what it has seen. A setting that is probably a mistake, but no error,
 * gets a note here. */
#ifndef SCREE_ENGINE_NOTES_H
#define SCREE_ENGINE_NOTES_H

#include "engine/state.h"
#include <stdio.h>

enum { NOTES_MAX = 200, NOTE_TEXT_MAX = 560 };

/* The smallest box around a set of points, in the user's coordinates; lower above upper: no points. */
struct extent {
    double lower[3], upper[3];
};

/* The extent of no point; grows by points within `reach` of x. */
extern const struct extent notes_nothing;
void notes_extent_add(struct extent *extent, const double x[3], double reach);

struct note {
    bool warning; /* the run will fail, or its results will be wrong; else: probably a mistake */
    char text[NOTE_TEXT_MAX];
};

/* The notes of a simulation, and the data of the notes; the same on all ranks. */
struct notes {
    uint64_t total;                          /* particles of all ranks */
    struct extent particles;                 /* of all ranks */
    int64_t outside;                         /* centres beyond an open side of the box */
    double speed_expected, overlap_expected; /* by who moves the grains; 0: not known */
    char stops[64]; /* guards that would end the run at the expected speed; "": none */
    int count, left_out;
    struct note note[NOTES_MAX];
};

/* Adds a note. Of more than NOTES_MAX the last ones are left out; a warning takes the place of a note that is none. */
void notes_add(struct notes *notes, bool warning, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* The distance moved in a step at the expected speed, over the smallest radius. */
double notes_moved(const struct notes *notes, const struct size_classes *classes, double dt);

/* Makes all notes, before the first step. Collective. */
void notes_take(const struct simulation *simulation, struct notes *notes);

/* Makes the notes on what a run that began at step `first` has seen, at its end. Any rank, without communication. */
void notes_seen(const struct physics_set *set, uint64_t first, struct notes *notes);

/* Prints a line each, "NOTE: ..." or "warning: ...", with `before` in front. */
void notes_print(const struct notes *notes, const char *before, FILE *file);

#endif
