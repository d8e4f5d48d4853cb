/* SPDX-License-Identifier: BSD-3-Clause */
/* A physics: what happens to particles, as one folder and one row of a table. Grains (engine/grains.c) are one, and
 * always there; others come with their section of a scene (physics_table.h).
 *
 * A physics says which fields it needs, who meets whom and how far (interactions), and which passes it adds to
 * the step. The engine merges the passes of all active physics into one plan (plan.h), keeps the pair lists of
 * their interactions, and tells each when lists are new. A physics that no scene asks for costs nothing: no
 * field, no pair, no pass.
 *
 * How to add a physics, in five steps (src/density/ is the example, with everything in 150 lines):
 *
 *   1. Make a folder src/NAME/ with the rows of its section of a scene, its fields and its observables
 *      (physics_table.h names the objects), and a local.mk that adds libNAME.la to PHYSICS_LIBS.
 *   2. Write its `struct physics`: interactions, create and destroy, passes.
 *   3. Add its row to PHYSICS_TABLE, and `include src/NAME/local.mk` to Makefile.am.
 *   4. Write its test against a plain double loop, on several ranks and threads and on every index.
 *   5. Make the pages: docs/scene.md by src/scene/document, docs/output.md by src/observe/document.
 *
 * A physics sees its context alone, never the simulation that it is part of. */
#ifndef SCREE_ENGINE_PHYSICS_H
#define SCREE_ENGINE_PHYSICS_H

#include "comm/ghosts.h"
#include "formats/restart.h"
#include "pairs/interaction.h"
#include "particles/fields.h"
#include "physics_table.h"
#include "scene/scene.h"

enum { PHYSICS_INTERACTIONS_MAX = 4 };

/* What a physics may see of a run. Borrowed; lists, classes and ghosts are those of the last rebuild. */
struct physics_context {
    void *self;          /* what `create` returned */
    const void *options; /* its section of the scene; NULL: it has none */
    const struct scene *scene;
    const struct box *box;
    const struct comm *comm;
    struct ghosts *ghosts; /* NULL: one rank alone has no copies */
    struct particles *particles;
    const struct size_classes *classes;
    const struct pairlist *list[PHYSICS_INTERACTIONS_MAX]; /* of its interactions, in their order */
    int threads;
    bool ordered; /* sums in an order that no layout changes */
};

/* Where in a step a pass runs. All passes of a stage run before those of the next. */
enum pass_stage {
    PASS_FIRST, /* before anything moves */
    PASS_MOVE,  /* particles move: a pass by rows */
    PASS_MOVED, /* other things move */
    /* the engine looks whether a rebuild is due, and rebuilds, or sends new values to the copies */
    PASS_PAIRS,  /* forces and other sums over pairs: a pass by block */
    PASS_SHARES, /* what acts on single particles: a pass by thread */
    PASS_CLOSE,  /* sums over threads; then the engine sends sums of copies home (REVERSE fields) */
    PASS_LOOK    /* not in the step: before anything is written or observed, where it is */
};

/* A pass of a step. One of whole, rows, block and share is given. */
struct physics_pass {
    const char *name;
    const char *why; /* what in the scene brings it; NULL: always */
    enum pass_stage stage;
    const char *timer;          /* the stage of the report that its time counts for; NULL: its own name */
    const char *reads, *writes; /* names of fields, "position velocity"; for people */
    bool (*needed)(const struct physics_context *context);
    /* At once; opens teams itself. */
    void (*whole)(const struct physics_context *context);
    /* MOVE: the particles [first, last) of one size class. Passes by rows and by block that stand side by side
     * share one visit to each block (plan.h). Many threads at once, each its own particles. */
    void (*rows)(const struct physics_context *context, int thread, size_t first, size_t last,
                 int size_class);
    /* PAIRS: one block of the list of the physics' first interaction. Many threads at once, each its own
     * blocks, in increasing order. `abandon` forgets the blocks of an evaluation that has to be repeated. */
    void (*block)(const struct physics_context *context, int thread, int block);
    void (*abandon)(const struct physics_context *context);
    /* SHARES: the share of one thread. */
    void (*share)(const struct physics_context *context, int thread);
};

struct physics {
    const char *name;
    int interactions;
    /* `context` of a row is replaced by the options. */
    struct interaction interaction[PHYSICS_INTERACTIONS_MAX];
    int passes;
    const struct physics_pass *pass;
    /* Made once the particles' fields are registered; before the first rebuild. NULL: it keeps nothing. */
    void *(*create)(const struct physics_context *context);
    void (*destroy)(void *self);
    /* New lists: after each rebuild. NULL: nothing to do. */
    void (*rebuilt)(const struct physics_context *context);
    /* The largest time step, up to `most`, that is stable for the state as it is. NULL: any. Collective. */
    double (*limit)(const struct physics_context *context, double most);
    /* Looks for physical nonsense after a step; fills `error`. NULL: nothing to find. */
    void (*guard)(const struct physics_context *context, struct error *error);
    /* Adds the numbers that a resume needs, under their names. NULL: none. */
    void (*restart)(const struct physics_context *context, struct restart *restart);
};

/* The physics of a run. */
struct physics_active {
    const struct physics *row;
    struct physics_context context;
    int first; /* number of its first interaction */
};
struct physics_set {
    int count;
    struct physics_active active[PHYSICS_COUNT + 1];
};

/* Finds the physics that a scene asks for, after `grains`, adds their interactions and registers their fields.
 * `context` has all but self and lists; its options are those of grains. One thread. */
void physics_begin(struct physics_set *set, const struct physics *grains,
                   const struct physics_context *context, struct interactions *interactions);

/* Creates what they keep. `self` is what grains keep; they are not created. */
void physics_create(struct physics_set *set, void *self);
void physics_free(struct physics_set *set);

/* Hands out the lists, once it is known who has one of its own (interactions_divide). */
void physics_lists(struct physics_set *set, const struct interactions *interactions);

/* After the search of a rebuild. */
void physics_rebuilt(struct physics_set *set, struct ghosts *ghosts);

/* Runs the passes before output. Collective. */
void physics_look(const struct physics_set *set);

/* The smallest limit of all; their guards; their numbers. */
double physics_limit(const struct physics_set *set, double most);
void physics_guard(const struct physics_set *set, struct error *error);
void physics_restart(const struct physics_set *set, struct restart *restart);

#endif
