#include "pack/options.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

enum { SETTING_MAX = 256 };

enum key_type { KEY_REAL, KEY_WHOLE, KEY_TEXT, KEY_NAME };

struct key {
    const char *name;
    enum key_type type;
    size_t offset;
    double least, most;
    const char *const *names; /* NAME: what the enum's values are called */
    const char *help;
};

static const char *const by_names[] = {"number", "mass", NULL};
static const char *const wall_names[] = {"periodic", "hard", NULL};
static const char *const number_names[] = {"table", "recipe", NULL};

#define AT(member) .offset = offsetof(struct pack_options, member)

static const struct key keys[] = {
    {.name = "ratio",
     .type = KEY_REAL,
     AT(ratio),
     .least = 1.001,
     .most = 1000,
     .help = "largest radius over smallest"},
    {.name = "numbers",
     .type = KEY_NAME,
     AT(numbers),
     .names = number_names,
     .help =
         "table: the published numbers, to the particle; recipe: what solid fractions of 0.12 and 0.36 give"},
    {.name = "count", .type = KEY_WHOLE, AT(count), .least = 1, .most = 1e8, .help = "particles"},
    {.name = "large", .type = KEY_WHOLE, AT(large), .least = 0, .most = 1e8, .help = "large particles"},
    {.name = "small",
     .type = KEY_WHOLE,
     AT(small),
     .least = 1,
     .most = 1e8,
     .help = "small particles that stay"},
    {.name = "box", .type = KEY_REAL, AT(box), .least = 1e-9, .most = 1e9, .help = "edge of the cube"},
    {.name = "fraction",
     .type = KEY_REAL,
     AT(fraction),
     .least = 1e-6,
     .most = 0.9,
     .help = "part of the cube that is solid; gives the edge"},
    {.name = "walls", .type = KEY_NAME, AT(walls), .names = wall_names, .help = "all six sides of the cube"},
    {.name = "broad",
     .type = KEY_REAL,
     AT(broad),
     .least = 0,
     .most = 1,
     .help = "part of the particles, by number, that is in the broad peak"},
    {.name = "scale",
     .type = KEY_REAL,
     AT(scale),
     .least = 0.01,
     .most = 1e6,
     .help = "diameter over which the density falls by a factor e"},
    {.name = "exponent",
     .type = KEY_REAL,
     AT(exponent),
     .least = -20,
     .most = 20,
     .help = "number density of the radii r is r^exponent"},
    {.name = "min", .type = KEY_REAL, AT(min), .least = 1e-9, .most = 1e9, .help = "smallest radius"},
    {.name = "max", .type = KEY_REAL, AT(max), .least = 1e-9, .most = 1e9, .help = "largest radius"},
    {.name = "by", .type = KEY_NAME, AT(by), .names = by_names, .help = "what the law counts"},
    {.name = "table",
     .type = KEY_TEXT,
     AT(table),
     .help =
         "file of the sieve curve: a line a sieve, its opening (a diameter) and what passes, as a part or in "
         "percent"},
    {.name = "gap",
     .type = KEY_REAL,
     AT(gap),
     .least = 1e-6,
     .most = 0.1,
     .help = "distance that neighbours are moved apart to, as part of the sum of their radii"},
    {.name = "overlap",
     .type = KEY_REAL,
     AT(overlap),
     .least = 0,
     .most = 0.5,
     .help = "largest overlap that may be left, as part of the smaller radius"},
    {.name = "sweeps",
     .type = KEY_WHOLE,
     AT(sweeps),
     .least = 1,
     .most = 1e9,
     .help = "gives up after so many sweeps"},
    {.name = "velocity",
     .type = KEY_REAL,
     AT(velocity),
     .least = 0,
     .most = 1e9,
     .help = "velocities are normal with this deviation in each component"},
    {.name = "density", .type = KEY_REAL, AT(density), .least = 1e-9, .most = 1e9, .help = "of the solid"},
    {.name = "seed",
     .type = KEY_WHOLE,
     AT(seed),
     .least = 0,
     .most = 0x1p53,
     .help = "of the random numbers"},
    {.name = "threads",
     .type = KEY_WHOLE,
     AT(threads),
     .least = 0,
     .most = 255,
     .help = "0: all; the packing is the same for any number"},
};
enum { KEYS = sizeof keys / sizeof keys[0] };

static const char *const common = "gap=0.001 overlap=0 sweeps=20000 velocity=0 density=1 seed=1 threads=0";

/* A law: its keys are those of `defaults`, those of `more`, which have none, and those of all. */
struct law {
    const char *name, *summary, *defaults, *more, *text;
};

static const struct law laws[] = {
    [PACK_BIDISPERSE] =
        {"bidisperse", "spheres of radius 1 and R in a periodic cube", "ratio=10 numbers=table",
         "box large small",
         "  The systems of Table 1 of Stratford, Shire and Hanley, for ratio 10, 20, 40, 80 and 100. Large "
         "spheres at a\n"
         "  solid fraction of 0.12 and small ones are thrown at random into the cube and moved apart until "
         "none\n"
         "  overlap, each size for itself; then small ones that overlap a large one are removed. At the "
         "stated 0.36\n"
         "  for the small ones this leaves other numbers than the table has. numbers=table starts with as "
         "many as will\n"
         "  leave the table's number, and takes the few too many out at random; numbers=recipe keeps to "
         "0.36. Other\n"
         "  ratios, or another box, need box, large and small (or numbers=recipe and box).\n"},
    [PACK_UNIVOL] = {"univol", "each interval of radii holds the same volume",
                     "ratio=50 count=125001 fraction=0.4 walls=hard", "box",
                     "  The number density of the radii is r^-3 between 1 and R, as in the hierarchical "
                     "grid's benchmarks of Krijgsman,\n"
                     "  Ogarko and Luding: points at random, then moved apart until no spheres overlap. "
                     "Solid fractions up to 0.62\n"
                     "  (and 0.7 between periodic sides) take a few hundred sweeps.\n"},
    [PACK_SAND] =
        {"sand", "Dunkirk sand: a sharp peak of dust and a broad one of grains",
         "ratio=10 broad=0.05 walls=periodic", "count box fraction",
         "  Diameters from 2 to 925 micrometres, by number: a sharp peak near 2.5 (log-normal, median 2.55, "
         "width 0.15)\n"
         "  and a broad one at 250 to 350 (log-normal, median 320, width 0.35), which holds the part `broad` "
         "of the\n"
         "  particles. They are then mapped linearly to diameters from 1 to R. Particles and box are those "
         "of Stratford,\n"
         "  Shire and Hanley for ratio 10, 20 and 40; another count keeps their particles per volume. The\n"
         "  report draws the distribution and gives no numbers: the weight and the widths are chosen "
         "here.\n"},
    [PACK_EXPONENTIAL] =
        {"exponential", "a density that falls exponentially with the diameter",
         "ratio=50 count=5040560 by=mass scale=4.2 walls=periodic", "box fraction",
         "  Diameters d from 1 to R; mass (or number) falls as exp(-d / scale). Count and box (368.77) are "
         "those of the\n"
         "  second polydisperse case of Stratford, Shire and Hanley; another count keeps the particles per "
         "volume. By\n"
         "  number a cube as dense as theirs holds no diameter beyond 15: so by=mass is taken.\n"},
    [PACK_POWER] = {"power", "a power law of the radius",
                    "min=1 max=10 exponent=-3 count=100000 fraction=0.4 walls=periodic", "box",
                    "  The number density of the radii is r^exponent in [min, max].\n"},
    [PACK_SIEVE] = {"sieve", "any sieve curve, from a file",
                    "by=mass count=100000 fraction=0.4 walls=periodic", "table box",
                    "  The file has a line a sieve: its opening, which is a diameter, and the part of the "
                    "mass (or number)\n"
                    "  that passes, from 0 to 1 or from 0 to 100, rising. Between two sieves the curve is "
                    "linear. Up to 64\n"
                    "  sieves; # begins a comment.\n"},
};
enum { LAWS = sizeof laws / sizeof laws[0] };

const char *pack_law_name(enum pack_law law) {
    return laws[law].name;
}

/* Is `name` (of `length` letters) a word of the list, whose words may go on with "=VALUE"? */
static bool listed(const char *list, const char *name, size_t length) {
    for (const char *at = list; *at; at += *at == ' ') {
        if (strcspn(at, " =") == length && strncmp(at, name, length) == 0)
            return true;
        at += strcspn(at, " ");
    }
    return false;
}

static bool law_has(const struct law *law, const char *name, size_t length) {
    return listed(law->defaults, name, length) || listed(law->more, name, length) ||
           listed(common, name, length);
}

static bool set_name(void *to, const struct key *key, const char *text, struct error *error) {
    for (int k = 0; key->names[k]; k++)
        if (strcmp(key->names[k], text) == 0) {
            *(int *)to = k; /* enums of these options are ints */
            return true;
        }
    return error_set(error, ERROR_USER, "command line: %s=%s: allowed are %s and %s", key->name, text,
                     key->names[0], key->names[1]);
}

static bool set_value(struct pack_options *options, const struct key *key, const char *text,
                      struct error *error) {
    void *to = (char *)options + key->offset;
    if (key->type == KEY_NAME)
        return set_name(to, key, text, error);
    if (key->type == KEY_TEXT) {
        *(const char **)to = text;
        return *text || error_set(error, ERROR_USER, "command line: %s= needs a value", key->name);
    }
    char *end;
    double value = strtod(text, &end);
    if (end == text || *end || !isfinite(value))
        return error_set(error, ERROR_USER, "command line: %s=%s: is not a number", key->name, text);
    if (key->type == KEY_WHOLE && value != floor(value))
        return error_set(error, ERROR_USER, "command line: %s=%s: must be a whole number", key->name, text);
    if (value < key->least || value > key->most)
        return error_set(error, ERROR_USER, "command line: %s=%s: must lie in %g ... %g", key->name, text,
                         key->least, key->most);
    *(double *)to = value;
    return true;
}

/* One KEY=VALUE. Box and fraction replace each other. */
static bool set_key(struct pack_options *options, const struct law *law, const char *text,
                    struct error *error) {
    size_t length = strcspn(text, "=");
    if (text[length] != '=')
        return error_set(error, ERROR_USER, "command line: '%s' must read KEY=VALUE", text);
    for (int k = 0; k < KEYS; k++) {
        if (strlen(keys[k].name) != length || strncmp(keys[k].name, text, length) != 0 ||
            !law_has(law, text, length))
            continue;
        if (strcmp(keys[k].name, "box") == 0)
            options->fraction = 0;
        if (strcmp(keys[k].name, "fraction") == 0)
            options->box = 0;
        return set_value(options, &keys[k], text + length + 1, error);
    }
    return error_set(error, ERROR_USER,
                     "command line: '%.*s' is no key of the law %s; 'scree help pack %s' lists its keys",
                     (int)length, text, law->name, law->name);
}

/* The words of a list of defaults. They are our own: no failure. */
static void set_defaults(struct pack_options *options, const struct law *law, const char *list,
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
        return o->max > o->min ||
               error_set(error, ERROR_USER, "command line: max=%g must be above min=%g", o->max, o->min);
    case PACK_SIEVE:
        return o->table || error_set(error, ERROR_USER, "command line: the law sieve needs table=FILE");
    default:
        return true;
    }
}

bool pack_options_read(struct pack_options *options, const char *law, const char *const *setting,
                       int settings, struct error *error) {
    int l = 0;
    while (l < LAWS && strcmp(laws[l].name, law) != 0)
        l++;
    if (l == LAWS)
        return error_set(
            error, ERROR_USER,
            "command line: '%s' is no law of sizes; known are bidisperse, univol, sand, exponential, power, "
            "sieve",
            law);
    *options = (struct pack_options){.law = (enum pack_law)l};
    set_defaults(options, &laws[l], common, error);
    set_defaults(options, &laws[l], laws[l].defaults, error);
    bool box = false, fraction = false;
    for (int k = 0; k < settings; k++) {
        if (!set_key(options, &laws[l], setting[k], error))
            return false;
        box = box || strncmp(setting[k], "box=", 4) == 0;
        fraction = fraction || strncmp(setting[k], "fraction=", 9) == 0;
    }
    if (box && fraction)
        return error_set(error, ERROR_USER, "command line: box and fraction exclude each other");
    return finish(options, error);
}

/* The default of a key in a list, "" if it has none. */
static void find_default(const char *list, const char *name, char *value, size_t size) {
    for (const char *at = list; *at; at += *at == ' ') {
        size_t length = strcspn(at, " "), word = strcspn(at, "=");
        if (word == strlen(name) && strncmp(at, name, word) == 0)
            snprintf(value, size, "%.*s", (int)(length - word - 1), at + word + 1);
        at += length;
    }
}

static void help_key(FILE *out, const struct law *law, const struct key *key) {
    char value[SETTING_MAX] = "";
    find_default(common, key->name, value, sizeof value);
    find_default(law->defaults, key->name, value, sizeof value);
    fprintf(out, "  %s=", key->name);
    if (key->type == KEY_NAME)
        fprintf(out, "%s|%s", key->names[0], key->names[1]);
    else
        fputs(key->type == KEY_TEXT ? "FILE" : key->type == KEY_WHOLE ? "N" : "X", out);
    if (*value)
        fprintf(out, " (default: %s)", value);
    fprintf(out, "\n      %s\n", key->help);
}

bool pack_help(FILE *out, const char *name) {
    for (int l = 0; l < LAWS; l++) {
        if (name && strcmp(laws[l].name, name) != 0)
            continue;
        if (!name) {
            fprintf(out, "  %-12s %s\n", laws[l].name, laws[l].summary);
            continue;
        }
        fprintf(out, "%s: %s\n\n%s\n", laws[l].name, laws[l].summary, laws[l].text);
        for (int k = 0; k < KEYS; k++)
            if (law_has(&laws[l], keys[k].name, strlen(keys[k].name)))
                help_key(out, &laws[l], &keys[k]);
        return true;
    }
    return !name;
}
