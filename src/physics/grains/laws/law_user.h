/* SPDX-License-Identifier: BSD-3-Clause */
/* A law of the user's own: a C file that a run compiles against scree_law.h and loads. One rank compiles, all load the same
 * bytes. */
#ifndef SCREE_LAWS_LAW_USER_H
#define SCREE_LAWS_LAW_USER_H

#include "physics/grains/laws/law.h"
#include "physics/grains/laws/scree_law.h"
#include "base/error.h"
#include <stddef.h>
#include <stdint.h>

struct law_user {
    struct law_form
        form; /* without functions: law_springs_of, law_impact_of and law_duration_of ask the file's */
    char name[LAW_NAME_MAX];
    uint64_t checksum; /* of the file's text */
    const struct scree_law *law;
    void *module;
};

/* A compiled file. */
struct law_object {
    char *bytes; /* owned */
    size_t size;
    uint64_t checksum; /* of the source's text */
};

/* Compiles `path` by the compiler that the environment variable CC names, or else cc, for the instruction set `level`
 * ("baseline", "x86-64-v3" ...). All files lie in a temporary folder, which is removed. Fails (user) with the compiler's
 * message, (system) where there is no room for files. One thread. */
bool law_user_compile(const char *path, const char *level, struct law_object *object, struct error *error);
void law_object_free(struct law_object *object);

/* Loads a compiled file. Fails (user) if it is no law of this version. Free with law_user_free, which sets the pointer to NULL. */
struct law_user *law_user_load(const char *path, const struct law_object *object, struct error *error);
void law_user_free(struct law_user **user);

#endif
