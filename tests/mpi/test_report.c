/* SPDX-License-Identifier: BSD-3-Clause */
/* The report and the progress lines.
 * Ranks: 1 2 4 */
#include "tests/test.h"

#include "base/memory.h"
#include "base/version.h"
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

enum { STAGES = 4 };
static const char *const names[STAGES] = {"setup", "advance", "comm", "other"};

static void gather(struct report *report, const struct comm *comm) {
    struct timers timers = {0};
    for (int s = 0; s < STAGES; s++)
        timers.stage[timer_register(&timers, names[s], "", 0)].seconds = s + comm->rank;
    struct timers before = timers;
    before.stage[0].seconds = 10 + comm->rank;
    struct report_mine mine = {.timers = &timers,
                               .timers_setup = &before,
                               .ghosts = (uint64_t)(10 + comm->rank),
                               .messages = (uint64_t)(3 * comm->rank),
                               .bytes = (uint64_t)(1000 * comm->rank),
                               .work = 1 + comm->rank,
                               .waiting = 2,
                               .seconds = 4 - (comm->rank > 0),
                               .seconds_setup = comm->rank};
    report_gather(report, comm, &mine);
}

static struct report example(const struct comm *comm) {
    struct report report;
    report_create(&report, comm->size);
    report.steps = 200;
    report.particles = 1000000;
    report.threads = 3;
    snprintf(report.index, sizeof report.index, "hgrid");
    snprintf(report.stopped, sizeof report.stopped, "a \"guard\"\n\\");
    report.levels = 2;
    report.level[1] = (struct report_level){.cell = INFINITY, .cells = 5, .particles = 6, .radius_max = 0.5};
    report.seed = UINT64_MAX;
    report.pairs = 123456789;
    report.rebuild_messages = 77;
    report.rebuild_bytes = 7700;
    report.memory_held = 770000;
    report.insertions = 2;
    report.insertion = memory_allocate_zero(2, sizeof *report.insertion, "report");
    report.insertion[0] = (struct report_insertion){.name = "rain", .asked = 2000, .placed = 1800};
    report.insertion[1] = (struct report_insertion){.name = "hail", .asked = 2000, .placed = 1799};
    gather(&report, comm);
    return report;
}

static void ranks_are_gathered(void **state) {
    struct team *team = *state;
    struct report report = example(&team->comm);
    int size = team->comm.size;
    for (int r = 0; r < size; r++)
        team_expect(team,
                    report.ghosts[r] == (uint64_t)(10 + r) && report.bytes[r] == (uint64_t)(1000 * r) &&
                        report.messages[r] == (uint64_t)(3 * r),
                    "rank %d", r);
    for (int s = 0; s < STAGES; s++) {
        const struct report_stage *stage = &report.stage[s];
        team_expect(team, stage->min == s && stage->max == s + size - 1, "stage %d", s);
        team_expect(team, fabs(stage->mean - (s + (size - 1) / 2.0)) < 1e-12, "mean of %d", s);
    }
    team_expect(team, report.setup_stage[0].min == 10 && report.setup_stage[0].max == 9 + size, "the set-up");
    team_expect(team, report.seconds == 4 && report.seconds_setup == size - 1, "seconds %g", report.seconds);
    team_expect(team, fabs(report.imbalance - 2.0 * size / (size + 1)) < 1e-12, "imbalance %g",
                report.imbalance);
    team_expect(team, fabs(report_pupcs(&report) - 5e7 / (3.0 * size)) < 1, "%g updates",
                report_pupcs(&report));
    team_expect(team, report_speed(&report) == 5e7, "speed %g", report_speed(&report));
    report.particle_steps = 4e6; /* the number of particles changed meanwhile */
    team_expect(team, report_speed(&report) == 1e6, "speed %g", report_speed(&report));
    team_expect(team, report.memory_peak > 1 << 20, "peak memory %d", (int)report.memory_peak);
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
        static const char *const keys[] = {
            "\"steps\": 200,",
            "\"particles\": 1000000,",
            "\"ranks\": ",
            "\"threads\": 3,",
            "\"threads_working\": 3,",
            "\"index\": \"hgrid\",",
            "\"levels\": [",
            "\"cells\": 5, \"particles\": 6",
            "\"ghosts\": [10",
            "\"bytes\": [0",
            "\"messages\": [0",
            "\"rebuild_messages\": 77,",
            "\"rebuild_bytes\": 7700,",
            "\"memory_held\": 770000,",
            "\"pupcs\": ",
            "\"imbalance\": ",
            "{\"name\": \"rain\", \"asked\": 2000, \"placed\": 1800, \"lost\": 0},",
            "\"stages\": {",
            "\"particle_steps_per_second\": 50000000,",
            "\"pairs\": 123456789,",
            "\"contacts\": ",
            "\"rebuilds\": ",
            "\"bytes_per_particle\": ",
            "\"seed\": 18446744073709551615,",
            "\"version\": \"",
            "\"git_revision\": \"",
            "\"compiler\": \"",
            "\"flags\": \"",
            "\"host\": \"",
            "\"cell_size\": null",
            "\"stopped\": \"a \\\"guard\\\"\\u000a\\\\\""};
        for (size_t k = 0; k < sizeof keys / sizeof keys[0]; k++)
            team_expect(team, strstr(text, keys[k]) != NULL, "%s is not in\n%s", keys[k], text);
        for (int s = 0; s < STAGES; s++) {
            char key[64];
            snprintf(key, sizeof key, "\"%s\": {\"min\": %d, \"mean\": ", names[s], s);
            team_expect(team, strstr(text, key) != NULL, "%s is not in\n%s", key, text);
        }
        memory_free(text);
    }
    report_destroy(&report);
    folder_remove(&folder, &team->comm);
    team_finish(team);
}

static void the_table_is_readable(void **state) {
    struct team *team = *state;
    struct report report = example(&team->comm);
    if (team->comm.rank == 0) {
        char *text = NULL;
        size_t size;
        FILE *memory = open_memstream(&text, &size);
        report.threads_working = 1.5;
        report.choices = 7;
        snprintf(report.choice, sizeof report.choice, "hgrid, 3 levels");
        report_print(&report, memory);
        fclose(memory);
        const char *const parts[] = {"200 steps of 1,000,000 particles",
                                     "123,456,789 pairs",
                                     "index hgrid, law ",
                                     "1.5 threads at work on average",
                                     "index chosen: hgrid, 3 levels (choice 7); predicted 0 ms",
                                     team->comm.size > 1 ? " ghosts; a rank and step sends "
                                                         : "1 rank x 3 threads\n",
                                     "contact",
                                     "level",
                                     "insertion rain: 1,800 of the 2,000 particles due are placed\n",
                                     "insertion hail: 1,799 of the 2,000 particles due are placed: NOTE"};
        for (size_t k = 0; k < sizeof parts / sizeof parts[0]; k++)
            team_expect(team, strstr(text, parts[k]) != NULL, "%s is not in\n%s", parts[k], text);
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

TEAM_MAIN(report, team_case(ranks_are_gathered), team_case(json_holds_all_keys),
          team_case(the_table_is_readable), team_case(a_file_that_does_not_fit_leaves_the_old_one),
          team_case(durations), team_case(progress_is_quiet_unless_asked))
