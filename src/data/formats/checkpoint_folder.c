/* SPDX-License-Identifier: BSD-3-Clause */
/* Lists and deletes the checkpoints in a folder. */
#include "data/formats/checkpoint_folder.h"

#include "base/memory.h"
#include "base/file.h"
#include "data/formats/output_options.h"

#include <dirent.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* STEP of "checkpoint-STEPending"; -1 for other names. */
static int64_t step_of_name(const char *name, const char *ending) {
    static const char lead[] = "checkpoint-";
    size_t skip = sizeof lead - 1, digits = 0;
    if (strncmp(name, lead, skip) != 0)
        return -1;
    while (name[skip + digits] >= '0' && name[skip + digits] <= '9')
        digits++;
    if (digits == 0 || digits > 18 || strcmp(name + skip + digits, ending) != 0)
        return -1;
    return strtoll(name + skip, NULL, 10);
}

static int compare_steps(const void *a, const void *b) {
    int64_t x = *(const int64_t *)a, y = *(const int64_t *)b;
    return (x < y) - (x > y);
}

/* The steps of the checkpoints in a directory, the newest first; memory_free. */
static int64_t *list_steps(const char *directory, size_t *count) {
    int64_t *step = NULL;
    *count = 0;
    DIR *open_directory = opendir(directory);
    if (!open_directory)
        return NULL;
    for (const struct dirent *entry; (entry = readdir(open_directory)) != NULL;) {
        int64_t found = step_of_name(entry->d_name, ".h5");
        if (found < 0)
            continue;
        step = memory_resize(step, *count + 1, sizeof *step, "checkpoints in a directory");
        step[(*count)++] = found;
    }
    closedir(open_directory);
    if (step)
        qsort(step, *count, sizeof *step, compare_steps);
    return step;
}

void checkpoint_delete_old(const char *directory, uint64_t newest, int keep) {
    size_t count;
    int kept = 0;
    int64_t *step = list_steps(directory, &count);
    for (size_t k = 0; k < count; k++) {
        if (step[k] > (int64_t)newest || kept++ < keep)
            continue;
        char path[FILE_PATH_MAX + OUTPUT_NAME_MAX];
        snprintf(path, sizeof path, "%s/checkpoint-%" PRId64 ".h5", directory, step[k]);
        unlink(path);
    }
    memory_free(step);
}

bool checkpoint_find(const char *directory, size_t place, char *path) {
    size_t count;
    int64_t *step = list_steps(directory, &count);
    if (place < count)
        snprintf(path, FILE_PATH_MAX, "%s/checkpoint-%" PRId64 ".h5", directory, step[place]);
    memory_free(step);
    return place < count;
}

bool checkpoint_discard(const char *directory, int64_t step, struct error *error) {
    static const char *const endings[] = {".h5", ".h5.part", CHECKPOINT_STOPPED ".h5",
                                          CHECKPOINT_STOPPED ".h5.part"};
    char path[FILE_PATH_MAX];
    DIR *open_directory = opendir(directory);
    if (!open_directory)
        return error_set_errno(error, "%s: cannot be listed", directory);
    for (const struct dirent *entry; (entry = readdir(open_directory)) != NULL;)
        for (size_t k = 0; k < sizeof endings / sizeof endings[0]; k++)
            if (step_of_name(entry->d_name, endings[k]) > step &&
                file_join(path, directory, entry->d_name, error) && unlink(path) != 0)
                error_set_errno(error, "%s: cannot be deleted", path);
    closedir(open_directory);
    return error->kind == ERROR_NONE;
}
