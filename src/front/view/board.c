/* SPDX-License-Identifier: BSD-3-Clause */
/* The board of a live view: one lock for all. Read board.h first. */
#include "front/view/board.h"
#include "base/memory.h"
#include "base/timer.h"
#include <errno.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static const double watched_seconds = 2; /* since a page asked last */

struct board {
    pthread_mutex_t lock;
    pthread_cond_t changed; /* a wish has changed */
    bool paused;
    int field, steps;
    double asked; /* seconds: when a page asked for a frame; 0: never */
    uint64_t number;
    char *frame, *about;
    size_t frame_bytes;
};

struct board *board_create(bool paused) {
    struct board *board = memory_allocate_zero(1, sizeof *board, "live view");
    pthread_mutex_init(&board->lock, NULL);
    pthread_cond_init(&board->changed, NULL);
    board->paused = paused;
    return board;
}

void board_destroy(struct board **board) {
    if (*board == NULL)
        return;
    pthread_mutex_destroy(&(*board)->lock);
    pthread_cond_destroy(&(*board)->changed);
    memory_free((*board)->frame);
    memory_free((*board)->about);
    memory_free(*board);
    *board = NULL;
}

static struct board_wishes wishes_now(const struct board *board) {
    return (struct board_wishes){.watched = board->asked > 0 && timer_now() - board->asked < watched_seconds,
                                 .paused = board->paused,
                                 .field = board->field,
                                 .steps = board->steps};
}

struct board_wishes board_wishes(struct board *board) {
    pthread_mutex_lock(&board->lock);
    struct board_wishes wishes = wishes_now(board);
    pthread_mutex_unlock(&board->lock);
    return wishes;
}

void board_wait(struct board *board, const struct board_wishes *known, double seconds) {
    struct timespec until;
    clock_gettime(CLOCK_REALTIME, &until);
    until.tv_nsec += (long)(1e9 * seconds);
    until.tv_sec += until.tv_nsec / 1000000000;
    until.tv_nsec %= 1000000000;
    int code = 0;
    pthread_mutex_lock(&board->lock);
    while (code != ETIMEDOUT && board->paused == known->paused && board->field == known->field &&
           board->steps == known->steps)
        code = pthread_cond_timedwait(&board->changed, &board->lock, &until);
    pthread_mutex_unlock(&board->lock);
}

void board_want(struct board *board, int field) {
    pthread_mutex_lock(&board->lock);
    board->asked = timer_now();
    if (field >= 0 && field != board->field) {
        board->field = field;
        pthread_cond_signal(&board->changed);
    }
    pthread_mutex_unlock(&board->lock);
}

static void set(struct board *board, bool paused, int steps) {
    pthread_mutex_lock(&board->lock);
    board->paused = paused;
    board->steps = steps;
    pthread_cond_signal(&board->changed);
    pthread_mutex_unlock(&board->lock);
}

void board_pause(struct board *board) {
    set(board, true, 0);
}

void board_step(struct board *board, int steps) {
    set(board, true, steps);
}

void board_go(struct board *board) {
    set(board, false, 0);
}

void board_stepped(struct board *board, int steps) {
    pthread_mutex_lock(&board->lock);
    board->steps = board->steps > steps ? board->steps - steps : 0;
    pthread_mutex_unlock(&board->lock);
}

void board_put(struct board *board, char *frame, size_t bytes, char *about) {
    pthread_mutex_lock(&board->lock);
    memory_free(board->frame);
    board->frame = frame;
    board->frame_bytes = bytes;
    if (about) {
        memory_free(board->about);
        board->about = about;
    }
    board->number++;
    pthread_mutex_unlock(&board->lock);
}

static char *copy_of(const char *text, size_t bytes) {
    char *copy = text ? malloc(bytes ? bytes : 1) : NULL;
    if (copy)
        memcpy(copy, text, bytes);
    return copy;
}

char *board_frame(struct board *board, uint64_t *number, size_t *bytes) {
    pthread_mutex_lock(&board->lock);
    char *copy = board->number > *number ? copy_of(board->frame, board->frame_bytes) : NULL;
    *bytes = board->frame_bytes;
    *number = board->number;
    pthread_mutex_unlock(&board->lock);
    return copy;
}

char *board_about(struct board *board, size_t *bytes) {
    pthread_mutex_lock(&board->lock);
    *bytes = board->about ? strlen(board->about) : 0;
    char *copy = copy_of(board->about, *bytes);
    pthread_mutex_unlock(&board->lock);
    return copy;
}
