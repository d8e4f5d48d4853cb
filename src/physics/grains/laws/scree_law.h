/* SPDX-License-Identifier: BSD-3-Clause */
/* A contact law of your own for scree: the scene says `contact: {law: {file: mylaw.c}}`, and `scree run` compiles the file
 * when it starts (docs/user-law.md is the tutorial). The whole of a file is
 *
 *   #include <scree_law.h>
 *   static inline struct scree_law_springs springs(struct scree_law_contact c) { ... }
 *   SCREE_LAW(springs, .name = "mine")
 *
 * The function gives the elastic forces of one contact; damping, friction and the rest are scree's, as for its own laws. The
 * macro makes a loop of the function that the compiler vectorises, if the function has no branches other than c ? a : b, and
 * calls nothing but sqrt, fabs and other `static inline` functions. */
#ifndef SCREE_LAWS_SCREE_LAW_H
#define SCREE_LAWS_SCREE_LAW_H

#include <math.h>

enum { SCREE_LAW_VERSION = 1, SCREE_LAW_PARAMETERS_MAX = 8 };

/* One contact. Units are those of the scene. */
struct scree_law_contact {
    double overlap;  /* length, more than 0 */
    double radius;   /* effective radius 1/(1/r_i + 1/r_j); at a wall that of the sphere */
    double k_n, k_t; /* of material_pairs */
    double parameter[SCREE_LAW_PARAMETERS_MAX]; /* `parameters` of material_pairs */
};

/* The springs of one contact. */
struct scree_law_springs {
    double force;      /* elastic normal force; positive: repulsion */
    double stiffness;  /* force / overlap: sets the damper that belongs to a restitution */
    double tangent;    /* d force / d overlap: sets the stable step */
    double tangential; /* stiffness of the tangential and of the rolling spring, force/length */
    double contact;    /* factor of gamma_n and gamma_t (damping: coefficient): 1, or the contact radius */
    double energy;     /* stored in the normal spring: the integral of the force */
};

/* Many contacts, an array each. */
struct scree_law_batch {
    int count;
    const double *overlap, *radius, *k_n, *k_t, *parameter[SCREE_LAW_PARAMETERS_MAX];
    double *force, *stiffness, *tangential, *contact, *energy;
};

/* What a file gives; the macro fills version, one and batch. */
struct scree_law {
    int version;
    const char *name; /* for messages and the report; letters, digits, _ */
    int parameters;   /* how many it takes */
    const char *parameter_name[SCREE_LAW_PARAMETERS_MAX]; /* for messages */
    /* The damper of a restitution: c = damper * zeta * sqrt(m* stiffness), with zeta that of the linear spring and dashpot with this
     * restitution; exact are 2 for a force ~ overlap and sqrt(5) for ~ overlap^(3/2). 0: 2. */
    double damper;
    double tangent; /* tangent / stiffness at small overlaps; 0: 1 */
    struct scree_law_springs (*one)(struct scree_law_contact contact);
    void (*batch)(const struct scree_law_batch *batch);
};

#define SCREE_LAW(FUNCTION, ...)                                                                             \
    static struct scree_law_springs scree_law_one(struct scree_law_contact contact) {                        \
        return FUNCTION(contact);                                                                            \
    }                                                                                                        \
    static void scree_law_loop(const struct scree_law_batch *batch) {                                        \
        const double *const overlap = batch->overlap, *const radius = batch->radius;                         \
        const double *const k_n = batch->k_n, *const k_t = batch->k_t;                                       \
        const double *const *const p = batch->parameter;                                                     \
        const double *const p0 = p[0], *const p1 = p[1], *const p2 = p[2], *const p3 = p[3];                 \
        const double *const p4 = p[4], *const p5 = p[5], *const p6 = p[6], *const p7 = p[7];                 \
        double *const force = batch->force, *const stiffness = batch->stiffness;                             \
        double *const tangential = batch->tangential, *const factor = batch->contact;                        \
        double *const energy = batch->energy;                                                                \
        const int count = batch->count;                                                                      \
        _Pragma("omp simd") for (int k = 0; k < count; k++) {                                                \
            struct scree_law_springs s = FUNCTION(                                                           \
                (struct scree_law_contact){overlap[k],                                                       \
                                           radius[k],                                                        \
                                           k_n[k],                                                           \
                                           k_t[k],                                                           \
                                           {p0[k], p1[k], p2[k], p3[k], p4[k], p5[k], p6[k], p7[k]}});       \
            force[k] = s.force;                                                                              \
            stiffness[k] = s.stiffness;                                                                      \
            tangential[k] = s.tangential;                                                                    \
            factor[k] = s.contact;                                                                           \
            energy[k] = s.energy;                                                                            \
        }                                                                                                    \
    }                                                                                                        \
    const struct scree_law scree_law = {                                                                     \
        .version = SCREE_LAW_VERSION, .one = scree_law_one, .batch = scree_law_loop, __VA_ARGS__};

#endif
