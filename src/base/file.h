/* SPDX-License-Identifier: BSD-3-Clause */
/* Files that appear whole or not at all: written under a temporary name, flushed to disk, renamed. */
#ifndef SCREE_BASE_FILE_H
#define SCREE_BASE_FILE_H

#include "base/error.h"
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

enum { FILE_PATH_MAX = 1024 }; /* bytes of a path, the end included */

/* A text file that is being written. */
struct file_new {
    FILE *stream;
    char path[FILE_PATH_MAX], temporary[FILE_PATH_MAX + 8];
};

/* Opens PATH.part for writing. */
bool file_new_open(struct file_new *file, const char *path, struct error *error);

/* Flushes the file and renames it to PATH. If a write failed (disk full), the temporary file is removed and
 * PATH stays unchanged. May be called after an error: the function then only cleans up, and returns false. */
bool file_new_close(struct file_new *file, struct error *error);

/* Flushes a closed file's bytes to disk, renames it, flushes the directory. */
bool file_settle(const char *temporary, const char *path, struct error *error);

/* Fails with "disk full" or "file size limit" if `bytes` more bytes do not fit on the disk of `path`.
 * `present`: the present size of the file, in bytes. */
bool file_check_room(const char *path, uint64_t present, uint64_t bytes, struct error *error);

/* Checks the same for an existing file, and reserves the room: `bytes` bytes behind the end stay free for the
 * file until the file is next cut to its size (HDF5 does so when it closes a file). If the file system cannot
 * reserve room, the function only checks. */
bool file_reserve(const char *path, uint64_t bytes, struct error *error);

/* Writes "DIRECTORY/NAME" to path (FILE_PATH_MAX bytes). Fails (user) if the text does not fit. */
bool file_join(char *path, const char *directory, const char *name, struct error *error);

/* Tells whether an errno of open says that there is no such file for this user: a wrong name, or no
 * permission. Every other errno is a failure of the system. */
bool file_is_missing(int code);

/* Reads or writes exactly so many bytes at a place of an open file; false, with errno set, if that fails or
 * the file ends before (EIO). */
bool file_read_at(int handle, void *data, uint64_t bytes, uint64_t offset);
bool file_write_at(int handle, const void *data, uint64_t bytes, uint64_t offset);

/* A name for libraries that keep names in short buffers (Open MPI's shared file pointers have 256 bytes). The
 * name is the path itself or, if the path is longer than FILE_SHORT_MAX, "/proc/self/fd/N/NAME". N is a
 * handle of the folder; the handle must stay open as long as the name is used. *folder becomes N, or -1 for
 * the path itself. */
enum { FILE_SHORT_MAX = 160 };
bool file_shorten(const char *path, char name[FILE_PATH_MAX], int *folder, struct error *error);

/* Why a path must not be opened for reading, as that could wait for ever: "is a named pipe, not a file", say.
 * NULL: it may be opened, or is not there. A pipe without a name, as bash's <(...) makes it, may be. */
const char *file_waits(const char *path);

/* Size of a file in bytes, or -1 if the system does not give the size. */
int64_t file_size(const char *path);

#endif
