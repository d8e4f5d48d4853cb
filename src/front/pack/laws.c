/* SPDX-License-Identifier: BSD-3-Clause */
/* The rows of the laws and of their keys, and their help. Read laws.h first. */
#include "front/pack/laws.h"

#include <string.h>

enum { VALUE_MAX = 64 };

static const char *const by_names[] = {"number", "mass", NULL};
static const char *const wall_names[] = {"periodic", "hard", NULL};
static const char *const shape_names[] = {"cube", "box", "cylinder", "sphere", "mesh", NULL};
static const char *const settle_names[] = {"no", "yes", NULL};
static const char *const number_names[] = {"table", "recipe", NULL};

#define AT(member) .offset = offsetof(struct pack_options, member)

static const struct law_key keys[] = {
    {.name = "ratio",
     .type = LAW_REAL,
     AT(ratio),
     .least = 1.001,
     .most = 1000,
     .help = "largest radius over smallest"},
    {.name = "numbers",
     .type = LAW_NAME,
     AT(numbers),
     .names = number_names,
     .help =
         "table: the published numbers, to the particle; recipe: what solid fractions of 0.12 and 0.36 give"},
    {.name = "count", .type = LAW_WHOLE, AT(count), .least = 1, .most = 1e8, .help = "particles"},
    {.name = "large", .type = LAW_WHOLE, AT(large), .least = 0, .most = 1e8, .help = "large particles"},
    {.name = "small",
     .type = LAW_WHOLE,
     AT(small),
     .least = 1,
     .most = 1e8,
     .help = "small particles that stay"},
    {.name = "box", .type = LAW_REAL, AT(box), .least = 1e-9, .most = 1e9, .help = "edge of the cube"},
    {.name = "fraction",
     .type = LAW_REAL,
     AT(fraction),
     .least = 1e-6,
     .most = 0.9,
     .help = "part of the volume that is solid: gives the edge of a cube, or, where the size is given, the "
             "count"},
    {.name = "walls",
     .type = LAW_NAME,
     AT(walls),
     .names = wall_names,
     .help = "all six sides of the cube or box"},
    {.name = "shape",
     .type = LAW_NAME,
     AT(shape),
     .names = shape_names,
     .help = "what is filled: cube (box=), box (edges=), cylinder upright on the origin (radius=, length=), "
             "sphere around the origin (radius=), or the inside of a closed mesh (file=)"},
    {.name = "edges",
     .type = LAW_EDGES,
     AT(edges),
     .least = 1e-9,
     .most = 1e9,
     .help = "of the box, as in 10,10,30"},
    {.name = "radius",
     .type = LAW_REAL,
     AT(radius),
     .least = 1e-9,
     .most = 1e9,
     .help = "of the cylinder or the sphere that is filled"},
    {.name = "length", .type = LAW_REAL, AT(length), .least = 1e-9, .most = 1e9, .help = "of the cylinder"},
    {.name = "file", .type = LAW_TEXT, AT(file), .help = "of the mesh: STL, OBJ, PLY, or nine numbers a row"},
    {.name = "scaled",
     .type = LAW_REAL,
     AT(scaled),
     .least = 1e-12,
     .most = 1e12,
     .help = "coordinates of the mesh's file x this"},
    {.name = "settle",
     .type = LAW_NAME,
     AT(settle),
     .names = settle_names,
     .help =
         "yes: the spheres then fall along -z in the container, between hard walls, until they rest on each "
         "other"},
    {.name = "friction",
     .type = LAW_REAL,
     AT(friction),
     .least = 0,
     .most = 10,
     .help = "of the spheres while they settle, among themselves and with the walls: the less, the denser "
             "the bed"},
    {.name = "broad",
     .type = LAW_REAL,
     AT(broad),
     .least = 0,
     .most = 1,
     .help = "part of the particles, by number, that is in the broad peak"},
    {.name = "scale",
     .type = LAW_REAL,
     AT(scale),
     .least = 0.01,
     .most = 1e6,
     .help = "diameter over which the density falls by a factor e"},
    {.name = "exponent",
     .type = LAW_REAL,
     AT(exponent),
     .least = -20,
     .most = 20,
     .help = "number density of the radii r is r^exponent"},
    {.name = "min", .type = LAW_REAL, AT(min), .least = 1e-9, .most = 1e9, .help = "smallest radius"},
    {.name = "max", .type = LAW_REAL, AT(max), .least = 1e-9, .most = 1e9, .help = "largest radius"},
    {.name = "by", .type = LAW_NAME, AT(by), .names = by_names, .help = "what the law counts"},
    {.name = "table",
     .type = LAW_TEXT,
     AT(table),
     .help = "file of the sizes: a line a size, its diameter (radius, if the first line reads 'radius "
             "passing' or "
             "'radius weight') and what passes, as a part or in percent, or its weight"},
    {.name = "diameters",
     .type = LAW_TEXT,
     AT(diameters),
     .help = "instead of the file: the sieves' openings, or the sizes, as in 1,2,4"},
    {.name = "radii", .type = LAW_TEXT, AT(radii), .help = "instead of diameters: half of them"},
    {.name = "passing",
     .type = LAW_TEXT,
     AT(passing),
     .help = "beside diameters or radii: what passes, as parts (0,0.4,1) or in percent (0,40,100)"},
    {.name = "weights",
     .type = LAW_TEXT,
     AT(weights),
     .help = "beside diameters or radii: share of each size, normalised to their sum"},
    {.name = "gap",
     .type = LAW_REAL,
     AT(gap),
     .least = 1e-6,
     .most = 0.1,
     .help = "distance that neighbours are moved apart to, as part of the sum of their radii"},
    {.name = "overlap",
     .type = LAW_REAL,
     AT(overlap),
     .least = 0,
     .most = 0.5,
     .help = "largest overlap that may be left, as part of the smaller radius"},
    {.name = "sweeps",
     .type = LAW_WHOLE,
     AT(sweeps),
     .least = 1,
     .most = 1e9,
     .help = "gives up after so many sweeps"},
    {.name = "velocity",
     .type = LAW_REAL,
     AT(velocity),
     .least = 0,
     .most = 1e9,
     .help = "velocities are normal with this deviation in each component"},
    {.name = "density", .type = LAW_REAL, AT(density), .least = 1e-9, .most = 1e9, .help = "of the solid"},
    {.name = "seed",
     .type = LAW_WHOLE,
     AT(seed),
     .least = 0,
     .most = 0x1p53,
     .help = "of the random numbers"},
    {.name = "threads",
     .type = LAW_WHOLE,
     AT(threads),
     .least = 0,
     .most = 255,
     .help = "0: all; the packing is the same for any number"},
};
enum { KEYS = sizeof keys / sizeof keys[0] };

static const char *const common = "gap=0.001 overlap=0 sweeps=20000 velocity=0 density=1 seed=1 threads=0";
static const char *const container = "shape=cube edges radius length file scaled=1 settle=no friction=0.5";

static const struct laws_row laws[] = {
    [PACK_BIDISPERSE] = {.name = "bidisperse",
                         .summary = "spheres of radius 1 and R in a periodic cube",
                         .defaults = "ratio=10 numbers=table",
                         .more = "box large small",
                         .cube_only = true,
                         .text = "The systems of Table 1 of Stratford, Shire and Hanley, for ratio 10, 20,\n"
                                 "40, 80 and 100. Large spheres at a solid fraction of 0.12 and small ones\n"
                                 "are thrown at random into the cube and moved apart until none overlap,\n"
                                 "each size for itself; then small ones that overlap a large one are\n"
                                 "removed. At the stated 0.36 for the small ones this leaves other numbers\n"
                                 "than the table has. numbers=table starts with as many as will leave the\n"
                                 "table's number, and takes the few too many out at random;\n"
                                 "numbers=recipe keeps to 0.36. Other ratios, or another box, need box,\n"
                                 "large and small (or numbers=recipe and box).\n"},
    [PACK_UNIVOL] = {.name = "univol",
                     .summary = "each interval of radii holds the same volume",
                     .defaults = "ratio=50 count=125001 fraction=0.4 walls=hard",
                     .more = "box",
                     .text = "The number density of the radii is r^-3 between 1 and R, as in a study of\n"
                             "the hierarchical grid by Ogarko and Luding. A solid fraction of 0.62\n"
                             "between hard walls takes some hundred sweeps.\n"},
    [PACK_SAND] = {.name = "sand",
                   .summary = "Dunkirk sand: a sharp peak of dust and a broad one of grains",
                   .defaults = "ratio=10 broad=0.05 walls=periodic",
                   .more = "count box fraction",
                   .text = "Diameters from 2 to 925 micrometres, by number: a sharp peak near 2.5\n"
                           "(log-normal, median 2.55, width 0.15) and a broad one at 250 to 350\n"
                           "(log-normal, median 320, width 0.35), which holds the part `broad` of the\n"
                           "particles. They are then mapped linearly to diameters from 1 to R.\n"
                           "Particles and box are those of Stratford, Shire and Hanley for ratio 10,\n"
                           "20 and 40; another count keeps their particles per volume. Their report\n"
                           "draws the distribution and gives no numbers: the weight and the widths\n"
                           "are chosen here.\n"},
    [PACK_EXPONENTIAL] = {.name = "exponential",
                          .summary = "a density that falls exponentially with the diameter",
                          .defaults = "ratio=50 count=5040560 by=mass scale=4.2 walls=periodic",
                          .more = "box fraction",
                          .text = "Diameters d from 1 to R; mass (or number) falls as exp(-d / scale).\n"
                                  "Count and box (368.77) are those of the second polydisperse case of\n"
                                  "Stratford, Shire and Hanley; another count keeps the particles per\n"
                                  "volume. By number a cube as full as theirs holds no diameter beyond 15:\n"
                                  "so by=mass is taken.\n"},
    [PACK_POWER] = {.name = "power",
                    .summary = "a power law of the radius",
                    .defaults = "min=1 max=10 exponent=-3 count=100000 fraction=0.4 walls=periodic",
                    .more = "box",
                    .text = "The number density of the radii is r^exponent in [min, max].\n"},
    [PACK_SIEVE] = {.name = "sieve",
                    .summary = "any sieve curve, from a file or a list",
                    .defaults = "by=mass count=100000 fraction=0.4 walls=periodic",
                    .more = "table diameters radii passing box",
                    .text = "The file has a line a sieve: its opening, which is a diameter, and the\n"
                            "part of the mass (or number) that passes, from 0 to 1 or from 0 to 100,\n"
                            "rising. Between two sieves the curve is linear. Up to 64 sieves; #\n"
                            "begins a comment. Instead of the file: diameters=1,2,4 passing=0,40,100.\n"},
    [PACK_DISCRETE] = {.name = "discrete",
                       .summary = "a few sizes with weights",
                       .defaults = "by=mass count=100000 fraction=0.4 walls=periodic",
                       .more = "table diameters radii weights box",
                       .text = "As in radii=1,3 weights=80,20, or from a file with a line a size: its\n"
                               "diameter and its weight, of the mass or of the number.\n"},
};
enum { LAWS = sizeof laws / sizeof laws[0] };

const struct laws_row *laws_get(int k) {
    return k >= 0 && k < LAWS ? &laws[k] : NULL;
}

const struct law_key *laws_key(int k) {
    return k >= 0 && k < KEYS ? &keys[k] : NULL;
}

const char *laws_common(void) {
    return common;
}

const char *laws_container(void) {
    return container;
}

const char *pack_law_name(enum pack_law law) {
    return laws[law].name;
}

/* True if `name` (of `length` letters) is a word of the list, whose words may go on with "=VALUE". */
static bool listed(const char *list, const char *name, size_t length) {
    for (const char *at = list; *at; at += *at == ' ') {
        if (strcspn(at, " =") == length && strncmp(at, name, length) == 0)
            return true;
        at += strcspn(at, " ");
    }
    return false;
}

bool laws_has(const struct laws_row *law, const char *name, size_t length) {
    return listed(law->defaults, name, length) || listed(law->more, name, length) ||
           listed(common, name, length) || (!law->cube_only && listed(container, name, length));
}

/* The default of a key in a list, "" if it has none. */
static void find_default(const char *list, const char *name, char *value, size_t size) {
    for (const char *at = list; *at; at += *at == ' ') {
        size_t length = strcspn(at, " "), word = strcspn(at, "= ");
        if (word < length && word == strlen(name) && strncmp(at, name, word) == 0)
            snprintf(value, size, "%.*s", (int)(length - word - 1), at + word + 1);
        at += length;
    }
}

static void help_key(FILE *out, const struct laws_row *law, const struct law_key *key) {
    char value[VALUE_MAX] = "";
    find_default(common, key->name, value, sizeof value);
    find_default(container, key->name, value, sizeof value);
    find_default(law->defaults, key->name, value, sizeof value);
    fprintf(out, "  %s=", key->name);
    static const char *const kinds[] = {
        [LAW_REAL] = "X", [LAW_WHOLE] = "N", [LAW_TEXT] = "FILE", [LAW_NAME] = "", [LAW_EDGES] = "X,Y,Z"};
    fputs(kinds[key->type], out);
    for (int k = 0; key->names && key->names[k]; k++)
        fprintf(out, "%s%s", k ? "|" : "", key->names[k]);
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
            if (laws_has(&laws[l], keys[k].name, strlen(keys[k].name)))
                help_key(out, &laws[l], &keys[k]);
        return true;
    }
    return !name;
}
