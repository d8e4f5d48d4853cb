/* SPDX-License-Identifier: BSD-3-Clause */
/* The rows of the laws and of their keys, and their help. Read laws.h first. */
#include "front/pack/laws.h"

#include "data/scene/schema.h"
#include "data/scene/schema_rows.h"

#include <string.h>

enum { VALUE_MAX = 64 };

static const struct laws_key keys[] = {
    {"ratio", NULL, "largest radius over smallest, 1.001 to 1000", false},
    {"numbers", NULL,
     "table: the published numbers, to the particle; recipe: what solid fractions of 0.12 and 0.36 give",
     false},
    {"count", "particles.sources.count", "particles", false},
    {"large", NULL, "large particles", false},
    {"small", NULL, "small particles that stay", false},
    {"box", NULL, "edge of the cube", false},
    {"fraction", "particles.sources.volume_fraction",
     "part of the volume that is solid: gives the edge of a cube, or, where the size is given, the count",
     false},
    {"walls", NULL, "periodic, or hard: all six sides of the cube or box", false},
    {"shape", NULL,
     "what is filled: cube (box=), box (edges=), cylinder upright on the origin (radius=, length=), sphere "
     "around the origin (radius=), or mesh: the inside of a closed one (file=)",
     false},
    {"edges", NULL, "of the box, as in 10,10,30", false},
    {"radius", NULL, "of the cylinder or the sphere that is filled", false},
    {"length", NULL, "of the cylinder", false},
    {"file", NULL, "of the mesh: STL, OBJ, PLY, or nine numbers a row", false},
    {"scaled", NULL, "coordinates of the mesh's file x this", false},
    {"settle", NULL,
     "yes: the spheres then fall along -z in the container, between hard walls, until they rest on each "
     "other",
     false},
    {"friction", NULL,
     "of the spheres while they settle, among themselves and with the walls: the less, the denser the bed",
     false},
    {"broad", NULL, "part of the particles, by number, that is in the broad peak", false},
    {"scale", NULL, "diameter over which the density falls by a factor e", false},
    {"exponent", "particles.sources.sizes.exponent", NULL, false},
    {"min", "particles.sources.sizes.min", NULL, false},
    {"max", "particles.sources.sizes.max", NULL, false},
    {"by", "particles.sources.sizes.by", NULL, false},
    {"table", "particles.sources.sizes.file", NULL, false},
    {"diameters", "particles.sources.sizes.diameters", NULL, true},
    {"radii", "particles.sources.sizes.radii", NULL, true},
    {"passing", "particles.sources.sizes.passing", NULL, true},
    {"weights", "particles.sources.sizes.weights", NULL, true},
    {"gap", "particles.sources.gap", NULL, false},
    {"overlap", "particles.sources.overlap", NULL, false},
    {"sweeps", "particles.sources.sweeps", NULL, false},
    {"velocity", "particles.sources.velocity_sigma",
     "standard deviation of each component of the velocities; their mean is taken off", false},
    {"density", "particles.sources.density", "of the solid", false},
    {"seed", "seed", NULL, false},
    {"threads", "threads", NULL, false},
};
enum { KEYS = sizeof keys / sizeof keys[0] };

static const char *const common = "density=1 gap overlap sweeps velocity seed threads";
static const char *const container = "shape=cube edges radius length file scaled=1 settle=no friction=0.5";

static const struct laws_row laws[] = {
    {.name = "bidisperse",
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
    {.name = "univol",
     .summary = "each interval of radii holds the same volume",
     .defaults = "ratio=50 count=125001 fraction=0.4 walls=hard",
     .more = "box",
     .text = "The number density of the radii is r^-3 between 1 and R, as in a study of\n"
             "the hierarchical grid by Ogarko and Luding. A solid fraction of 0.62\n"
             "between hard walls takes some hundred sweeps.\n"},
    {.name = "sand",
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
    {.name = "exponential",
     .summary = "a density that falls exponentially with the diameter",
     .defaults = "ratio=50 count=5040560 by=mass scale=4.2 walls=periodic",
     .more = "box fraction",
     .text = "Diameters d from 1 to R; mass (or number) falls as exp(-d / scale).\n"
             "Count and box (368.77) are those of the second polydisperse case of\n"
             "Stratford, Shire and Hanley; another count keeps the particles per\n"
             "volume. By number a cube as full as theirs holds no diameter beyond 15:\n"
             "so by=mass is taken.\n"},
    {.name = "power",
     .summary = "a power law of the radius",
     .defaults = "min=1 max=10 exponent=-3 count=100000 fraction=0.4 walls=periodic",
     .more = "box",
     .text = "The number density of the radii is r^exponent in [min, max].\n"},
    {.name = "sieve",
     .summary = "any sieve curve, from a file or a list",
     .defaults = "by=mass count=100000 fraction=0.4 walls=periodic",
     .more = "table diameters radii passing box",
     .text = "The file has a line a sieve: its opening, which is a diameter, and the\n"
             "part of the mass (or number) that passes, from 0 to 1 or from 0 to 100,\n"
             "rising. Between two sieves the curve is linear. Up to 64 sieves; #\n"
             "begins a comment. Instead of the file: diameters=1,2,4 passing=0,40,100.\n"},
    {.name = "discrete",
     .summary = "a few sizes with weights",
     .defaults = "by=mass count=100000 fraction=0.4 walls=periodic",
     .more = "table diameters radii weights box",
     .text = "As in radii=1,3 weights=80,20, or from a file with a line a size: its\n"
             "diameter and its weight, of the mass or of the number.\n"},
};
enum { LAWS = sizeof laws / sizeof laws[0] };

const struct laws_row *laws_find(const char *name) {
    for (int k = 0; k < LAWS; k++)
        if (strcmp(laws[k].name, name) == 0)
            return &laws[k];
    return NULL;
}

const struct laws_key *laws_key(int k) {
    return k >= 0 && k < KEYS ? &keys[k] : NULL;
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

/* The default of a key in a list of words KEY=VALUE; false: none. */
static bool find_default(const char *list, const char *name, char *value, size_t size) {
    for (const char *at = list; *at; at += *at == ' ') {
        size_t length = strcspn(at, " "), word = strcspn(at, "= ");
        if (word < length && word == strlen(name) && strncmp(at, name, word) == 0) {
            snprintf(value, size, "%.*s", (int)(length - word - 1), at + word + 1);
            return true;
        }
        at += length;
    }
    return false;
}

bool laws_default(const struct laws_row *law, const char *name, char *value, size_t size) {
    return find_default(law->defaults, name, value, size) || find_default(common, name, value, size) ||
           (!law->cube_only && find_default(container, name, value, size));
}

static void help_key(FILE *out, const struct laws_row *law, const struct laws_key *key) {
    char value[VALUE_MAX] = "", full[SCHEMA_KEY_MAX];
    const struct schema_row *row = key->path ? schema_find(key->path, full) : NULL;
    if (!laws_default(law, key->name, value, sizeof value) && row && row->fallback && !key->help)
        snprintf(value, sizeof value, "%s", row->fallback);
    fprintf(out, "  %s=", key->name);
    if (*value)
        fprintf(out, " (default: %s)", value);
    fprintf(out, "\n      %s\n", key->help ? key->help : row->help);
    if (row)
        fprintf(out, "      as %s in a scene\n", key->path);
}

bool pack_help(FILE *out, const char *name) {
    const struct laws_row *law = name ? laws_find(name) : NULL;
    for (int l = 0; !name && l < LAWS; l++)
        fprintf(out, "  %-12s %s\n", laws[l].name, laws[l].summary);
    if (!law)
        return !name;
    fprintf(out, "%s: %s\n\n%s\n", law->name, law->summary, law->text);
    for (int k = 0; k < KEYS; k++)
        if (laws_has(law, keys[k].name, strlen(keys[k].name)))
            help_key(out, law, &keys[k]);
    return true;
}
