/* SPDX-License-Identifier: BSD-3-Clause */
/* Errors: the first one wins, fatal ones end the program. */
#include "tests/test.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.h"

static void first_error_wins(void **state) {
    (void)state;
    struct error error = {0};
    assert_false(error_set(&error, ERROR_USER, "line %d: no key '%s'", 7, "speed"));
    assert_int_equal(error.kind, ERROR_USER);
    assert_string_equal(error.text, "line 7: no key 'speed'");
    assert_false(error_set(&error, ERROR_PHYSICS, "later"));
    errno = ENOSPC;
    assert_false(error_set_errno(&error, "later still"));
    assert_int_equal(error.kind, ERROR_USER);
    assert_string_equal(error.text, "line 7: no key 'speed'");
}

static void errno_is_named_and_kept(void **state) {
    (void)state;
    struct error error = {0};
    errno = ENOENT;
    assert_false(error_set_errno(&error, "opening %s", "a.yaml"));
    assert_int_equal(errno, ENOENT);
    assert_int_equal(error.kind, ERROR_SYSTEM);
    assert_string_equal(error.text, "opening a.yaml: No such file or directory");
}

static void long_texts_are_cut(void **state) {
    (void)state;
    char *text = malloc(2 * ERROR_TEXT_MAX);
    memset(text, 'x', 2 * ERROR_TEXT_MAX - 1);
    text[2 * ERROR_TEXT_MAX - 1] = '\0';
    struct error error = {0};
    error_set(&error, ERROR_USER, "%s", text);
    assert_int_equal(strlen(error.text), ERROR_TEXT_MAX - 1);
    error = (struct error){0};
    error_set_errno(&error, "%s", text);
    assert_int_equal(strlen(error.text), ERROR_TEXT_MAX - 1);
    free(text);
}

static void leave(int status) {
    _exit(40 + status);
}

/* Ends a child by error_fatal and returns its wait status and what it wrote to stderr. */
static int fatal_child(void (*hook)(int), char *text, size_t size) {
    int ends[2];
    assert_int_equal(pipe(ends), 0);
    pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        signal(SIGABRT, SIG_DFL);
        dup2(ends[1], STDERR_FILENO);
        if (hook != NULL) {
            error_set_abort(3, hook);
        }
        error_fatal("disk %s", "full");
    }
    close(ends[1]);
    size_t used = 0;
    ssize_t got;
    while ((got = read(ends[0], text + used, size - 1 - used)) > 0) {
        used += (size_t)got;
    }
    text[used] = '\0';
    close(ends[0]);
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    return status;
}

static void fatal_goes_through_the_hook(void **state) {
    (void)state;
    char text[4096];
    int status = fatal_child(leave, text, sizeof text);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), 40 + ERROR_SYSTEM);
    assert_string_equal(text, "scree: rank 3: disk full\n");
}

static void fatal_aborts_without_hook(void **state) {
    (void)state;
    char text[4096];
    int status = fatal_child(NULL, text, sizeof text);
    assert_true(WIFSIGNALED(status));
    assert_int_equal(WTERMSIG(status), SIGABRT);
    assert_non_null(strstr(text, "scree: rank 0: disk full\n"));
}

TEST_MAIN(error, cmocka_unit_test(first_error_wins), cmocka_unit_test(errno_is_named_and_kept),
          cmocka_unit_test(long_texts_are_cut), cmocka_unit_test(fatal_goes_through_the_hook),
          cmocka_unit_test(fatal_aborts_without_hook))
