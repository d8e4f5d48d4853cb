/* SPDX-License-Identifier: BSD-3-Clause */
/* The state of a simulation: everything that a run holds. The parts know nothing of each other beyond what the arrows
 * of docs/architecture.md allow; they meet here. simulation.h makes one, step.h and rebuild.h advance it. */
#ifndef SCREE_ENGINE_STATE_H
#define SCREE_ENGINE_STATE_H

#include "contact/force.h"
#include "engine/plan.h"
#include "core/team.h"
#include "integrate/timestep.h"
#include "formats/output.h"
#include "pairs/skin.h"
#include "pairs/sweep.h"
#include "scene/compare.h"
#include "scene/scene_particles.h"

enum { TUNING_VARIANTS_MAX = 8 };

struct simulation;
struct domain;
struct walls;

/* What all ranks must know of a step before they go on; one reduction. */
struct step_signals {
    bool rebuild;
    bool stop;       /* a signal asked the run to end */
    bool checkpoint; /* wall clock says so */
    bool error;      /* a rank has an error */
};

/* The guard of energies (guards.c). Energies as in observables. */
struct guard_energy {
    struct observables *observables; /* NULL: not asked for */
    bool mechanical; /* kinetic, elastic and potential energy alone, which cannot grow: needs no sums each
                        step */
    bool begun;
    double start, last, gained, in_play;
    uint64_t step, changes; /* of the last look: its number, particles that have come and gone */
};

/* Trials of what an index that chooses has on offer (tune.c). */
struct tuning {
    int64_t choices; /* of all ranks together: more of them start the trials again */
    int variant, rebuilds;
    bool settled;
    double start, seconds[TUNING_VARIANTS_MAX];
};

/* Steps and time: time = time_base + (step - step_base) dt. */
struct clock {
    uint64_t step; /* steps done */
    uint64_t step_base;
    double time, time_base, dt;
    double dt_fraction; /* of the stable step that dt is; 0: dt was given */
};

/* The stable step, and what it was found from (timing.h). */
struct timing {
    struct timestep_limits limits;
    double expected;         /* the stable step for contacts to come, those that there are left out */
    double overlap_started;  /* largest overlap at the start of a run, over the smaller radius */
    double speed_expected;   /* of an impact: what the stable step counts with; length/time */
    double overlap_expected; /* of the heaviest like particles, or of one and a wall, at that speed, over the
                                radius */
};

/* What grains keep (grains.c). */
struct grains {
    struct law law;
    struct integrator_context motion;
    const struct pairlist *list; /* of contacts; one of the interactions' */
    struct history *history;     /* NULL: the law has none */
    struct walls *walls;         /* NULL: none */
    struct force_loop *loop;
    struct force_context contact;
    struct force_sums sums;     /* of the last evaluation, this rank's part */
    double taken;               /* sum of force_sums.taken since the start, this rank's part */
    bool sums_each_step;        /* dissipated energy is observed */
    double (*speed)[CLASS_MAX]; /* [thread][class]: largest squared speed of the last drift */
    double servo_force[WALLS_MAX][3];
};

/* The search for pairs, and when it is due again. */
struct search {
    struct index *index;
    struct tuning tuning;
    double pairs_seconds;             /* wall time of all pair list builds */
    struct index_view view;           /* of the last rebuild */
    struct interactions interactions; /* and their lists */
    struct skin *skin;
    struct sweep *sweep; /* the plan of the fused order; NULL: the scene wants the plain one alone */
};

/* This rank among others. */
struct ranks {
    struct domain *domain;
    bool wrap[3]; /* directions that the index wraps */
    struct ghosts *ghosts;
    bool alone; /* one rank: nothing to exchange */
    struct load {
        bool begun, fresh;  /* divided at all; divided since the imbalance was measured */
        double reached;     /* imbalance right after the last division; 0: none yet */
        double seconds;     /* of work when it was measured last */
        uint64_t divisions; /* by weight */
    } load;                 /* load.h */
};

/* Particles that come and go (sources.h). */
struct sources {
    struct scene_census census;
    int64_t next_id;
    double placing_told; /* seconds: when a placement last told how far it is; 0: not yet */
    struct insertion insertion[INSERTIONS_MAX];
    struct insertion_state state[INSERTIONS_MAX];
    uint64_t inserted, deleted;
    uint64_t last_step; /* at which particles came or went */
};

/* What a checkpoint brought (resume.h). */
struct resumed {
    double dt;                    /* step of the run that wrote it; 0: not resumed */
    double fraction;              /* and its fraction */
    int grid[3];                  /* its ranks per direction */
    struct scene_changes changes; /* of the scene since */
    uint64_t masses;              /* particles that got another mass */
};

/* What guards remember (guards.h). */
struct guards {
    unsigned warned; /* bit by guard: has warned */
    struct guard_energy energy;
};

/* What all ranks agree on in a step (decide.h). */
struct agree {
    double value[2 * CLASS_MAX + 4]; /* bounds of the skin and signals, on their way through all ranks */
    struct comm_reduction reduction;
    struct step_signals signals; /* in: this rank's; out of step_run: everybody's */
};

struct simulation {
    const struct comm *comm;   /* borrowed */
    const struct scene *scene; /* borrowed */
    int threads;               /* that work is dealt out to */
    struct team team;          /* those that work at a time */
    struct particles *particles;
    struct size_classes classes;
    bool classes_stale; /* radii may have changed: choose classes again at the next rebuild */
    uint64_t total;     /* particles on all ranks */
    struct clock clock;
    struct timing timing;
    struct grains grains;
    struct search search;
    struct ranks ranks;
    struct sources sources;
    struct guards guards;
    struct agree agree;
    struct physics_set physics;
    struct step_plan plan;
    struct resumed resumed;
    struct lineage lineage; /* this run, and those that it goes on from */
    struct error error;     /* of a guard or of particles that left; checked after each step */
    struct timers timers;
};
#endif
