/* SPDX-License-Identifier: BSD-3-Clause */
/* Drag and buoyancy of grains in a fluid that does not resolve them: the section `drag` of a scene. The flow around each
 * grain is replaced by a law (drag_law.h), with the porosity around the grain (porosity.h); the fluid is given by its
 * superficial velocity U, the volume flow over the whole cross-section. A grain of velocity v, diameter d and volume V
 * feels
 *
 *   F = K (U - porosity v) - density_of_the_fluid V g
 *
 * with the law's K(d, |U - porosity v|, porosity). The drag K (...) is all that the fluid gives but for hydrostatic
 * buoyancy: it has the force of the pressure gradient that the drag of the other grains makes (form B of Zhou, Kuang, Chu,
 * Yu, J. Fluid Mech. 661 (2010) 482). The fluid therefore loses the pressure sum of drags / cross-section over a bed,
 * which is the weight of a fluidised bed less its buoyancy.
 *
 * Instead of a given fluid, that of the section `fluid` may flow between the grains: then U - porosity v is w - v with its volume flow w at
 * the grain, the force of its pressure may be apart (then K is porosity times that of form B: form A), and it loses the momentum that the grain
 * gains (physics/drag/carrier.h, physics/fluid/coupling/unresolved_grains.h). */
#ifndef SCREE_DRAG_DRAG_H
#define SCREE_DRAG_DRAG_H

enum drag_law_name { DRAG_STOKES, DRAG_SCHILLER_NAUMANN, DRAG_DI_FELICE, DRAG_GIDASPOW, DRAG_LAWS };

/* A fluid that is given. */
struct drag_fluid {
    double density, viscosity; /* viscosity: dynamic */
    double velocity[3];        /* superficial, at the start; length/time */
    double acceleration[3];    /* of the superficial velocity; length/time2 */
};

struct drag_porosity {
    double support; /* of the kernel, length; NAN: not given */
    int every;      /* steps from one sum to the next */
};

struct drag_options { /* the section `drag` of a scene */
    enum drag_law_name law;
    int fluids; /* 0: that of the section `fluid`, which resolves none of these grains (physics/drag/carrier.h); 1 */
    struct drag_fluid fluid;
    struct drag_porosity porosity;
    double largest; /* radius up to which grains feel drag and count in the porosity; NAN: any */
};

struct scene;

/* The radius up to which grains take part. */
double drag_largest(const struct scene *scene);

#endif
