/* The pair list: every pair nearer than r_i + r_j + margin, laid out for the force loop.
 *
 * Threads own contiguous ranges of particles (of each size class, as classes lie one after another in
 * memory). The rows of a thread are cut into blocks, small enough for the cache. Pair k is (i[k], j[k]): i
 * the row, an owned particle of the block (or, in one-sided pairs, a ghost of the thread), j the partner with
 * the image code in its upper 5 bits. The pairs of a block lie together, in three segments that differ in who
 * gets the force:
 *
 *   both   [first_pair, one_sided)  i and j both get it; both belong to this thread
 *   one    [one_sided, slotted)     only i gets it: j belongs to another thread, which has the mirrored pair
 * in a block of its own, or is a ghost with newton off slot   [slotted, end_pair)      i gets it, j is a
 * particle with very many partners ("busy") or a ghost that several threads meet: its share goes into this
 * thread's slot for j, and slots are summed in thread order afterwards
 *
 * Thus no atomics, and the result depends on the number of threads only through the order of sums. The *set*
 * of primary pairs is the same for any number of threads; the mirrored second copies of `one` pairs are
 * derived from it.
 *
 * A list serves any law with a range: it knows nothing of contacts. */
#ifndef SCREE_PAIRS_PAIRLIST_H
#define SCREE_PAIRS_PAIRLIST_H

#include "index/index.h"
#include "particles/particles.h"

enum { PAIR_INDEX_MASK = (1 << PARTICLE_INDEX_BITS) - 1 };

static inline uint32_t pair_partner(uint32_t j) {
    return j & PAIR_INDEX_MASK;
}
static inline unsigned pair_image(uint32_t j) {
    return j >> PARTICLE_INDEX_BITS;
}

/* One block of rows and its pairs. */
struct pair_block {
    uint32_t first_row, last_row;                    /* owned particles [first_row, last_row) */
    size_t first_pair, one_sided, slotted, end_pair; /* segments, see above */
    uint8_t size_class;                              /* of all rows */
};

struct pairlist {
    uint32_t *i, *j;      /* pair_count entries, padded */
    size_t pair_count;    /* with mirrored copies */
    size_t primary_count; /* without: what an index found; the sum over ranks counts each pair once with
                             newton on */
    struct pair_block *blocks;
    int block_count;
    int threads;
    int *thread_block; /* thread t runs blocks [thread_block[t], thread_block[t + 1]); the last block of a
                          thread may have no rows and hold the one-sided pairs of its ghosts */
    uint32_t *busy;    /* particles with slots: slot_count entries */
    size_t slot_count;
    int32_t *slot_of; /* slot of particle k, -1: none; NULL if slot_count is 0. total entries */
    double shift[BOX_IMAGE_CODES][4]; /* image code -> vector added to x_j */
    uint64_t revision;                /* of the particles it was built for */
};

struct pairlist_options {
    int threads;
    size_t block_rows; /* rows a block; 0: chosen for the cache */
    size_t busy_bound; /* a particle whose class averages more partners than this gets slots; 0: default */
};

/* Makes an empty list; destroy frees it and nulls the pointer. */
struct pairlist *pairlist_create(const struct pairlist_options *options);
void pairlist_destroy(struct pairlist **list);

/* Fills the view that an index sees: the particles, the classes, the periodic directions it wraps itself
 * (`wrap`, a direction in which one rank holds the whole box). Borrows all pointers. */
void pairlist_view(struct index_view *view, const struct particles *particles,
                   const struct size_classes *classes, const struct box *box, const bool wrap[3]);

/* Rebuilds the list from an index that was built for `view`: count, scan, fill. Opens its own thread team. */
void pairlist_build(struct pairlist *list, const struct index *index, const struct index_view *view,
                    const struct particles *particles, const struct box *box);

/* Bytes held. */
size_t pairlist_memory(const struct pairlist *list);

/* True if every pair lies within its margin and in the right segment, for tests and debug builds. */
bool pairlist_valid(const struct pairlist *list, const struct index_view *view, char *why, size_t why_size);

#endif
