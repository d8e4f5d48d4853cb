/* SPDX-License-Identifier: BSD-3-Clause */
/* Parts of a trajectory in H5MD: frames, contacts, and going on in an old file. */
#ifndef SCREE_DATA_FORMATS_H5MD_PARTS_H
#define SCREE_DATA_FORMATS_H5MD_PARTS_H

#include "data/formats/contact_list.h"
#include "data/formats/frame.h"
#include "data/formats/h5md_file.h"

struct h5md;

/* A contact list in the H5MD file. */

/* Appends a contact list (the box is needed if the file does not exist yet). Collective. */
bool h5md_write_contacts(struct h5md *h5md, const struct contact_list *list, const struct box *box,
                         struct error *error);

/* A frame in the H5MD file. */

/* Appends a frame; does nothing if the file already holds that step. Collective. */
bool h5md_write_frame(struct h5md *h5md, const struct frame *frame, struct error *error);

/* Private part of the H5MD writer: continues an existing file. */

/* Fills `h5md` from an existing file, and cuts off data after a step. Collective. */
bool h5md_resume(struct h5md *h5md, int64_t step, struct error *error);

/* Checks that the file fits `varying`: a file made for a fixed set of particles holds their ids only once. */
bool h5md_check_varying(const struct h5md *h5md, const struct h5 *h5, struct error *error);

/* Only fills `h5md` from the existing file. */
bool h5md_recall(struct h5md *h5md, const struct h5 *h5, struct error *error);

#endif
