/* SPDX-License-Identifier: BSD-3-Clause */
/* docs/output.md against the program: its tables. tests/app/entries.sh compares them with reports of runs. */
#include "tests/test.h"

#include "engine/run_report.h"
#include "engine/stages.h"
#include "data/observe/describe.h"

#include <stdlib.h>
#include <string.h>

enum { TEXT = 1 << 17 };

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
    const struct describe_from from = {run_report_rows, &stages};
    stages_register_all(&stages);
    char *text = NULL;
    size_t size;
    FILE *in = fmemopen(page, strlen(page), "r"), *out = open_memstream(&text, &size);
    assert_true(in && out);
    bool good = describe_page(in, out, &from, error);
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

TEST_MAIN(describe, cmocka_unit_test(page_is_current), cmocka_unit_test(damaged_pages_are_refused))
