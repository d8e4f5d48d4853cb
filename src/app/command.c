#include "app/command.h"
#include "engine/run.h"
#include "core/memory.h"
#include "formats/convert.h"
#include "formats/info.h"
#include "pack/options.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct flag {
    const char *name; /* as in --name */
    const char *argument, *help;
    const char *only; /* the commands that this row is for; NULL: all that take the flag */
};

static const struct flag flags[] = {
    {"output", "DIR",
     "directory for the files of the run (also -o); exists: refused without --overwrite or --resume", "run"},
    {"output", "DIR", "directory for the tables (also -o); exists: refused without --overwrite", "ablate"},
    {"set", "KEY=VALUE",
     "overrides a key of the scene, e.g. --set index.name=hgrid or --set walls[0].radius=0.2; KEY=~ takes it "
     "out; may be repeated",
     NULL},
    {"resume", "FILE",
     "goes on from a checkpoint, on any number of ranks and threads; 'last' is the newest whole one in the "
     "directory; "
     "what a run wrote there after that step is replaced",
     NULL},
    {"overwrite", NULL,
     "an existing directory is used; files of an earlier run in it, checkpoints too, are deleted", "run"},
    {"overwrite", NULL, "an existing directory is used; tables of an earlier ablate in it are replaced",
     "ablate"},
    {"overwrite", NULL,
     "a file that is there already is replaced; without it, it is kept, and nothing is written",
     "convert pack"},
    {"quiet", NULL, "no notes, no progress, no report and no list of what a resume changes on the terminal",
     NULL},
    {"to", "FORMAT", "lammps-data, lammps-dump, h5md or xdmf; else by the output's name", NULL},
    {"frame", "N", "one frame only, from 0, negative from the end", NULL},
    {"index", "A,B,...", "the indexes to compare; default: all", NULL},
    {"threads", "1,2,...", "the thread counts to compare; default: powers of two up to all cores", NULL},
    {"newton", "on,off", "the newton settings to compare; default: both", NULL},
    {"steps", "N", "steps of each run; default: those of the scene", NULL},
    {"error", NULL,
     "compares settings by time and by error against a reference that is run first: speed_error.csv, "
     "speed_error.svg, and advice",
     NULL},
    {"duration", "T", "with --error: simulated time of each run, s; default: that of the scene", NULL},
    {"samples", "N", "with --error: how often runs are compared; default: 40", NULL},
    {"repeat", "N", "with --error: each run is timed so often, the fastest counts; default: 2", NULL},
    {"members", "N", "with --error: runs that the statistical spread is from; default: 3", NULL},
    {"tolerance", "X", "with --error: relative error that the advice allows; default: 0.01", NULL},
    {"judge", "A,B,...",
     "with --error: columns of the scene's observables, or trajectory, that count; default: those that are "
     "no "
     "energies",
     NULL},
    {"mean-from", "T",
     "with --error: columns are judged by their mean from this time on, s; default: sample by sample", NULL},
};

enum { FLAGS = sizeof flags / sizeof flags[0] };

static int run_run(const struct comm *comm, const struct command_line *line, struct error *error);
static int run_info(const struct comm *comm, const struct command_line *line, struct error *error);
static int run_convert(const struct comm *comm, const struct command_line *line, struct error *error);

static const struct command commands[] = {
    {"run", "SCENE.yaml -o DIR", "runs a scene", 1, 1, "output set resume overwrite quiet", run_run},
    {"check", "SCENE.yaml", "validates a scene and prints what it needs; runs nothing", 1, 1, "set",
     command_check},
    {"ablate", "SCENE.yaml -o DIR",
     "runs a scene over all indexes, threads and newton settings, a table of times; with --error over all "
     "that "
     "has a price in time and in error",
     1, 1,
     "output set overwrite index threads newton steps error duration samples repeat members tolerance judge "
     "mean-from",
     command_ablate},
    {"info", "FILE", "tells what is in a trajectory, checkpoint, LAMMPS data file or dump", 1, 1, "",
     run_info},
    {"convert", "IN OUT", "converts LAMMPS data, dumps and H5MD into each other; checkpoints, too", 2, 2,
     "to frame overwrite", run_convert},
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

/* Is `name` a word of the space-separated list? */
static bool word_in(const char *list, const char *name, size_t length) {
    for (const char *at = list; *at;) {
        size_t word = strcspn(at, " ");
        if (word == length && strncmp(at, name, length) == 0)
            return true;
        at += word;
        at += *at == ' ';
    }
    return false;
}

/* Does the row say what the flag is for this command? */
static bool flag_fits(const struct flag *flag, const struct command *command) {
    return word_in(command->flags, flag->name, strlen(flag->name)) &&
           (flag->only == NULL || word_in(flag->only, command->name, strlen(command->name)));
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
    for (int f = 0; f < FLAGS; f++) {
        if (!flag_fits(&flags[f], command))
            continue;
        fprintf(out, "  --%s%s%s\n      %s\n", flags[f].name, flags[f].argument ? " " : "",
                flags[f].argument ? flags[f].argument : "", flags[f].help);
    }
    if (packs) {
        fprintf(out, "\nLAW is one of these; 'scree help pack LAW' tells its keys:\n");
        pack_help(out, NULL);
    }
    return true;
}

static bool setting_add(struct command_line *line, const char *text, struct error *error) {
    if (strchr(text, '=') == NULL)
        return error_set(error, ERROR_USER, "command line: --set %s: must read KEY=VALUE", text);
    if (line->settings == COMMAND_SETTINGS_MAX)
        return error_set(error, ERROR_USER, "command line: more than %d --set", COMMAND_SETTINGS_MAX);
    line->setting[line->settings++].text = text;
    return true;
}

static bool flag_store(struct command_line *line, const char *name, const char *value, struct error *error) {
    static const char *const lists[ABLATE_FLAGS] = {
        [ABLATE_INDEX] = "index",   [ABLATE_THREADS] = "threads",    [ABLATE_NEWTON] = "newton",
        [ABLATE_STEPS] = "steps",   [ABLATE_DURATION] = "duration",  [ABLATE_SAMPLES] = "samples",
        [ABLATE_REPEAT] = "repeat", [ABLATE_MEMBERS] = "members",    [ABLATE_TOLERANCE] = "tolerance",
        [ABLATE_JUDGE] = "judge",   [ABLATE_MEAN_FROM] = "mean-from"};
    const struct {
        const char *name;
        const char **to;
    } texts[] = {
        {"output", &line->directory}, {"resume", &line->resume}, {"to", &line->to}, {"frame", &line->frame}};
    if (strcmp(name, "set") == 0)
        return setting_add(line, value, error);
    line->overwrite = line->overwrite || strcmp(name, "overwrite") == 0;
    line->quiet = line->quiet || strcmp(name, "quiet") == 0;
    line->errors = line->errors || strcmp(name, "error") == 0;
    for (size_t k = 0; k < sizeof texts / sizeof texts[0]; k++)
        if (strcmp(texts[k].name, name) == 0)
            *texts[k].to = value;
    for (size_t k = 0; k < sizeof lists / sizeof lists[0]; k++)
        if (strcmp(lists[k], name) == 0)
            line->list[k] = value;
    return true;
}

/* Reads one flag at argv[*at] (and its argument). */
static bool flag_read(struct command_line *line, const struct command *command, char **argv, int argc,
                      int *at, struct error *error) {
    const char *given = argv[*at], *name = given + 2, *value = NULL;
    size_t length;
    if (strcmp(given, "-o") == 0)
        name = "output";
    else if (strncmp(given, "--", 2) != 0)
        return error_set(error, ERROR_USER,
                         "command line: unknown flag %s; 'scree help %s' lists those of this command", given,
                         command->name);
    length = strcspn(name, "=");
    if (name[length] == '=')
        value = name + length + 1;
    for (int f = 0; f < FLAGS; f++) {
        const struct flag *flag = &flags[f];
        if (strlen(flag->name) != length || strncmp(flag->name, name, length) != 0 ||
            !flag_fits(flag, command))
            continue;
        if (flag->argument == NULL && value != NULL)
            return error_set(error, ERROR_USER, "command line: --%s takes no argument", flag->name);
        if (flag->argument != NULL && value == NULL) {
            if (*at + 1 >= argc)
                return error_set(error, ERROR_USER, "command line: %s needs its %s", given, flag->argument);
            value = argv[++*at];
        }
        return flag_store(line, flag->name, value, error);
    }
    return error_set(error, ERROR_USER,
                     "command line: unknown flag %s; 'scree help %s' lists those of this command", given,
                     command->name);
}

bool command_line_read(struct command_line *line, const struct command *command, int argc, char **argv,
                       struct error *error) {
    *line = (struct command_line){0};
    for (int at = 0; at < argc; at++) {
        if (argv[at][0] == '-' && argv[at][1] != '\0') {
            if (!flag_read(line, command, argv, argc, &at, error))
                return false;
        } else if (line->files == command->files_max) {
            return error_set(error, ERROR_USER,
                             "command line: '%s' is one argument too many; usage: scree %s %s", argv[at],
                             command->name, command->arguments);
        } else {
            line->file[line->files++] = argv[at];
        }
    }
    if (line->files < command->files_min)
        return error_set(error, ERROR_USER, "command line: too few arguments; usage: scree %s %s",
                         command->name, command->arguments);
    return true;
}

struct scene *command_scene(const struct comm *comm, const struct command_line *line,
                            const struct scene_setting *extra, int extras, struct error *error) {
    struct scene_setting setting[2 * COMMAND_SETTINGS_MAX];
    char *text = NULL;
    struct scene *scene = NULL;
    memcpy(setting, line->setting, sizeof line->setting);
    for (int k = 0; k < extras; k++)
        setting[line->settings + k] = extra[k];
    if (scene_read_text(line->file[0], &text, NULL, error))
        scene = scene_parse(line->file[0], text, setting, line->settings + extras, error);
    memory_free(text);
    if (!comm_agree(comm, error))
        scene_free(&scene);
    return scene;
}

/* The newest checkpoint in a directory that is whole, in `path`. Damaged ones are passed over with a message;
 * if all are, the error is that of the newest. */
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
    int status = run_scene(comm, scene, &options, NULL, error);
    scene_free(&scene);
    return status;
}

static bool one_rank(const struct comm *comm, const char *what, struct error *error) {
    if (comm->size > 1)
        error_set(error, ERROR_USER, "command line: scree %s runs on one rank; it was started on %d", what,
                  comm->size);
    return comm->size == 1;
}

static int run_info(const struct comm *comm, const struct command_line *line, struct error *error) {
    if (one_rank(comm, "info", error))
        info_print(line->file[0], comm, stdout, error);
    return error->kind;
}

static int run_convert(const struct comm *comm, const struct command_line *line, struct error *error) {
    struct convert_options options = {.overwrite = line->overwrite, .one_frame = line->frame != NULL};
    if (!one_rank(comm, "convert", error))
        return error->kind;
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
