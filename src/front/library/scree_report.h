/* SPDX-License-Identifier: BSD-3-Clause */
/* The report of a simulation of the library. */
#ifndef SCREE_LIBRARY_SCREE_REPORT_H
#define SCREE_LIBRARY_SCREE_REPORT_H

#include "front/library/scree_parts.h"

/* Begins the record of steps for the report, after the simulation, or that of a stage, is made; this began at `began`. */
void scree_report_begin(struct scree_simulation *simulation, double began);

#endif
