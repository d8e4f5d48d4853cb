/* SPDX-License-Identifier: BSD-3-Clause */
/* Names of datasets, and the list of the numbers that every checkpoint has. Read checkpoint_names.h first. */
#include "data/formats/checkpoint_names.h"
#include "kernel/particles/spin.h"
#include "physics_table.h"

#include <stdio.h>

const char *const checkpoint_name_datasets[RESTART_KINDS] = {
    [RESTART_INTEGER] = "/run/integer_names",
    [RESTART_REAL] = "/run/real_names",
    [RESTART_SUM] = "/run/sum_names",
};
const char *const checkpoint_value_datasets[RESTART_KINDS] = {
    [RESTART_INTEGER] = "/run/integers",
    [RESTART_REAL] = "/run/reals",
    [RESTART_SUM] = "/run/sums",
};

#define CHECKPOINT_PHYSICS(name, key, whose, summary) #name,
const char *const checkpoint_physics_names[] = {PHYSICS_TABLE(CHECKPOINT_PHYSICS)};
#undef CHECKPOINT_PHYSICS

void checkpoint_rows_names(const char *group, char name[CHECKPOINT_ROWS_NAMES][OUTPUT_NAME_MAX]) {
    snprintf(name[CHECKPOINT_ROWS_COUNT], OUTPUT_NAME_MAX, "/%s/count", group);
    snprintf(name[CHECKPOINT_ROWS_PARTNER], OUTPUT_NAME_MAX, "/%s/partner", group);
    snprintf(name[CHECKPOINT_ROWS_VALUE], OUTPUT_NAME_MAX, "/%s/value_separation", group);
}

void checkpoint_core_list(struct checkpoint_core *core, struct restart *restart) {
    static const char axis[] = "xyz";
    restart_add(restart, RESTART_INTEGER, false, &core->step, "step");
    restart_add(restart, RESTART_INTEGER, false, &core->seed, "seed");
    restart_add(restart, RESTART_INTEGER, false, &core->next_id, "next id");
    restart_add(restart, RESTART_INTEGER, false, &core->ranks, "ranks");
    restart_add(restart, RESTART_INTEGER, false, &core->history_components, "history components");
    restart_add(restart, RESTART_INTEGER, false, &core->particles, "particles");
    for (int d = 0; d < 3; d++)
        restart_add(restart, RESTART_INTEGER, false, &core->grid[d], "ranks along %c", axis[d]);
    restart_add(restart, RESTART_REAL, false, &core->time, "time");
    restart_add(restart, RESTART_REAL, false, &core->dt, "time step");
}

void checkpoint_field_name(const struct field *field, char name[OUTPUT_NAME_MAX]) {
    snprintf(name, OUTPUT_NAME_MAX, "/particles/%s", field->name);
}

size_t checkpoint_full_width(const struct particles *particles) {
    return spin_of(particles) ? 6 : 3;
}

size_t checkpoint_type_bytes(enum field_type type) {
    return type == FIELD_UINT8 ? 1 : type == FIELD_INT32 ? 4 : 8;
}
