/* SPDX-License-Identifier: BSD-3-Clause */
/* Several mistakes of a scene in one error: a line each, so that people mend a scene in one go. */
#ifndef SCREE_SCENE_MISTAKES_H
#define SCREE_SCENE_MISTAKES_H

#include "base/error.h"

enum { MISTAKES_MAX = 10 };

/* Adds a user's mistake as a further line; the first makes the error. Of more than MISTAKES_MAX lines, or more
 * than the text of an error holds, the last line tells that there are more. Returns false. */
bool mistakes_add(struct error *error, const char *text);

/* True if further mistakes would add nothing, so that nobody need look for them. */
bool mistakes_full(const struct error *error);

#endif
