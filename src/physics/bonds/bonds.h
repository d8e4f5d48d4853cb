/* SPDX-License-Identifier: BSD-3-Clause */
/* Parallel bonds between grains (bond.h): made once, at the start of a run or at a given time, between grains whose
 * surfaces are near or that a list names; then each lasts until it breaks, over any gap.
 *
 * A bond is a row (struct history_row) at each of its two particles. The engine carries the rows with their
 * particles (engine/physics.h). Both ends compute the same numbers from the same state, so nothing is sent: the
 * partner is found by its id among the particles and copies of the rank, which a reach of its own (kernel/comm/copies.h)
 * brings there, however far the bond has stretched. The index searches no further than contacts need; only until
 * the bonds are made, the interaction has the range `gap`. */
#ifndef SCREE_BONDS_BONDS_H
#define SCREE_BONDS_BONDS_H

#include "physics/bonds/bond.h"
#include "physics/grains/laws/law.h"
#include "base/file.h"
#include "data/formats/output_options.h"

enum { BONDS_ENTRIES_MAX = 16 };

enum bonds_when { BONDS_AT_START, BONDS_AT_TIME };

/* One entry of `laws`. */
struct bonds_entry {
    int materials, material[2]; /* one: both are of it; two: one each; none: any */
    int groups, group[2];
    double k_n, k_s;       /* Pa/m; NAN: not given, and then */
    double modulus, ratio; /* Young's modulus of the bond, k_n = modulus / (r_i + r_j), and k_n / k_s */
    double radius;         /* of the bond over the smaller of the two radii */
    double tensile, shear; /* strengths, Pa; NAN: never breaks in this way */
    double damping;
};

/* The section `bonds` of a scene. */
struct bonds_options {
    int when;    /* enum bonds_when */
    double time; /* AT_TIME; NAN: not given */
    double gap;  /* largest gap between surfaces, length */
    bool contacts;
    int entries;
    struct bonds_entry entry[BONDS_ENTRIES_MAX];
    char list[FILE_PATH_MAX]; /* table of pairs of ids; "": by the gap */
};

#endif
