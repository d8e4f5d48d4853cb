/* SPDX-License-Identifier: BSD-3-Clause */
/* Hard contacts: the options of their solver, as a scene gives them. docs/hard.md says what they are; row.h has the
 * equations, hard_solve.h the step, hard_physics.c the seam to the engine. */
#ifndef SCREE_HARD_HARD_H
#define SCREE_HARD_HARD_H

enum hard_method { HARD_GAUSS_SEIDEL, HARD_NEWTON };

/* A pass over the impacts alone after the sweeps; or Poisson's: each impact keeps 1 + e times its impulse of the sweeps, and
 * all contacts are solved again. */
enum hard_restitution { HARD_RESTITUTION_PASS, HARD_RESTITUTION_POISSON };

/* Plain data (scene key contact.solver). */
struct hard_options {
    int method;       /* enum hard_method */
    int model;        /* enum hard_model_number (models.h) */
    int restitution;  /* enum hard_restitution */
    int sweeps;       /* at most so many a step */
    int steps;        /* Newton: at most so many a step */
    double tolerance; /* on the residual; 0: always all sweeps */
    double kappa;     /* stiffness of rigid contacts in units of the step; INFINITY: rigid */
    double repair;    /* largest release of an overlap in a step, over the smaller radius */
};

/* 4 pi^2: a contact whose period is one step. */
#define HARD_KAPPA 39.478417604357434

#endif
