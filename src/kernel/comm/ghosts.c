/* SPDX-License-Identifier: BSD-3-Clause */
/* The plan of the copies.
 *
 * Invariants, from ghosts_make until ghosts_drop:
 *   - `to` and `from` are sorted by rank; peers may appear in one of them alone (reduced ghosts), and the own
 *     rank in both (copies of own particles).
 *   - to[t] covers the entries [first, first + count) of `original`: owned particles, one entry a copy;
 *     the entries made by round 1 (shadows.h) increase within a peer. from[f] covers the ghosts
 *     owned + [first, first + count).
 *   - The copies that rank a sends to b agree in number and order with those that b has from a, so messages
 *     contain no lengths.
 *   - Values cross in one message per peer; forward and reverse use the same two buffers the other way round,
 *     never at the same time.
 *   - Sums (reverse) run over `to` in rank order and inside a peer in entry order: fixed for a layout.
 */
#include "kernel/comm/ghosts.h"

#include "kernel/comm/copies.h"
#include "kernel/comm/ghosts_parts.h"
#include "kernel/comm/shadows.h"
#include "base/memory.h"
#include "base/scan.h"
#include "kernel/particles/fields.h"

#include <assert.h>
#include <string.h>

struct ghosts *ghosts_create(const struct comm *comm, const struct domain *domain, const struct box *box,
                             const struct ghosts_options *options) {
    assert(options->newton || !options->reduced);
    struct ghosts *ghosts = memory_allocate_zero(1, sizeof *ghosts, "ghost plan");
    ghosts->comm = comm;
    ghosts->domain = domain;
    ghosts->box = box;
    ghosts->options = *options;
    ghosts->misfit.id = -1;
    exchange_init(&ghosts->exchange, comm);
    /* the rounds are counted from 0 again: no rank may still be in a round of an earlier plan */
    comm_check(MPI_Barrier(comm->handle), "MPI_Barrier");
    return ghosts;
}

static void plan_free(struct ghosts *ghosts) {
    ghosts_used_free(&ghosts->used);
    memory_free(ghosts->to);
    memory_free(ghosts->from);
    memory_free(ghosts->original);
    memory_free(ghosts->border);
    memory_free(ghosts->image);
    memory_free(ghosts->number);
    memory_free(ghosts->place);
    memory_free(ghosts->to_message);
    memory_free(ghosts->from_message);
    ghosts->to = ghosts->from = NULL;
    ghosts->original = ghosts->border = ghosts->number = NULL;
    ghosts->image = NULL;
    ghosts->place = NULL;
    ghosts->to_message = ghosts->from_message = NULL;
    ghosts->to_count = ghosts->from_count = ghosts->sent = ghosts->border_count = ghosts->held = 0;
    memset(ghosts->class_count, 0, sizeof ghosts->class_count);
}

void ghosts_destroy(struct ghosts **ghosts) {
    if (*ghosts == NULL)
        return;
    assert((*ghosts)->flight.count == 0);
    plan_free(*ghosts);
    exchange_flight_free(&(*ghosts)->flight);
    memory_free((*ghosts)->to_buffer);
    memory_free((*ghosts)->from_buffer);
    memory_free(*ghosts);
    *ghosts = NULL;
}

void ghosts_migrate_rows(struct ghosts *ghosts, struct particles *particles,
                         const struct migrate_places *places, struct migrate_rows *rows, int n) {
    assert(ghosts->held == 0);
    ghosts->migrated += migrate_particles(&ghosts->exchange, ghosts->domain, particles, places, rows, n);
}

_Static_assert(sizeof(struct history_row) == 2 * 8 + 8 * HISTORY_COMPONENTS_MAX + 3 * 8, "rows have padding");

void ghosts_migrate(struct ghosts *ghosts, struct particles *particles, struct history_rows *rows) {
    const struct migrate_places unknown = {0};
    if (rows == NULL) {
        ghosts_migrate_rows(ghosts, particles, &unknown, NULL, 0);
        return;
    }
    struct migrate_rows set = {
        .start = rows->start, .row = rows->row, .count = rows->count, .row_bytes = sizeof *rows->row};
    ghosts_migrate_rows(ghosts, particles, &unknown, &set, 1);
    *rows = (struct history_rows){set.start, set.row, set.count, rows->components};
}

/* Calls a function for parts of a transfer, by several threads if the transfer is long enough. */
enum { PART = 4096 };

/* Fills the copies number[0 ... n - 1], and shifts their positions by their images. */
static void unpack(const struct ghosts *ghosts, struct particles *particles, const struct field_list *fields,
                   const uint32_t *number, size_t n, const char *buffer) {
    size_t each = fields_packed_bytes(particles, fields);
    const bool shifted = !ghosts->options.in_place && fields_listed(fields, FIELD_POSITION);
#pragma omp parallel for schedule(static) if (n > PART)
    for (size_t k = 0; k < n; k += PART) {
        size_t part = n - k < PART ? n - k : PART;
        fields_unpack_list(particles, fields, number + k, part, buffer + k * each);
        for (size_t g = k; g < k + part && shifted; g++) {
            const double *shift = ghosts->shift[ghosts->image[number[g] - particles->owned]];
            double *x = particles->state[number[g]].x;
            for (int d = 0; d < 3; d++)
                x[d] += shift[d];
        }
    }
}

static void plan_sends(struct ghosts *ghosts, struct shadows *shadows, size_t owned) {
    const struct groups *groups = &shadows->kept;
    ghosts->to_count = groups->count;
    ghosts->to = memory_allocate(groups->count, sizeof *ghosts->to, "peers");
    for (size_t g = 0; g < groups->count; g++)
        ghosts->to[g] =
            (struct peer){groups->rank[g], groups->start[g], groups->start[g + 1] - groups->start[g]};
    ghosts->sent = groups->start[groups->count];
    ghosts->original = memory_allocate(ghosts->sent, sizeof *ghosts->original, "copies held elsewhere");
    for (size_t k = 0; k < ghosts->sent; k++)
        ghosts->original[k] = shadows->original[groups->item[k]];
    uint8_t *has_copy = memory_allocate_zero(owned, 1, "border particles");
    for (size_t k = 0; k < ghosts->sent; k++)
        has_copy[ghosts->original[k]] = 1;
    ghosts->border = memory_allocate(ghosts->sent, sizeof *ghosts->border, "border particles");
    ghosts->border_count = scan_marked(has_copy, owned, ghosts->border);
    memory_free(has_copy);
}

static void plan_receives(struct ghosts *ghosts, const struct shadows *shadows,
                          const struct particles *particles) {
    const struct groups *groups = &shadows->held;
    ghosts->from_count = groups->count;
    ghosts->from = memory_allocate(groups->count, sizeof *ghosts->from, "peers");
    for (size_t g = 0; g < groups->count; g++)
        ghosts->from[g] =
            (struct peer){groups->rank[g], groups->start[g], groups->start[g + 1] - groups->start[g]};
    ghosts->held = shadows->count;
    size_t total = particles->owned + ghosts->held;
    if (total > (size_t)1 << PARTICLE_INDEX_BITS)
        error_fatal("%zu particles with copies on one rank, at most %zu are possible: use more ranks", total,
                    (size_t)1 << PARTICLE_INDEX_BITS);
    ghosts->image = memory_allocate(ghosts->held, 1, "images of copies");
    ghosts->number = memory_allocate(ghosts->held, sizeof *ghosts->number, "numbers of copies");
    for (size_t k = 0; k < ghosts->held; k++) {
        ghosts->number[k] = (uint32_t)(particles->owned + k);
        ghosts->image[k] = shadows->shadow[groups->item[k]].image;
    }
}

static void append_copies(struct ghosts *ghosts, const struct shadows *shadows, struct particles *particles) {
    size_t owned = particles->owned;
    const struct field_list fields = fields_with(particles, FIELD_GHOST);
    particles_reserve(particles, owned + ghosts->held);
    if (ghosts->options.in_place)
        ghosts->place = memory_allocate(ghosts->held, sizeof *ghosts->place, "places of originals");
#pragma omp parallel for schedule(static) if (ghosts->held > PART)
    for (size_t k = 0; k < ghosts->held; k++) {
        const double *shift = ghosts->shift[ghosts->image[k]];
        fields_unpack(particles, &fields, owned + k, 1, shadows->shadow[shadows->held.item[k]].fields);
        if (ghosts->place)
            memcpy(ghosts->place[k], particles->state[owned + k].x, sizeof *ghosts->place);
        for (int d = 0; d < 3; d++)
            particles->state[owned + k].x[d] += shift[d];
    }
    fields_clear_reverse(particles, owned, ghosts->held);
    for (size_t k = 0; k < ghosts->held; k++)
        ghosts->class_count[particles->size_class[owned + k]]++;
    particles->ghosts = ghosts->held;
    particles->revision++;
    ghosts->revision = particles->revision;
}

static char *buffer_room(char *buffer, size_t *room, size_t bytes) {
    if (bytes <= *room)
        return buffer;
    *room = bytes + bytes / 8;
    memory_free(buffer);
    return memory_allocate(*room, 1, "values of copies");
}

/* Makes the messages. Each exchange sets the lengths and the pointers into the buffers. */
static void plan_buffers(struct ghosts *ghosts) {
    ghosts->to_message = memory_allocate(ghosts->to_count, sizeof *ghosts->to_message, "messages");
    ghosts->from_message = memory_allocate(ghosts->from_count, sizeof *ghosts->from_message, "messages");
}

/* Notes a particle for which next-neighbour synchronisation is not enough. The copies of the particle are
 * made nevertheless. */
static void note_misfit(struct ghosts *ghosts, const struct copies *copies,
                        const struct particles *particles) {
    if (!copies->far || ghosts->options.sync != GHOSTS_NEIGHBOURS || ghosts->misfit.id >= 0)
        return;
    ghosts->misfit.id = particles->id[copies->farthest];
    ghosts->misfit.radius = particles->state[copies->farthest].radius;
    ghosts->misfit.reach = copies->radius;
    ghosts->misfit.clearance = domain_clearance(ghosts->domain);
}

bool ghosts_fit(const struct ghosts *ghosts, struct error *error) {
    if (ghosts->misfit.id < 0)
        return true;
    return error_set(
        error, ERROR_USER,
        "sync: neighbours: particle %lld of radius %.6g must be known up to %.6g from its centre, but "
        "what lies %.6g from the subdomain of rank %d is not next to it any more; use sync: shadow or "
        "auto, or fewer ranks",
        (long long)ghosts->misfit.id, ghosts->misfit.radius, ghosts->misfit.reach, ghosts->misfit.clearance,
        ghosts->comm->rank);
}

void ghosts_make(struct ghosts *ghosts, struct particles *particles, const struct size_classes *classes) {
    assert(particles->ghosts == 0 && ghosts->held == 0 && ghosts->flight.count == 0);
    plan_free(ghosts);
    box_image_shifts(ghosts->box, ghosts->shift);
    ghosts->revision = particles->revision;
    if (ghosts->comm->size == 1 && !ghosts->box->motion.shears)
        return;
    double reach[CLASS_MAX];
    struct copies copies;
    struct shadows shadows;
    copies_reach(classes, ghosts->options.reduced, reach);
    for (int c = 0; c < classes->count; c++)
        reach[c] += ghosts->outside;
    copies_select(&copies, ghosts->comm, ghosts->domain, ghosts->box, particles, reach);
    note_misfit(ghosts, &copies, particles);
    if (copies.far && copies.radius > ghosts->farthest)
        ghosts->farthest = copies.radius;
    struct shadows_place place = {&ghosts->exchange, ghosts->domain, ghosts->box, particles, reach};
    shadows_spread(&shadows, &place, &copies);
    plan_sends(ghosts, &shadows, particles->owned);
    plan_receives(ghosts, &shadows, particles);
    append_copies(ghosts, &shadows, particles);
    plan_buffers(ghosts);
    if (shadows.rounds > ghosts->rounds)
        ghosts->rounds = shadows.rounds;
    shadows_free(&shadows);
    copies_free(&copies);
}

void ghosts_drop(struct ghosts *ghosts, struct particles *particles) {
    assert(ghosts->flight.count == 0);
    plan_free(ghosts);
    if (particles->ghosts > 0)
        particles->revision++;
    particles->ghosts = 0;
}

/* The copies that an exchange carries: all, or those that pairs use. */
static struct ghosts_used copies_all(const struct ghosts *ghosts) {
    struct ghosts_used all = {.known = true,
                              .to = ghosts->to,
                              .from = ghosts->from,
                              .original = ghosts->original,
                              .number = ghosts->number,
                              .sent = ghosts->sent,
                              .held = ghosts->held};
    memcpy(all.class_count, ghosts->class_count, sizeof all.class_count);
    return all;
}

static struct ghosts_used copies_of(const struct ghosts *ghosts, bool used) {
    return used && ghosts->used.known ? ghosts->used : copies_all(ghosts);
}

/* Counts the bytes of copies that were received or are sent back, `each` bytes a copy. */
static void count_bytes(struct ghosts *ghosts, const struct ghosts_used *copies, size_t each) {
    for (int c = 0; c < CLASS_MAX; c++)
        ghosts->class_bytes[c] += copies->class_count[c] * each;
}

/* The messages of an exchange in which a copy has `each` bytes. */
static void plan_messages(const struct peer *peer, size_t peers, size_t each, char *buffer,
                          struct exchange_message *message) {
    for (size_t k = 0; k < peers; k++)
        message[k] =
            (struct exchange_message){peer[k].rank, peer[k].count * each, buffer + peer[k].first * each};
}

static void plan_ready(const struct ghosts *ghosts, const struct particles *particles) {
    (void)particles;
    (void)ghosts;
    assert(ghosts->flight.count == 0);
    assert(particles->ghosts == ghosts->held && particles->revision == ghosts->revision);
}

/* Room in both buffers, and the messages of an exchange in which a copy has `each` bytes. */
static void plan_exchange(struct ghosts *ghosts, const struct ghosts_used *copies, size_t each) {
    ghosts->to_buffer = buffer_room(ghosts->to_buffer, &ghosts->to_room, copies->sent * each);
    ghosts->from_buffer = buffer_room(ghosts->from_buffer, &ghosts->from_room, copies->held * each);
    plan_messages(copies->to, ghosts->to_count, each, ghosts->to_buffer, ghosts->to_message);
    plan_messages(copies->from, ghosts->from_count, each, ghosts->from_buffer, ghosts->from_message);
}

/* Packed values of copies go from their holders to the owners: to_buffer gets those of from_buffer. */
static void send_back(struct ghosts *ghosts) {
    exchange_start(&ghosts->exchange, COMM_TAG_REVERSE, ghosts->from_message, ghosts->from_count,
                   ghosts->to_message, ghosts->to_count, &ghosts->flight);
    exchange_finish(&ghosts->flight);
}

static void forward_begin(struct ghosts *ghosts, struct particles *particles, const struct field_list *fields,
                          bool used) {
    const struct ghosts_used copies = copies_of(ghosts, used);
    plan_ready(ghosts, particles);
    assert(fields->count > 0);
    ghosts->flying = *fields;
    ghosts->flying_used = used;
    plan_exchange(ghosts, &copies, fields_packed_bytes(particles, fields));
    copies_pack(particles, fields, copies.original, copies.sent, ghosts->to_buffer);
    exchange_start(&ghosts->exchange, COMM_TAG_FORWARD, ghosts->to_message, ghosts->to_count,
                   ghosts->from_message, ghosts->from_count, &ghosts->flight);
}

void ghosts_forward_begin(struct ghosts *ghosts, struct particles *particles,
                          const struct field_list *fields) {
    forward_begin(ghosts, particles, fields, false);
}

void ghosts_step_begin(struct ghosts *ghosts, struct particles *particles, const struct field_list *fields) {
    forward_begin(ghosts, particles, fields, true);
}

void ghosts_forward_end(struct ghosts *ghosts, struct particles *particles) {
    const struct ghosts_used copies = copies_of(ghosts, ghosts->flying_used);
    exchange_finish(&ghosts->flight);
    unpack(ghosts, particles, &ghosts->flying, copies.number, copies.held, ghosts->from_buffer);
    count_bytes(ghosts, &copies, fields_packed_bytes(particles, &ghosts->flying));
}

static void sum(struct ghosts *ghosts, struct particles *particles, const struct field_list *fields,
                bool used) {
    const struct ghosts_used copies = copies_of(ghosts, used);
    plan_ready(ghosts, particles);
    size_t each = fields_packed_bytes(particles, fields);
    plan_exchange(ghosts, &copies, each);
    copies_pack(particles, fields, copies.number, copies.held, ghosts->from_buffer);
    send_back(ghosts);
    count_bytes(ghosts, &copies, each);
    fields_unpack_add(particles, fields, copies.original, copies.sent, ghosts->to_buffer);
}

void ghosts_reverse(struct ghosts *ghosts, struct particles *particles, const struct field_list *fields) {
    if (ghosts->options.newton)
        sum(ghosts, particles, fields, false);
}

void ghosts_step_reverse(struct ghosts *ghosts, struct particles *particles,
                         const struct field_list *fields) {
    if (ghosts->options.newton)
        sum(ghosts, particles, fields, true);
}

void ghosts_sum(struct ghosts *ghosts, struct particles *particles, const struct field_list *fields) {
    sum(ghosts, particles, fields, false);
}

void ghosts_use(struct ghosts *ghosts, struct particles *particles, const uint8_t *used) {
    const struct ghosts_used all = copies_all(ghosts);
    plan_ready(ghosts, particles);
    plan_exchange(ghosts, &all, 1);
    if (ghosts->held > 0)
        memcpy(ghosts->from_buffer, used, ghosts->held);
    send_back(ghosts);
    ghosts_used_make(ghosts, particles, (const uint8_t *)ghosts->to_buffer, used);
}

const uint32_t *ghosts_originals(const struct ghosts *ghosts, size_t *count) {
    *count = ghosts->border_count;
    return ghosts->border;
}

const uint32_t *ghosts_step_originals(const struct ghosts *ghosts, size_t *count) {
    const struct ghosts_used copies = copies_of(ghosts, true);
    *count = copies.sent;
    return copies.original;
}

/* The peer that is this rank itself, or NULL. */
static const struct peer *peer_self(const struct ghosts *ghosts, const struct peer *peer, size_t count) {
    for (size_t k = 0; k < count; k++)
        if (peer[k].rank == ghosts->comm->rank)
            return &peer[k];
    return NULL;
}

const uint32_t *ghosts_own(const struct ghosts *ghosts, size_t *first, size_t *count) {
    const struct peer *to = peer_self(ghosts, ghosts->to, ghosts->to_count);
    const struct peer *from = peer_self(ghosts, ghosts->from, ghosts->from_count);
    *first = *count = 0;
    if (to == NULL || from == NULL)
        return NULL;
    assert(to->count == from->count);
    *first = ghosts->number[from->first];
    *count = from->count;
    return ghosts->original + to->first;
}

const uint8_t *ghosts_unshift(struct ghosts *ghosts, struct particles *particles) {
    assert(ghosts->options.in_place && particles->ghosts == ghosts->held);
    for (size_t k = 0; k < ghosts->held; k++)
        memcpy(particles->state[particles->owned + k].x, ghosts->place[k], sizeof *ghosts->place);
    return ghosts->image;
}

unsigned ghosts_image(const struct ghosts *ghosts, size_t k) {
    assert(k < ghosts->held);
    return ghosts->image[k];
}
