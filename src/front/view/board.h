/* SPDX-License-Identifier: BSD-3-Clause */
/* The state that the thread of the server and the thread of the run share, on rank 0: the newest frame, and the wishes of
 * the page. Every function takes the lock of the board, and may be called from any thread. */
#ifndef SCREE_VIEW_BOARD_H
#define SCREE_VIEW_BOARD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct board;

/* What the pages wish. */
struct board_wishes {
    bool watched; /* a page asked for a frame in the last two seconds */
    bool paused;
    int field; /* the field that gives the colour, a number in the list of fields */
    int steps; /* steps to take before the next pause; board_stepped lowers the number */
};

/* Makes an empty board; `paused`: the run waits from the start. board_destroy frees and nulls the pointer. */
struct board *board_create(bool paused);
void board_destroy(struct board **board);

struct board_wishes board_wishes(struct board *board);

/* Waits until the pages wish something else than `known`, for at most `seconds`. */
void board_wait(struct board *board, const struct board_wishes *known, double seconds);

/* A page: wants frames coloured by `field` (below 0: as before); lets the run pause, take steps, or go on. */
void board_want(struct board *board, int field);
void board_pause(struct board *board);
void board_step(struct board *board, int steps);
void board_go(struct board *board);

/* Counts `steps` steps that the run has taken. */
void board_stepped(struct board *board, int steps);

/* Puts a new frame and the description of the run (JSON) there; both are taken over (memory_free). A description of NULL
 * keeps the old one. */
void board_put(struct board *board, char *frame, size_t bytes, char *about);

/* Copies of the newest frame, if it is newer than number *number, which becomes its number, and of the description; the
 * caller frees each by free(). NULL: there is none. */
char *board_frame(struct board *board, uint64_t *number, size_t *bytes);
char *board_about(struct board *board, size_t *bytes);

#endif
