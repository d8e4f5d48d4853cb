/* SPDX-License-Identifier: BSD-3-Clause */
/* The contacts of a moment, between particles and with walls, for files and statistics (force chains). */
#ifndef SCREE_FORMATS_CONTACT_LIST_H
#define SCREE_FORMATS_CONTACT_LIST_H

#include "data/formats/output.h"

struct contact_list {
    uint64_t step;
    double time;
    size_t particle_count, wall_count; /* of this rank */
    struct force_contact *particle;    /* both ids of particles; each contact on one rank only */
    struct force_contact *wall;        /* id_j = -(wall + 1) */
};

/* Evaluates the contacts of this rank, without communication. contact_list_free releases. */
void contact_list_create(struct contact_list *list, const struct output_view *view);
void contact_list_free(struct contact_list *list);

#endif
