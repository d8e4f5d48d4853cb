/* SPDX-License-Identifier: BSD-3-Clause */
/* The system gives a block; the caller sees the array inside it:
 *
 *   block ... header | array (count * size bytes) | padding of at least one cache line ... end of block
 *
 * The header, one cache line, ends where the array begins and knows the block. Small blocks begin on a cache
 * line and the array right after the header. Large blocks begin on a huge page, and the system is asked to
 * back large blocks with huge pages. Arrays in large blocks begin at different offsets: arrays that all began
 * at the same place of a page would compete for the same few cache lines when a loop runs over many arrays.
 *
 * Large blocks that are freed are kept for a while (cache_*), and given out again to arrays of about the same
 * size: a rebuild frees and allocates the same arrays each time, and fresh pages cost more time than the work
 * on the arrays. The bytes kept are bounded by a part of the bytes in use, and count in the peak.
 */
#include "base/memory.h"

#include "base/error.h"

#include <assert.h>
#include <malloc.h>
#include <omp.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>

enum { PAGE_HUGE = 2 << 20, LARGE = 4 << 20, OFFSETS = 32, OFFSET_STEP = 2 * MEMORY_ALIGNMENT };

struct header {
    void *block;
    size_t held; /* bytes of the block */
    size_t room; /* bytes of the array, padding not counted */
    uint64_t mark;
};

static const uint64_t HEADER_MARK = 0x7363726565617272u;

static _Atomic size_t bytes_in_use;
static _Atomic size_t bytes_kept; /* bytes freed, but not given back to the system */
static _Atomic size_t bytes_peak;
static _Atomic unsigned large_arrays;

static struct header *header_of(void *array) {
    struct header *header = (struct header *)((char *)array - MEMORY_ALIGNMENT);
    assert(header->mark == HEADER_MARK);
    return header;
}

static void count_bytes(size_t held) {
    size_t now = atomic_fetch_add(&bytes_in_use, held) + held + atomic_load(&bytes_kept);
    size_t peak = atomic_load(&bytes_peak);
    while (now > peak && !atomic_compare_exchange_weak(&bytes_peak, &peak, now)) {
    }
}

static size_t round_up(size_t bytes, size_t unit) {
    return (bytes + unit - 1) / unit * unit;
}

/* Freed large blocks, newest last. One thread at a time uses this list. */
enum { CACHE_BLOCKS = 12, CACHE_SHARE = 16 };

static struct {
    int count;
    struct {
        void *block;
        size_t held;
    } entry[CACHE_BLOCKS];
} cache;

static void cache_drop(int k) {
    atomic_fetch_sub(&bytes_kept, cache.entry[k].held);
    cache.count--;
    memmove(&cache.entry[k], &cache.entry[k + 1], (size_t)(cache.count - k) * sizeof cache.entry[0]);
}

/* A kept block of at least `held` bytes and not much more, or NULL; `held` becomes the size of the block. */
static void *cache_take(size_t *held) {
    void *block = NULL;
#pragma omp critical(memory_cache)
    {
        int best = -1;
        for (int k = 0; k < cache.count; k++) {
            bool fits = cache.entry[k].held >= *held && cache.entry[k].held <= *held + *held / 4;
            if (fits && (best < 0 || cache.entry[k].held < cache.entry[best].held)) {
                best = k;
            }
        }
        if (best >= 0) {
            block = cache.entry[best].block;
            *held = cache.entry[best].held;
            cache_drop(best);
        }
    }
    return block;
}

/* Keeps a large block, and releases the oldest ones above the bound. */
static void cache_put(void *block, size_t held) {
#pragma omp critical(memory_cache)
    {
        size_t bound = atomic_load(&bytes_in_use) / CACHE_SHARE;
        while (cache.count > 0 && (cache.count == CACHE_BLOCKS || atomic_load(&bytes_kept) + held > bound)) {
            free(cache.entry[0].block);
            cache_drop(0);
        }
        if (held > bound) {
            free(block);
        } else {
            cache.entry[cache.count].block = block;
            cache.entry[cache.count++].held = held;
            atomic_fetch_add(&bytes_kept, held);
        }
    }
}

void *memory_allocate(size_t count, size_t size, const char *what) {
    static_assert(sizeof(struct header) <= MEMORY_ALIGNMENT, "the header fits into its cache line");
    size_t bytes;
    if (__builtin_mul_overflow(count, size, &bytes) || bytes > SIZE_MAX / 4) {
        error_fatal("out of memory: %s needs %zu times %zu bytes", what, count, size);
    }
    size_t offset = MEMORY_ALIGNMENT;
    size_t alignment = MEMORY_ALIGNMENT;
    if (bytes >= LARGE) {
        alignment = PAGE_HUGE;
        offset += (size_t)(atomic_fetch_add(&large_arrays, 1) % OFFSETS) * OFFSET_STEP;
    }
    size_t held = round_up(offset + bytes + MEMORY_ALIGNMENT, MEMORY_ALIGNMENT);
    void *block = bytes >= LARGE ? cache_take(&held) : NULL;
    bool fresh = block == NULL;
    if (fresh && posix_memalign(&block, alignment, held) != 0) {
        error_fatal("out of memory: %zu bytes for %s (%zu bytes are held already)", bytes, what,
                    memory_in_use());
    }
    if (fresh && bytes >= LARGE) {
        madvise(block, held, MADV_HUGEPAGE); /* optional: huge pages only save time */
    }
    char *array = (char *)block + offset;
    struct header *header = (struct header *)(array - MEMORY_ALIGNMENT);
    *header = (struct header){.block = block, .held = held, .room = bytes, .mark = HEADER_MARK};
    count_bytes(held);
    return array;
}

/* Copies `copied` bytes from `source` and sets the rest, up to `bytes`, to zero. All threads fill a large
 * array, each thread its own part, so that pages lie near the thread that later works on that part. */
static void fill(char *array, const char *source, size_t copied, size_t bytes) {
#pragma omp parallel if (bytes >= LARGE)
    {
        size_t threads = (size_t)omp_get_num_threads();
        size_t part = round_up(bytes / threads + 1, MEMORY_ALIGNMENT);
        size_t begin = part * (size_t)omp_get_thread_num();
        size_t end = begin + part < bytes ? begin + part : bytes;
        size_t middle = copied < end ? copied : end;
        if (begin < middle) {
            memcpy(array + begin, source + begin, middle - begin);
        } else {
            middle = begin;
        }
        if (middle < end) {
            memset(array + middle, 0, end - middle);
        }
    }
}

void *memory_allocate_zero(size_t count, size_t size, const char *what) {
    char *array = memory_allocate(count, size, what);
    fill(array, NULL, 0, count * size + MEMORY_ALIGNMENT);
    return array;
}

void *memory_resize(void *array, size_t count, size_t size, const char *what) {
    if (array == NULL) {
        return memory_allocate(count, size, what);
    }
    struct header *header = header_of(array);
    size_t bytes;
    bool fits = !__builtin_mul_overflow(count, size, &bytes) && bytes <= header->room;
    if (fits && bytes >= header->room / 2) {
        return array;
    }
    char *other = memory_allocate(count, size, what);
    size_t kept = fits ? bytes : header->room;
    fill(other, array, kept, kept);
    memory_free(array);
    return other;
}

void memory_free(void *array) {
    if (array == NULL) {
        return;
    }
    struct header *header = header_of(array);
    header->mark = 0;
    atomic_fetch_sub(&bytes_in_use, header->held);
    if (header->room >= LARGE) {
        cache_put(header->block, header->held);
    } else {
        free(header->block);
    }
}

void memory_trim(void) {
#pragma omp critical(memory_cache)
    while (cache.count > 0) {
        free(cache.entry[0].block);
        cache_drop(0);
    }
    malloc_trim(0);
}

size_t memory_in_use(void) {
    return atomic_load(&bytes_in_use);
}

size_t memory_peak(void) {
    return atomic_load(&bytes_peak);
}

void memory_peak_reset(void) {
    atomic_store(&bytes_peak, atomic_load(&bytes_in_use));
}

/* The number behind `name` in a file of the system, or the first one if the name is empty, times `unit`; SIZE_MAX where there is
 * none. */
static size_t system_number(const char *path, const char *name, size_t unit) {
    FILE *file = fopen(path, "r");
    size_t number = SIZE_MAX, length = strlen(name);
    char line[256];
    while (file && number == SIZE_MAX && fgets(line, sizeof line, file) != NULL)
        if (strncmp(line, name, length) == 0 && sscanf(line + length, "%zu", &number) == 1)
            number *= unit;
    if (file)
        fclose(file);
    return number;
}

/* Reads VmHWM, not getrusage: getrusage also counts the memory of the process before exec. */
size_t memory_peak_resident(void) {
    size_t bytes = system_number("/proc/self/status", "VmHWM:", 1024);
    return bytes == SIZE_MAX ? 0 : bytes;
}

static size_t smaller_room(size_t room, size_t most, size_t used) {
    size_t left = most == SIZE_MAX || used == SIZE_MAX ? SIZE_MAX : most > used ? most - used : 0;
    return left < room ? left : room;
}

/* What the control group uses and the system cannot take back: without files that it keeps in memory. */
static size_t group_used(void) {
    size_t used = system_number("/sys/fs/cgroup/memory.current", "", 1);
    static const char *const kept[] = {"active_file ", "inactive_file "};
    for (int k = 0; k < 2 && used != SIZE_MAX; k++) {
        size_t bytes = system_number("/sys/fs/cgroup/memory.stat", kept[k], 1);
        used -= bytes == SIZE_MAX ? 0 : bytes < used ? bytes : used;
    }
    return used;
}

size_t memory_room(void) {
    struct rlimit limit;
    size_t room = system_number("/proc/meminfo", "MemAvailable:", 1024);
    room = smaller_room(room, system_number("/sys/fs/cgroup/memory.max", "", 1), group_used());
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
        room = smaller_room(room, limit.rlim_cur, system_number("/proc/self/status", "VmSize:", 1024));
    return room;
}
