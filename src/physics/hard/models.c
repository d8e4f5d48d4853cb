/* SPDX-License-Identifier: BSD-3-Clause */
/* Models of a single contact. Read models.h first. */
#include "physics/hard/models.h"
#include <string.h>

/* Most iterations of a model, and the relative change at which it ends. */
enum { SLIDES_MOST = 40, STEPS_MOST = 400, ANGLES = 64, GOLDEN_STEPS = 60 };
static const double enough = 1e-15;

static double square2(const double x[2]) {
    return x[0] * x[0] + x[1] * x[1];
}

/* x = -(a + more)^-1 c */
static void solve2(const double a[3], double more, const double c[2], double x[2]) {
    double p = a[0] + more, r = a[2] + more, determinant = p * r - a[1] * a[1];
    x[0] = -(r * c[0] - a[1] * c[1]) / determinant;
    x[1] = -(p * c[1] - a[1] * c[0]) / determinant;
}

bool hard_relax_disc(const double a[3], const double c[2], double most, double x[2]) {
    double more = 0.0, y[2], length;
    solve2(a, more, c, x);
    if (square2(x) <= most * most)
        return false;
    if (!(most > 0.0)) {
        x[0] = x[1] = 0.0;
        return true;
    }
    for (int k = 0; k < SLIDES_MOST; k++) { /* Newton on 1/most - 1/|x|, which is monotone */
        length = sqrt(square2(x));
        if (fabs(length - most) <= enough * most)
            break;
        solve2(a, more, x, y);
        more += square2(x) / -(x[0] * y[0] + x[1] * y[1]) * (length - most) / most;
        solve2(a, more, c, x);
    }
    length = sqrt(square2(x));
    x[0] *= most / length;
    x[1] *= most / length;
    return true;
}

static void tangents(const struct hard_local *l, double a[3]) {
    a[0] = l->a[4];
    a[1] = 0.5 * (l->a[5] + l->a[7]);
    a[2] = l->a[8];
}

/* What the tangents see where the normal impulse is n. */
static void slip_at(const struct hard_local *l, double n, double c[2]) {
    c[0] = l->c[1] + l->a[3] * n;
    c[1] = l->c[2] + l->a[6] * n;
}

/* Friction's limit. */
static double most_at(const struct hard_local *l, double n) {
    return l->friction * (n + l->press);
}

static void frictionless(const struct hard_local *l, double p[3]) {
    p[0] = fmax(0.0, -l->c[0] / l->a[0]);
    p[1] = p[2] = 0.0;
}

/* The impulse that sticks, by elimination of the normal one; true if it lies in the cone. */
static bool sticks(const struct hard_local *l, double p[3]) {
    double a[3], c[2];
    tangents(l, a);
    a[0] -= l->a[1] * l->a[3] / l->a[0];
    a[1] -= l->a[1] * l->a[6] / l->a[0];
    a[2] -= l->a[2] * l->a[6] / l->a[0];
    slip_at(l, -l->c[0] / l->a[0], c);
    solve2(a, 0.0, c, p + 1);
    p[0] = -(l->c[0] + l->a[1] * p[1] + l->a[2] * p[2]) / l->a[0];
    double most = most_at(l, p[0]);
    return p[0] >= 0.0 && square2(p + 1) <= most * most;
}

/* The impulses of a contact that opens; false: its friction would close it. */
static bool opens(const struct hard_local *l, double p[3]) {
    double a[3], c[2];
    if (l->c[0] < 0.0 && l->friction > 0.0)
        return false;
    frictionless(l, p);
    if (!(most_at(l, 0.0) > 0.0))
        return true;
    tangents(l, a);
    slip_at(l, 0.0, c);
    hard_relax_disc(a, c, most_at(l, 0.0), p + 1);
    return l->c[0] + l->a[1] * p[1] + l->a[2] * p[2] >= 0.0;
}

static void coulomb(const struct hard_local *l, double p[3]) {
    double a[3], c[2], last[3], stuck[3];
    if (opens(l, p)) /* of two answers the one that separates */
        return;
    if (sticks(l, stuck)) {
        memcpy(p, stuck, sizeof stuck);
        return;
    }
    tangents(l, a);
    for (int k = 0; k < SLIDES_MOST; k++) {
        memcpy(last, p, sizeof last);
        p[0] = fmax(0.0, -(l->c[0] + l->a[1] * p[1] + l->a[2] * p[2]) / l->a[0]);
        slip_at(l, p[0], c);
        double most = most_at(l, p[0]), whole = p[0] + l->press;
        if (hard_relax_disc(a, c, most, p + 1) && most > 0.0) { /* along this direction both at once */
            double turns = (l->a[1] * p[1] + l->a[2] * p[2]) / whole, along = l->a[0] + turns;
            double n = along > 0.0 ? fmax(0.0, (-l->c[0] - l->press * turns) / along) : p[0];
            p[1] *= (n + l->press) / whole;
            p[2] *= (n + l->press) / whole;
            p[0] = n;
        }
        if (fabs(p[0] - last[0]) + fabs(p[1] - last[1]) + fabs(p[2] - last[2]) <= enough * (p[0] + l->press))
            break;
    }
}

static void decoupled(const struct hard_local *l, double p[3]) {
    double a[3], c[2];
    p[0] = fmax(0.0, -(l->c[0] + l->a[1] * p[1] + l->a[2] * p[2]) / l->a[0]);
    tangents(l, a);
    slip_at(l, p[0], c);
    solve2(a, 0.0, c, p + 1);
    double most = most_at(l, p[0]), square = square2(p + 1);
    double keep = square > most * most ? most / sqrt(square) : 1.0;
    p[1] *= keep;
    p[2] *= keep;
}

/* The point of the cone nearest to p; that of a cohesion has its tip below p_n = 0, where it is cut. */
static void cone(const struct hard_local *l, double p[3]) {
    double friction = l->friction, slip = sqrt(square2(p + 1)), whole = p[0] + l->press;
    double n = (whole + friction * slip) / (1.0 + friction * friction), most = most_at(l, 0.0);
    if (slip <= friction * whole && p[0] >= 0.0)
        return;
    if (slip > friction * whole && n > l->press) {
        p[0] = n - l->press;
        p[1] *= friction * n / slip;
        p[2] *= friction * n / slip;
        return;
    }
    double keep = slip > most ? most / slip : 1.0;
    p[0] = 0.0;
    p[1] *= keep;
    p[2] *= keep;
}

/* Steps down the slope, and back onto the cone; `slips`: with the slip in the normal row. */
static void project(const struct hard_local *l, bool slips, double p[3]) {
    double step = 1.0 / (l->a[0] + l->a[4] + l->a[8]); /* the trace is above all eigenvalues */
    if (slips)
        step /= 1.0 + l->friction;
    for (int k = 0; k < STEPS_MOST; k++) {
        double w[3], last[3], change = 0.0;
        memcpy(last, p, sizeof last);
        for (int d = 0; d < 3; d++)
            w[d] = l->c[d] + l->a[3 * d] * p[0] + l->a[3 * d + 1] * p[1] + l->a[3 * d + 2] * p[2];
        if (slips)
            w[0] += l->friction * sqrt(square2(w + 1));
        for (int d = 0; d < 3; d++)
            p[d] -= step * w[d];
        cone(l, p);
        for (int d = 0; d < 3; d++)
            change += fabs(p[d] - last[d]);
        if (change <= enough * (p[0] + l->press))
            break;
    }
}

static void projection(const struct hard_local *l, double p[3]) {
    project(l, false, p);
}

static void de_saxce(const struct hard_local *l, double p[3]) {
    if (!opens(l, p))
        project(l, true, p);
}

/* The impulse on the rim of the cone that keeps the contact closed, in a direction; false: none. */
static bool rim(const struct hard_local *l, double angle, double p[3]) {
    double along = l->a[0] + l->friction * (l->a[1] * cos(angle) + l->a[2] * sin(angle));
    if (!(along > 0.0))
        return false;
    p[0] = fmax(0.0, (-l->c[0] - l->press * (along - l->a[0])) / along);
    p[1] = most_at(l, p[0]) * cos(angle);
    p[2] = most_at(l, p[0]) * sin(angle);
    return true;
}

/* Energy that is left, but for a constant: p A p / 2 + c p. */
static double left(const struct hard_local *l, double angle) {
    double p[3], sum = 0.0;
    if (!rim(l, angle, p))
        return INFINITY;
    for (int d = 0; d < 3; d++)
        sum +=
            p[d] * (l->c[d] + 0.5 * (l->a[3 * d] * p[0] + l->a[3 * d + 1] * p[1] + l->a[3 * d + 2] * p[2]));
    return sum;
}

static void dissipation(const struct hard_local *l, double p[3]) {
    const double golden = 0.5 * (sqrt(5.0) - 1.0), apart = 2.0 * M_PI / ANGLES;
    double best = 0.0, least = INFINITY;
    if (opens(l, p))
        return;
    if (sticks(l, p))
        return;
    for (int k = 0; k < ANGLES; k++)
        if (left(l, k * apart) < least) {
            best = k * apart;
            least = left(l, best);
        }
    double low = best - apart, high = best + apart;
    for (int k = 0; k < GOLDEN_STEPS; k++) {
        double one = high - golden * (high - low), two = low + golden * (high - low);
        if (left(l, one) < left(l, two))
            high = two;
        else
            low = one;
    }
    rim(l, 0.5 * (low + high), p);
}

const struct hard_model *hard_relax_model(enum hard_model_number number) {
#define MODEL(NAME, name_, closed_, summary_)                                                                \
    [HARD_MODEL_##NAME] = {.name = #name_, .summary = summary_, .relax = name_, .closed = closed_},
    static const struct hard_model models[HARD_MODELS] = {HARD_MODEL_TABLE(MODEL)};
#undef MODEL
    return &models[number];
}
