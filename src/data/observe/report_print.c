/* SPDX-License-Identifier: BSD-3-Clause */
/* The report on the terminal: lines of text with the entries of the report in them. Read report_rows.h first. */
#include "data/observe/report_print.h"
#include "data/observe/report_rows.h"

#include <assert.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT_ROOM = 256 };

/* "1,234,567" */
static void group_digits(uint64_t value, char text[TEXT_ROOM]) {
    char digits[24];
    int length = snprintf(digits, sizeof digits, "%" PRIu64, value), used = 0;
    for (int k = 0; k < length; k++) {
        if (k > 0 && (length - k) % 3 == 0)
            text[used++] = ',';
        text[used++] = digits[k];
    }
    text[used] = '\0';
}

/* The first of two words, "one|other", or the second. */
static void choose_word(const char *words, bool first, char text[TEXT_ROOM]) {
    const char *bar = strchr(words, '|');
    if (first)
        snprintf(text, TEXT_ROOM, "%.*s", (int)(bar - words), words);
    else
        snprintf(text, TEXT_ROOM, "%s", bar + 1);
}

static void show_real(const struct report_row *row, double value, char text[TEXT_ROOM]) {
    snprintf(text, TEXT_ROOM, row->print, row->seen ? row->seen(value) : value);
}

static void show_each(const struct report *report, const struct report_row *row, char text[TEXT_ROOM]) {
    double each = report->steps > 0 ? 1 / ((double)report->steps * report->ranks) : 0;
    uint64_t sum = 0;
    for (int k = 0; k < report->ranks; k++)
        sum += report_row_each(row, report)[k];
    if (row->print)
        show_real(row, (double)sum * each, text);
    else
        group_digits(sum, text);
}

/* The text of a value in the format of its row. The result is `text` or another string. */
static const char *show(const struct report *report, const struct report_row *row, const void *base,
                        char text[TEXT_ROOM]) {
    char word[TEXT_ROOM];
    switch (row->type) {
    case REPORT_COUNT:
        if (row->print)
            show_real(row, (double)report_row_count(row, base), text);
        else
            group_digits(report_row_count(row, base), text);
        return text;
    case REPORT_NUMBER:
        choose_word(row->print, report_row_number(row, base) == 1, word);
        snprintf(text, TEXT_ROOM, "%d %.200s", report_row_number(row, base), word);
        return text;
    case REPORT_REAL:
        show_real(row, report_row_real(row, base), text);
        return text;
    case REPORT_FLAG:
        choose_word(row->print, report_row_flag(row, base), text);
        return text;
    case REPORT_TEXT:
        return report_row_text(row, base, text, TEXT_ROOM);
    default:
        show_each(report, row, text);
        return text;
    }
}

/* Source of the values of a line: the rows, the struct that the rows describe, its number in a list. */
struct source {
    const struct report_row *rows;
    const void *base;
    int number;
};

/* Prints a text, with "{name}" or "{name:width}" replaced by the value of that row, "{#}" by the number. */
static void print_text(const struct report *report, const struct source *source, const char *text,
                       FILE *file) {
    char buffer[TEXT_ROOM];
    while (*text) {
        size_t plain = strcspn(text, "{");
        fprintf(file, "%.*s", (int)plain, text);
        text += plain;
        if (*text == '\0')
            break;
        size_t length = strcspn(++text, ":}");
        int width = text[length] == ':' ? atoi(text + length + 1) : 0;
        const char *value = buffer;
        if (*text == '#') {
            snprintf(buffer, sizeof buffer, "%d", source->number);
        } else {
            const struct report_row *row = report_row_find(source->rows, text, length);
            assert(row);
            value = show(report, row, source->base, buffer);
        }
        fprintf(file, "%*s", width, value);
        text = strchr(text, '}') + 1;
    }
}

/* Stages that took time, and their share of all but the set-up. */
static void print_stages(const struct report *report, FILE *file) {
    const struct report_row *row = report_row_find(report_rows, "stages", strlen("stages"));
    double total = report_stages(report, 0, TIMER_START);
    fprintf(file, "\n  %-10s %10s %10s %10s %7s\n", "seconds", "min", "mean", "max", "share");
    for (int s = 0; s < report->stages; s++) {
        const struct source source = {row->rows, &report->stage[s], s};
        if (report->stage[s].max <= 0)
            continue;
        fprintf(file, "  %-10s", report->stage[s].name);
        print_text(report, &source, " {min:10} {mean:10} {max:10}", file);
        if ((report->stage[s].use & TIMER_START) || total <= 0)
            fprintf(file, " %7s\n", "");
        else
            fprintf(file, " %5.1f %%\n", 100 * report->stage[s].mean / total);
    }
}

static bool stopped(const struct report *report) {
    return report->stopped[0] != '\0';
}

static bool disturbed(const struct report *report) {
    return report->threads_working > 0 && report->threads_working < 0.95 * report->threads;
}

static bool skin_chosen(const struct report *report) {
    return report->skin_auto;
}
static bool many_ranks(const struct report *report) {
    return report->ranks > 1;
}

static bool chosen(const struct report *report) {
    return report->levels > 0 && report->choice[0] != '\0';
}

/* Lines in their order: a text; or, for each entry of a list, a text, with `heading` before the first; or the
 * output of a function. */
struct line {
    const char *text, *list, *heading;
    void (*print)(const struct report *report, FILE *file);
    bool (*shown)(const struct report *report); /* NULL: always */
};

static const struct line lines[] = {
    {.text = "{steps} steps of {particles} particles in {seconds} s ({duration}): "
             "{particle_steps_per_second} particle-steps/s\n"},
    {.text = "  stopped early at step {last_step}: {stopped}\n", .shown = stopped},
    {.text = "  index {index}, law {law}, integrator {integrator}, newton {newton}{reproducible}, {ranks} x "
             "{threads}\n"},
    {.text = "  {threads_working} threads at work on average: other programs used the cores\n",
     .shown = disturbed},
    {.text = "  {pairs} pairs, {contacts} contacts, {rebuilds} rebuilds\n"},
    {.text = "  skin: {skin_factor} times that of the scene, {skin_changes} changes\n", .shown = skin_chosen},
    {.text = "  {bytes_per_particle} bytes a particle, peak memory of a rank {memory_peak} MB\n"},
    {.text = "  {ghosts} ghosts; a rank and step sends {messages} messages, {bytes} bytes; {pupcs} particle "
             "updates/core/s\n"
             "  domain {domain}, imbalance {imbalance}, {sync_share} % of the time for other ranks\n"
             "  sync {sync}\n",
     .shown = many_ranks},
    {.text = "  class {#}: {ghosts} ghosts, {bytes} MB for them\n", .list = "classes", .shown = many_ranks},
    {.text = "\n  index chosen: {index_choice.index} (choice {index_choice.choices}); predicted "
             "{index_choice.predicted_seconds} ms a rebuild, measured {index_choice.measured_seconds} ms\n"
             "  {index_choice.why}\n",
     .shown = chosen},
    {.text = "  {#:-5} {particles:12} {cells:14} {cell_size:14}   {radius_min} ... {radius_max}\n",
     .list = "levels",
     .heading = "\n  level    particles          cells      cell size   radii{unit_of_length}\n"},
    {.print = print_stages},
    {.text = "  {name:-10} {solves:8} {iterations:10} {set_ups:8} {kept:6} {doubtful:8} {residual_worst:9}\n",
     .list = "solvers",
     .heading = "\n  solver       solves iterations  set-ups   kept doubtful  residual\n"},
    {.text = "\n  scree {version} ({git_revision}), {compiler}\n  {flags}\n  {host}, {cpu}\n"},
    {.text = "  insertion {name}: {placed} of the {asked} particles due are placed{note}\n",
     .list = "insertions",
     .heading = "\n"},
    {.text =
         "  stage {name:-12} steps {first:12} ... {last:12}   t = {time:-10} {seconds:8} s, ended by {end}\n",
     .list = "scene_stages",
     .heading = "\n"},
};

static void print_list(const struct report *report, const struct line *line, FILE *file) {
    const struct report_row *row = report_row_find(report_rows, line->list, strlen(line->list));
    const struct source whole = {report_rows, report, 0};
    assert(row);
    for (int k = 0; k < report_row_entries(row, report); k++) {
        const struct source source = {row->rows, report_row_entry(row, report, k), k};
        if (k == 0 && line->heading)
            print_text(report, &whole, line->heading, file);
        print_text(report, &source, line->text, file);
    }
}

void report_print(const struct report *report, FILE *file) {
    const struct source whole = {report_rows, report, 0};
    for (size_t k = 0; k < sizeof lines / sizeof lines[0]; k++) {
        const struct line *line = &lines[k];
        if (line->shown && !line->shown(report))
            continue;
        if (line->print)
            line->print(report, file);
        else if (line->list)
            print_list(report, line, file);
        else
            print_text(report, &whole, line->text, file);
    }
}
