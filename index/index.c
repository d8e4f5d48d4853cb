/* SPDX-License-Identifier: BSD-3-Clause */
/* The wrappers: the only place that calls through the table of an index. */
#include "index/index.h"

#include "base/memory.h"
#include "base/timer.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

static bool view_plausible(const struct index_view *view) {
    return view->owned <= view->total && view->total <= (size_t)1 << INDEX_IMAGE_SHIFT && view->stride > 0 &&
           (view->dimension == 2 || view->dimension == 3) && view->classes >= 1 &&
           view->classes <= INDEX_CLASS_MAX && view->threads >= 1 &&
           (view->total == 0 || (view->position && view->radius && view->size_class));
}

struct index *index_create(const char *name, const struct index_params *params, struct error *error) {
    const struct index_ops *ops = index_registry_find(name);
    if (ops == NULL) {
        char known[INDEX_WHY_MAX] = "";
        for (int k = 0; k < index_registry_count(); k++) {
            size_t used = strlen(known);
            snprintf(known + used, sizeof known - used, "%s%s", k > 0 ? ", " : "",
                     index_registry_get(k)->name);
        }
        error_set(error, ERROR_USER, "unknown index \"%s\"; there are: %s", name, known);
        return NULL;
    }
    struct index *index = ops->create(params);
    index->ops = ops;
    index->params = *params;
    return index;
}

void index_destroy(struct index **index) {
    if (*index != NULL) {
        memory_free((*index)->described);
        (*index)->ops->destroy(*index);
    }
    *index = NULL;
}

bool index_applicable(const char *name, const struct index_params *params, const struct index_view *view,
                      char why[INDEX_WHY_MAX]) {
    const struct index_ops *ops = index_registry_find(name);
    if (ops == NULL) {
        snprintf(why, INDEX_WHY_MAX, "there is no index \"%s\"", name);
        return false;
    }
    if (view->total > (size_t)1 << INDEX_IMAGE_SHIFT) {
        snprintf(why, INDEX_WHY_MAX, "%zu particles on one rank, at most %zu are possible", view->total,
                 (size_t)1 << INDEX_IMAGE_SHIFT);
        return false;
    }
    return ops->applicable == NULL || ops->applicable(params, view, why);
}

bool index_stays(struct index *index, const struct index_view *view) {
    return index->ops->stays ? index->ops->stays(index, view) : index->ops->order == NULL;
}

void index_order(struct index *index, const struct index_view *view, uint32_t *order) {
    assert(view_plausible(view) && view->total == view->owned);
    if (index->ops->order == NULL) {
        for (size_t k = 0; k < view->owned; k++) {
            order[k] = (uint32_t)k;
        }
        return;
    }
    double start = timer_now();
    index->ops->order(index, view, order);
    index->order_seconds += timer_now() - start;
}

void index_build(struct index *index, const struct index_view *view) {
    assert(view_plausible(view));
    double start = timer_now();
    memory_free(index->described);
    index->described = NULL;
    index->ops->build(index, view);
    index->build_seconds += timer_now() - start;
    index->builds++;
}

/* Drops the pairs of one body among those from `first` on. */
static void bodies_drop(const struct index_view *view, size_t first, struct index_sink *sink) {
    const uint32_t partner = (1u << INDEX_IMAGE_SHIFT) - 1;
    size_t kept = first;
    for (size_t k = first; k < sink->count; k++) {
        int64_t body = view->body[sink->i[k]];
        if (body >= 0 && body == view->body[sink->j[k] & partner]) {
            continue;
        }
        sink->i[kept] = sink->i[k];
        sink->j[kept++] = sink->j[k];
    }
    sink->count = kept;
}

void index_visit(const struct index *index, const struct index_view *view, size_t first, size_t last,
                 struct index_sink *sink) {
    assert(index->builds > 0 && first <= last && last <= view->owned);
    size_t before = sink->count;
    index->ops->visit(index, view, first, last, sink);
    if (view->body && sink->count <= sink->capacity) {
        bodies_drop(view, before, sink);
    }
}

bool index_check(const struct index *index, const struct index_view *view, char why[INDEX_WHY_MAX]) {
    if (!view_plausible(view)) {
        snprintf(why, INDEX_WHY_MAX, "the view is inconsistent");
        return false;
    }
    return index->ops->check == NULL || index->ops->check(index, view, why);
}

void index_describe(const struct index *index, struct index_description *description) {
    memset(description, 0, sizeof *description);
    if (index->described != NULL) {
        *description = *index->described;
        return;
    }
    index->ops->describe(index, description);
}

void index_release(struct index *index) {
    if (index->ops->release == NULL || index->described != NULL) {
        return;
    }
    struct index_description *described = memory_allocate(1, sizeof *described, "description of an index");
    index_describe(index, described);
    index->ops->release(index);
    index->described = described;
}

size_t index_memory(const struct index *index) {
    return index->ops->memory(index);
}

int index_trials(const struct index *index) {
    return index->ops->trials != NULL ? index->ops->trials(index) : 0;
}

void index_select(struct index *index, int variant) {
    if (index->ops->select != NULL) {
        index->ops->select(index, variant);
    }
}
