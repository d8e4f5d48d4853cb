/* SPDX-License-Identifier: BSD-3-Clause */
/* The threaded sort by cell, for dense and for sparse cells. Read cells_sort.h first. */
#include "index/grids/cells_sort.h"
#include "index/grids/cells.h"

#include "base/memory.h"

#include <omp.h>
#include <stdlib.h>
#include <string.h>

enum { DENSE_BUCKETS = 4096, SPARSE_BUCKETS = 256, SAMPLES_A_BUCKET = 16, INSERTION = 24 };

/* How keys become buckets: by their upper bits (splitters == NULL), or by bisection among splitters. */
struct buckets {
    size_t count;
    unsigned shift;
    const uint64_t *splitters; /* count - 1 of them, ascending */
};

static size_t bucket_of(const struct buckets *buckets, uint64_t key) {
    if (buckets->splitters == NULL) {
        return (size_t)(key >> buckets->shift);
    }
    size_t low = 0, high = buckets->count - 1;
    while (low < high) {
        size_t middle = (low + high) / 2;
        if (buckets->splitters[middle] <= key) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

void cells_scratch_reserve(struct cells_scratch *scratch, size_t count) {
    if (count <= scratch->capacity && scratch->key != NULL) {
        return;
    }
    memory_free(scratch->key);
    memory_free(scratch->bucket_key);
    memory_free(scratch->bucket_particle);
    scratch->key = memory_allocate(count, sizeof(uint64_t), "index keys");
    scratch->bucket_key = NULL;
    scratch->bucket_particle = NULL;
    scratch->capacity = count;
}

void cells_scratch_free(struct cells_scratch *scratch) {
    memory_free(scratch->key);
    memory_free(scratch->bucket_key);
    memory_free(scratch->bucket_particle);
    memory_free(scratch->histogram);
    *scratch = (struct cells_scratch){0};
}

size_t cells_scratch_memory(const struct cells_scratch *scratch) {
    size_t each = sizeof(uint64_t) + (scratch->bucket_key ? sizeof(uint64_t) + sizeof(uint32_t) : 0);
    return scratch->capacity * each + scratch->histogram_capacity * sizeof(size_t);
}

/* Frees the buckets until the next sort, as their memory is large. */
static void free_buckets(struct cells_scratch *scratch) {
    memory_free(scratch->bucket_key);
    memory_free(scratch->bucket_particle);
    scratch->bucket_key = NULL;
    scratch->bucket_particle = NULL;
}

/* Room for the buckets' entries and for a histogram a thread, with one column more for the bucket ends. */
static void reserve_buckets(struct cells_scratch *scratch, const struct buckets *buckets, int threads) {
    if (scratch->bucket_key == NULL) {
        scratch->bucket_key = memory_allocate(scratch->capacity, sizeof(uint64_t), "index keys");
        scratch->bucket_particle = memory_allocate(scratch->capacity, sizeof(uint32_t), "index particles");
    }
    size_t room = (buckets->count + 1) * ((size_t)threads + 1);
    if (room > scratch->histogram_capacity) {
        memory_free(scratch->histogram);
        scratch->histogram = memory_allocate(room, sizeof(size_t), "index histogram");
        scratch->histogram_capacity = room;
    }
}

/* Pass 1: afterwards bucket b has the entries histogram[b] ... histogram[b + 1], in their old order. Called
 * by all threads of a team; histogram row 0 holds the bucket beginnings, row 1 + t is thread t's own. */
static void into_buckets(struct cells_scratch *scratch, const struct buckets *buckets, size_t count,
                         const uint32_t *particle) {
    size_t threads = (size_t)omp_get_num_threads();
    size_t thread = (size_t)omp_get_thread_num();
    size_t begin = count * thread / threads, end = count * (thread + 1) / threads;
    size_t row = buckets->count + 1;
    size_t *mine = scratch->histogram + row * (thread + 1);
    memset(mine, 0, row * sizeof *mine);
    for (size_t k = begin; k < end; k++) {
        mine[bucket_of(buckets, scratch->key[k])]++;
    }
#pragma omp barrier
#pragma omp single
    {
        size_t sum = 0;
        for (size_t b = 0; b < buckets->count; b++) {
            scratch->histogram[b] = sum;
            for (size_t t = 1; t <= threads; t++) {
                size_t entries = scratch->histogram[row * t + b];
                scratch->histogram[row * t + b] = sum;
                sum += entries;
            }
        }
        scratch->histogram[buckets->count] = sum;
    }
    for (size_t k = begin; k < end; k++) {
        size_t to = mine[bucket_of(buckets, scratch->key[k])]++;
        scratch->bucket_key[to] = scratch->key[k];
        scratch->bucket_particle[to] = particle[k];
    }
#pragma omp barrier
}

/* Pass 2, dense: counts directly in the table of cell beginnings; no other bucket has the cells of this
 * bucket. */
static void sort_dense_bucket(const struct cells_scratch *scratch, const size_t entries[2],
                              const size_t range[2], uint32_t *particle, uint32_t *begin) {
    memset(begin + range[0], 0, (range[1] - range[0]) * sizeof *begin);
    for (size_t k = entries[0]; k < entries[1]; k++) {
        begin[scratch->bucket_key[k]]++;
    }
    uint32_t sum = (uint32_t)entries[0];
    for (size_t c = range[0]; c < range[1]; c++) {
        uint32_t inside = begin[c];
        begin[c] = sum;
        sum += inside;
    }
    for (size_t k = entries[0]; k < entries[1]; k++) {
        particle[begin[scratch->bucket_key[k]]++] = scratch->bucket_particle[k];
    }
    for (size_t c = range[1] - 1; c > range[0]; c--) {
        begin[c] = begin[c - 1];
    }
    begin[range[0]] = (uint32_t)entries[0];
}

void cells_sort_dense(struct cells_scratch *scratch, const struct cells_sort_job *job, uint32_t *particle,
                      uint32_t *begin) {
    size_t cells = (size_t)job->cells;
    struct buckets buckets = {0};
    while (cells >> buckets.shift >= DENSE_BUCKETS || (cells >> buckets.shift) > job->count / 8 + 1) {
        buckets.shift++;
    }
    buckets.count = (cells >> buckets.shift) + 1;
    reserve_buckets(scratch, &buckets, job->threads);
#pragma omp parallel num_threads(job->threads) if (job->count > CELLS_THREADED)
    {
        into_buckets(scratch, &buckets, job->count, particle);
#pragma omp for schedule(dynamic, 16)
        for (size_t b = 0; b < buckets.count; b++) {
            size_t range[2] = {b << buckets.shift, (b + 1) << buckets.shift};
            range[1] = range[1] < cells ? range[1] : cells;
            if (range[0] < range[1]) {
                sort_dense_bucket(scratch, scratch->histogram + b, range, particle, begin);
            }
        }
    }
    begin[cells] = (uint32_t)job->count;
    free_buckets(scratch);
}

static void insertion_sort(uint64_t *key, uint32_t *particle, size_t n) {
    for (size_t k = 1; k < n; k++) {
        uint64_t moved_key = key[k];
        uint32_t moved = particle[k];
        size_t to = k;
        for (; to > 0 && key[to - 1] > moved_key; to--) {
            key[to] = key[to - 1];
            particle[to] = particle[to - 1];
        }
        key[to] = moved_key;
        particle[to] = moved;
    }
}

/* Sorts n entries in place, stably, using as many entries of other_key and other. */
static void merge_sort(uint64_t *key, uint32_t *particle, uint64_t *other_key, uint32_t *other, size_t n) {
    if (n <= INSERTION) {
        insertion_sort(key, particle, n);
        return;
    }
    size_t half = n / 2;
    merge_sort(key, particle, other_key, other, half);
    merge_sort(key + half, particle + half, other_key, other, n - half);
    if (key[half - 1] <= key[half]) {
        return;
    }
    memcpy(other_key, key, half * sizeof *key);
    memcpy(other, particle, half * sizeof *particle);
    size_t left = 0, right = half, to = 0;
    while (left < half) {
        bool from_right = right < n && key[right] < other_key[left];
        key[to] = from_right ? key[right] : other_key[left];
        particle[to++] = from_right ? particle[right] : other[left];
        right += from_right;
        left += !from_right;
    }
}

static int compare_keys(const void *a, const void *b) {
    uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

/* Chooses splitters from a regular sample of the keys; returns their number. */
static size_t choose_splitters(const uint64_t *key, size_t count, uint64_t *splitters) {
    size_t wanted = count / 64 + 1 < SPARSE_BUCKETS ? count / 64 + 1 : SPARSE_BUCKETS;
    uint64_t sample[SPARSE_BUCKETS * SAMPLES_A_BUCKET];
    size_t samples = wanted * SAMPLES_A_BUCKET < count ? wanted * SAMPLES_A_BUCKET : count;
    for (size_t s = 0; s < samples; s++) {
        sample[s] = key[count * s / samples];
    }
    qsort(sample, samples, sizeof sample[0], compare_keys);
    for (size_t b = 1; b < wanted; b++) {
        splitters[b - 1] = sample[samples * b / wanted];
    }
    return wanted - 1;
}

void cells_sort_sparse(struct cells_scratch *scratch, const struct cells_sort_job *job, uint32_t *particle) {
    uint64_t splitters[SPARSE_BUCKETS];
    struct buckets buckets = {.splitters = splitters};
    buckets.count = choose_splitters(scratch->key, job->count, splitters) + 1;
    reserve_buckets(scratch, &buckets, job->threads);
#pragma omp parallel num_threads(job->threads) if (job->count > CELLS_THREADED)
    {
        into_buckets(scratch, &buckets, job->count, particle);
#pragma omp for schedule(dynamic)
        for (size_t b = 0; b < buckets.count; b++) {
            size_t at = scratch->histogram[b], n = scratch->histogram[b + 1] - at;
            memcpy(scratch->key + at, scratch->bucket_key + at, n * sizeof(uint64_t));
            memcpy(particle + at, scratch->bucket_particle + at, n * sizeof(uint32_t));
            merge_sort(scratch->key + at, particle + at, scratch->bucket_key + at,
                       scratch->bucket_particle + at, n);
        }
    }
    free_buckets(scratch);
}
