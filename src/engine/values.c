/* SPDX-License-Identifier: BSD-3-Clause */
/* Sends and receives the values of copies. Read values.h first. */
#include "engine/values.h"
#include "engine/state.h"

void values_send(struct simulation *s) {
    struct field_list fields = fields_with(s->particles, FIELD_FORWARD);
    ghosts_step_begin(s->ranks.ghosts, s->particles, &fields);
}

void values_receive(struct simulation *s) {
    ghosts_forward_end(s->ranks.ghosts, s->particles);
    fields_clear_reverse(s->particles, s->particles->owned, s->particles->ghosts);
}
