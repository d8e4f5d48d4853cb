/* SPDX-License-Identifier: BSD-3-Clause */
/* Prints the contents of a file, by its kind. Read info.h first. */
#include "data/formats/info.h"

#include "data/formats/checkpoint.h"
#include "data/formats/checkpoint_folder.h"
#include "data/formats/checkpoint_table.h"
#include "base/memory.h"
#include "base/file.h"
#include "data/formats/dump.h"
#include "data/formats/h5.h"
#include "data/formats/h5md_read.h"
#include "data/formats/lammps_data.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <string.h>
#include <zlib.h>

enum { BINS = 10, BAR = 40 };

bool info_kind(const char *path, enum info_kind *kind, struct error *error) {
    static const char hdf5_mark[] = "\211HDF\r\n\032\n";
    char head[4096] = {0};
    *kind = INFO_UNKNOWN;
    const char *waits = file_waits(path);
    if (waits)
        return error_set(error, ERROR_USER, "%s: %s", path, waits);
    gzFile file = gzopen(path, "rb");
    if (!file)
        return error_set(error, ERROR_USER, "%s: cannot be opened: %s", path, strerror(errno));
    int size = gzread(file, head, sizeof head - 1), status = Z_OK;
    const char *why = gzerror(file, &status);
    bool readable = size >= 0;
    if (!readable)
        error_set(error, ERROR_USER, "%s: cannot be read: %s", path,
                  status == Z_ERRNO ? strerror(errno) : why);
    gzclose(file);
    if (size >= 8 && memcmp(head, hdf5_mark, 8) == 0)
        *kind = INFO_H5MD;
    else if (strncmp(head, "scree checkpoint ", 17) == 0)
        *kind = INFO_CHECKPOINT;
    else if (strncmp(head, "ITEM: ", 6) == 0)
        *kind = INFO_LAMMPS_DUMP;
    else if (strstr(head, " atoms") && strstr(head, "xlo xhi"))
        *kind = INFO_LAMMPS_DATA;
    return readable;
}

static void print_columns(const struct rows *rows, FILE *file) {
    fprintf(file, "  fields     ");
    for (int k = 0; k < ROWS_KINDS; k++)
        if (rows_columns(rows) & rows_kinds[k].bit)
            fprintf(file, "%s ", rows_kinds[k].name);
    fprintf(file, "\n");
}

static void print_box(const struct rows *rows, FILE *file) {
    for (int d = 0; rows->box_given && d < rows->dimension; d++)
        fprintf(file, "  %s %c        %.9g ... %.9g%s\n", d == 0 ? "box" : "   ", 'x' + d, rows->lower[d],
                rows->upper[d],
                !rows->periodic_given ? ""
                : rows->periodic[d]   ? ", periodic"
                                      : ", open");
    if (rows->tilt.offset != 0)
        fprintf(file, "  sheared    the image above along %c lies at %.9g along %c\n",
                'x' + rows->tilt.gradient, rows->tilt.offset, 'x' + rows->tilt.flow);
}

/* Prints the numbers of particles by radius, in bins of equal ratio. */
static void print_radii(const struct rows *rows, FILE *file) {
    if (!rows->radius || rows->count == 0)
        return;
    double low = INFINITY, high = 0;
    for (size_t k = 0; k < rows->count; k++) {
        low = fmin(low, rows->radius[k]);
        high = fmax(high, rows->radius[k]);
    }
    fprintf(file, "  radii      %.9g ... %.9g\n", low, high);
    if (!(low > 0) || high <= low * (1 + 1e-9))
        return;
    uint64_t bin[BINS] = {0}, most = 0;
    for (size_t k = 0; k < rows->count; k++) {
        int b = (int)(BINS * (log(rows->radius[k]) - log(low)) / (log(high) - log(low)));
        bin[b < BINS ? b : BINS - 1]++;
    }
    for (int b = 0; b < BINS; b++)
        most = bin[b] > most ? bin[b] : most;
    for (int b = 0; b < BINS; b++) {
        int length = (int)((double)bin[b] / (double)most * BAR + 0.5);
        fprintf(file, "  %12.5g %12" PRIu64 " %.*s\n", low * exp((log(high) - log(low)) * (b + 0.5) / BINS),
                bin[b], length, "########################################");
    }
}

static void print_rows(const struct rows *rows, FILE *file) {
    fprintf(file, "  particles  %" PRIu64 "\n", rows->total);
    print_columns(rows, file);
    print_box(rows, file);
    print_radii(rows, file);
}

/* Prints the names of the observables in a trajectory, each with its number of rows. */
static bool print_observables(const char *path, FILE *file, struct error *error) {
    static const char group[] = "/observables";
    struct h5 h5;
    struct h5_names names = {0};
    if (!h5_open(&h5, path, NULL, false, error))
        return false;
    bool good = !h5_exists(&h5, group) || h5_list(&h5, group, &names, error);
    for (size_t k = 0; good && k < names.count; k++) {
        char value[2 * OUTPUT_NAME_MAX];
        struct h5_shape shape;
        snprintf(value, sizeof value, "%s/%s/value", group, names.name[k]);
        if (h5_exists(&h5, value) && h5_get_shape(&h5, value, &shape, error))
            fprintf(file, "  observable %-24s %" PRIu64 " rows\n", names.name[k], (uint64_t)shape.size[0]);
    }
    memory_free(names.name);
    return h5_close(&h5, error) && good && error->kind == ERROR_NONE;
}

static bool print_h5md(const char *path, FILE *file, struct error *error) {
    uint64_t frames;
    struct rows first, last;
    struct h5md_read_options begin = {.frame = 0}, end = {.frame = -1};
    if (!h5md_read_frames(path, NULL, &frames, error))
        return false;
    fprintf(file, "%s: H5MD\n  frames     %" PRIu64 "\n", path, frames);
    if (frames == 0)
        return true;
    if (!h5md_read(path, &begin, NULL, &first, error))
        return false;
    bool good = h5md_read(path, &end, NULL, &last, error);
    if (good)
        fprintf(file, "  steps      %" PRIu64 " ... %" PRIu64 ", time %.9g ... %.9g\n", first.step, last.step,
                first.time, last.time);
    if (good)
        print_rows(&last, file);
    rows_free(&first);
    rows_free(&last);
    return good && print_observables(path, file, error);
}

static bool print_dump(const char *path, FILE *file, struct error *error) {
    uint64_t frames;
    struct rows rows;
    if (!dump_frames(path, &frames, error))
        return false;
    fprintf(file, "%s: LAMMPS dump\n  frames     %" PRIu64 "\n", path, frames);
    if (frames == 0)
        return true;
    if (!dump_read(path, -1, &rows, error))
        return false;
    fprintf(file, "  last step  %" PRIu64 "\n", rows.step);
    print_rows(&rows, file);
    rows_free(&rows);
    return true;
}

static bool print_data(const char *path, FILE *file, struct error *error) {
    struct rows rows;
    if (!lammps_data_read(path, &rows, error))
        return false;
    fprintf(file, "%s: LAMMPS data, atom style sphere\n", path);
    print_rows(&rows, file);
    rows_free(&rows);
    return true;
}

static bool print_checkpoint(const char *path, const struct comm *comm, FILE *file, struct error *error) {
    struct checkpoint_loaded head;
    struct checkpoint_table table;
    if (!checkpoint_verify(comm, path, error) || !checkpoint_table_read(&table, comm, path, error) ||
        !checkpoint_read_head(comm, path, &head, error))
        return false;
    fprintf(file, "%s: checkpoint, whole\n", path);
    fprintf(file, "  step       %" PRIu64 ", time %.9g, time step %.9g\n", head.numbers.step,
            head.numbers.time, head.numbers.dt);
    fprintf(file, "  particles  %" PRIu64 ", written on %d rank%s, seed %" PRIu64 "\n", head.total,
            head.ranks, head.ranks == 1 ? "" : "s", head.numbers.seed);
    for (int d = 0; d < head.box.dimension; d++)
        fprintf(file, "  %s %c        %.9g ... %.9g%s\n", d == 0 ? "box" : "   ", 'x' + d, head.box.origin[d],
                head.box.origin[d] + head.box.edge[d], head.box.periodic[d] ? ", periodic" : ", open");
    for (int w = 0; w < head.walls; w++)
        fprintf(file, "  wall       %s\n", head.wall[w].name);
    for (int m = 0; m < head.materials; m++)
        fprintf(file, "  material   %s, density %.9g\n", head.material[m].name, head.material[m].density);
    for (size_t k = 0; k < head.lineage.count; k++)
        fprintf(file, "  run        from step %" PRIu64 ", scree %s (%s)\n", head.lineage.run[k].step,
                head.lineage.run[k].version, head.lineage.run[k].revision);
    fprintf(file, "  datasets\n");
    for (int k = 0; k < table.entries; k++)
        fprintf(file, "    %-28s %14" PRIu64 " bytes\n", table.entry[k].name, table.entry[k].bytes);
    checkpoint_loaded_free(&head);
    return true;
}

bool info_print(const char *path, const struct comm *comm, FILE *file, struct error *error) {
    enum info_kind kind;
    if (!info_kind(path, &kind, error))
        return false;
    switch (kind) {
    case INFO_H5MD:
        return print_h5md(path, file, error);
    case INFO_CHECKPOINT:
        return print_checkpoint(path, comm, file, error);
    case INFO_LAMMPS_DATA:
        return print_data(path, file, error);
    case INFO_LAMMPS_DUMP:
        return print_dump(path, file, error);
    default:
        return error_set(error, ERROR_USER,
                         "%s: is none of: H5MD file, checkpoint, LAMMPS data file, LAMMPS dump", path);
    }
}

bool info_folder(const char *folder, const struct comm *comm, FILE *file, struct error *error) {
    static const char *const names[] = {"trajectory.h5", "dump.lammpstrj"};
    char path[FILE_PATH_MAX];
    int found = 0;
    for (size_t k = 0; k <= sizeof names / sizeof names[0]; k++) {
        bool last = k == sizeof names / sizeof names[0];
        if (last ? !checkpoint_find(folder, 0, path)
                 : !file_join(path, folder, names[k], error) || file_size(path) < 0)
            continue;
        if (!info_print(path, comm, file, error))
            return false;
        found++;
    }
    return found > 0 ||
           error_set(error, ERROR_USER,
                     "%s: is a folder without trajectory.h5, dump.lammpstrj or a checkpoint; name a file",
                     folder);
}
