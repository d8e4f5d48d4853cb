/* SPDX-License-Identifier: BSD-3-Clause */
/* Reads KEY=VALUE by the tables of laws.c, and derives the values that are not given. Read options.h
 * first. */
#include "pack/options_read.h"

#include "pack/laws.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SETTING_MAX = 256 };

static bool set_name(void *to, const struct law_key *key, const char *text, struct error *error) {
    for (int k = 0; key->names[k]; k++)
        if (strcmp(key->names[k], text) == 0) {
            *(int *)to = k; /* enums of these options are ints */
            return true;
        }
    return error_set(error, ERROR_USER, "command line: %s=%s: allowed are %s and %s", key->name, text,
                     key->names[0], key->names[1]);
}

static bool set_value(struct pack_options *options, const struct law_key *key, const char *text,
                      struct error *error) {
    void *to = (char *)options + key->offset;
    if (key->type == LAW_NAME)
        return set_name(to, key, text, error);
    if (key->type == LAW_TEXT) {
        *(const char **)to = text;
        return *text || error_set(error, ERROR_USER, "command line: %s= needs a value", key->name);
    }
    char *end;
    double value = strtod(text, &end);
    if (end == text || *end || !isfinite(value))
        return error_set(error, ERROR_USER, "command line: %s=%s: is not a number", key->name, text);
    if (key->type == LAW_WHOLE && value != floor(value))
        return error_set(error, ERROR_USER, "command line: %s=%s: must be a whole number", key->name, text);
    if (value < key->least || value > key->most)
        return error_set(error, ERROR_USER, "command line: %s=%s: must lie in %g ... %g", key->name, text,
                         key->least, key->most);
    *(double *)to = value;
    return true;
}

/* One KEY=VALUE. Box and fraction replace each other. */
static bool set_key(struct pack_options *options, const struct laws_row *law, const char *text,
                    struct error *error) {
    size_t length = strcspn(text, "=");
    if (text[length] != '=')
        return error_set(error, ERROR_USER, "command line: '%s' must read KEY=VALUE", text);
    for (int k = 0; laws_key(k); k++) {
        const struct law_key *key = laws_key(k);
        if (strlen(key->name) != length || strncmp(key->name, text, length) != 0 ||
            !laws_has(law, text, length))
            continue;
        if (strcmp(key->name, "box") == 0)
            options->fraction = 0;
        if (strcmp(key->name, "fraction") == 0)
            options->box = 0;
        return set_value(options, key, text + length + 1, error);
    }
    return error_set(error, ERROR_USER,
                     "command line: '%.*s' is no key of the law %s; 'scree help pack %s' lists its keys",
                     (int)length, text, law->name, law->name);
}

/* Reads the words of a list of defaults. The lists are part of the program, so no word fails. */
static void set_defaults(struct pack_options *options, const struct laws_row *law, const char *list,
                         struct error *error) {
    char word[SETTING_MAX];
    for (const char *at = list; *at; at += *at == ' ') {
        size_t length = strcspn(at, " ");
        snprintf(word, sizeof word, "%.*s", (int)length, at);
        set_key(options, law, word, error);
        at += length;
    }
}

/* A published system. */
struct published {
    double ratio, box, large, small; /* small: all, where there is one kind */
};

static const struct published *published_find(const struct published *systems, int n, double ratio) {
    for (int k = 0; k < n; k++)
        if (systems[k].ratio == ratio)
            return &systems[k];
    return NULL;
}

/* Stratford, Shire and Hanley, Table 1. */
static bool finish_bidisperse(struct pack_options *o, struct error *error) {
    static const struct published systems[] = {{10, 205.9, 250, 711657},
                                               {20, 314.15, 111, 2337678},
                                               {40, 500.14, 56, 9624306},
                                               {80, 793.92, 28, 42900051},
                                               {100, 955.61, 25, 66193461}};
    const struct published *system = published_find(systems, 5, o->ratio);
    bool own = o->box > 0 || o->large > 0 || o->small > 0;
    if (!own && !system)
        return error_set(
            error, ERROR_USER,
            "command line: ratio=%g is not in the published table (10, 20, 40, 80, 100): give box, large "
            "and small, or box and numbers=recipe",
            o->ratio);
    if (!own) {
        o->box = system->box;
        o->large = system->large;
        o->small = system->small;
    }
    if (o->box <= 0)
        return error_set(error, ERROR_USER, "command line: large and small need a box");
    if (o->numbers == PACK_RECIPE)
        o->large = own && o->large > 0 ? o->large : rint(0.12 * pow(o->box / o->ratio, 3) * 0.75 / M_PI);
    else if (o->small <= 0)
        return error_set(error, ERROR_USER, "command line: a box needs small (and large), or numbers=recipe");
    return true;
}

/* Count and box of the published system, or, for another count, a box with as many particles per volume. */
static bool finish_published(struct pack_options *o, const struct published *system, struct error *error) {
    if (o->count == 0 && system)
        o->count = system->small;
    if (o->count == 0)
        return error_set(error, ERROR_USER,
                         "command line: ratio=%g is not a published system: give count, and box or "
                         "fraction",
                         o->ratio);
    if (o->box == 0 && o->fraction == 0 && system)
        o->box = system->box * cbrt(o->count / system->small);
    return o->box > 0 || o->fraction > 0 ||
           error_set(error, ERROR_USER,
                     "command line: ratio=%g is not a published system: give box or fraction", o->ratio);
}

static bool finish(struct pack_options *o, struct error *error) {
    static const struct published sand[] = {
        {10, 205.9, 0, 712333}, {20, 506, 0, 2336380}, {40, 1475, 0, 9591137}};
    static const struct published exponential[] = {{50, 368.77, 0, 5040560}};
    switch (o->law) {
    case PACK_BIDISPERSE:
        return finish_bidisperse(o, error);
    case PACK_SAND:
        return finish_published(o, published_find(sand, 3, o->ratio), error);
    case PACK_EXPONENTIAL:
        return finish_published(o, published_find(exponential, 1, o->ratio), error);
    case PACK_POWER:
        return (o->max > o->min && o->max <= 1000 * o->min) ||
               error_set(error, ERROR_USER,
                         "command line: max=%g must be above min=%g, at most 1000 times as large", o->max,
                         o->min);
    case PACK_SIEVE:
    case PACK_DISCRETE:
        return o->table || o->radii || o->diameters ||
               error_set(error, ERROR_USER,
                         "command line: the law %s needs table=FILE, or diameters= and %s=",
                         pack_law_name(o->law), o->law == PACK_SIEVE ? "passing" : "weights");
    default:
        return true;
    }
}

bool pack_options_read(struct pack_options *options, const char *law, const char *const *setting,
                       int settings, struct error *error) {
    int l = 0;
    while (laws_get(l) && strcmp(laws_get(l)->name, law) != 0)
        l++;
    if (!laws_get(l))
        return error_set(
            error, ERROR_USER,
            "command line: '%s' is no law of sizes; known are bidisperse, univol, sand, exponential, power, "
            "sieve, discrete",
            law);
    *options = (struct pack_options){.law = (enum pack_law)l};
    set_defaults(options, laws_get(l), laws_common(), error);
    set_defaults(options, laws_get(l), laws_get(l)->defaults, error);
    bool box = false, fraction = false;
    for (int k = 0; k < settings; k++) {
        if (!set_key(options, laws_get(l), setting[k], error))
            return false;
        box = box || strncmp(setting[k], "box=", 4) == 0;
        fraction = fraction || strncmp(setting[k], "fraction=", 9) == 0;
    }
    if (box && fraction)
        return error_set(error, ERROR_USER, "command line: box and fraction exclude each other");
    return finish(options, error);
}
