/* SPDX-License-Identifier: BSD-3-Clause */
/* The sections of a scene that no module has options for. Read scene.h first. */
#ifndef SCREE_SCENE_SCENE_SECTIONS_H
#define SCREE_SCENE_SCENE_SECTIONS_H

#include "data/formats/output_options.h"
#include "index/index.h"
#include "data/scene/region.h"
#include <stdbool.h>
#include <stdint.h>

enum {
    SCENE_PATH_MAX = 1024,
    SCENE_NOTE_MAX = 256,
    SCENE_NAME_MAX = 64,
    SCENE_IDS_MAX = 1024,
    SCENE_PAIRS_MAX = 32640 /* of 255 materials */
};

enum scene_units { SCENE_UNITS_SI, SCENE_UNITS_NONE };

/* Length of a run and of its step. */
struct scene_step {
    double dt;             /* > 0: given; 0: fraction x the stable step */
    double fraction;       /* of the stable step; set where dt is 0 */
    int64_t count;         /* steps; -1: by duration */
    bool force;            /* run although dt is above the stable step */
    bool fused;            /* particles move just before their first contact, instead of all at once */
    int64_t rebuild_every; /* most steps between two rebuilds; 0: when the skin is used up */
    int contacts;     /* simultaneous contacts counted for the stable step; 0: the default of timestep.h */
    double speed_max; /* largest impact speed expected for the stable step; 0: from the particles */
};

/* Shear of the box. */
struct scene_shear {
    double rate;        /* 1/time */
    double offset;      /* of the image one edge up the gradient, at the start; length */
    int flow, gradient; /* directions */
    bool profile;       /* particles start with the velocity of the mean flow in addition to their own */
};

/* Strain of the box. */
struct scene_strain {
    double rate[3]; /* of each edge, 1/time */
    bool profile;   /* as in struct scene_shear */
};

/* Stress of the box, positive in compression; NAN: not given. */
struct scene_stress {
    double pressure;  /* all edges change alike */
    double normal[3]; /* the edge along each direction changes */
    double shear[3];  /* xy, xz, yz, one at most: the rate of the shear changes */
    double inertia;   /* bound on the rates, as an inertial number */
};

/* Vector instructions used at most; the numbers are those of enum index_instructions. */
enum scene_simd { SCENE_SIMD_AUTO, SCENE_SIMD_BASELINE, SCENE_SIMD_V3, SCENE_SIMD_V4 };

/* The names of enum scene_simd: those of the force loop's kernels. */
const char *scene_simd_name(enum scene_simd simd);

enum scene_group_motion { SCENE_FREE, SCENE_FROZEN, SCENE_MOVING };

/* A group: group 0 is "free" and always there. A particle belongs to the group that its source names, else to
 * the last group whose selection it meets; a group without any selection is filled by sources alone. */
struct scene_group {
    char name[SCENE_NAME_MAX];
    enum scene_group_motion motion;
    double velocity[3], omega[3]; /* MOVING */
    bool by_region;
    struct region region; /* centre inside */
    int material;         /* -1: any */
    int id_count;         /* 0: any */
    int64_t id[SCENE_IDS_MAX];
    double radius_above, radius_upto; /* radius in (above, upto] */
    bool selects;                     /* true if any of the criteria was given */
};

/* Stages (scene_stage.h). */
enum { STAGES_MAX = 32, STAGE_CONDITIONS_MAX = 8, STAGE_SET_MAX = 4096 };

/* A bound on an observable with one column. */
struct scene_condition {
    struct observable_request request;
    double at_least, at_most; /* in base units of the observable; NAN: no such bound */
};

/* A stage ends when its duration is over, or when all conditions hold at a look. */
struct scene_stage {
    char name[OUTPUT_NAME_MAX];
    double duration; /* time; INFINITY: until the conditions hold */
    double after;    /* time of the stage before which nobody looks at the conditions */
    int64_t every;   /* steps between two looks */
    int conditions;
    struct scene_condition condition[STAGE_CONDITIONS_MAX];
    char set[STAGE_SET_MAX]; /* keys and values, as YAML in one line; "": none */
};

/* Which copies a rank gets, as the scene says it. */
enum scene_ghosts { SCENE_GHOSTS_FULL, SCENE_GHOSTS_REDUCED, SCENE_GHOSTS_AUTO };

/* The action of a guard. */
enum scene_guard { SCENE_GUARD_STOP, SCENE_GUARD_WARN, SCENE_GUARD_OFF, SCENE_GUARD_AUTO };

struct scene_guards {
    enum scene_guard overlap, nan, speed, step;
    enum scene_guard energy;   /* AUTO: stop, with a cheaper and coarser look, where there can be one */
    enum scene_guard residual; /* of linear solves */
    double overlap_bound;      /* largest overlap / smaller radius */
    double energy_bound;       /* largest growth without cause / energy in play */
};

/* One entry of material_pairs as the user wrote it. */
struct scene_pair {
    int material[2]; /* -1: the default for all pairs not named */
    double restitution, friction, rolling_friction, k_n, k_t, gamma_n, gamma_t; /* NAN: not given */
    struct law_extra extra;                                                     /* NAN: not given */
    int between_count;
};

struct scene_index {
    char name[SCENE_NAME_MAX];
    struct index_params params;
    bool measure;    /* auto: time variants of the choice */
    int level_cells; /* how many of params.level_cell were given */
};

#endif
