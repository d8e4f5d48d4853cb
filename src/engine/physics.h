/* SPDX-License-Identifier: BSD-3-Clause */
/* A physics is a set of effects on particles, in one folder and one row of a table (physics_table.h). Grains
 * (src/physics/grains) are a physics that is always active; a scene activates other physics by their sections.
 *
 * A physics states the fields that it needs, its interactions (which particles meet, and up to which
 * distance), and the passes that it adds to the step. The engine merges the passes of all active physics into
 * one plan (plan.h), keeps the pair lists of their interactions, and informs each physics of new lists. A
 * physics that no scene asks for costs nothing: no field, no pair, no pass.
 *
 * How to add a physics, in six steps (src/physics/density/ is the example, with everything in 150 lines):
 *
 *   1. Make a folder src/physics/NAME/ with the rows of its section of a scene, its fields and its observables
 *      (physics_table.h names the objects), and a local.mk that adds libNAME.la to PHYSICS_LIBS.
 *   2. Write its `struct physics`: interactions, create and destroy, passes.
 *   3. Add its row to PHYSICS_SECTION_TABLE, `include src/physics/NAME/local.mk` to Makefile.am, and its folder to `floors` in
 *      tests/lint, to the table of docs/architecture.md and to docs/folders.dot.
 *   4. Write its test against a plain double loop, on several ranks and threads and on every index (tests/app/density.sh).
 *   5. Features meet: add it to tests/app/features.sh and docs/features.md, or refuse a feature by name in `check`.
 *   6. `make pages` writes docs/scene.md and docs/output.md.
 *
 * How to add a pass of the step, in four steps:
 *
 *   1. Choose its place (enum pass_place). Forces are added in PASS_PAIRS, PASS_SHARES or PASS_CLOSE. They are
 *      complete when the step ends: a pass that reads the force on a particle runs in PASS_LOOK, or in
 *      PASS_FIRST of the next step.
 *   2. Write its function: `whole`, `rows`, `block` or `share`, see struct physics_pass.
 *   3. Add its row to the array of passes of the physics, for grains in src/physics/grains/grains_physics.c, and count it in
 *      `passes`. `scree check --all SCENE` prints the plan in which the pass then is.
 *   4. The time of a pass is a stage of the report, unless its row names the stage of another pass as `timer`:
 *      `make pages` writes it to docs/output.md. (Passes of PASS_LOOK count as output.)
 *
 * A physics sees only its context, never the simulation. What only some physics have stands in *facets*, structs of their
 * own below: a NULL facet says that the physics has no part in the matter, and so does a NULL function of a facet. The
 * engine visits a facet by PHYSICS_EACH (physics_set.h).
 *
 * One physics of a run moves the grains: the one that the scene gives and that has the facet `mover`, else src/physics/grains.
 * It adds the passes that move them, and context->moves_grains is true for it alone; the passes of src/physics/grains that kick,
 * drift and push are then left out, while the walls stay there and move: with another mover contacts and walls exert NO forces,
 * but for what its own passes add. Pair lists, histories of contacts, walls and ranks serve any mover. So choose: what changes
 * the force is a pass in PASS_SHARES or PASS_PAIRS of a physics without `mover`; what replaces v += dt f/m is a mover; a given
 * motion needs no code, but a group of the scene. */
#ifndef SCREE_ENGINE_PHYSICS_H
#define SCREE_ENGINE_PHYSICS_H

#include "kernel/comm/ghosts.h"
#include "base/exact.h"
#include "base/log.h"
#include "engine/clock.h"
#include "data/formats/checkpoint_state.h"
#include "data/formats/restart.h"
#include "kernel/pairs/history.h"
#include "kernel/pairs/interaction.h"
#include "kernel/pairs/history_rows.h"
#include "kernel/particles/fields.h"
#include "physics_table.h"
#include "data/scene/scene.h"
#include <stddef.h>

enum { PHYSICS_INTERACTIONS_MAX = 4 };

/* What the engine asks of an evaluation of forces. */
struct evaluation {
    double dt;         /* time since the evaluation before; 0: the forces of a given state, memories stay */
    bool sums, virial; /* energies are wanted, and the work of forces on distances */
};

/* The parts of a run that a physics may use. Borrowed; lists, classes and ghosts are those of the last
 * rebuild. */
struct physics_context {
    void *self;                    /* the result of `create` */
    const void *options;           /* the section of the scene for this physics; NULL: none */
    const struct physics_set *set; /* all physics of the run: for services of others */
    const struct scene *scene;
    const struct box *box;
    const struct comm *comm;
    const struct log *log; /* receiver of warnings and notes; one rank tells each */
    struct ghosts *ghosts; /* NULL: a single rank without copies */
    struct particles *particles;
    const struct size_classes *classes;
    const struct pairlist *list[PHYSICS_INTERACTIONS_MAX]; /* lists of the interactions, in their order */
    const struct clock *clock; /* number, time and length of the step; the length may change between steps */
    const struct evaluation *evaluation; /* of forces: the one in progress, or the last one */
    struct timers *timers; /* of the run, for the stages of the physics; only the main thread uses them */
    int threads;
    bool moves_grains; /* this physics moves the grains */
    bool ordered;      /* sums in an order that no layout changes */
};

/* The places of a step, in which passes run. All passes of a place run before those of the next. */
enum pass_place {
    PASS_FIRST, /* before all motion */
    PASS_MOVE,  /* particles move: passes by rows */
    PASS_MOVED, /* other things move */
    /* here the engine decides whether a rebuild is due, and rebuilds, or sends new values to the copies */
    PASS_PAIRS,  /* forces and other sums over pairs: passes by block */
    PASS_SHARES, /* effects on single particles: passes by thread */
    PASS_CLOSE,  /* sums over threads; then the engine sends REVERSE fields of copies to originals */
    PASS_LOOK,   /* not in the step, but before output and observables, if any are due */
    PASS_PLACES
};

/* A pass of a step. Exactly one of whole, rows, block and share is given. */
struct physics_pass {
    const char *name;
    const char *why; /* the reason in the scene for this pass; NULL: always there */
    enum pass_place place;
    const char *does;           /* its work in a few words, for the report's description of its stage */
    const char *timer;          /* stage of the report for the time (stages.h); NULL: named as the pass */
    const char *reads, *writes; /* names of fields, as "position velocity": shown to people */
    bool (*needed)(const struct physics_context *context); /* NULL: always */
    /* Called once; opens its own teams of threads. */
    void (*whole)(const struct physics_context *context);
    /* MOVE: the owned particles [first, last) of one size class; needs no interaction. Returns the largest squared
     * speed of those that it has moved, 0 if none, and no number if one is none: pair lists live by it. Adjacent passes
     * by rows and by block share one visit to each block (plan.h). Called by many threads at once, each with its
     * own particles. */
    double (*rows)(const struct physics_context *context, int thread, size_t first, size_t last,
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

/* A grain that is to enter. */
struct physics_grain {
    int material;
    double radius, density; /* mass over volume of its sphere */
    int64_t id;             /* chooses between the variants of what it becomes ... */
    int variant;            /* ... or this number does; -1: the id */
    int shape; /* what its source names (struct source_form); 0: material and radius choose; -1: it stays a sphere */
};

/* A sphere of which a grain is made; of a rock the ball around it. */
struct physics_part {
    double radius, mass;
    double inner; /* radius of the largest sphere about the centre that what it stands for holds */
};

/* Facet of a physics with interactions: which particles meet, and up to which distance. */
struct physics_search {
    int interactions;
    /* `context` of a row is replaced by the options, or by the own data if `range_of_self`. */
    struct interaction interaction[PHYSICS_INTERACTIONS_MAX];
    bool range_of_self;
    /* True if the physics reads its lists in `rebuilt` alone and nothing that it knows moves: where all physics with
     * interactions say so, the engine then releases the memory of the search. NULL: false. */
    bool (*rests)(const struct physics_context *context);
};

/* Facet of a physics that bounds the time step. */
struct physics_limit {
    /* The largest time step, up to `most`, that is stable for the present state. Collective. */
    double (*of)(const struct physics_context *context, double most);
    const char
        *why;   /* its cause, for messages: "advection of the fluid ..."; NULL: the mover's `why` tells */
    bool stays; /* no state changes the limit: a run does not look at it again */
};

/* Facet of a physics that makes particles of its own (physics_table.h). */
struct physics_maker {
    /* Bits 1 << kind (kinds.h) of those that move. NULL: none. */
    unsigned (*moving)(const void *options);
    /* Appends this rank's share, wherever the particles lie: the first rebuild sends them to their
     * owners. After the grains have been made, in a run that is not resumed; kinds (kinds.h) are registered. The same
     * ids on any number of ranks. Collective. Errors may differ between ranks. */
    bool (*fill)(const struct physics_context *context, const struct physics_share *share,
                 struct error *error);
    /* The sphere `number` of those that a grain becomes if it enters a run; false: it has no more, or no such variant. Grains
     * that stay as they are have none. The same on all ranks; any thread. NULL: all grains stay. */
    bool (*part)(const struct physics_context *context, const struct physics_grain *grain, int number,
                 struct physics_part *part);
    /* The least radius above `radius` at which grains of a material become something else; INFINITY: there is none. Grains of that
     * radius belong to those below. NULL: there is none. */
    double (*edge)(const struct physics_context *context, int material, double radius);
    /* Makes particle k of this rank, a grain that has just been appended, and its parts, which are appended with ids from
     * `first_id` on. In a rebuild, without copies. */
    void (*join)(const struct physics_context *context, size_t k, int64_t first_id);
    /* Refuses (user) a grain that the calling program adds during the run, or, where it is NULL, that it deletes any. Collective.
     * NULL: all may come and go. */
    bool (*admit)(const struct physics_context *context, const struct physics_grain *grain,
                  struct error *error);
};

/* Facet of a physics that remembers pairs: rows at both particles of a pair (kernel/pairs/history.h), by owned particle, of which
 * `components` doubles count. The engine asks before each rebuild, and for a checkpoint; it carries the rows with their
 * particles through deletion, migration, reorder, checkpoint and resume. The physics forgets what it derived from their
 * numbers; `rebuilt` finds them in the new order. */
struct physics_rows {
    struct history_rows *(*of)(
        const struct physics_context
            *context); /* `start` is there, owned + 1 entries; NULL: this scene has no rows */
    int components;    /* 0: `of` says it in the rows, as the scene asks for more or fewer */
    /* True if the step in progress must rebuild. The same on all ranks. */
    bool (*due)(const struct physics_context *context);
    /* After `rebuilt`. True if the ranges of interactions or the rows have changed: the engine
     * rebuilds at once, a second time, with new size classes. The same on all ranks; false the second time.
     * Collective. */
    bool (*again)(const struct physics_context *context);
};

struct stability;
struct timestep_body;

/* Facet of a physics that joins grains. */
struct physics_joints {
    /* True if two particles of the list of contacts, one of them owned, have no contact now; any thread. Asked
     * if `joins` is true, at the start. */
    bool (*joined)(const struct physics_context *context, size_t i, size_t j);
    bool (*joins)(const struct physics_context *context);
    /* True if this physics has the contacts of an owned particle with walls, which the law then leaves out; any thread, where
     * `joins` is true. NULL: of none. */
    bool (*alone)(const struct physics_context *context, size_t i);
    /* Raises what sets owned particle i, or if i is SIZE_MAX a grain that is to enter, apart from a sphere in the stable step
     * (physics/grains/motion/timestep.h). NULL: nothing does. */
    void (*ease)(const struct physics_context *context, size_t i, const struct physics_grain *grain,
                 struct timestep_body *body);
    /* Its part in the stability of contacts (physics/grains/motion/stability.h): adds the springs at owned particles, with newton on
     * also at copies, whose sums then go home; the largest L_i + L_j of its pairs. NULL: it has none. */
    void (*stiffen)(const struct physics_context *context, struct stability *stability);
    double (*stiffest)(const struct physics_context *context, const struct stability *stability);
};

/* This rank's parts in the balance of energies: energy that the physics holds; energy that it has taken from the grains
 * for good since the start; its work on grains since the start, negative if it took energy; what of the energy held may become
 * another form (guards.energy), 0 or more: `held` counts, too, where it is larger. */
struct physics_energy {
    double held, taken, work, play;
};

/* Facet of a physics with a table of its own in the folder of a run: opens it, cut behind `step` if the run goes on from
 * there (-1: a new run); appends the rows that are due: with output, before a checkpoint, at the end. Collective;
 * errors may differ between ranks. */
struct physics_table {
    bool (*open)(const struct physics_context *context, const char *directory, int64_t step,
                 struct error *error);
    bool (*write)(const struct physics_context *context, struct error *error);
};

struct notes;
struct output_shapes; /* data/formats/output_shapes.h */
struct report_part;   /* report_part.h */

/* Facet of a physics with more to show than fields and observables. */
struct physics_shown {
    /* Stages of the report beside those of the passes, which the physics starts by timer_enter. */
    int stages;
    const struct timer_stage *stage;
    /* Brings velocities that integrator_full_step reads up to date, before they are observed. Collective. */
    void (*full_step)(const struct physics_context *context);
    /* Fills its part of a view of the run; of the report; of the notes on a scene, collective (notes.h). */
    void (*view)(const struct physics_context *context, struct output_view *view);
    void (*report)(const struct physics_context *context, struct report_part *part);
    void (*notes)(const struct physics_context *context, struct notes *notes);
    /* Adds the shapes that orientations in its fields are of. NULL: none. Any rank. */
    void (*shapes)(const struct physics_context *context, struct output_shapes *shapes);
    /* Notes at the end of a run that began at step `first`, on what it has seen. NULL: none. Any rank. */
    void (*seen)(const struct physics_context *context, uint64_t first, struct notes *notes);
};

/* The energies of grains, this rank's part: the last one is the work taken for good since the start. */
enum {
    GRAINS_KINETIC,
    GRAINS_ROTATIONAL,
    GRAINS_GRAVITY,
    GRAINS_NORMAL,
    GRAINS_TANGENTIAL,
    GRAINS_TAKEN,
    GRAINS_ENERGIES
};

/* The sums that make the stress of the box: six products of distance and force, and the energy of normal springs. */
enum { STRESS_SUMS = 7 };

/* Facet of a physics that can move the grains. The engine asks the one that does; but `prepare` of each.
 *
 * The passes at PASS_MOVE of a mover do what integrator_advance does for grains (physics/grains/motion/integrator.h): they
 * move the particles, set the force record of each to zero, give prescribed groups their motion and leave carried grains to
 * their carrier, and leave z as it is in two dimensions. tests/mpi/test_mover.c has a whole one in 40 lines. */
struct physics_mover {
    /* The evaluation that follows, or the length of steps, is another one: context->evaluation, context->clock. */
    void (*prepare)(const struct physics_context *context);
    /* After the forces of the state from which a run starts. Resumed runs do without. Collective. */
    void (*begin)(const struct physics_context *context);
    /* Moves the velocities of grains back by half of `dt`, under the present forces: after `begin`, and where the length of
     * steps changes, by the difference. At a resume, too, where that is often 0: what has become free there has velocities of
     * the full step, and goes back by half of a step. The stored velocities are then those of half a step before, and files and observables show
     * v + dt/2 (f/m + g). NULL: the stored velocities are those of the full step, and are shown as they are. */
    void (*stagger)(const struct physics_context *context, double dt);
    /* The largest stable step for what may come, from the particles at the start; INFINITY: any. Collective. `why`
     * writes the cause. NULL: any. */
    double (*expected)(const struct physics_context *context);
    void (*why)(const struct physics_context *context, char *text, size_t room);
    /* The fraction of the stable step that a run takes if its scene gives none. NULL: 1. */
    double (*fraction)(void);
    /* Sides of contacts in the last evaluation. NULL: none. */
    size_t (*contacts)(const struct physics_context *context);
    /* Adds this rank's sums of the last evaluation, for which evaluation->virial was set: without rounding to `exact`,
     * if that is not NULL, else to `sum`. */
    void (*stress)(const struct physics_context *context, struct exact exact[STRESS_SUMS],
                   double sum[STRESS_SUMS]);
    /* Adds this rank's energies at the full step; `mechanical`: without what needs sums at each step. */
    void (*energies)(const struct physics_context *context, bool mechanical, double energy[GRAINS_ENERGIES]);
    /* The memory of contacts, of pairs of the first list of the run: the engine keeps it over rebuilds, checkpoints
     * and resumes. Asked once, after `create`. NULL: none. */
    struct history *(*history)(const struct physics_context *context);
};

/* Facet of a physics that holds what grains meet beside grains: walls. At most one of a run has it. */
struct physics_obstacles {
    /* True if a sphere at x (box-relative) would overlap one. Any thread. */
    bool (*taken)(const struct physics_context *context, const double x[3], double radius);
    /* A bound on their displacement since the last search. */
    double (*displacement)(const struct physics_context *context);
    /* Work on grains since the start, this rank's part. */
    double (*work)(const struct physics_context *context);
    /* True if `search`, `detach` and `attach` are needed. `search` runs in a rebuild, once particles have their places. */
    bool (*needed)(const struct physics_context *context);
    void (*search)(const struct physics_context *context);
    /* The memory of contacts with them as rows; and back, after `search`. */
    void (*detach)(const struct physics_context *context, struct history_rows *rows);
    void (*attach)(const struct physics_context *context, const struct history_rows *rows);
    /* In a rebuild, after particles have come or gone. */
    void (*changed)(const struct physics_context *context);
    /* Fills `error` if the place or the motion of one, or the force on it, is not finite. */
    void (*finite)(const struct physics_context *context, struct error *error);
};

/* Facet of a physics with a fluid that carries grains which it does not resolve; the physics of drag asks for it. */
struct physics_carrier {
    /* False if the options leave no grain unresolved; else density, dynamic viscosity and the largest radius of those. */
    bool (*of)(const void *options, double *density, double *viscosity, double *largest);
};

/* Facet of a physics with its own part of a checkpoint, beside fields, rows and restart numbers. */
struct physics_record {
    /* Fills its part; `rows` are those of the obstacles. All is borrowed until the checkpoint is written. Collective. */
    void (*save)(const struct physics_context *context, const struct history_rows *rows,
                 struct checkpoint *checkpoint);
    /* Refuses a checkpoint of another scene. */
    bool (*fits)(const struct physics_context *context, const char *path,
                 const struct checkpoint_loaded *loaded, struct error *error);
    /* Takes its part, after all restart numbers and before its rows; fills the rows of the obstacles. */
    void (*resume)(const struct physics_context *context, struct checkpoint_loaded *loaded,
                   struct history_rows *rows);
};

struct physics {
    const char *name;
    bool box_moves; /* it works in a box that moves (kernel/particles/box.h); else such a scene is refused */
    int passes;
    const struct physics_pass *pass;
    /* Refuses options that do not go together: a user's error. NULL: nothing to refuse. */
    bool (*check)(const struct physics_context *context, struct error *error);
    /* Makes the physics' own data: after the particles' fields have been registered, before the first
     * rebuild. NULL: no data. */
    void *(*create)(const struct physics_context *context);
    void (*destroy)(void *self);
    /* Called after each rebuild, when the lists are new. NULL: nothing to do. */
    void (*rebuilt)(const struct physics_context *context);
    /* Looks for physical nonsense after a step; fills `error`. NULL: no check. */
    void (*guard)(const struct physics_context *context, struct error *error);
    /* Sets its parts in the balance of energies. NULL: none. */
    void (*energy)(const struct physics_context *context, struct physics_energy *energy);
    /* Prints lines for `scree check`, by rank 0 alone, at the start. NULL: none. Collective. */
    void (*print)(const struct physics_context *context, FILE *file);
    /* Adds the numbers that a resume needs, with their names. NULL: none. */
    void (*restart)(const struct physics_context *context, struct restart *restart);
    /* The facets. */
    const struct physics_search *search;
    const struct physics_limit *limit;
    const struct physics_maker *maker;
    const struct physics_rows *rows;
    const struct physics_joints *joints;
    const struct physics_table *table;
    const struct physics_shown *shown;
    const struct physics_mover *mover;
    const struct physics_obstacles *obstacles;
    const struct physics_record *record;
    const struct physics_carrier *carrier;
};

#endif
