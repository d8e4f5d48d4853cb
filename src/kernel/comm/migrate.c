/* SPDX-License-Identifier: BSD-3-Clause */
/* A message holds, for n particles: n (8 bytes), their MIGRATE fields (fields_pack), and for each row set n
 * counts (8 bytes each) and the rows themselves, particle after particle. The receiver checks that the parts
 * add up to the length that came. */
#include "kernel/comm/migrate.h"

#include "kernel/comm/rank_groups.h"
#include "base/memory.h"
#include "base/scan.h"
#include "kernel/particles/fields.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* The particles that leave, grouped by destination: groups.item holds indices into `particle`. */
struct leavers {
    struct groups groups;
    uint32_t *particle;
    size_t count;
};

size_t migrate_places(const struct comm *comm, const struct domain *domain, const struct particles *particles,
                      uint32_t *place) {
    size_t owned = particles->owned;
    double lower[3], upper[3];
    uint8_t *leaves = memory_allocate(owned, 1, "particles that leave");
    domain_bounds(domain, comm->rank, lower, upper);
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < owned; k++)
        leaves[k] = domain_owner_from(domain, comm->rank, lower, upper, particles->state[k].x) != comm->rank;
    size_t stay = particles_places(leaves, owned, place);
    memory_free(leaves);
    return stay;
}

static void find_leavers(struct leavers *leavers, const struct comm *comm, const struct domain *domain,
                         const struct particles *particles, const struct migrate_places *places) {
    double lower[3], upper[3];
    const size_t n = leavers->count = particles->owned - places->stay;
    domain_bounds(domain, comm->rank, lower, upper);
    const size_t looked = n > 0 ? particles->owned : 0;
    uint8_t *leaves = memory_allocate(looked, 1, "particles that leave");
    uint32_t *found = memory_allocate(n, sizeof *found, "particles that leave");
    int *owner = memory_allocate(n, sizeof *owner, "owners");
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < looked; k++)
        leaves[k] = places->place[k] == PARTICLE_LEFT;
    size_t count = scan_marked(leaves, looked, found);
    assert(count == n);
    (void)count;
    memory_free(leaves);
    for (size_t k = 0; k < n; k++)
        owner[k] = domain_owner_from(domain, comm->rank, lower, upper, particles->state[found[k]].x);
    rank_groups_make(&leavers->groups, owner, n, comm->size);
    leavers->particle = memory_allocate(n, sizeof *leavers->particle, "particles that leave");
    for (size_t k = 0; k < n; k++) /* sorted by destination */
        leavers->particle[k] = found[leavers->groups.item[k]];
    memory_free(owner);
    memory_free(found);
}

/* A row and the particle that carries it. */
struct carried {
    uint32_t carrier, row;
};

static int compare_carried(const void *a, const void *b) {
    const struct carried *x = a, *y = b;
    return x->carrier != y->carrier ? (x->carrier > y->carrier) - (x->carrier < y->carrier)
                                    : (x->row > y->row) - (x->row < y->row);
}

/* Sorts the rows of a set by their carriers. */
static void sort_carried(struct migrate_rows *rows) {
    struct carried *order = memory_allocate(rows->count, sizeof *order, "rows by particle");
    char *sorted = memory_allocate(rows->count, rows->row_bytes, "rows by particle");
    for (size_t r = 0; r < rows->count; r++)
        order[r] = (struct carried){rows->carrier[r], (uint32_t)r};
    if (rows->count > 1)
        qsort(order, rows->count, sizeof *order, compare_carried);
    for (size_t r = 0; r < rows->count; r++) {
        rows->carrier[r] = order[r].carrier;
        memcpy(sorted + r * rows->row_bytes, (const char *)rows->row + order[r].row * rows->row_bytes,
               rows->row_bytes);
    }
    memory_free(order);
    memory_free(rows->row);
    rows->row = sorted;
}

/* The first row of particle k, and how many it carries. */
static size_t first_row(const struct migrate_rows *rows, uint32_t k) {
    return rows->start ? rows->start[k] : scan_first(rows->carrier, rows->count, k);
}

static size_t rows_of(const struct migrate_rows *rows, uint32_t k) {
    return first_row(rows, k + 1) - first_row(rows, k);
}

static char *put(char *to, const void *from, size_t bytes) {
    if (bytes > 0)
        memcpy(to, from, bytes);
    return to + bytes;
}

/* Copies `count` rows, the first bytes of each that both sides have. */
static void copy_rows(char *to, size_t to_bytes, const char *from, size_t from_bytes, size_t count) {
    size_t bytes = to_bytes < from_bytes ? to_bytes : from_bytes;
    if (to_bytes == from_bytes)
        put(to, from, count * bytes);
    else
        for (size_t k = 0; k < count; k++)
            memcpy(to + k * to_bytes, from + k * from_bytes, bytes);
}

static size_t sent_bytes(const struct migrate_rows *rows) {
    return rows->sent > 0 ? rows->sent : rows->row_bytes;
}

static char *pack_rows(const struct migrate_rows *rows, const uint32_t *list, size_t n, char *to) {
    for (size_t k = 0; k < n; k++) {
        uint64_t count = rows_of(rows, list[k]);
        to = put(to, &count, sizeof count);
    }
    for (size_t k = 0; k < n; k++) {
        const char *from = (const char *)rows->row + first_row(rows, list[k]) * rows->row_bytes;
        copy_rows(to, sent_bytes(rows), from, rows->row_bytes, rows_of(rows, list[k]));
        to += rows_of(rows, list[k]) * sent_bytes(rows);
    }
    return to;
}

/* Makes the message with the particles list[0 ... n-1]. */
static void pack_message(struct exchange_message *message, const struct particles *particles,
                         const struct migrate_rows *rows, int sets, const uint32_t *list, size_t n) {
    const struct field_list fields = fields_with(particles, FIELD_MIGRATE);
    size_t bytes = sizeof(uint64_t) + n * fields_packed_bytes(particles, &fields);
    for (int s = 0; s < sets; s++)
        for (size_t k = 0; k < n; k++)
            bytes += sizeof(uint64_t) + rows_of(&rows[s], list[k]) * sent_bytes(&rows[s]);
    message->bytes = bytes;
    message->data = memory_allocate(bytes, 1, "particles that leave");
    uint64_t count = n;
    char *to = put(message->data, &count, sizeof count);
    to = fields_pack(particles, &fields, list, n, to);
    for (int s = 0; s < sets; s++)
        to = pack_rows(&rows[s], list, n, to);
    assert(to == message->data + bytes);
}

/* A message that came in, taken apart. */
struct arrivals {
    size_t count;       /* particles */
    const char *fields; /* packed */
    struct {
        const char *counts, *rows;
        size_t total;
    } set[MIGRATE_SETS_MAX];
};

static uint64_t read_count(const char *from, size_t k) {
    uint64_t count;
    memcpy(&count, from + k * sizeof count, sizeof count);
    return count;
}

/* Takes `count` items of `size` bytes off the front of the rest of a message. */
static const char *take(const struct exchange_message *message, size_t *left, uint64_t count, size_t size) {
    const char *part = message->data + (message->bytes - *left);
    if (size > 0 && count > *left / size)
        error_fatal("migration: the message from rank %d ends after %zu bytes, too early", message->rank,
                    message->bytes);
    *left -= count * size;
    return part;
}

static struct arrivals take_apart(const struct exchange_message *message, const struct particles *particles,
                                  const struct migrate_rows *rows, int sets) {
    struct arrivals arrivals;
    size_t left = message->bytes;
    const struct field_list fields = fields_with(particles, FIELD_MIGRATE);
    arrivals.count = read_count(take(message, &left, 1, sizeof(uint64_t)), 0);
    arrivals.fields = take(message, &left, arrivals.count, fields_packed_bytes(particles, &fields));
    for (int s = 0; s < sets; s++) {
        arrivals.set[s].counts = take(message, &left, arrivals.count, sizeof(uint64_t));
        arrivals.set[s].total = 0;
        for (size_t k = 0; k < arrivals.count; k++)
            arrivals.set[s].total += read_count(arrivals.set[s].counts, k);
        arrivals.set[s].rows = take(message, &left, arrivals.set[s].total, sent_bytes(&rows[s]));
    }
    if (left != 0)
        error_fatal("migration: the message from rank %d has %zu bytes, %zu more than its contents",
                    message->rank, message->bytes, left);
    return arrivals;
}

/* Makes row set `s` of the particles here now: first the rows of the particles that stay, from[0 ... stay -
 * 1], then the rows of the arrivals. */
static void join_rows(struct migrate_rows *rows, int s, const uint32_t *from, size_t stay,
                      const struct arrivals *arrivals, size_t messages) {
    size_t particles = stay, count = rows->count;
    for (size_t m = 0; m < messages; m++) {
        particles += arrivals[m].count;
        count += arrivals[m].set[s].total;
    }
    struct migrate_rows joined = {.row_bytes = rows->row_bytes, .sent = rows->sent};
    joined.start = memory_allocate(particles + 1, sizeof *joined.start, "rows by particle");
    joined.row = memory_allocate_zero(count, rows->row_bytes, "rows by particle");
    char *to = joined.row;
    size_t p = 0;
    for (; p < stay; p++) {
        size_t n = rows_of(rows, from[p]);
        joined.start[p] = joined.count;
        to = put(to, (const char *)rows->row + rows->start[from[p]] * rows->row_bytes, n * rows->row_bytes);
        joined.count += n;
    }
    for (size_t m = 0; m < messages; m++) {
        for (size_t k = 0; k < arrivals[m].count; k++) {
            joined.start[p++] = joined.count;
            joined.count += read_count(arrivals[m].set[s].counts, k);
        }
        copy_rows(to, rows->row_bytes, arrivals[m].set[s].rows, sent_bytes(rows), arrivals[m].set[s].total);
        to += arrivals[m].set[s].total * rows->row_bytes;
    }
    joined.start[p] = joined.count;
    memory_free(rows->start);
    memory_free(rows->row);
    *rows = joined;
}

/* Replaces row set `s` of the particles that left by the rows of the arrivals; the first of these is particle
 * number `stay`. */
static void replace_rows(struct migrate_rows *rows, int s, size_t stay, const struct arrivals *arrivals,
                         size_t messages) {
    size_t count = 0, row = 0, p = stay;
    for (size_t m = 0; m < messages; m++)
        count += arrivals[m].set[s].total;
    memory_free(rows->carrier);
    memory_free(rows->row);
    rows->count = count;
    rows->carrier = memory_allocate(count, sizeof *rows->carrier, "rows by particle");
    rows->row = memory_allocate_zero(count, rows->row_bytes, "rows by particle");
    for (size_t m = 0; m < messages; m++) {
        copy_rows((char *)rows->row + row * rows->row_bytes, rows->row_bytes, arrivals[m].set[s].rows,
                  sent_bytes(rows), arrivals[m].set[s].total);
        for (size_t k = 0; k < arrivals[m].count; k++, p++)
            for (uint64_t n = read_count(arrivals[m].set[s].counts, k); n > 0; n--)
                rows->carrier[row++] = (uint32_t)p;
    }
}

static void append_arrivals(struct particles *particles, const struct arrivals *arrivals, size_t messages) {
    size_t total = particles->owned;
    for (size_t m = 0; m < messages; m++)
        total += arrivals[m].count;
    if (total > (size_t)1 << PARTICLE_INDEX_BITS)
        error_fatal("%zu particles on one rank, at most %zu are possible: use more ranks", total,
                    (size_t)1 << PARTICLE_INDEX_BITS);
    const struct field_list fields = fields_with(particles, FIELD_MIGRATE);
    particles_reserve(particles, total);
    for (size_t m = 0; m < messages; m++) {
        size_t first = particles->owned;
        for (size_t k = 0; k < arrivals[m].count; k++)
            particles_append(particles);
        fields_unpack(particles, &fields, first, arrivals[m].count, arrivals[m].fields);
    }
}

/* The particle that comes to each place, of those that stay. */
static uint32_t *places_from(const struct migrate_places *places, size_t owned) {
    uint32_t *from = memory_allocate(places->stay, sizeof *from, "places of particles");
    for (size_t k = 0; k < owned; k++)
        if (places->place[k] != PARTICLE_LEFT)
            from[places->place[k]] = (uint32_t)k;
    return from;
}

static void settle(struct particles *particles, struct migrate_rows *rows, int sets,
                   const struct migrate_places *places, const struct exchange_inbox *inbox) {
    uint32_t *from = NULL;
    struct arrivals *arrivals = memory_allocate(inbox->count, sizeof *arrivals, "arrivals");
    for (size_t m = 0; m < inbox->count; m++)
        arrivals[m] = take_apart(&inbox->message[m], particles, rows, sets);
    for (int s = 0; s < sets; s++) {
        if (rows[s].carrier) {
            replace_rows(&rows[s], s, places->stay, arrivals, inbox->count);
            continue;
        }
        from = from ? from : places_from(places, particles->owned);
        join_rows(&rows[s], s, from, places->stay, arrivals, inbox->count);
    }
    particles_vacate(particles, places->place, places->stay);
    append_arrivals(particles, arrivals, inbox->count);
    memory_free(arrivals);
    memory_free(from);
}

/* As migrate_particles, which particles leave being known. */
static size_t migrate_known(struct exchange *exchange, const struct domain *domain,
                            struct particles *particles, const struct migrate_places *places,
                            struct migrate_rows *rows, int n) {
    struct leavers leavers;
    find_leavers(&leavers, exchange->comm, domain, particles, places);
    size_t peers = leavers.groups.count;
    struct exchange_message *out = memory_allocate(peers, sizeof *out, "messages");
    for (int s = 0; s < n; s++)
        if (rows[s].carrier)
            sort_carried(&rows[s]);
    for (size_t g = 0; g < peers; g++) {
        size_t first = leavers.groups.start[g], last = leavers.groups.start[g + 1];
        out[g].rank = leavers.groups.rank[g];
        pack_message(&out[g], particles, rows, n, leavers.particle + first, last - first);
    }
    struct exchange_inbox inbox;
    exchange_sparse(exchange, out, peers, &inbox);
    if (leavers.count > 0 || inbox.count > 0)
        settle(particles, rows, n, places, &inbox);
    for (size_t g = 0; g < peers; g++)
        memory_free(out[g].data);
    memory_free(out);
    exchange_inbox_free(&inbox);
    size_t sent = leavers.count;
    rank_groups_free(&leavers.groups);
    memory_free(leavers.particle);
    return sent;
}

size_t migrate_particles(struct exchange *exchange, const struct domain *domain, struct particles *particles,
                         const struct migrate_places *places, struct migrate_rows *rows, int n) {
    assert(particles->ghosts == 0 && n <= MIGRATE_SETS_MAX);
    if (exchange->comm->size == 1)
        return 0;
    if (places->place)
        return migrate_known(exchange, domain, particles, places, rows, n);
    uint32_t *place = memory_allocate(particles->owned, sizeof *place, "places of particles");
    struct migrate_places found = {place, migrate_places(exchange->comm, domain, particles, place)};
    size_t sent = migrate_known(exchange, domain, particles, &found, rows, n);
    memory_free(place);
    return sent;
}
