/* SPDX-License-Identifier: BSD-3-Clause */
/* Gives particles their ids. Read source_makers.h first. */
#include "data/scene/source_makers.h"

#include "base/memory.h"

#include <stdlib.h>

/* True if the rows of a source have ids of their own, by the file or by the scene. */
static bool names_ids(const struct source_options *options, const struct source_batch *batch) {
    return options->kind == SOURCE_SINGLE ? options->id > 0
                                          : batch->rows.id && options->ids == SOURCE_IDS_FILE;
}

static int64_t named_id(const struct source_options *options, const struct source_batch *batch, size_t row) {
    return options->kind == SOURCE_SINGLE ? options->id : batch->rows.id[row];
}

static int by_id(const void *a, const void *b) {
    int64_t x = *(const int64_t *)a, y = *(const int64_t *)b;
    return (x > y) - (x < y);
}

void source_ids_begin(struct source_ids *ids, const struct scene *scene, const struct source_batch *batch) {
    size_t named = 0;
    bool all = true;
    for (int s = 0; s < scene->sources; s++) {
        bool names = names_ids(&scene->source[s], &batch[s]);
        named += names ? batch[s].rows.count : 0;
        all = all && names;
    }
    if (all || named == 0)
        return; /* no new id has to leave out another */
    ids->named = memory_allocate(named, sizeof *ids->named, "ids of files");
    for (int s = 0; s < scene->sources; s++) {
        const struct source_options *options = &scene->source[s];
        for (size_t k = 0; names_ids(options, &batch[s]) && k < batch[s].rows.count; k++) {
            struct source_sphere sphere = source_sphere_of(options, &batch[s], k);
            if (!source_sphere_left_out(options, &sphere))
                ids->named[ids->count++] = named_id(options, &batch[s], k);
        }
    }
    qsort(ids->named, ids->count, sizeof *ids->named, by_id);
}

int64_t source_ids_give(struct source_ids *ids, const struct source_options *options,
                        const struct source_batch *batch, size_t row) {
    if (names_ids(options, batch))
        return named_id(options, batch, row);
    ids->last++;
    for (; ids->passed < ids->count && ids->named[ids->passed] <= ids->last; ids->passed++)
        ids->last += ids->named[ids->passed] == ids->last;
    return ids->last;
}

void source_ids_free(struct source_ids *ids) {
    memory_free(ids->named);
    *ids = (struct source_ids){0};
}
