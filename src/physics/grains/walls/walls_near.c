/* SPDX-License-Identifier: BSD-3-Clause */
/* Candidates: the particles near walls, with the pieces near each (walls_parts.h). Count, scan, fill; each
 * thread its own range of particles, so that the result is the same for any number of threads. */
#include "physics/grains/walls/walls_near.h"
#include "physics/grains/walls/walls_touch.h"
#include "kernel/particles/spin.h"
#include "base/memory.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static void reserve(struct walls *walls, size_t candidates, size_t pieces) {
    size_t components = (size_t)walls->law->history_components;
    if (candidates > walls->candidate_capacity) {
        size_t n = walls->candidate_capacity = candidates + candidates / 4;
        walls->particle = memory_resize(walls->particle, n, sizeof *walls->particle, "wall candidates");
        walls->first = memory_resize(walls->first, n + 1, sizeof *walls->first, "wall candidates");
        for (int b = 0; b < 2; b++)
            walls->records[b].count =
                memory_resize(walls->records[b].count, n, sizeof *walls->records[b].count, "wall history");
    }
    if (pieces > walls->piece_capacity) {
        size_t n = walls->piece_capacity = pieces + pieces / 4;
        walls->piece = memory_resize(walls->piece, n, sizeof *walls->piece, "wall candidates");
        for (int b = 0; b < 2; b++) {
            struct wall_records *records = &walls->records[b];
            records->key = memory_resize(records->key, n, sizeof *records->key, "wall history");
            records->value =
                memory_resize(records->value, n * components, sizeof *records->value, "wall history");
        }
    }
}

static int piece_compare(const void *a, const void *b) {
    const struct wall_piece *x = a, *y = b;
    return x->triangle < y->triangle ? -1 : x->triangle > y->triangle;
}

/* The triangles of one image of a mesh near x. `out` may be NULL; `number` is then not used. */
static size_t near_mesh(const struct wall *wall, struct law_vector x, double reach, struct wall_piece key,
                        struct wall_piece *out, int32_t *number) {
    struct law_vector apart = law_add(x, -1.0, wall_transform_point(&wall->pose, wall->mesh->centre));
    double far = reach + wall->mesh->radius;
    if (!(law_dot(apart, apart) < far * far))
        return 0;
    size_t count = wall_grid_query(wall->grid, walls_into_body(wall, x), reach, out ? number : NULL);
    for (size_t k = 0; out && k < count; k++) {
        out[k] = key;
        out[k].triangle = number[k];
    }
    if (out)
        qsort(out, count, sizeof *out, piece_compare);
    return count;
}

size_t walls_near(const struct walls *walls, int w, struct law_vector x, double reach, struct wall_piece *out,
                  int32_t *number) {
    const struct wall *wall = &walls->wall[w];
    size_t count = 0;
    for (int k = 0; k < wall->image_count; k++) {
        struct wall_piece key = {.wall = (uint8_t)w, .image = (uint8_t)wall->image[k]};
        struct law_vector here = law_add(x, -1.0, walls_shift(walls, w, wall->image[k]));
        struct wall_piece *place = out ? out + count : NULL;
        if (wall->mesh) {
            count += near_mesh(wall, here, reach, key, place, number);
            continue;
        }
        struct wall_cylinder cylinder = walls_cylinder(wall);
        bool near = wall->options.shape == WALL_PLANE
                        ? law_dot(wall->axis_now, law_add(here, -1.0, wall->point_now)) < reach
                        : wall_cylinder_near(&cylinder, here, reach);
        if (near && place)
            *place = key;
        count += near;
    }
    return count;
}

/* The images of a wall that are nearer than `reach` by its field. */
static size_t near_field(const struct walls *walls, int w, struct law_vector x, double reach,
                         struct wall_piece *out) {
    const struct wall *wall = &walls->wall[w];
    size_t count = 0;
    for (int k = 0; k < wall->image_count; k++) {
        struct law_vector here = law_add(x, -1.0, walls_shift(walls, w, wall->image[k])), gradient;
        double distance;
        if (!wall_field_at(wall->field, walls_into_body(wall, here), &distance, &gradient) ||
            !(fabs(distance) < reach))
            continue;
        if (out)
            out[count] = (struct wall_piece){
                .triangle = WALL_PIECE_FIELD, .wall = (uint8_t)w, .image = (uint8_t)wall->image[k]};
        count++;
    }
    return count;
}

static bool is_zero(const double a[3]) {
    return a[0] == 0 && a[1] == 0 && a[2] == 0;
}

bool walls_at_rest(const struct particles *particles, size_t i) {
    const struct particle_state *state = &particles->state[i];
    if (state->inverse_mass != 0 || !is_zero(state->v))
        return false;
    const double(*omega)[4] = spin_values(particles);
    return omega == NULL || is_zero(omega[i]);
}

/* How far a particle may go in the frame of a wall until the next rebuild. No point of the wall moves farther than `margin`, but a
 * centre farther out than any of them does where the wall turns. */
static double drift_of(const struct wall *wall, struct law_vector here, double margin) {
    struct law_vector arm = law_add(here, -1.0, wall->mesh->centre);
    double far = (sqrt(law_dot(arm, arm)) + margin) / wall->mesh->radius;
    return wall->moving ? margin * law_max(1.0, far) : margin;
}

/* `face` of the first of the pieces of a wall near x (walls_parts.h). */
static uint8_t face_of(const struct walls *walls, const struct wall_piece *piece, size_t pieces,
                       struct law_vector x, double margin) {
    const struct wall *wall = &walls->wall[piece->wall];
    if (wall->mesh == NULL || wall->field)
        return 0;
    struct law_vector here =
        walls_into_body(wall, law_add(x, -1.0, walls_shift(walls, piece->wall, piece->image)));
    double drift = drift_of(wall, here, margin);
    uint8_t face = 0;
    for (size_t k = 0; k < pieces; k++) {
        if (piece[k].image != piece->image ||
            wall->mesh->triangle[piece[k].triangle].patch != wall->mesh->triangle[piece->triangle].patch)
            return 0;
        if (k < UINT8_MAX && wall_touch_inside(wall->mesh, piece[k].triangle, here) > drift)
            face = (uint8_t)(k + 1);
    }
    return face;
}

/* All pieces near particle i; counts only without `out`. */
static size_t near_particle(const struct walls *walls, const struct particles *particles,
                            const struct size_classes *classes, size_t i, struct wall_piece *out,
                            int32_t *number) {
    const struct particle_state *state = &particles->state[i];
    double margin = classes->margin[particles->size_class[i]][classes->count];
    struct law_vector x = wall_vector(state->x);
    size_t count = 0;
    bool fixed = !walls->fixed_too && walls_at_rest(particles, i);
    for (int w = 0; w < walls->count; w++) {
        struct wall_piece *place = out ? out + count : NULL;
        if (fixed && !wall_moves(&walls->wall[w].options))
            continue;
        size_t found = walls->wall[w].field ? near_field(walls, w, x, state->radius + margin, place)
                                            : walls_near(walls, w, x, state->radius + margin, place, number);
        if (place && found > 0)
            place->face = face_of(walls, place, found, x, margin);
        count += found;
    }
    return count;
}

/* A wall at rest that reaches into the box is not shifted: perhaps only its images touch particles there. */
void walls_wrap(struct walls *walls) {
    for (int w = 0; w < walls->count; w++) {
        struct wall *wall = &walls->wall[w];
        struct law_vector centre =
            wall_transform_point(&wall->pose, wall->mesh ? wall->mesh->centre : wall->point);
        const double at[3] = {centre.x, centre.y, centre.z};
        for (int d = 0; d < 3; d++) {
            double edge = walls->box.edge[d], reach = wall->reach[d];
            bool outside = at[d] + reach < 0.0 || at[d] - reach > edge;
            bool wraps = wall->images && walls->box.periodic[d] && (wall->moving || outside);
            wall->wrap[d] = wraps ? -edge * floor(at[d] / edge) : 0.0;
        }
    }
}

/* Stores the present poses: displacements start from them. Also selects the images of walls that have
 * travelled. */
static void anchor(struct walls *walls) {
    for (int w = 0; w < walls->count; w++)
        walls->wall[w].built = walls->wall[w].pose;
    walls_wrap(walls);
}

/* Lets the fields reach as far as particles look for walls. */
static void cover(struct walls *walls, const struct size_classes *classes) {
    double reach = 0.0;
    for (int c = 0; c < classes->count; c++)
        reach = law_max(reach, classes->radius_max[c] + classes->margin[c][classes->count]);
    walls_cover(walls, reach);
}

/* The results of one thread in its range of particles. */
struct share {
    size_t candidates, pieces, most;
};

static struct share count_range(struct walls *walls, const struct particles *particles,
                                const struct size_classes *classes, size_t first, size_t last) {
    struct share share = {0};
    for (size_t i = first; i < last; i++) {
        size_t n = near_particle(walls, particles, classes, i, NULL, NULL);
        walls->near_count[i] = (uint32_t)n;
        share.candidates += n > 0;
        share.pieces += n;
        share.most = n > share.most ? n : share.most;
    }
    return share;
}

static void fill_range(struct walls *walls, const struct particles *particles,
                       const struct size_classes *classes, size_t first, size_t last, struct share at,
                       int32_t *number) {
    for (size_t i = first; i < last; i++) {
        if (walls->near_count[i] == 0)
            continue;
        walls->particle[at.candidates] = (uint32_t)i;
        walls->first[at.candidates++] = at.pieces;
        near_particle(walls, particles, classes, i, walls->piece + at.pieces, number);
        at.pieces += walls->near_count[i];
    }
}

static size_t range_start(size_t owned, int thread, int threads) {
    return owned * (size_t)thread / (size_t)threads;
}

void walls_build(struct walls *walls, const struct particles *particles, const struct size_classes *classes) {
    size_t owned = particles->owned;
    int threads = walls->threads;
    struct share *share = memory_allocate((size_t)threads + 1, sizeof *share, "wall candidates");
    if (owned > walls->near_capacity) {
        walls->near_capacity = owned + owned / 8;
        walls->near_count = memory_resize(walls->near_count, walls->near_capacity, sizeof *walls->near_count,
                                          "wall candidates");
    }
    anchor(walls);
    cover(walls, classes);
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < threads; t++)
        share[t] = count_range(walls, particles, classes, range_start(owned, t, threads),
                               range_start(owned, t + 1, threads));
    struct share sum = {0};
    for (int t = 0; t < threads; t++) {
        struct share mine = share[t];
        share[t] = sum;
        sum.candidates += mine.candidates;
        sum.pieces += mine.pieces;
        sum.most = mine.most > sum.most ? mine.most : sum.most;
    }
    reserve(walls, sum.candidates, sum.pieces);
#pragma omp parallel for schedule(static, 1)
    for (int t = 0; t < threads; t++) {
        int32_t *number = memory_allocate(sum.most, sizeof *number, "wall candidates");
        walls_scratch_reserve(walls->scratch[t], sum.most);
        fill_range(walls, particles, classes, range_start(owned, t, threads),
                   range_start(owned, t + 1, threads), share[t], number);
        memory_free(number);
    }
    walls->candidates = sum.candidates;
    walls->first[sum.candidates] = sum.pieces;
    walls->now = 0;
    if (sum.candidates > 0)
        memset(walls->records[0].count, 0, sum.candidates * sizeof *walls->records[0].count);
    memory_free(share);
}
