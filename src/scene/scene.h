/* SPDX-License-Identifier: BSD-3-Clause */
/* The scene: all that a user sets, read from a YAML file against one schema (schema.h), as the option structs
 * of the modules by value, plus the data of the scene alone. No other module knows the file.
 *
 *     scene_text.h: the text of the file
 *         ->  scene_read.h, which calls the rest:
 *         ->  tree.h: nodes with lines, --set applied
 *         ->  schema_read.h: every key checked and stored
 *         ->  finish.h: derived values
 *         ->  scene_check.h: combinations
 *     scene_particles.h: the particles of its sources
 *
 * A number that the user did not give and that has no default is NAN while reading; finish.c leaves none
 * behind in the data of the modules (`step.dt`, for one, is then 0). Lengths of regions, sources, walls and
 * observables are in the user's coordinates; everything handed to particles is box-relative. */
#ifndef SCREE_SCENE_SCENE_H
#define SCREE_SCENE_SCENE_H

#include "comm/domain.h"
#include "comm/ghosts.h"
#include "contact/law.h"
#include "walls/wall.h"
#include "core/error.h"
#include "index/index.h"
#include "integrate/integrator.h"
#include "formats/output_options.h"
#include "particles/box.h"
#include "particles/classes.h"
#include "particles/particles.h"
#include "physics_table.h"
#include "scene/insertion.h"
#include "scene/source.h"
#include <stdio.h>

enum {
    SCENE_PATH_MAX = 1024,
    SCENE_NOTE_MAX = 256,
    SCENE_NAME_MAX = 64,
    SCENE_IDS_MAX = 1024,
    SCENE_PAIRS_MAX = 528
};

struct tree_node;

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

/* Which copies a rank gets, as the scene says it. */
enum scene_ghosts { SCENE_GHOSTS_FULL, SCENE_GHOSTS_REDUCED, SCENE_GHOSTS_AUTO };

/* The action of a guard. */
enum scene_guard { SCENE_GUARD_STOP, SCENE_GUARD_WARN, SCENE_GUARD_OFF, SCENE_GUARD_AUTO };

struct scene_guards {
    enum scene_guard overlap, nan, speed, step;
    enum scene_guard energy; /* AUTO: stop, with a cheaper and coarser look, where there can be one */
    double overlap_bound;    /* largest overlap / smaller radius */
    double energy_bound;     /* largest growth without cause / energy in play */
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

struct scene {
    char file[SCENE_PATH_MAX];   /* as named in messages */
    char note[SCENE_NOTE_MAX];   /* message of the reader to the user; "" if none */
    char folder[SCENE_PATH_MAX]; /* start of relative paths, ends with '/' or is empty */
    struct tree_node *tree;      /* the parsed text, for places in messages; owned */
    char title[256];
    enum scene_units units;
    uint64_t seed;
    struct box box;
    double box_lower[3], box_upper[3];
    int leave_all;
    int leave_side[3][2];
    double gravity[3];
    double duration; /* time; 0: by step.count */
    struct scene_step step;
    char integrator[SCENE_NAME_MAX];
    int threads; /* 0: as many as OpenMP offers */
    enum scene_simd simd;

    struct law_options law;
    int materials;
    struct law_material material[LAW_MATERIALS_MAX];
    int pairs;
    struct scene_pair pair[SCENE_PAIRS_MAX];
    struct law_pair law_pair[LAW_MATERIALS_MAX][LAW_MATERIALS_MAX]; /* complete: input of law_prepare */

    int walls;
    struct wall_options wall[WALLS_MAX];

    int groups; /* group[0] is "free" */
    struct scene_group group[INTEGRATOR_GROUPS_MAX];

    /* Sections of physics (physics_table.h): options as each has them, and 1 where it is given. */
    double physics[PHYSICS_COUNT][PHYSICS_OPTIONS_MAX];
    int physics_given[PHYSICS_COUNT];

    int sources;
    struct source_options source[SOURCES_MAX];
    int insertions;
    struct insertion_options insertion[INSERTIONS_MAX];
    int deletions;
    struct deletion_options deletion[DELETIONS_MAX];

    struct scene_index index;
    struct classes_options classes;
    bool reproducible; /* the same bits on any layout; newton and ghosts then do not matter */
    struct ghosts_options ghosts;
    struct domain_options domain;
    int ghosts_name; /* enum scene_ghosts */
    struct scene_guards guards;
    struct output_options output;
};

/* Frees a scene and sets it to NULL. */
void scene_free(struct scene **scene);

/* "FILE:LINE" or "command line" of a key ("walls[0].radius"), or of the nearest section above it that was
 * given. Writes at most `room` bytes; returns `place`. */
const char *scene_place(const struct scene *scene, const char *key, char *place, size_t room);

/* True if the scene itself gives `key` in a section ("box"), be it its default. */
bool scene_gives(const struct scene *scene, const char *section, const char *key);

/* Fills `error` with "PLACE: KEY: TEXT"; returns false. */
bool scene_fail(const struct scene *scene, struct error *error, const char *key, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* Registers the fields that the scene needs beyond those of every set; `law` as prepared from it. */
void scene_register(const struct scene *scene, const struct law *law, struct particles *particles);

/* Motion of the groups and gravity as the integrator wants them; dt stays 0. */
void scene_integrator(const struct scene *scene, struct integrator_context *context);

/* Sets `reproducible` in a scene that was read, and the settings that follow from it. */
void scene_make_reproducible(struct scene *scene);

/* Number of a material or wall by name, or -1. */
int scene_material(const struct scene *scene, const char *name);
int scene_wall(const struct scene *scene, const char *name);

#endif
