/* SPDX-License-Identifier: BSD-3-Clause */
/* Reads and writes the sections of LAMMPS data files. Read lammps_data.h first. */
#include "data/formats/lammps_data.h"

#include "base/memory.h"
#include "base/file.h"
#include "base/lines.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Sections that a data file of spheres may hold; Atoms and Velocities are read, the rest skipped or refused.
 */
static const char *const sections[] = {"Atoms", "Velocities", "Masses", "Pair Coeffs", "PairIJ Coeffs"};
enum { SECTIONS = sizeof sections / sizeof sections[0] };

struct numbered {
    int64_t id;
    size_t row;
    bool moves; /* the particle has a line in section Velocities */
};

struct reading {
    struct lines lines;
    struct rows *rows;
    int64_t atoms, types;
    struct numbered *sorted; /* the rows sorted by id */
    bool pending;            /* lines.text is a section head not yet used */
};

/* Splits "Atoms # sphere" into the section (its number, or -1) and the hint after '#'. */
static int section_of(const char *line, char *hint, size_t size) {
    const char *comment = strchr(line, '#');
    hint[0] = '\0';
    if (comment)
        snprintf(hint, size, "%s", comment + 1 + strspn(comment + 1, " \t"));
    size_t length = comment ? (size_t)(comment - line) : strlen(line);
    while (length > 0 && (line[length - 1] == ' ' || line[length - 1] == '\t'))
        length--;
    for (int s = 0; s < SECTIONS; s++)
        if (strlen(sections[s]) == length && strncmp(line, sections[s], length) == 0)
            return s;
    return -1;
}

/* True if the line holds blanks or a comment alone. */
static bool is_blank(const char *line) {
    char first = line[strspn(line, " \t\r")];
    return first == '\0' || first == '#';
}

/* Reads a line of the head: counts and bounds. */
static bool read_head_line(struct reading *r, struct error *error) {
    char *word[8];
    struct lines *lines = &r->lines;
    char *comment = strchr(lines->text, '#');
    if (comment)
        *comment = '\0';
    int words = lines_words(lines, word, 8);
    if (words == 0)
        return true; /* a comment alone */
    double lower, upper;
    static const char *const low[] = {"xlo", "ylo", "zlo"};
    for (int d = 0; d < 3; d++)
        if (words == 4 && strcmp(word[2], low[d]) == 0) {
            if (!lines_real(word[0], &lower) || !lines_real(word[1], &upper) || !(upper > lower))
                return lines_refuse(lines, error, "wants the lower and the upper bound of the box");
            r->rows->lower[d] = lower;
            r->rows->upper[d] = upper;
            return true;
        }
    if (words == 6 && strcmp(word[3], "xy") == 0) {
        double tilt[3];
        for (int k = 0; k < 3; k++)
            if (!lines_real(word[k], &tilt[k]))
                return lines_refuse(lines, error, "wants the tilts xy, xz and yz");
        return rows_tilt_of(tilt, &r->rows->tilt) ||
               lines_refuse(lines, error, "the box has several tilts; at most one is known");
    }
    if (words == 2 && strcmp(word[1], "atoms") == 0)
        return (lines_integer(word[0], &r->atoms) && r->atoms >= 0) ||
               lines_refuse(lines, error, "\"%s\" is not a number of atoms", word[0]);
    if (words == 3 && strcmp(word[1], "atom") == 0 && strcmp(word[2], "types") == 0)
        return (lines_integer(word[0], &r->types) && r->types >= 0) ||
               lines_refuse(lines, error, "\"%s\" is not a number of types", word[0]);
    int64_t count;
    if (words >= 2 && lines_integer(word[0], &count) && count == 0)
        return true; /* "0 bonds" and the like */
    return lines_refuse(lines, error, "\"%s%s%s...\" is not a line of a data file of spheres", word[0],
                        words > 1 ? " " : "", words > 1 ? word[1] : "");
}

/* Reads up to the first section. */
static bool read_head(struct reading *r, struct error *error) {
    struct lines *lines = &r->lines;
    char hint[64];
    r->atoms = -1;
    r->rows->lower[0] = NAN;
    r->rows->lower[1] = NAN;
    r->rows->lower[2] = NAN;
    if (!lines_next(lines)) /* a title */
        return lines_refuse(lines, error, "the file is empty");
    if (strncmp(lines->text, "ITEM: ", 6) == 0)
        return lines_refuse(lines, error,
                            "this is a LAMMPS dump, not a data file; `scree convert %s OUT.data` makes one",
                            lines->path);
    while (!r->pending && lines_next(lines)) {
        if (is_blank(lines->text))
            continue;
        if (section_of(lines->text, hint, sizeof hint) >= 0)
            r->pending = true;
        else if (!read_head_line(r, error))
            return false;
    }
    if (r->atoms < 0)
        return lines_refuse(lines, error,
                            "there is no line \"N atoms\" before this; this is not a LAMMPS data file");
    for (int d = 0; d < 3; d++)
        if (isnan(r->rows->lower[d]))
            return lines_refuse(lines, error, "there is no line \"LO HI %clo %chi\" before this", 'x' + d,
                                'x' + d);
    r->rows->box_given = true;
    return true;
}

/* Skips blank lines and reads `count` lines of a section; `take` gets the numbers of each line. */
static bool read_section(struct reading *r, int64_t count, int least, int most,
                         bool (*take)(struct reading *, size_t, const double *, int, struct error *),
                         struct error *error) {
    double value[16];
    for (int64_t k = 0; k < count; k++) {
        if (!lines_next_filled(&r->lines))
            return lines_refuse(&r->lines, error, "the file ends after %" PRId64 " of %" PRId64 " lines", k,
                                count);
        char hint[64];
        if (section_of(r->lines.text, hint, sizeof hint) >= 0)
            return lines_refuse(&r->lines, error,
                                "the section before this has %" PRId64 " lines instead of %" PRId64, k,
                                count);
        int n = lines_numbers(&r->lines, value, 16);
        if (n < 0)
            return lines_refuse(&r->lines, error, "holds a word that is not a number");
        if (n < least || n > most)
            return lines_refuse(&r->lines, error, "has %d columns instead of %d%s", n, least,
                                most > least ? " (or with three image flags)" : "");
        if (!take(r, (size_t)k, value, n, error))
            return false;
    }
    return true;
}

/* id type diameter density x y z [ix iy iz] */
static bool take_atom(struct reading *r, size_t row, const double *value, int n, struct error *error) {
    struct rows *rows = r->rows;
    int64_t types = r->types > 0 && r->types < INT32_MAX ? r->types : INT32_MAX, type, image;
    if (!lines_whole(value[0], 1, LINES_WHOLE_MAX, &rows->id[row]))
        return lines_refuse(&r->lines, error, "%g is not an id (a whole number from 1 to 2^53)", value[0]);
    if (!lines_whole(value[1], 1, types, &type))
        return lines_refuse(&r->lines, error, "%g is not a type (1 ... %" PRId64 ")", value[1], types);
    rows->material[row] = (int32_t)(type - 1);
    rows->line[row] = (uint32_t)r->lines.number;
    if (value[2] <= 0 || value[3] <= 0)
        return lines_refuse(&r->lines, error, "diameter and density must be positive");
    if (n != 7 && n != 10)
        return lines_refuse(&r->lines, error, "has %d columns instead of 7 or 10", n);
    double radius = value[2] / 2;
    rows->radius[row] = radius;
    rows->mass[row] = value[3] * (4.0 / 3.0) * M_PI * radius * radius * radius;
    memcpy(rows->position[row], value + 4, sizeof rows->position[row]);
    for (int d = 0; n == 10 && d < 3; d++) {
        if (!lines_whole(value[7 + d], -INT32_MAX, INT32_MAX, &image))
            return lines_refuse(&r->lines, error, "%g is not an image flag (a whole number of 32 bits)",
                                value[7 + d]);
        rows->image[row][d] = (int32_t)image;
    }
    return true;
}

static int compare_ids(const void *a, const void *b) {
    const struct numbered *x = a, *y = b;
    return x->id != y->id ? (x->id > y->id) - (x->id < y->id) : (x->row > y->row) - (x->row < y->row);
}

/* Sorts the rows by id; refuses ids that occur twice. */
static bool order_ids(struct reading *r, struct error *error) {
    size_t n = r->rows->count;
    const uint32_t *line = r->rows->line;
    r->sorted = memory_allocate(n, sizeof *r->sorted, "rows by id");
    for (size_t k = 0; k < n; k++)
        r->sorted[k] = (struct numbered){.id = r->rows->id[k], .row = k};
    qsort(r->sorted, n, sizeof *r->sorted, compare_ids);
    for (size_t k = 1; k < n; k++)
        if (r->sorted[k].id == r->sorted[k - 1].id)
            return error_set(error, ERROR_USER, "%s:%u: has the id of particle %" PRId64 ", line %u",
                             r->lines.path, line[r->sorted[k].row], r->sorted[k].id,
                             line[r->sorted[k - 1].row]);
    return true;
}

/* id vx vy vz wx wy wz */
static bool take_velocity(struct reading *r, size_t line, const double *value, int n, struct error *error) {
    (void)line;
    struct rows *rows = r->rows;
    if (n != 7)
        return lines_refuse(&r->lines, error,
                            "has %d columns; in atom style sphere a velocity has 7: id vx vy vz wx wy wz", n);
    size_t low = 0, high = rows->count;
    while (low + 1 < high) {
        size_t middle = (low + high) / 2;
        if ((double)r->sorted[middle].id <= value[0])
            low = middle;
        else
            high = middle;
    }
    if (rows->count == 0 || (double)r->sorted[low].id != value[0])
        return lines_refuse(&r->lines, error, "there is no atom with id %g", value[0]);
    if (r->sorted[low].moves)
        return lines_refuse(&r->lines, error, "a second velocity of the atom with id %g", value[0]);
    r->sorted[low].moves = true;
    size_t row = r->sorted[low].row;
    memcpy(rows->velocity[row], value + 1, sizeof rows->velocity[row]);
    memcpy(rows->angular_velocity[row], value + 4, sizeof rows->angular_velocity[row]);
    return true;
}

/* Skips a section whose numbers are not needed: up to the next section's head. */
static void skip_section(struct reading *r) {
    char hint[64];
    while (!r->pending && lines_next(&r->lines))
        r->pending = section_of(r->lines.text, hint, sizeof hint) >= 0;
}

static bool read_sections(struct reading *r, struct error *error) {
    struct rows *rows = r->rows;
    bool atoms = false, velocities = false;
    while (r->pending || lines_next(&r->lines)) {
        char hint[64];
        if (!r->pending && is_blank(r->lines.text))
            continue;
        r->pending = false;
        int section = section_of(r->lines.text, hint, sizeof hint);
        if (section == 0) {
            if (hint[0] && strcmp(hint, "sphere") != 0)
                return lines_refuse(&r->lines, error, "atom style \"%s\": only \"sphere\" is known", hint);
            if (atoms)
                return lines_refuse(&r->lines, error, "a second section Atoms");
            atoms = true;
            if (!read_section(r, r->atoms, 7, 10, take_atom, error) || !order_ids(r, error))
                return false;
        } else if (section == 1) {
            if (!atoms || velocities)
                return lines_refuse(&r->lines, error, "Velocities must come once, after Atoms");
            velocities = true;
            if (!read_section(r, r->atoms, 1, 15, take_velocity, error))
                return false;
        } else if (section > 1) {
            skip_section(r);
        } else {
            return lines_refuse(&r->lines, error, "\"%.60s\" is not a section of a data file of spheres",
                                r->lines.text);
        }
    }
    if (!velocities) {
        memory_free(rows->velocity);
        memory_free(rows->angular_velocity);
        rows->velocity = rows->angular_velocity = NULL;
    }
    if (r->lines.damaged)
        return lines_refuse(&r->lines, error, "the file does not end here");
    return atoms || lines_refuse(&r->lines, error, "the file has no section Atoms");
}

/* Makes rows for the number of atoms in the head, and moves the data of the head into the rows. */
static void make_rows(struct reading *r) {
    struct rows head = *r->rows;
    rows_create(r->rows, (size_t)r->atoms, ROWS_ALL | ROWS_LINE);
    memcpy(r->rows->lower, head.lower, sizeof head.lower);
    memcpy(r->rows->upper, head.upper, sizeof head.upper);
    r->rows->tilt = head.tilt;
    r->rows->box_given = true;
}

bool lammps_data_read(const char *path, struct rows *rows, struct error *error) {
    *rows = (struct rows){0};
    struct reading r = {.rows = rows};
    if (!lines_open(&r.lines, path, error))
        return false;
    bool good = read_head(&r, error);
    /* a line takes 14 bytes at least: a count too large for the file means a damaged file, and must not make
     * the program run out of memory */
    if (good && r.atoms > lines_bytes_most(&r.lines) / 14 + 1)
        good = error_set(error, ERROR_USER, "%s: says %" PRId64 " atoms, for which it is too short", path,
                         r.atoms);
    if (good) {
        make_rows(&r);
        good = read_sections(&r, error);
    }
    lines_close(&r.lines);
    memory_free(r.sorted);
    if (!good)
        rows_free(rows);
    return good;
}

/* Writes one line of section Atoms. */
static void write_atom(FILE *file, const struct rows *rows, size_t k) {
    double radius = rows->radius[k], volume = (4.0 / 3.0) * M_PI * radius * radius * radius;
    double density = rows->mass && rows->mass[k] > 0 ? rows->mass[k] / volume : 1;
    fprintf(file, "%" PRId64 " %d %.17g %.17g %.17g %.17g %.17g", rows->id ? rows->id[k] : (int64_t)k + 1,
            rows->material ? rows->material[k] + 1 : 1, 2 * radius, density, rows->position[k][0],
            rows->position[k][1], rows->position[k][2]);
    if (rows->image)
        fprintf(file, " %d %d %d", rows->image[k][0], rows->image[k][1], rows->image[k][2]);
    fprintf(file, "\n");
}

static void write_velocity(FILE *file, const struct rows *rows, size_t k) {
    static const double none[3] = {0};
    const double *w = rows->angular_velocity ? rows->angular_velocity[k] : none;
    fprintf(file, "%" PRId64 " %.17g %.17g %.17g %.17g %.17g %.17g\n",
            rows->id ? rows->id[k] : (int64_t)k + 1, rows->velocity[k][0], rows->velocity[k][1],
            rows->velocity[k][2], w[0], w[1], w[2]);
}

bool lammps_data_write(const char *path, const struct rows *rows, struct error *error) {
    if (!rows->radius)
        return error_set(error, ERROR_USER,
                         "%s: the particles have no radius, which a data file of spheres needs", path);
    if (!rows->box_given)
        return error_set(error, ERROR_USER, "%s: there is no box, which a data file needs", path);
    const struct rows_tilt *tilt = &rows->tilt;
    if (tilt->offset != 0 && tilt->flow > tilt->gradient)
        return error_set(error, ERROR_USER,
                         "%s: the box is sheared along %c with the height %c; LAMMPS knows x with y, x with "
                         "z and y with z",
                         path, 'x' + tilt->flow, 'x' + tilt->gradient);
    struct file_new file;
    if (!file_new_open(&file, path, error))
        return false;
    int types = 1;
    for (size_t k = 0; rows->material && k < rows->count; k++)
        types = rows->material[k] + 1 > types ? rows->material[k] + 1 : types;
    fprintf(file.stream,
            "LAMMPS data file written by scree, step %" PRIu64 "\n\n%zu atoms\n%d atom types\n\n", rows->step,
            rows->count, types);
    double upper[3], lower[3];
    memcpy(lower, rows->lower, sizeof lower);
    memcpy(upper, rows->upper, sizeof upper);
    for (size_t k = 0; rows->dimension == 2 && k < rows->count; k++) {
        upper[2] = fmax(upper[2], rows->radius[k]); /* a 2D scene is as thick as its particles */
        lower[2] = fmin(lower[2], -rows->radius[k]);
    }
    for (int d = 0; d < 3; d++)
        fprintf(file.stream, "%.17g %.17g %clo %chi\n", lower[d], upper[d], 'x' + d, 'x' + d);
    double slant[3] = {0};
    if (tilt->offset != 0) {
        slant[tilt->flow + tilt->gradient - 1] = tilt->offset;
        fprintf(file.stream, "%.17g %.17g %.17g xy xz yz\n", slant[0], slant[1], slant[2]);
    }
    fprintf(file.stream, "\nAtoms # sphere\n\n");
    for (size_t k = 0; k < rows->count; k++)
        write_atom(file.stream, rows, k);
    if (rows->velocity) {
        fprintf(file.stream, "\nVelocities\n\n");
        for (size_t k = 0; k < rows->count; k++)
            write_velocity(file.stream, rows, k);
    }
    return file_new_close(&file, error);
}
