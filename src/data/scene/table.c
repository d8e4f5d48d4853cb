/* SPDX-License-Identifier: BSD-3-Clause */
/* Plain tables: a row of numbers a particle, columns apart by blanks, tabs, commas or semicolons; `#` begins
 * a comment. The columns are named by the scene or by a header line ("Radius[m] PosX[m] PosY[m] PosZ[m]"),
 * which has no number in it; units of the header hold where the scene gives none. A row with more or fewer
 * numbers than there are columns is refused: it is not a row of this list. */
#include "data/scene/source_makers.h"
#include "data/scene/scene_shapes.h"
#include "data/scene/scene_text.h"

#include "base/memory.h"
#include "kernel/particles/particles.h"
#include "data/scene/units.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum column {
    COLUMN_SKIP,
    COLUMN_ID,
    COLUMN_RADIUS,
    COLUMN_DIAMETER,
    COLUMN_DENSITY,
    COLUMN_MATERIAL,
    COLUMN_SHAPE,
    COLUMN_X,
    COLUMN_Y,
    COLUMN_Z,
    COLUMN_VX,
    COLUMN_VY,
    COLUMN_VZ,
    COLUMN_WX,
    COLUMN_WY,
    COLUMN_WZ,
    COLUMN_QW,
    COLUMN_QX,
    COLUMN_QY,
    COLUMN_QZ,
    COLUMNS
};

static const struct {
    const char *names; /* the first is the one to use; all in lower case, apart by blanks */
    const char *unit;
} columns[COLUMNS] = {
    [COLUMN_SKIP] = {"skip _ -", ""},
    [COLUMN_ID] = {"id number", ""},
    [COLUMN_RADIUS] = {"radius r rad", "m"},
    [COLUMN_DIAMETER] = {"diameter d", "m"},
    [COLUMN_DENSITY] = {"density rho", "kg/m3"},
    [COLUMN_MATERIAL] = {"material type", ""},
    [COLUMN_SHAPE] = {"shape", ""},
    [COLUMN_X] = {"x posx pos_x position_x", "m"},
    [COLUMN_Y] = {"y posy pos_y position_y", "m"},
    [COLUMN_Z] = {"z posz pos_z position_z", "m"},
    [COLUMN_VX] = {"vx velx vel_x velocity_x", "m/s"},
    [COLUMN_VY] = {"vy vely vel_y velocity_y", "m/s"},
    [COLUMN_VZ] = {"vz velz vel_z velocity_z", "m/s"},
    [COLUMN_WX] = {"omega_x omegax wx angular_velocity_x", "rad/s"},
    [COLUMN_WY] = {"omega_y omegay wy angular_velocity_y", "rad/s"},
    [COLUMN_WZ] = {"omega_z omegaz wz angular_velocity_z", "rad/s"},
    [COLUMN_QW] = {"qw quatw quaternion_w", ""},
    [COLUMN_QX] = {"qx quati quatx quaternion_x", ""},
    [COLUMN_QY] = {"qy quatj quaty quaternion_y", ""},
    [COLUMN_QZ] = {"qz quatk quatz quaternion_z", ""},
};

struct table {
    const struct scene *scene;
    const struct source_options *source;
    int number; /* of the source */
    int width;
    enum column column[SOURCE_COLUMNS_MAX];
    struct units_scale scale[SOURCE_COLUMNS_MAX]; /* to SI */
    struct table_lines lines;
    bool from_scene; /* the columns at hand are those of the scene */
    struct error *error;
};

static bool fail(const struct table *table, const char *format, const char *what) {
    char text[512];
    snprintf(text, sizeof(text), format, what);
    if (table->from_scene) {
        char key[96];
        return scene_fail(table->scene, table->error, source_key(table->number, "columns", key, sizeof(key)),
                          "%s", text);
    }
    if (table->lines.number == 0)
        return error_set(table->error, ERROR_USER, "%.700s: %s", table->source->file, text);
    return error_set(table->error, ERROR_USER, "%.700s:%ld: %s", table->source->file, table->lines.number,
                     text);
}

static bool name_matches(const char *names, const char *word, size_t length) {
    while (*names) {
        size_t one = strcspn(names, " ");
        if (one == length && strncasecmp(names, word, length) == 0)
            return true;
        names += one + (names[one] == ' ');
    }
    return false;
}

/* The unit of a column in brackets: "[mm]", "(mm)". False if it is not one of the column. */
static bool parse_unit(const char *brackets, enum column column, struct units_scale *scale) {
    char unit[64] = "";
    struct units_dimension given, wanted;
    struct units_scale si;
    size_t length = strcspn(brackets + 1, "])");
    if (length >= sizeof(unit))
        return false;
    memcpy(unit, brackets + 1, length);
    return units_parse(unit, scale, &given) && units_parse(columns[column].unit, &si, &wanted) &&
           units_same(&given, &wanted);
}

/* "PosX[mm]": the column and its unit. 0: no such column, -1: wrong unit. */
static int parse_column(const char *word, enum column *column, struct units_scale *scale) {
    size_t length = strcspn(word, "[(");
    *scale = (struct units_scale){1, 0};
    for (int c = 0; c < COLUMNS; c++) {
        if (!name_matches(columns[c].names, word, length))
            continue;
        *column = (enum column)c;
        if (word[length] == '\0')
            return 1;
        return parse_unit(word + length, *column, scale) ? 1 : -1;
    }
    return 0;
}

static const char unit_of_nothing[] = "column '%s' has a unit, but the scene is dimensionless (units: none)";

static bool add_column(struct table *table, const char *word) {
    static const char known[] =
        "id radius diameter density material shape x y z vx vy vz omega_x omega_y omega_z qw qx qy qz skip";
    enum column column;
    struct units_scale scale;
    int found = parse_column(word, &column, &scale);
    char text[400];
    if (found <= 0) {
        snprintf(text, sizeof(text),
                 found ? "column '%.60s': not a unit of it" : "'%.60s' is not a column; known: %s", word,
                 known);
        return fail(table, "%s", text);
    }
    if (strpbrk(word, "[(") && table->scene->units == SCENE_UNITS_NONE && column != COLUMN_SKIP)
        return fail(table, unit_of_nothing, word);
    for (int k = 0; k < table->width; k++)
        if (column != COLUMN_SKIP && table->column[k] == column)
            return fail(table, "column '%s' is there twice", word);
    if (table->width == SOURCE_COLUMNS_MAX)
        return fail(table, "%s", "too many columns");
    table->column[table->width] = column;
    table->scale[table->width++] = scale;
    return true;
}

static bool has_column(const struct table *table, enum column column) {
    for (int k = 0; k < table->width; k++)
        if (table->column[k] == column)
            return true;
    return false;
}

/* A header: a line without a number among its words, or a comment whose words all name columns. */
static bool is_header(const struct table *table, const char *line, bool comment) {
    char *rest = table_lines_words(&table->lines, line), *word, *end;
    enum column column;
    struct units_scale scale;
    while ((word = table_lines_word(&rest))) {
        strtod(word, &end);
        if (comment ? parse_column(word, &column, &scale) == 0 : *end == '\0')
            return false;
    }
    return true;
}

/* Names the columns from words in a line. */
static bool columns_from(struct table *table, const char *line) {
    char *rest = table_lines_words(&table->lines, line), *word;
    while ((word = table_lines_word(&rest)))
        if (!add_column(table, word))
            return false;
    return true;
}

/* Takes the units of a header for the columns that the scene names without one. */
static bool units_from(struct table *table, const char *header) {
    char *rest = table_lines_words(&table->lines, header), *word;
    bool matched = table_lines_count(header) == table->width, open = false, open_at[SOURCE_COLUMNS_MAX];
    for (int k = 0; k < table->width; k++) {
        open_at[k] = columns[table->column[k]].unit[0] && !strpbrk(table->source->column[k], "[(");
        open = open || open_at[k];
    }
    for (int k = 0; (word = table_lines_word(&rest)); k++) {
        const char *brackets = strpbrk(word, "[(");
        if (!brackets || !(matched ? open_at[k] : open))
            continue;
        if (table->scene->units == SCENE_UNITS_NONE)
            return fail(table, unit_of_nothing, word);
        if (!matched)
            return fail(table, "header '%s': not a word for each column; give units in `columns`: radius(mm)",
                        word);
        if (!parse_unit(brackets, table->column[k], &table->scale[k]))
            return fail(table, "column '%s': not a unit of it; `columns` may give one: radius(mm)", word);
    }
    return true;
}

/* Columns of bodies go with bodies, and with each other. */
static bool check_bodies(const struct table *table) {
    const bool shapes = has_column(table, COLUMN_SHAPE), named = table->source->shape[0] != '\0';
    int turns = 0;
    for (int c = COLUMN_QW; c <= COLUMN_QZ; c++)
        turns += has_column(table, (enum column)c);
    if (shapes && table->scene->shapes == NULL)
        return fail(table, "%s", "there is a column of shapes, and the scene has no section bodies");
    if (shapes && named)
        return fail(
            table, "%s",
            "there is a column of shapes, and the source names one (shape), too; allowed: one of both");
    if (turns != 0 && turns != 4)
        return fail(table, "%s", "an orientation has four columns: qw qx qy qz");
    return turns == 0 || shapes || named ||
           fail(table, "%s",
                "there are orientations, and nothing says of what; needed: a column of shapes, or `shape` of "
                "the source");
}

/* Finds the columns: from the scene, a header line, or a comment of column names just before the data. The
 * text is left at the first row. */
static bool find_columns(struct table *table) {
    const char *start = table->lines.at;
    const struct source_options *source = table->source;
    if (!table_lines_next(&table->lines, true))
        return fail(table, "%s", "the file holds no particles");
    const char *line = table->lines.line, *comment = table->lines.comment;
    if (strncmp(line, "ITEM: ", 6) == 0)
        return fail(
            table,
            "this is a LAMMPS dump, not a table; `scree convert %s OUT.data` makes a lammps-data file of it",
            source->file);
    bool header = is_header(table, line, false);
    if (!header) {
        table->lines.at = start;
        table->lines.number = 0;
    }
    char key[96], place[SCENE_PATH_MAX];
    source_key(table->number, "columns", key, sizeof(key));
    scene_place(table->scene, key, place, sizeof(place));
    table->from_scene = true;
    for (int k = 0; k < source->column_count; k++)
        if (!add_column(table, source->column[k]))
            return false;
    table->from_scene = false;
    if (source->column_count == 0 && !header && !comment[0])
        return error_set(table->error, ERROR_USER,
                         "%.700s: %s: is missing, and %.700s has no header line; needed: what each column "
                         "holds, as in [radius, x, y, z]",
                         place, key, source->file);
    if (source->column_count == 0 && !columns_from(table, header ? line : comment))
        return false;
    if (source->column_count > 0 && (header || is_header(table, comment, true)) &&
        !units_from(table, header ? line : comment))
        return false;
    if (has_column(table, COLUMN_RADIUS) == has_column(table, COLUMN_DIAMETER))
        return fail(table, "%s", "one column must be the radius (or the diameter)");
    for (int d = 0; d < table->scene->box.dimension; d++)
        if (!has_column(table, (enum column)(COLUMN_X + d)))
            return fail(table, "no column '%s'", columns[COLUMN_X + d].names);
    return check_bodies(table);
}

/* Stores the shape that a word names; "-": the row stays a sphere. */
static bool store_shape(const struct table *table, struct source_batch *batch, size_t row, const char *word) {
    const struct scene_shapes *shapes = table->scene->shapes;
    char why[400];
    if (strcmp(word, "-") == 0) {
        batch->form[row] = (struct source_row){.shape = -1, .ball = 1, .solid = 1};
        return true;
    }
    const int entry = scene_shapes_find(shapes, word, why, sizeof(why));
    if (entry < 0)
        return fail(table, "%s (or - for a sphere)", why);
    const struct source_form *form = &shapes->entry[entry].form;
    batch->form[row] = (struct source_row){.shape = form->shape, .ball = form->ball, .solid = form->solid};
    return true;
}

/* Stores one value; false if it cannot be. */
static bool store(const struct table *table, struct source_batch *batch, size_t row, int k,
                  const char *word) {
    char *end;
    double value = strtod(word, &end);
    enum column column = table->column[k];
    if (column == COLUMN_SKIP)
        return true;
    if (column == COLUMN_SHAPE)
        return store_shape(table, batch, row, word);
    int material = *end && column == COLUMN_MATERIAL ? scene_material(table->scene, word) : -1;
    char what[200];
    snprintf(what, sizeof(what), "column %d (%.*s): '%.60s'", k + 1, (int)strcspn(columns[column].names, " "),
             columns[column].names, word);
    if (material >= 0) {
        batch->rows.material[row] = material;
        batch->materials_named = true;
        return true;
    }
    if (end == word || *end)
        return fail(table,
                    column == COLUMN_MATERIAL ? "%s is neither a material of the scene nor a number"
                                              : "%s is not a number",
                    what);
    if (!isfinite(value))
        return fail(table, "%s is not finite", what);
    bool whole = value == nearbyint(value) && value >= 1 && value < 9e15;
    if ((column == COLUMN_ID || column == COLUMN_MATERIAL) && !whole)
        return fail(table, "%s is not a whole number from 1", what);
    value = units_convert(value, &table->scale[k]);
    if (column == COLUMN_ID)
        batch->rows.id[row] = (int64_t)value;
    else if (column == COLUMN_MATERIAL)
        batch->rows.material[row] = value > SOURCE_TYPES_MAX ? SOURCE_TYPES_MAX : (int32_t)value - 1;
    else if (column == COLUMN_RADIUS || column == COLUMN_DIAMETER)
        batch->rows.radius[row] = column == COLUMN_RADIUS ? value : value / 2;
    else if (column == COLUMN_DENSITY)
        batch->rows.mass[row] = value; /* made a mass when the radius is known */
    else if (column <= COLUMN_Z)
        batch->rows.position[row][column - COLUMN_X] = value;
    else if (column <= COLUMN_VZ)
        batch->rows.velocity[row][column - COLUMN_VX] = value;
    else if (column <= COLUMN_WZ)
        batch->rows.angular_velocity[row][column - COLUMN_WX] = value;
    else
        batch->rows.orientation[row][column - COLUMN_QW] = value;
    return true;
}

static bool read_row(const struct table *table, struct source_batch *batch, size_t row, char *line) {
    char *word, what[200], *rest = line;
    int width = table_lines_count(line);
    snprintf(what, sizeof(what),
             "%d values where there are %d columns; this is not a row of the list (`rows` ends the list "
             "before it)",
             width, table->width);
    if (width != table->width)
        return fail(table, "%s", what);
    for (int k = 0; (word = table_lines_word(&rest)); k++)
        if (!store(table, batch, row, k, word))
            return false;
    double *radius = &batch->rows.radius[row];
    if (!(*radius > 0))
        return fail(table, "%s", "the radius must be > 0");
    if (has_column(table, COLUMN_DENSITY) && table->scene->box.density == BOX_DENSITY_AREA)
        return fail(table, "%s",
                    "a column of densities is mass over volume, which box.density: area excludes");
    if (has_column(table, COLUMN_DENSITY) && !(batch->rows.mass[row] > 0))
        return fail(table, "%s", "the density must be > 0");
    if (has_column(table, COLUMN_DENSITY))
        batch->rows.mass[row] = particles_sphere_mass(*radius, batch->rows.mass[row]);
    batch->rows.line[row] = (uint32_t)table->lines.number;
    const bool turns = batch->rows.orientation && (!batch->form || batch->form[row].shape > 0);
    return !turns || scene_shapes_may_turn(batch->rows.orientation[row], table->scene->box.dimension) ||
           fail(table, "%s",
                table->scene->box.dimension == 2
                    ? "in two dimensions bodies turn about z alone: qx and qy must be 0, and qw or qz not"
                    : "the orientation is no quaternion: not all of qw qx qy qz may be 0");
}

/* Rows of data from here on, at most as many as the scene wants, and the line of the last. */
static size_t count_rows(const struct table *table, long *last_line) {
    struct table copy = *table;
    size_t count = 0, wanted = (size_t)table->source->rows;
    while ((wanted == 0 || count < wanted) && table_lines_next(&copy.lines, false))
        count++;
    *last_line = copy.lines.number;
    return count;
}

static unsigned wanted_columns(const struct table *table) {
    unsigned wanted = ROWS_POSITION | ROWS_RADIUS | ROWS_LINE;
    for (int k = 0; k < table->width; k++) {
        enum column column = table->column[k];
        wanted |= column == COLUMN_ID ? ROWS_ID : 0;
        wanted |= column == COLUMN_MATERIAL ? ROWS_MATERIAL : 0;
        wanted |= column == COLUMN_DENSITY ? ROWS_MASS : 0;
        wanted |= column >= COLUMN_VX && column <= COLUMN_VZ ? ROWS_VELOCITY : 0;
        wanted |= column >= COLUMN_WX && column <= COLUMN_WZ ? ROWS_ANGULAR_VELOCITY : 0;
        wanted |= column >= COLUMN_QW ? ROWS_ORIENTATION : 0;
    }
    return wanted;
}

static bool read_rows(struct table *table, struct source_batch *batch) {
    char what[80];
    for (int64_t k = 0; k < table->source->skip_rows; k++)
        if (!table_lines_next(&table->lines, false))
            return fail(table, "%s", "the file ends within the rows that are skipped");
    long last_line;
    size_t count = count_rows(table, &last_line);
    snprintf(what, sizeof(what), "the file has %zu rows; `rows` asks for %lld", count,
             (long long)table->source->rows);
    if (count == 0 || count < (size_t)table->source->rows) {
        table->lines.number = last_line;
        return fail(table, "%s", count ? what : "the file holds no particles");
    }
    rows_create(&batch->rows, count, wanted_columns(table));
    if (has_column(table, COLUMN_SHAPE))
        batch->form = memory_allocate_zero(count, sizeof(*batch->form), "bodies of a file");
    for (size_t row = 0; row < count; row++)
        if (!table_lines_next(&table->lines, false) || !read_row(table, batch, row, table->lines.line))
            return false;
    return true;
}

/* Opens the text of a table, up to its columns. */
static bool table_open(struct table *table, char **text, struct error *error) {
    if (!scene_read_text(table->source->file, text, NULL, error))
        return false;
    table_lines_open(&table->lines, *text);
    return find_columns(table);
}

static void table_close(struct table *table, char *text) {
    if (text)
        table_lines_close(&table->lines);
    memory_free(text);
}

bool table_read(const struct scene *scene, int source, struct source_batch *batch, struct error *error) {
    struct table table = {.scene = scene, .source = &scene->source[source], .number = source, .error = error};
    char *text = NULL;
    bool good = table_open(&table, &text, error) && read_rows(&table, batch);
    table_close(&table, text);
    return good;
}

bool table_names_shapes(const struct scene *scene, int source, bool *names, struct error *error) {
    struct table table = {.scene = scene, .source = &scene->source[source], .number = source, .error = error};
    char *text = NULL;
    bool good = table_open(&table, &text, error);
    *names = good && has_column(&table, COLUMN_SHAPE);
    table_close(&table, text);
    return good;
}
