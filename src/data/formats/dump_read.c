/* SPDX-License-Identifier: BSD-3-Clause */
/* Reads the dumps that dump.c writes, and those of LAMMPS. Read dump.h first. */
#include "data/formats/dump.h"

#include "base/memory.h"
#include "base/lines.h"

#include <inttypes.h>
#include <string.h>

enum { COLUMNS_MAX = 1024 };

/* The meaning of a column of the file. */
enum meaning {
    SKIP,
    ID,
    TYPE,
    RADIUS,
    DIAMETER,
    MASS,
    KIND,
    BODY,
    BODY_PART,
    BODY_MASS,
    ROCK_SHAPE,
    X, /* and Y, Z: place + component */
    SCALED = X + 3,
    V = SCALED + 3,
    OMEGA = V + 3,
    IMAGE = OMEGA + 3,
    TURN = IMAGE + 3 /* four: w x y z */
};

static const struct {
    const char *name;
    int meaning;
    unsigned column;
} known_columns[] = {
    {"id", ID, ROWS_ID},
    {"type", TYPE, ROWS_MATERIAL},
    {"radius", RADIUS, ROWS_RADIUS},
    {"diameter", DIAMETER, ROWS_RADIUS},
    {"mass", MASS, ROWS_MASS},
    {"x", X, ROWS_POSITION},
    {"y", X + 1, ROWS_POSITION},
    {"z", X + 2, ROWS_POSITION},
    {"xu", X, ROWS_POSITION},
    {"yu", X + 1, ROWS_POSITION},
    {"zu", X + 2, ROWS_POSITION},
    {"xs", SCALED, ROWS_POSITION},
    {"ys", SCALED + 1, ROWS_POSITION},
    {"zs", SCALED + 2, ROWS_POSITION},
    {"vx", V, ROWS_VELOCITY},
    {"vy", V + 1, ROWS_VELOCITY},
    {"vz", V + 2, ROWS_VELOCITY},
    {"omegax", OMEGA, ROWS_ANGULAR_VELOCITY},
    {"omegay", OMEGA + 1, ROWS_ANGULAR_VELOCITY},
    {"omegaz", OMEGA + 2, ROWS_ANGULAR_VELOCITY},
    {"ix", IMAGE, ROWS_IMAGE},
    {"iy", IMAGE + 1, ROWS_IMAGE},
    {"iz", IMAGE + 2, ROWS_IMAGE},
    {"kind", KIND, ROWS_KIND},
    {"body", BODY, ROWS_BODY},
    {"body_part", BODY_PART, ROWS_BODY_PART},
    {"body_mass", BODY_MASS, ROWS_BODY_MASS},
    {"rock_shape", ROCK_SHAPE, ROWS_ROCK_SHAPE},
    {"quatw", TURN, ROWS_ROCK_ORIENTATION},
    {"quati", TURN + 1, ROWS_ROCK_ORIENTATION},
    {"quatj", TURN + 2, ROWS_ROCK_ORIENTATION},
    {"quatk", TURN + 3, ROWS_ROCK_ORIENTATION},
    {"c_q[1]", TURN, ROWS_ROCK_ORIENTATION},
    {"c_q[2]", TURN + 1, ROWS_ROCK_ORIENTATION},
    {"c_q[3]", TURN + 2, ROWS_ROCK_ORIENTATION},
    {"c_q[4]", TURN + 3, ROWS_ROCK_ORIENTATION},
};

struct layout {
    int columns;
    int meaning[COLUMNS_MAX];
    unsigned present; /* bits of enum rows_column */
};

/* The head of a frame: step, number of particles, box. */
struct head {
    int64_t step, count;
    double time, lower[3], upper[3];
    struct rows_tilt tilt;
    bool periodic[3], box_given;
    struct layout layout;
};

static bool expect(struct lines *lines, const char *what, struct error *error) {
    return lines_next(lines) || lines_refuse(lines, error, "the file ends where %s is wanted", what);
}

static bool read_integer(struct lines *lines, const char *what, int64_t *value, struct error *error) {
    if (!expect(lines, what, error))
        return false;
    const char *text = lines->text + strspn(lines->text, " \t");
    return (lines_integer(text, value) && *value >= 0) ||
           lines_refuse(lines, error, "\"%s\" is not %s", lines->text, what);
}

static bool read_box(struct lines *lines, struct head *head, struct error *error) {
    char *word[8];
    char bounds[64];
    snprintf(bounds, sizeof bounds, "%s", lines->text + strlen("ITEM: BOX BOUNDS"));
    bool tilts = strstr(bounds, "xy xz yz") != NULL;
    double tilt[3] = {0};
    char *rest = bounds + (tilts ? strcspn(bounds, "x") + strlen("xy xz yz") : 0);
    for (int d = 0; d < 3; d++) {
        word[d] = strtok_r(rest, " ", &rest);
        head->periodic[d] = word[d] && strcmp(word[d], "pp") == 0;
    }
    for (int d = 0; d < 3; d++) {
        double value[3];
        if (!expect(lines, "a line of box bounds", error))
            return false;
        if (lines_numbers(lines, value, 2 + tilts) != 2 + tilts || value[1] < value[0])
            return lines_refuse(lines, error, "wants the lower and the upper bound of the box%s",
                                tilts ? ", and a tilt" : "");
        head->lower[d] = value[0];
        head->upper[d] = value[1];
        tilt[d] = tilts ? value[2] : 0;
    }
    if (!rows_tilt_of(tilt, &head->tilt))
        return lines_refuse(lines, error, "the box has several tilts; at most one is known");
    head->lower[head->tilt.flow] -= fmin(0, head->tilt.offset); /* the bounds hold the whole cell */
    head->upper[head->tilt.flow] -= fmax(0, head->tilt.offset);
    head->box_given = true;
    return true;
}

/* Checks that vectors are complete or absent: a missing component does not count as 0. */
static bool check_vectors(const struct lines *lines, const struct layout *layout, struct error *error) {
    static const struct {
        unsigned column;
        int first[2]; /* meanings of the first component */
        const char *letters, *names;
    } vectors[] = {
        {ROWS_POSITION, {X, SCALED}, "xyz", "x y z (or xu yu zu, xs ys zs)"},
        {ROWS_VELOCITY, {V, V}, "xyz", "vx vy vz"},
        {ROWS_ANGULAR_VELOCITY, {OMEGA, OMEGA}, "xyz", "omegax omegay omegaz"},
        {ROWS_IMAGE, {IMAGE, IMAGE}, "xyz", "ix iy iz"},
        {ROWS_ROCK_ORIENTATION, {TURN, TURN}, "wijk", "quatw quati quatj quatk (or c_q[1] to c_q[4])"}};
    for (size_t v = 0; v < sizeof vectors / sizeof vectors[0]; v++)
        for (const char *letter = vectors[v].letters; *letter && (layout->present & vectors[v].column);
             letter++) {
            const int k = (int)(letter - vectors[v].letters);
            bool have = false;
            for (int c = 0; c < layout->columns; c++)
                have = have || layout->meaning[c] == vectors[v].first[0] + k ||
                       layout->meaning[c] == vectors[v].first[1] + k;
            if (!have)
                return lines_refuse(lines, error, "there is no column for the %c component among %s", *letter,
                                    vectors[v].names);
        }
    return true;
}

static bool read_layout(struct lines *lines, struct layout *layout, struct error *error) {
    char *word[COLUMNS_MAX + 2];
    int words = lines_words(lines, word, COLUMNS_MAX + 2);
    if (words > COLUMNS_MAX + 2)
        return lines_refuse(lines, error, "there are more than %d columns", COLUMNS_MAX);
    *layout = (struct layout){.columns = words - 2};
    for (int c = 0; c < layout->columns; c++)
        for (size_t k = 0; k < sizeof known_columns / sizeof known_columns[0]; k++)
            if (strcmp(word[c + 2], known_columns[k].name) == 0) {
                layout->meaning[c] = known_columns[k].meaning;
                layout->present |= known_columns[k].column;
            }
    if (!(layout->present & ROWS_POSITION))
        return lines_refuse(lines, error, "there are no columns x y z");
    return check_vectors(lines, layout, error);
}

/* Reads a count. A count too large for the file means a damaged file; without this check the program would
 * run out of memory. */
static bool read_count(struct lines *lines, int64_t *count, struct error *error) {
    return read_integer(lines, "a number of particles", count, error) &&
           ((*count >= 0 && *count <= lines_bytes_most(lines) / 2) ||
            lines_refuse(lines, error, "%" PRId64 " particles cannot be in this file", *count));
}

/* Reads up to the line before the particles. False at the end of the file (no error) or on an error. */
static bool read_head(struct lines *lines, struct head *head, struct error *error) {
    *head = (struct head){.count = -1};
    while (lines_next(lines)) {
        const char *text = lines->text;
        if (strncmp(text, "ITEM: TIMESTEP", 14) == 0) {
            if (!read_integer(lines, "a step", &head->step, error))
                return false;
        } else if (strncmp(text, "ITEM: TIME", 10) == 0) {
            if (!expect(lines, "a time", error) || lines_numbers(lines, &head->time, 1) != 1)
                return lines_refuse(lines, error, "\"%s\" is not a time", lines->text);
        } else if (strncmp(text, "ITEM: UNITS", 11) == 0) {
            if (!expect(lines, "a system of units", error))
                return false;
        } else if (strncmp(text, "ITEM: NUMBER OF ATOMS", 21) == 0) {
            if (!read_count(lines, &head->count, error))
                return false;
        } else if (strncmp(text, "ITEM: BOX BOUNDS", 16) == 0) {
            if (!read_box(lines, head, error))
                return false;
        } else if (strncmp(text, "ITEM: ATOMS", 11) == 0 && head->count >= 0) {
            return (head->box_given || lines_refuse(lines, error, "there is no ITEM: BOX BOUNDS before")) &&
                   read_layout(lines, &head->layout, error);
        } else {
            return lines_refuse(lines, error, "\"%.60s\" is not what a LAMMPS dump holds here", text);
        }
    }
    if (lines->damaged)
        lines_refuse(lines, error, "the file does not end here");
    return false;
}

/* Stores a whole number of 32 bits, `least` or more. */
static bool store_whole(double value, int64_t least, int32_t *to) {
    int64_t whole;
    if (!lines_whole(value, least, INT32_MAX, &whole))
        return false;
    *to = (int32_t)whole;
    return true;
}

static bool store(const struct head *head, struct rows *rows, size_t row, int meaning, double value) {
    switch (meaning) {
    case ID:
        return lines_whole(value, 1, LINES_WHOLE_MAX, &rows->id[row]);
    case TYPE:
        if (!store_whole(value, 1, &rows->material[row]))
            return false;
        rows->material[row]--;
        return true;
    case RADIUS:
        rows->radius[row] = value;
        return value >= 0;
    case DIAMETER:
        rows->radius[row] = value / 2;
        return value >= 0;
    case MASS:
        rows->mass[row] = value;
        return value >= 0;
    case KIND:
        return store_whole(value, 0, &rows->kind[row]);
    case BODY:
        return lines_whole(value, -1, LINES_WHOLE_MAX, &rows->body[row]);
    case BODY_PART:
        return store_whole(value, 0, &rows->body_part[row]);
    case BODY_MASS:
        rows->body_mass[row] = value;
        return value >= 0;
    case ROCK_SHAPE:
        return store_whole(value, -1, &rows->rock_shape[row]);
    default:
        break;
    }
    int d = (meaning - X) % 3;
    if (meaning >= TURN)
        rows->rock_orientation[row][meaning - TURN] = value;
    else if (meaning >= IMAGE)
        return store_whole(value, -INT32_MAX, &rows->image[row][d]);
    else if (meaning >= OMEGA)
        rows->angular_velocity[row][d] = value;
    else if (meaning >= V)
        rows->velocity[row][d] = value;
    else if (meaning >= SCALED)
        rows->position[row][d] = head->lower[d] + value * (head->upper[d] - head->lower[d]);
    else
        rows->position[row][d] = value;
    return true;
}

static bool read_rows(struct lines *lines, const struct head *head, struct rows *rows, struct error *error) {
    char *word[COLUMNS_MAX];
    const struct rows_tilt *tilt = &head->tilt;
    bool scaled = false;
    for (int c = 0; c < head->layout.columns; c++)
        scaled = scaled || head->layout.meaning[c] == SCALED;
    for (size_t row = 0; row < rows->count; row++) {
        if (!expect(lines, "a particle", error))
            return false;
        int words = lines_words(lines, word, COLUMNS_MAX);
        if (words != head->layout.columns)
            return lines_refuse(lines, error, "has %s%d columns instead of %d",
                                words > COLUMNS_MAX ? "at least " : "", words, head->layout.columns);
        for (int c = 0; c < words; c++) {
            double value = 0;
            if (head->layout.meaning[c] == SKIP)
                continue;
            if (!lines_real(word[c], &value) || !store(head, rows, row, head->layout.meaning[c], value))
                return lines_refuse(lines, error, "column %d: \"%s\" is no value for it", c + 1, word[c]);
        }
        if (scaled && tilt->offset != 0)
            rows->position[row][tilt->flow] +=
                tilt->offset * (rows->position[row][tilt->gradient] - head->lower[tilt->gradient]) /
                (head->upper[tilt->gradient] - head->lower[tilt->gradient]);
    }
    return true;
}

/* Skips the particles of a frame. */
static bool skip_rows(struct lines *lines, const struct head *head, struct error *error) {
    for (int64_t row = 0; row < head->count; row++)
        if (!expect(lines, "a particle", error))
            return false;
    return true;
}

bool dump_frames(const char *path, uint64_t *frames, struct error *error) {
    struct lines lines;
    struct head head;
    *frames = 0;
    if (!lines_open(&lines, path, error))
        return false;
    while (read_head(&lines, &head, error) && skip_rows(&lines, &head, error))
        (*frames)++;
    lines_close(&lines);
    return error->kind == ERROR_NONE;
}

bool dump_read(const char *path, int64_t frame, struct rows *rows, struct error *error) {
    *rows = (struct rows){0};
    uint64_t frames = 0;
    if (frame < 0 && !dump_frames(path, &frames, error))
        return false;
    int64_t wanted = frame < 0 ? frame + (int64_t)frames : frame;
    struct lines lines;
    struct head head;
    if (!lines_open(&lines, path, error))
        return false;
    int64_t seen = 0;
    bool found = false, good = true;
    while (good && !found && wanted >= 0 && read_head(&lines, &head, error)) {
        found = seen++ == wanted;
        good = found || skip_rows(&lines, &head, error);
    }
    if (!found)
        error_set(error, ERROR_USER, "%s: has no frame %" PRId64, path, frame);
    if (found) {
        rows_create(rows, (size_t)head.count, head.layout.present);
        rows->step = (uint64_t)head.step;
        rows->time = head.time;
        rows->box_given = rows->periodic_given = true;
        memcpy(rows->lower, head.lower, sizeof head.lower);
        memcpy(rows->upper, head.upper, sizeof head.upper);
        rows->tilt = head.tilt;
        memcpy(rows->periodic, head.periodic, sizeof head.periodic);
        good = read_rows(&lines, &head, rows, error);
    }
    lines_close(&lines);
    if (!good || !found)
        rows_free(rows);
    return good && found;
}
