/* SPDX-License-Identifier: BSD-3-Clause */
/* Lines of progress: when they come, and what they tell. The test moves the beginning into the past instead of waiting. */
#include "tests/test.h"

#include "base/timer.h"
#include "data/observe/progress.h"
#include <string.h>

/* Lines in the file, and the last one in `last`. */
static int lines_of(FILE *file, char *last, size_t room) {
    int count = 0;
    char text[600];
    rewind(file);
    while (fgets(text, sizeof text, file)) {
        snprintf(last, room, "%s", text);
        count++;
    }
    fseek(file, 0, SEEK_END);
    return count;
}

/* Updates at a step, `passed` seconds after the start and `since` seconds after the line before. */
static void update(struct progress *progress, uint64_t step, double passed, double since) {
    double now = timer_now();
    progress->began = now - passed;
    progress->shown = now - since;
    progress_update(progress, step, 10, 0.5);
}

static void lines_by_time(void **state) {
    struct progress progress;
    char last[600];
    FILE *file = tmpfile();
    (void)state;
    progress_start(&progress, &(struct progress_options){.mode = PROGRESS_AUTO}, NULL, file, 100, 1100);
    assert_true(progress.mode == PROGRESS_LINES && progress.rare);
    update(&progress, 300, 4, -1000); /* far from the next line, however slow this machine is */
    assert_int_equal(lines_of(file, last, sizeof last), 0);
    update(&progress, 600, 500, 5.1); /* a twentieth of the time passed is more than 5 s now */
    assert_int_equal(lines_of(file, last, sizeof last), 0);
    update(&progress, 600, 50, 5.1);
    assert_int_equal(lines_of(file, last, sizeof last), 1);
    assert_memory_equal(last, " 50 % 0:5", 9); /* as much is left as has passed, 50 s */
    assert_non_null(strstr(last, " left, step 600 of 1100, t = 0.5, "));
    update(&progress, 601, 1e6, 60.1); /* a minute is the longest pause */
    assert_int_equal(lines_of(file, last, sizeof last), 2);
    fclose(file);
}

static void lines_at_tenths(void **state) {
    struct progress progress;
    char last[600];
    FILE *file = tmpfile();
    (void)state;
    progress_start(&progress, &(struct progress_options){.mode = PROGRESS_LINES}, NULL, file, 0, 1000);
    for (uint64_t step = 1; step <= 1000; step++)
        update(&progress, step, 1, -1000);
    assert_int_equal(lines_of(file, last, sizeof last), 10);
    assert_memory_equal(last, "100 % 0:00 left, step 1000 of 1000", 34);
    fclose(file);
}

static void no_end_known(void **state) {
    struct progress progress;
    char last[600];
    FILE *file = tmpfile();
    (void)state;
    progress_start(&progress, &(struct progress_options){.mode = PROGRESS_AUTO}, NULL, file, 0,
                   UINT64_MAX / 2);
    update(&progress, 7, 10, 6);
    assert_int_equal(lines_of(file, last, sizeof last), 1);
    assert_memory_equal(last, "step 7, t = 0.5, ", 17);
    fclose(file);
}

static void durations(void **state) {
    char text[20];
    (void)state;
    progress_duration(59.6, text, sizeof text);
    assert_string_equal(text, "1:00");
    progress_duration(3723, text, sizeof text);
    assert_string_equal(text, "1:02:03");
    progress_duration(-1, text, sizeof text);
    assert_string_equal(text, "-:--");
}

TEST_MAIN(progress, cmocka_unit_test(lines_by_time), cmocka_unit_test(lines_at_tenths),
          cmocka_unit_test(no_end_known), cmocka_unit_test(durations))
