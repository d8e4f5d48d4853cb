/* SPDX-License-Identifier: BSD-3-Clause */
/* scree pack: makes a packing and writes it. One rank works, with threads; others wait. */
#include "front/program/commands.h"
#include "front/program/pack_settle.h"
#include "base/memory.h"
#include "base/timer.h"
#include "base/file.h"
#include "data/formats/h5md.h"
#include "data/formats/lammps_data.h"
#include "data/observe/progress.h"
#include "front/pack/pack.h"
#include <inttypes.h>
#include <string.h>
#include <unistd.h>

/* Seconds between lines of progress without a terminal. */
static const double line_seconds = 5;

/* The request of the command line. */
struct request {
    const struct command_line *line;
    int settings, outputs;
    const char *setting[COMMAND_FILES_MAX];
    const char *output[COMMAND_FILES_MAX];
    struct recipe recipe;
};

/* The progress: on a terminal one line that is overwritten; else a line every few seconds. */
struct progress_line {
    bool terminal, drawn;
    double shown;
    const char *what;
};

/* True if the next line is due. */
static bool show_due(struct progress_line *line) {
    double now = timer_now();
    if (now - line->shown < (line->terminal ? 0.2 : line_seconds))
        return false;
    line->shown = now;
    return true;
}

static void show_text(struct progress_line *line, const char *text) {
    line->drawn = true;
    if (line->terminal)
        fprintf(stderr, "\r\033[K%.*s", progress_columns(stderr), text);
    else
        fprintf(stderr, "%s\n", text);
    fflush(stderr);
}

static void show_sweep(void *context, const struct pack_report *report) {
    char text[PROGRESS_COLUMNS_MAX + 1];
    if (report->packed.sweeps == 0 || !show_due(context))
        return;
    snprintf(text, sizeof text, "sweep %d, largest overlap %.3g of the smaller radius", report->packed.sweeps,
             report->packed.overlap);
    show_text(context, text);
}

static void show_settling(void *context, const struct settle_state *state) {
    char text[PROGRESS_COLUMNS_MAX + 1];
    if (!show_due(context))
        return;
    snprintf(text, sizeof text, "settling: %.2f fall times, speed %.3g, unbalanced force %.3g", state->time,
             state->speed, state->unbalanced);
    show_text(context, text);
}

static void end_progress(const struct progress_line *line) {
    if (line->terminal && line->drawn)
        fprintf(stderr, "\r\033[K");
}

static bool ends_in(const char *path, const char *ending) {
    size_t length = strlen(path), end = strlen(ending);
    return length > end && strcmp(path + length - end, ending) == 0;
}

static bool is_h5md(const char *path) {
    return ends_in(path, ".h5");
}

/* Checks the folder of the output before the work begins. */
static bool folder_holds(const char *path, struct error *error) {
    const char *slash = strrchr(path, '/');
    char folder[FILE_PATH_MAX];
    int length = slash ? (int)(slash - path) + 1 : 2;
    if (snprintf(folder, sizeof folder, "%.*s", length, slash ? path : "./") >= FILE_PATH_MAX)
        return error_set(error, ERROR_USER, "%.60s...: this path is too long", path);
    return access(folder, W_OK | X_OK) == 0 ||
           error_set(error, ERROR_USER, "%s: its folder is not there, or may not be written to", path);
}

/* Sorts the arguments after the law: KEY=VALUE, or an output. Names with a slash before the '=' are files. */
static bool read_request(struct request *request, struct error *error) {
    const struct command_line *line = request->line;
    for (int k = 1; k < line->files; k++) {
        const char *text = line->file[k], *equals = strchr(text, '='), *slash = strchr(text, '/');
        if (equals && (!slash || slash > equals)) {
            request->setting[request->settings++] = text;
            continue;
        }
        request->output[request->outputs++] = text;
        if (!is_h5md(text) && !ends_in(text, ".data") && !ends_in(text, ".lammps"))
            return error_set(
                error, ERROR_USER,
                "command line: %s: the format is not clear from this name (.data or .lammps for LAMMPS data, "
                ".h5 for H5MD); settings read KEY=VALUE",
                text);
        if (!line->overwrite && file_size(text) >= 0)
            return error_set(error, ERROR_USER, "%s: is there already (--overwrite replaces it)", text);
        if (!folder_holds(text, error))
            return false;
    }
    if (request->outputs == 0)
        return error_set(error, ERROR_USER,
                         "command line: scree pack needs a file to write: NAME.data or NAME.h5");
    return recipe_read(&request->recipe, line->file[0], request->setting, request->settings, error);
}

/* Writes the frame by all ranks, as parallel HDF5 requires; rank 0 has all rows, the other ranks have
 * none. */
static bool write_h5md(const struct comm *comm, const char *path, const struct request *request,
                       const struct rows *rows, struct error *error) {
    struct h5md_head head = {.dimensionless = true, .xdmf = true, .seed = request->recipe.scene->seed};
    struct h5md *h5md = NULL;
    struct frame frame;
    frame_from_rows(&frame, rows);
    frame.first = rows->first;
    frame.total = rows->total;
    if (!h5md_open(&h5md, comm, path, &head, -1, error))
        return false;
    bool good = h5md_write_frame(h5md, &frame, error);
    return h5md_close(&h5md, error) && good;
}

static bool write_files(const struct comm *comm, const struct request *request, struct rows *rows,
                        struct error *error) {
    struct rows head = *rows; /* the same on all ranks, except for the arrays */
    unsigned columns = rows_columns(rows);
    comm_broadcast(comm, &columns, sizeof columns);
    comm_broadcast(comm, &head, sizeof head);
    if (comm->rank > 0) {
        rows_create(rows, 0, columns);
        rows->first = rows->total = head.count;
        memcpy(rows->lower, head.lower, sizeof rows->lower);
        memcpy(rows->upper, head.upper, sizeof rows->upper);
        memcpy(rows->periodic, head.periodic, sizeof rows->periodic);
    }
    for (int k = 0; k < request->outputs; k++) {
        if (is_h5md(request->output[k]))
            write_h5md(comm, request->output[k], request, rows, error);
        else if (comm->rank == 0)
            lammps_data_write(request->output[k], rows, error);
        if (!comm_agree(comm, error))
            return false;
    }
    return true;
}

static void print_settled(const struct pack_report *report, const struct settle_state *state) {
    printf("settled in %" PRIu64
           " steps, %.1f times the fall through the container: unbalanced force %.2g, %.2f "
           "contacts a sphere\n",
           state->steps, state->time, state->unbalanced, state->coordination);
    printf("bed: three quarters of the spheres' volume lie below a height of %.6g, at a solid fraction of "
           "%.4f\n",
           report->bed.height, report->bed.fraction);
}

static void print_report(const struct request *request, const struct pack_report *report, size_t count,
                         double seconds) {
    const struct recipe *recipe = &request->recipe;
    const struct packed_report *packed = &report->packed;
    printf("law %s, seed %" PRIu64 ": %zu particles in %s\n", recipe->law->name, recipe->scene->seed, count,
           report->container);
    printf("radii %.6g to %.6g, solid fraction %.4f\n", report->smallest, report->largest, report->fraction);
    if (recipe->broad > 0)
        printf("part of the particles in the broad peak, by number: %g\n", recipe->broad);
    if (packed->started > 0)
        printf("%" PRIu64 " large, %" PRIu64 " small; the small ones began as %" PRIu64 ": %" PRIu64
               " were removed at large ones, %" PRIu64 " at random\n",
               report->kinds[1], report->kinds[0], packed->started, packed->removed, packed->thinned);
    printf("largest overlap %.3g of the smaller radius%s\n", packed->overlap,
           packed->overlap > 0 ? "" : " (none overlap)");
    printf("%d sweeps, %.1f s, at most %.0f bytes a particle\n", packed->sweeps, seconds,
           (double)memory_peak() / (double)(count ? count : 1));
}

/* Makes the packing on rank 0. */
static bool make(const struct comm *comm, const struct request *request, struct rows *rows,
                 struct error *error) {
    struct progress_line line = {.terminal = isatty(STDERR_FILENO), .shown = timer_now()};
    struct pack_hook hook = {.show = show_sweep, .context = &line};
    struct settle_hook settling = {.show = show_settling, .context = &line};
    struct settle_state settled = {0};
    struct pack_report report;
    bool quiet = request->line->quiet, settle = request->recipe.settles;
    if (comm->rank > 0)
        return true;
    if (comm->size > 1 && !quiet)
        fprintf(stderr, "scree: pack works on one rank, with threads; the other %d wait\n", comm->size - 1);
    double began = timer_now();
    bool good =
        pack_make(&request->recipe, quiet ? NULL : &hook, rows, &report, error) &&
        (!settle || pack_settle(&request->recipe, quiet ? NULL : &settling, rows, &report, &settled, error));
    end_progress(&line);
    if (good && !quiet)
        print_report(request, &report, rows->count, timer_now() - began);
    if (good && !quiet && settle)
        print_settled(&report, &settled);
    if (good && settle && !settled.rests)
        fprintf(stderr,
                "scree: warning: the spheres are not at rest after %.0f falls through the container; the "
                "files have their present places\n",
                settled.time);
    fflush(stdout);
    return good;
}

int command_pack(const struct comm *comm, const struct command_line *line, struct error *error) {
    struct request request = {.line = line};
    struct rows rows = {0};
    read_request(&request, error);
    if (comm_agree(comm, error))
        make(comm, &request, &rows, error);
    if (comm_agree(comm, error))
        write_files(comm, &request, &rows, error);
    rows_free(&rows);
    recipe_free(&request.recipe);
    return error->kind;
}
