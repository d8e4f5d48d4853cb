/* SPDX-License-Identifier: BSD-3-Clause */
/* Stands between a program and the C library (LD_PRELOAD) and makes one call on a file fail: a tool of
 * unreadable.sh.
 *
 *     FAIL_CALL    open, pread or close
 *     FAIL_FILE    a part of the path: which file
 *     FAIL_NUMBER  which of these calls on such files, from 1; 0: none
 *     FAIL_RANK    whose; not given: of every process
 *     FAIL_ERRNO   the number of the error
 *     FAIL_NOTE    a file to which a line is added when the call fails */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

typedef int open_call(const char *, int, ...);
typedef ssize_t pread_call(int, void *, size_t, off_t);
typedef int close_call(int);

static void note(open_call *real) {
    const char *path = getenv("FAIL_NOTE");
    int handle = path ? real(path, O_WRONLY | O_CREAT | O_APPEND, 0666) : -1;
    if (handle >= 0 && write(handle, "failed\n", 7) == 7)
        fsync(handle);
}

/* True if this is the call that fails; errno is set then. */
static int fails(const char *call, const char *path) {
    static int calls;
    const char *wanted = getenv("FAIL_CALL"), *file = getenv("FAIL_FILE"), *number = getenv("FAIL_NUMBER"),
               *rank = getenv("FAIL_RANK"), *mine = getenv("OMPI_COMM_WORLD_RANK"),
               *code = getenv("FAIL_ERRNO");
    if (!wanted || !file || !number || strcmp(wanted, call) != 0 || !path || !strstr(path, file) ||
        (rank && mine && strcmp(rank, mine) != 0))
        return 0;
    if (__atomic_add_fetch(&calls, 1, __ATOMIC_RELAXED) != atoi(number))
        return 0;
    open_call *real;
    *(void **)&real = dlsym(RTLD_NEXT, "open");
    note(real);
    errno = code ? atoi(code) : EIO;
    return 1;
}

/* The path of an open file, in `path`; NULL if there is none. */
static const char *path_of(int handle, char path[PATH_MAX]) {
    char link[64];
    snprintf(link, sizeof link, "/proc/self/fd/%d", handle);
    ssize_t length = readlink(link, path, PATH_MAX - 1);
    if (length < 0)
        return NULL;
    path[length] = '\0';
    return path;
}

static int open_or_fail(const char *call, const char *path, int flags, mode_t mode) {
    open_call *real;
    *(void **)&real = dlsym(RTLD_NEXT, call);
    return fails("open", path) ? -1 : real(path, flags, mode);
}

int open(const char *path, int flags, ...) {
    va_list list;
    va_start(list, flags);
    mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(list, mode_t) : 0;
    va_end(list);
    return open_or_fail("open", path, flags, mode);
}

int open64(const char *path, int flags, ...) {
    va_list list;
    va_start(list, flags);
    mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(list, mode_t) : 0;
    va_end(list);
    return open_or_fail("open64", path, flags, mode);
}

static ssize_t read_or_fail(const char *call, int handle, void *data, size_t bytes, off_t place) {
    pread_call *real;
    char path[PATH_MAX];
    *(void **)&real = dlsym(RTLD_NEXT, call);
    return fails("pread", path_of(handle, path)) ? -1 : real(handle, data, bytes, place);
}

ssize_t pread(int handle, void *data, size_t bytes, off_t place) {
    return read_or_fail("pread", handle, data, bytes, place);
}

ssize_t pread64(int handle, void *data, size_t bytes, off_t place) {
    return read_or_fail("pread64", handle, data, bytes, place);
}

int close(int handle) {
    close_call *real;
    char path[PATH_MAX];
    *(void **)&real = dlsym(RTLD_NEXT, "close");
    int failed = fails("close", path_of(handle, path)), code = errno;
    int closed = real(handle);
    if (!failed)
        return closed;
    errno = code;
    return -1;
}
