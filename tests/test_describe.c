/* SPDX-License-Identifier: BSD-3-Clause */
/* docs/output.md against the program: its tables, and the keys of report.json. */
#include "tests/test.h"

#include "base/memory.h"
#include "engine/stages.h"
#include "data/observe/describe.h"
#include "data/observe/report_json.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { TEXT = 1 << 17, KEYS = 400, KEY = 128 };

static char *read_text(const char *path) {
    char *text = calloc(TEXT, 1);
    FILE *file = fopen(path, "r");
    assert_non_null(text);
    assert_non_null(file);
    assert_true(fread(text, 1, TEXT - 1, file) < TEXT - 1);
    fclose(file);
    return text;
}

static char *read_page(void) {
    const char *top = getenv("top_srcdir");
    char path[1024];
    snprintf(path, sizeof path, "%s/docs/output.md", top ? top : ".");
    return read_text(path);
}

/* The page with its tables made again; NULL: refused. */
static char *described(char *page, struct error *error) {
    struct timers stages = {0};
    stages_register_all(&stages);
    char *text = NULL;
    size_t size;
    FILE *in = fmemopen(page, strlen(page), "r"), *out = open_memstream(&text, &size);
    assert_true(in && out);
    bool good = describe_page(in, out, &stages, error);
    fclose(in);
    fclose(out);
    if (!good) {
        free(text);
        text = NULL;
    }
    return text;
}

/* The tables of docs/output.md are what the program writes. */
static void page_is_current(void **state) {
    (void)state;
    struct error error = {0};
    char *page = read_page(), *now = described(page, &error);
    if (!now)
        fail_msg("%s", error.text);
    if (strcmp(now, page) != 0)
        fail_msg("docs/output.md has other tables than the program: run `make pages`");
    /* of each table a row that was computed by hand */
    assert_non_null(strstr(page, "| `velocity` | `vx vy vz` | float64 | N × D | m s-1 | each frame | any |"));
    assert_non_null(strstr(page, "| `mass` | `mass` | float64 | N | kg | fixed | any | mass |"));
    assert_non_null(strstr(page, "| `wall_force` | `WALL_fx` `WALL_fy` `WALL_fz` | N | `target`: a wall; "));
    assert_non_null(strstr(page, "- `load`: `ghosts`, `messages`, `bytes`"));
    free(now);
    free(page);
}

static void damaged_pages_are_refused(void **state) {
    (void)state;
    static const char *const pages[][2] = {{"text\n<!-- fields: -->\nno end\n", "end of fields"},
                                           {"<!-- fields: -->\n<!-- end of fields -->\n", "observables"}};
    for (size_t k = 0; k < 2; k++) {
        struct error error = {0};
        char page[100];
        snprintf(page, sizeof page, "%s", pages[k][0]);
        assert_null(described(page, &error));
        assert_int_equal(error.kind, ERROR_USER);
        assert_non_null(strstr(error.text, pages[k][1]));
    }
}

struct keys {
    int count;
    char key[KEYS][KEY];
};

static bool known(const struct keys *keys, const char *key) {
    for (int k = 0; k < keys->count; k++)
        if (strcmp(keys->key[k], key) == 0)
            return true;
    return false;
}

static void add(struct keys *keys, const char *key) {
    if (known(keys, key))
        return;
    assert_true(keys->count < KEYS);
    snprintf(keys->key[keys->count++], KEY, "%s", key);
}

static const char *skip_string(const char *c) {
    for (c++; *c != '"'; c++) {
        assert_true(*c != '\0');
        c += *c == '\\';
    }
    return c + 1;
}

/* Collects the keys of a JSON value, "levels[].cells" and the like; returns where the value ends. */
static const char *collect(const char *c, const char *path, struct keys *keys) {
    c += strspn(c, " \n");
    if (*c == '"')
        return skip_string(c);
    if (*c != '{' && *c != '[')
        return c + strcspn(c, ",]} \n");
    char end = *c == '{' ? '}' : ']';
    for (c++; *(c += strspn(c, " \n,")) != end;) {
        char below[KEY];
        snprintf(below, sizeof below, "%s[]", path);
        if (end == '}') {
            const char *name = c + 1;
            c = skip_string(c);
            snprintf(below, sizeof below, "%s%s%.*s", path, path[0] ? "." : "", (int)(c - 1 - name), name);
            add(keys, below);
            c += strspn(c, " :");
        }
        c = collect(c, below, keys);
    }
    return c + 1;
}

/* A report with all that it may have. */
static void write_report(char path[]) {
    struct error error = {0};
    struct report report;
    report_create(&report, 2);
    struct timers stages = {0};
    stages_register_all(&stages);
    report.stages = stages.stages;
    for (int k = 0; k < stages.stages; k++)
        for (int setup = 0; setup < 2; setup++)
            snprintf(setup ? report.setup_stage[k].name : report.stage[k].name, sizeof report.stage[k].name,
                     "%s", stages.stage[k].name);
    snprintf(report.choice, sizeof report.choice, "hgrid");
    report.levels = report.classes = report.insertions = report.solvers = report.scene_stages = 2;
    report.insertion = memory_allocate_zero(2, sizeof *report.insertion, "insertions");
    int file = mkstemp(path);
    assert_true(file >= 0);
    close(file);
    if (!report_write_json(&report, path, &error))
        fail_msg("%s", error.text);
    report_destroy(&report);
}

/* The keys that the page's last table has a row for. */
static void read_rows(const char *page, struct keys *rows) {
    const char *line = strstr(page, "<!-- report: ");
    assert_non_null(line);
    for (; line; line = strchr(line, '\n')) {
        line++;
        if (strncmp(line, "| `", 3) == 0) {
            char key[KEY];
            snprintf(key, sizeof key, "%.*s", (int)strcspn(line + 3, "`"), line + 3);
            assert_false(known(rows, key));
            add(rows, key);
        }
    }
}

static bool of_all_stages(const char *key) {
    if (strncmp(key, "setup_stages.", 13) == 0)
        return true; /* the page has the names at `stages` */
    return strncmp(key, "stages.", 7) == 0 && strchr(key + 7, '.');
}

static void keys_of_the_report_are_described(void **state) {
    (void)state;
    char path[] = "/tmp/scree-describe-XXXXXX";
    write_report(path);
    char *text = read_text(path), *page = read_page();
    unlink(path);
    struct keys *written = calloc(2, sizeof *written), *rows = written + 1;
    assert_non_null(written);
    collect(text, "", written);
    read_rows(page, rows);
    assert_true(known(written, "levels[].cells") && known(written, "stages.wall.mean"));
    for (int k = 0; k < written->count; k++)
        if (!of_all_stages(written->key[k]) && !known(rows, written->key[k]))
            fail_msg("docs/output.md does not describe %s of report.json", written->key[k]);
    for (int k = 0; k < rows->count; k++)
        if (!known(written, rows->key[k]))
            fail_msg("docs/output.md describes %s, which report.json does not have", rows->key[k]);
    free(written);
    free(page);
    free(text);
}

TEST_MAIN(describe, cmocka_unit_test(page_is_current), cmocka_unit_test(damaged_pages_are_refused),
          cmocka_unit_test(keys_of_the_report_are_described))
