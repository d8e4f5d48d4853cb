/* What contacts with walls remember: which record a contact goes on with, and the way over a rebuild. */
#include "contact/walls_parts.h"
#include "core/memory.h"
#include <assert.h>
#include <string.h>

/* A contact that appears takes over from one that vanishes if both point the same way: cosine of the angle.
 */
static const double carry_cosine = 0.5;
/* And if what vanishes is no farther than this many radii. */
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

void walls_recall(const struct walls *walls, size_t k, int w, size_t count, struct law_vector x,
                  double radius, struct wall_scratch *scratch) {
    const struct wall_records *old = &walls->records[walls->now];
    size_t records = (size_t)old->count[k], known = 0;
    if (records > 0)
        memset(scratch->taken, 0, records);
    for (size_t c = 0; c < count; c++) {
        scratch->from[c] = -1;
        for (size_t r = 0; r < records && scratch->from[c] < 0; r++) {
            const struct wall_key *key = &old->key[walls->first[k] + r];
            if (!scratch->taken[r] && key->wall == w && key->feature == scratch->touch[c].feature) {
                scratch->taken[r] = 1;
                scratch->from[c] = (int32_t)r;
                known++;
            }
        }
    }
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

void walls_detach(const struct walls *walls, const struct particles *particles, struct wall_rows *rows) {
    const struct wall_records *now = &walls->records[walls->now];
    size_t components = (size_t)walls->law->history_components, at = 0, k = 0;
    size_t candidates = components > 0 ? walls->candidates : 0;
    *rows = (struct wall_rows){
        .start = memory_allocate(particles->owned + 1, sizeof *rows->start, "wall history")};
    for (size_t c = 0; c < candidates; c++)
        rows->count += (size_t)now->count[c];
    rows->row = memory_allocate_zero(rows->count, sizeof *rows->row, "wall history");
    for (size_t i = 0; i < particles->owned; i++) {
        rows->start[i] = at;
        if (k == candidates || walls->particle[k] != i)
            continue;
        for (size_t r = walls->first[k]; r < walls->first[k] + (size_t)now->count[k]; r++) {
            struct wall_row *row = &rows->row[at++];
            *row = (struct wall_row){
                .id = particles->id[i], .wall = now->key[r].wall, .patch = now->key[r].feature};
            memcpy(row->value, now->value + r * components, components * sizeof *row->value);
        }
        k++;
    }
    rows->start[particles->owned] = at;
}

/* True if a row of history belongs to something that exists. */
static bool row_exists(const struct walls *walls, const struct wall_row *row) {
    return row->wall >= 0 && row->wall < walls->count && row->patch >= 0 &&
           (size_t)row->patch < walls_features(&walls->wall[row->wall]);
}

void walls_attach(struct walls *walls, const struct wall_rows *rows, const struct particles *particles) {
    struct wall_records *now = &walls->records[walls->now];
    size_t components = (size_t)walls->law->history_components;
    (void)particles; /* without assertions */
    assert(walls->candidates == 0 || walls->particle[walls->candidates - 1] < particles->owned);
    if (components == 0 || rows->count == 0)
        return;
    for (size_t k = 0; k < walls->candidates; k++) {
        size_t i = walls->particle[k], room = walls->first[k + 1] - walls->first[k], count = 0;
        for (size_t r = rows->start[i]; r < rows->start[i + 1] && count < room; r++) {
            const struct wall_row *row = &rows->row[r];
            if (!row_exists(walls, row))
                continue;
            now->key[walls->first[k] + count] = (struct wall_key){row->wall, row->patch};
            memcpy(now->value + (walls->first[k] + count) * components, row->value,
                   components * sizeof *row->value);
            count++;
        }
        now->count[k] = (int32_t)count;
    }
}
