/* SPDX-License-Identifier: BSD-3-Clause */
/* The walk over pairs: it gathers what a batch of near pairs needs. Contacts, heat, density and porosity go through it.
 * A loop that needs no batch, as most of a rebuild and of output do, uses pairlist_each (pairlist.h). The fluid
 * makes rows of both sides (pair_rows_build).
 *
 * A block of the list (pairlist.h) goes through these operations:
 *
 *   filter     distances of four pairs at a time against the cut-off; numbers of near pairs are collected
 *
 * then for each WALK_BATCH near pairs, and for the rest at the end of the block:
 *
 *   gather     differences of the hot records and the fields asked for are written to the batch
 *   recall     the record of the pair is found in the history
 *   compute    the client's physics over the batch
 *   scatter    shares are added to i, and to j or its slot, by segment of the list; or written to the ledger
 *   remember   the new record of the pair goes to the other buffer of the history
 *   note       the client's sums over the batch
 *
 * How to add a client, in seven steps (src/physics/density/density.c is one in 40 lines):
 *
 *   1. Choose the result of a pair: an enum walk_scatter.
 *   2. Write a struct that begins with a struct walk_batch and holds the data of your physics for a batch.
 *   3. Write `compute`: it reads record, radius, gathered, history, and writes out (and lever, history), for
 * the entries [0, padded). `compute` runs for WALK_BATCH pairs at a time, so a call through a pointer is
 * cheap.
 *   4. Fill a struct walk_client with these, and create a walk with it.
 *   5. Fill a struct walk_work: the list of your interaction, the cut-off as `range`, and the target, which the
 * caller sets to zero before, for owned particles and copies.
 *   6. After each rebuild walk_prepare; in a step walk_run, or walk_block for all blocks and walk_finish. The
 * shares of copies then belong to their originals: a field with FIELD_REVERSE goes back with the forces, any
 * other by ghosts_reverse (kernel/comm/ghosts.h).
 *   7. Fields beyond the gathered ones are read in `compute` by the numbers i[k] and j[k].
 *
 * Entries of a batch lie in the order of the pairs. Separations are formed as (x_j - x_i) + shift, so that a
 * pair and its mirrored copy have exactly opposite ones. The operations are compiled for several instruction sets
 * (walk_block.c), and the best that the CPU has is taken at run time; all give the same bits: no sum depends
 * on the vector length, and nothing is contracted into fused operations. */
#ifndef SCREE_PAIRS_WALK_H
#define SCREE_PAIRS_WALK_H

#include "kernel/pairs/history.h"
#include "kernel/pairs/pairlist.h"
#include "kernel/pairs/walk_ordered.h"

/* WALK_QUAD: pairs that the filter takes at a time. WALK_AHEAD: how many pairs ahead partners are fetched;
 * lists are padded by more than that. */
enum {
    WALK_CHUNK = 512,
    WALK_BATCH = 64,
    WALK_LANES = 8,
    WALK_QUAD = 4,
    WALK_AHEAD = 16,
    WALK_GATHER_MAX = 2,
    WALK_VALUES_MAX = 8
};

/* Near pairs on their way through the operations. Entry k of each array belongs to pair k; loops may run to the
 * next multiple of WALK_LANES (`padded`): the entries from `count` on repeat the last one. */
struct walk_batch {
    double record[WALK_BATCH][8];                       /* x_j - x_i, r_i + r_j, v_j - v_i, 1/m_i + 1/m_j */
    double gathered[WALK_GATHER_MAX][WALK_BATCH][8];    /* four doubles of i, four of j */
    double radius[2][WALK_BATCH];                       /* r_i, r_j */
    double history[HISTORY_COMPONENTS_MAX][WALK_BATCH]; /* in: old record (0: a new pair); out: new record */
    double out[2 * WALK_VALUES_MAX][WALK_BATCH];        /* see enum walk_scatter */
    double lever[2][WALK_BATCH];                        /* of i, of j */
    double share[WALK_BATCH][12];          /* force 0 moment 0 rolling 0 as records, made by the walk */
    uint32_t i[WALK_BATCH], j[WALK_BATCH]; /* particle numbers, without image code */
    uint32_t pair[WALK_BATCH];             /* pair number - first pair of the thread */
    int count, padded;
    int both, one; /* [0, both): i and j get a share; [both, one): i alone; [one, count): j by its slot */
};

/* The results of a pair, and their places in `out`. */
enum walk_scatter {
    WALK_NOTHING, /* no result: the client has taken its sums in `compute` */
    WALK_VALUES,  /* `values` doubles for i: out[c], and for j: out[values + c] */
    WALK_FORCE,   /* records of 4 or more doubles: out[0..2] is a force on j, its negative acts on i */
    WALK_TORQUE,  /* records of 8: and out[3..5] a torque per lever, lever[0] of it on i, lever[1] on j */
    WALK_ROLLING  /* and out[6..8] a torque on j, its negative on i */
};

/* A field whose first four doubles are gathered. */
struct walk_field {
    const double *base; /* of particle 0, four doubles readable */
    size_t stride;      /* doubles from one particle to the next */
};

struct walk_task;

/* A client of the walk. */
struct walk_client {
    const char *name;
    size_t memory; /* bytes of a thread's batch, which begins with a struct walk_batch */
    enum walk_scatter scatter;
    int values; /* WALK_VALUES: 1 ... WALK_VALUES_MAX */
    /* Sets keep[k] to 0 for near pairs that are not wanted; asked if the work is selective. */
    void (*select)(const struct walk_task *task, const struct walk_batch *batch, uint8_t *keep);
    void (*compute)(const struct walk_task *task, struct walk_batch *batch);
    /* After the scatter; NULL: none. */
    void (*note)(const struct walk_task *task, struct walk_batch *batch);
};

/* Data of an evaluation; all borrowed. A pair is near if its distance is below the cut-off: `range`,
 * and with `radii` r_i + r_j + range. */
struct walk_work {
    const void *context; /* the client's */
    const struct particles *particles;
    const struct pairlist *list;
    struct history *history; /* NULL: pairs remember nothing */
    int gathers;
    struct walk_field gather[WALK_GATHER_MAX];
    double *target; /* where shares are added: `stride` doubles a particle, owned and copies */
    size_t stride;
    bool radii;
    double range;
    /* With `radii` and a history: a pair is near if it touches, or if number `held` of its record is not 0; the range is not
     * asked. For forces that act across a gap only where surfaces have touched. */
    bool waits;
    int held;
    bool selective; /* the client's `select` is asked */
    bool ordered;   /* shares are summed in an order that no layout changes (walk_ordered.h) */
};

/* A thread's own memory. */
struct walk_thread {
    struct walk_batch *batch; /* `memory` bytes of the client */
    /* Near pairs, number - first pair of the block; WALK_QUAD are written at a time. */
    uint32_t candidate[WALK_CHUNK + WALK_BATCH + WALK_QUAD];
    size_t candidates;
    size_t cursor;              /* merge pointer into the old history records */
    size_t ahead;               /* the filter's, of work that waits */
    double *slots;              /* stride doubles a busy particle */
    struct walk_ledger *ledger; /* NULL: shares are added at once */
};

/* One block's work, as a client sees it. */
struct walk_task {
    const struct walk_client *client;
    const struct walk_work *work;
    const struct pair_block *block;
    struct walk_thread *thread;
    size_t pair_base;               /* first pair of the thread */
    const struct history_part *old; /* NULL without history */
    struct history_part *new;
};

struct walk;

/* Makes a walk for `threads` threads; the client is borrowed. Takes the best instruction set of this CPU. */
struct walk *walk_create(const struct walk_client *client, int threads);
void walk_destroy(struct walk **walk);

/* The batch of a thread, for the client's own memory behind it. */
struct walk_batch *walk_batch_of(const struct walk *walk, int thread);

/* Takes another instruction set (walk_level); false if there is none of that name or the CPU cannot run it.
 */
bool walk_choose(struct walk *walk, const char *name);

/* Prepares for a new pair list (slots, room for history). One thread, after each rebuild. */
void walk_prepare(struct walk *walk, const struct walk_work *work);

/* Walks the pairs of one block by thread `thread`; a thread takes its blocks in increasing order, all of
 * them, then comes walk_finish. Adds to work.target. Many threads at once, each its own blocks. */
void walk_block(struct walk *walk, const struct walk_work *work, int thread, int block);

/* Ends the evaluation: adds the slots in thread order or the ledgers, and exchanges the buffers of the
 * history. One thread, after all have finished their blocks. */
void walk_finish(struct walk *walk, const struct walk_work *work);

/* Discards an evaluation instead of ending it: the histories are those before the evaluation; the caller
 * clears the target. One thread. */
void walk_abandon(struct walk *walk, const struct walk_work *work);

/* All blocks by all threads, and walk_finish. Opens its own team. */
void walk_run(struct walk *walk, const struct walk_work *work);

/* Weights of the batch's pairs in sums over pairs (weight: WALK_BATCH doubles): a pair that another thread or
 * rank computes too counts one half, padding entries (up to `padded`) zero. Any thread. */
void walk_weigh(const struct walk_batch *batch, double *weight);

/* The instruction sets, best first: 2 "x86-64-v4", 1 "x86-64-v3", 0 "baseline". walk_level gives the number
 * of a name, or with NULL that of the best; -1 if this program or this CPU does not have it. */
int walk_level(const char *name);
const char *walk_level_name(int level);

#endif
