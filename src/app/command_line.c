/* SPDX-License-Identifier: BSD-3-Clause */
/* Reads the command line by the table of flags. */
#include "app/command_line.h"
#include "core/memory.h"
#include "scene/scene_files.h"
#include "scene/scene_text.h"
#include <string.h>

static const struct flag flags[] = {
    {"output", "DIR",
     "directory for the files of the run (also -o), made with its parents; with files in it: refused without "
     "--overwrite or --resume",
     "run"},
    {"output", "DIR", "directory for the tables (also -o); exists: refused without --overwrite", "ablate"},
    {"output", "FILE",
     "the picture (also -o): .png, .mp4 for a film of all frames, .pov for POV-Ray's text alone", "picture"},
    {"set", "KEY=VALUE",
     "overrides a key of the scene, e.g. --set index.name=hgrid or --set walls[0].radius=0.2; KEY=~ takes it "
     "out; may be repeated",
     NULL},
    {"petsc", "OPTIONS",
     "options for PETSc, which solves the equations of a fluid: the same as --set fluid.solver.petsc=OPTIONS",
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
    {"frame", "N", "one frame only, from 0, negative from the end", "convert"},
    {"frame", "N",
     "the frame to draw, from 0, negative from the end; default: the last; of a film the last frame",
     "picture"},
    {"output", "FILE", "the page (also -o)", "report"},
    {"colour", "FIELD",
     "what gives a particle its colour: speed, radius, material, x, y, z, spin, mass, id, or any field of "
     "trajectory.h5 (of a vector the length, or force.z); FIELD@N: its value in frame N, so that z@0 shows "
     "the layer "
     "from which a particle came; default: material if there are several, else radius if radii differ, else "
     "speed",
     NULL},
    {"range", "LOW,HIGH",
     "values of the first and the last colour; default: the least and the largest (of speed, all but the "
     "fastest "
     "hundredth)",
     NULL},
    {"bands", "N", "number of colours; default: 64", NULL},
    {"palette", "NAME", "scree, viridis or grey", NULL},
    {"grey", "A,B,...", "materials that are drawn in grey, and whole where --cut takes others away", NULL},
    {"cut", "CONDITION",
     "takes away the particles with these centres: 'y<0', or 'x>0,y<0' for both at a time", NULL},
    {"view", "VIEW",
     "corner, front, right, back, left, top, or AZIMUTH,ELEVATION of the camera in degrees; default: corner, "
     "in two "
     "dimensions top",
     NULL},
    {"size", "WxH", "width and height in pixels; default: 1280x960", NULL},
    {"rate", "N", "frames a second of a film; default: 25", NULL},
    {"bare", NULL, "no walls and no legend", NULL},
    {"get", "KEY",
     "prints one value of report.json and nothing else: --get pairs, --get stages.contact.seconds; FILE may "
     "be the "
     "folder of the run",
     NULL},
    {"column", "NAME",
     "prints one column of observables.csv or another table with commas, a line a row; FILE may be the "
     "folder of the "
     "run",
     NULL},
    {"row", "ROW", "with --column: first, last, or a number from 0, negative from the end; default: all rows",
     NULL},
    {"index", "A,B,...", "the indexes to compare; default: all", NULL},
    {"ranks", "N", "tells what a layout of N ranks would need", NULL},
    {"threads", "M", "with --ranks: threads of each rank; default: those of the scene", "check"},
    {"threads", "1,2,...", "the thread counts to compare; default: powers of two up to all cores", "ablate"},
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

/* True if `name` is a word of the space-separated list. */
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

/* True if the row describes the flag for this command. */
static bool flag_fits(const struct flag *flag, const struct command *command) {
    return word_in(command->flags, flag->name, strlen(flag->name)) &&
           (flag->only == NULL || word_in(flag->only, command->name, strlen(command->name)));
}

const struct flag *command_line_flag(const struct command *command, int k) {
    for (int f = 0; f < FLAGS; f++)
        if (flag_fits(&flags[f], command) && k-- == 0)
            return &flags[f];
    return NULL;
}

void command_line_flags(FILE *out, const struct command *command) {
    for (int f = 0; f < FLAGS; f++) {
        if (!flag_fits(&flags[f], command))
            continue;
        fprintf(out, "  --%s%s%s\n      %s\n", flags[f].name, flags[f].argument ? " " : "",
                flags[f].argument ? flags[f].argument : "", flags[f].help);
    }
}

static bool setting_add(struct command_line *line, const char *text, struct error *error) {
    if (strchr(text, '=') == NULL)
        return error_set(error, ERROR_USER, "command line: --set %s: must read KEY=VALUE", text);
    if (line->settings == COMMAND_SETTINGS_MAX)
        return error_set(error, ERROR_USER, "command line: more than %d --set", COMMAND_SETTINGS_MAX);
    line->setting[line->settings++].text = text;
    return true;
}

static bool petsc_add(struct command_line *line, const char *text, struct error *error) {
    int length = snprintf(line->petsc, sizeof line->petsc, "fluid.solver.petsc=\"%s\"", text);
    if (strpbrk(text, "\"\\") || length >= (int)sizeof line->petsc)
        return error_set(error, ERROR_USER,
                         "command line: --petsc: too long, or with a quotation mark or backslash");
    return setting_add(line, line->petsc, error);
}

static bool flag_store(struct command_line *line, const char *name, const char *value, struct error *error) {
    static const char *const lists[ABLATE_FLAGS] = {
        [ABLATE_INDEX] = "index",   [ABLATE_THREADS] = "threads",    [ABLATE_NEWTON] = "newton",
        [ABLATE_STEPS] = "steps",   [ABLATE_DURATION] = "duration",  [ABLATE_SAMPLES] = "samples",
        [ABLATE_REPEAT] = "repeat", [ABLATE_MEMBERS] = "members",    [ABLATE_TOLERANCE] = "tolerance",
        [ABLATE_JUDGE] = "judge",   [ABLATE_MEAN_FROM] = "mean-from"};
    static const char *const drawn[DRAW_FLAGS] = {
        [DRAW_COLOUR] = "colour",   [DRAW_RANGE] = "range", [DRAW_BANDS] = "bands",
        [DRAW_PALETTE] = "palette", [DRAW_GREY] = "grey",   [DRAW_CUT] = "cut",
        [DRAW_VIEW] = "view",       [DRAW_SIZE] = "size",   [DRAW_RATE] = "rate"};
    const struct {
        const char *name;
        const char **to;
    } texts[] = {{"output", &line->directory}, {"resume", &line->resume}, {"to", &line->to},
                 {"frame", &line->frame},      {"ranks", &line->ranks},   {"get", &line->get},
                 {"column", &line->column},    {"row", &line->row}};
    for (size_t k = 0; k < sizeof texts / sizeof texts[0]; k++)
        if (strcmp(texts[k].name, name) == 0 && *texts[k].to)
            return error_set(error, ERROR_USER, "command line: --%s is given twice: %s and %s", name,
                             *texts[k].to, value);
    if (strcmp(name, "set") == 0)
        return setting_add(line, value, error);
    if (strcmp(name, "petsc") == 0)
        return petsc_add(line, value, error);
    line->overwrite = line->overwrite || strcmp(name, "overwrite") == 0;
    line->quiet = line->quiet || strcmp(name, "quiet") == 0;
    line->bare = line->bare || strcmp(name, "bare") == 0;
    for (size_t k = 0; k < sizeof drawn / sizeof drawn[0]; k++)
        if (strcmp(drawn[k], name) == 0)
            line->draw[k] = value;
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
    if (scene)
        scene_files_open(scene, error);
    memory_free(text);
    if (!comm_agree(comm, error))
        scene_free(&scene);
    return scene;
}
