/* SPDX-License-Identifier: BSD-3-Clause */
/* A contact list in the H5MD file. */
#ifndef SCREE_FORMATS_H5MD_CONTACTS_H
#define SCREE_FORMATS_H5MD_CONTACTS_H

#include "data/formats/contact_list.h"

struct h5md;

/* Appends a contact list (the box is needed if the file does not exist yet). Collective. */
bool h5md_write_contacts(struct h5md *h5md, const struct contact_list *list, const struct box *box,
                         struct error *error);

#endif
