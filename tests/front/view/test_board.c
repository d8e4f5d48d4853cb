/* SPDX-License-Identifier: BSD-3-Clause */
/* The board of a live view: frames go out once, and steps are counted down. */
#include "tests/test.h"

#include "front/view/board.h"
#include "base/memory.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char *text_of(const char *text) {
    return strcpy(memory_allocate(strlen(text) + 1, 1, "test"), text);
}

/* The answer to a page that knows frame `number`; "" for none. Sets the number. */
static const char *frame_after(struct board *board, uint64_t *number) {
    static char copy[20];
    size_t bytes;
    char *frame = board_frame(board, number, &bytes);
    snprintf(copy, sizeof copy, "%s", frame ? frame : "");
    free(frame);
    return copy;
}

static void frames_go_out_once(void **state) {
    struct board *board = board_create(true);
    uint64_t number = 0;
    size_t bytes;
    (void)state;
    assert_string_equal(frame_after(board, &number), "");
    assert_null(board_about(board, &bytes));
    board_put(board, text_of("one"), 4, text_of("a heap"));
    assert_string_equal(frame_after(board, &number), "one");
    assert_int_equal(number, 1);
    assert_string_equal(frame_after(board, &number), "");
    board_put(board, text_of("two"), 4, NULL);
    board_put(board, text_of("three"), 6, NULL);
    assert_string_equal(frame_after(board, &number), "three");
    assert_int_equal(number, 3);
    char *about = board_about(board, &bytes);
    assert_int_equal(bytes, 6);
    assert_memory_equal(about, "a heap", 6);
    free(about);
    board_destroy(&board);
    assert_null(board);
}

static void steps_are_counted_down(void **state) {
    struct board *board = board_create(false);
    (void)state;
    assert_false(board_wishes(board).paused || board_wishes(board).watched);
    board_step(board, 5);
    assert_true(board_wishes(board).paused && board_wishes(board).steps == 5);
    board_stepped(board, 3);
    assert_int_equal(board_wishes(board).steps, 2);
    board_stepped(board, 3);
    assert_int_equal(board_wishes(board).steps, 0);
    board_step(board, 5);
    board_pause(board);
    assert_true(board_wishes(board).paused && board_wishes(board).steps == 0);
    board_go(board);
    assert_false(board_wishes(board).paused);
    board_want(board, 3);
    board_want(board, -1); /* as before */
    assert_int_equal(board_wishes(board).field, 3);
    struct board_wishes old = {.field = 2};
    board_wait(board, &old, 1e6); /* the wish is another one already */
    board_destroy(&board);
}

TEST_MAIN(board, cmocka_unit_test(frames_go_out_once), cmocka_unit_test(steps_are_counted_down))
