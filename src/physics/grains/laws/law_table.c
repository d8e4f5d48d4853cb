/* SPDX-License-Identifier: BSD-3-Clause */
/* The rows of the table of contact laws (law_table.h), for code that does not need the rows at compile
 * time. */
#include "physics/grains/laws/law_table.h"
#include "physics/grains/laws/law_parts.h"

#define LAW_ROW(NAME, name, traits, summary) [LAW_##NAME] = {#name, traits, summary, &law_##name},
static const struct law_row law_rows[] = {LAW_TABLE(LAW_ROW)};

const struct law_row *law_row_get(enum law_normal normal) {
    return &law_rows[normal];
}

bool law_has_trait(enum law_normal normal, const char *trait) {
    const struct law_part_row row = {.with = trait};
    return law_part_combines(&row, law_rows[normal].traits);
}

enum law_normal law_linear(void) {
    int k = 0;
    while (!law_rows[k].form->linear)
        k++;
    return (enum law_normal)k;
}
