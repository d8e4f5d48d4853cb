/* SPDX-License-Identifier: BSD-3-Clause */
/* Sends and receives the values of copies. Read values.h first. */
#include "engine/values.h"

void values_send(struct ghosts *ghosts, struct particles *particles) {
    struct field_list fields = fields_with(particles, FIELD_FORWARD);
    ghosts_step_begin(ghosts, particles, &fields);
}

void values_receive(struct ghosts *ghosts, struct particles *particles) {
    ghosts_forward_end(ghosts, particles);
    fields_clear_reverse(particles, particles->owned, particles->ghosts);
}
