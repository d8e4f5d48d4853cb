/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows of the schema: the electrolyte of a fluid. */
#ifndef SCREE_FLUID_ELECTROLYTE_ROWS_H
#define SCREE_FLUID_ELECTROLYTE_ROWS_H

#include "scene/schema_rows.h"

extern const struct schema_table electrolyte_table;

#endif
