/* SPDX-License-Identifier: BSD-3-Clause */
/* The table of drag laws. Read drag_law.h first. */
#include "physics/drag/drag_law.h"
#include "physics/drag/drag.h"
#include <math.h>

static double reynolds(const struct drag_case *at) {
    return at->density * at->diameter * at->speed / at->viscosity;
}

static double stokes(const struct drag_case *at) {
    return 3.0 * M_PI * at->viscosity * at->diameter;
}

/* From this Reynolds number on the coefficient of drag is that of Newton. */
static const double newton_from = 1000.0, newton = 0.44;

static double schiller_naumann(const struct drag_case *at) {
    double re = reynolds(at);
    if (re > newton_from)
        return M_PI / 8.0 * newton * at->density * at->diameter * at->diameter * at->speed;
    return stokes(at) * (1.0 + 0.15 * pow(re, 0.687));
}

/* (0.63 sqrt(|w|) + 4.8 sqrt(mu / (density d)))^2 is C |w| without a quotient of zeros. */
static double di_felice(const struct drag_case *at) {
    double root = 0.63 * sqrt(at->speed) + 4.8 * sqrt(at->viscosity / (at->density * at->diameter));
    double off = 1.5 - log10(fmax(reynolds(at), 1e-12));
    double power = 3.7 - 0.65 * exp(-0.5 * off * off);
    return M_PI / 8.0 * at->density * at->diameter * at->diameter * root * root *
           pow(at->porosity, -power - 1.0);
}

/* The porosity up to which a bed is one of Ergun's. */
static const double ergun_upto = 0.8;

static double gidaspow(const struct drag_case *at) {
    double e = at->porosity, d = at->diameter;
    if (e > ergun_upto)
        return schiller_naumann(at) * pow(e, -4.65);
    return M_PI / 6.0 * d / (e * e * e) *
           (150.0 * at->viscosity * (1.0 - e) + 1.75 * at->density * d * at->speed);
}

static const struct drag_law laws[DRAG_LAWS] = {
    [DRAG_STOKES] = {"stokes", "a sphere alone in creeping flow", false, stokes},
    [DRAG_SCHILLER_NAUMANN] = {"schiller_naumann", "a sphere alone, up to Re of about 10^5", false,
                               schiller_naumann},
    [DRAG_DI_FELICE] = {"di_felice", "spheres at any porosity and Re (Di Felice 1994)", true, di_felice},
    [DRAG_GIDASPOW] = {"gidaspow", "Ergun's law up to a porosity of 0.8, Wen and Yu's beyond", true,
                       gidaspow}};

const struct drag_law *drag_law_get(int law) {
    return &laws[law];
}
