/* SPDX-License-Identifier: BSD-3-Clause */
/* The state of a simulation: everything that a run holds. The parts use each other only as the floors of
 * docs/architecture.md allow; this struct joins all parts. simulation.h makes a simulation, step.h and rebuild.h
 * advance it. */
#ifndef SCREE_ENGINE_STATE_H
#define SCREE_ENGINE_STATE_H

#include "engine/plan.h"
#include "engine/physics_set.h"
#include "base/log.h"
#include "base/team.h"
#include "data/formats/output.h"
#include "kernel/pairs/skin.h"
#include "kernel/pairs/skin_choice.h"
#include "kernel/pairs/sweep.h"
#include "data/scene/compare.h"
#include "data/scene/scene_particles.h"

enum { TUNING_VARIANTS_MAX = 8 };

struct simulation;
struct domain;

/* The signals that all ranks must agree on in a step; one reduction. */
struct step_signals {
    bool rebuild;
    bool stop;       /* a signal asked the run to end */
    bool checkpoint; /* a checkpoint is due by wall clock */
    bool error;      /* a rank has an error */
};

/* The guard of energies (guards.c). */
struct guard_energy {
    bool wanted;     /* the scene asks for the guard */
    bool mechanical; /* only kinetic, elastic and potential energy, which cannot grow: no sums at each
                        step */
    bool begun;
    double start, last, gained, in_play;
    uint64_t step, changes; /* at the last check: number of the step; particles that have come and gone */
};

/* Trials of the variants that an index offers (tune.c). */
struct tuning {
    int64_t choices; /* choices of all ranks together: more choices start the trials again */
    int variant, rebuilds;
    bool settled;
    double start, seconds[TUNING_VARIANTS_MAX];
};

/* The stable step (timing.h). */
struct timing {
    double stable;   /* for the contacts that there are, and those that may come */
    double expected; /* for contacts that may come alone */
    char why[256];   /* what sets `stable`, if that is finite, for the brackets behind the number */
};

/* Edges and shear of the box that follow the stress (deform.c). */
struct box_servo {
    bool on, shears;                    /* the shear follows it, too */
    double mass;                        /* of all particles */
    double bound;                       /* largest rate of an edge, 1/time, for a target of 1 */
    double drift;                       /* the part of the rate of the shear that adds up, 1/time */
    int threads;                        /* of the sums of the stress */
    struct exact (*exact)[STRESS_SUMS]; /* by thread: sums that no layout changes; NULL: not wanted. Owned */
};

/* The search for pairs, and when it is due again. */
struct search {
    struct index *index;
    struct tuning tuning;
    double pairs_seconds;   /* wall time of all pair list builds */
    struct index_view view; /* of the last rebuild */
    uint64_t revision;      /* of the particles at the last build of the index */
    bool sorts;             /* the next rebuild sorts the particles, as a rebuild after a resume does */
    uint64_t sorted;        /* rebuilds that sorted, the first one among them */
    struct interactions interactions; /* the interactions with their lists */
    const struct pairlist *list;      /* the list of the sweep: of the first interaction */
    struct history *history;    /* memory of contacts of these pairs, of who moves the grains; NULL: none */
    double (*speed)[CLASS_MAX]; /* [thread][class]: largest squared speed of the last drift */
    struct skin *skin;
    struct skin_choice choice; /* of the skin, with `skin: auto`; skin_auto.h */
    struct sweep *sweep;       /* the plan of the fused order; NULL: the scene wants only the plain order */
};

/* The division among ranks, and this rank's copies. */
struct ranks {
    struct domain *domain;
    bool wrap[3]; /* directions that the index wraps */
    struct ghosts *ghosts;
    bool alone; /* one rank: nothing to exchange */
    struct load {
        bool begun, fresh;  /* box was divided; divided since the imbalance was measured */
        double reached;     /* imbalance right after the last division; 0: none yet */
        double seconds;     /* of work at the last measurement */
        uint64_t divisions; /* number of divisions by weight */
    } load;                 /* load_balance.h */
};

/* Particles that come and go (sources.h). */
struct sources {
    struct scene_census census;
    int64_t next_id;
    double placing_told;         /* seconds: clock at the last progress line of a placement; 0: none yet */
    struct insertion *insertion; /* by number; owned, as the next */
    struct insertion_state *state;
    uint64_t *lost; /* particles of this run that were placed where the box deletes them */
    uint64_t inserted, deleted;
    double deleted_mass; /* this rank's part */
    uint64_t last_step;  /* last step at which particles came or went */
    /* What the calling program adds and deletes at the next rebuild, the same on all ranks. */
    struct given {
        size_t added, added_room, taken, taken_room;
        struct insertion_candidate *add;
        int64_t *take; /* ids */
    } given;
};

/* Data read from a checkpoint (resume.h). */
struct resumed {
    double dt;                    /* time step of the run that wrote the checkpoint; 0: not resumed */
    double fraction;              /* dt_fraction of that run */
    int grid[3];                  /* ranks per direction of that run */
    struct scene_changes changes; /* changes of the scene since the checkpoint */
    uint64_t masses;              /* number of particles whose mass was changed */
};

/* The place of a run among the stages of its scene (run_stages.h); all zero without stages. */
struct stage_place {
    uint64_t number; /* of the present stage, from 0 */
    uint64_t last;   /* the step that ends the stage, as its conditions hold; 0: they do not */
    double began;    /* time at the beginning of the stage */
};

/* Data of the guards (guards.h). */
enum guard_kind { GUARD_SPEED, GUARD_ENERGY, GUARD_STEP, GUARD_KINDS };
struct guards {
    bool warned[GUARD_KINDS];
    struct guard_energy energy;
};

/* Data of the agreement of all ranks in a step (decide.h). */
struct agree {
    double value[2 * CLASS_MAX + 4]; /* bounds of the skin and signals, in the reduction */
    struct comm_reduction reduction;
    struct step_signals signals; /* before step_run: of this rank; after step_run: of all ranks */
};

/* The program that runs the simulation, if it is not scree's own. All zero: scree's own. */
struct simulation_caller {
    struct log log; /* receiver of warnings and notes */
    bool quiet;     /* nothing is told of the progress of placing particles */
    /* Adds forces of the caller's to those on owned particles, once in each evaluation of forces, before forces
     * of copies return to their originals. Main thread of every rank. NULL: none. */
    void (*force)(void *context, struct simulation *simulation);
    void *context; /* of `force` */
};

struct simulation {
    struct simulation_caller caller;
    const struct comm *comm;   /* borrowed */
    const struct scene *scene; /* borrowed */
    struct box box;            /* as it is now: that of the scene may move */
    struct box_servo servo;    /* of the box */
    int threads;               /* threads to which work is dealt out */
    struct team team;          /* threads that work at a time */
    struct particles *particles;
    struct size_classes classes;
    bool classes_stale; /* radii may have changed: the next rebuild chooses classes again */
    uint64_t total;     /* particles on all ranks */
    struct clock clock;
    struct stage_place stage;
    struct output_crossing crossings[OUTPUT_PLANES_MAX]; /* crossings.h */
    struct timing timing;
    struct evaluation evaluation; /* of forces */
    bool sums_each_step;          /* dissipated energy is observed, or guarded */
    struct search search;
    struct ranks ranks;
    struct sources sources;
    struct guards guards;
    struct agree agree;
    struct physics_set physics;
    struct step_plan plan;
    struct resumed resumed;
    struct lineage lineage; /* this run and its earlier runs */
    struct error error;     /* error of a guard, or of particles that left; checked after each step */
    struct timers timers;
};
#endif
