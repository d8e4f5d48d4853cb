/* SPDX-License-Identifier: BSD-3-Clause */
/* A text file as a whole, packed by gzip or not. */
#ifndef SCREE_SCENE_SCENE_TEXT_H
#define SCREE_SCENE_SCENE_TEXT_H

#include "base/error.h"
#include <stdbool.h>
#include <stddef.h>

/* Reads a whole text file into memory (memory_free), ended by a zero byte; `length` may be NULL. Fails (user)
 * where it cannot be read. */
bool scene_read_text(const char *path, char **text, size_t *length, struct error *error);

#endif
