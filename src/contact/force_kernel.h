/* Inside of the force loop: what force.c hands to the compiled kernels, and a batch of contacts. The walls
 * use batches and `respond` for their contacts (walls_force.c). Nobody else but tests includes this.
 *
 * force_block.c is compiled several times, for several instruction sets, and the best one that the CPU has is
 * chosen at run time. All give the same bits: no sum depends on the vector length, and nothing is contracted
 * into fused operations.
 *
 * A block goes through these stages (docs/performance.md):
 *
 *   filter   distances of four pairs at a time against r_i + r_j; the numbers of those that touch are
 *            appended to `candidate`
 *
 * then for each FORCE_BATCH candidates, and for the rest at the end of the block:
 *
 *   gather   the records of the two particles, their difference written to the batch
 *   recall   old springs, found by the merge pointer
 *   measure  a vectorised loop, specialised for the law: geometry
 *   respond  another: law_respond
 *   scatter  forces to i, and to j or its slot, by segment
 *   remember springs to the other history buffer
 *
 * Distances are formed as (x_j - x_i) + shift, so that a pair and its mirror have exactly opposite ones; the
 * law keeps that up. */
#ifndef SCREE_CONTACT_FORCE_KERNEL_H
#define SCREE_CONTACT_FORCE_KERNEL_H

#include "contact/force.h"
#include "contact/force_ordered.h"
#include "contact/law_kernel.h"

/* FORCE_QUAD: pairs that the filter takes at a time. FORCE_AHEAD: how many pairs ahead partners are fetched;
 * lists are padded by more than that. */
enum { FORCE_CHUNK = 512, FORCE_BATCH = 64, FORCE_LANES = 8, FORCE_QUAD = 4, FORCE_AHEAD = 16 };

/* Contacts on their way through the phases. Entry k of each array belongs to contact k; the loops run to the
 * next multiple of FORCE_LANES: what lies there repeats the last contact, or is left from earlier ones. */
struct force_batch {
    double record[FORCE_BATCH][8];      /* x_j - x_i, r_i + r_j, v_j - v_i, 1/m_i + 1/m_j */
    double omega[FORCE_BATCH][8];       /* omega_i 0 omega_j 0 */
    double radius[2][FORCE_BATCH];      /* r_i, r_j */
    double coefficient[6][FORCE_BATCH]; /* the members of struct law_coefficients */
    double overlap[FORCE_BATCH];        /* what struct law_contact holds, by component */
    double mass[FORCE_BATCH];
    double effective[FORCE_BATCH];
    double normal[3][FORCE_BATCH];
    double velocity[3][FORCE_BATCH];
    double half_normal[3][FORCE_BATCH];
    double surface[3][FORCE_BATCH];
    double spin[3][FORCE_BATCH];
    double spring[HISTORY_COMPONENTS_MAX][FORCE_BATCH]; /* in: the old ones; out: the new ones */
    double force[3][FORCE_BATCH];                       /* on j */
    double moment[3][FORCE_BATCH];                      /* torque per lever */
    double rolling[3][FORCE_BATCH];                     /* torque on j */
    double lever[2][FORCE_BATCH];                       /* of i, of j */
    double energy[3][FORCE_BATCH];                      /* normal, springs, work taken; if asked for */
    double share[FORCE_BATCH][12];                      /* force 0 moment 0 rolling 0, as records have them */
    uint32_t i[FORCE_BATCH], j[FORCE_BATCH];            /* particle numbers, without image code */
    uint32_t pair[FORCE_BATCH];                         /* pair number - first pair of the thread */
    int count, padded;
};

typedef void force_physics(struct force_batch *batch, struct law_step step);

/* Writes the coefficients of contact k into a batch. */
static inline void force_set_coefficients(struct force_batch *restrict b, int k,
                                          const struct law_coefficients *c) {
    b->coefficient[0][k] = c->k_n;
    b->coefficient[1][k] = c->k_t;
    b->coefficient[2][k] = c->c_n;
    b->coefficient[3][k] = c->c_t;
    b->coefficient[4][k] = c->friction;
    b->coefficient[5][k] = c->rolling_friction;
}

/* Adds a contact with the branch d and the force f on its far end to a virial, `weight` times. */
static inline void force_add_virial(double virial[6], double weight, const double d[3], const double f[3]) {
    virial[0] += weight * d[0] * f[0];
    virial[1] += weight * d[1] * f[1];
    virial[2] += weight * d[2] * f[2];
    virial[3] += weight * 0.5 * (d[0] * f[1] + d[1] * f[0]);
    virial[4] += weight * 0.5 * (d[0] * f[2] + d[2] * f[0]);
    virial[5] += weight * 0.5 * (d[1] * f[2] + d[2] * f[1]);
}

/* Adds a thread's sums to the total; largest overlaps are compared. */
void force_sums_add(struct force_sums *total, const struct force_sums *part);

/* A thread's own memory. */
struct force_thread {
    struct force_batch batch;
    /* Touching pairs, number - first pair of the block; FORCE_QUAD are written at a time. */
    uint32_t candidate[FORCE_CHUNK + FORCE_BATCH + FORCE_QUAD];
    size_t candidates;
    size_t cursor; /* merge pointer into the old history records */
    struct force_sums sums;
    double *slots;               /* force_stride doubles a busy particle */
    struct force_ledger *ledger; /* NULL: forces are added at once */
};

/* One block's work, as force.c sets it up. */
struct force_task {
    const struct force_context *context;
    const struct pair_block *block;
    struct force_thread *thread;
    size_t pair_base;               /* first pair of the thread */
    const struct history_part *old; /* NULL without history */
    struct history_part *new;
    struct law_step step;
    bool energies;
};

struct force_kernel {
    const char *name;                             /* the instruction set */
    void (*block)(const struct force_task *task); /* computes a block */
    /* The law alone over the first `count` contacts of a batch whose overlap ... spring are filled in, for
     * contacts that are no pairs: fills force ... energy. */
    void (*respond)(const struct law_options *options, bool energies, struct force_batch *batch,
                    struct law_step step);
};

/* The kernel of that name, or with NULL the best one; NULL if there is none or this CPU cannot run it. */
const struct force_kernel *force_kernel_find(const char *name);

extern const struct force_kernel force_kernel_baseline;
#ifdef FORCE_X86_KERNELS
extern const struct force_kernel force_kernel_v3; /* x86-64-v3: AVX2 */
extern const struct force_kernel force_kernel_v4; /* x86-64-v4: AVX-512 */
#endif

#endif
