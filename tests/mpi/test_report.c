/* SPDX-License-Identifier: BSD-3-Clause */
/* Reports, and the progress lines.
 * Ranks: 1 2 4 */
#include "tests/test.h"

#include "base/memory.h"
#include "folder.h"
#include "base/file.h"
#include "data/observe/progress.h"
#include "data/observe/report_json.h"
#include "data/observe/report_print.h"
#include "team.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <signal.h>
#include <unistd.h>

/* A report of few rows, one of each kind, about this: */
struct report_source {
    const struct comm *comm;
    double seconds;
    uint64_t pairs;
};

static uint64_t pairs(const struct report_source *of, int k) {
    (void)k;
    return of->pairs;
}

static uint64_t seed(const struct report_source *of, int k) {
    (void)of;
    (void)k;
    return UINT64_MAX;
}

static uint64_t ranks(const struct report_source *of, int k) {
    (void)k;
    return (uint64_t)of->comm->size;
}

static uint64_t ghosts(const struct report_source *of, int k) {
    (void)k;
    return (uint64_t)(10 + of->comm->rank);
}

/* A collective getter. */
static double seconds(const struct report_source *of, int k) {
    double most = of->seconds;
    (void)k;
    comm_max(of->comm, &most, 1);
    return most;
}

static bool alone(const struct report_source *of, int k) {
    (void)k;
    return of->comm->size == 1;
}

static const char *stopped(const struct report_source *of, int k, char *buffer, size_t room) {
    (void)of;
    (void)k;
    snprintf(buffer, room, "a \"%s\"\n\\", "guard");
    return buffer;
}

static const char *hidden(const struct report_source *of, int k, char *buffer, size_t room) {
    (void)of;
    (void)k;
    (void)buffer;
    (void)room;
    return "on the terminal";
}

static int two(const struct report_source *of) {
    (void)of;
    return 2;
}

static int none(const struct report_source *of) {
    (void)of;
    return 0;
}

static double cell(const struct report_source *of, int k) {
    (void)of;
    return k == 0 ? INFINITY : 0.25;
}

static const char *name(const struct report_source *of, int k, char *buffer, size_t room) {
    (void)of;
    (void)buffer;
    (void)room;
    return k == 0 ? "rain" : "hail";
}

/* Of the second entry, the sum over ranks of their numbers from 1 on; of the first, 0. */
static uint64_t placed(const struct report_source *of, int k) {
    int64_t sum = k * (of->comm->rank + 1);
    comm_sum_int(of->comm, &sum, 1);
    return (uint64_t)sum;
}

static const struct report_row why_rows[] = {
    {.name = "why", .text = name}, {.name = "secret", .text = hidden, .terminal = true}, {0}};
static const struct report_row level_rows[] = {
    {.name = "name", .text = name}, {.name = "cell", .real = cell}, {.name = "placed", .count = placed}, {0}};
static const struct report_row rows[] = {
    {.name = "pairs", .count = pairs},
    {.name = "seed", .count = seed},
    {.name = "ranks", .count = ranks, .print = "rank|ranks"},
    {.name = "seconds", .real = seconds, .print = "%.1f", .times = 1e3},
    {.name = "secret", .text = hidden, .terminal = true},
    {.name = "alone", .flag = alone, .print = "alone|together"},
    {.name = "stopped", .text = stopped},
    {.name = "ghosts", .each = ghosts},
    {.name = "choice", .shape = REPORT_GROUP, .rows = why_rows},
    {.name = "no_choice", .shape = REPORT_GROUP, .rows = why_rows, .entries = none, .optional = true},
    {.name = "levels", .shape = REPORT_LIST, .rows = level_rows, .entries = two},
    {.name = "no_levels", .shape = REPORT_LIST, .rows = level_rows, .entries = none},
    {.name = "stages", .shape = REPORT_STAGES, .rows = level_rows, .entries = two},
    {0}};

static struct report example(const struct comm *comm) {
    struct report report;
    const struct report_source source = {.comm = comm, .seconds = comm->rank, .pairs = 123456789};
    report_make(&report, rows, comm, &source);
    return report;
}

static void getters_make_a_report(void **state) {
    struct team *team = *state;
    struct report report = example(&team->comm);
    int size = team->comm.size;
    const struct report_table *levels = report_list(&report, "levels");
    const struct report_column *column;
    team_expect(team, report_find(&report.table, "ghosts", 6, &column) != NULL, "no ghosts");
    for (int r = 0; r < size; r++)
        team_expect(team, column->value[r].count == (uint64_t)(10 + r), "rank %d", r);
    team_expect(team, report_number(&report, "seconds") == size - 1, "the seconds");
    team_expect(team, report_number(&report, "pairs") == 123456789, "the pairs");
    team_expect(team, report_number(&report, "alone") == (size == 1), "alone");
    team_expect(team, strcmp(report_text(&report, "choice.why"), "rain") == 0, "the group");
    team_expect(team, levels->entries == 2, "%d levels", levels->entries);
    team_expect(team, report_list_number(levels, 0, "placed") == 0, "the first level");
    team_expect(team, report_list_number(levels, 1, "placed") == size * (size + 1) / 2, "the second level");
    team_expect(team, strcmp(report_list_text(levels, 1, "name"), "hail") == 0, "its name");
    team_expect(team, report_find(&report.table, "nothing", 7, &column) == NULL, "a row of no name");
    team_expect(team, report_holds(&report.table, 0, "levels") && !report_holds(levels, 0, "placed"), "held");
    team_expect(team, !report_holds(&report.table, 0, "no_levels"), "held");
    report_destroy(&report);
    team_finish(team);
}

static char *read_text(const char *path) {
    char *text = memory_allocate_zero(1 << 16, 1, "test");
    FILE *file = fopen(path, "r");
    if (file && fread(text, 1, (1 << 16) - 1, file) == 0)
        text[0] = '\0';
    if (file)
        fclose(file);
    return text;
}

/* A reader of JSON that knows just enough to check that a text is JSON: returns the end of the value, NULL if
 * the text is no value. */
static const char *skip_value(const char *c);

static const char *skip_space(const char *c) {
    return c + strspn(c, " \n\t\r");
}

static const char *skip_string(const char *c) {
    if (*c++ != '"')
        return NULL;
    while (*c && *c != '"' && (unsigned char)*c >= 0x20)
        c += *c == '\\' && c[1] ? 2 : 1;
    return *c == '"' ? c + 1 : NULL;
}

static const char *skip_members(const char *c, char end, bool keys) {
    c = skip_space(c + 1);
    if (*c == end)
        return c + 1;
    for (;;) {
        if (keys) {
            c = skip_string(skip_space(c));
            if (!c || *(c = skip_space(c)) != ':')
                return NULL;
            c++;
        }
        c = skip_value(c);
        if (!c)
            return NULL;
        c = skip_space(c);
        if (*c == end)
            return c + 1;
        if (*c++ != ',')
            return NULL;
    }
}

static const char *skip_value(const char *c) {
    static const char *const words[] = {"true", "false", "null"};
    c = skip_space(c);
    if (*c == '{')
        return skip_members(c, '}', true);
    if (*c == '[')
        return skip_members(c, ']', false);
    if (*c == '"')
        return skip_string(c);
    for (int k = 0; k < 3; k++)
        if (strncmp(c, words[k], strlen(words[k])) == 0)
            return c + strlen(words[k]);
    char *end;
    if (strspn(c, "-0123456789") == 0)
        return NULL;
    strtod(c, &end);
    return end == c ? NULL : end;
}

static void json_holds_all_keys(void **state) {
    struct team *team = *state;
    struct folder folder;
    struct error error = {0};
    folder_make(&folder, &team->comm);
    struct report report = example(&team->comm);
    if (team->comm.rank == 0) {
        char path[FOLDER_MAX + 64];
        team_expect(team, report_write_json(&report, folder_file(&folder, "report.json", path), &error), "%s",
                    error.text);
        char *text = read_text(path);
        const char *end = skip_value(text);
        team_expect(team, end && *skip_space(end) == '\0', "this is not JSON:\n%s", text);
        static const char *const keys[] = {"{\n  \"pairs\": 123456789,\n",
                                           "\n  \"seed\": 18446744073709551615,\n",
                                           "\n  \"ranks\": ",
                                           "\n  \"seconds\": ",
                                           "\n  \"alone\": ",
                                           "\n  \"stopped\": \"a \\\"guard\\\"\\u000a\\\\\",\n",
                                           "\n  \"ghosts\": [10",
                                           "\n  \"choice\": {\"why\": \"rain\"},\n",
                                           "\n  \"levels\": [\n    {\"name\": \"rain\", \"cell\": null, "
                                           "\"placed\": 0},\n    {\"name\": \"hail\", \"cell\": 0.25, ",
                                           "}\n  ],\n  \"no_levels\": [],\n",
                                           "\n  \"stages\": {\n    \"rain\": {\"cell\": null, \"placed\": "
                                           "0},\n    \"hail\": {\"cell\": 0.25, "};
        for (size_t k = 0; k < sizeof keys / sizeof keys[0]; k++)
            team_expect(team, strstr(text, keys[k]) != NULL, "%s is not in\n%s", keys[k], text);
        team_expect(team, !strstr(text, "secret") && !strstr(text, "no_choice"), "too much in\n%s", text);
        memory_free(text);
    }
    report_destroy(&report);
    folder_remove(&folder, &team->comm);
    team_finish(team);
}

static void lines_are_printed(void **state) {
    struct team *team = *state;
    static const struct report_line lines[] = {
        {.text = "{pairs} pairs on {ranks}, {alone}, in {seconds:6} ms; {choice.why:-6}|{secret}\n"},
        {.text = "never\n", .when = "no_levels"},
        {.text = "{stopped}\n", .when = "stopped"},
        {.text = "{#}: {name:6} has {placed}\n", .list = "levels", .heading = "{pairs} above\n"},
        {.text = "only {name}\n", .list = "levels", .only = "placed"},
        {.text = "never\n", .list = "no_levels", .heading = "never\n"},
        {0}};
    struct report report = example(&team->comm);
    int size = team->comm.size;
    if (team->comm.rank == 0) {
        char *text = NULL, wanted[400];
        size_t room;
        FILE *memory = open_memstream(&text, &room);
        report_print(&report, lines, memory);
        fclose(memory);
        snprintf(wanted, sizeof wanted,
                 "123,456,789 pairs on %d rank%s, %s, in %6.1f ms; rain  |on the terminal\n"
                 "a \"guard\"\n\\\n123,456,789 above\n0:   rain has 0\n1:   hail has %d\nonly hail\n",
                 size, size == 1 ? "" : "s", size == 1 ? "alone" : "together", 1e3 * (size - 1),
                 size * (size + 1) / 2);
        team_expect(team, strcmp(text, wanted) == 0, "these are the lines:\n%s", text);
        free(text);
    }
    report_destroy(&report);
    team_finish(team);
}

static void a_file_that_does_not_fit_leaves_the_old_one(void **state) {
    struct team *team = *state;
    struct folder folder;
    struct error error = {0};
    folder_make(&folder, &team->comm);
    struct report report = example(&team->comm);
    if (team->comm.rank == 0) {
        char path[FOLDER_MAX + 64];
        folder_file(&folder, "report.json", path);
        team_expect(team, report_write_json(&report, path, &error), "%s", error.text);
        int64_t size = file_size(path);
        struct rlimit limit, small;
        getrlimit(RLIMIT_FSIZE, &limit);
        signal(SIGXFSZ, SIG_IGN);
        small = limit;
        small.rlim_cur = 100;
        setrlimit(RLIMIT_FSIZE, &small);
        team_expect(team, !report_write_json(&report, path, &error), "it fits");
        setrlimit(RLIMIT_FSIZE, &limit);
        team_expect(team, error.kind == ERROR_SYSTEM && strstr(error.text, "File too large"), "%s",
                    error.text);
        team_expect(team, file_size(path) == size && folder_count(&folder) == 1, "the old one is gone");
        error = (struct error){0};
        team_expect(team, !report_write_json(&report, "/nowhere/report.json", &error), "written to nowhere");
        team_expect(team, strstr(error.text, "/nowhere/report.json") != NULL, "%s", error.text);
    }
    report_destroy(&report);
    folder_remove(&folder, &team->comm);
    team_finish(team);
}

static void durations(void **state) {
    struct team *team = *state;
    static const struct {
        double seconds;
        const char *text;
    } cases[] = {{0, "0:00"},         {59.4, "0:59"},      {59.6, "1:00"},
                 {3599.6, "1:00:00"}, {86399, "23:59:59"}, {360000, "100:00:00"},
                 {-1, "-:--"},        {INFINITY, "-:--"},  {NAN, "-:--"}};
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        char text[32];
        progress_duration(cases[k].seconds, text, sizeof text);
        team_expect(team, strcmp(text, cases[k].text) == 0, "%g s is %s", cases[k].seconds, text);
    }
    team_finish(team);
}

static void progress_text(enum progress_mode mode, char *text, size_t size) {
    struct progress progress;
    struct progress_options options = {.mode = mode};
    FILE *file = tmpfile();
    progress_start(&progress, &options, NULL, file, 100, 300);
    for (uint64_t step = 101; step <= 300; step++)
        progress_update(&progress, step, 1000, 0.5 * (double)step);
    progress_finish(&progress);
    rewind(file);
    size_t length = fread(text, 1, size - 1, file);
    text[length] = '\0';
    fclose(file);
}

static void progress_is_quiet_unless_asked(void **state) {
    struct team *team = *state;
    char text[1 << 14];
    progress_text(PROGRESS_AUTO, text, sizeof text);
    team_expect(team, text[0] == '\0', "AUTO prints into a file at once: %s", text);
    progress_text(PROGRESS_LINES, text, sizeof text);
    int lines = 0;
    for (const char *c = text; *c; c++)
        lines += *c == '\n';
    team_expect(team, lines == 10, "%d lines:\n%s", lines, text);
    team_expect(team, strstr(text, " 50 % 0:00 left, step 200 of 300, t = 100, ") != NULL, "%s", text);
    progress_text(PROGRESS_BAR, text, sizeof text);
    const char *bar = strstr(text, "########] 100 % 0:00 left, step 300 of 300");
    team_expect(team, bar != NULL, "%s", text);
    for (const char *drawn = text; (drawn = strstr(drawn, "\033[K")) != NULL;) { /* the width is not known */
        drawn += strlen("\033[K");
        team_expect(team, strcspn(drawn, "\r") < 80, "a line of %zu columns", strcspn(drawn, "\r"));
    }
    team_expect(team, strcmp(text + strlen(text) - 4, "\r\033[K") == 0, "the bar is left: %s", text);
    team_finish(team);
}

TEAM_MAIN(report, team_case(getters_make_a_report), team_case(json_holds_all_keys),
          team_case(lines_are_printed), team_case(a_file_that_does_not_fit_leaves_the_old_one),
          team_case(durations), team_case(progress_is_quiet_unless_asked))
