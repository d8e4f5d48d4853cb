/* The scene: all that a user sets, read from a YAML file against one schema (schema.h), as the option structs
 * of the modules by value, plus what belongs to the scene alone. Nobody else knows the file.
 *
 *     text (any rank reads it, all parse it)
 *         ->  tree.h: nodes with lines, --set applied
 *         ->  schema_read: every key checked and stored
 *         ->  finish.c: derived values
 *         ->  scene_check.c: combinations
 *
 * A number that the user did not give and that has no default is NAN while reading; finish.c leaves none
 * behind in what the modules receive (`step.dt`, for one, is then 0). Lengths of regions, sources, walls and
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
#include "scene/insertion.h"
#include "scene/source.h"
#include <stdio.h>

enum { SCENE_PATH_MAX = 1024, SCENE_NOTE_MAX = 256, SCENE_NAME_MAX = 64, SCENE_IDS_MAX = 1024, SCENE_PAIRS_MAX = 528 };

enum scene_units { SCENE_UNITS_SI, SCENE_UNITS_NONE };

/* Length of a run and of its step. */
struct scene_step {
    double dt;             /* > 0: given; 0: fraction x the stable step */
    double fraction;       /* of the stable step; set where dt is 0 */
    int64_t count;         /* steps; -1: by duration */
    bool force;            /* run although dt is above the stable step */
    bool fused;            /* particles move just before their first contact, instead of all at once */
    int64_t rebuild_every; /* rebuild at least every so many steps; 0: when the skin is used up */
    int contacts;     /* simultaneous contacts counted for the stable step; 0: the default of timestep.h */
    double speed_max; /* largest impact speed expected for the stable step; 0: from the particles */
};

/* Vector instructions used at most; the numbers are those of enum index_instructions. */
enum scene_simd { SCENE_SIMD_AUTO, SCENE_SIMD_BASELINE, SCENE_SIMD_V3, SCENE_SIMD_V4 };

/* Their names: those of the force loop's kernels. */
const char *scene_simd_name(enum scene_simd simd);

/* The name of a law. */
const char *scene_law_name(enum law_normal law);

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

/* What a guard does. */
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
    int between_count;
};

struct scene_index {
    char name[SCENE_NAME_MAX];
    struct index_params params;
    bool measure;    /* auto: time variants of the choice */
    int level_cells; /* how many of params.level_cell were given */
};

struct tree; /* the parsed text, for places in messages */

struct scene {
    char file[SCENE_PATH_MAX];   /* as named in messages */
    char note[SCENE_NOTE_MAX];   /* what the reader has to tell; "" if nothing */
    char folder[SCENE_PATH_MAX]; /* what relative paths start from, ends with '/' or is empty */
    struct tree *tree;           /* owned */
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
    struct law_pair law_pair[LAW_MATERIALS_MAX][LAW_MATERIALS_MAX]; /* complete: what law_prepare takes */

    int walls;
    struct wall_options wall[WALLS_MAX];

    int groups; /* group[0] is "free" */
    struct scene_group group[INTEGRATOR_GROUPS_MAX];

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

/* One --set KEY=VALUE of the command line. */
struct scene_setting {
    const char *text; /* "walls[0].radius=0.2"; "step.fraction=~" takes the key out */
};

/* Reads a whole text file into memory (memory_free), ended by a zero byte; `length` may be NULL. Fails (user)
 * where it cannot be read. */
bool scene_read_text(const char *path, char **text, size_t *length, struct error *error);

/* Parses and checks a scene. `file` names the text in messages and gives the folder that relative paths start
 * from; `set` has `sets` overrides, applied in order. Every rank gives the same arguments. Opens the particle
 * file where the box comes from it. Returns the scene, to be freed by scene_free, or NULL with a user's
 * error. One thread. */
struct scene *scene_parse(const char *file, const char *text, const struct scene_setting *set, int sets,
                          struct error *error);
void scene_free(struct scene **scene);

/* Writes the effective scene as YAML: every key that applies with its value, in base units; parsing it gives
 * the same scene. Returned as allocated text (memory_free). */
char *scene_echo(const struct scene *scene);

/* "FILE:LINE" or "command line" of a key ("walls[0].radius"), or of the nearest section above it that was
 * given. Writes at most `room` bytes; returns `place`. */
const char *scene_place(const struct scene *scene, const char *key, char *place, size_t room);

/* Registers the fields that the scene needs beyond those of every set; `law` as prepared from it. */
void scene_register(const struct scene *scene, const struct law *law, struct particles *particles);

/* Motion of the groups and gravity as the integrator wants them; dt stays 0. */
void scene_integrator(const struct scene *scene, struct integrator_context *context);

/* Sets `reproducible` in a scene that was read, and what follows from it. */
void scene_make_reproducible(struct scene *scene);

/* Number of a material or wall by name, or -1. */
int scene_material(const struct scene *scene, const char *name);
int scene_wall(const struct scene *scene, const char *name);

/* Which particles this rank keeps: those with mine(context, x) true (x box-relative, wrapped), or, where
 * `mine` is NULL, an equal share: blocks of the stream dealt out in turn, wherever they lie. Spheres that are
 * placed at random keep clear of what taken(context, x, radius) says, on all ranks the same (NULL: nothing).
 * While spheres are placed at random, `progress` is called now and then with the part that is done, 0 to 1, on
 * every rank. */
struct scene_share {
    int rank, size;
    bool (*mine)(void *context, const double x[3]);
    bool (*taken)(void *context, const double x[3], double radius);
    void *context;
    void (*progress)(void *context, const char *what, double part); /* NULL: nobody is told */
};

/* What the sources gave, over all ranks; the same on every rank. */
struct scene_census {
    uint64_t particles;
    int64_t id_max;
    double radius_min, radius_max;
    uint64_t material[LAW_MATERIALS_MAX];
    uint64_t group[INTEGRATOR_GROUPS_MAX];
    double speed_max;
    double volume; /* solid */
};

/* Fills an empty particle set, with the fields of scene_register, with this rank's particles: box-relative
 * positions, velocities as given (full step), inverse masses (0 in groups that do not move freely), ids,
 * materials, groups. Every rank reads or generates the whole stream; no communication. Bad data: file, line,
 * column and what is allowed. Duplicate ids and coinciding centres are searched for by all ranks together,
 * each a part: errors differ between ranks, so the caller agrees on them (comm_agree). One thread. `census`
 * may be NULL.
 */
bool scene_particles(const struct scene *scene, const struct scene_share *share, struct particles *particles,
                     struct scene_census *census, struct error *error);

/* Text of `scree help`: all keys in one line each (`key` NULL), a section, or one key at length. False if
 * there is no such key; then the nearest is named in `out` too. */
bool scene_help(FILE *out, const char *key);

/* docs/scene.md. */
void scene_document(FILE *out);

#endif
