/* SPDX-License-Identifier: BSD-3-Clause */
/* The batch of contacts: every contact of a step and of an output goes through the law in one, by one function. Only the
 * batches, the walls and tests include this header.
 *
 * Three fill a batch: the walk over pairs (force.c), the walls (walls_force.c), and the list of contacts for output, which is a
 * walk, too (force_contacts.c). `contacts` of struct force_kernel then computes it in three parts:
 *
 *   mix      coefficients of the two materials, where materials differ
 *   push     what the loop of the law has not: springs of a file of the user's; the normal direction of a law with parts, in a
 *            vectorised loop or one contact after another; or all of a law whose resistances have no loop
 *   respond  the loop of the law: law_respond, or behind a push loops of the law's resistances (force_resist.h)
 *
 * What needs the geometry of two spheres has `measure` before: records are turned into columns, then a vectorised loop.
 *
 * force_block.c is compiled for several instruction sets, as the walk is. All compiled versions give the same
 * bits. Distances are formed as (x_j - x_i) + shift, so that a pair and its mirror have exactly opposite distances;
 * the law keeps this symmetry. */
#ifndef SCREE_BATCH_FORCE_KERNEL_H
#define SCREE_BATCH_FORCE_KERNEL_H

#include "physics/grains/batch/force.h"
#include "physics/grains/laws/law_kernel.h"
#include "kernel/pairs/walk.h"
#include <string.h>

enum { FORCE_BATCH = WALK_BATCH, FORCE_LANES = WALK_LANES };

/* The column of each member of struct law_coefficients. */
#define FORCE_COLUMN(member) FORCE_##member,
enum { LAW_COEFFICIENT_TABLE(FORCE_COLUMN) FORCE_COEFFICIENTS };

/* Places of the law's results in `out` of the walk's batch: components x y z each. */
enum { FORCE_OUT = 0, FORCE_MOMENT = 3, FORCE_ROLLING = 6 };

enum { FORCE_UNLIKE = -1 };

/* Numbers that a push gives; loops of resistances; numbers that the resistances of a kind are given at most. */
#define FORCE_ROLLING_MEMBER(NAME, name, with, summary) struct rolling_##name##_given name;
#define FORCE_TWISTING_MEMBER(NAME, name, with, summary) struct twisting_##name##_given name;
union force_rolling_given {
    LAW_ROLLING_PARTS(FORCE_ROLLING_MEMBER)
};
union force_twisting_given {
    LAW_TWISTING_PARTS(FORCE_TWISTING_MEMBER)
};
enum {
    FORCE_SPRINGS = 8,
    FORCE_RESISTS = 3,
    FORCE_ROLLINGS = sizeof(union force_rolling_given) / sizeof(double),
    FORCE_TWISTINGS = sizeof(union force_twisting_given) / sizeof(double)
};

/* Contacts that pass through the law. Entry k of each array belongs to contact k; the loops run to the next
 * multiple of FORCE_LANES. walk.history: the springs, tangential (0..2) and rolling (3..5), and what a law with parts remembers
 * beside. walk.out: the force on j, the torque per lever, the rolling torque on j. walk.gathered[0]: omega_i 0 omega_j 0. */
struct force_batch {
    struct walk_batch walk;
    uint8_t material[2][FORCE_BATCH]; /* of i and j; only where the law is not uniform */
    int alike; /* the materials for which all coefficients stand here, as one number; FORCE_UNLIKE: they differ */
    double coefficient[FORCE_COEFFICIENTS][FORCE_BATCH]; /* the members of struct law_coefficients */
    double overlap[FORCE_BATCH]; /* from here on: the members of struct law_contact, by component */
    double mass[FORCE_BATCH];
    double effective[FORCE_BATCH];
    double normal[3][FORCE_BATCH];
    double velocity[3][FORCE_BATCH];
    double half_normal[3][FORCE_BATCH];
    double surface[3][FORCE_BATCH];
    double spin[3][FORCE_BATCH];
    double omega[2][3][FORCE_BATCH]; /* of i, of j, 1/time */
    /* What a push gives: force with the damper, the damper's base, tangential, press (law_general.h), 1 where the surfaces
     * touch, 1 where they interact, the contact radius where it recalls (law_grip.h), the spring. Before, those of a file of
     * the user's: force, stiffness, tangential, contact, energy. */
    double springs[FORCE_SPRINGS][FORCE_BATCH];
    double sticky[LAW_STICKY][FORCE_BATCH]; /* of a law with parts: the members of the cohesion's struct */
    double rolling[FORCE_ROLLINGS][FORCE_BATCH];       /* and what the resistance to rolling is given */
    double twisting[FORCE_TWISTINGS][FORCE_BATCH];     /* and to twisting */
    double branch[LAW_BRANCH_COUNT][FORCE_BATCH];      /* of a law with branches: LAW_BRANCH_NUMBERS */
    double parameter[LAW_PARAMETERS_MAX][FORCE_BATCH]; /* of a law of the user's */
    double energy[3][FORCE_BATCH];                     /* normal, springs, work taken; if asked for */
    const struct law_extra *extra[FORCE_BATCH];        /* of a law with parts */
    bool active[FORCE_BATCH];                          /* contact k interacts */
};

static inline struct law_vector force_vector(double a[3][FORCE_BATCH], int k) {
    return (struct law_vector){a[0][k], a[1][k], a[2][k]};
}

static inline void force_set(double a[3][FORCE_BATCH], int k, struct law_vector v) {
    a[0][k] = v.x;
    a[1][k] = v.y;
    a[2][k] = v.z;
}

typedef void force_physics(struct force_batch *batch, struct law_step step);
/* Fills `springs`, what contacts remember of the normal direction, and with step.energies the energies of it. */
typedef void force_pusher(const struct law *law, struct law_step step, struct force_batch *batch);

/* How the contacts of one evaluation are computed. */
struct force_form {
    const struct law *law;
    struct law_step step;
    force_physics *measure;              /* geometry of two spheres, for pairs */
    force_pusher *push;                  /* NULL: the loop of the law has all */
    force_physics *respond;              /* NULL: `push` and `resist` have done all */
    force_pusher *resist[FORCE_RESISTS]; /* behind a push: sliding, rolling, twisting; NULL: none */
};

/* Writes the coefficients of contact k into a batch, and reads them. */
static inline void force_set_coefficients(struct force_batch *restrict b, int k,
                                          const struct law_coefficients *c) {
#define PUT(member) b->coefficient[FORCE_##member][k] = c->member;
    LAW_COEFFICIENT_TABLE(PUT)
#undef PUT
}

LAW_INLINE struct law_coefficients force_coefficients_of(const struct force_batch *restrict b, int k) {
#define TAKE(member) .member = b->coefficient[FORCE_##member][k],
    return (struct law_coefficients){LAW_COEFFICIENT_TABLE(TAKE)};
#undef TAKE
}

#define FORCE_STICKY_SIZE(NAME, name, with, summary) [LAW_COHESION_##NAME] = sizeof(struct cohesion_##name),

/* Writes what the normal direction of contact k takes into a batch: the numbers of the law's cohesion, which lie side by side, and
 * those of a law with branches. */
static inline void force_set_sticky(struct force_batch *restrict b, int k, enum law_cohesion cohesion,
                                    const union law_sticky *sticky) {
    static const size_t size[LAW_COHESION_COUNT] = {LAW_COHESION_PARTS(FORCE_STICKY_SIZE)};
    const double *number = (const double *)sticky;
    for (size_t n = 0; n < size[cohesion] / sizeof *number; n++)
        b->sticky[n][k] = number[n];
}

/* The same for what its resistances to rolling and twisting are given. */
static inline void force_set_given(double column[][FORCE_BATCH], int k, const void *given, size_t size) {
    for (size_t n = 0; n < size / sizeof(double); n++)
        column[n][k] = ((const double *)given)[n];
}

static inline void force_set_resistances(struct force_batch *restrict b, int k,
                                         const struct law_options *options, const struct law_extra *extra) {
#define ROLLING(NAME, name, with, summary)                                                                   \
    if (options->rolling == LAW_ROLLING_##NAME)                                                              \
        force_set_given(b->rolling, k, &extra->rolling_##name, sizeof extra->rolling_##name);
#define TWISTING(NAME, name, with, summary)                                                                  \
    if (options->twisting == LAW_TWISTING_##NAME)                                                            \
        force_set_given(b->twisting, k, &extra->twisting_##name, sizeof extra->twisting_##name);
    LAW_ROLLING_PARTS(ROLLING)
    LAW_TWISTING_PARTS(TWISTING)
#undef ROLLING
#undef TWISTING
}

static inline void force_set_branch(struct force_batch *restrict b, int k, const struct law_extra *extra) {
#define PUT(member) b->branch[LAW_BRANCH_##member][k] = extra->member;
    LAW_BRANCH_NUMBERS(PUT)
#undef PUT
}

/* The numbers of a cohesion, as force_set_sticky has written them. */
#define FORCE_STICKY_TAKE(part, member)                                                                      \
    .member = b->sticky[offsetof(struct cohesion_##part, member) / sizeof(double)][k],
#define FORCE_STICKY_OF(NAME, name, with, summary)                                                           \
    LAW_INLINE struct cohesion_##name force_##name##_of(const struct force_batch *restrict b, int k) {       \
        return (struct cohesion_##name){COHESION_##NAME##_NUMBERS(FORCE_STICKY_TAKE)};                       \
    }
LAW_COHESION_PARTS(FORCE_STICKY_OF)

/* Adds a thread's sums to the total; largest overlaps are compared. */
void force_sums_add(struct force_sums *total, const struct force_sums *part);

/* A thread's batch, with data for the law and the sums. */
struct force_thread {
    struct force_batch batch;
    struct force_form form;
    struct force_sums sums;
    struct force_exact *exact; /* of this thread; NULL: not wanted */
    const uint8_t *material;   /* NULL if all particles are of one material */
};

struct force_kernel {
    const char *name; /* the instruction set */
    /* Chooses the loops of an evaluation with the time step dt, and prepares the batch for it. Before a thread's first batch. */
    void (*begin)(struct force_form *form, struct force_batch *batch, const struct law *law, double dt,
                  bool energies);
    /* The one computation of contacts: those of a batch whose material, radii (walk.radius, of a law with parts), overlap ... spin and
     * history are filled in; of walk.count contacts. Fills out, history, `active`, and if asked for `energy`. */
    void (*contacts)(const struct force_form *form, struct force_batch *batch);
    /* The parts of the walk's client that has a struct force_thread: contacts of pairs, and their sums. */
    void (*compute)(const struct walk_task *task, struct walk_batch *batch);
    void (*note)(const struct walk_task *task, struct walk_batch *batch);
};

/* An evaluation, as the walk sees it. */
struct walk_work force_walk_work(const struct force_context *context);

/* The `select` of a client of contacts: drops those of particles that are fixed to each other or joined. */
void force_walk_select(const struct walk_task *task, const struct walk_batch *batch, uint8_t *keep);

/* Prepares a thread for an evaluation, before its first block. */
void force_thread_begin(struct force_thread *own, const struct force_kernel *kernel,
                        const struct force_context *context, int thread);

/* The kernel of that name, or with NULL the best one; NULL if there is none or this CPU cannot run it. */
const struct force_kernel *force_kernel_find(const char *name);

extern const struct force_kernel force_kernel_baseline;
#ifdef SCREE_X86_KERNELS
extern const struct force_kernel force_kernel_v3; /* x86-64-v3: AVX2 */
extern const struct force_kernel force_kernel_v4; /* x86-64-v4: AVX-512 */
#endif

#endif
