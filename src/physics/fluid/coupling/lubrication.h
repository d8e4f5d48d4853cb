/* SPDX-License-Identifier: BSD-3-Clause */
/* What a lattice of the spacing dx leaves out of the lubrication between two spheres, or discs, whose gap h is below two spacings. Numbers alone: no lists, no ranks.
 *
 * With the reduced radius R = r1 r2 / (r1 + r2), of a wall R = r1, a thin film of the viscosity mu resists three motions of the two surfaces, and no others without bound as h -> 0: squeezing at the
 * speed v; slip s, the tangential velocity of one surface relative to the other; rolling, at the sum c of the velocities of both surfaces relative to the film between them, which turns with the line
 * of centres. The power that it takes is Z v^2 + S s^2 + C c^2:
 *
 *             three dimensions              two, a depth
 *   Z (h)     6 pi mu R^2 / h               3 sqrt 2 pi mu (R / h)^(3/2)
 *   S (h)     2 pi mu R ln (R / h)          sqrt 2 pi mu (R / h)^(1/2)
 *   C (h)     6/5 pi mu R ln (R / h)        as S
 *
 * In three dimensions these are the leading terms of Jeffrey and Onishi (J. Fluid Mech. 139 (1984) 261) for all ratios of the radii, and of Goldman, Cox and Brenner (Chem. Eng. Sci. 22 (1967) 637) at a wall;
 * in two, those of a film of the thickness h + x^2 / (2 R). The lattice has these at the gap h + d (h), as its edges are no sharper than that; d was measured (docs/fluid-method.md). So
 * Z (h) - Z (h + d) is what it leaves out, and likewise S and C; each less its value at LUBRICATION_REACH spacings, where it ends. h is at least the roughness. */
#ifndef SCREE_COUPLING_LUBRICATION_H
#define SCREE_COUPLING_LUBRICATION_H

#include <stdbool.h>

/* Where it begins, in spacings. */
#define LUBRICATION_REACH 2.0

struct lubrication {
    double viscosity, spacing, roughness; /* length: the least h */
    int dimension;
};

/* Z, S and C; force over velocity. */
struct lubrication_parts {
    double squeeze, slip, roll;
};

/* What is left out at a gap, which may be negative, of the reduced radius, between two grains or a grain and a wall. Any thread. */
struct lubrication_parts lubrication_of(const struct lubrication *lubrication, double reduced, bool wall,
                                        double gap);

/* Two that are near. Of a wall lever[1] is INFINITY, spin[1] is not used, and velocity[1] is that of its surface. */
struct lubrication_pair {
    double normal[3]; /* from the first to the second */
    double lever[2]; /* from the centres to the middle of the gap; their sum is the distance of the centres */
    double velocity[2][3], spin[2][3];
    double lightness[2], swing[2]; /* 1/mass, 1/moment of inertia; of a wall 0 */
};

/* Cuts the parts so that an explicit step dt with up to twelve such neighbours takes no more than all of the motion. Any thread. */
void lubrication_limit(struct lubrication_parts *parts, const struct lubrication_pair *pair, double dt);

/* Force and torque on the first: six numbers. The second one gets the opposite force at the gap, so that momentum and angular momentum stay, and the power is never positive. Any thread. */
void lubrication_force(const struct lubrication_parts *parts, const struct lubrication_pair *pair,
                       double force[6]);

#endif
