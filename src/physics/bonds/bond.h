/* SPDX-License-Identifier: BSD-3-Clause */
/* One parallel bond: a short elastic beam between two spheres (D. O. Potyondy and P. A. Cundall, "A bonded-particle
 * model for rock", Int. J. Rock Mech. Min. Sci. 41 (2004) 1329-1364, its parallel bonds).
 *
 * A bond of radius R has the section of a disc: area A = pi R^2, moment of inertia I = pi R^4 / 4, polar moment
 * J = pi R^4 / 2. Stiffnesses k_n and k_s are those of an area, Pa/m. A relative motion of the two
 * ends at the middle of the bond changes force and moment by
 *
 *   dF_n = k_n A dU_n,  dF_s = -k_s A dU_s,  dM_n = -k_s J dTheta_n,  dM_s = -k_n I dTheta_s
 *
 * The largest tensile and shear stress at the rim of the section are
 *
 *   sigma = tension / A + |M_s| R / I,   tau = |F_s| / A + |M_n| R / J
 *
 * and the bond breaks where one of them reaches its strength. The tension is k_n A (length - rest length), the
 * sum of its increments. Shear force and moments are increments over the steps, taken at half a step, and turn
 * with the bond: with the line of centres, and about the line with the mean spin of both spheres.
 *
 * All vectors are those of the particle with the higher id: force and moment on it, separation from the lower id
 * to the higher. Both ends of a bond compute the same numbers from the same state, to the last bit. */
#ifndef SCREE_BONDS_BOND_H
#define SCREE_BONDS_BOND_H

#include "physics/grains/laws/law_vector.h"
#include "kernel/pairs/history.h"

/* The doubles of a bond's row (kernel/pairs/history.h), and their number. */
enum { BOND_REST, BOND_SHEAR, BOND_MOMENT = 4, BOND_ENTRY = 7, BOND_COMPONENTS };

/* The ways in which a bond ends. LOST: one of its particles was deleted. */
enum bond_end { BOND_WHOLE, BOND_TENSION, BOND_SHEARED, BOND_LOST, BOND_ENDS };

/* The numbers of a bond that do not change:
 *
 *   radius, area
 *   stretch, slide                        k_n A, k_s A: force/length
 *   bend, twist                           k_n I, k_s J: torque/rad
 *   tensile, shear                        strengths, Pa; INFINITY: never breaks in this way
 *   c_stretch, c_slide, c_bend, c_twist   dampers: 2 beta sqrt(m* K), and of moments with I*
 *   bend_over, twist_over                 R / I, R / J */
#define BOND_SECTION_TABLE(ROW)                                                                              \
    ROW(radius)                                                                                              \
    ROW(area)                                                                                                \
    ROW(stretch)                                                                                             \
    ROW(slide)                                                                                               \
    ROW(bend)                                                                                                \
    ROW(twist)                                                                                               \
    ROW(tensile)                                                                                             \
    ROW(shear) ROW(c_stretch) ROW(c_slide) ROW(c_bend) ROW(c_twist) ROW(bend_over) ROW(twist_over)
#define BOND_SECTION_MEMBER(member) double member;
struct bond_section {
    BOND_SECTION_TABLE(BOND_SECTION_MEMBER)
};

/* What makes a section. */
struct bond_numbers {
    double k_n, k_s;       /* Pa/m */
    double radius;         /* of the bond, length */
    double tensile, shear; /* Pa */
    double damping;        /* beta: of critical, of each of the four motions */
    double mass, inertia;  /* effective ones of the two spheres: m1 m2 / (m1 + m2); 0: neither is free */
};
struct bond_section bond_section_of(const struct bond_numbers *numbers);

/* The two spheres, lower id first. */
struct bond_motion {
    struct law_vector separation; /* x_higher - x_lower now */
    struct law_vector velocity;   /* v_higher - v_lower, of the last half step */
    struct law_vector spin[2];    /* angular velocities */
    double lever[2];              /* distance from the centres to the middle of the bond now */
};

struct bond_response {
    struct law_vector force, moment; /* on the higher, dampers included */
    double stored;                   /* elastic energy */
    double taken;                    /* work that the dampers take in this step, exact to first order */
    double tensile, shear;           /* stresses, Pa */
    struct law_vector normal;        /* from lower to higher */
    enum bond_end end;
};

/* Bonds that advance together, in one loop over vectors: entry k of each column belongs to bond k. The columns of `section` and
 * `motion` are the members of the structs, those of `before` and `value` what the row holds, those of `out` the response's. */
enum {
    BOND_BATCH = 64,
    BOND_SECTIONS = sizeof(struct bond_section) / sizeof(double),
    BOND_MOTIONS = sizeof(struct bond_motion) / sizeof(double)
};
enum {
    BOND_OUT_FORCE,
    BOND_OUT_MOMENT = 3,
    BOND_OUT_NORMAL = 6,
    BOND_OUT_STORED = 9,
    BOND_OUT_TAKEN,
    BOND_OUT_TENSILE,
    BOND_OUT_SHEAR,
    BOND_OUT_END,
    BOND_OUTS
};
struct bond_batch {
    int count;
    double section[BOND_SECTIONS][BOND_BATCH], motion[BOND_MOTIONS][BOND_BATCH];
    double before[3][BOND_BATCH], value[BOND_ENTRY][BOND_BATCH], out[BOND_OUTS][BOND_BATCH];
};

/* Puts a bond behind the others of a batch that is not full. Any thread, with its own batch. */
void bond_batch_add(struct bond_batch *batch, const struct bond_section *section,
                    const struct bond_motion *motion, const struct history_row *row);

/* Advances force and moment of all bonds by a step dt; 0: a first evaluation, only the normal force is new. A bond that breaks in
 * this step has end != BOND_WHOLE; its force counts no more, and `stored` is the energy that it loses: that of half a step before,
 * up to which its force has acted. */
void bond_batch_advance(struct bond_batch *batch, double dt);

/* Writes bond k to its row, and gives its response. */
void bond_batch_take(const struct bond_batch *batch, int k, struct history_row *row,
                     struct bond_response *out);

/* Elastic energy of a row as it stands. */
double bond_energy(const struct bond_section *section, const struct history_row *row);

#endif
