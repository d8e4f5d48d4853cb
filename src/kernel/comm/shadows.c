/* SPDX-License-Identifier: BSD-3-Clause */
/* The rounds in which copies are registered and spread. Read shadows.h first. */
#include "kernel/comm/shadows.h"

#include "base/memory.h"
#include "base/hash.h"
#include "kernel/particles/fields.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* A message: n (8 bytes), n heads, the GHOST fields of n particles. */
struct head {
    int32_t owner;
    uint32_t number;
    uint8_t image; /* total image from the original */
    uint8_t step;  /* image from the sender's place to the receiver's */
    uint8_t how;   /* COPY_FAR, COPY_RELAY */
    uint8_t unused;
};
_Static_assert(sizeof(struct head) == 12, "heads have padding");

/* A copy to hand on. */
struct order {
    struct head head;
    const char *fields;
};

/* A shadow to be handed on: the copy received, and the sender. */
struct arrival {
    struct order order;
    int sender;
};

struct spread {
    const struct shadows_place *place;
    struct shadows *result;
    struct field_list fields; /* the GHOST ones */
    size_t each;              /* bytes of these fields of a particle */
    int own;
    struct order *order; /* copies to hand on in this round */
    int *to;
    size_t orders, order_room;
    struct arrival *fresh; /* shadows received in the last round */
    size_t fresh_count, fresh_room;
    struct head *seen; /* room for as many as the table */
    size_t seen_count;
    struct hash seen_by_key;
};

static bool same(const struct head *a, const struct head *b) {
    return a->owner == b->owner && a->number == b->number && a->image == b->image;
}

static uint64_t seen_key(const struct head *head) {
    return mix_word((uint64_t)(uint32_t)head->owner << 32 | head->number, head->image);
}

static void seen_grow(struct spread *spread) {
    hash_start(&spread->seen_by_key, spread->seen_count + 1, "shadows seen");
    spread->seen =
        memory_resize(spread->seen, spread->seen_by_key.room, sizeof *spread->seen, "shadows seen");
    for (size_t k = 0; k < spread->seen_count; k++)
        hash_put(&spread->seen_by_key, seen_key(&spread->seen[k]), (uint32_t)k);
}

/* Notes a shadow; false if the same shadow had come before. */
static bool seen_put(struct spread *spread, const struct head *head) {
    const struct hash *table = &spread->seen_by_key;
    if (spread->seen_count == table->room)
        seen_grow(spread);
    uint64_t key = seen_key(head);
    for (uint32_t k = hash_first(table, key); k != HASH_END; k = table->next[k])
        if (same(&spread->seen[k], head))
            return false;
    spread->seen[spread->seen_count] = *head;
    hash_put(&spread->seen_by_key, key, (uint32_t)spread->seen_count++);
    return true;
}

static void order_put(struct spread *spread, int to, const struct head *head, const char *fields) {
    if (spread->orders == spread->order_room) {
        spread->order_room = 2 * spread->order_room + 64;
        spread->order =
            memory_resize(spread->order, spread->order_room, sizeof *spread->order, "shadows to send");
        spread->to = memory_resize(spread->to, spread->order_room, sizeof *spread->to, "shadows to send");
    }
    spread->to[spread->orders] = to;
    spread->order[spread->orders++] = (struct order){*head, fields};
}

static void hold(struct shadows *shadows, const struct head *head, const char *fields) {
    if (shadows->count == shadows->room) {
        shadows->room = 2 * shadows->room + 256;
        shadows->shadow = memory_resize(shadows->shadow, shadows->room, sizeof *shadows->shadow, "copies");
    }
    shadows->shadow[shadows->count++] = (struct shadow){head->owner, head->number, head->image, fields};
}

/* Takes one copy received. */
static void take(struct spread *spread, const struct head *head, const char *fields, int sender) {
    if (head->image >= IMAGE_CODES || head->step >= IMAGE_CODES || head->owner < 0 ||
        head->owner >= spread->place->exchange->comm->size)
        error_fatal("copies: rank %d sent image code %d of a particle of rank %d", sender, head->image,
                    head->owner);
    if (!(head->how & COPY_FAR)) {
        hold(spread->result, head, fields);
        return;
    }
    if (!seen_put(spread, head))
        return;
    if (!(head->how & COPY_RELAY))
        hold(spread->result, head, fields);
    if (spread->fresh_count == spread->fresh_room) {
        spread->fresh_room = 2 * spread->fresh_room + 64;
        spread->fresh = memory_resize(spread->fresh, spread->fresh_room, sizeof *spread->fresh, "shadows");
    }
    spread->fresh[spread->fresh_count++] = (struct arrival){{*head, fields}, sender};
}

static void take_message(struct spread *spread, const struct exchange_message *message) {
    uint64_t n = 0;
    size_t each = sizeof(struct head) + spread->each;
    if (message->bytes >= sizeof n)
        memcpy(&n, message->data, sizeof n);
    if (message->bytes < sizeof n || (message->bytes - sizeof n) / each != n ||
        (message->bytes - sizeof n) % each != 0)
        error_fatal("copies: the message from rank %d has %zu bytes, which is not the length of %llu copies",
                    message->rank, message->bytes, (unsigned long long)n);
    const char *heads = message->data + sizeof n, *fields = heads + n * sizeof(struct head);
    for (size_t k = 0; k < n; k++) {
        struct head head;
        memcpy(&head, heads + k * sizeof head, sizeof head);
        take(spread, &head, fields + k * spread->each, message->rank);
    }
}

static struct exchange_inbox *inbox_next(struct shadows *shadows) {
    shadows->inbox =
        memory_resize(shadows->inbox, (size_t)shadows->inboxes + 1, sizeof *shadows->inbox, "messages");
    return &shadows->inbox[shadows->inboxes++];
}

/* Delivers messages and takes the copies received. Returns true if any rank wants another round. */
static bool deliver(struct spread *spread, struct exchange_message *out, size_t n, bool more) {
    struct shadows *result = spread->result;
    struct exchange_inbox *inbox = inbox_next(result);
    int flag = more;
    exchange_sparse_max(spread->place->exchange, out, n, inbox, &flag);
    for (size_t m = 0; m < n; m++)
        memory_free(out[m].data);
    memory_free(out);
    spread->fresh_count = 0;
    for (size_t m = 0; m < inbox->count; m++)
        take_message(spread, &inbox->message[m]);
    result->rounds++;
    return flag > 0;
}

static char *message_begin(struct exchange_message *message, const struct spread *spread, int rank,
                           uint64_t n) {
    message->rank = rank;
    message->bytes = sizeof n + n * (sizeof(struct head) + spread->each);
    message->data = memory_allocate(message->bytes, 1, "copies to send");
    memcpy(message->data, &n, sizeof n);
    return message->data + sizeof n;
}

/* Round 1: the owner sends copies to the places next to its subdomain. */
static bool round_of_owners(struct spread *spread, const struct copies *copies) {
    const struct groups *groups = &copies->groups;
    struct exchange_message *out = memory_allocate(groups->count, sizeof *out, "messages");
    for (size_t g = 0; g < groups->count; g++) {
        size_t first = groups->start[g], n = groups->start[g + 1] - first;
        char *heads = message_begin(&out[g], spread, groups->rank[g], n);
        for (size_t k = first; k < first + n; k++) {
            struct head head = {.owner = spread->own,
                                .number = copies->particle[k],
                                .image = copies->image[k],
                                .step = copies->image[k],
                                .how = copies->how[k]};
            memcpy(heads + (k - first) * sizeof head, &head, sizeof head);
        }
        copies_pack(spread->place->particles, &spread->fields, copies->particle + first, n,
                    heads + n * sizeof(struct head));
    }
    return deliver(spread, out, groups->count, copies->far);
}

/* Number of the place from which `step` led to this rank; `count` if no place fits. */
static size_t place_of_sender(const struct domain *domain, int rank, unsigned step) {
    int way[3];
    bool wrapped[3];
    size_t count;
    const struct domain_place *places = domain_neighbours(domain, &count);
    domain_wrap(domain, wrapped);
    image_vector(step, way);
    for (size_t p = 0; p < count; p++) {
        bool fits = places[p].rank == rank;
        for (int d = 0; d < 3; d++) /* in a wrapped direction the image is the ball's, not the place's */
            fits = fits && (wrapped[d] || places[p].image[d] == -way[d]);
        if (fits)
            return p;
    }
    return count;
}

static bool places_meet(const struct domain_place *a, const struct domain_place *b) {
    for (int d = 0; d < 3; d++)
        if (a->seen_lower[d] > b->seen_upper[d] || b->seen_lower[d] > a->seen_upper[d])
            return false;
    return true;
}

/* Orders a copy for a place that needs one of a shadow that this rank holds or passes on; `ball` is the
 * shadow's particle. */
static void hand_on(struct spread *spread, const struct arrival *arrival, const struct domain_place *to,
                    const struct copy_ball *ball) {
    int image[3];
    struct head head = arrival->order.head;
    image_vector(head.image, image);
    for (int d = 0; d < 3; d++)
        image[d] += to->image[d];
    domain_settle_image(spread->place->domain, ball->x, image);
    for (int d = 0; d < 3; d++)
        if (abs(image[d]) > 1)
            return;
    head.image = (uint8_t)image_code(image[0], image[1], image[2]);
    head.step = (uint8_t)image_code(to->image[0], to->image[1], to->image[2]);
    if (to->rank == head.owner && head.image == 0)
        return;
    double distance2 = domain_place_distance2(spread->place->domain, to, ball->x, image);
    if (distance2 > ball->relay * ball->relay)
        return;
    head.how = distance2 <= ball->radius * ball->radius ? COPY_FAR : COPY_FAR | COPY_RELAY;
    order_put(spread, to->rank, &head, arrival->order.fields);
}

static void spread_arrival(struct spread *spread, const struct arrival *arrival) {
    struct particles *particles = spread->place->particles;
    size_t count, slot = particles->owned;
    const struct domain_place *places = domain_neighbours(spread->place->domain, &count);
    fields_unpack(particles, &spread->fields, slot, 1, arrival->order.fields);
    struct copy_ball ball;
    const double *own = copies_own_reach(particles);
    copies_ball(&ball, &particles->state[slot], spread->place->reach[particles->size_class[slot]],
                own ? own[slot] : 0, spread->place->box);
    size_t sender = place_of_sender(spread->place->domain, arrival->sender, arrival->order.head.step);
    for (size_t p = 0; p < count; p++)
        if (p != sender && (sender == count || !places_meet(&places[p], &places[sender])))
            hand_on(spread, arrival, &places[p], &ball);
}

/* A later round: shadows are handed on. Returns true if any rank handed on a shadow. */
static bool round_of_holders(struct spread *spread) {
    spread->orders = 0;
    particles_reserve(spread->place->particles, spread->place->particles->owned + 1);
    for (size_t k = 0; k < spread->fresh_count; k++)
        spread_arrival(spread, &spread->fresh[k]);
    struct groups groups;
    rank_groups_make(&groups, spread->to, spread->orders, spread->place->exchange->comm->size);
    struct exchange_message *out = memory_allocate(groups.count, sizeof *out, "messages");
    for (size_t g = 0; g < groups.count; g++) {
        size_t n = groups.start[g + 1] - groups.start[g];
        char *heads = message_begin(&out[g], spread, groups.rank[g], n),
             *fields = heads + n * sizeof(struct head);
        for (size_t k = 0; k < n; k++) {
            const struct order *order = &spread->order[groups.item[groups.start[g] + k]];
            memcpy(heads + k * sizeof(struct head), &order->head, sizeof(struct head));
            memcpy(fields + k * spread->each, order->fields, spread->each);
        }
    }
    bool more = deliver(spread, out, groups.count, spread->orders > 0);
    rank_groups_free(&groups);
    return more;
}

/* The number of one of this rank's particles, registered by a holder. */
static uint32_t registered(const struct exchange_message *message, size_t k, size_t owned) {
    uint32_t number;
    memcpy(&number, message->data + k * sizeof number, sizeof number);
    if (number >= owned)
        error_fatal("copies: rank %d registers a copy of particle number %u, but %zu are here", message->rank,
                    number, owned);
    return number;
}

/* Makes the list of shadows that other ranks hold: first the copies of round 1, then the shadows of later
 * rounds, as registered by their holders. */
static void keep(struct shadows *result, const struct copies *copies, const struct exchange_inbox *inbox,
                 const struct shadows_place *place) {
    size_t total = copies->groups.start[copies->groups.count], n = 0;
    for (size_t m = 0; m < inbox->count; m++) {
        if (inbox->message[m].bytes % sizeof(uint32_t) != 0)
            error_fatal("copies: the message from rank %d has %zu bytes, which is not the length of numbers",
                        inbox->message[m].rank, inbox->message[m].bytes);
        total += inbox->message[m].bytes / sizeof(uint32_t);
    }
    int *rank = memory_allocate(total, sizeof *rank, "copies held elsewhere");
    result->original = memory_allocate(total, sizeof *result->original, "copies held elsewhere");
    for (size_t g = 0; g < copies->groups.count; g++)
        for (size_t k = copies->groups.start[g]; k < copies->groups.start[g + 1]; k++) {
            if (copies->how[k] & COPY_RELAY)
                continue;
            rank[n] = copies->groups.rank[g];
            result->original[n++] = copies->particle[k];
        }
    for (size_t m = 0; m < inbox->count; m++)
        for (size_t k = 0; k < inbox->message[m].bytes / sizeof(uint32_t); k++) {
            rank[n] = inbox->message[m].rank;
            result->original[n++] = registered(&inbox->message[m], k, place->particles->owned);
        }
    rank_groups_make(&result->kept, rank, n, place->exchange->comm->size);
    memory_free(rank);
}

/* Holders tell the owners which shadows the holders got from round 2 on: shadow[first] and all behind. */
static void register_shadows(struct spread *spread, size_t first, struct exchange_inbox *inbox) {
    const struct shadows *result = spread->result;
    size_t n = result->count - first;
    int *owner = memory_allocate(n, sizeof *owner, "owners");
    uint32_t *number = memory_allocate(n, sizeof *number, "shadows to register");
    for (size_t k = 0; k < n; k++)
        owner[k] = result->shadow[first + k].owner;
    struct groups groups;
    rank_groups_make(&groups, owner, n, spread->place->exchange->comm->size);
    for (size_t k = 0; k < n; k++)
        number[k] = result->shadow[first + groups.item[k]].number;
    struct exchange_message *out = memory_allocate(groups.count, sizeof *out, "messages");
    for (size_t g = 0; g < groups.count; g++)
        out[g] = (struct exchange_message){groups.rank[g],
                                           (groups.start[g + 1] - groups.start[g]) * sizeof *number,
                                           (char *)(number + groups.start[g])};
    exchange_sparse(spread->place->exchange, out, groups.count, inbox);
    memory_free(out);
    memory_free(number);
    memory_free(owner);
    rank_groups_free(&groups);
}

void shadows_spread(struct shadows *shadows, const struct shadows_place *place, const struct copies *copies) {
    int size = place->exchange->comm->size;
    *shadows = (struct shadows){0};
    struct spread spread = {.place = place, .result = shadows, .own = place->exchange->comm->rank};
    struct exchange_inbox numbers = {0};
    spread.fields = fields_with(place->particles, FIELD_GHOST);
    spread.each = fields_packed_bytes(place->particles, &spread.fields);
    bool more = round_of_owners(&spread, copies);
    size_t first = shadows->count;
    if (more) {
        while (round_of_holders(&spread))
            continue;
        register_shadows(&spread, first, &numbers);
    }
    keep(shadows, copies, &numbers, place);
    int *owner = memory_allocate(shadows->count, sizeof *owner, "owners");
    for (size_t k = 0; k < shadows->count; k++)
        owner[k] = shadows->shadow[k].owner;
    rank_groups_make(&shadows->held, owner, shadows->count, size);
    memory_free(owner);
    exchange_inbox_free(&numbers);
    memory_free(spread.order);
    memory_free(spread.to);
    memory_free(spread.fresh);
    memory_free(spread.seen);
    hash_free(&spread.seen_by_key);
}

void shadows_free(struct shadows *shadows) {
    rank_groups_free(&shadows->held);
    rank_groups_free(&shadows->kept);
    memory_free(shadows->shadow);
    memory_free(shadows->original);
    for (int k = 0; k < shadows->inboxes; k++)
        exchange_inbox_free(&shadows->inbox[k]);
    memory_free(shadows->inbox);
    *shadows = (struct shadows){0};
}
