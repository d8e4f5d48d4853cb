/* SPDX-License-Identifier: BSD-3-Clause */
/* Starts other programs. Read program.h first. */
#define _GNU_SOURCE
#include "base/program.h"
#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>

enum { TOLD_MOST = 800 };

extern char **environ;

/* Reads the last bytes of a file. */
static void read_end(const char *path, char text[TOLD_MOST + 1]) {
    FILE *file = path ? fopen(path, "r") : NULL;
    size_t length = 0;
    if (file) {
        if (fseek(file, -(long)TOLD_MOST, SEEK_END) != 0)
            rewind(file);
        length = fread(text, 1, TOLD_MOST, file);
        fclose(file);
    }
    while (length > 0 && text[length - 1] == '\n')
        length--;
    text[length] = '\0';
}

bool program_run(const char *const argv[], const char *folder, const char *told, const char *package,
                 struct error *error) {
    posix_spawn_file_actions_t actions;
    pid_t child;
    int status;
    char text[TOLD_MOST + 1];
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    if (told) {
        posix_spawn_file_actions_addopen(&actions, 1, told, O_WRONLY | O_CREAT | O_TRUNC, 0666);
        posix_spawn_file_actions_adddup2(&actions, 1, 2);
    }
    if (folder)
        posix_spawn_file_actions_addchdir_np(&actions, folder);
    int code = posix_spawnp(&child, argv[0], &actions, NULL, (char *const *)argv, environ);
    posix_spawn_file_actions_destroy(&actions);
    if (code == ENOENT)
        return error_set(error, ERROR_USER, "the program %s is not there (Debian's package: %s)", argv[0],
                         package);
    if (code != 0)
        return error_set(error, ERROR_SYSTEM, "%s cannot be started: %s", argv[0], strerror(code));
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            return error_set_errno(error, "%s", argv[0]);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
        return true;
    read_end(told, text);
    return error_set(error, ERROR_USER, "%s failed%s%s", argv[0], text[0] ? ": " : "", text);
}
