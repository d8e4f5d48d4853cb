/* SPDX-License-Identifier: BSD-3-Clause */
/* Rows of the schema: the electrolyte of a fluid. */
#ifndef SCREE_CARRIED_ELECTROLYTE_ROWS_H
#define SCREE_CARRIED_ELECTROLYTE_ROWS_H

#include "data/scene/schema_rows.h"

extern const struct schema_table electrolyte_table;

#endif
