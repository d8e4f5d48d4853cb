/* SPDX-License-Identifier: BSD-3-Clause */
/* A live view of a run: a page for browsers on this machine, which rank 0 serves. The engine knows only the observer (struct
 * run_watch). The view takes frames after a few steps: ten a second while a page asks, and never so many that taking the frames
 * needs more than a twenty-fifth of the time; how often is rank 0's choice, which all ranks get with each frame. */
#ifndef SCREE_VIEW_VIEW_H
#define SCREE_VIEW_VIEW_H

#include "engine/run.h"

struct view;

struct view_options {
    int port;              /* 0: any that is free */
    bool paused;           /* the run waits before its first step */
    const char *directory; /* of the run; borrowed */
    const char *page;      /* folder of the page and of plots; borrowed */
};

/* Starts the server on rank 0. `comm` is borrowed. Errors (user): the port is taken; the program is built without a server.
 * False: the same error on all ranks. Collective. view_close ends the server and frees. */
bool view_open(struct view **view, const struct comm *comm, const struct view_options *options,
               struct error *error);
void view_close(struct view **view);

/* The observer for the run; borrows the view. When the run begins, with its particles placed, the observer prints the address
 * of the page: from then on each request has an answer. */
struct run_watch view_watch(struct view *view);

#endif
