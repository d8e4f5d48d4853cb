/* SPDX-License-Identifier: BSD-3-Clause */
/* The table of subcommands, their usage, and the short subcommands: run, info, convert. */
#include "front/program/command.h"
#include "front/program/commands.h"
#include "data/formats/checkpoint.h"
#include "engine/run.h"
#include "data/formats/convert.h"
#include "data/formats/info.h"
#include "front/pack/laws.h"
#include "front/picture/polyhedra.h"
#include "front/view/view.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static int run_run(const struct comm *comm, const struct command_line *line, struct error *error);
static int run_info(const struct comm *comm, const struct command_line *line, struct error *error);
static int run_convert(const struct comm *comm, const struct command_line *line, struct error *error);

static const struct command commands[] = {
    {"run", "SCENE.yaml -o DIR", "runs a scene", 1, 1, "output set petsc resume overwrite quiet view paused",
     run_run},
    {"check", "SCENE.yaml",
     "validates a scene and prints what it needs and what a run will cost; writes nothing", 1, 1,
     "set all ranks threads", command_check},
    {"ablate", "SCENE.yaml -o DIR",
     "runs a scene over all indexes, threads and newton settings, or over values of any keys, a table of "
     "times; "
     "with --error over all that has a price in time and in error",
     1, 1,
     "output set overwrite index threads newton steps vary error duration samples repeat members tolerance "
     "judge "
     "mean-from only young",
     command_ablate},
    {"info", "FILE or DIR",
     "tells what is in a trajectory, checkpoint, LAMMPS data file or dump; or one value of a report or table",
     1, 1, "get column row", run_info},
    {"convert", "IN OUT",
     "converts LAMMPS data, dumps and H5MD into each other; checkpoints, too; to .vtp and .pvd the faces of "
     "rocks",
     2, 2, "to frame overwrite", run_convert},
    {"picture", "DIR -o FILE.png",
     "draws a run, or a file of particles, as a picture; FILE.mp4 makes a film, FILE.pov the text for "
     "POV-Ray",
     1, 1, "output overwrite frame colour range bands palette grey cut view size rate bare", command_picture},
    {"report", "DIR -o FILE.html",
     "makes one page of a run or an ablation: figures, plots, pictures, tables, the scene", 1, 1,
     "output overwrite", command_report},
    {"pack", "LAW FILE... [KEY=VALUE...]",
     "makes a packing of spheres: NAME.data for LAMMPS, NAME.h5 for H5MD", 2, COMMAND_FILES_MAX,
     "overwrite quiet", command_pack},
};

enum { COMMANDS = sizeof commands / sizeof commands[0] };

const struct command *command_get(int k) {
    return k >= 0 && k < COMMANDS ? &commands[k] : NULL;
}

const struct command *command_find(const char *name) {
    for (int k = 0; k < COMMANDS; k++)
        if (strcmp(commands[k].name, name) == 0)
            return &commands[k];
    return NULL;
}

bool command_usage(FILE *out, const struct command *command, const char *topic) {
    if (command == NULL) {
        fprintf(out, "scree simulates particles of very different sizes\n\n");
        for (int k = 0; k < COMMANDS; k++)
            fprintf(out, "  scree %-8s %-18s %s\n", commands[k].name, commands[k].arguments,
                    commands[k].summary);
        fprintf(out, "  scree %-8s %-18s %s\n", "help", "[COMMAND | KEY]",
                "a command at length, all keys of a scene, or one key at length");
        fprintf(out, "  scree --version\n\nSeveral ranks: mpirun -n 4 scree run ...\n");
        return true;
    }
    bool packs = command->run == command_pack;
    if (topic && packs)
        return pack_help(out, topic);
    fprintf(out, "scree %s %s: %s\n", command->name, command->arguments, command->summary);
    command_line_flags(out, command);
    if (packs) {
        fprintf(out, "\nLAW is one of these; 'scree help pack LAW' tells its keys:\n");
        pack_help(out, NULL);
    }
    return true;
}

/* Writes the path of the newest undamaged checkpoint of a directory to `path`. Damaged checkpoints are
 * skipped with a message; if all are damaged, the error is that of the newest. */
static bool newest_whole(const struct comm *comm, const char *directory, char path[FILE_PATH_MAX],
                         struct error *error) {
    struct error first = {0};
    for (size_t place = 0;; place++) {
        struct error damage = {0};
        int64_t found = comm->rank == 0 && checkpoint_find(directory, place, path);
        comm_max_int(comm, &found, 1);
        comm_broadcast(comm, path, FILE_PATH_MAX);
        if (!found)
            break;
        if (checkpoint_verify(comm, path, &damage)) {
            if (place > 0 && comm->rank == 0)
                fprintf(stderr, "scree: %s; going on from %s instead\n", first.text, path);
            return true;
        }
        if (damage.kind != ERROR_USER || place == 0)
            first = damage;
        if (damage.kind != ERROR_USER)
            break;
    }
    *error = first;
    return first.kind == ERROR_NONE &&
           error_set(error, ERROR_USER, "%s: holds no checkpoint to resume from", directory);
}

/* The port of --view; -1 with an error. */
static int view_port(const struct command_line *line, struct error *error) {
    char *end;
    long port = line->view ? strtol(line->view, &end, 10) : 0;
    if (line->paused && line->view == NULL)
        error_set(error, ERROR_USER, "command line: --paused goes with --view");
    else if (line->view && (*end != '\0' || port < 0 || port > 65535))
        error_set(error, ERROR_USER, "command line: --view %s: the port must be a number from 1 to 65535",
                  line->view);
    return error->kind == ERROR_NONE ? (int)port : -1;
}

/* Runs a scene, with a live view if one is wanted. */
static int run_viewed(const struct comm *comm, const struct scene *scene, struct run_options *options,
                      const struct command_line *line, struct error *error) {
    struct view *view = NULL;
    struct run_watch watch;
    char page[FILE_PATH_MAX];
    struct view_options shown = {
        .port = view_port(line, error), .paused = line->paused, .directory = line->directory, .page = page};
    bool good = error->kind == ERROR_NONE;
    if (good && line->view) {
        if (comm->rank == 0)
            page_folder("view.html", page, error);
        good = comm_agree(comm, error) && view_open(&view, comm, &shown, error);
    }
    if (view && good) {
        watch = view_watch(view);
        options->watch = &watch;
    }
    int status = good ? run_scene(comm, scene, options, NULL, error) : (int)error->kind;
    view_close(&view);
    return status;
}

static int run_run(const struct comm *comm, const struct command_line *line, struct error *error) {
    char newest[FILE_PATH_MAX] = "";
    if (line->directory == NULL) {
        error_set(error, ERROR_USER, "command line: scree run needs -o DIR for its files");
        return error->kind;
    }
    struct run_options options = {.directory = line->directory,
                                  .resume = line->resume,
                                  .overwrite = line->overwrite,
                                  .quiet = line->quiet};
    if (line->resume && strcmp(line->resume, "last") == 0) {
        if (!newest_whole(comm, line->directory, newest, error))
            return error->kind;
        options.resume = newest;
    }
    struct scene *scene = command_scene(comm, line, NULL, 0, error);
    if (scene == NULL)
        return error->kind;
    int status = run_viewed(comm, scene, &options, line, error);
    scene_free(&scene);
    return status;
}

static bool one_rank(const struct comm *comm, const char *what, struct error *error) {
    if (comm->size > 1)
        error_set(error, ERROR_USER, "command line: scree %s runs on one rank; it was started on %d", what,
                  comm->size);
    return comm->size == 1;
}

int command_lookup(const struct command_line *line, struct error *error) {
    if (line->row && !line->column)
        error_set(error, ERROR_USER, "command line: --row goes with --column NAME");
    else if (line->get && line->column)
        error_set(error, ERROR_USER,
                  "command line: --get reads a report, and --column a table: give one of them");
    else if (line->get)
        lookup_key(line->file[0], line->get, stdout, error);
    else
        lookup_column(line->file[0], line->column, line->row, stdout, error);
    return error->kind;
}

static int run_info(const struct comm *comm, const struct command_line *line, struct error *error) {
    struct stat found;
    if (!one_rank(comm, "info", error))
        return error->kind;
    if (stat(line->file[0], &found) == 0 && S_ISDIR(found.st_mode))
        info_folder(line->file[0], comm, stdout, error);
    else
        info_print(line->file[0], comm, stdout, error);
    return error->kind;
}

static int run_convert(const struct comm *comm, const struct command_line *line, struct error *error) {
    struct convert_options options = {.overwrite = line->overwrite, .one_frame = line->frame != NULL};
    if (!one_rank(comm, "convert", error))
        return error->kind;
    if (line->to == NULL && polyhedra_named(line->file[1])) {
        const struct polyhedra_options rocks = {.frame = line->frame, .overwrite = line->overwrite};
        polyhedra_write(comm, line->file[0], line->file[1], &rocks, error);
        return error->kind;
    }
    if (line->frame) {
        char *end;
        options.frame = strtoll(line->frame, &end, 10);
        if (*end != '\0' || end == line->frame)
            error_set(error, ERROR_USER, "command line: --frame %s: must be a whole number", line->frame);
    }
    if (line->to) {
        options.to = convert_format_find(line->to);
        if (options.to == CONVERT_BY_NAME)
            error_set(error, ERROR_USER,
                      "command line: --to %s: known formats are lammps-data, lammps-dump, h5md, xdmf",
                      line->to);
    }
    if (error->kind == ERROR_NONE)
        convert_file(line->file[0], line->file[1], &options, comm, error);
    return error->kind;
}
