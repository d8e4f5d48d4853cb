/* SPDX-License-Identifier: BSD-3-Clause */
/* The history of contacts with walls: the old record of each contact, and the way over a rebuild. */
#include "physics/grains/walls/walls_history.h"
#include "physics/grains/walls/walls_touch.h"
#include "base/memory.h"
#include <assert.h>
#include <string.h>

/* A contact that appears takes over from one that vanishes if both point the same way: cosine of the angle.
 */
static const double carry_cosine = 0.5;
/* The vanished contact must also be no farther than this many radii. */
static const double carry_distance = 1.5;

struct law_vector walls_carry(struct law_vector spring, struct law_vector from, struct law_vector to) {
    struct law_vector axis = law_cross(from, to); /* of length sin(angle) */
    double cosine = law_dot(from, to);
    if (cosine < -0.999)
        return spring;
    struct law_vector once = law_cross(axis, spring);
    struct law_vector twice = law_cross(axis, once);
    return law_add(law_add(spring, 1.0, once), 1.0 / (1.0 + cosine), twice);
}

/* The best record of wall w that no contact has taken yet, for a contact that is new; -1: none. */
static int32_t find_vanished(const struct walls *walls, size_t k, int w, const struct wall_touch *touch,
                             struct law_vector x, double radius, const uint8_t *taken) {
    const struct wall_records *old = &walls->records[walls->now];
    struct law_vector here = law_add(x, -1.0, walls_shift(walls, w, touch->image));
    double best = carry_cosine;
    int32_t found = -1;
    for (int32_t r = 0; r < old->count[k]; r++) {
        const struct wall_key *key = &old->key[walls->first[k] + (size_t)r];
        if (taken[r] || key->wall != w)
            continue;
        double distance;
        struct law_vector toward = walls_toward(&walls->wall[w], key->feature, here, &distance);
        double cosine = law_dot(toward, touch->normal);
        if (cosine > best && fabs(distance) < carry_distance * radius) {
            best = cosine;
            found = r;
        }
    }
    return found;
}

/* Sorts contacts with one feature through several images of its wall by image, each among the places that
 * they have. A wrapped particle changes the images, not their order. */
static void sort_images(struct wall_touch *touch, size_t count) {
    for (size_t a = 0; a + 1 < count; a++)
        for (size_t b = a + 1; b < count; b++)
            if (touch[a].feature == touch[b].feature &&
                image_place((unsigned)touch[a].image) > image_place((unsigned)touch[b].image)) {
                struct wall_touch other = touch[a];
                touch[a] = touch[b];
                touch[b] = other;
            }
}

/* Gives the contacts with wall w that have no record yet those of their feature; with `images` only where the
 * image is the same, too. Returns the number of contacts that got one. */
static size_t recall_feature(const struct wall_key *key, size_t records, int w, size_t count, bool images,
                             struct wall_scratch *scratch) {
    size_t found = 0;
    for (size_t c = 0; c < count; c++) {
        const struct wall_touch *touch = &scratch->touch[c];
        for (size_t r = 0; r < records && scratch->from[c] < 0; r++) {
            if (scratch->taken[r] || key[r].wall != w || key[r].feature != touch->feature ||
                (images && key[r].image != touch->image))
                continue;
            scratch->taken[r] = 1;
            scratch->from[c] = (int32_t)r;
            found++;
        }
    }
    return found;
}

/* Finds the old records of the `count` contacts with wall w. */
static void recall(const struct walls *walls, size_t k, int w, size_t count, struct law_vector x,
                   double radius, struct wall_scratch *scratch) {
    const struct wall_records *old = &walls->records[walls->now];
    const struct wall_key *key = old->key + walls->first[k];
    size_t records = (size_t)old->count[k];
    if (records > 0)
        memset(scratch->taken, 0, records);
    for (size_t c = 0; c < count; c++)
        scratch->from[c] = -1;
    size_t known = recall_feature(key, records, w, count, true, scratch);
    if (known < count && known < records)
        known += recall_feature(key, records, w, count, false, scratch);
    if (known == count || known == records)
        return;
    for (size_t c = 0; c < count; c++) {
        if (scratch->from[c] >= 0)
            continue;
        int32_t r = find_vanished(walls, k, w, &scratch->touch[c], x, radius, scratch->taken);
        scratch->from[c] = r;
        if (r >= 0)
            scratch->taken[r] = 1;
    }
}

size_t walls_find(const struct walls *walls, size_t k, size_t first, size_t *last, struct law_vector x,
                  double radius, struct wall_scratch *scratch) {
    int w = walls->piece[first].wall;
    *last = first + 1;
    while (*last < walls->first[k + 1] && walls->piece[*last].wall == w)
        ++*last;
    const struct wall_piece *piece = walls->piece + first;
    size_t count = piece->face ? walls_touch_face(walls, piece, x, radius, scratch)
                               : walls_touch(walls, piece, *last - first, x, radius, scratch);
    if (count > 1 && walls->wall[w].image_count > 1)
        sort_images(scratch->touch, count);
    if (walls->law->history_components > 0 && count > 0)
        recall(walls, k, w, count, x, radius, scratch);
    else
        for (size_t c = 0; c < count; c++)
            scratch->from[c] = -1;
    return count;
}

void walls_detach(struct walls *walls, const struct particles *particles, struct history_rows *rows) {
    struct wall_records *now = &walls->records[walls->now];
    size_t components = (size_t)walls->law->history_components, at = 0, k = 0;
    size_t candidates = components > 0 ? walls->candidates : 0;
    *rows = (struct history_rows){
        .start = memory_allocate(particles->owned + 1, sizeof *rows->start, "wall history"),
        .components = (int)components};
    for (size_t c = 0; c < candidates; c++)
        rows->count += (size_t)now->count[c];
    struct history_row *row = rows->row = memory_allocate_zero(rows->count, sizeof *row, "wall history");
    for (size_t i = 0; i < particles->owned; i++) {
        rows->start[i] = at;
        if (k == candidates || walls->particle[k] != i)
            continue;
        for (size_t r = walls->first[k]; r < walls->first[k] + (size_t)now->count[k]; r++) {
            now->key[r].image = WALL_IMAGE_LOST; /* the image is lost here, as in the rows */
            row[at] = (struct history_row){
                .id = particles->id[i], .partner = wall_row_partner(now->key[r].wall, now->key[r].feature)};
            memcpy(row[at++].value, now->value + r * components, components * sizeof *row->value);
        }
        k++;
    }
    rows->start[particles->owned] = at;
}

/* True if the wall and the feature of a row of history exist. */
static bool row_exists(const struct walls *walls, const struct history_row *row) {
    int wall = wall_row_wall(row);
    return wall >= 0 && wall < walls->count &&
           (size_t)wall_row_feature(row) < walls_features(&walls->wall[wall]);
}

static bool triangle_has(const struct wall_triangle *t, int32_t feature) {
    bool has = t->patch == feature;
    for (int c = 0; c < 3; c++)
        has = has || t->edge[c] == feature || t->vertex[c] == feature;
    return has;
}

/* The relation of a row to the pieces of candidate k. */
enum row_place {
    ROW_AWAY,   /* its wall is not among them: no contact can go on with it */
    ROW_BESIDE, /* its wall is, its feature is not: a contact that crossed an edge may */
    ROW_HERE
};

static enum row_place row_place(const struct walls *walls, size_t k, const struct history_row *row) {
    enum row_place place = ROW_AWAY;
    int wall = wall_row_wall(row);
    int32_t feature = wall_row_feature(row);
    for (size_t p = walls->first[k]; p < walls->first[k + 1] && place != ROW_HERE; p++) {
        const struct wall_piece *piece = &walls->piece[p];
        const struct wall_mesh *mesh = walls->wall[piece->wall].mesh;
        if (piece->wall == wall)
            place = mesh == NULL || piece->triangle == WALL_PIECE_FIELD ||
                            triangle_has(&mesh->triangle[piece->triangle], feature)
                        ? ROW_HERE
                        : ROW_BESIDE;
    }
    return place;
}

/* Gives candidate k the rows [first, last) that stand to it as `place`, as far as there is room. */
static void attach_rows(struct walls *walls, size_t k, const struct history_row *first,
                        const struct history_row *last, enum row_place place) {
    struct wall_records *now = &walls->records[walls->now];
    size_t components = (size_t)walls->law->history_components;
    size_t at = walls->first[k] + (size_t)now->count[k];
    for (const struct history_row *row = first; row < last && at < walls->first[k + 1]; row++) {
        if (!row_exists(walls, row) || row_place(walls, k, row) != place)
            continue;
        now->key[at] = (struct wall_key){
            .wall = (int16_t)wall_row_wall(row), .image = WALL_IMAGE_LOST, .feature = wall_row_feature(row)};
        memcpy(now->value + at * components, row->value, components * sizeof *row->value);
        at++;
    }
    now->count[k] = (int32_t)(at - walls->first[k]);
}

void walls_attach(struct walls *walls, const struct history_rows *rows, const struct particles *particles) {
    (void)particles; /* without assertions */
    assert(walls->candidates == 0 || walls->particle[walls->candidates - 1] < particles->owned);
    if (walls->law->history_components == 0 || rows->count == 0)
        return;
    const struct history_row *row = rows->row;
    for (size_t k = 0; k < walls->candidates; k++) {
        const struct history_row *first = row + rows->start[walls->particle[k]];
        const struct history_row *last = row + rows->start[walls->particle[k] + 1];
        attach_rows(walls, k, first, last, ROW_HERE);
        attach_rows(walls, k, first, last, ROW_BESIDE);
    }
}
