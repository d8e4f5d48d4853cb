/* SPDX-License-Identifier: BSD-3-Clause */
/* The forms in which a user gives a sieve curve or a list of sizes: radii or diameters, parts or per cent, in
 * the scene or in a file. All of them become radii and parts. */
#ifndef SCREE_SCENE_SIZES_FILE_H
#define SCREE_SCENE_SIZES_FILE_H

#include "data/scene/sizes.h"

/* Brings TABLE and DISCRETE laws to `radii` and `share` in parts, whatever form was given, and clears the other
 * forms (diameters, file); other laws stay untouched. A file has one line for each size: the size, a diameter
 * unless its first line reads "radius passing" (or "radius weight"), and what passes, or the weight. Lengths
 * of the file are multiplied by `file_unit`. Passing that ends with 100 counts per cent. Fails (user) if not
 * exactly one form is given, with a text that names no place, or on a file that cannot be read, with its name
 * and line: *in_file then is true. */
bool sizes_file_complete(struct sizes_options *options, bool *in_file, struct error *error);

#endif
