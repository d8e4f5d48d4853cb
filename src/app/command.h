/* The subcommands and how the command line is read. One table row a command, one a flag. */
#ifndef SCREE_APP_COMMAND_H
#define SCREE_APP_COMMAND_H

#include "comm/comm.h"
#include "core/error.h"
#include "scene/scene.h"
#include <stdbool.h>

enum { COMMAND_SETTINGS_MAX = 256, COMMAND_FILES_MAX = 40 };

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
    ABLATE_FLAGS
};

/* What the command line said. Texts are borrowed from argv. */
struct command_line {
    int files;
    const char *file[COMMAND_FILES_MAX]; /* in order: SCENE.yaml, the input and output of convert ... */
    int settings;
    struct scene_setting setting[COMMAND_SETTINGS_MAX];
    const char *directory;          /* -o */
    const char *resume;             /* --resume */
    const char *to;                 /* --to */
    const char *frame;              /* --frame */
    const char *list[ABLATE_FLAGS]; /* of ablate */
    bool overwrite, quiet;
    bool errors; /* --error (ablate) */
};

struct command {
    const char *name, *arguments, *summary;
    int files_min, files_max;
    const char *flags; /* long names of the flags it takes, separated by spaces */
    /* Returns the exit status, or fills the error. Collective where several ranks run. */
    int (*run)(const struct comm *comm, const struct command_line *line, struct error *error);
};

/* The command of a name, or NULL; the k-th, NULL after the last. */
const struct command *command_find(const char *name);
const struct command *command_get(int k);

/* Reads the arguments after the command's name. */
bool command_line_read(struct command_line *line, const struct command *command, int argc, char **argv,
                       struct error *error);

/* The usage of all commands, or of one at length; with a topic, that topic of the command. False if there is
 * no such topic. */
bool command_usage(FILE *out, const struct command *command, const char *topic);

/* Reads and parses the scene file that the line names, with its settings and `extra` more. NULL: error
 * filled. Collective. */
struct scene *command_scene(const struct comm *comm, const struct command_line *line,
                            const struct scene_setting *extra, int extras, struct error *error);

int command_check(const struct comm *comm, const struct command_line *line, struct error *error);
int command_pack(const struct comm *comm, const struct command_line *line, struct error *error);
int command_ablate(const struct comm *comm, const struct command_line *line, struct error *error);

#endif
