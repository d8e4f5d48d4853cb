/* SPDX-License-Identifier: BSD-3-Clause */
/* Compiles and loads the law of a user. Read law_user.h first. */
#define _GNU_SOURCE
#include "physics/grains/laws/law_user.h"
#include "base/checksum.h"
#include "base/memory.h"
#include "base/program.h"
#include <dlfcn.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { PATH_MOST = 1024, WORDS_MOST = 16, TOLD_MOST = 1500 };

/* The text of scree_law.h, so that a run needs no installed header. */
static const char header[] =
#include "physics/grains/laws/scree_law.text"
    ;

/* A temporary folder with three files. */
struct place {
    char folder[PATH_MOST];
    char header[PATH_MOST + 16], object[PATH_MOST + 16], told[PATH_MOST + 16];
};

static bool place_make(struct place *place, struct error *error) {
    const char *where = getenv("TMPDIR");
    snprintf(place->folder, sizeof place->folder, "%s/scree-law-XXXXXX", where && where[0] ? where : "/tmp");
    if (mkdtemp(place->folder) == NULL)
        return error_set_errno(error, "%s: no folder for a compiled law", place->folder);
    snprintf(place->header, sizeof place->header, "%s/scree_law.h", place->folder);
    snprintf(place->object, sizeof place->object, "%s/law.so", place->folder);
    snprintf(place->told, sizeof place->told, "%s/told", place->folder);
    return true;
}

static void place_remove(const struct place *place) {
    unlink(place->header);
    unlink(place->object);
    unlink(place->told);
    rmdir(place->folder);
}

/* All of a file, with a zero behind it; NULL: it cannot be read. */
static char *read_all(const char *path, size_t *size) {
    FILE *file = fopen(path, "rb");
    size_t room = 1 << 16;
    char *text = file ? memory_allocate(room, 1, "law") : NULL;
    *size = 0;
    while (file) {
        *size += fread(text + *size, 1, room - *size - 1, file);
        if (*size < room - 1)
            break;
        text = memory_resize(text, room *= 2, 1, "law");
    }
    if (file) {
        text[*size] = '\0';
        fclose(file);
    }
    return text;
}

static bool write_all(const char *path, const void *bytes, size_t size, struct error *error) {
    FILE *file = fopen(path, "wb");
    bool good = file && fwrite(bytes, 1, size, file) == size;
    good = file && fclose(file) == 0 && good;
    return good || error_set_errno(error, "%s", path);
}

/* Compiles the file. The environment variable CC may hold flags behind the name of the compiler. */
static bool run_compiler(const struct place *place, const char *path, const char *level,
                         struct error *error) {
    const char *given = getenv("CC"), *compiler = given && given[0] ? given : "cc";
    /* the flags of scree's own loops: the same bits on any instruction set */
    const char *own[] = {"-std=gnu11",
                         "-O3",
                         "-fopenmp-simd",
                         "-ffp-contract=off",
                         "-fno-math-errno",
                         "-fno-trapping-math",
                         "-fPIC",
                         "-shared",
                         "-w",
                         NULL,
                         "-I",
                         NULL,
                         "-o",
                         NULL,
                         NULL,
                         "-lm",
                         NULL};
    char words[PATH_MOST], march[64], file[PATH_MOST + 2], *rest = words;
    const char *command[WORDS_MOST + sizeof own / sizeof own[0]];
    struct error failed = {0};
    int count = 0;
    snprintf(words, sizeof words, "%s", compiler);
    snprintf(march, sizeof march, "-march=%s", level);
    snprintf(file, sizeof file, "%s%s", path[0] == '-' ? "./" : "", path); /* a name, no flag */
    own[9] = strcmp(level, "baseline") == 0 ? "-w" : march;
    own[11] = place->folder;
    own[13] = place->object;
    own[14] = file;
    while (count < WORDS_MOST && (command[count] = strtok_r(rest, " \t", &rest)) != NULL)
        count++;
    memcpy(command + count, own, sizeof own);
    if (program_run(command, NULL, place->told, "gcc", &failed) && access(place->object, R_OK) == 0)
        return true;
    size_t size;
    char *told = read_all(place->told, &size);
    while (told && size > 0 && told[size - 1] == '\n')
        told[--size] = '\0';
    error_set(error, ERROR_USER,
              "%s: %s does not compile it (the environment variable CC names the compiler):\n%.*s", path,
              compiler, TOLD_MOST, told && told[0] ? told : failed.text);
    memory_free(told);
    return false;
}

bool law_user_compile(const char *path, const char *level, struct law_object *object, struct error *error) {
    struct place place;
    size_t size;
    *object = (struct law_object){0};
    char *text = read_all(path, &size);
    if (text == NULL)
        return error_set(error, ERROR_USER, "%s: contact.law: the file cannot be read: %s", path,
                         strerror(errno));
    object->checksum = checksum_row(0, text, size);
    memory_free(text);
    if (!place_make(&place, error))
        return false;
    bool good =
        write_all(place.header, header, sizeof header - 1, error) && run_compiler(&place, path, level, error);
    if (good)
        object->bytes = read_all(place.object, &object->size);
    place_remove(&place);
    if (good && object->bytes == NULL)
        return error_set(error, ERROR_SYSTEM, "%s: the compiled law cannot be read", place.object);
    return good;
}

void law_object_free(struct law_object *object) {
    memory_free(object->bytes);
    *object = (struct law_object){0};
}

/* Refuses what is not a law. */
static bool check(const char *path, const struct scree_law *law, struct error *error) {
    if (law == NULL)
        return error_set(error, ERROR_USER,
                         "%s: defines no law: its last line is SCREE_LAW(function, .name = \"...\")", path);
    if (law->version != SCREE_LAW_VERSION)
        return error_set(error, ERROR_USER,
                         "%s: is written for version %d of scree_law.h; this program has version %d", path,
                         law->version, SCREE_LAW_VERSION);
    if (law->name == NULL || law->name[0] == '\0' || strlen(law->name) >= LAW_NAME_MAX ||
        law->name[strspn(law->name, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_")] !=
            '\0')
        return error_set(error, ERROR_USER, "%s: .name must be letters, digits and _, up to %d", path,
                         LAW_NAME_MAX - 1);
    if (law->parameters < 0 || law->parameters > SCREE_LAW_PARAMETERS_MAX || !(law->damper >= 0.0) ||
        !(law->tangent >= 0.0))
        return error_set(error, ERROR_USER, "%s: .parameters must be 0 to %d, .damper and .tangent 0 or more",
                         path, SCREE_LAW_PARAMETERS_MAX);
    return true;
}

struct law_user *law_user_load(const char *path, const struct law_object *object, struct error *error) {
    struct place place;
    if (!place_make(&place, error))
        return NULL;
    void *module = NULL;
    if (write_all(place.object, object->bytes, object->size, error)) {
        module = dlopen(place.object, RTLD_NOW | RTLD_LOCAL);
        if (module == NULL)
            error_set(error, ERROR_USER, "%s: the compiled law cannot be loaded: %s", path, dlerror());
    }
    place_remove(&place); /* what is loaded stays */
    if (module == NULL)
        return NULL;
    const struct scree_law *law = dlsym(module, "scree_law");
    if (!check(path, law, error)) {
        dlclose(module);
        return NULL;
    }
    struct law_user *user = memory_allocate_zero(1, sizeof *user, "law");
    user->law = law;
    user->module = module;
    user->checksum = object->checksum;
    snprintf(user->name, sizeof user->name, "%s", law->name);
    user->form = (struct law_form){.radius = true,
                                   .damper = law->damper > 0.0 ? law->damper : 2.0,
                                   .tangent = law->tangent > 0.0 ? law->tangent : 1.0};
    return user;
}

void law_user_free(struct law_user **user) {
    if (*user == NULL)
        return;
    dlclose((*user)->module);
    memory_free(*user);
    *user = NULL;
}
