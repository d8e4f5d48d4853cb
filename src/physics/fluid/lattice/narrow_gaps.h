/* SPDX-License-Identifier: BSD-3-Clause */
/* Gaps between grains, and between grains and walls, that the spacing of a fluid does not resolve. A contact is a gap.
 * In a packing grains touch: such gaps are told, and a run goes on. They are not told where lubrication acts in them (lubrication.h). */
#ifndef SCREE_LATTICE_NARROW_GAPS_H
#define SCREE_LATTICE_NARROW_GAPS_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

struct nodes;
struct physics_context;

/* In a gap of fewer spacings the flow is not resolved. */
#define GAPS_NARROW 2.0

struct gaps {
    int64_t grains,
        walls;        /* gaps below GAPS_NARROW spacings: between two grains; between a grain and a wall */
    double narrowest; /* of all gaps, length; below 0 where they overlap; INFINITY without a gap */
    int64_t of[2];    /* its grains, or its grain and the number of its wall */
    bool at_wall;
};

/* Looks at the grains of all nodes (nodes_make), each pair at its nearest images; a mesh that is farther than
 * GAPS_NARROW spacings has no gap. The same on all ranks. */
struct gaps narrow_gaps_find(const struct nodes *nodes, const struct physics_context *context);

/* Tells the log of gaps that are too narrow, with the place of fluid.spacing in the scene. One rank. */
void narrow_gaps_note(const struct gaps *gaps, const struct physics_context *context);

/* Prints the line of gaps for `check`. One rank. */
void narrow_gaps_print(const struct gaps *gaps, const struct physics_context *context, FILE *file);

#endif
