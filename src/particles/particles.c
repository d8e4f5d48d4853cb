#include "particles/particles.h"
#include "core/memory.h"
#include "core/stream.h"
#include "particles/storage.h"
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { CAPACITY_MIN = 16 };

static void arrays_resize(struct particles *particles, size_t capacity) {
    for (int a = 0; a < STORAGE_ARRAYS; a++) {
        if (!storage_present(a, particles->features))
            continue;
        size_t stride = storage_stride(a, particles->features);
        void *old = storage_get(particles, a);
        storage_set(particles, a, memory_resize(old, capacity, stride, "particles"));
    }
    particles->capacity = capacity;
}

struct particles *particles_create(unsigned features, size_t capacity) {
    struct particles *particles = memory_allocate_zero(1, sizeof *particles, "particle set");
    particles->features = features;
    particles->force_stride = (features & PARTICLE_SPIN) ? 8 : 4;
    arrays_resize(particles, capacity > CAPACITY_MIN ? capacity : CAPACITY_MIN);
    return particles;
}

void particles_destroy(struct particles **particles) {
    if (*particles == NULL)
        return;
    for (int a = 0; a < STORAGE_ARRAYS; a++)
        memory_free(storage_get(*particles, a));
    memory_free(*particles);
    *particles = NULL;
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
    for (int a = 0; a < STORAGE_ARRAYS; a++) {
        if (!storage_present(a, particles->features))
            continue;
        size_t stride = storage_stride(a, particles->features);
        memset((char *)storage_get(particles, a) + k * stride, 0, stride);
    }
    particles->revision++;
    return k;
}

size_t particles_remove(struct particles *particles, const uint8_t *remove) {
    assert(particles->ghosts == 0);
    size_t n = particles->owned, kept = 0;
    for (int a = 0; a < STORAGE_ARRAYS; a++) {
        if (!storage_present(a, particles->features))
            continue;
        size_t stride = storage_stride(a, particles->features);
        char *base = storage_get(particles, a);
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
    size_t stay = 0, last;
    for (size_t k = 0; k < owned; k++)
        stay += !leaves[k];
    last = stay;
    for (size_t k = 0; k < owned; k++)
        place[k] = leaves[k] ? PARTICLE_LEFT : (uint32_t)k;
    for (size_t k = 0; k < stay; k++) {
        if (!leaves[k])
            continue;
        while (leaves[last])
            last++;
        place[last++] = (uint32_t)k;
    }
    return stay;
}

void particles_vacate(struct particles *particles, const uint32_t *place, size_t stay) {
    assert(particles->ghosts == 0);
    size_t owned = particles->owned;
    for (int a = 0; a < STORAGE_ARRAYS; a++) {
        if (!storage_present(a, particles->features))
            continue;
        size_t stride = storage_stride(a, particles->features);
        char *base = storage_get(particles, a);
        for (size_t k = stay; k < owned; k++)
            if (place[k] != PARTICLE_LEFT)
                memcpy(base + place[k] * stride, base + k * stride, stride);
    }
    if (stay != owned)
        particles->revision++;
    particles->owned = stay;
}

/* Row k, of `bytes`, from row order[k] of those that lie `stride` apart; by the threads of the team that
 * calls. Inlined for each length, as a call for each row would cost more than the copy. */
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
    stream_end(); /* for others from the end of the region on */
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

/* Gathers particle states one half after the other, each through `spare`, which has room for halves. */
static void gather_halves(struct particle_state *state, char *spare, const uint32_t *order, size_t n) {
    enum { HALF = sizeof(struct particle_state) / 2 };
    for (size_t offset = 0; offset < sizeof(struct particle_state); offset += HALF) {
        char *array = (char *)state + offset;
#pragma omp parallel
        {
            gather_rows(spare, array, sizeof(struct particle_state), order, n, HALF);
#pragma omp for schedule(static)
            for (size_t k = 0; k < n; k++)
                memcpy(array + k * sizeof(struct particle_state), spare + k * HALF, HALF);
        }
    }
}

/* Arrays as wide as the spare one gather into it and change places with it; others are copied back from it.
 * While forces are zero their array is the spare one. */
void particles_reorder(struct particles *particles, const uint32_t *order) {
    assert(particles->ghosts == 0);
    const size_t force_stride = storage_stride(STORAGE_FORCE, particles->features), n = particles->owned;
    const bool lend = particles->force_clear; /* the array of states alone may be wider, by twice */
    const size_t width = lend ? force_stride : sizeof(struct particle_state);
    void *spare = lend ? (void *)particles->force
                       : memory_allocate(particles->capacity, width, "particles, second array");
    for (int a = 0; a < STORAGE_ARRAYS; a++) {
        if (!storage_present(a, particles->features) || (a == STORAGE_FORCE && lend))
            continue;
        size_t stride = storage_stride(a, particles->features);
        void *now = storage_get(particles, a);
        if (stride > width) {
            gather_halves(now, spare, order, n);
            continue;
        }
        gather(spare, now, order, n, stride);
        if (stride == width) {
            storage_set(particles, a, spare);
            spare = now;
        } else {
            copy(now, spare, n * stride);
        }
    }
    if (lend) {
        particles->force = spare;
        copy((char *)particles->force, NULL, n * force_stride);
    } else {
        memory_free(spare);
    }
    particles->revision++;
}

void particles_classify(struct particles *particles, const struct size_classes *classes) {
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < particles->owned; k++)
        particles->size_class[k] = (uint8_t)classes_of(classes, particles->state[k].radius);
}

/* Wraps one coordinate; returns how many edges it had to go back. */
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

bool particles_wrap(struct particles *particles, const struct box *box) {
    int bad = 0;
#pragma omp parallel for schedule(static) reduction(| : bad)
    for (size_t k = 0; k < particles->owned; k++) {
        double *x = particles->state[k].x, sum = x[0] + x[1] + x[2];
        if (!(sum - sum == 0)) {
            bad = 1;
            continue;
        }
        for (int d = 0; d < 3; d++) {
            if (!box->periodic[d] || (x[d] >= 0 && x[d] < box->edge[d]))
                continue;
            double turns = wrap_coordinate(&x[d], box->edge[d]);
            if (particles->image)
                particles->image[k][d] += (int32_t)turns;
        }
    }
    return !bad;
}

double particles_sphere_mass(double radius, double density) {
    return 4.0 / 3.0 * M_PI * radius * radius * radius * density;
}

double particles_mass(const struct particles *particles, size_t i) {
    const struct particle_state *state = &particles->state[i];
    if (state->inverse_mass > 0)
        return 1 / state->inverse_mass;
    assert(particles->density);
    return particles_sphere_mass(state->radius, particles->density[i]);
}

size_t particles_bytes_each(const struct particles *particles) {
    size_t bytes = 0;
    for (int a = 0; a < STORAGE_ARRAYS; a++)
        if (storage_present(a, particles->features))
            bytes += storage_stride(a, particles->features);
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
