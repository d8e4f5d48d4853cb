/* SPDX-License-Identifier: BSD-3-Clause */
/* Draws the bar, or prints lines. Read progress.h first. */
#include "data/observe/progress.h"

#include "base/memory.h"
#include "base/timer.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

enum { BAR_WIDTH = 30, BAR_LEAST = 8, LEFT_WIDTH = 20, PARTS = 7, PART_MAX = 160 };

/* Seconds between two drawings, and between two lines. */
static const double draw_pause = 0.2, line_pause = 5, line_pause_most = 60;

/* Lines grow rarer with the time that has passed. */
static const double line_pause_part = 0.05;

void progress_duration(double seconds, char *text, size_t size) {
    if (!(seconds >= 0 && seconds < 1e9)) {
        snprintf(text, size, "-:--");
        return;
    }
    long whole = (long)(seconds + 0.5), hours = whole / 3600, minutes = whole / 60 % 60;
    if (hours > 0)
        snprintf(text, size, "%ld:%02ld:%02ld", hours, minutes, whole % 60);
    else
        snprintf(text, size, "%ld:%02ld", minutes, whole % 60);
}

int progress_columns(FILE *file) {
    struct winsize window;
    int width = 80;
    if (ioctl(fileno(file), TIOCGWINSZ, &window) == 0 && window.ws_col > 0)
        width = window.ws_col;
    return width - 1 < PROGRESS_COLUMNS_MAX ? width - 1 : PROGRESS_COLUMNS_MAX;
}

void progress_start(struct progress *progress, const struct progress_options *options,
                    const struct progress_series *series, FILE *file, uint64_t first, uint64_t last) {
    const char *terminal = getenv("TERM");
    bool can_draw = file && isatty(fileno(file)) && !(terminal && strcmp(terminal, "dumb") == 0);
    enum progress_mode mode = options->mode;
    if (mode == PROGRESS_AUTO)
        mode = can_draw ? PROGRESS_BAR : PROGRESS_LINES;
    *progress = (struct progress){.file = file,
                                  .mode = file ? mode : PROGRESS_OFF,
                                  .series = series,
                                  .rare = options->mode == PROGRESS_AUTO,
                                  .first = first,
                                  .last = last,
                                  .step = first,
                                  .began = timer_now()};
    progress->shown = mode == PROGRESS_LINES ? progress->began : 0;
}

/* True if the end is not known, as that of a stage that ends by conditions. */
static bool is_endless(const struct progress *progress) {
    return progress->last - progress->first > (uint64_t)1 << 60;
}

static double fraction_done(const struct progress *progress) {
    if (progress->last <= progress->first)
        return 1;
    return (double)(progress->step - progress->first) / (double)(progress->last - progress->first);
}

/* The parts of a line, the most important part first: percentage and time left, the run of a series, the
 * step, the simulated time, particle-steps per second, memory of rank 0, the last observables. */
static void describe(const struct progress *progress, double now, double time, char part[PARTS][PART_MAX]) {
    double seconds = now - progress->began, done = fraction_done(progress), left = -1;
    const struct progress_series *series = progress->series;
    char remaining[32];
    if (done > 0)
        left = seconds / done * (1 - done + (series ? series->after : 0));
    progress_duration(left, remaining, sizeof remaining);
    if (is_endless(progress)) /* the step comes first, and nobody knows the part that is done */
        snprintf(part[0], PART_MAX, "step %" PRIu64, progress->step);
    else
        snprintf(part[0], PART_MAX, "%3d %% %s left", (int)(100 * done), remaining);
    part[1][0] = '\0';
    if (series && series->runs > 1)
        snprintf(part[1], PART_MAX, ", run %d of %d: %.30s", series->number, series->runs, series->name);
    else if (series)
        snprintf(part[1], PART_MAX, ", %.30s", series->name);
    part[2][0] = '\0';
    if (!is_endless(progress))
        snprintf(part[2], PART_MAX, ", step %" PRIu64 " of %" PRIu64, progress->step, progress->last);
    snprintf(part[3], PART_MAX, ", t = %.4g", time);
    snprintf(part[4], PART_MAX, ", %.3g particle-steps/s", seconds > 0 ? progress->work / seconds : 0);
    snprintf(part[5], PART_MAX, ", %.0f MiB", (double)memory_in_use() / 1048576);
    part[6][0] = '\0';
    if (progress->last_values)
        progress->last_values(progress->context, part[6], PART_MAX);
}

/* Joins the parts as far as they fit into `room` columns; the first part is always there. Returns the
 * length. */
static int join(char part[PARTS][PART_MAX], int room, char *text, size_t size) {
    int length = snprintf(text, size, "%.*s", room, part[0]);
    for (int k = 1; k < PARTS && length + (int)strlen(part[k]) <= room; k++)
        length += snprintf(text + length, size - (size_t)length, "%s", part[k]);
    return length;
}

static void draw_bar(struct progress *progress, double now, double time) {
    char part[PARTS][PART_MAX], text[PARTS * PART_MAX], bar[BAR_WIDTH + 1];
    int columns = progress_columns(progress->file);
    describe(progress, now, time, part);
    int room = is_endless(progress) ? 0 : columns - BAR_LEAST - 3; /* a very narrow terminal has no bar */
    int length = join(part, room < LEFT_WIDTH ? columns : room, text, sizeof text),
        width = is_endless(progress) ? 0 : columns - length - 3;
    width = width > BAR_WIDTH ? BAR_WIDTH : width;
    fputs("\r\033[K", progress->file);
    if (width >= BAR_LEAST) {
        memset(bar, '.', (size_t)width);
        memset(bar, '#', (size_t)(fraction_done(progress) * width));
        fprintf(progress->file, "[%.*s] ", width, bar);
    }
    fprintf(progress->file, "%s", text);
    fflush(progress->file);
    progress->shown = now;
}

/* Plain lines have no limit of width, so each line has all parts. */
static void print_line(struct progress *progress, double now, double time) {
    char part[PARTS][PART_MAX], text[PARTS * PART_MAX];
    int tenths = (int)(10 * fraction_done(progress));
    double pause = line_pause_part * (now - progress->began);
    pause = pause < line_pause ? line_pause : pause > line_pause_most ? line_pause_most : pause;
    bool tenth = !progress->rare && tenths > progress->tenths;
    if (!tenth && now - progress->shown < pause)
        return;
    describe(progress, now, time, part);
    join(part, (int)sizeof text - 1, text, sizeof text);
    fprintf(progress->file, "%s\n", text);
    fflush(progress->file);
    progress->tenths = tenths;
    progress->shown = now;
}

void progress_update(struct progress *progress, uint64_t step, uint64_t particles, double time) {
    if (progress->mode == PROGRESS_OFF)
        return;
    progress->work += (double)(step - progress->step) * (double)particles;
    progress->step = step;
    double now = timer_now();
    if (progress->mode == PROGRESS_LINES)
        print_line(progress, now, time);
    else if (now - progress->shown >= draw_pause || step == progress->last)
        draw_bar(progress, now, time);
}

void progress_finish(struct progress *progress) {
    if (progress->mode == PROGRESS_BAR) {
        fprintf(progress->file, "\r\033[K");
        fflush(progress->file);
    }
    progress->mode = PROGRESS_OFF;
}
