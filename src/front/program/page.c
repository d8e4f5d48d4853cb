/* SPDX-License-Identifier: BSD-3-Clause */
/* scree report: hands a folder and the scene of its run over to a script. Read commands.h first. */
#include "front/program/commands.h"
#include "base/memory.h"
#include "base/file.h"
#include "base/program.h"
#include "front/picture/picture_source.h"
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

bool page_folder(const char *file, char folder[FILE_PATH_MAX], struct error *error) {
    static const char *const places[] = {"page", "../share/scree/page"};
    char program[FILE_PATH_MAX] = "", path[FILE_PATH_MAX + 64];
    ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
    char *slash = length > 0 ? strrchr(program, '/') : NULL;
    for (size_t k = 0; slash && k < sizeof places / sizeof places[0]; k++) {
        snprintf(folder, FILE_PATH_MAX, "%.*s/%s", (int)(slash - program), program, places[k]);
        snprintf(path, sizeof path, "%s/%s", folder, file);
        if (access(path, R_OK) == 0)
            return true;
    }
    snprintf(folder, FILE_PATH_MAX, "%s", SCREE_PAGE_FOLDER);
    snprintf(path, sizeof path, "%s/%s", folder, file);
    return access(path, R_OK) == 0 ||
           error_set(error, ERROR_USER, "%s: is not there; 'make install' puts it there", path);
}

/* Writes the effective scene of the run beside the page, if the folder tells it. */
static bool write_scene(const struct comm *comm, const char *folder, const char *path, struct error *error) {
    struct error none = {0};
    char *text = picture_source_scene(comm, folder, &none);
    FILE *file = text ? fopen(path, "w") : NULL;
    bool good = text == NULL || (file && fputs(text, file) >= 0);
    good = (file == NULL || fclose(file) == 0) && good;
    if (!good)
        error_set_errno(error, "%s: cannot be written", path);
    bool written = good && text;
    memory_free(text);
    return written;
}

int command_report(const struct comm *comm, const struct command_line *line, struct error *error) {
    const char *folder = line->file[0], *out = line->directory;
    char pages[FILE_PATH_MAX], script[FILE_PATH_MAX + 16], scene[FILE_PATH_MAX], told[FILE_PATH_MAX];
    struct stat found;
    if (comm->size > 1)
        error_set(error, ERROR_USER, "command line: scree report runs on one rank; it was started on %d",
                  comm->size);
    else if (out == NULL || strlen(out) > FILE_PATH_MAX - 16)
        error_set(error, ERROR_USER, "command line: scree report needs -o FILE.html");
    else if (stat(folder, &found) != 0 || !S_ISDIR(found.st_mode))
        error_set(error, ERROR_USER, "%s: there is no such folder", folder);
    else if (!line->overwrite && file_size(out) >= 0)
        error_set(error, ERROR_USER, "%s: is there already (--overwrite replaces it)", out);
    if (error->kind != ERROR_NONE || !page_folder("report.py", pages, error))
        return error->kind;
    snprintf(script, sizeof script, "%s/report.py", pages);
    snprintf(scene, sizeof scene, "%.1000s.scene", out);
    snprintf(told, sizeof told, "%.1000s.log", out);
    bool has_scene = write_scene(comm, folder, scene, error);
    const char *const command[] = {"python3", "-B", script, folder, out, has_scene ? scene : NULL, NULL};
    if (error->kind == ERROR_NONE)
        program_run(command, NULL, told, "python3", error);
    remove(scene);
    remove(told);
    return error->kind;
}
