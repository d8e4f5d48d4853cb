/* SPDX-License-Identifier: BSD-3-Clause */
/* A recipe on its way. */
#ifndef SCREE_FRONT_PACK_RECIPE_WORK_H
#define SCREE_FRONT_PACK_RECIPE_WORK_H

#include "base/error.h"
#include "front/pack/laws.h"

enum { RECIPE_SETS_MAX = 64, RECIPE_VALUES = 4 };

struct recipe_work {
    const struct laws_row *law;
    const char *const *setting; /* KEY=VALUE, borrowed */
    int given;                  /* their number */
    char *set[RECIPE_SETS_MAX]; /* PATH=VALUE of the scene, owned */
    int sets, sources;
    double box, count;             /* of a published system; 0: none */
    double broad;                  /* part of sand */
    char value[RECIPE_VALUES][64]; /* of the last defaults */
    unsigned values;
    struct error *error;
};

/* The value that the user gives to a key, or NULL; or else the law's default, which lasts for a few calls. */
const char *recipe_given(const struct recipe_work *work, const char *key);
const char *recipe_value(struct recipe_work *work, const char *key);

/* A key as a number, in bounds or whole; 0 where it has no value. False: error filled. */
bool recipe_number(struct recipe_work *work, const char *key, double least, double most, double *value);
bool recipe_whole(struct recipe_work *work, const char *key, double least, double *value);

/* Adds a setting of the scene. */
void recipe_set(struct recipe_work *work, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Fills the error with "command line: TEXT" (user); returns false. */
bool recipe_fail(struct recipe_work *work, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Laws of sizes as size laws of a scene, and the published systems. */

/* The size law of the source, its keys of a scene left out. */
bool recipe_sizes(struct recipe_work *work);

/* Count and edge of the published cube where the user gives none. */
bool recipe_published(struct recipe_work *work);

/* The two sources of the law bidisperse, and their cube. */
bool recipe_bidisperse(struct recipe_work *work);

#endif
