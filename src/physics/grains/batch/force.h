/* SPDX-License-Identifier: BSD-3-Clause */
/* The threaded force loop: the contact laws as a client of the walk over pairs (kernel/pairs/walk.h). A cheap
 * vectorised distance filter over the flat pairs of a block comes first, then the contacts that really touch,
 * in batches (docs/performance-journal.md). The functions work block by block, so that the step may run other passes
 * on a block just before or after (docs/architecture.md). */
#ifndef SCREE_BATCH_FORCE_H
#define SCREE_BATCH_FORCE_H

#include "physics/grains/laws/law.h"
#include "base/exact.h"
#include "kernel/pairs/history.h"
#include "kernel/pairs/pairlist.h"

/* Sums of a force evaluation on this rank. A pair computed by two threads or ranks counts half on each. */
struct force_sums {
    double elastic_normal;     /* energy stored in normal springs */
    double elastic_tangential; /* in tangential and rolling springs; the sum of `taken` includes it */
    double taken;       /* work taken in this step by normal dampers and by all tangential forces, springs
                           included (energy; exact to first order) */
    double virial[6];   /* sum of x_ij F_ij: xx yy zz xy xz yz, energy */
    double overlap_max; /* largest overlap / smaller radius; overlap_id: its particles */
    int64_t overlap_id[2];
    /* Sides of touching pairs that were computed: 2 a pair, or 1 here and 1 on another thread or rank. */
    size_t contact_sides;
    size_t contacts; /* contact_sides / 2; over ranks add up the sides, then halve */
};

/* Adds a contact with the branch d and the force f on its far end to a virial, `weight` times. */
static inline void force_add_virial(double virial[6], double weight, const double d[3], const double f[3]) {
    virial[0] += weight * d[0] * f[0];
    virial[1] += weight * d[1] * f[1];
    virial[2] += weight * d[2] * f[2];
    virial[3] += weight * 0.5 * (d[0] * f[1] + d[1] * f[0]);
    virial[4] += weight * 0.5 * (d[0] * f[2] + d[2] * f[0]);
    virial[5] += weight * 0.5 * (d[1] * f[2] + d[2] * f[1]);
}

/* Sums that no layout changes, of one thread: each term of force_sums.virial, and of force_sums.elastic_normal,
 * without rounding. A contact that two threads or ranks compute adds one half of the same term twice. */
enum { FORCE_EXACT = 7 };
struct force_exact {
    struct exact sum[FORCE_EXACT];
};

/* One evaluated contact, for the contact list (force chains). */
struct force_contact {
    int64_t id_i, id_j;
    double normal[3];          /* unit vector from i to j */
    double overlap;            /* length unit */
    double force[3];           /* on j, normal and tangential together */
    double branch[3];          /* from the centre of i to that of j, or to the point of a wall, length unit */
    size_t number_i, number_j; /* of the particles on this rank, copies included; j of a wall: SIZE_MAX */
};

/* The work of a contact. */
struct force_work {
    double taken;  /* as force_sums.taken */
    double stored; /* what its tangential, rolling and twisting springs hold now */
};

struct force_context {
    struct particles *particles;
    const struct pairlist *list;
    struct history *history; /* NULL where the law has none */
    const struct law *law;
    double range;     /* how far beyond touch contacts reach, at most */
    double dt;        /* time step of the histories; 0 in the first evaluation of a run: the histories stay */
    bool want_sums;   /* fill the energies of the sums; contacts and overlap_max always are */
    bool want_virial; /* fill the virial; only with want_sums */
    /* By thread: with want_virial the terms of pairs are added to it, not those of walls; the caller clears it.
     * NULL: not wanted. */
    struct force_exact *exact;
    bool prescribed; /* there may be particles whose motion is prescribed */
    bool ordered;    /* forces are summed in an order that no layout changes (kernel/pairs/walk_ordered.h) */
    bool
        want_work; /* a physics asks for the work of single contacts in every step: want_sums is then always set */
    /* Where that work goes; NULL: nowhere. */
    struct force_work *pair_work; /* by pair of the list: set for each contact */
    struct force_work *wall_work; /* by owned particle: those of its contacts with walls are added */
    /* Lists the contacts that a solver has found, those of pairs or those with walls, allocated (memory_free). NULL: contacts
     * are listed by the law. */
    size_t (*solved)(const void *solver, bool walls, struct force_contact **contacts);
    const void *solver;
    /* True if two particles of the list have no contact, whatever their distance; any thread. NULL: all have. */
    bool (*joined)(const void *context, size_t i, size_t j);
    /* True if a physics has the contacts of a particle with walls; any thread. NULL: none has. */
    bool (*alone)(const void *context, size_t i);
    const void *joined_context; /* of both */
};

/* A force loop's own memory (slots, batches of each thread), and the compiled kernel that the loop runs: the
 * kernel for the best instruction set of this CPU. All kernels give the same bits. */
struct force_loop;
struct force_loop *force_loop_create(int threads);
void force_loop_destroy(struct force_loop **loop);

/* The name of the kernel in use: "x86-64-v4", "x86-64-v3" or "baseline". force_loop_choose chooses another
 * kernel, for tests and measurements; false if no kernel has that name or the CPU cannot run the kernel. */
const char *force_loop_kernel(const struct force_loop *loop);
bool force_loop_choose(struct force_loop *loop, const char *kernel);

/* Prepares for a new pair list (slots, room for history). One thread, after each rebuild. */
void force_loop_prepare(struct force_loop *loop, const struct force_context *context);

/* Computes the pairs of one block by thread `thread`; blocks of a thread in increasing order, all of them,
 * then force_loop_finish. Adds to particles.force (zeroed before by the integrator). May be called by many
 * threads at once, each with its own blocks. */
void force_loop_block(struct force_loop *loop, const struct force_context *context, int thread, int block);

/* Ends the evaluation: adds the slots in thread order, flips the history, adds up the sums. Called by one
 * thread after all have finished their blocks. */
void force_loop_finish(struct force_loop *loop, const struct force_context *context, struct force_sums *sums);

/* Discards an evaluation instead of ending it: histories and sums stay as before the evaluation; the caller
 * clears the forces. One thread. */
void force_loop_abandon(struct force_loop *loop, const struct force_context *context);

/* Computes all blocks by all threads: the plain order. */
void force_loop_run(struct force_loop *loop, const struct force_context *context, struct force_sums *sums);

/* Evaluates the present contacts again, springs at rest, without changing forces or present histories, and returns the
 * contacts for output. Not while an evaluation is under way, whose new histories would be lost. If two threads or ranks hold a pair, only the home of the pair gives the contact. Returns the
 * number of contacts; `contacts` is allocated (memory_free). One thread. */
size_t force_loop_contacts(const struct force_context *context, struct force_contact **contacts);

#endif
