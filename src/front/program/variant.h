/* SPDX-License-Identifier: BSD-3-Clause */
/* The variants that `scree ablate --error` tries: a scene with one or a few settings changed. What no key of a scene can say (for
 * example stiffnesses for another law) is changed in the scene after reading; the rest are keys with values, as in --set. */
#ifndef SCREE_PROGRAM_VARIANT_H
#define SCREE_PROGRAM_VARIANT_H

#include "engine/simulation.h"
#include "front/program/command_line.h"

enum {
    VARIANTS_MAX = 96,
    VARIANT_CHANGES_MAX = 8,
    VARIANT_TEXT_MAX = 200,
    VARIANT_SETTINGS_MAX =
        2 * LAW_MATERIALS_MAX + 8, /* of an explicit run: two keys a material, and some more */
    VARIANT_SET_MAX = 40 * VARIANT_SETTINGS_MAX
};

enum variant_kind {
    VARIANT_STEP,         /* the time step times `value` */
    VARIANT_INTEGRATOR,   /* integrator number `value` of those known */
    VARIANT_LINEAR,       /* the law with linear springs that store as much energy */
    VARIANT_SOFT,         /* stiffnesses times `value`; the step stays the same part of the stable step */
    VARIANT_FRICTIONLESS, /* no tangential force */
    VARIANT_NO_ROLLING,   /* no rolling resistance */
    VARIANT_SLIDING,      /* the other way of sliding: enum law_sliding */
    VARIANT_SKIN,         /* skins times `value` */
    VARIANT_INDEX,        /* index number `value` of the registry */
    VARIANT_CLASSES,      /* sizes merged into `value` classes */
    VARIANT_FUSED,        /* the order of the step: 1 fused, 0 plain */
    VARIANT_SETTINGS,     /* the keys of `set`; the step is that of the scene with them */
    VARIANT_REPRODUCIBLE  /* forces summed in the same order on every layout */
};

struct variant_change {
    enum variant_kind kind;
    double value;
};

struct variant {
    const char *group;               /* "step", "law" ... */
    char settings[VARIANT_TEXT_MAX]; /* shown to people: "dt x 2" */
    struct variant_change change[VARIANT_CHANGES_MAX];
    int changes;               /* 0: the scene as it is */
    char set[VARIANT_SET_MAX]; /* KEY=VALUE, lines; of VARIANT_SETTINGS */
};

/* The facts of a scene that are needed to choose and apply variants. */
struct variant_facts {
    double dt, stable, rayleigh; /* time */
    double speed;                /* largest met, length/time; 0: not known yet */
    uint64_t particles;
    int classes; /* size classes */
    int materials;
    double radius[LAW_MATERIALS_MAX]; /* mean, of free particles; infinite without such particles */
    double mass[LAW_MATERIALS_MAX];
    struct law_coefficients *coefficients; /* materials x materials (law_place_of); owned */
};

/* Finds the facts by creating the simulation of a scene and destroying it. variant_forget releases. Collective. */
bool variant_probe(const struct comm *comm, const struct scene *scene, struct variant_facts *facts,
                   struct error *error);
void variant_forget(struct variant_facts *facts);

/* The keys that a variant sets, into `setting`, with room for VARIANT_SETTINGS_MAX, whose texts lie in `text`. Returns their
 * number. */
int variant_settings(const struct variant *variant, struct scene_setting *setting,
                     char text[VARIANT_SET_MAX]);

/* Adds a variant of keys and values, lines of KEY=VALUE, to a list of `count`; returns the new count. Without room nothing is
 * added. */
int variant_put(struct variant *list, int count, const char *group, const char *settings, const char *set);

/* Adds more and fewer sweeps, softer and stiffer springs, and the other method, of a scene with contact.solver. Returns the new
 * count. */
int variant_put_solver(struct variant *list, int count, const struct scene *scene);

/* Adds the combinations of the values of --vary, as variants of the group "vary". Fails (user). */
bool variant_vary(const struct command_line *line, struct variant *list, int *count, struct error *error);

/* Adds the explicit runs of a scene with contact.solver: at 5 MPa, at 1 GPa, and at the modulus `young` (Pa; 0: that of the
 * scene, if it has one); each at the default step and at four times that. The stiffest stands last. Returns the new count. */
int variant_put_explicit(struct variant *list, int count, const struct scene *scene, double young);

/* Fills `list` with the scene as it is and the variants that make sense for the scene; returns the number of
 * entries. */
int variant_list(struct variant *list, const struct scene *scene, const struct variant_facts *facts);

/* Takes out of a list of `count` variants all but the first, the scene as it is, and those of the groups named in `groups`,
 * words with commas between (NULL: all stay). Returns the new count; 0, and an error (user), if the list has no group of such
 * a name. */
int variant_keep(struct variant *list, int count, const char *groups, struct error *error);

/* Adds the changes of `from` to `to`, and its settings to the text. */
void variant_add(struct variant *to, const struct variant *from);

/* Makes a variant's changes in a scene. Returns the factor for the time step. */
double variant_apply(const struct variant *variant, const struct variant_facts *facts, struct scene *scene);

/* True if the stable step changes with the variant, and the time step with it. */
bool variant_scales_step(const struct variant *variant);

/* True if results stay the same except for rounding and the order of sums. */
bool variant_is_exact(const struct variant *variant);

#endif
