/* SPDX-License-Identifier: BSD-3-Clause */
/* Finds the ranks that need a copy of a particle, and packs the copies. Read copies.h first. */
#include "kernel/comm/copies.h"

#include "base/memory.h"
#include "kernel/particles/fields.h"
#include "kernel/particles/kinds.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <omp.h>

void copies_reach(const struct size_classes *classes, bool reduced, double reach[CLASS_MAX]) {
    double most = 0.0;
    for (int a = 0; a < classes->count; a++) {
        int last = reduced ? a : classes->count - 1;
        reach[a] = -INFINITY;
        for (int c = 0; c <= last; c++)
            if (classes_meet(classes, a, c))
                reach[a] = fmax(fmax(reach[a], 0), classes->radius_max[c] + classes->margin[a][c]);
        if (classes->kind[a] == KIND_BODY) /* known wherever it may have members, or copies of them */
            reach[a] = fmax(reach[a], most + 1e-9 * classes->radius_max[a]);
        most = fmax(most, reach[a]);
    }
}

/* The copies found by one thread, in the order of the thread's particles. */
struct found {
    size_t count, capacity;
    int *rank;
    uint32_t *particle;
    uint8_t *image, *how;
    bool far;
    size_t farthest;
    double radius;
};

/* Data that all threads read. */
struct selection {
    const struct domain *domain;
    const struct particles *particles;
    const double *reach, *own;
    const struct box *box;
    const struct domain_place *place;
    size_t places;
    double clearance;
    double lower[3], upper[3]; /* corners of the own subdomain; infinite in wrapped directions */
    double limit[3];           /* a ball must be smaller than this */
};

static const struct field own_reach = {.name = "own_reach",
                                       .type = FIELD_DOUBLE,
                                       .components = 1,
                                       .use = FIELD_GHOST | FIELD_MIGRATE,
                                       .unit = "m",
                                       .needed_for = "bonds",
                                       .help = "distance up to which other ranks must know the particle"};

void copies_register_reach(struct particles *particles) {
    fields_register(particles, &own_reach);
}

double *copies_own_reach(const struct particles *particles) {
    return fields_values(particles, &own_reach);
}

void copies_ball(struct copy_ball *ball, const struct particle_state *state, double reach, double own,
                 const struct box *box) {
    ball->x = state->x;
    ball->radius = (state->radius + reach) * (1 + 8 * DBL_EPSILON);
    if (own > 0 && own > ball->radius)
        ball->radius = own;
    ball->relay =
        ball->radius + 64 * DBL_EPSILON * (box->edge[0] + box->edge[1] + box->edge[2] + ball->radius);
}

static void found_put(struct found *found, int rank, uint32_t particle, unsigned image, unsigned how) {
    if (found->count == found->capacity) {
        found->capacity = 2 * found->capacity + 256;
        found->rank = memory_resize(found->rank, found->capacity, sizeof *found->rank, "copies");
        found->particle = memory_resize(found->particle, found->capacity, sizeof *found->particle, "copies");
        found->image = memory_resize(found->image, found->capacity, sizeof *found->image, "copies");
        found->how = memory_resize(found->how, found->capacity, sizeof *found->how, "copies");
    }
    found->rank[found->count] = rank;
    found->particle[found->count] = particle;
    found->how[found->count] = (uint8_t)how;
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

static void note_far(struct found *found, size_t k, double radius) {
    if (!found->far || radius > found->radius) {
        found->farthest = k;
        found->radius = radius;
    }
    found->far = true;
}

static void find_copies(const struct selection *selection, size_t k, struct found *found) {
    const struct particle_state *state = &selection->particles->state[k];
    struct copy_ball ball;
    copies_ball(&ball, state, selection->reach[selection->particles->size_class[k]],
                selection->own ? selection->own[k] : 0, selection->box);
    if (stays_inside(selection, state->x, ball.radius))
        return;
    check_limit(selection, k, ball.radius);
    bool far = ball.relay >= selection->clearance;
    if (far)
        note_far(found, k, ball.radius);
    for (size_t p = 0; p < selection->places; p++) {
        const struct domain_place *place = &selection->place[p];
        int image[3] = {place->image[0], place->image[1], place->image[2]};
        domain_settle_image(selection->domain, ball.x, image);
        double distance2 = domain_place_distance2(selection->domain, place, ball.x, image);
        bool needed = distance2 <= ball.radius * ball.radius;
        if (needed || (far && distance2 <= ball.relay * ball.relay))
            found_put(found, place->rank, (uint32_t)k, image_code(image[0], image[1], image[2]),
                      (far ? COPY_FAR : 0u) | (needed ? 0u : COPY_RELAY));
    }
}

/* Joins the copies found by all threads, sorts them by rank, and frees the threads' lists. */
static void join(struct copies *copies, struct found *found, int threads, int size) {
    size_t total = 0;
    for (int t = 0; t < threads; t++)
        total += found[t].count;
    int *rank = memory_allocate(total, sizeof *rank, "copies");
    struct copies all = {.particle = memory_allocate(total, sizeof *all.particle, "copies"),
                         .image = memory_allocate(total, sizeof *all.image, "copies"),
                         .how = memory_allocate(total, sizeof *all.how, "copies")};
    size_t at = 0;
    for (int t = 0; t < threads; t++) {
        for (size_t k = 0; k < found[t].count; k++, at++) {
            rank[at] = found[t].rank[k];
            all.particle[at] = found[t].particle[k];
            all.image[at] = found[t].image[k];
            all.how[at] = found[t].how[k];
        }
        if (found[t].far && (!copies->far || found[t].radius > copies->radius)) {
            copies->far = true;
            copies->farthest = found[t].farthest;
            copies->radius = found[t].radius;
        }
        memory_free(found[t].rank);
        memory_free(found[t].particle);
        memory_free(found[t].image);
        memory_free(found[t].how);
    }
    rank_groups_make(&copies->groups, rank, total, size);
    copies->particle = memory_allocate(total, sizeof *copies->particle, "copies to send");
    copies->image = memory_allocate(total, sizeof *copies->image, "copies to send");
    copies->how = memory_allocate(total, sizeof *copies->how, "copies to send");
    for (size_t k = 0; k < total; k++) {
        uint32_t from = copies->groups.item[k];
        copies->particle[k] = all.particle[from];
        copies->image[k] = all.image[from];
        copies->how[k] = all.how[from];
        copies->groups.item[k] = (uint32_t)k;
    }
    memory_free(rank);
    memory_free(all.particle);
    memory_free(all.image);
    memory_free(all.how);
}

void copies_select(struct copies *copies, const struct comm *comm, const struct domain *domain,
                   const struct box *box, const struct particles *particles, const double reach[CLASS_MAX]) {
    struct selection selection = {.domain = domain,
                                  .particles = particles,
                                  .reach = reach,
                                  .own = copies_own_reach(particles),
                                  .box = box,
                                  .clearance = domain_clearance(domain)};
    *copies = (struct copies){0};
    selection.place = domain_neighbours(domain, &selection.places);
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
        for (size_t k = particles->owned * me / team; k < particles->owned * (me + 1) / team; k++)
            find_copies(&selection, k, &mine);
        found[me] = mine;
    }
    join(copies, found, threads, comm->size);
    memory_free(found);
}

void copies_free(struct copies *copies) {
    rank_groups_free(&copies->groups);
    memory_free(copies->particle);
    memory_free(copies->image);
    memory_free(copies->how);
    *copies = (struct copies){0};
}

void copies_pack(const struct particles *particles, const struct field_list *fields, const uint32_t *list,
                 size_t n, char *buffer) {
    size_t each = fields_packed_bytes(particles, fields);
    enum { PART = 4096 };
#pragma omp parallel for schedule(static) if (n > PART)
    for (size_t first = 0; first < n; first += PART) {
        size_t part = n - first < PART ? n - first : PART;
        fields_pack(particles, fields, list + first, part, buffer + first * each);
    }
}
