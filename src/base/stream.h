/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes that bypass the caches, for arrays so large that the caches would drop the data before a thread
 * reads them. A plain write of a cache line fetches the line first, which is a third of the traffic of a
 * copy. On CPUs without such instructions the functions write plainly. */
#ifndef SCREE_BASE_STREAM_H
#define SCREE_BASE_STREAM_H

#include <stddef.h>
#include <string.h>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

/* Arrays of more bytes than this gain from such writes. */
enum { STREAM_BYTES = 16 << 20 };

/* Copies `bytes`, or (`from` NULL) writes zeros. `to` is aligned to 16 bytes. Any thread. Another thread
 * reads the result only after the writer's stream_end. */
static inline __attribute__((always_inline)) void stream_copy(void *to, const void *from, size_t bytes) {
    size_t k = 0;
#ifdef __SSE2__
    for (; k + 16 <= bytes; k += 16) {
        __m128i line = from ? _mm_loadu_si128((const __m128i *)(const void *)((const char *)from + k))
                            : _mm_setzero_si128();
        _mm_stream_si128((__m128i *)(void *)((char *)to + k), line);
    }
#endif
    if (from)
        memcpy((char *)to + k, (const char *)from + k, bytes - k);
    else
        memset((char *)to + k, 0, bytes - k);
}

/* Ends the writes of this thread: every thread that synchronises with this one from now on sees the data. */
static inline void stream_end(void) {
#ifdef __SSE2__
    _mm_sfence();
#endif
}

#endif
