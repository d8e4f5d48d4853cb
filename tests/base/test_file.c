/* SPDX-License-Identifier: BSD-3-Clause */
/* Files that get their name when they are whole: what is written, and that it is on the disk before it bears
 * the name. */
#include "tests/test.h"

#include "base/file.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

/* What the program has flushed so far. */
enum { FLUSHES = 8 };
static struct {
    int count;
    ino_t node[FLUSHES];
    bool folder[FLUSHES], named[FLUSHES];
} flushed;
static const char *name;

/* Stands for the C library's fsync: notes what is flushed, and whether the file bears its name by then. */
int fsync(int handle) {
    struct stat status;
    if (flushed.count < FLUSHES && fstat(handle, &status) == 0) {
        flushed.node[flushed.count] = status.st_ino;
        flushed.folder[flushed.count] = S_ISDIR(status.st_mode);
        flushed.named[flushed.count] = file_size(name) > 0;
    }
    flushed.count++;
    return (int)syscall(SYS_fsync, handle);
}

/* The file's content first, then its name in the folder. */
static void flushed_before_named(void **state) {
    (void)state;
    struct file_new file;
    struct error error = {0};
    char path[64], line[16] = "";
    struct stat status, folder;
    snprintf(path, sizeof path, "test-file-%ld.txt", (long)getpid());
    name = path;
    flushed.count = 0;
    assert_true(file_new_open(&file, path, &error));
    fputs("whole\n", file.stream);
    assert_int_equal(file_size(path), -1);
    assert_true(file_new_close(&file, &error));
    assert_int_equal(file_size(path), 6);
    assert_int_equal(file_size(file.temporary), -1);
    assert_int_equal(stat(path, &status), 0);
    assert_int_equal(stat(".", &folder), 0);
    assert_int_equal(flushed.count, 2);
    assert_true(flushed.node[0] == status.st_ino && !flushed.folder[0] && !flushed.named[0]);
    assert_true(flushed.node[1] == folder.st_ino && flushed.folder[1] && flushed.named[1]);
    FILE *again = fopen(path, "r");
    assert_non_null(again);
    assert_non_null(fgets(line, sizeof line, again));
    assert_string_equal(line, "whole\n");
    fclose(again);
    remove(path);
}

/* Where there is nothing to flush the error names it, and the present file stays. */
static void nothing_to_flush(void **state) {
    (void)state;
    struct error error = {0};
    assert_false(file_settle("test-file-absent.part", "test-file-absent", &error));
    assert_int_equal(error.kind, ERROR_SYSTEM);
    assert_non_null(strstr(error.text, "test-file-absent.part"));
    assert_int_equal(file_size("test-file-absent"), -1);
}

TEST_MAIN(file, cmocka_unit_test(flushed_before_named), cmocka_unit_test(nothing_to_flush))
