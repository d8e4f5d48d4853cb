/* SPDX-License-Identifier: BSD-3-Clause */
/* The program from its arguments to its exit status: help and version, MPI, the command, its error. */
#include "front/program/command.h"
#include "front/program/commands.h"
#include "base/version.h"
#include "data/formats/output.h"
#include "data/scene/schema_help.h"
#include "scree.h"
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

static int show_help(int argc, char **argv) {
    if (argc == 3 && strcmp(argv[2], "--man") == 0) {
        manual_page(stdout);
        return 0;
    }
    if (argc == 3 && strcmp(argv[2], "--bash") == 0) {
        manual_bash(stdout);
        return 0;
    }
    if (argc == 3 && strcmp(argv[2], "--zsh") == 0) {
        manual_zsh(stdout);
        return 0;
    }
    if (argc == 3 && strcmp(argv[2], "--fish") == 0) {
        manual_fish(stdout);
        return 0;
    }
    const struct command *command = argc > 2 ? command_find(argv[2]) : NULL;
    if (command && argc > 3) {
        bool known = command_usage(stdout, command, argv[3]);
        if (!known)
            fprintf(stderr, "scree: help %s: there is nothing on '%s'\n", argv[2], argv[3]);
        return known ? 0 : ERROR_USER;
    }
    if (argc <= 2 || command) {
        command_usage(stdout, command, NULL);
        if (argc <= 2) {
            printf("\nThe keys of a scene (scree help KEY tells more):\n\n");
            scene_help(stdout, NULL);
        }
        return 0;
    }
    return scene_help(stdout, argv[2]) ? 0 : ERROR_USER;
}

static int show_version(void) {
    printf("scree %s (%s)\n%s\n%s\n", version_number(), version_revision(), version_compiler(),
           version_flags());
    return 0;
}

/* Handles command lines that need no MPI. Returns -1 for other command lines. */
static int answer_plainly(int argc, char **argv) {
    if (argc < 2 || strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0) {
        command_usage(argc < 2 ? stderr : stdout, NULL, NULL);
        return argc < 2 ? ERROR_USER : 0;
    }
    if (strcmp(argv[1], "help") == 0)
        return show_help(argc, argv);
    if (strcmp(argv[1], "--version") == 0 || strcmp(argv[1], "version") == 0)
        return show_version();
    return -1;
}

static int run_command(const struct comm *comm, int argc, char **argv, struct error *error) {
    static struct command_line line; /* large; read once */
    const struct command *command = command_find(argv[1]);
    if (command == NULL) {
        error_set(error, ERROR_USER,
                  "command line: unknown command '%s'; known are run, check, ablate, info, convert, picture, "
                  "report, "
                  "pack, help",
                  argv[1]);
        return error->kind;
    }
    for (int k = 2; k < argc; k++) {
        if (strcmp(argv[k], "--help") == 0 || strcmp(argv[k], "-h") == 0) {
            const char *topic = argv[2][0] == '-' ? NULL : argv[2];
            if (comm->rank == 0 && !command_usage(stdout, command, topic))
                command_usage(stdout, command, NULL);
            return 0;
        }
    }
    if (!command_line_read(&line, command, argc - 1, argv + 1, error))
        return error->kind;
    return command->run(comm, &line, error);
}

/* Prints an error, each of its lines after the name of the program. */
static void print_error(const struct error *error) {
    for (const char *line = error->text; line;) {
        size_t length = strcspn(line, "\n");
        fprintf(stderr, "scree: %.*s\n", (int)length, line);
        line = line[length] ? line + length + 1 : NULL;
    }
}

/* Answers `scree info FILE --get ...`, for scripts: without MPI, which takes longer than the answer. Returns -1 for
 * other command lines. */
static int answer_shortly(int argc, char **argv) {
    static struct command_line line; /* large; read once */
    struct error error = {0};
    if (argc < 3 || strcmp(argv[1], "info") != 0 ||
        !command_line_read(&line, command_find("info"), argc - 1, argv + 1, &error) ||
        !(line.get || line.column || line.row))
        return -1;
    int status = command_lookup(&line, &error);
    if (error.kind != ERROR_NONE)
        print_error(&error);
    return status;
}

/* Checks standard output at the end: a failed write must not end in success. */
static int answer_end(int status) {
    bool lost = ferror(stdout) != 0;
    errno = 0;
    if (fflush(stdout) == 0 && !lost)
        return status;
    fprintf(stderr, "scree: standard output cannot be written%s%s\n", errno ? ": " : "",
            errno ? strerror(errno) : "");
    return status != 0 ? status : ERROR_SYSTEM;
}

int scree_main(int argc, char **argv) {
    struct comm comm;
    struct error error = {0};
    int status = answer_plainly(argc, argv);
    if (status < 0)
        status = answer_shortly(argc, argv);
    if (status >= 0)
        return answer_end(status);
    comm_start(&comm, &argc, &argv);
    signal(SIGXFSZ, SIG_IGN); /* then a write beyond the limit on file sizes returns an error */
    status = run_command(&comm, argc, argv, &error);
    if (error.kind != ERROR_NONE && comm.rank == 0)
        print_error(&error);
    status = answer_end(status);
    if (output_left_open())
        comm_abort(status);
    comm_stop(&comm);
    return status;
}
