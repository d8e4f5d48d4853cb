/* SPDX-License-Identifier: BSD-3-Clause */
/* The operations of the index contract (index.h) for a set of grids. Read levels_index.h first. */
#include "index/levels/levels_index.h"

#include "base/memory.h"
#include "index/levels/levels_plan.h"

struct levels_index {
    struct index base;
    struct levels levels;
    levels_planner *planner;
};

static struct levels_index *own(struct index *self) {
    return (struct levels_index *)self;
}

static const struct levels_index *own_const(const struct index *self) {
    return (const struct levels_index *)self;
}

static struct levels_plan make_plan(const struct levels_index *index, const struct index_view *view) {
    struct levels_plan plan = {0};
    for (int g = 0; g < INDEX_CLASS_MAX; g++) {
        plan.fixed[g] = index->base.params.cell_factor > 0;
    }
    index->planner(&index->base.params, view, &plan);
    levels_plan_apart(&plan, view);
    return plan;
}

struct index *levels_index_create(const struct index_params *params, levels_planner *planner) {
    struct levels_index *index = memory_allocate_zero(1, sizeof *index, "index");
    levels_start(&index->levels, params);
    index->planner = planner;
    return &index->base;
}

void levels_index_destroy(struct index *self) {
    levels_free(&own(self)->levels);
    memory_free(self);
}

bool levels_index_stays(struct index *self, const struct index_view *view) {
    struct levels_plan plan = make_plan(own(self), view);
    return levels_stays(&own(self)->levels, &plan, view);
}

void levels_index_order(struct index *self, const struct index_view *view, uint32_t *order) {
    struct levels_plan plan = make_plan(own(self), view);
    levels_order(&own(self)->levels, &plan, view, order);
}

void levels_index_build(struct index *self, const struct index_view *view) {
    struct levels_plan plan = make_plan(own(self), view);
    levels_build(&own(self)->levels, &plan, view);
}

void levels_index_visit(const struct index *self, const struct index_view *view, size_t first, size_t last,
                        struct index_sink *sink) {
    levels_visit(&own_const(self)->levels, view, first, last, sink);
}

bool levels_index_check(const struct index *self, const struct index_view *view, char why[INDEX_WHY_MAX]) {
    return levels_check(&own_const(self)->levels, view, why);
}

void levels_index_describe(const struct index *self, struct index_description *description) {
    levels_describe(&own_const(self)->levels, description);
}

size_t levels_index_memory(const struct index *self) {
    return sizeof(struct levels_index) + levels_memory(&own_const(self)->levels);
}

void levels_index_release(struct index *self) {
    levels_release(&own(self)->levels);
}

double levels_index_factor(const struct index_params *params, double fallback) {
    return params->cell_factor > 0 ? params->cell_factor : fallback;
}
