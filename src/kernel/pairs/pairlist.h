/* SPDX-License-Identifier: BSD-3-Clause */
/* The pair list: every pair nearer than r_i + r_j + margin, laid out for the force loop.
 *
 * Threads own contiguous ranges of particles (of each size class, as classes lie one after another in
 * memory). The rows of a thread are cut into blocks, small enough for the cache. Pair k is (i[k], j[k]): i
 * the row, j the partner with the image code in its upper 5 bits. The pairs of a block lie together, in three
 * segments that differ in the particles that get the force:
 *
 *   both   [first_pair, one_sided)  i and j both get it; both belong to this thread
 *   one    [one_sided, slotted)     only i gets it: j belongs to another thread, which has the mirrored pair
 *                                   in its mirror block, or j is a ghost with newton off
 *   slot   [slotted, end_pair)      i gets it; j is "busy" (its class has very many partners), so its share
 *                                   goes into this thread's slot for j; slots are summed in thread order
 *
 * The last two blocks of a thread have no rows of their own:
 *   mirror block   second copies of pairs whose row belongs to another thread: row i here, one-sided
 *   ghost block    all pairs with ghosts. With newton on a ghost belongs to the first thread that meets it;
 *                  the others have it one-sided, and its thread the mirrored pair, whose row is the ghost
 *
 * Thus no atomics, and forces depend on the number of threads only through the order of sums. The set of
 * primary pairs (all but the mirrored ones) is the same for any number of threads.
 *
 * Building: each thread visits its blocks once and appends to its own region of the list. If a region is too
 * small, the visit goes on counting, the list is laid out again from the counts, and filled (count, scan,
 * fill); the counts of one build are the guess of the next.
 *
 * A list serves any law with a range: it knows nothing of contacts. */
#ifndef SCREE_PAIRS_PAIRLIST_H
#define SCREE_PAIRS_PAIRLIST_H

#include "index/index.h"
#include "kernel/particles/particles.h"

enum { PAIR_INDEX_MASK = (1 << PARTICLE_INDEX_BITS) - 1, PAIR_THREADS_MAX = 255 };

static inline uint32_t pair_partner(uint32_t j) {
    return j & PAIR_INDEX_MASK;
}
static inline unsigned pair_image(uint32_t j) {
    return j >> PARTICLE_INDEX_BITS;
}

enum pair_block_kind { PAIR_BLOCK_ROWS, PAIR_BLOCK_MIRROR, PAIR_BLOCK_GHOST };

/* One block of rows and its pairs. */
struct pair_block {
    uint32_t first_row, last_row; /* ROWS: owned particles [first_row, last_row), else empty */
    size_t first_pair, one_sided, slotted, end_pair; /* segments, see above */
    enum pair_block_kind kind;
    int size_class; /* ROWS: the class of all its rows */
};

struct pairlist_build; /* scratch of a build, private */

struct pairlist {
    uint32_t *i, *j;      /* padded by INDEX_SINK_PAD entries; threads' regions may leave gaps between them */
    size_t capacity;      /* entries allocated */
    size_t pair_count;    /* pairs in all blocks, mirrored copies included */
    size_t primary_count; /* without mirrored copies: the pairs that the index found */
    struct pair_block *blocks;
    int block_count;
    int threads;
    int *thread_block; /* thread t runs blocks [thread_block[t], thread_block[t + 1]) */
    uint32_t *busy;    /* particles with slots: slot_count entries */
    size_t slot_count; /* 0 with one thread */
    int32_t *slot_of;  /* slot of particle k (owned or ghost), if it is of a busy class; else not set */
    size_t busy_capacity, slot_of_capacity;
    double shift[IMAGE_CODES][4]; /* image code -> vector added to x_j */
    bool moves;                   /* the box moves: `drift` counts */
    double drift[IMAGE_CODES][4]; /* image code -> velocity added to v_j */
    int64_t sides;                /* of a list that was released, for the report; else 0 */
    struct pairlist_build *build;
};

struct pairlist_options {
    int threads;
    size_t block_rows; /* rows a block; 0: chosen for the cache */
    /* Particles of a class with more partners on average than this get slots; 0: default. */
    double busy_bound;
};

/* Makes an empty list; destroy frees it and nulls the pointer. */
struct pairlist *pairlist_create(const struct pairlist_options *options);
void pairlist_destroy(struct pairlist **list);

/* Releases the pairs and the memory of their search; the counts stay, the blocks are empty. pairlist_build makes the pairs again. */
void pairlist_release(struct pairlist *list);

/* A checksum of the threads' rows and of the classes with slots. Two lists of the same particles with the same sum have each pair in the same
 * segments of the same threads. */
uint64_t pairlist_owners(const struct pairlist *list);

/* Fills the view that an index sees: the particles, the classes, the periodic directions it wraps itself
 * (`wrap`, a direction in which one rank holds the whole box). Borrows all pointers. */
void pairlist_view(struct index_view *view, const struct particles *particles,
                   const struct size_classes *classes, const struct box *box, const bool wrap[3]);

/* Rebuilds the list from an index that was built for `view`: count, scan, fill. Opens its own thread team. */
void pairlist_build(struct pairlist *list, const struct index *index, const struct index_view *view,
                    const struct box *box);

/* Shifts and velocities of the images, after the box has moved: the pairs keep their images. */
void pairlist_follow(struct pairlist *list, const struct box *box);

/* Adds the image under which each ghost stands (`image[k]`: image code of ghost k, of particle owned + k) to
 * the image codes of its pairs. From then on the codes start from the original, and the caller must give each
 * ghost the position of its original. One thread; once after pairlist_build. */
void pairlist_add_images(struct pairlist *list, size_t owned, const uint8_t *image);

/* First pair number of a thread; the thread's history counts from this number. */
static inline size_t pairlist_thread_first(const struct pairlist *list, int thread) {
    int b = list->thread_block[thread];
    return b < list->thread_block[thread + 1] ? list->blocks[b].first_pair : 0;
}

/* The sides of pairs that this rank computes: two of a pair, one of a pair that is in the lists of two threads or
 * ranks. */
int64_t pairlist_sides(const struct pairlist *list);

/* Bytes held. */
size_t pairlist_memory(const struct pairlist *list);

/* True if the particles of every pair exist, are of classes that meet, and lie within their margin, and its
 * row is one of its block's where that has rows; the segment of the pair is not checked. Else `why`
 * gets one line. Tests call it. */
bool pairlist_valid(const struct pairlist *list, const struct index_view *view, char *why, size_t why_size);

/* Sets used[k - owned] to 1 for each copy k that a pair of the list has; the other entries stay as they are. Opens its
 * own thread team. */
void pairlist_mark_copies(const struct pairlist *list, size_t owned, uint8_t *used);

/* One loop over pairs, for all that need neither a batch of pairs nor its fields (else: walk.h):
 *
 *   struct pair_visit pair = pairlist_thread(list, t);
 *   while (pairlist_each(list, &pair))
 *       ... pair.i, pair.j ...
 *
 * Pairs come in the order of the list: block after block of the thread, the mirror block and the ghost block last. */
struct pair_visit {
    size_t k;       /* number of the pair in the list */
    uint32_t i, j;  /* row and partner, without image code */
    unsigned image; /* of j: image code */
    int number;     /* of the block of the pair */
    const struct pair_block *block;
    size_t end; /* of the pairs of the block */
    int last;   /* number of the last block of the loop */
};

/* Before the first pair of blocks [first, end). */
static inline struct pair_visit pairlist_blocks(int first, int end) {
    return (struct pair_visit){.k = SIZE_MAX, .number = first - 1, .last = end - 1};
}

/* Before the first pair of one block. */
static inline struct pair_visit pairlist_block(int block) {
    return pairlist_blocks(block, block + 1);
}

/* Before the first pair of a thread. */
static inline struct pair_visit pairlist_thread(const struct pairlist *list, int thread) {
    return pairlist_blocks(list->thread_block[thread], list->thread_block[thread + 1]);
}

/* Before the first pair of the list, thread after thread. */
static inline struct pair_visit pairlist_all(const struct pairlist *list) {
    return pairlist_blocks(0, list->block_count);
}

/* Goes on to the next pair; false: there is none. */
static inline bool pairlist_each(const struct pairlist *list, struct pair_visit *pair) {
    pair->k++;
    while (pair->k >= pair->end) {
        if (pair->number == pair->last)
            return false;
        pair->block = &list->blocks[++pair->number];
        pair->k = pair->block->first_pair;
        pair->end = pair->block->end_pair;
    }
    pair->i = list->i[pair->k];
    pair->j = pair_partner(list->j[pair->k]);
    pair->image = pair_image(list->j[pair->k]);
    return true;
}

/* The segment of the pair (pairlist.h): who gets what the pair gives. Of `both`, `one` and `slot` one is true. */
static inline bool pair_gives_both(const struct pair_visit *pair) {
    return pair->k < pair->block->one_sided;
}
static inline bool pair_gives_slot(const struct pair_visit *pair) {
    return pair->k >= pair->block->slotted;
}
static inline bool pair_gives_one(const struct pair_visit *pair) {
    return !pair_gives_both(pair) && !pair_gives_slot(pair);
}

#endif
