#include "comm/copies.h"

#include "core/memory.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <omp.h>

void copies_reach(const struct size_classes *classes, bool reduced, double reach[CLASS_MAX]) {
    for (int a = 0; a < classes->count; a++) {
        int last = reduced ? a : classes->count - 1;
        reach[a] = 0;
        for (int c = 0; c <= last; c++)
            reach[a] = fmax(reach[a], classes->radius_max[c] + classes->margin[a][c]);
    }
}

/* The finds of one thread, in the order of its particles. */
struct found {
    size_t count, capacity;
    int *rank;
    uint32_t *particle;
    uint8_t *image;
};

/* What all threads read. */
struct selection {
    const struct domain *domain;
    const struct particles *particles;
    const double *reach;
    int own;
    double lower[3], upper[3]; /* of the own subdomain; infinite where wrapped */
    double limit[3];           /* a ball must be smaller than this */
};

static void found_put(struct found *found, int rank, uint32_t particle, unsigned image) {
    if (found->count == found->capacity) {
        found->capacity = 2 * found->capacity + 256;
        found->rank = memory_resize(found->rank, found->capacity, sizeof *found->rank, "copies");
        found->particle = memory_resize(found->particle, found->capacity, sizeof *found->particle, "copies");
        found->image = memory_resize(found->image, found->capacity, sizeof *found->image, "copies");
    }
    found->rank[found->count] = rank;
    found->particle[found->count] = particle;
    found->image[found->count++] = (uint8_t)image;
}

static bool stays_inside(const struct selection *selection, const double x[3], double radius) {
    for (int d = 0; d < 3; d++)
        if (x[d] - selection->lower[d] <= radius || selection->upper[d] - x[d] <= radius)
            return false;
    return true;
}

static void check_limit(const struct selection *selection, size_t k, double radius) {
    for (int d = 0; d < 3; d++)
        if (radius >= selection->limit[d])
            error_fatal(
                "particle %lld with radius %g must be known up to %g from its centre, but the periodic "
                "box has the edge %g: 2 r + range + skin must be less than that",
                (long long)selection->particles->id[k], selection->particles->state[k].radius, radius,
                selection->limit[d]);
}

/* The copies of particle k. `touch` is the thread's own memory, grown as needed. */
static void find_copies(const struct selection *selection, size_t k, struct domain_touch **touch, int *room,
                        struct found *found) {
    const struct particle_state *state = &selection->particles->state[k];
    double radius = state->radius + selection->reach[selection->particles->size_class[k]];
    radius *= 1 + 8 * DBL_EPSILON;
    if (stays_inside(selection, state->x, radius))
        return;
    check_limit(selection, k, radius);
    int n = domain_touching(selection->domain, state->x, radius, *touch, *room);
    if (n > *room) {
        *room = 2 * n;
        *touch = memory_resize(*touch, (size_t)*room, sizeof **touch, "places a particle touches");
        n = domain_touching(selection->domain, state->x, radius, *touch, *room);
    }
    for (int t = 0; t < n; t++) {
        const struct domain_touch *at = &(*touch)[t];
        unsigned image = box_image_code(at->image[0], at->image[1], at->image[2]);
        if (at->rank != selection->own || image != 0)
            found_put(found, at->rank, (uint32_t)k, image);
    }
}

static void find_range(const struct selection *selection, size_t first, size_t last, struct found *found) {
    int room = 64;
    struct domain_touch *touch = memory_allocate((size_t)room, sizeof *touch, "places a particle touches");
    for (size_t k = first; k < last; k++)
        find_copies(selection, k, &touch, &room, found);
    memory_free(touch);
}

/* Joins the finds of all threads and sorts them by rank. Frees them. */
static void join(struct copies *copies, struct found *found, int threads, int size) {
    size_t total = 0;
    for (int t = 0; t < threads; t++)
        total += found[t].count;
    int *rank = memory_allocate(total, sizeof *rank, "copies");
    uint32_t *particle = memory_allocate(total, sizeof *particle, "copies");
    uint8_t *image = memory_allocate(total, sizeof *image, "copies");
    size_t at = 0;
    for (int t = 0; t < threads; t++) {
        for (size_t k = 0; k < found[t].count; k++, at++) {
            rank[at] = found[t].rank[k];
            particle[at] = found[t].particle[k];
            image[at] = found[t].image[k];
        }
        memory_free(found[t].rank);
        memory_free(found[t].particle);
        memory_free(found[t].image);
    }
    groups_make(&copies->groups, rank, total, size);
    copies->particle = memory_allocate(total, sizeof *copies->particle, "copies to send");
    copies->image = memory_allocate(total, sizeof *copies->image, "copies to send");
    for (size_t k = 0; k < total; k++) {
        uint32_t from = copies->groups.item[k];
        copies->particle[k] = particle[from];
        copies->image[k] = image[from];
        copies->groups.item[k] = (uint32_t)k;
    }
    memory_free(rank);
    memory_free(particle);
    memory_free(image);
}

void copies_select(struct copies *copies, const struct comm *comm, const struct domain *domain,
                   const struct box *box, const struct particles *particles, const double reach[CLASS_MAX]) {
    struct selection selection = {
        .domain = domain, .particles = particles, .reach = reach, .own = comm->rank};
    bool wrapped[3];
    domain_wrap(domain, wrapped);
    domain_bounds(domain, comm->rank, selection.lower, selection.upper);
    for (int d = 0; d < 3; d++) {
        selection.limit[d] = box->periodic[d] && !wrapped[d] ? box->edge[d] : INFINITY;
        if (wrapped[d]) {
            selection.lower[d] = -INFINITY;
            selection.upper[d] = INFINITY;
        }
    }
    int threads = omp_get_max_threads();
    struct found *found = memory_allocate_zero((size_t)threads, sizeof *found, "copies per thread");
#pragma omp parallel num_threads(threads)
    {
        size_t me = (size_t)omp_get_thread_num(), team = (size_t)omp_get_num_threads();
        struct found mine = {0};
        find_range(&selection, particles->owned * me / team, particles->owned * (me + 1) / team, &mine);
        found[me] = mine;
    }
    join(copies, found, threads, comm->size);
    memory_free(found);
}

void copies_free(struct copies *copies) {
    groups_free(&copies->groups);
    memory_free(copies->particle);
    memory_free(copies->image);
    *copies = (struct copies){0};
}
