/* SPDX-License-Identifier: BSD-3-Clause */
/* LAMMPS's text files at the edge of what they may hold: comments, numbers out of range, many columns. */
#include "tests/test.h"

#include "base/memory.h"
#include "data/formats/dump.h"
#include "data/formats/lammps_data.h"
#include "base/lines.h"

#include <stdio.h>
#include <string.h>

static const char *const path = "test_lammps.txt";

static void write_text(const char *text) {
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    assert_true(fputs(text, file) >= 0);
    assert_int_equal(fclose(file), 0);
}

typedef bool reader(const char *path, struct rows *rows, struct error *error);

static bool read_dump(const char *name, struct rows *rows, struct error *error) {
    return dump_read(name, 0, rows, error);
}

/* The reader refuses the text, and says so with these words. */
static void refuses(reader *read, const char *text, const char *says) {
    struct rows rows;
    struct error error = {0};
    write_text(text);
    if (read(path, &rows, &error)) {
        rows_free(&rows);
        fail_msg("accepted: %s", text);
    }
    assert_int_equal(error.kind, ERROR_USER);
    if (strstr(error.text, path) != error.text || !strstr(error.text, says))
        fail_msg("\"%s\" instead of \"%s\"", error.text, says);
    assert_null(rows.position);
    remove(path);
}

static void reads(reader *read, const char *text, struct rows *rows) {
    struct error error = {0};
    write_text(text);
    if (!read(path, rows, &error))
        fail_msg("%s", error.text);
    remove(path);
}

#define HEAD "a title\n\n1 atoms\n2 atom types\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n"
#define ATOM "\nAtoms # sphere\n\n1 2 0.2 3 .1 .2 .3\n"

/* A comment may stand alone wherever a line may, indented or not, and behind what a line says. */
static void data_comments(void **state) {
    (void)state;
    static const char *const texts[] = {
        "a title\n  # note\n1 atoms\n2 atom types\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n" ATOM,
        HEAD "\t# note of a length that no other line of this file has\n" ATOM,
        "a title\n#\n1 atoms # so many\n2 atom types#\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n" ATOM,
        HEAD "\nAtoms # sphere\n\n # note\n1 2 0.2 3 .1 .2 .3 # note\n # note\n\n# note\n",
        HEAD "\nAtoms # sphere\n\n1 2 0.2 3 .1 .2 .3\n  # note\nVelocities\n\n # note\n1 0 0 0 0 0 0\n",
    };
    for (size_t k = 0; k < sizeof texts / sizeof texts[0]; k++) {
        struct rows rows;
        reads(lammps_data_read, texts[k], &rows);
        assert_int_equal(rows.count, 1);
        assert_true(rows.position[0][2] == 0.3 && rows.material[0] == 1 && rows.upper[2] == 1);
        rows_free(&rows);
    }
}

static void data_numbers(void **state) {
    (void)state;
    static const char *const cases[][2] = {
        {"1e300 1 0.2 3 .1 .2 .3", "1e+300 is not an id"},
        {"9223372036854775807 1 0.2 3 .1 .2 .3", "is not an id"},
        {"-9223372036854775808 1 0.2 3 .1 .2 .3", "is not an id"},
        {"1.5 1 0.2 3 .1 .2 .3", "1.5 is not an id"},
        {"1 -2147483648 0.2 3 .1 .2 .3", "is not a type (1 ... 2)"},
        {"1 1e300 0.2 3 .1 .2 .3", "1e+300 is not a type"},
        {"1 0 0.2 3 .1 .2 .3", "0 is not a type"},
        {"1 1 0.2 3 .1 .2 .3 0 1e300 0", "1e+300 is not an image flag"},
        {"1 1 0.2 3 .1 .2 .3 0 0.5 0", "0.5 is not an image flag"},
        {"1 1 0.2 3 .1 .2 .3 0 -2147483648 0", "is not an image flag"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        char text[512];
        snprintf(text, sizeof text, HEAD "\nAtoms # sphere\n\n%s\n", cases[k][0]);
        refuses(lammps_data_read, text, cases[k][1]);
        snprintf(text, sizeof text,
                 "a title\n1 atoms\n0 1 xlo xhi\n0 1 ylo yhi\n0 1 zlo zhi\n\nAtoms\n\n%s\n", cases[k][0]);
        refuses(lammps_data_read, text, ": ");
    }
    struct rows rows;
    reads(lammps_data_read, HEAD "\nAtoms\n\n9007199254740992 1 0.2 3 .1 .2 .3 -2147483647 0 2147483647\n",
          &rows);
    assert_true(rows.id[0] == LINES_WHOLE_MAX && rows.image[0][0] == -INT32_MAX &&
                rows.image[0][2] == INT32_MAX);
    rows_free(&rows);
}

#define DUMP                                                                                                 \
    "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp ff\n0 2\n0 2\n0 4\nITEM: ATOMS "

static void dump_numbers(void **state) {
    (void)state;
    static const char *const cases[][2] = {
        {"id type x y z ix\n1 -2147483648 0 0 0 0\n", "for the y component among ix iy iz"},
        {"id type x y z\n1 -2147483648 0 0 0\n", "column 2: \"-2147483648\""},
        {"id type x y z\n1 1e300 0 0 0\n", "column 2: \"1e300\""},
        {"id type x y z\n1e300 1 0 0 0\n", "column 1: \"1e300\""},
        {"id type x y z ix iy iz\n1 1 0 0 0 1e10 0 0\n", "column 6: \"1e10\""},
        {"id x\n1 1\n", "no column for the y component among x y z"},
        {"id x y\n1 1 1\n", "no column for the z component among x y z"},
        {"id y z\n1 1 1\n", "no column for the x component"},
        {"id x y z vx vz\n1 1 1 1 1 1\n", "no column for the y component among vx vy vz"},
        {"id x y z omegaz\n1 1 1 1 1\n", "no column for the x component among omegax"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        char text[512];
        snprintf(text, sizeof text, DUMP "%s", cases[k][0]);
        refuses(read_dump, text, cases[k][1]);
    }
    refuses(read_dump, "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS id xs ys zs\n1 .5 .5 .5\n",
            "no ITEM: BOX BOUNDS");
    struct rows rows;
    reads(read_dump, DUMP "xu ys id z\n0.5 0.25 9 3\n", &rows);
    assert_true(rows.id[0] == 9 && rows.position[0][0] == 0.5 && rows.position[0][1] == 0.5 &&
                rows.position[0][2] == 3);
    rows_free(&rows);
}

/* A dump of so many columns, the last three x y z. */
static char *wide_dump(int columns, int values) {
    char *text = memory_allocate(sizeof DUMP + 16 * (size_t)(columns + values), 1, "test");
    char *end = text + sprintf(text, DUMP);
    for (int c = 0; c < columns; c++)
        end += c < columns - 3 ? sprintf(end, "c_a[%d] ", c) : sprintf(end, "%c ", 'x' + c - (columns - 3));
    *end++ = '\n';
    for (int c = 0; c < values; c++)
        end += sprintf(end, "%d ", c % 7);
    sprintf(end, "\n");
    return text;
}

static void dump_columns(void **state) {
    (void)state;
    struct rows rows;
    char *text = wide_dump(100, 100);
    reads(read_dump, text, &rows);
    assert_true(rows.position[0][0] == 97 % 7 && rows.position[0][1] == 98 % 7 &&
                rows.position[0][2] == 99 % 7);
    rows_free(&rows);
    memory_free(text);
    static const struct {
        int columns, values;
        const char *says;
    } cases[] = {{100, 99, "has 99 columns instead of 100"},
                 {64, 65, "has 65 columns instead of 64"},
                 {1024, 2000, "has at least 1025 columns instead of 1024"},
                 {1025, 1025, "there are more than 1024 columns"}};
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        text = wide_dump(cases[k].columns, cases[k].values);
        refuses(read_dump, text, cases[k].says);
        memory_free(text);
    }
}

/* Scaled coordinates are parts of the box, from its lower corner on; a diameter is two radii. */
static void dump_scaled(void **state) {
    (void)state;
    struct rows rows;
    reads(read_dump,
          "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp ff ff\n-2 2\n1 9\n-5 -4\n"
          "ITEM: ATOMS id type diameter xs ys zs\n7 2 1.5 0.75 0.25 0.5\n",
          &rows);
    assert_int_equal(rows.count, 1);
    assert_true(rows.position[0][0] == 1 && rows.position[0][1] == 3 && rows.position[0][2] == -4.5);
    assert_true(rows.radius[0] == 0.75 && rows.material[0] == 1 && rows.id[0] == 7);
    rows_free(&rows);
}

TEST_MAIN(lammps, cmocka_unit_test(dump_scaled), cmocka_unit_test(data_comments),
          cmocka_unit_test(data_numbers), cmocka_unit_test(dump_numbers), cmocka_unit_test(dump_columns))
