/* SPDX-License-Identifier: BSD-3-Clause */
/* The life of a set of particles: room, append, remove, reorder, wrap. Read particles.h first. */
#include "kernel/particles/particles.h"
#include "base/memory.h"
#include "base/scan.h"
#include "base/stream.h"
#include "kernel/particles/kinds.h"
#include "kernel/particles/storage.h"
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { CAPACITY_MIN = 16 };

static const struct field image = {.name = "image",
                                   .type = FIELD_INT32,
                                   .components = 3,
                                   .use = FIELD_TRAVELS | FIELD_OUTPUT | FIELD_SPATIAL,
                                   .needed_for = "a periodic direction",
                                   .help = "crossings of the periodic box"};

static void arrays_resize(struct particles *particles, size_t capacity) {
    struct storage *storage = particles->storage;
    for (int a = 0; a < storage->arrays; a++) {
        struct storage_array *array = &storage->array[a];
        array->base = memory_resize(array->base, capacity, array->stride, "particles");
    }
    particles->capacity = capacity;
    storage_publish(particles);
}

struct particles *particles_create(size_t capacity) {
    struct particles *particles = memory_allocate_zero(1, sizeof *particles, "particle set");
    particles->storage = memory_allocate_zero(1, sizeof *particles->storage, "particle set");
    storage_begin(particles->storage);
    arrays_resize(particles, capacity > CAPACITY_MIN ? capacity : CAPACITY_MIN);
    return particles;
}

void particles_destroy(struct particles **particles) {
    if (*particles == NULL)
        return;
    struct storage *storage = (*particles)->storage;
    for (int a = 0; a < storage->arrays; a++)
        memory_free(storage->array[a].base);
    memory_free(storage);
    memory_free(*particles);
    *particles = NULL;
}

void particles_count_images(struct particles *particles) {
    fields_register(particles, &image);
}

int32_t (*particles_images(const struct particles *particles))[3] {
    return fields_values(particles, &image);
}

void particles_reserve(struct particles *particles, size_t capacity) {
    if (capacity <= particles->capacity)
        return;
    size_t grown = particles->capacity + particles->capacity / 8;
    arrays_resize(particles, capacity > grown ? capacity : grown);
}

size_t particles_append(struct particles *particles) {
    assert(particles->ghosts == 0);
    if (particles->owned == particles->capacity)
        particles_reserve(particles, 2 * particles->capacity);
    size_t k = particles->owned++;
    for (int a = 0; a < particles->storage->arrays; a++) {
        const struct storage_array *array = &particles->storage->array[a];
        memset(array->base + k * array->stride, 0, array->stride);
    }
    storage_fill(particles, k, 1);
    particles->revision++;
    return k;
}

size_t particles_remove(struct particles *particles, const uint8_t *remove) {
    assert(particles->ghosts == 0);
    size_t n = particles->owned, kept = 0;
    for (int a = 0; a < particles->storage->arrays; a++) {
        size_t stride = particles->storage->array[a].stride;
        char *base = particles->storage->array[a].base;
        kept = 0;
        for (size_t k = 0; k < n; k++) {
            if (remove[k])
                continue;
            if (kept != k)
                memcpy(base + kept * stride, base + k * stride, stride);
            kept++;
        }
    }
    particles->owned = kept;
    if (kept != n)
        particles->revision++;
    return n - kept;
}

size_t particles_places(const uint8_t *leaves, size_t owned, uint32_t *place) {
    size_t left = scan_marked(leaves, owned, NULL), stay = owned - left, last = stay;
    uint32_t *gap = memory_allocate(left, sizeof *gap, "particles that leave");
    scan_marked(leaves, owned, gap);
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < owned; k++)
        place[k] = leaves[k] ? PARTICLE_LEFT : (uint32_t)k;
    for (size_t g = 0; g < left && gap[g] < stay; g++) {
        while (leaves[last])
            last++;
        place[last++] = gap[g];
    }
    memory_free(gap);
    return stay;
}

void particles_vacate(struct particles *particles, const uint32_t *place, size_t stay) {
    assert(particles->ghosts == 0);
    size_t owned = particles->owned;
    for (int a = 0; a < particles->storage->arrays; a++) {
        size_t stride = particles->storage->array[a].stride;
        char *base = particles->storage->array[a].base;
        for (size_t k = stay; k < owned; k++)
            if (place[k] != PARTICLE_LEFT)
                memcpy(base + place[k] * stride, base + k * stride, stride);
    }
    if (stay != owned)
        particles->revision++;
    particles->owned = stay;
}

/* Copies row order[k] (of rows that lie `stride` apart) to row k of `bytes`, by the threads of the calling
 * team. Inlined for each length, as a call for each row would cost more than the copy. */
static inline __attribute__((always_inline)) void gather_rows(char *restrict to, const char *restrict from,
                                                              size_t stride, const uint32_t *order, size_t n,
                                                              size_t bytes) {
    const bool streaming = bytes % 16 == 0 && n * bytes > STREAM_BYTES;
#pragma omp for schedule(static)
    for (size_t k = 0; k < n; k++) {
        if (streaming)
            stream_copy(to + k * bytes, from + (size_t)order[k] * stride, bytes);
        else
            memcpy(to + k * bytes, from + (size_t)order[k] * stride, bytes);
    }
    stream_end(); /* other threads see the data from the end of the region on */
}

static void gather(char *restrict to, const char *restrict from, const uint32_t *order, size_t n,
                   size_t stride) {
#pragma omp parallel
    switch (stride) {
    case 64:
        gather_rows(to, from, 64, order, n, 64);
        break;
    case 32:
        gather_rows(to, from, 32, order, n, 32);
        break;
    case 12:
        gather_rows(to, from, 12, order, n, 12);
        break;
    case 8:
        gather_rows(to, from, 8, order, n, 8);
        break;
    case 1:
        gather_rows(to, from, 1, order, n, 1);
        break;
    default:
        gather_rows(to, from, stride, order, n, stride);
    }
}

/* Copies, or (`from` NULL) clears, by all threads. */
static void copy(char *to, const char *from, size_t bytes) {
    enum { PIECE = 1 << 16 };
#pragma omp parallel
    {
#pragma omp for schedule(static)
        for (size_t first = 0; first < bytes; first += PIECE) {
            size_t length = bytes - first < PIECE ? bytes - first : PIECE;
            if (bytes > STREAM_BYTES)
                stream_copy(to + first, from ? from + first : NULL, length);
            else if (from)
                memcpy(to + first, from + first, length);
            else
                memset(to + first, 0, length);
        }
        stream_end();
    }
}

/* Gathers an array piece after piece of its rows, each of at most `width` bytes through `spare`, which has
 * room for these. */
static void gather_pieces(const struct storage_array *array, char *spare, size_t width, const uint32_t *order,
                          size_t n) {
    for (size_t offset = 0; offset < array->stride; offset += width) {
        const size_t bytes = array->stride - offset < width ? array->stride - offset : width;
        char *piece = array->base + offset;
#pragma omp parallel
        {
            if (bytes == 32)
                gather_rows(spare, piece, array->stride, order, n, 32);
            else
                gather_rows(spare, piece, array->stride, order, n, bytes);
#pragma omp for schedule(static)
            for (size_t k = 0; k < n; k++)
                memcpy(piece + k * array->stride, spare + k * bytes, bytes);
        }
    }
}

/* Gathers an array that is as wide as the spare one into the spare one, and exchanges the two; copies any
 * other array back from the spare one. While forces are zero, their array is the spare one. */
void particles_reorder(struct particles *particles, const uint32_t *order) {
    assert(particles->ghosts == 0);
    struct storage *storage = particles->storage;
    struct storage_array *force = &storage->array[STORAGE_FORCE];
    const size_t n = particles->owned;
    const bool lend = particles->force_clear; /* few arrays are wider, that of the states by twice */
    const size_t width = lend ? force->stride : sizeof(struct particle_state);
    char *spare = lend ? force->base : memory_allocate(particles->capacity, width, "particles, second array");
    for (int a = 0; a < storage->arrays; a++) {
        struct storage_array *array = &storage->array[a];
        if (a == STORAGE_FORCE && lend)
            continue;
        if (array->stride > width) {
            gather_pieces(array, spare, width, order, n);
            continue;
        }
        gather(spare, array->base, order, n, array->stride);
        if (array->stride == width) {
            char *now = array->base;
            array->base = spare;
            spare = now;
        } else {
            copy(array->base, spare, n * array->stride);
        }
    }
    if (lend) {
        force->base = spare;
        copy(force->base, NULL, n * force->stride);
    } else {
        memory_free(spare);
    }
    storage_publish(particles);
    particles->revision++;
}

void particles_spread(struct particles *particles) {
    struct storage *storage = particles->storage;
    assert(particles->ghosts == 0);
    for (int a = 0; a < storage->arrays; a++) {
        struct storage_array *array = &storage->array[a];
        char *spread = memory_allocate(particles->capacity, array->stride, "particles");
        copy(spread, array->base, particles->owned * array->stride);
        memory_free(array->base);
        memory_trim();
        array->base = spread;
    }
    storage_publish(particles);
}

void particles_classify(struct particles *particles, const struct size_classes *classes) {
    particles_classify_from(particles, classes, 0);
}

void particles_classify_from(struct particles *particles, const struct size_classes *classes, size_t first) {
    const uint8_t *kind = kinds_of(particles);
#pragma omp parallel for schedule(static)
    for (size_t k = first; k < particles->owned; k++)
        particles->size_class[k] =
            (uint8_t)(kind ? kinds_class(classes, (enum kind)kind[k], particles->state[k].radius)
                           : classes_of(classes, particles->state[k].radius));
}

/* Wraps one coordinate; returns the number of edges that were subtracted. */
static double wrap_coordinate(double *x, double edge) {
    double turns = floor(*x / edge);
    *x -= turns * edge;
    /* Rounding may leave x at the upper face, which is the lower one */
    if (*x >= edge) {
        *x = 0;
        turns += 1;
    }
    return turns;
}

/* Wraps one particle of a box that moves: an image has a velocity of its own, and a turn along the gradient of
 * a shear moves the particle along the flow, which is wrapped afterwards. `jump` gets what the velocity has lost. False if
 * crossings cannot be counted. */
static bool wrap_moving(struct particle_state *state, const struct box *box, double velocity[IMAGE_CODES][4],
                        int32_t *crossed, double jump[3]) {
    const struct box_motion *motion = &box->motion;
    double image[3] = {0};
    for (int k = 0; k < 3; k++) {
        int d = (motion->gradient + k) % 3;
        if (!box->periodic[d] || (state->x[d] >= 0 && state->x[d] < box->edge[d]))
            continue;
        const int one[3] = {d == 0, d == 1, d == 2};
        const double *gained = velocity[image_code(one[0], one[1], one[2])];
        double turns = wrap_coordinate(&state->x[d], box->edge[d]);
        bool slides = motion->shears && d == motion->gradient;
        for (int c = 0; c < 3; c++) {
            state->v[c] -= turns * gained[c];
            jump[c] += turns * gained[c];
        }
        if (slides)
            state->x[motion->flow] -= turns * motion->offset;
        image[d] += turns;
        if (slides)
            image[motion->flow] -= turns * motion->turns;
    }
    for (int d = 0; crossed && d < 3; d++) {
        if (fabs(crossed[d] + image[d]) > INT32_MAX)
            return false;
        crossed[d] += (int32_t)image[d];
    }
    return true;
}

/* Takes a jump off the other velocities of particle k. */
static void jump_flow(const struct fields_flow *flow, int flows, const uint8_t *kind, size_t k,
                      const double jump[3]) {
    for (int f = 0; f < flows; f++)
        for (int c = 0; c < 3 && (!flow[f].kinds || (flow[f].kinds >> kind[k] & 1)); c++)
            flow[f].value[k][c] -= jump[c];
}

bool particles_wrap(struct particles *particles, const struct box *box) {
    struct fields_flow flow[FIELDS_MAX];
    const int flows = fields_flowing(particles, flow);
    const uint8_t *kind = kinds_of(particles);
    int bad = 0;
    double velocity[IMAGE_CODES][4];
    if (box->motion.moves)
        box_image_velocities(box, velocity);
    int32_t(*const crossed)[3] = particles_images(particles);
#pragma omp parallel for schedule(static) reduction(| : bad)
    for (size_t k = 0; k < particles->owned; k++) {
        double *x = particles->state[k].x, sum = x[0] + x[1] + x[2];
        if (!(sum - sum == 0)) {
            bad = 1;
            continue;
        }
        if (box->motion.moves) {
            double jump[3] = {0};
            bad |= !wrap_moving(&particles->state[k], box, velocity, crossed ? crossed[k] : NULL, jump);
            jump_flow(flow, flows, kind, k, jump);
            continue;
        }
        for (int d = 0; d < 3; d++) {
            if (!box->periodic[d] || (x[d] >= 0 && x[d] < box->edge[d]))
                continue;
            double wrapped = x[d], turns = wrap_coordinate(&wrapped, box->edge[d]);
            double image = crossed ? crossed[k][d] + turns : 0;
            if (fabs(image) > INT32_MAX) {
                bad = 1;
                continue;
            }
            x[d] = wrapped;
            if (crossed)
                crossed[k][d] = (int32_t)image;
        }
    }
    return !bad;
}

double particles_sphere_mass(double radius, double density) {
    return 4.0 / 3.0 * M_PI * radius * radius * radius * density;
}

double particles_density(const struct box *box, double radius, double density) {
    return box->density == BOX_DENSITY_AREA ? 0.75 * density / radius : density;
}

size_t particles_bytes_each(const struct particles *particles) {
    size_t bytes = 0;
    for (int a = 0; a < particles->storage->arrays; a++)
        bytes += particles->storage->array[a].stride;
    return bytes;
}

bool particles_valid(const struct particles *particles, char *why, size_t why_size) {
    if (particles->owned + particles->ghosts > particles->capacity) {
        snprintf(why, why_size, "%zu owned + %zu ghosts exceed the capacity %zu", particles->owned,
                 particles->ghosts, particles->capacity);
        return false;
    }
    for (size_t k = 0; k < particles->owned + particles->ghosts; k++) {
        const struct particle_state *s = &particles->state[k];
        bool finite = isfinite(s->x[0]) && isfinite(s->x[1]) && isfinite(s->x[2]) && isfinite(s->v[0]) &&
                      isfinite(s->v[1]) && isfinite(s->v[2]);
        if (finite && s->radius > 0 && s->inverse_mass >= 0 && particles->id[k] >= 1)
            continue;
        snprintf(why, why_size, "particle %zu (id %lld): position %g %g %g, radius %g, 1/mass %g", k,
                 (long long)particles->id[k], s->x[0], s->x[1], s->x[2], s->radius, s->inverse_mass);
        return false;
    }
    return true;
}
