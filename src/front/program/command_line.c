/* SPDX-License-Identifier: BSD-3-Clause */
/* Reads the command line by the table of flags and getopt_long. */
#include "front/program/command_line.h"
#include "data/scene/schema_unknown.h"
#include "base/memory.h"
#include "data/scene/scene_files.h"
#include "data/scene/scene_text.h"
#include <getopt.h>
#include <stddef.h>
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
     "convert picture report pack"},
    {"quiet", NULL, "no notes, no progress, no report and no list of what a resume changes on the terminal",
     NULL},
    {"view", "[PORT]",
     "shows the run while it runs, on a page for a browser on this machine; prints the address of the page; "
     "PORT: of 127.0.0.1, default: any that is free",
     "run"},
    {"paused", NULL, "with --view: waits before the first step until the page lets the run go on", NULL},
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
     "picture"},
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
    {"all", NULL,
     "also prints what is off, every field of a particle and every pass of a step and of a rebuild", NULL},
    {"ranks", "N", "tells what a layout of N ranks would need", NULL},
    {"threads", "M", "with --ranks: threads of each rank; default: those of the scene", "check"},
    {"threads", "1,2,...", "the thread counts to compare; default: powers of two up to all cores", "ablate"},
    {"newton", "on,off", "the newton settings to compare; default: both", NULL},
    {"steps", "N", "steps of each run; default: those of the scene", NULL},
    {"vary", "KEY=A,B,...",
     "values of any key of the scene to compare, e.g. --vary contact.solver.kappa=40,400; may be repeated: "
     "all combinations run. Without --error, --index, --threads and --newton are then the scene's unless "
     "given",
     NULL},
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
    {"only", "A,B,...",
     "with --error: kinds of settings to try: step, integrator, law, stiffness, solver, explicit, skin, "
     "index, "
     "classes, order; default: all",
     NULL},
    {"young", "E",
     "with --error, of a scene of rigid grains: their real modulus, e.g. 70e9, for the explicit runs beside "
     "it; "
     "default: 5 MPa and 1 GPa alone",
     NULL},
};

enum { FLAGS = sizeof flags / sizeof flags[0], OPTION_FIRST = 256 };

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

static bool vary_add(struct command_line *line, const char *text, struct error *error) {
    if (line->varied == COMMAND_VARY_MAX)
        return error_set(error, ERROR_USER, "command line: more than %d --vary", COMMAND_VARY_MAX);
    line->vary[line->varied++] = text;
    return true;
}

/* The members of the command line that a flag sets: a text, once or the last one, or whether the flag was given. */
static const struct target {
    const char *name;
    size_t text, given; /* offset of a const char *, of a bool; 0: none */
    bool last;          /* of several texts the last one counts */
} targets[] = {
#define TEXT(flag, member)                                                                                   \
    { .name = flag, .text = offsetof(struct command_line, member) }
#define LAST(flag, member)                                                                                   \
    { .name = flag, .text = offsetof(struct command_line, member), .last = true }
#define GIVEN(flag, member)                                                                                  \
    { .name = flag, .given = offsetof(struct command_line, member) }
    TEXT("output", directory),
    TEXT("resume", resume),
    TEXT("to", to),
    TEXT("frame", frame),
    TEXT("ranks", ranks),
    TEXT("get", get),
    TEXT("column", column),
    TEXT("row", row),
    TEXT("view", view),
    LAST("index", list[ABLATE_INDEX]),
    LAST("threads", list[ABLATE_THREADS]),
    LAST("newton", list[ABLATE_NEWTON]),
    LAST("steps", list[ABLATE_STEPS]),
    LAST("duration", list[ABLATE_DURATION]),
    LAST("samples", list[ABLATE_SAMPLES]),
    LAST("repeat", list[ABLATE_REPEAT]),
    LAST("members", list[ABLATE_MEMBERS]),
    LAST("tolerance", list[ABLATE_TOLERANCE]),
    LAST("judge", list[ABLATE_JUDGE]),
    LAST("mean-from", list[ABLATE_MEAN_FROM]),
    LAST("only", list[ABLATE_ONLY]),
    LAST("young", list[ABLATE_YOUNG]),
    LAST("colour", draw[DRAW_COLOUR]),
    LAST("range", draw[DRAW_RANGE]),
    LAST("bands", draw[DRAW_BANDS]),
    LAST("palette", draw[DRAW_PALETTE]),
    LAST("grey", draw[DRAW_GREY]),
    LAST("cut", draw[DRAW_CUT]),
    LAST("size", draw[DRAW_SIZE]),
    LAST("rate", draw[DRAW_RATE]),
    GIVEN("overwrite", overwrite),
    GIVEN("quiet", quiet),
    GIVEN("paused", paused),
    GIVEN("bare", bare),
    GIVEN("error", errors),
    GIVEN("all", all),
#undef TEXT
#undef LAST
#undef GIVEN
};

static bool flag_store(struct command_line *line, const char *name, const char *value, struct error *error) {
    if (strcmp(name, "set") == 0)
        return setting_add(line, value, error);
    if (strcmp(name, "petsc") == 0)
        return petsc_add(line, value, error);
    if (strcmp(name, "vary") == 0)
        return vary_add(line, value, error);
    for (size_t k = 0; k < sizeof targets / sizeof targets[0]; k++) {
        const struct target *target = &targets[k];
        if (strcmp(target->name, name) != 0)
            continue;
        if (target->given) {
            *(bool *)(void *)((char *)line + target->given) = true;
            return true;
        }
        const char **text = (const char **)(void *)((char *)line + target->text);
        if (*text && !target->last)
            return error_set(error, ERROR_USER, "command line: --%s is given twice: %s and %s", name, *text,
                             value);
        *text = value;
    }
    return true;
}

/* The flags of a command for getopt_long; each with a number of its own, or getopt_long takes two of one
 * kind for the same. */
static void options_make(const struct command *command, struct option option[FLAGS + 1]) {
    const struct flag *flag;
    int n = 0;
    for (; (flag = command_line_flag(command, n)) != NULL; n++)
        option[n] = (struct option){.name = flag->name,
                                    .val = OPTION_FIRST + n,
                                    .has_arg = flag->argument == NULL     ? no_argument
                                               : flag->argument[0] == '[' ? optional_argument
                                                                          : required_argument};
    option[n] = (struct option){0};
}

/* What getopt_long could not read: `word` is the argument that it stands in. */
static bool flag_refuse(const struct command *command, const struct option *option, int code,
                        const char *word, struct error *error) {
    size_t length = strcspn(word, "=");
    const struct flag *flag = NULL;
    if (strcmp(word, "-o") == 0)
        length = strlen("--output"), word = "--output";
    for (int k = 0; option[k].name && flag == NULL; k++)
        if (length > 2 && strncmp(option[k].name, word + 2, length - 2) == 0)
            flag = command_line_flag(command, k);
    if (code == ':' && flag)
        return error_set(error, ERROR_USER, "command line: --%s needs its %s", flag->name, flag->argument);
    if (flag && strlen(flag->name) == length - 2 && word[length] == '=')
        return error_set(error, ERROR_USER, "command line: --%s takes no argument", flag->name);
    const char *near = NULL;
    for (int k = 0; option[k].name && flag == NULL && near == NULL && length > 2 && length < 64; k++) {
        char name[64];
        snprintf(name, sizeof name, "%.*s", (int)length - 2, word + 2);
        near = schema_distance(name, option[k].name) >= 0 ? option[k].name : NULL;
    }
    return error_set(error, ERROR_USER,
                     "command line: %s %s%s%s%s; 'scree help %s' lists those of this command",
                     flag ? "several flags begin with" : "unknown flag", word,
                     near ? " (did you mean --" : "", near ? near : "", near ? "?)" : "", command->name);
}

/* The argument of a flag whose argument may be missing: behind '=', or the next word if that is a number. */
static const char *argument_given(const char *behind, int argc, char **argv) {
    const char *next = optind < argc ? argv[optind] : "";
    if (behind)
        return behind;
    return *next && next[strspn(next, "0123456789")] == '\0' ? argv[optind++] : "";
}

static bool file_add(struct command_line *line, const struct command *command, const char *word,
                     struct error *error) {
    if (line->files == command->files_max)
        return error_set(error, ERROR_USER, "command line: '%s' is one argument too many; usage: scree %s %s",
                         word, command->name, command->arguments);
    line->file[line->files++] = word;
    return true;
}

bool command_line_read(struct command_line *line, const struct command *command, int argc, char **argv,
                       struct error *error) {
    struct option option[FLAGS + 1];
    int code, which = 0;
    bool good = true;
    *line = (struct command_line){0};
    options_make(command, option);
    optind = 0; /* begin, also where this is not the first command line */
    opterr = 0; /* the messages are ours */
    for (int at = 1; good && (code = getopt_long(argc, argv, "-:o:", option, &which)) != -1; at = optind) {
        if (code == 1)
            good = file_add(line, command, optarg, error);
        else if (code == 'o')
            good = flag_store(line, "output", optarg, error);
        else if (code < OPTION_FIRST)
            good = flag_refuse(command, option, code, argv[at], error);
        else
            good = flag_store(line, option[which].name,
                              option[which].has_arg == optional_argument ? argument_given(optarg, argc, argv)
                                                                         : optarg,
                              error);
    }
    for (; good && optind < argc; optind++) /* behind -- */
        good = file_add(line, command, argv[optind], error);
    if (good && line->files < command->files_min)
        return error_set(error, ERROR_USER, "command line: too few arguments; usage: scree %s %s",
                         command->name, command->arguments);
    return good;
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
