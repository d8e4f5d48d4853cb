/* SPDX-License-Identifier: BSD-3-Clause */
/* Contact lists: /connectivity/contacts holds the pairs of ids, /connectivity/wall_contacts the ids of
 * particles that touch a wall. The values of each contact stand in the same row in /observables/contact_list
 * and /observables/wall_contact_list. All these elements share one step and time. Absent rows have ids -1. */
#include "data/formats/h5md_parts.h"
#include "data/formats/h5md_file.h"
#include "data/formats/h5md_head.h"

#include "base/memory.h"

#include <stdio.h>
#include <string.h>

enum { CHUNK_CONTACTS = 8192 };

static const char contacts_group[] = "/connectivity/contacts";

/* A value of a contact that is written; `group` is the path of the element. */
struct part {
    const char *group;
    const char *unit;
    enum field_type type;
    int width; /* 0: one value */
    bool wall;
    void (*get)(const struct force_contact *contact, void *value);
};

static void get_ids(const struct force_contact *contact, void *value) {
    ((int64_t *)value)[0] = contact->id_i;
    ((int64_t *)value)[1] = contact->id_j;
}

static void get_id(const struct force_contact *contact, void *value) {
    *(int64_t *)value = contact->id_i;
}

static void get_wall(const struct force_contact *contact, void *value) {
    *(int64_t *)value = -contact->id_j - 1;
}

static void get_force(const struct force_contact *contact, void *value) {
    memcpy(value, contact->force, sizeof contact->force);
}

static void get_normal(const struct force_contact *contact, void *value) {
    memcpy(value, contact->normal, sizeof contact->normal);
}

static void get_overlap(const struct force_contact *contact, void *value) {
    *(double *)value = contact->overlap;
}

static const struct part parts[] = {
    {"/connectivity/contacts", "", FIELD_INT64, 2, false, get_ids},
    {"/observables/contact_list/force", "N", FIELD_DOUBLE, 3, false, get_force},
    {"/observables/contact_list/normal", "", FIELD_DOUBLE, 3, false, get_normal},
    {"/observables/contact_list/overlap", "m", FIELD_DOUBLE, 0, false, get_overlap},
    {"/connectivity/wall_contacts", "", FIELD_INT64, 0, true, get_id},
    {"/observables/wall_contact_list/wall", "", FIELD_INT64, 0, true, get_wall},
    {"/observables/wall_contact_list/force", "N", FIELD_DOUBLE, 3, true, get_force},
    {"/observables/wall_contact_list/normal", "", FIELD_DOUBLE, 3, true, get_normal},
    {"/observables/wall_contact_list/overlap", "m", FIELD_DOUBLE, 0, true, get_overlap},
};
enum { PARTS = sizeof parts / sizeof parts[0] };

/* The numbers of rows of this rank and of all ranks: contacts, then wall contacts. */
struct counts {
    int64_t first[2], total[2];
};

static struct h5_table table_of(const struct part *part, const struct contact_list *list,
                                const struct counts *counts) {
    return (struct h5_table){.type = part->type,
                             .rows = (uint64_t)counts->total[part->wall],
                             .width = (uint64_t)part->width,
                             .first = (uint64_t)counts->first[part->wall],
                             .count = part->wall ? list->wall_count : list->particle_count};
}

static bool make_part(const struct h5md *h5md, const struct h5 *h5, const struct part *part,
                      const struct h5_table *table, struct error *error) {
    static const int64_t absent = -1;
    static const double nothing = 0;
    const void *fill = part->type == FIELD_INT64 ? (const void *)&absent : (const void *)&nothing;
    bool first = strcmp(part->group, contacts_group) == 0;
    char value[FILE_PATH_MAX];
    snprintf(value, sizeof value, "%s/value", part->group);
    if (!h5md_make_element(h5md, h5, part->group, first ? NULL : contacts_group, error) ||
        !h5_make_frames(h5, value, table, CHUNK_CONTACTS, fill, error) ||
        !h5md_write_unit(h5md, h5, value, part->unit, error))
        return false;
    if (strncmp(part->group, "/connectivity/", 14) != 0)
        return true;
    if (!h5_exists(h5, "/particles/all") && !h5_make_group(h5, "/particles/all", error))
        return false;
    return h5_write_reference(h5, part->group, "particles_group", "/particles/all", error) &&
           h5_write_reference(h5, value, "particles_group", "/particles/all", error);
}

static bool make_all(const struct h5md *h5md, const struct h5 *h5, const struct contact_list *list,
                     const struct counts *counts, struct error *error) {
    for (size_t k = 0; k < PARTS; k++) {
        struct h5_table table = table_of(&parts[k], list, counts);
        if (!make_part(h5md, h5, &parts[k], &table, error))
            return false;
    }
    static const char *const numbers[] = {"/observables/contact_list/count",
                                          "/observables/wall_contact_list/count"};
    bool good = true;
    for (size_t k = 0; good && k < 2; k++) {
        char value[FILE_PATH_MAX];
        snprintf(value, sizeof value, "%s/value", numbers[k]);
        good = h5md_make_element(h5md, h5, numbers[k], contacts_group, error) &&
               h5_make_series(h5, value, FIELD_INT64, error);
    }
    return good;
}

static bool write_part(const struct h5 *h5, const struct part *part, const struct contact_list *list,
                       const struct h5_table *table, uint64_t frame, struct error *error) {
    const struct force_contact *contact = part->wall ? list->wall : list->particle;
    size_t bytes = sizeof(double) * (size_t)(part->width ? part->width : 1);
    char *data = memory_allocate(table->count, bytes, "contacts to write");
    for (size_t k = 0; k < table->count; k++)
        part->get(&contact[k], data + k * bytes);
    char value[FILE_PATH_MAX];
    snprintf(value, sizeof value, "%s/value", part->group);
    bool good = h5_write_frame(h5, value, table, frame, data, error);
    memory_free(data);
    return good;
}

static bool write_all(struct h5md *h5md, const struct h5 *h5, const struct contact_list *list,
                      const struct counts *counts, struct error *error) {
    struct h5_shape shape;
    if (!h5_get_shape(h5, "/connectivity/contacts/step", &shape, error))
        return false;
    uint64_t frame = shape.size[0];
    hsize_t last = frame - 1, one = 1;
    int64_t known = -1;
    if (frame > 0 &&
        !h5_read_block(h5, "/connectivity/contacts/step", FIELD_INT64, &last, &one, &known, error))
        return false;
    if (known >= (int64_t)list->step) /* for example after a resume */
        return true;
    for (size_t k = 0; k < PARTS; k++) {
        struct h5_table table = table_of(&parts[k], list, counts);
        if (!write_part(h5, &parts[k], list, &table, frame, error))
            return false;
    }
    h5md->lists = frame + 1;
    for (int k = 0; k < 2; k++)
        if ((uint64_t)counts->total[k] > h5md->list_rows[k])
            h5md->list_rows[k] = (uint64_t)counts->total[k];
    int64_t step = (int64_t)list->step;
    return h5_write_series(h5, "/observables/contact_list/count/value", FIELD_INT64, frame, 1,
                           &counts->total[0], error) &&
           h5_write_series(h5, "/observables/wall_contact_list/count/value", FIELD_INT64, frame, 1,
                           &counts->total[1], error) &&
           h5_write_series(h5, "/connectivity/contacts/step", FIELD_INT64, frame, 1, &step, error) &&
           h5_write_series(h5, "/connectivity/contacts/time", FIELD_DOUBLE, frame, 1, &list->time, error);
}

/* Reserves the room for a list, or refuses before the file is changed. */
static bool reserve_room(const struct h5md *h5md, const struct counts *counts, struct error *error) {
    uint64_t bytes = H5MD_ROOM_FRAME;
    for (size_t k = 0; k < PARTS; k++) {
        const struct part *part = &parts[k];
        struct h5md_stored stored = {.frames = h5md->lists,
                                     .rows = h5md->list_rows[part->wall],
                                     .chunk = CHUNK_CONTACTS,
                                     .row_bytes = sizeof(double) * (size_t)(part->width ? part->width : 1)};
        bytes += h5md_room(&stored, (uint64_t)counts->total[part->wall]);
    }
    return h5md_reserve(h5md, bytes, error);
}

bool h5md_write_contacts(struct h5md *h5md, const struct contact_list *list, const struct box *box,
                         struct error *error) {
    struct counts counts = {.total = {(int64_t)list->particle_count, (int64_t)list->wall_count}};
    for (int k = 0; k < 2; k++)
        counts.first[k] = comm_scan(h5md->comm, counts.total[k]);
    comm_sum_int(h5md->comm, counts.total, 2);
    if ((!h5md->made && !h5md_make_file(h5md, box, error)) || !reserve_room(h5md, &counts, error))
        return false;
    struct h5 h5;
    if (!h5_open(&h5, h5md->path, h5md->comm, true, error))
        return false;
    if (h5_exists(&h5, contacts_group) || make_all(h5md, &h5, list, &counts, error))
        write_all(h5md, &h5, list, &counts, error);
    return h5_close(&h5, error);
}
