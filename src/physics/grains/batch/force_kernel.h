/* SPDX-License-Identifier: BSD-3-Clause */
/* Private parts of the force loop: the contact laws as a client of the walk over pairs (kernel/pairs/walk.h), a
 * batch of contacts at a time. The walls use batches and `respond` for their contacts (walls_force.c). Apart
 * from these, only tests include this header.
 *
 * force_block.c is compiled for several instruction sets, as the walk is. All compiled versions give the same
 * bits. `compute` in force_block.c has two phases:
 *
 *   measure  records are turned into columns; a vectorised loop, specialised for the law: geometry
 *   respond  another: law_respond
 *
 * Distances are formed as (x_j - x_i) + shift, so that a pair and its mirror have exactly opposite distances;
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

/* Contacts that pass through the law. Entry k of each array belongs to contact k; the loops run to the next
 * multiple of FORCE_LANES. walk.history: the springs, tangential (0..2) and rolling (3..5). walk.out: the
 * force on j, the torque per lever, the rolling torque on j. walk.gathered[0]: omega_i 0 omega_j 0. */
struct force_batch {
    struct walk_batch walk;
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
    /* Of a law of the user's: force, stiffness, tangential, contact, energy. Of a law with parts that rubs: force with the
     * damper, the damper's base, tangential, press (law_general.h), 1 where the surfaces touch, 1 where they interact. */
    double springs[6][FORCE_BATCH];
    double sticky[LAW_STICKY][FORCE_BATCH]; /* of a law with parts: the members of the cohesion's struct */
    double branch[LAW_BRANCH_COUNT][FORCE_BATCH];      /* of a law with branches: LAW_BRANCH_NUMBERS */
    double parameter[LAW_PARAMETERS_MAX][FORCE_BATCH]; /* its input */
    double energy[3][FORCE_BATCH];                     /* normal, springs, work taken; if asked for */
    /* Of a law with parts or of the user's: coefficients of the parts; contact k interacts. */
    const struct law_extra *extra[FORCE_BATCH];
    bool active[FORCE_BATCH];
};

typedef void force_physics(struct force_batch *batch, struct law_step step);
/* The normal direction of a law that rubs, without energies: fills `springs`, `effective`, and what contacts remember of it. */
typedef void force_gripper(const struct law *law, struct force_batch *batch);

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

/* force_add_virial without rounding, and the energy of the contact. */
static inline void force_add_exact(struct force_exact *exact, double weight, double energy, const double d[3],
                                   const double f[3]) {
    double term[6] = {0};
    force_add_virial(term, weight, d, f);
    for (int c = 0; c < 6; c++)
        exact_add(&exact->sum[c], term[c]);
    exact_add(&exact->sum[6], weight * energy);
}

/* Writes down the work of each contact of the batch. */
static inline void force_put_work(const struct walk_task *task, const struct force_batch *b) {
    const struct force_context *context = task->work->context;
    for (int k = 0; k < b->walk.count; k++)
        context->pair_work[task->pair_base + b->walk.pair[k]] =
            (struct force_work){b->energy[2][k], b->energy[1][k]};
}

/* Adds a thread's sums to the total; largest overlaps are compared. */
void force_sums_add(struct force_sums *total, const struct force_sums *part);

enum { FORCE_UNLIKE = -1 };

/* A thread's batch, with data for the law and the sums. */
struct force_thread {
    struct force_batch batch;
    struct force_sums sums;
    struct force_exact *exact; /* of this thread; NULL: not wanted */
    struct law_step step;
    const struct force_kernel *kernel; /* of the loop, of a law with parts */
    bool rubs;                         /* such a law goes through force_general_rub */
    force_gripper *grip;               /* the loop of such a law; NULL: one contact after another */
    bool energies;
    const uint8_t *material; /* NULL if all particles are of one material */
    int alike; /* the materials of all contacts of the batch before, as one number; FORCE_UNLIKE: they differ */
    force_physics *measure, *respond; /* the loops of this law */
};

struct force_kernel {
    const char *name; /* the instruction set */
    /* Called before a thread's blocks: chooses the thread's loops. */
    void (*begin)(struct force_thread *thread, const struct force_context *context);
    void (*compute)(const struct walk_task *task,
                    struct walk_batch *batch); /* the client's part of a batch */
    void (*note)(const struct walk_task *task, struct walk_batch *batch);
    /* The sums of a batch besides the number of contacts. */
    void (*account)(const struct force_context *context, struct force_thread *thread);
    /* Coefficients of each contact of a law with parts, where they differ between materials. */
    void (*mix)(const struct law *law, const uint8_t *material, struct force_batch *batch);
    /* The loop of the normal direction of a law that rubs; NULL: its contacts go one after another. */
    force_gripper *(*grip_find)(const struct law_options *options);
    /* Sliding and rolling of a law that rubs (law_general.h), after its normal direction: fills force ... rolling, and the springs. */
    void (*rub)(const struct law_options *options, struct force_batch *batch, struct law_step step);
    /* The law alone over the first `count` contacts of a batch whose overlap ... spring are filled in, for
     * contacts that are no pairs: fills force ... energy. */
    void (*respond)(const struct law_options *options, bool energies, struct force_batch *batch,
                    struct law_step step);
};

/* The kernel of that name, or with NULL the best one; NULL if there is none or this CPU cannot run it. */
const struct force_kernel *force_kernel_find(const char *name);

extern const struct force_kernel force_kernel_baseline;
#ifdef SCREE_X86_KERNELS
extern const struct force_kernel force_kernel_v3; /* x86-64-v3: AVX2 */
extern const struct force_kernel force_kernel_v4; /* x86-64-v4: AVX-512 */
#endif

#endif
