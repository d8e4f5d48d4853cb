/* SPDX-License-Identifier: BSD-3-Clause */
/* The observer of a live view: when frames are taken, and how a run waits. Read view.h first. */
#include "front/view/view.h"
#include "base/memory.h"
#include "base/timer.h"
#include "front/view/board.h"
#include "front/view/server.h"
#include "front/view/shot.h"
#include <math.h>
#include <stdio.h>
#include <time.h>

static const double frame_seconds = 0.1; /* between two frames while a page asks */
static const double idle_seconds = 0.25; /* between two looks for pages */
static const double wait_seconds = 0.05; /* between two looks at the wishes of a run that waits */
static const double part_most = 0.04;    /* of the time, for taking frames */

struct view {
    const struct comm *comm; /* borrowed */
    struct board *board;     /* rank 0 only, as is the server */
    struct server *server;
    uint64_t next;              /* the step after which the next frame is due; the same on all ranks */
    uint64_t left_step, stride; /* rank 0: step of the last look; steps from one look to the next */
    double left;                /* rank 0: seconds, when the last look ended */
    int stepping;               /* rank 0: steps that a page asked for and that are under way */
    bool told;                  /* the address has been printed */
};

/* What rank 0 asks of all ranks in a look. */
enum { ASK_FRAME, ASK_FIELD, ASK_WAIT, ASK_STRIDE, ASK_SIGNAL, ASK_COUNT };

bool view_open(struct view **out, const struct comm *comm, const struct view_options *options,
               struct error *error) {
    struct view *view = memory_allocate_zero(1, sizeof *view, "live view");
    view->comm = comm;
    view->stride = 1;
    *out = view;
    if (comm->rank == 0) {
        view->board = board_create(options->paused);
        struct server_options served = {
            .port = options->port, .directory = options->directory, .page = options->page};
        server_start(&view->server, view->board, &served, error);
    }
    return comm_agree(comm, error);
}

void view_close(struct view **view) {
    if (*view == NULL)
        return;
    server_stop(&(*view)->server);
    board_destroy(&(*view)->board);
    memory_free(*view);
    *view = NULL;
}

/* Fills what rank 0 asks at the present step; other ranks ask nothing. */
static struct board_wishes ask(struct view *view, int64_t asked[ASK_COUNT]) {
    struct board_wishes wishes = {0};
    for (int k = 0; k < ASK_COUNT; k++)
        asked[k] = 0;
    asked[ASK_SIGNAL] = run_signalled() != 0;
    if (view->board) {
        wishes = board_wishes(view->board);
        asked[ASK_FRAME] = wishes.watched || wishes.paused;
        asked[ASK_FIELD] = wishes.field;
        asked[ASK_WAIT] = wishes.paused && wishes.steps == 0;
        asked[ASK_STRIDE] = wishes.paused ? wishes.steps : (int64_t)view->stride;
    }
    comm_max_int(view->comm, asked, ASK_COUNT);
    return wishes;
}

static void frame_take(struct view *view, const struct simulation *s, const int64_t asked[ASK_COUNT]) {
    size_t bytes;
    char *frame = shot_take(s, (int)asked[ASK_FIELD], asked[ASK_WAIT] != 0, &bytes);
    if (view->board)
        board_put(view->board, frame, bytes, NULL);
}

/* Lets all ranks wait a moment, without load on the cores. */
static void wait_once(const struct view *view, const struct board_wishes *known) {
    struct timespec moment = {.tv_nsec = (long)(1e9 * wait_seconds)};
    if (view->board)
        board_wait(view->board, known, wait_seconds);
    else
        nanosleep(&moment, NULL);
}

/* Rank 0: chooses after how many steps the next look comes, from the time of a step and of a frame. */
static void stride_choose(struct view *view, uint64_t step, double arrived, bool watched) {
    double taken = timer_now() - arrived, seconds = watched ? frame_seconds : idle_seconds;
    uint64_t most = 4 * view->stride;
    if (step <= view->left_step)
        return;
    double each = fmax(arrived - view->left, 1e-9) / (double)(step - view->left_step);
    double wanted = fmax(seconds, taken / part_most) / each;
    view->stride = wanted < 1 ? 1 : wanted > (double)most ? most : (uint64_t)wanted;
}

/* Shows the state, waits while the run is to wait, and sets the step of the next look. */
static void show(struct view *view, const struct simulation *s) {
    int64_t asked[ASK_COUNT];
    double arrived = timer_now();
    uint64_t step = s->clock.step;
    if (view->board && view->stepping > 0)
        board_stepped(view->board, view->stepping);
    view->stepping = 0;
    struct board_wishes wishes = ask(view, asked);
    if (asked[ASK_FRAME])
        frame_take(view, s, asked);
    if (view->board && !wishes.paused)
        stride_choose(view, step, arrived, wishes.watched);
    while (asked[ASK_WAIT] && !asked[ASK_SIGNAL]) {
        int64_t field = asked[ASK_FIELD];
        wait_once(view, &wishes);
        wishes = ask(view, asked);
        if (asked[ASK_FIELD] != field && asked[ASK_WAIT])
            frame_take(view, s, asked);
    }
    view->stepping = view->board && wishes.paused ? wishes.steps : 0;
    view->next = step + (uint64_t)(asked[ASK_STRIDE] > 0 ? asked[ASK_STRIDE] : 1);
    view->left_step = step;
    view->left = timer_now();
}

/* Rank 0: prints the address, once, when the server can answer all that a page asks. */
static void address_tell(struct view *view) {
    if (!view->told)
        fprintf(stderr, "scree: live view: %s%s\n", server_address(view->server),
                board_wishes(view->board).paused ? " (the run waits for the page)" : "");
    view->told = true;
}

static bool view_begin(void *context, struct simulation *s, struct error *error) {
    struct view *view = context;
    (void)error;
    view->left_step = s->clock.step;
    view->left = timer_now();
    if (view->board) {
        size_t bytes = 0;
        board_put(view->board, NULL, bytes, shot_about(s));
        address_tell(view);
    }
    show(view, s);
    return true;
}

static bool view_due(const void *context, uint64_t step) {
    return step >= ((const struct view *)context)->next;
}

static bool view_look(void *context, const struct simulation *s, struct error *error) {
    (void)error;
    show(context, s);
    return true;
}

struct run_watch view_watch(struct view *view) {
    return (struct run_watch){
        .context = view, .without_sums = true, .begin = view_begin, .due = view_due, .look = view_look};
}
