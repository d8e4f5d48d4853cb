/* SPDX-License-Identifier: BSD-3-Clause */
/* The command line: the flags of each command, and the reading of the words. One table row a flag. */
#ifndef SCREE_PROGRAM_COMMAND_LINE_H
#define SCREE_PROGRAM_COMMAND_LINE_H

#include "kernel/comm/comm.h"
#include "base/error.h"
#include "data/scene/scene_read.h"
#include <stdbool.h>
#include <stdio.h>

enum { COMMAND_SETTINGS_MAX = 256, COMMAND_PETSC_MAX = 1024, COMMAND_FILES_MAX = 40, COMMAND_VARY_MAX = 8 };

/* Flags of ablate that take a word or a list. */
enum {
    ABLATE_INDEX,
    ABLATE_THREADS,
    ABLATE_NEWTON,
    ABLATE_STEPS,
    ABLATE_DURATION,
    ABLATE_SAMPLES,
    ABLATE_REPEAT,
    ABLATE_MEMBERS,
    ABLATE_TOLERANCE,
    ABLATE_JUDGE,
    ABLATE_MEAN_FROM,
    ABLATE_ONLY,
    ABLATE_YOUNG,
    ABLATE_FLAGS
};

/* Flags of picture that take a word. */
enum {
    DRAW_COLOUR,
    DRAW_RANGE,
    DRAW_BANDS,
    DRAW_PALETTE,
    DRAW_GREY,
    DRAW_CUT,
    DRAW_SIZE,
    DRAW_RATE,
    DRAW_FLAGS
};

/* The settings of the command line. Texts are borrowed from argv. */
struct command_line {
    int files;
    const char *file[COMMAND_FILES_MAX]; /* in order: SCENE.yaml, the input and output of convert ... */
    int settings;
    struct scene_setting setting[COMMAND_SETTINGS_MAX];
    const char *directory;          /* -o */
    const char *resume;             /* --resume */
    const char *to;                 /* --to */
    const char *frame;              /* --frame */
    const char *get;                /* --get */
    const char *column, *row;       /* --column, --row */
    const char *ranks;              /* --ranks */
    const char *view;               /* --view of run: "" or the port; of picture: the view; NULL: not given */
    char petsc[COMMAND_PETSC_MAX];  /* --petsc, as a setting */
    const char *list[ABLATE_FLAGS]; /* of ablate */
    int varied;
    const char *vary[COMMAND_VARY_MAX]; /* --vary KEY=A,B,... (ablate) */
    const char *draw[DRAW_FLAGS];       /* of picture */
    bool overwrite, quiet;
    bool paused; /* --paused */
    bool bare;   /* --bare (picture) */
    bool errors; /* --error (ablate) */
    bool all;    /* --all (check) */
};

struct command {
    const char *name, *arguments, *summary;
    int files_min, files_max;
    const char *flags; /* long names of the flags of the command, separated by spaces */
    /* Returns the exit status, or fills the error. Collective if several ranks run. */
    int (*run)(const struct comm *comm, const struct command_line *line, struct error *error);
};

/* Reads the words behind the name of the command, which is argv[0]; a flag may be abbreviated, and -- ends the flags. Uses
 * getopt_long, and so its variables. One thread. */
bool command_line_read(struct command_line *line, const struct command *command, int argc, char **argv,
                       struct error *error);

/* A flag as a command has it. */
struct flag {
    const char *name; /* as in --name */
    const char *argument, *help;
    const char *only; /* the commands that this row is for; NULL: all that take the flag */
};

/* Flag `k` of a command, NULL behind the last. */
const struct flag *command_line_flag(const struct command *command, int k);

/* Prints the flags of a command, each with its help. */
void command_line_flags(FILE *out, const struct command *command);

/* Reads and parses the scene file that the line names, with its settings and `extra` more. NULL: error
 * filled. Collective. */
struct scene *command_scene(const struct comm *comm, const struct command_line *line,
                            const struct scene_setting *extra, int extras, struct error *error);

#endif
