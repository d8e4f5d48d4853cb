/* SPDX-License-Identifier: BSD-3-Clause */
/* Reads a text file as a whole, packed by gzip or not. */
#include "data/scene/scene_text.h"

#include "base/memory.h"
#include "base/file.h"

#include <errno.h>
#include <string.h>
#include <zlib.h>

/* The message of zlib about a file. */
static const char *reading_error(gzFile file) {
    int status = Z_OK;
    const char *why = gzerror(file, &status);
    return status == Z_OK ? NULL : status == Z_ERRNO ? strerror(errno) : why;
}

bool scene_read_text(const char *path, char **text, size_t *length, struct error *error) {
    *text = NULL;
    const char *waits = file_waits(path);
    if (waits)
        return error_set(error, ERROR_USER, "%s: %s", path, waits);
    gzFile file = gzopen(path, "rb");
    if (!file)
        return error_set(error, ERROR_USER, "%s: cannot be read: %s", path, strerror(errno));
    enum { PART = 65536 };
    size_t have = 0, room = PART + 1;
    char *data = memory_allocate(room, 1, "scene text");
    int got;
    while ((got = gzread(file, data + have, PART)) > 0) {
        have += (size_t)got;
        if (room - have <= PART)
            data = memory_resize(data, room *= 2, 1, "scene text");
    }
    const char *why = reading_error(file);
    bool good = why == NULL || error_set(error, ERROR_USER, "%s: cannot be read: %s", path, why);
    gzclose(file);
    if (good && memchr(data, '\0', have))
        good = error_set(error, ERROR_USER, "%s: not a text file", path);
    if (!good) {
        memory_free(data);
        return false;
    }
    data[have] = '\0';
    *text = data;
    if (length)
        *length = have;
    return true;
}
