/* SPDX-License-Identifier: BSD-3-Clause */
/* A physics is a set of effects on particles, in one folder and one row of a table. Grains (engine/grains.c)
 * are a physics, and always active; a scene activates other physics by their sections (physics_table.h).
 *
 * A physics states the fields that it needs, its interactions (which particles meet, and up to which
 * distance), and the passes that it adds to the step. The engine merges the passes of all active physics into
 * one plan (plan.h), keeps the pair lists of their interactions, and informs each physics of new lists. A
 * physics that no scene asks for costs nothing: no field, no pair, no pass.
 *
 * How to add a physics, in five steps (src/density/ is the example, with everything in 150 lines):
 *
 *   1. Make a folder src/NAME/ with the rows of its section of a scene, its fields and its observables
 *      (physics_table.h names the objects), and a local.mk that adds libNAME.la to PHYSICS_LIBS.
 *   2. Write its `struct physics`: interactions, create and destroy, passes.
 *   3. Add its row to PHYSICS_TABLE, and `include src/NAME/local.mk` to Makefile.am.
 *   4. Write its test against a plain double loop, on several ranks and threads and on every index.
 *   5. `make pages` writes docs/scene.md and docs/output.md.
 *
 * How to add a pass of the step, in four steps:
 *
 *   1. Choose its stage (enum pass_stage). Forces are added in PASS_PAIRS, PASS_SHARES or PASS_CLOSE. They are
 *      complete when the step ends: a pass that reads the force on a particle runs in PASS_LOOK, or in
 *      PASS_FIRST of the next step.
 *   2. Write its function: `whole`, `rows`, `block` or `share`, see struct physics_pass.
 *   3. Add its row to the array of passes of the physics, for grains in engine/grains.c, and count it in
 *      `passes`. `scree check SCENE` prints the plan in which the pass then is.
 *   4. The time of a pass is a stage of the report, unless its row names the stage of another pass as `timer`:
 *      `make pages` writes it to docs/output.md. (Passes of PASS_LOOK count as output.)
 *
 * A physics sees only its context, never the simulation. */
#ifndef SCREE_ENGINE_PHYSICS_H
#define SCREE_ENGINE_PHYSICS_H

#include "comm/ghosts.h"
#include "contact/force.h"
#include "core/log.h"
#include "engine/clock.h"
#include "formats/restart.h"
#include "integrate/integrator.h"
#include "observe/report.h"
#include "pairs/interaction.h"
#include "particles/fields.h"
#include "physics_table.h"
#include "scene/scene.h"

enum { PHYSICS_INTERACTIONS_MAX = 4 };

/* The parts of a run that a physics may use. Borrowed; lists, classes and ghosts are those of the last
 * rebuild. */
struct physics_context {
    void *self;          /* the result of `create` */
    const void *options; /* the section of the scene for this physics; NULL: none */
    const struct scene *scene;
    const struct box *box;
    const struct comm *comm;
    const struct log *log; /* receiver of warnings and notes; one rank tells each */
    struct ghosts *ghosts; /* NULL: a single rank without copies */
    struct particles *particles;
    const struct size_classes *classes;
    const struct pairlist *list[PHYSICS_INTERACTIONS_MAX]; /* lists of the interactions, in their order */
    struct walls *walls;                                   /* NULL: none */
    struct force_context *contact;     /* of grains; a physics may ask for the work of contacts in `create` */
    struct integrator_context *motion; /* of grains; a physics that carries grains sets motion->carried */
    const struct clock *clock; /* number, time and length of the step; the length may change between steps */
    struct timers *timers;     /* of the run, for the stages of the physics; only the main thread uses them */
    int threads;
    double (*speed)
        [CLASS_MAX]; /* [thread][class]: largest squared speed of this drift; a pass that moves particles
                                   raises it, as the skin of pair lists lives by it */
    bool ordered;    /* sums in an order that no layout changes */
    struct force_sums
        *sums;     /* of contacts, in the last evaluation: a physics that solves contacts fills it */
    double *taken; /* sum of sums->taken since the start, to which that physics adds */
    const double *speed_expected; /* of an impact; known from the first `limit` on */
};

/* The stages of a step, in which passes run. All passes of a stage run before those of the next. */
enum pass_stage {
    PASS_FIRST, /* before all motion */
    PASS_MOVE,  /* particles move: passes by rows */
    PASS_MOVED, /* other things move */
    /* here the engine decides whether a rebuild is due, and rebuilds, or sends new values to the copies */
    PASS_PAIRS,  /* forces and other sums over pairs: passes by block */
    PASS_SHARES, /* effects on single particles: passes by thread */
    PASS_CLOSE,  /* sums over threads; then the engine sends REVERSE fields of copies to originals */
    PASS_LOOK    /* not in the step, but before output and observables, if any are due */
};

/* A pass of a step. Exactly one of whole, rows, block and share is given. */
struct physics_pass {
    const char *name;
    const char *why; /* the reason in the scene for this pass; NULL: always there */
    enum pass_stage stage;
    const char *does;  /* its work in a few words, for the report's description of its stage */
    const char *timer; /* stage of the report for the time (stages.h); NULL: named as the pass */
    /* Names of fields, as "position velocity": shown to people, and the reason for which a scene has or has not the
     * ring order (plan.h). */
    const char *reads, *writes;
    bool
        at_end; /* of the fields that moves read and write it touches only those of particles that move at the end
                    of a step in ring order (pairs/ring.h) */
    bool (*needed)(const struct physics_context *context); /* NULL: always */
    /* Called once; opens its own teams of threads. */
    void (*whole)(const struct physics_context *context);
    /* MOVE: the owned particles [first, last) of one size class; needs no interaction. Adjacent passes by
     * rows and by block share one visit to each block (plan.h). Called by many threads at once, each with its
     * own particles. */
    void (*rows)(const struct physics_context *context, int thread, size_t first, size_t last,
                 int size_class);
    /* PAIRS: one block of the list of the physics' first interaction. Called by many threads at once, each
     * with its own blocks, in increasing order. `abandon` discards the blocks of an evaluation that must be
     * repeated. */
    void (*block)(const struct physics_context *context, int thread, int block);
    void (*abandon)(const struct physics_context *context);
    /* SHARES: computes the share of one thread, 0 ... context->threads - 1, of a division of its own: of the
     * particles from owned * thread / threads on, say. Called by many threads at once. */
    void (*share)(const struct physics_context *context, int thread);
};

/* What the particles begin with that a physics of its own particles makes (physics_table.h). */
struct physics_share {
    int64_t first_id; /* ids from this one on are free */
};

struct stability;

struct physics {
    const char *name;
    int interactions;
    /* `context` of a row is replaced by the options, or by the own data if `range_of_self`. */
    struct interaction interaction[PHYSICS_INTERACTIONS_MAX];
    bool range_of_self;
    int passes;
    const struct physics_pass *pass;
    /* Stages of the report beside those of the passes, which the physics starts by timer_enter; with `stages`
     * entries. */
    const struct timer_stage *stage;
    int stages;
    bool box_moves; /* it works in a box that moves (particles/box.h); else such a scene is refused */
    /* Refuses options that do not go together: a user's error. The same on all ranks. NULL: nothing to refuse. */
    bool (*check)(const struct physics_context *context, struct error *error);
    /* Bits 1 << kind (kinds.h) of its own particles that move. NULL: none. */
    unsigned (*moving)(const void *options);
    /* Makes the physics' own data: after the particles' fields have been registered, before the first
     * rebuild. NULL: no data. */
    void *(*create)(const struct physics_context *context);
    void (*destroy)(void *self);
    /* Appends this rank's share of the physics' own particles, wherever they lie: the first rebuild sends them to their
     * owners. After the grains have been made, in a run that is not resumed; kinds (kinds.h) are registered. The same
     * ids on any number of ranks. NULL: no particles. Collective. Errors may differ between ranks. */
    bool (*fill)(const struct physics_context *context, const struct physics_share *share,
                 struct error *error);
    /* Called after each rebuild, when the lists are new. NULL: nothing to do. */
    void (*rebuilt)(const struct physics_context *context);
    /* True if the physics reads its lists in `rebuilt` alone and nothing that it knows moves: where all physics with
     * interactions say so, the engine then releases the memory of the search. NULL: false. */
    bool (*rests)(const struct physics_context *context);
    /* The memory of pairs of the physics: rows at both particles of a pair (pairs/history.h), by owned particle,
     * of which `row_components` doubles count. The engine asks before each rebuild, and for a checkpoint; it
     * carries the rows with their particles through deletion, migration, reorder, checkpoint and resume. The
     * physics forgets what it derived from their numbers; `rebuilt` finds them in the new order. `start` is
     * there, owned + 1 entries. NULL: no rows. */
    struct history_rows *(*rows)(const struct physics_context *context);
    int row_components;
    /* True if the step in progress must rebuild. The same on all ranks. NULL: never. */
    bool (*due)(const struct physics_context *context);
    /* As `rebuilt`, which it follows. True if the ranges of interactions or the rows have changed: the engine
     * rebuilds at once, a second time, with new size classes. The same on all ranks; false the second time.
     * Collective. NULL: false. */
    bool (*rebuilt_again)(const struct physics_context *context);
    /* This rank's parts of the energy that the physics holds, and of the energy that it has taken from the
     * grains for good since the start: parts of the balance of energies. NULL: none. */
    void (*energy)(const struct physics_context *context, double *stored, double *taken);
    /* Work that the physics has done on grains since the start, negative if it took energy; this rank's part.
     * NULL: none. */
    double (*work)(const struct physics_context *context);
    /* True if two particles of the list of contacts, one of them owned, have no contact now; any thread. Asked
     * if `joins` is true, at the start. NULL: all have. */
    bool (*joined)(const struct physics_context *context, size_t i, size_t j);
    bool (*joins)(const struct physics_context *context);
    /* The part of the physics in the stability of contacts (integrate/stability.h): adds the springs at owned
     * particles; the largest L_i + L_j of its pairs. NULL: none. */
    void (*stiffen)(const struct physics_context *context, struct stability *stability);
    double (*stiffest)(const struct physics_context *context, const struct stability *stability);
    /* Opens the tables that the physics writes into the folder of a run, cut behind `step` if the run goes on
     * from there (-1: a new run); and appends the rows that are due: with output, before a checkpoint, at the
     * end. Collective; errors may differ between ranks. NULL: none. */
    bool (*table_open)(const struct physics_context *context, const char *directory, int64_t step,
                       struct error *error);
    bool (*table_write)(const struct physics_context *context, struct error *error);
    /* Brings velocities that integrator_full_step reads up to date, before they are observed. NULL: nothing to
     * do. Collective. */
    void (*full_step)(const struct physics_context *context);
    /* The largest time step, up to `most`, that is stable for the present state. NULL: any. Collective. */
    double (*limit)(const struct physics_context *context, double most);
    const char *limit_why; /* the cause of the limit, for messages: "advection of the fluid ..." */
    /* Looks for physical nonsense after a step; fills `error`. NULL: no check. */
    void (*guard)(const struct physics_context *context, struct error *error);
    /* Prints lines for `scree check`, by rank 0 alone, at the start. NULL: none. Collective. */
    void (*print)(const struct physics_context *context, FILE *file);
    /* Fills rows of the report with the linear solvers of the physics; returns how many, up to REPORT_SOLVERS_MAX.
     * NULL: none. Collective. */
    int (*solvers)(const struct physics_context *context, struct report_solver *solver);
    /* Adds the numbers that a resume needs, with their names. NULL: none. */
    void (*restart)(const struct physics_context *context, struct restart *restart);
};

/* The physics of a run. */
struct physics_active {
    const struct physics *row;
    struct physics_context context;
    int first; /* number of the first interaction of the physics */
};
struct physics_set {
    int count;
    struct physics_active active[PHYSICS_COUNT + 1];
    struct interactions *interactions; /* borrowed */
};

/* Finds the physics that a scene asks for, after `grains`, adds their interactions and registers their
 * fields. `context` has all members but self and lists; `context->options` are those of grains. One
 * thread. */
void physics_begin(struct physics_set *set, const struct physics *grains,
                   const struct physics_context *context, struct interactions *interactions);

/* The row of a physics of the table, and the key of its section. */
const struct physics *physics_get(enum physics_number number);
const char *physics_key(enum physics_number number);

/* Checks the options of all physics, and creates the own data of all but grains, whose data are `self`. */
bool physics_create(struct physics_set *set, void *self, struct error *error);
void physics_free(struct physics_set *set);

/* The own data of each physics of the table; NULL of those that are not in the run. */
void physics_own(const struct physics_set *set, const void *own[PHYSICS_COUNT]);

/* Adds the particles of all physics. Collective; errors may differ between ranks. */
bool physics_fill(const struct physics_set *set, const struct physics_share *share, struct error *error);

/* Gives each physics its lists, after the interactions with their own lists are known
 * (interactions_divide). */
void physics_lists(struct physics_set *set, const struct interactions *interactions);

/* Calls `rebuilt` of all physics, after the search of a rebuild. True if the engine must rebuild again. */
bool physics_rebuilt(struct physics_set *set, struct ghosts *ghosts);

/* True if no physics reads its lists until the next rebuild. */
bool physics_rests(const struct physics_set *set);

/* True if a physics needs a rebuild in the step in progress. */
bool physics_due(const struct physics_set *set);

/* True if a physics has rows. */
bool physics_carries(const struct physics_set *set);

/* The rows of the physics in their order in the table, NULL of those without, after they have been asked for. */
void physics_rows(const struct physics_set *set, struct history_rows *rows[PHYSICS_COUNT],
                  int components[PHYSICS_COUNT]);

/* This rank's parts of the energies of all. */
void physics_energy(const struct physics_set *set, double *stored, double *taken);

/* This rank's part of the work of all on grains. */
double physics_work(const struct physics_set *set);

/* True if a physics says that the pair has no contact; `set` as context for struct force_context. physics_joins:
 * a physics may. */
bool physics_joined(const void *set, size_t i, size_t j);
bool physics_joins(const struct physics_set *set);

/* The parts of all in the stability of contacts. */
void physics_stiffen(const struct physics_set *set, struct stability *stability);
double physics_stiffest(const struct physics_set *set, const struct stability *stability);

/* True if a physics has tables; opens the tables of all; writes them. Collective; errors may differ between ranks. */
bool physics_has_tables(const struct physics_set *set);
bool physics_table_open(const struct physics_set *set, const char *directory, int64_t step,
                        struct error *error);
bool physics_table_write(const struct physics_set *set, struct error *error);

/* Calls `full_step` of all physics. Collective. */
void physics_full_step(const struct physics_set *set);

/* Runs the passes before output, after physics_full_step. Collective. */
void physics_look(const struct physics_set *set);

/* The smallest limit of all physics; the guards of all; the restart numbers of all. */
double physics_limit(const struct physics_set *set, double most);

/* The cause of a limit, if that of a physics other than grains is no larger; else NULL. Collective. */
const char *physics_limit_why(const struct physics_set *set, double limit);
void physics_guard(const struct physics_set *set, struct error *error);
void physics_restart(const struct physics_set *set, struct restart *restart);

/* The linear solvers of all physics, for the report. Collective. */
void physics_solvers(const struct physics_set *set, struct report *report);

/* Prints the lines of all physics. Collective. */
void physics_print(const struct physics_set *set, FILE *file);

#endif
