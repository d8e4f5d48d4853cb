/* SPDX-License-Identifier: BSD-3-Clause */
/* Heat that grains conduct through their contacts, with walls and, where asked for, through the gas between
 * grains that nearly touch. A grain has one temperature: its inside conducts better than its contacts (Biot
 * number far below 1).
 *
 * Two grains i and j with the contact radius a exchange the power H (T_j - T_i),
 *
 *   H = 4 k_i k_j / (k_i + k_j) a      (a: contact radius of the law, law_grip_radius)
 *
 * (Batchelor and O'Brien, Proc. R. Soc. A 355 (1977) 313, eq. 2.2: 2 k a for equal grains). Where the scene's
 * grains are softer than the real ones by `softening` (Young's moduli, real over the scene's), the contact
 * radius under the same Hertzian force is smaller: a is divided by the cube root of softening.
 *
 * Through gas of conductivity k_g grains exchange H_g (T_j - T_i) where the gap between the surfaces is below
 * `distance`: the gap at a distance r from the line of centres is g + r^2 / (2 R*), and the gap is never less
 * than `roughness`, so that
 *
 *   H_g = 2 pi k_g R* ln(distance / max(g, roughness))      for g < distance, overlaps count as g = 0
 *
 * (the same paper, section 4, cut off at the given gap). A neck, where surfaces touch across a gap, counts as g = 0.
 *
 * Of the energy that a contact loses (dampers, sliding, plastic flow) the part `dissipation` becomes heat: half of it in
 * each of two grains, all of it in the grain at a wall (heat_work.h). */
#ifndef SCREE_HEAT_HEAT_H
#define SCREE_HEAT_HEAT_H

#include "physics/grains/batch/force.h"
#include "physics/grains/walls/wall.h"

enum { HEAT_PATH_MAX = 256 };

/* One entry of `materials`. */
struct heat_material {
    int material;                  /* -1: all materials that no other entry names */
    double conductivity, capacity; /* W/(m K); J/(kg K) */
};

/* One entry of `walls`; a wall that is not named exchanges no heat. */
struct heat_wall {
    int wall;
    double temperature; /* K; NAN: not given, and then: */
    double flux;        /* W/m2 of the cross-section of a grain that touches; NAN: not given, and then: */
    char table[HEAT_PATH_MAX]; /* rows t T: the temperature over time */
};

struct heat_gas {
    double conductivity; /* W/(m K); 0: no gas */
    double distance, roughness;
};

/* The section `heat` of a scene. */
struct heat_options {
    double temperature; /* of grains at the start, K, where their source gives no other */
    double dissipation; /* share of the energy lost in contacts that warms the grains, 0 ... 1 */
    double softening;
    struct heat_gas gas;
    int materials;
    struct heat_material material[LAW_MATERIALS_MAX];
    int walls;
    struct heat_wall wall[WALLS_MAX];
};

#endif
