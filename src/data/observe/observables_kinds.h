/* SPDX-License-Identifier: BSD-3-Clause */
/* The registry of observables: one row an observable, by which requests of a scene, columns, help and
 * docs/output.md go.
 *
 * How to add an observable, in three steps:
 *   1. Write its function: `of_particle`, the part of one particle, or `of_rank`, this rank's part. One with a target that may be
 *      a region begins with observables_item_counts, or counts all particles.
 *   2. Add its row: what concerns the whole run to observables_bulk.c or observables_state.c, a wall, a particle or a region
 *      to observables_single.c, fields of a physics to NAME_observables (physics_table.h). `relevant` says in
 *      which scenes a family has the row; a request by its name is always served, so the function must do
 *      without its field.
 *   3. `make pages` writes docs/output.md. Tests: tests/mpi/test_observables.c, tests/app/observables.sh.
 * Velocities of the state are those of half a step before: observables_velocity gives those of the moment. */
#ifndef SCREE_OBSERVE_OBSERVABLES_KINDS_H
#define SCREE_OBSERVE_OBSERVABLES_KINDS_H

#include "data/formats/contact_list.h"
#include "data/observe/observables.h"
#include <stdio.h>

enum { OBSERVABLE_PARTS_MAX = 12 };

struct observable_expression;

/* A resolved request: what one kind observes of one target. */
struct observable_item {
    int kind;
    unsigned components;                /* bits of the components that have a column */
    int wall, material;                 /* material -1: all */
    int group;                          /* OBSERVABLE_OF_BODY: group of grains, where `wall` is -1 */
    const struct output_region *region; /* NULL: the whole run */
    int plane;                          /* OBSERVABLE_OF_PLANE: its number in `planes` */
    const struct output_plane *planes;
    struct observable_expression *expression; /* OBSERVABLE_OF_EXPRESSION, else NULL; owned */
    int64_t id;
    int first_part, first_column;
    uint64_t revision; /* of the particles when `number` was found */
    size_t number;     /* particle `id` on this rank; SIZE_MAX: not here */
};

/* Arguments of the functions of a row. */
struct observable_context {
    const struct output_view *view;
    const double (*wall_force)[6];       /* this rank's part, by wall */
    const struct contact_list *contacts; /* this rank's; empty unless an item needs contacts */
};

/* How the parts of ranks combine. */
enum observable_combine { OBSERVABLE_SUM, OBSERVABLE_MAX };

/* A component whose name and unit are not those of all vectors. */
struct observable_component {
    const char *name;             /* end of the column: "viscous_x" */
    const char *unit, *unit_flat; /* NULL: those of the row */
};

/* A row of the registry: this rank's part in `parts` numbers, summed (or the largest taken) over ranks, then
 * turned into components. */
struct observable_kind {
    struct observable_info info;
    const char *symbol; /* before the component in a column of a wall or particle: "v" gives ball_vz */
    const struct observable_component *component; /* info.components of them; NULL: as usual */
    int parts;
    enum observable_combine combine;
    bool of_all_kinds;   /* not grains alone */
    bool needs_sums;     /* force_sums beyond contacts and overlap */
    bool needs_work;     /* force_sums.taken of every step */
    bool needs_contacts; /* the contact list, of a region (then no sums) */
    bool lists_contacts; /* the contact list, of a region or not */
    /* Add to this rank's parts, which begin as zero. A row has one of the two functions or both: for the whole
     * rank, called once and last, and for one particle, called for all owned grains, prescribed ones too, by
     * many threads at once (with `of_all_kinds` for particles of all kinds, kinds.h). With OBSERVABLE_MAX each takes the larger of its value and part[k],
     * so what can be negative needs another form: a least value is 1 / the largest inverse. */
    void (*of_rank)(const struct observable_context *context, struct observable_item *item, double *part);
    void (*of_particle)(const struct output_view *view, const struct observable_item *item, size_t i,
                        double *part);
    /* Turns the combined parts into components in place; NULL: they are the components. */
    void (*finish)(const struct output_view *view, const struct observable_item *item, double *part);
    /* True if a region is allowed; NULL: every region is. */
    bool (*check)(const struct output_view *view, const struct output_region *region, struct error *error);
    /* True if a family includes the row in this scene; NULL: always. */
    bool (*relevant)(const struct output_view *view);
};

/* The rows that a physics adds (physics_table.h). */
struct observable_table {
    const struct observable_kind *rows;
    int count;
};

/* The rows of the files that define them, and of all together. */
int observables_expression_count(void);
const struct observable_kind *observables_expression(int k);
int observables_state_count(void);
const struct observable_kind *observables_state(int k);
int observables_flow_count(void);
const struct observable_kind *observables_flow(int k);
int observables_bulk_count(void);
const struct observable_kind *observables_bulk(int k);
int observables_single_count(void);
const struct observable_kind *observables_single(int k);
int observables_kinds_count(void);
const struct observable_kind *observables_kind(int k);

/* The place of particle i, or of copy i, in the box (user's coordinates). Copies stand beyond the box, and particles may, between
 * rebuilds. */
void observables_place(const struct output_view *view, size_t i, double x[3]);

/* The radius of the sphere with the volume that owned particle i stands for: its own, of a member that of its share of the body's. */
double observables_solid_radius(const struct output_view *view, size_t i);

/* That volume; in two dimensions the area of its disc. */
double observables_solid(const struct output_view *view, size_t i);

/* The velocity of owned particle i, and the spin (NULL: not wanted), at the moment of its place: in a box that moves, that of the
 * image in the box, as images have velocities of their own. */
void observables_velocity(const struct output_view *view, size_t i, double velocity[3], double omega[3]);

/* The velocity of the body that carries owned particle i, at its centre and at the same moment; of a grain that moves by itself
 * observables_velocity. The masses of a body's members are that of the body. */
void observables_velocity_of_body(const struct output_view *view, size_t i, double velocity[3]);

/* True if a point (user's coordinates) lies in a region. */
bool observables_region_contains(const struct output_region *region, const double x[3]);

/* True if particle i, or copy i, is of the item's material and lies in its region (no region: any particle).
 * The place is that of observables_place. */
bool observables_item_counts(const struct output_view *view, const struct observable_item *item, size_t i);

/* Reads the expressions of a request, whose variables are the fields of the view's particles. Fails (user) with the names
 * of the variables. The result is to be freed even then. */
bool observables_expression_make(struct observable_expression **expression,
                                 const struct observable_request *request, const struct output_view *view,
                                 struct error *error);
void observables_expression_free(struct observable_expression **expression);

/* Volume of the part of a region that lies in the box, in two dimensions area; NULL: of the box. */
double observables_volume(const struct box *box, const struct output_region *region);

/* True if the volume of a region is known. */
bool observables_volume_check(const struct output_view *view, const struct output_region *region,
                              struct error *error);

/* The parts of the row "stress" (observables_stress.c has the formula). */
void observables_stress_flux(const struct output_view *view, const struct observable_item *item, size_t i,
                             double *part);
void observables_stress_contacts(const struct observable_context *context, struct observable_item *item,
                                 double *part);
void observables_stress_finish(const struct output_view *view, const struct observable_item *item,
                               double *part);

enum { OBSERVABLE_COLUMN_MAX = 3 * OUTPUT_NAME_MAX };

struct observable_column {
    char name[OBSERVABLE_COLUMN_MAX];
    const char *unit;
};

struct observables {
    bool dimensionless, flat; /* flat: the box has two dimensions */
    int regions;
    struct output_region region[OUTPUT_REGIONS_MAX];
    int planes;
    struct output_plane plane[OUTPUT_PLANES_MAX];
    int items, item_room, columns, column_room, parts;
    struct observable_item *item;
    struct observable_column *column;
    double *value;                                    /* of the last row */
    const char **name, **unit;                        /* of the columns */
    char units[OUTPUT_REQUESTS_MAX][OUTPUT_NAME_MAX]; /* those that a request gives */
    int units_given;
    char path[FILE_PATH_MAX];
    FILE *file;       /* rank 0, once opened */
    double last_time; /* of the file's last row; -INFINITY: none */
    double (*wall_force)[6];
    bool needs_sums, needs_work, needs_contacts;
};

#endif
