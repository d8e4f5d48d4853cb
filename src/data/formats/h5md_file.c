/* SPDX-License-Identifier: BSD-3-Clause */
/* The present H5MD file: its elements and frames, room on the disk, units, and the XDMF file beside it. */
#include "data/formats/h5md_file.h"

#include "base/memory.h"
#include "base/file.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

bool h5md_write_unit(const struct h5md *h5md, const struct h5 *h5, const char *dataset, const char *unit,
                     struct error *error) {
    if (h5md->dimensionless || unit[0] == '\0' || strcmp(unit, "1") == 0)
        return true;
    char text[OUTPUT_NAME_MAX];
    const char *slash = strchr(unit, '/');
    if (slash)
        snprintf(text, sizeof text, "%.*s %s-1", (int)(slash - unit), unit, slash + 1);
    else
        snprintf(text, sizeof text, "%s", unit);
    return h5_write_free_text(h5, dataset, "unit", text, error);
}

bool h5md_make_element(const struct h5md *h5md, const struct h5 *h5, const char *group, const char *linked_to,
                       struct error *error) {
    char step[FILE_PATH_MAX], time[FILE_PATH_MAX];
    snprintf(step, sizeof step, "%s/step", group);
    snprintf(time, sizeof time, "%s/time", group);
    if (!h5_make_group(h5, group, error))
        return false;
    if (!linked_to)
        return h5_make_series(h5, step, FIELD_INT64, error) &&
               h5_make_series(h5, time, FIELD_DOUBLE, error) && h5md_write_unit(h5md, h5, time, "s", error);
    char from[FILE_PATH_MAX];
    snprintf(from, sizeof from, "%s/step", linked_to);
    if (!h5_link(h5, from, step, error))
        return false;
    snprintf(from, sizeof from, "%s/time", linked_to);
    return h5_link(h5, from, time, error);
}

uint64_t h5md_room(const struct h5md_stored *stored, uint64_t rows) {
    enum { ROOM_CHUNK = 128 }; /* bytes of an entry in the chunk index of the dataset */
    uint64_t chunk = stored->chunk > 0 ? stored->chunk : 1,
             widest = rows > stored->rows ? rows : stored->rows;
    uint64_t before = (stored->rows + chunk - 1) / chunk, after = (widest + chunk - 1) / chunk;
    uint64_t chunks = (stored->frames + 1) * after - stored->frames * before;
    return H5MD_ROOM_DATASET + chunks * (chunk * stored->row_bytes + ROOM_CHUNK);
}

bool h5md_reserve(const struct h5md *h5md, uint64_t bytes, struct error *error) {
    /* waiting observables: values, and the groups and first chunks of their series */
    uint64_t columns = (uint64_t)h5md->observables + 2;
    bytes += h5md->kept > 0 ? columns * (8192 + h5md->kept * sizeof(double)) : 0;
    if (h5md->comm->rank == 0)
        file_reserve(h5md->path, bytes, error);
    return comm_agree(h5md->comm, error);
}

struct h5md_element *h5md_add_element(struct h5md *h5md, const char *name, enum field_type type,
                                      int components, bool frames) {
    bool single = h5md->single && frames && type == FIELD_DOUBLE;
    struct h5md_element *element = &h5md->element[h5md->elements++];
    *element = (struct h5md_element){.type = type, .single = single};
    snprintf(element->name, sizeof element->name, "%s", name);
    snprintf(element->dataset, sizeof element->dataset, "/particles/all/%s%s", name, frames ? "/value" : "");
    element->shown = (struct xdmf_column){.name = element->name,
                                          .dataset = element->dataset,
                                          .integer = type != FIELD_DOUBLE,
                                          .bytes = type == FIELD_INT32 || single ? 4 : 8,
                                          .components = components,
                                          .frames = frames};
    return element;
}

void h5md_remember(struct h5md *h5md, const struct xdmf_frame *frame) {
    if (h5md->frames == h5md->frame_room) {
        h5md->frame_room = h5md->frame_room ? 2 * h5md->frame_room : 64;
        h5md->frame = memory_resize(h5md->frame, h5md->frame_room, sizeof *h5md->frame, "list of frames");
    }
    h5md->frame[h5md->frames++] = *frame;
}

bool h5md_update_xdmf(struct h5md *h5md, bool last, struct error *error) {
    /* in a long series not at each frame, so that the work grows in proportion to the frames */
    bool due = h5md->frames > h5md->xdmf_frames + h5md->frames / 1000;
    if (h5md->xdmf && h5md->frames > 0 && (due || (last && h5md->frames != h5md->xdmf_frames))) {
        const char *slash = strrchr(h5md->path, '/');
        struct xdmf_column column[XDMF_COLUMNS_MAX];
        for (int k = 0; k < h5md->elements; k++)
            column[k] = h5md->element[k].shown;
        struct xdmf_content content = {.h5 = slash ? slash + 1 : h5md->path,
                                       .columns = h5md->elements,
                                       .column = column,
                                       .rows = h5md->rows,
                                       .frames = h5md->frames,
                                       .frame = h5md->frame};
        if (h5md->comm->rank == 0)
            xdmf_write(h5md->xdmf_path, &content, error);
        h5md->xdmf_frames = h5md->frames;
    }
    return comm_agree(h5md->comm, error);
}
