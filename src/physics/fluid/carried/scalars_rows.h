/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows of the schema: the scalars of a fluid, and names that other sections of a fluid share. */
#ifndef SCREE_CARRIED_SCALARS_ROWS_H
#define SCREE_CARRIED_SCALARS_ROWS_H

#include "data/scene/schema_rows.h"

extern const struct schema_table scalars_table;

/* The sides of the box. */
extern const struct schema_name scalars_sides[];

#endif
