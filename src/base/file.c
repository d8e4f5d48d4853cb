/* SPDX-License-Identifier: BSD-3-Clause */
/* New files under temporary names, and reads, writes and room on the disk, each checked. Read file.h
 * first. */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* fallocate */
#endif
#include "base/file.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <string.h>
#include <sys/resource.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

/* The directory of a path, "." if it names none. */
static void directory_of(const char *path, char directory[FILE_PATH_MAX]) {
    snprintf(directory, FILE_PATH_MAX, "%s", path);
    char *slash = strrchr(directory, '/');
    if (!slash)
        snprintf(directory, FILE_PATH_MAX, ".");
    else if (slash == directory)
        slash[1] = '\0';
    else
        *slash = '\0';
}

bool file_new_open(struct file_new *file, const char *path, struct error *error) {
    file->stream = NULL;
    if (strlen(path) >= FILE_PATH_MAX)
        return error_set(error, ERROR_USER, "%.100s...: the path is longer than %d characters", path,
                         FILE_PATH_MAX - 1);
    snprintf(file->path, sizeof file->path, "%s", path);
    snprintf(file->temporary, sizeof file->temporary, "%s.part", path);
    file->stream = fopen(file->temporary, "w");
    if (!file->stream)
        return error_set_errno(error, "%s: cannot be written", file->temporary);
    return true;
}

bool file_new_close(struct file_new *file, struct error *error) {
    if (!file->stream)
        return false;
    errno = 0;
    bool written = fflush(file->stream) == 0 && !ferror(file->stream);
    if (!written)
        error_set_errno(error, "%s: not all could be written", file->temporary);
    if (fclose(file->stream) != 0)
        error_set_errno(error, "%s: not all could be written", file->temporary);
    file->stream = NULL;
    if (error->kind == ERROR_NONE && file_settle(file->temporary, file->path, error))
        return true;
    unlink(file->temporary);
    return false;
}

static bool flush_to_disk(const char *path, int flags, struct error *error) {
    int handle = open(path, flags);
    if (handle < 0)
        return error_set_errno(error, "%s: cannot be opened to flush it", path);
    /* some file systems cannot flush a directory, and say so by EINVAL */
    bool flushed = fsync(handle) == 0 || errno == EINVAL;
    if (!flushed)
        error_set_errno(error, "%s: cannot be flushed to disk", path);
    close(handle);
    return flushed;
}

bool file_settle(const char *temporary, const char *path, struct error *error) {
    char directory[FILE_PATH_MAX];
    directory_of(path, directory);
    if (!flush_to_disk(temporary, O_RDONLY, error))
        return false;
    if (rename(temporary, path) != 0)
        return error_set_errno(error, "%s: cannot be renamed to %s", temporary, path);
    return flush_to_disk(directory, O_RDONLY | O_DIRECTORY, error);
}

bool file_check_room(const char *path, uint64_t present, uint64_t bytes, struct error *error) {
    struct rlimit limit;
    if (getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY &&
        present + bytes > limit.rlim_cur)
        return error_set(error, ERROR_SYSTEM,
                         "%s: needs %" PRIu64 " bytes, more than the file size limit of %" PRIu64 ": %s",
                         path, present + bytes, (uint64_t)limit.rlim_cur, strerror(EFBIG));
    char directory[FILE_PATH_MAX];
    directory_of(path, directory);
    struct statvfs system;
    if (statvfs(directory, &system) != 0)
        return error_set_errno(error, "%s: its file system cannot be asked", directory);
    uint64_t room = (uint64_t)system.f_bavail * system.f_frsize;
    if (system.f_blocks > 0 && bytes > room)
        return error_set(error, ERROR_SYSTEM,
                         "%s: disk full: needs %" PRIu64 " bytes, %" PRIu64 " are left: %s", path, bytes,
                         room, strerror(ENOSPC));
    return true;
}

bool file_reserve(const char *path, uint64_t bytes, struct error *error) {
    int64_t present = file_size(path);
    if (!file_check_room(path, present > 0 ? (uint64_t)present : 0, bytes, error))
        return false;
    int handle = open(path, O_WRONLY);
    if (handle < 0)
        return error_set_errno(error, "%s: cannot be opened", path);
    bool refused = fallocate(handle, FALLOC_FL_KEEP_SIZE, present, (off_t)bytes) != 0 &&
                   (errno == ENOSPC || errno == EDQUOT || errno == EFBIG);
    if (refused)
        error_set_errno(error, "%s: disk full: needs %" PRIu64 " bytes more", path, bytes);
    close(handle);
    return !refused;
}

bool file_join(char *path, const char *directory, const char *name, struct error *error) {
    int length = snprintf(path, FILE_PATH_MAX, "%s/%s", directory, name);
    if (length < 0 || length >= FILE_PATH_MAX)
        return error_set(error, ERROR_USER, "%.100s...: the path is longer than %d characters", directory,
                         FILE_PATH_MAX - 1);
    return true;
}

const char *file_waits(const char *path) {
    struct stat found;
    if (stat(path, &found) != 0 || S_ISREG(found.st_mode) || S_ISDIR(found.st_mode))
        return NULL;
    if (!S_ISFIFO(found.st_mode))
        return S_ISSOCK(found.st_mode) ? "is a socket, not a file" : "is a device, not a file";
    char *name = realpath(path, NULL); /* the link of a pipe without a name leads nowhere */
    const char *why = name ? "is a named pipe, not a file" : NULL;
    free(name);
    return why;
}

int64_t file_size(const char *path) {
    struct stat status;
    return stat(path, &status) == 0 ? (int64_t)status.st_size : -1;
}

bool file_is_missing(int code) {
    return code == ENOENT || code == ENOTDIR || code == EACCES || code == EPERM || code == ELOOP ||
           code == ENAMETOOLONG || code == EISDIR || code == EROFS;
}

bool file_read_at(int handle, void *data, uint64_t bytes, uint64_t offset) {
    char *next = data;
    while (bytes > 0) {
        ssize_t got = pread(handle, next, bytes, (off_t)offset);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0) {
            errno = got == 0 ? EIO : errno;
            return false;
        }
        next += got;
        offset += (uint64_t)got;
        bytes -= (uint64_t)got;
    }
    return true;
}

bool file_write_at(int handle, const void *data, uint64_t bytes, uint64_t offset) {
    const char *next = data;
    while (bytes > 0) {
        ssize_t put = pwrite(handle, next, bytes, (off_t)offset);
        if (put < 0 && errno == EINTR)
            continue;
        if (put <= 0) {
            errno = put == 0 ? EIO : errno;
            return false;
        }
        next += put;
        offset += (uint64_t)put;
        bytes -= (uint64_t)put;
    }
    return true;
}

bool file_shorten(const char *path, char name[FILE_PATH_MAX], int *folder, struct error *error) {
    char directory[FILE_PATH_MAX];
    *folder = -1;
    snprintf(name, FILE_PATH_MAX, "%s", path);
    if (strlen(path) <= FILE_SHORT_MAX)
        return true;
    directory_of(path, directory);
    const char *slash = strrchr(path, '/');
    *folder = open(directory, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (*folder < 0)
        return error_set_errno(error, "%s: cannot be opened", directory);
    snprintf(name, FILE_PATH_MAX, "/proc/self/fd/%d/%s", *folder, slash ? slash + 1 : path);
    return true;
}
