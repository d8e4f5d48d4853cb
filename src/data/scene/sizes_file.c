/* SPDX-License-Identifier: BSD-3-Clause */
/* Sizes in any form become radii and parts of 1. Read sizes_file.h first. */
#include "data/scene/sizes_file.h"

#include "base/lines.h"

#include <string.h>

/* The first line may name the columns. */
static bool read_header(struct lines *lines, bool discrete, bool *radii, struct error *error) {
    char *word[2];
    const char *share = discrete ? "weight" : "passing";
    bool good = lines_words(lines, word, 2) == 2 && strcmp(word[1], share) == 0 &&
                (strcmp(word[0], "radius") == 0 || strcmp(word[0], "diameter") == 0);
    if (!good)
        return lines_refuse(lines, error,
                            "must hold two numbers, a sieve's opening and what passes, or name the columns: "
                            "'diameter %s' or 'radius %s'",
                            share, share);
    *radii = strcmp(word[0], "radius") == 0;
    return true;
}

static bool read_row(struct sizes_options *sizes, struct lines *lines, double factor, struct error *error) {
    double value[3];
    if (lines_numbers(lines, value, 3) != 2)
        return lines_refuse(lines, error, "must hold two numbers: a sieve's opening and what passes");
    if (!(value[0] > 0))
        return lines_refuse(lines, error, "a sieve's opening must be positive");
    if (!(value[1] >= 0))
        return lines_refuse(lines, error, "what passes, or a weight, must not be negative");
    if (sizes->points == SIZES_POINTS_MAX)
        return lines_refuse(lines, error, "is one sieve too many: %d are allowed", SIZES_POINTS_MAX);
    sizes->radii[sizes->points] = value[0] * factor;
    sizes->share[sizes->points++] = value[1];
    return true;
}

static bool read_file(struct sizes_options *sizes, struct error *error) {
    struct lines lines;
    double unused[3];
    bool good = true, first = true, radii = false;
    if (!lines_open(&lines, sizes->file, error))
        return false;
    for (; good && lines_next_filled(&lines); first = false) {
        if (first && lines_numbers(&lines, unused, 3) < 0)
            good = read_header(&lines, sizes->law == SIZES_DISCRETE, &radii, error);
        else
            good = read_row(sizes, &lines, radii ? sizes->file_unit : sizes->file_unit / 2, error);
    }
    if (good && lines.damaged)
        good = lines_refuse(&lines, error, "the file does not end here");
    lines_close(&lines);
    sizes->values = sizes->points;
    return good;
}

/* True if the sizes of a sieve curve increase. */
static bool sizes_rise(const char *what, const double *size, int count, struct error *error) {
    for (int k = 1; k < count; k++)
        if (!(size[k] > size[k - 1]))
            return error_set(
                error, ERROR_USER,
                "%s must increase: %g comes after %g; begin with the finest sieve, through which nothing "
                "passes (passing: 0)",
                what, size[k], size[k - 1]);
    return true;
}

bool sizes_file_complete(struct sizes_options *o, bool *in_file, struct error *error) {
    bool discrete = o->law == SIZES_DISCRETE;
    const char *share = discrete ? "weights" : "passing";
    *in_file = false;
    if (o->law != SIZES_TABLE && !discrete)
        return true;
    if ((o->points > 0) + (o->diameters > 0) + (o->file[0] != '\0') != 1)
        return error_set(error, ERROR_USER, "give one of radii, diameters and file");
    if (o->file[0] && o->values > 0)
        return error_set(error, ERROR_USER, "%s beside file: the file has both columns", share);
    if (!o->file[0] && o->values == 0)
        return error_set(error, ERROR_USER, "%s is missing beside %s", share,
                         o->points > 0 ? "radii" : "diameters");
    if (o->file[0] && !read_file(o, error)) {
        *in_file = true;
        return false;
    }
    if (!discrete && !o->file[0] &&
        !(sizes_rise("radii", o->radii, o->points, error) &&
          sizes_rise("diameters", o->diameter, o->diameters, error)))
        return false;
    for (int k = 0; k < o->diameters; k++)
        o->radii[k] = o->diameter[k] / 2;
    o->points = o->diameters > 0 ? o->diameters : o->points;
    for (int k = 0; k < SIZES_POINTS_MAX; k++)
        o->diameter[k] = 0;
    memset(o->file, 0, sizeof o->file);
    o->diameters = 0;
    o->file_unit = 1;
    bool percent = !discrete && o->values > 0 && o->share[o->values - 1] == 100;
    for (int k = 0; percent && k < o->values; k++)
        o->share[k] /= 100;
    return true;
}
