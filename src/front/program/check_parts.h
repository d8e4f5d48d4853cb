/* SPDX-License-Identifier: BSD-3-Clause */
/* Parts of what `scree check` prints: the terms and fields that a scene needs. */
#ifndef SCREE_PROGRAM_CHECK_PARTS_H
#define SCREE_PROGRAM_CHECK_PARTS_H

struct simulation;

#include <stdbool.h>

/* Prints the terms of the contact law that the scene brings, each with what brought it. The terms that it leaves out
 * are named in one line; with `all` each has the setting that would bring it. One thread. */
void check_parts_terms(const struct simulation *s, bool all);

/* Prints the fields of a particle with bytes and reason, and those that are not needed. One thread. */
void check_parts_fields(const struct simulation *s);

/* Prints the bytes that are stored of a particle and of a pair that touches. One thread. */
void check_parts_bytes(const struct simulation *s);

/* Prints the bytes of a particle in each kind of message; nothing on one rank. One thread. */
void check_parts_wire(const struct simulation *s);

#endif
