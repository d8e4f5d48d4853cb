#include "observe/progress.h"

#include "core/timer.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { BAR_WIDTH = 30 };

/* Seconds between two drawings. */
static const double draw_pause = 0.2;

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

void progress_start(struct progress *progress, const struct progress_options *options, FILE *file,
                    uint64_t first, uint64_t last) {
    const char *terminal = getenv("TERM");
    bool can_draw = file && isatty(fileno(file)) && !(terminal && strcmp(terminal, "dumb") == 0);
    enum progress_mode mode = options->mode;
    if (mode == PROGRESS_AUTO)
        mode = can_draw ? PROGRESS_BAR : PROGRESS_OFF;
    *progress = (struct progress){.file = file,
                                  .mode = file ? mode : PROGRESS_OFF,
                                  .first = first,
                                  .last = last,
                                  .step = first,
                                  .began = timer_now()};
}

/* "1.23e+07 particle-steps/s", the time left and the simulated time. */
static void describe(const struct progress *progress, double now, double time, char *text, size_t size) {
    double seconds = now - progress->began, done = (double)(progress->step - progress->first);
    double left = done > 0 ? seconds / done * (double)(progress->last - progress->step) : -1;
    char remaining[32];
    progress_duration(left, remaining, sizeof remaining);
    snprintf(text, size, "step %" PRIu64 " of %" PRIu64 ", t = %.4g, %.3g particle-steps/s, %s left",
             progress->step, progress->last, time, seconds > 0 ? progress->work / seconds : 0, remaining);
}

static double fraction_done(const struct progress *progress) {
    if (progress->last <= progress->first)
        return 1;
    return (double)(progress->step - progress->first) / (double)(progress->last - progress->first);
}

static void draw_bar(struct progress *progress, double now, double time) {
    char text[160], bar[BAR_WIDTH + 1];
    describe(progress, now, time, text, sizeof text);
    double fraction = fraction_done(progress);
    int filled = (int)(fraction * BAR_WIDTH);
    memset(bar, '.', BAR_WIDTH);
    memset(bar, '#', (size_t)filled);
    bar[BAR_WIDTH] = '\0';
    fprintf(progress->file, "\r\033[K[%s] %3d %% %s", bar, (int)(100 * fraction), text);
    fflush(progress->file);
    progress->shown = now;
}

static void print_line(struct progress *progress, double now, double time) {
    int tenths = (int)(10 * fraction_done(progress));
    if (tenths <= progress->tenths)
        return;
    char text[160];
    describe(progress, now, time, text, sizeof text);
    fprintf(progress->file, "%3d %% %s\n", 10 * tenths, text);
    fflush(progress->file);
    progress->tenths = tenths;
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
