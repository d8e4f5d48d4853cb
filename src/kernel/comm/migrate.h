/* SPDX-License-Identifier: BSD-3-Clause */
/* Particles change ranks, together with their rows. */
#ifndef SCREE_COMM_MIGRATE_H
#define SCREE_COMM_MIGRATE_H

#include "kernel/comm/domain.h"
#include "kernel/comm/exchange.h"
#include "kernel/particles/particles.h"

enum { MIGRATE_SETS_MAX = 16 };

/* Rows that travel with particles (contact history): owned particle k carries the rows start[k] ... start[k +
 * 1] - 1 of row_bytes bytes each. With `carrier` the set has only the rows of particles that leave, in any
 * order: row r travels with particle carrier[r]; afterwards the set has the rows of the arrivals, and their
 * numbers. All arrays come from memory_allocate and are replaced; rows have no padding and hold no local
 * numbers. */
struct migrate_rows {
    size_t *start; /* owned + 1 entries; NULL with `carrier` */
    void *row;
    size_t count, row_bytes;
    size_t sent;       /* the first bytes of a row that travel, the others become 0; 0: all */
    uint32_t *carrier; /* `count` entries; NULL with `start` */
};

/* The particles that leave, if the caller knows them. All zero: migrate_particles finds them. */
struct migrate_places {
    const uint32_t *place; /* of particles_places; borrowed */
    size_t stay;           /* the number of particles that do not leave */
};

/* The places for migration of the owned particles; returns how many stay. Opens its own thread team. */
size_t migrate_places(const struct comm *comm, const struct domain *domain, const struct particles *particles,
                      uint32_t *place);

/* Sends every owned particle to the rank that owns the particle's position; this may be any rank. Particles
 * that stay lie in the order of particles_places; arrivals follow by source rank, then in the order of the
 * source rank. The `n` row sets are brought into the same order. Returns how many particles this rank sent
 * away. Collective. */
size_t migrate_particles(struct exchange *exchange, const struct domain *domain, struct particles *particles,
                         const struct migrate_places *places, struct migrate_rows *rows, int n);

#endif
