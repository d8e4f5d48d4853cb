/* SPDX-License-Identifier: BSD-3-Clause */
/* Migration, and copies of particles that other ranks need (ghosts): made at a rebuild, valid until the next;
 * between rebuilds only values travel, along a plan that was made once. Neighbours form a graph; a rank may
 * have more or fewer than 26.
 *
 * The order of a rebuild: (ghosts_let_stay), ghosts_drop, particles_wrap, ghosts_migrate, (classify, reorder), ghosts_make. A
 * copy stands at x + image * edge, next to the receiver's subdomain. A rank may hold several copies of one
 * particle, and in a periodic direction divided among ranks also copies of the rank's own particles. In
 * wrapped directions (domain_wrap) there are no copies: the index wraps these directions. In a sheared box
 * copies across the gradient follow from the offset of the moment, so their ranks change from rebuild to
 * rebuild; such copies stand at their originals in the step (`in_place`), as their shift changes. */
#ifndef SCREE_KERNEL_COMM_GHOSTS_H
#define SCREE_KERNEL_COMM_GHOSTS_H

#include "kernel/comm/domain.h"
#include "kernel/comm/migrate.h"
#include "kernel/pairs/history.h"
#include "kernel/particles/fields.h"

struct ghosts_part;

/* The way that copies reach other ranks (shadows.h). In steps both ways are the same: one message a peer,
 * from the owner to all holders, and one back with newton on. AUTO spreads copies from neighbour to neighbour
 * if needed, and costs nothing if not. */
enum ghosts_sync { GHOSTS_AUTO, GHOSTS_NEIGHBOURS, GHOSTS_SHADOW };

struct ghosts_options {
    bool newton;
    bool reduced;  /* small particles are sent only as far as their small partners need; requires newton */
    bool in_place; /* after the search for pairs, copies stand at their originals: ghosts_unshift */
    enum ghosts_sync sync;
};

struct ghosts; /* the plan */

/* Makes an empty plan; borrows comm, domain and box until destroyed. Reduced ghosts with newton off are a
 * programmer's mistake here: the scene refuses this combination. Collective. */
struct ghosts *ghosts_create(const struct comm *comm, const struct domain *domain, const struct box *box,
                             const struct ghosts_options *options);
void ghosts_destroy(struct ghosts **ghosts);

/* Sends every owned particle (wrapped before) to the rank that owns the particle's position, with its history
 * rows. ghosts == 0 before and after. `rows` may be NULL without history. Fields that do not migrate are 0 in
 * arriving particles: particles_classify sets the size classes afterwards. Collective. */
void ghosts_migrate(struct ghosts *ghosts, struct particles *particles, struct history_rows *rows);

/* As ghosts_migrate, with any `n` sets of rows (at most MIGRATE_SETS_MAX), whose arrays are replaced, and with
 * the places of the particles if the caller knows them (places all zero: not). */
void ghosts_migrate_rows(struct ghosts *ghosts, struct particles *particles,
                         const struct migrate_places *places, struct migrate_rows *rows, int n);

/* Asks whether the particles, not wrapped yet in the divided directions, may stay on their ranks: true on all ranks if all
 * want it and no particle lies farther outside of its subdomain than copies may make up for. Copies then reach
 * farther by the largest such distance, until the next question. Collective. */
bool ghosts_let_stay(struct ghosts *ghosts, const struct particles *particles,
                     const struct size_classes *classes, bool wanted);

/* Bounds of the places where the copies of this rank will be; infinite at ends where the subdomain has no bound. */
void ghosts_around(const struct ghosts *ghosts, const struct size_classes *classes, double low[3],
                   double high[3]);

/* Makes the copies: rank q gets p iff dist(x_p + image, subdomain of q) <= r_p + max over the classes c whose
 * pair with p q computes of (radius_max(c) + margin); see copies.h. Sets the GHOST fields, and the REVERSE
 * ones to 0. Copies lie behind the owned particles, by source rank, then in the order of the source rank.
 * Particles must have been classified and migrated to their owners (ghosts_migrate), or stay (ghosts_let_stay).
 * Collective. */
void ghosts_make(struct ghosts *ghosts, struct particles *particles, const struct size_classes *classes);

/* False, with a user's error, if the sync is next-neighbour and a particle of this rank reached beyond the
 * neighbours of its subdomain. The copies are correct nevertheless. Errors may differ between ranks. */
bool ghosts_fit(const struct ghosts *ghosts, struct error *error);

/* Drops all copies. Not collective. */
void ghosts_drop(struct ghosts *ghosts, struct particles *particles);

/* Sends fields of the originals to their copies, each step those of fields_with(particles, FIELD_FORWARD).
 * begin packs and posts, end waits and unpacks; between them the copies keep their old values and originals
 * may change. The list is the same on all ranks and not empty. Collective (neighbours). */
void ghosts_forward_begin(struct ghosts *ghosts, struct particles *particles,
                          const struct field_list *fields);
void ghosts_forward_end(struct ghosts *ghosts, struct particles *particles);

/* Tells the owners which copies pairs use: used[k] is not 0 for copy number k (of particles.owned + k) of this rank.
 * Until the next ghosts_make the exchanges of a step carry the values of these copies alone. Not called: those of
 * all. Collective (neighbours). */
void ghosts_use(struct ghosts *ghosts, struct particles *particles, const uint8_t *used);

/* As ghosts_forward_begin and ghosts_reverse, for the copies that pairs use; the other copies keep their old values
 * and send nothing. ghosts_forward_end ends the exchange. */
void ghosts_step_begin(struct ghosts *ghosts, struct particles *particles, const struct field_list *fields);
void ghosts_step_reverse(struct ghosts *ghosts, struct particles *particles, const struct field_list *fields);

/* The owned particles whose values travel in a step, in the order of the messages, some several times. Borrowed until
 * the next ghosts_make, ghosts_use or ghosts_drop. */
const uint32_t *ghosts_step_originals(const struct ghosts *ghosts, size_t *count);

/* Newton on: sends fields of doubles of the copies back and adds them to the originals, each step those of
 * fields_with(particles, FIELD_REVERSE), in a fixed order: by the rank that held the copy, then in the order
 * of the copies on that rank. Newton off: does nothing. The copies keep their values. Collective
 * (neighbours). */
void ghosts_reverse(struct ghosts *ghosts, struct particles *particles, const struct field_list *fields);

/* The same, whatever newton is: for sums that are not over pairs of the list. */
void ghosts_sum(struct ghosts *ghosts, struct particles *particles, const struct field_list *fields);

/* The owned particles that have copies on any rank, increasing, each once. Borrowed until the next ghosts_make or ghosts_drop. */
const uint32_t *ghosts_originals(const struct ghosts *ghosts, size_t *count);

/* The copies that this rank holds of its own particles, if the rank is its own neighbour across the box.
 * These copies lie together; `first` is the number of the first one (particles.owned + ...). Returns the
 * numbers of their originals, in the order of the copies; NULL without such copies. Borrowed until the next
 * ghosts_make or ghosts_drop. */
const uint32_t *ghosts_own(const struct ghosts *ghosts, size_t *first, size_t *count);

/* With options.in_place, after the search for pairs: puts all copies at the positions of their originals, to
 * the last bit (x + image * edge has lost some bits). ghosts_forward then keeps the copies at these
 * positions. Returns the image code of each copy, which their pairs must take over (pairlist_add_images);
 * borrowed until the next ghosts_make or ghosts_drop. Not collective. */
const uint8_t *ghosts_unshift(struct ghosts *ghosts, struct particles *particles);

/* The image code under which copy number k (of particles.owned + k) stands. */
unsigned ghosts_image(const struct ghosts *ghosts, size_t k);

/* Counters of the communication of this rank. */
struct ghosts_counts {
    uint64_t ghosts; /* copies held now */
    uint64_t ghosts_class[CLASS_MAX];
    uint64_t bytes_class[CLASS_MAX];          /* of copies received, and sent back, since the start */
    double clearance;                         /* see domain.h */
    double reach;                             /* the largest reach beyond the neighbours so far; 0: none */
    uint64_t neighbours;                      /* other ranks talked to now */
    uint64_t messages, bytes;                 /* sent to other ranks since the start, all kinds */
    uint64_t rebuild_messages, rebuild_bytes; /* of messages and bytes: at rebuilds */
    uint64_t migrated;                        /* particles sent away since the start */
    int rounds; /* largest number of rounds to make copies: 1 if every particle reached neighbours only */
};
void ghosts_count(const struct ghosts *ghosts, struct ghosts_counts *counts);

/* True if the plan fits the particles: the number of copies and the order of the peers are right, the
 * originals are owned, and no copy of this rank's own particles stands at the position of its original. Else
 * `why` gets one line. Not collective. For tests. */
bool ghosts_valid(const struct ghosts *ghosts, const struct particles *particles, char *why, size_t why_size);

/* Messages about some of the copies alone: numbers that their owner keeps in an array of its own travel between
 * originals and copies, without the other particles. A part is made after ghosts_make and is valid until the next
 * ghosts_make or ghosts_drop. */

/* The part of the particles k with row[k] >= 0, owned ones and copies; the number is the row of the particle in
 * the arrays below. Ranks must agree: a copy is in the part if and only if its original is. Not collective. */
struct ghosts_part *ghosts_part_create(struct ghosts *ghosts, const int32_t *row);
void ghosts_part_destroy(struct ghosts_part **part);

/* Sends the rows of originals (`width` doubles each) to the rows of their copies, as they are: nothing is shifted
 * by images. Collective (neighbours). */
void ghosts_part_forward(struct ghosts_part *part, double *value, int width);

/* Adds the rows of copies to the rows of their originals, by the rank that held the copy, then in the order of the
 * copies there. Copies keep their rows. Collective (neighbours). */
void ghosts_part_sum(struct ghosts_part *part, double *value, int width);

#endif
