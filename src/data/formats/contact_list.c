/* SPDX-License-Identifier: BSD-3-Clause */
/* Collects the contacts of a rank into a list. Read contact_list.h first. */
#include "data/formats/contact_list.h"

#include "base/memory.h"

void contact_list_create(struct contact_list *list, const struct output_view *view) {
    *list = (struct contact_list){.step = view->step, .time = view->time};
    if (!view->contact)
        return;
    list->particle_count = force_loop_contacts(view->contact, &list->particle);
    if (view->walls)
        list->wall_count = walls_contacts(view->walls, view->contact, &list->wall);
}

void contact_list_free(struct contact_list *list) {
    memory_free(list->particle);
    memory_free(list->wall);
    *list = (struct contact_list){0};
}
