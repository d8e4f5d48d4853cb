/* SPDX-License-Identifier: BSD-3-Clause */
/* Aligned, counted memory. Every large array of the program comes from here, so that the report can state
 * bytes per particle, and so that arrays are aligned to cache lines. */
#ifndef SCREE_BASE_MEMORY_H
#define SCREE_BASE_MEMORY_H

#include <stddef.h>
#include <stdint.h>

enum { MEMORY_ALIGNMENT = 64 };

/* Returns `count * size` bytes, aligned to MEMORY_ALIGNMENT and padded at the end by one more cache line that
 * may be read and written (vector loops run over the end). Contents undefined. `what` names the array in the
 * message if memory runs out (which ends the program). count = 0 gives a valid pointer. Any thread. Free with
 * memory_free. */
void *memory_allocate(size_t count, size_t size, const char *what);

/* As memory_allocate, filled with zeros. */
void *memory_allocate_zero(size_t count, size_t size, const char *what);

/* Grows or shrinks an array of this interface (or NULL) to `count * size` bytes. The contents are kept up to
 * the smaller of both sizes. Returns the new array; the old pointer must not be used any more. */
void *memory_resize(void *array, size_t count, size_t size, const char *what);

/* Frees an array of this interface; NULL is allowed. */
void memory_free(void *array);

/* Gives all freed memory that is kept for later arrays back to the system. One thread. */
void memory_trim(void);

/* Bytes now held through this interface on this process, and the largest value so far. */
size_t memory_in_use(void);
size_t memory_peak(void);

/* Sets the largest value to the bytes held now. */
void memory_peak_reset(void);

/* Bytes that the process can still get, by the machine's free memory, the limit of its control group and the limit of its
 * address space (ulimit -v); SIZE_MAX where nothing is known. Ranks on one machine share the free memory. */
size_t memory_room(void);

/* The peak resident set of the process in bytes, as the operating system counts it (0 where unknown). */
size_t memory_peak_resident(void);

#endif
