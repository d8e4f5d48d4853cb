/* SPDX-License-Identifier: BSD-3-Clause */
/* Greedy colours of pairs in the order of ids. Read colour.h first. */
#include "physics/hard/colour.h"
#include "base/image.h"
#include "base/memory.h"
#include <assert.h>
#include <stdbool.h>
#include <stdlib.h>

/* Pairs of one colour that a thread takes at a time. */
enum { CUT_PAIRS = 256 };

/* Colours of single pairs: two particles that are no hubs have fewer partners than this together. */
enum { WORDS = 2, SINGLE_COLOURS = 64 * WORDS, BUNDLE_COLOURS = 64 };
static_assert(2 * HARD_HUB <= SINGLE_COLOURS, "single pairs always find a colour");

struct ranked {
    int64_t id;
    uint32_t number;
};

static int by_id(const void *a, const void *b) {
    const struct ranked *x = a, *y = b;
    if (x->id != y->id)
        return x->id < y->id ? -1 : 1;
    return x->number < y->number ? -1 : x->number > y->number;
}

/* A pair in the list of its head. */
struct entry {
    uint32_t other; /* rank of the other particle among the ids */
    uint32_t pair;
    uint8_t image;
    int64_t tie[2];
};

static int by_other(const void *a, const void *b) {
    const struct entry *x = a, *y = b;
    if (x->other != y->other)
        return x->other < y->other ? -1 : 1;
    if (x->image != y->image)
        return x->image < y->image ? -1 : 1;
    for (int e = 0; e < 2; e++)
        if (x->tie[e] != y->tie[e])
            return x->tie[e] < y->tie[e] ? -1 : 1;
    return 0;
}

/* The work of one colouring. */
struct work {
    size_t pairs, particles;
    const uint32_t (*end)[2];
    const uint8_t *image;
    const int64_t (*tie)[2];
    uint32_t *rank;          /* of each particle in the order of ids */
    uint32_t *degree;        /* partners of each particle */
    size_t *start;           /* by rank: particles + 1 */
    struct entry *entry;     /* of heads in the order of ranks */
    uint64_t (*used)[WORDS]; /* colours of single pairs at each particle */
    uint64_t *bundled;       /* colours of bundles at each particle */
    int *colour_of;          /* of each pair; -1: in a bundle */
    int *bundle_colour;      /* by rank of a hub; -1: no bundle */
    int singles, bundles;    /* numbers of colours */
};

static bool is_hub(const struct work *w, uint32_t particle) {
    return w->degree[particle] > HARD_HUB;
}

/* The particle in whose list a pair stands: its hub (of two the one with more partners), else the end with the lower
 * id. */
static int head_of(const struct work *w, size_t k) {
    const uint32_t *end = w->end[k];
    uint32_t d0 = w->degree[end[0]], d1 = w->degree[end[1]];
    bool lower = w->rank[end[0]] < w->rank[end[1]];
    if ((is_hub(w, end[0]) || is_hub(w, end[1])) && d0 != d1)
        return d0 > d1 ? 0 : 1;
    return lower ? 0 : 1;
}

static void ranks_make(struct work *w, const int64_t *id) {
    struct ranked *ranked = memory_allocate(w->particles, sizeof *ranked, "colours of contacts");
    for (size_t k = 0; k < w->particles; k++)
        ranked[k] = (struct ranked){id[k], (uint32_t)k};
    qsort(ranked, w->particles, sizeof *ranked, by_id);
    for (size_t k = 0; k < w->particles; k++)
        w->rank[ranked[k].number] = (uint32_t)k;
    memory_free(ranked);
}

static void lists_make(struct work *w) {
    for (size_t k = 0; k < w->pairs; k++)
        for (int e = 0; e < 2; e++)
            w->degree[w->end[k][e]]++;
    for (size_t k = 0; k < w->pairs; k++)
        w->start[w->rank[w->end[k][head_of(w, k)]] + 1]++;
    for (size_t r = 0; r < w->particles; r++)
        w->start[r + 1] += w->start[r];
    size_t *at = memory_allocate(w->particles, sizeof *at, "colours of contacts");
    for (size_t r = 0; r < w->particles; r++)
        at[r] = w->start[r];
    for (size_t k = 0; k < w->pairs; k++) {
        int head = head_of(w, k);
        bool lower = w->rank[w->end[k][0]] < w->rank[w->end[k][1]];
        uint8_t image = (uint8_t)(lower ? w->image[k] : image_opposite(w->image[k]));
        struct entry entry = {w->rank[w->end[k][1 - head]], (uint32_t)k, image, {0, 0}};
        for (int e = 0; w->tie && e < 2; e++)
            entry.tie[e] = w->tie[k][e == head ? 0 : 1];
        w->entry[at[w->rank[w->end[k][head]]]++] = entry;
    }
    memory_free(at);
#pragma omp parallel for schedule(dynamic, 1024)
    for (size_t r = 0; r < w->particles; r++)
        qsort(w->entry + w->start[r], w->start[r + 1] - w->start[r], sizeof *w->entry, by_other);
}

/* The lowest colour that neither end of a single pair has. */
static void colour_single(struct work *w, uint32_t pair) {
    uint64_t *a = w->used[w->end[pair][0]], *b = w->used[w->end[pair][1]];
    for (int word = 0; word < WORDS; word++) {
        uint64_t free = ~(a[word] | b[word]);
        if (free == 0)
            continue;
        int bit = __builtin_ctzll(free);
        a[word] |= UINT64_C(1) << bit;
        b[word] |= UINT64_C(1) << bit;
        w->colour_of[pair] = 64 * word + bit;
        w->singles = w->colour_of[pair] >= w->singles ? w->colour_of[pair] + 1 : w->singles;
        return;
    }
}

/* The same for a bundle and all its particles; where none is left a colour of its own. */
static void colour_bundle(struct work *w, size_t r) {
    uint64_t all = 0;
    for (size_t e = w->start[r]; e < w->start[r + 1]; e++)
        for (int side = 0; side < 2; side++)
            all |= w->bundled[w->end[w->entry[e].pair][side]];
    int colour = ~all ? __builtin_ctzll(~all) : w->bundles > BUNDLE_COLOURS ? w->bundles : BUNDLE_COLOURS;
    for (size_t e = w->start[r]; e < w->start[r + 1]; e++)
        for (int side = 0; side < 2 && colour < BUNDLE_COLOURS; side++)
            w->bundled[w->end[w->entry[e].pair][side]] |= UINT64_C(1) << colour;
    w->bundle_colour[r] = colour;
    w->bundles = colour >= w->bundles ? colour + 1 : w->bundles;
}

static void colours_find(struct work *w) {
    for (size_t r = 0; r < w->particles; r++) {
        w->bundle_colour[r] = -1;
        if (w->start[r] == w->start[r + 1])
            continue;
        const uint32_t *end = w->end[w->entry[w->start[r]].pair];
        if (is_hub(w, end[0]) || is_hub(w, end[1])) {
            colour_bundle(w, r);
            continue;
        }
        for (size_t e = w->start[r]; e < w->start[r + 1]; e++)
            colour_single(w, w->entry[e].pair);
    }
}

static void cut_end(struct hard_colours *c, size_t at) {
    if (at > c->cut[c->cuts])
        c->cut[++c->cuts] = at;
}

/* Single pairs colour by colour, each in the order of the list, in cuts of a fixed size. */
static size_t singles_write(const struct work *w, struct hard_colours *c) {
    size_t *at = memory_allocate_zero((size_t)w->singles + 2, sizeof *at, "colours of contacts");
    size_t written = 0;
    for (size_t k = 0; k < w->pairs; k++)
        if (w->colour_of[k] >= 0)
            at[w->colour_of[k] + 1]++;
    for (int colour = 0; colour < w->singles; colour++)
        at[colour + 1] += at[colour];
    for (size_t k = 0; k < w->pairs; k++)
        if (w->colour_of[k] >= 0)
            c->order[at[w->colour_of[k]]++] = (uint32_t)k;
    for (int colour = 0; colour < w->singles; colour++) {
        for (; written < at[colour]; written = c->cut[c->cuts])
            cut_end(c, written + CUT_PAIRS < at[colour] ? written + CUT_PAIRS : at[colour]);
        c->colour[++c->colours] = c->cuts;
    }
    memory_free(at);
    return written;
}

/* Bundles colour by colour, a cut each. */
static void bundles_write(const struct work *w, struct hard_colours *c, size_t at) {
    for (int colour = 0; colour < w->bundles; colour++) {
        for (size_t r = 0; r < w->particles; r++) {
            if (w->bundle_colour[r] != colour)
                continue;
            for (size_t e = w->start[r]; e < w->start[r + 1]; e++)
                c->order[at++] = w->entry[e].pair;
            cut_end(c, at);
        }
        c->colour[++c->colours] = c->cuts;
    }
}

void hard_colours_make(struct hard_colours *colours, size_t pairs, const uint32_t (*end)[2],
                       const uint8_t *image, const int64_t (*tie)[2], size_t particles, const int64_t *id) {
    static const char what[] = "colours of contacts";
    struct work w = {.pairs = pairs, .particles = particles, .end = end, .image = image, .tie = tie};
    w.rank = memory_allocate(particles, sizeof *w.rank, what);
    w.degree = memory_allocate_zero(particles, sizeof *w.degree, what);
    w.start = memory_allocate_zero(particles + 1, sizeof *w.start, what);
    w.entry = memory_allocate(pairs, sizeof *w.entry, what);
    w.used = memory_allocate_zero(particles, sizeof *w.used, what);
    w.bundled = memory_allocate_zero(particles, sizeof *w.bundled, what);
    w.colour_of = memory_allocate(pairs, sizeof *w.colour_of, what);
    w.bundle_colour = memory_allocate(particles, sizeof *w.bundle_colour, what);
    for (size_t k = 0; k < pairs; k++)
        w.colour_of[k] = -1;
    ranks_make(&w, id);
    lists_make(&w);
    colours_find(&w);
    size_t colour_room = (size_t)(w.singles + w.bundles) + 1;
    *colours = (struct hard_colours){.pairs = pairs};
    colours->order = memory_allocate(pairs, sizeof *colours->order, what);
    colours->cut =
        memory_allocate_zero(pairs / CUT_PAIRS + particles + colour_room + 1, sizeof(size_t), what);
    colours->colour = memory_allocate_zero(colour_room, sizeof(size_t), what);
    bundles_write(&w, colours, singles_write(&w, colours));
    memory_free(w.rank);
    memory_free(w.degree);
    memory_free(w.start);
    memory_free(w.entry);
    memory_free(w.used);
    memory_free(w.bundled);
    memory_free(w.colour_of);
    memory_free(w.bundle_colour);
}

void hard_colours_free(struct hard_colours *colours) {
    memory_free(colours->order);
    memory_free(colours->cut);
    memory_free(colours->colour);
    *colours = (struct hard_colours){0};
}
