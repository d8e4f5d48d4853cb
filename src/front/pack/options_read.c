/* SPDX-License-Identifier: BSD-3-Clause */
/* Reads KEY=VALUE by the tables of laws.c, and derives the values that are not given. Read options.h
 * first. */
#include "front/pack/options_read.h"

#include "front/pack/laws.h"

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
    char allowed[SETTING_MAX] = "";
    for (int k = 0; key->names[k]; k++)
        snprintf(allowed + strlen(allowed), sizeof allowed - strlen(allowed), "%s%s", k ? ", " : "",
                 key->names[k]);
    return error_set(error, ERROR_USER, "command line: %s=%s: allowed are %s", key->name, text, allowed);
}

static bool set_edges(double *edge, const struct law_key *key, const char *text, struct error *error) {
    const char *at = text;
    for (int c = 0; c < 3; c++) {
        char *end;
        edge[c] = strtod(at, &end);
        if (end == at || *end != (c < 2 ? ',' : '\0') || !(edge[c] >= key->least && edge[c] <= key->most))
            return error_set(error, ERROR_USER,
                             "command line: %s=%s: must be three lengths in %g ... %g, as in 10,10,30",
                             key->name, text, key->least, key->most);
        at = end + 1;
    }
    return true;
}

static bool set_value(struct pack_options *options, const struct law_key *key, const char *text,
                      struct error *error) {
    void *to = (char *)options + key->offset;
    if (key->type == LAW_NAME)
        return set_name(to, key, text, error);
    if (key->type == LAW_EDGES)
        return set_edges(to, key, text, error);
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

/* One KEY=VALUE. */
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
        return set_value(options, key, text + length + 1, error);
    }
    return error_set(error, ERROR_USER,
                     "command line: '%.*s' is no key of the law %s; 'scree help pack %s' lists its keys",
                     (int)length, text, law->name, law->name);
}

/* Reads the words of a list of defaults, KEY=VALUE or KEY. The lists are part of the program, so no word fails. */
static void set_defaults(struct pack_options *options, const struct laws_row *law, const char *list,
                         struct error *error) {
    char word[SETTING_MAX];
    for (const char *at = list; *at; at += *at == ' ') {
        size_t length = strcspn(at, " ");
        snprintf(word, sizeof word, "%.*s", (int)length, at);
        if (strchr(word, '='))
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

/* The keys that a container has, and how many of them it needs. */
static const struct {
    const char *name, *keys[2];
    int needed;
} shapes[] = {[PACK_CUBE] = {"cube", {"box"}, 0},
              [PACK_BOX] = {"box", {"edges"}, 1},
              [PACK_CYLINDER] = {"cylinder", {"radius", "length"}, 2},
              [PACK_SPHERE] = {"sphere", {"radius"}, 1},
              [PACK_MESH] = {"mesh", {"file", "scaled"}, 1}};
static const char *const shape_keys[] = {"box", "edges", "radius", "length", "file", "scaled"};

/* What the command line gives. */
struct given {
    const char *const *setting;
    int settings;
};

static bool is_given(const struct given *given, const char *key) {
    size_t length = strlen(key);
    for (int k = 0; k < given->settings; k++)
        if (strncmp(given->setting[k], key, length) == 0 && given->setting[k][length] == '=')
            return true;
    return false;
}

/* The keys of the container are given, and no others. */
static bool check_shape(const struct pack_options *o, const struct given *given, struct error *error) {
    const char *const *keys = shapes[o->shape].keys, *name = shapes[o->shape].name;
    for (size_t k = 0; k < sizeof shape_keys / sizeof shape_keys[0]; k++) {
        bool fits = strcmp(shape_keys[k], keys[0]) == 0 || (keys[1] && strcmp(shape_keys[k], keys[1]) == 0);
        if (!fits && is_given(given, shape_keys[k]))
            return error_set(error, ERROR_USER,
                             "command line: %s= does not go with shape=%s, which has %s%s%s", shape_keys[k],
                             name, keys[0], keys[1] ? " and " : "", keys[1] ? keys[1] : "");
    }
    for (int k = 0; k < shapes[o->shape].needed; k++)
        if (!is_given(given, keys[k]))
            return error_set(error, ERROR_USER, "command line: shape=%s needs %s=%s%s%s", name, keys[0],
                             shapes[o->shape].needed > 1 ? " and " : "",
                             shapes[o->shape].needed > 1 ? keys[1] : "",
                             shapes[o->shape].needed > 1 ? "=" : "");
    return o->shape <= PACK_BOX || o->walls == PACK_HARD || !is_given(given, "walls") ||
           error_set(error, ERROR_USER, "command line: walls=periodic goes with shape=cube and shape=box");
}

/* Spheres settle between walls. */
static bool check_settle(struct pack_options *o, const struct given *given, struct error *error) {
    if (o->settle == PACK_FLOATING)
        return !is_given(given, "friction") ||
               error_set(error, ERROR_USER, "command line: friction= goes with settle=yes");
    if (is_given(given, "walls") && o->walls == PACK_PERIODIC)
        return error_set(
            error, ERROR_USER,
            "command line: settle=yes needs walls that spheres rest on, and walls=periodic has none");
    o->walls = PACK_HARD;
    return true;
}

/* Of size, count and fraction two decide the third. */
static bool finish_shape(struct pack_options *o, const struct given *given, struct error *error) {
    bool count = is_given(given, "count"), fraction = is_given(given, "fraction");
    bool box = is_given(given, "box");
    const char *name = shapes[o->shape].name;
    if (!check_shape(o, given, error) || !check_settle(o, given, error))
        return false;
    if (o->shape > PACK_BOX)
        o->walls = PACK_HARD;
    if (o->shape == PACK_CUBE && !(box && fraction)) {
        o->fraction = box ? 0 : o->fraction;
        return true;
    }
    if (count && fraction)
        return error_set(error, ERROR_USER,
                         "command line: of count, fraction and the size of the %s two decide the third; here "
                         "all are given",
                         name);
    o->fraction = count ? 0 : o->fraction;
    o->count = count ? o->count : 0;
    return count || o->fraction > 0 ||
           error_set(error, ERROR_USER, "command line: shape=%s needs fraction= or count=", name);
}

static bool finish(struct pack_options *o, struct error *error) {
    static const struct published sand[] = {
        {10, 205.9, 0, 712333}, {20, 506, 0, 2336380}, {40, 1475, 0, 9591137}};
    static const struct published exponential[] = {{50, 368.77, 0, 5040560}};
    bool sized = o->shape != PACK_CUBE || (o->box > 0 && o->fraction > 0);
    switch (o->law) {
    case PACK_BIDISPERSE:
        return finish_bidisperse(o, error);
    case PACK_SAND:
        return sized || finish_published(o, published_find(sand, 3, o->ratio), error);
    case PACK_EXPONENTIAL:
        return sized || finish_published(o, published_find(exponential, 1, o->ratio), error);
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
    if (!laws_get(l)->cube_only)
        set_defaults(options, laws_get(l), laws_container(), error);
    set_defaults(options, laws_get(l), laws_get(l)->defaults, error);
    for (int k = 0; k < settings; k++)
        if (!set_key(options, laws_get(l), setting[k], error))
            return false;
    struct given given = {setting, settings};
    return finish_shape(options, &given, error) && finish(options, error);
}
