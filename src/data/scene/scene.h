/* SPDX-License-Identifier: BSD-3-Clause */
/* The scene: all that a user sets, read from a YAML file against one schema (schema_rows.h), as the option structs
 * of the modules by value, plus the data of the scene alone. No other module knows the file.
 *
 *     scene_text.h: the text of the file
 *         ->  scene_read.h, which calls the rest:
 *         ->  tree.h: nodes with lines
 *         ->  schema_normalise.h: short forms become long ones
 *         ->  schema_read.h: --set, then every key checked and stored
 *         ->  finish.h: derived values
 *         ->  scene_check.h: combinations
 *     scene_particles.h: the particles of its sources
 *
 * A number that the user did not give and that has no default is NAN while reading; finish.c leaves none
 * behind in the data of the modules (`step.dt`, for one, is then 0). Lengths of regions, sources, walls and
 * observables are in the user's coordinates; everything handed to particles is box-relative. */
#ifndef SCREE_SCENE_SCENE_H
#define SCREE_SCENE_SCENE_H

#include "kernel/comm/ghosts.h"
#include "physics/grains/laws/law.h"
#include "data/formats/output_options.h"
#include "physics/grains/motion/integrator.h"
#include "physics_table.h"
#include "data/scene/insertion.h"
#include "data/scene/scene_sections.h"
#include "physics/grains/walls/wall.h"

struct tree_node;
struct scene_shapes; /* scene_shapes.h */

struct scene {
    char file[SCENE_PATH_MAX];   /* as named in messages */
    char note[SCENE_NOTE_MAX];   /* message of the reader to the user; "" if none */
    char folder[SCENE_PATH_MAX]; /* start of relative paths, ends with '/' or is empty */
    struct tree_node *tree;      /* the parsed text, for places in messages; owned */
    char *text;                  /* of the file, if there are stages, else NULL; owned */
    int settings;                /* of the command line, beside `text` */
    char **setting;              /* owned */
    char title[256];
    enum scene_units units;
    uint64_t seed;
    struct box box;
    double box_lower[3], box_upper[3];
    int shear_given;
    struct scene_shear shear;
    int strain_given;
    struct scene_strain strain;
    int stress_given;
    struct scene_stress stress;
    int leave_all;
    int leave_side[3][2];
    double gravity[3];
    double duration; /* time; 0: by step.count */
    int stages;
    struct scene_stage stage[STAGES_MAX];
    struct scene_step step;
    char integrator[SCENE_NAME_MAX];
    int threads; /* 0: as many as OpenMP offers */
    enum scene_simd simd;

    struct law_options law; /* key `contact`; law_prepare makes struct law from it */
    int materials;
    struct law_material material[LAW_MATERIALS_MAX];
    int pairs;
    struct scene_pair *pair;   /* as read; finish.c makes law_pair from it; both owned */
    struct law_pair *law_pair; /* materials x materials (law_place_of), complete: input of law_prepare */

    int walls;
    struct wall_options *wall; /* owned */

    int groups; /* group[0] is "free" */
    struct scene_group group[INTEGRATOR_GROUPS_MAX];

    /* Sections of physics (physics_table.h): options as each has them, and 1 where it is given. */
    double physics[PHYSICS_COUNT][PHYSICS_OPTIONS_MAX];
    int physics_given[PHYSICS_COUNT];
    struct scene_shapes *shapes; /* of bodies; owned; NULL: there is no such section */

    int sources;
    struct source_options *source; /* owned */
    int insertions;
    struct insertion_options *insertion; /* owned */
    int deletions;
    struct deletion_options *deletion; /* owned */

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

/* The coefficients of two materials. */
static inline struct law_pair *scene_law_pair(const struct scene *scene, int a, int b) {
    return &scene->law_pair[law_place_of(scene->materials, a, b)];
}

/* Number of a material or wall by name, or -1. */
int scene_material(const struct scene *scene, const char *name);
int scene_wall(const struct scene *scene, const char *name);

#endif
