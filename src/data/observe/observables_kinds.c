/* SPDX-License-Identifier: BSD-3-Clause */
/* The table of all kinds of observables: those of the files beside this one, then those of each physics. */
#include "data/observe/observables_kinds.h"
#include "physics_table.h"
#include <math.h>

#define OBSERVABLES_OF(name, key, whose, summary) &name##_observables,
static const struct observable_table *const of_physics[] = {PHYSICS_TABLE(OBSERVABLES_OF)};
#undef OBSERVABLES_OF

/* The files that define rows, in the order of docs/output.md. */
static const struct {
    int (*count)(void);
    const struct observable_kind *(*row)(int k);
} files[] = {{observables_bulk_count, observables_bulk},
             {observables_state_count, observables_state},
             {observables_flow_count, observables_flow},
             {observables_single_count, observables_single},
             {observables_expression_count, observables_expression}};

int observables_kinds_count(void) {
    int count = 0;
    for (size_t f = 0; f < sizeof files / sizeof files[0]; f++)
        count += files[f].count();
    for (int p = 0; p < PHYSICS_COUNT; p++)
        count += of_physics[p]->count;
    return count;
}

const struct observable_kind *observables_kind(int k) {
    int p = 0;
    for (size_t f = 0; f < sizeof files / sizeof files[0]; f++) {
        if (k < files[f].count())
            return files[f].row(k);
        k -= files[f].count();
    }
    for (; k >= of_physics[p]->count; p++)
        k -= of_physics[p]->count;
    return &of_physics[p]->rows[k];
}

int observables_count(void) {
    return observables_kinds_count();
}

const struct observable_info *observables_get(int k) {
    return &observables_kind(k)->info;
}

double observables_solid_radius(const struct output_view *view, size_t i) {
    const struct carried *carried = view->motion->carried;
    const double *solid = carried ? carried->solid : NULL, own = view->particles->state[i].radius;
    return solid && solid[i] > 0 ? solid[i] : own;
}

double observables_solid(const struct output_view *view, size_t i) {
    const double own = view->particles->state[i].radius;
    const double r = observables_solid_radius(view, i);
    return view->box->dimension == 2 ? M_PI * own * own : 4 * M_PI / 3 * r * r * r;
}
