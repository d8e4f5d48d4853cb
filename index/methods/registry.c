/* SPDX-License-Identifier: BSD-3-Clause */
/* The one table of indexes. */
#include "index/index.h"

#include <string.h>

extern const struct index_ops brute_ops, linkcell_ops, multi_ops, bytype_ops, hgrid_ops, auto_ops;

static const struct index_ops *const registry[] = {&brute_ops,  &linkcell_ops, &multi_ops,
                                                   &bytype_ops, &hgrid_ops,    &auto_ops};

int index_registry_count(void) {
    return (int)(sizeof registry / sizeof registry[0]);
}

const struct index_ops *index_registry_get(int k) {
    return registry[k];
}

const struct index_ops *index_registry_find(const char *name) {
    for (int k = 0; k < index_registry_count(); k++) {
        if (strcmp(registry[k]->name, name) == 0) {
            return registry[k];
        }
    }
    return NULL;
}
