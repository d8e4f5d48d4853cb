/* An elastic oblique impact of a sphere onto a plane with slip in a part of the contact area, the problem
 * that Maw, Barber and Fawcett (Wear 38 (1976) 101) solve by annuli which stick or slip one by one. It is
 * solved here by the method of dimensionality reduction (Popov and Hess, Method of Dimensionality Reduction
 * in Contact Mechanics and Friction, Springer 2015), which turns the axisymmetric problem into a row of
 * springs: the one at x touches once the approach d exceeds x^2 / R, carries E* (d - x^2 / R) dx along the
 * normal and G* u dx along the surface, u being its tangential displacement, and slips where that reaches MU
 * times its normal force. 1 / E* = sum (1 - nu^2) / E, 1 / G* = sum (2 - nu) / (4 G).
 *
 * maw E1 NU1 E2 NU2 MU R M
 *
 * Lines of standard input: vx vy before, vy towards the plane (negative), without spin. A line of output for
 * each: vx and the spin afterwards, counter-clockwise. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { SPRINGS = 400, STEPS = 20000 };

struct body {
    double normal, tangent; /* E*, G* */
    double friction, radius, mass;
};

/* Sum of the tangential springs after a step `slip` of the surface, at the approach d. */
static double springs_move(const struct body *b, double u[SPRINGS], double width, double d, double slip) {
    double sum = 0.0;
    for (int k = 0; k < SPRINGS; k++) {
        double x = (k + 0.5) * width, pressed = d - x * x / b->radius;
        double most = pressed > 0.0 ? b->friction * b->normal / b->tangent * pressed : 0.0;
        u[k] = pressed > 0.0 ? fmax(-most, fmin(most, u[k] + slip)) : 0.0;
        sum += u[k];
    }
    return 2.0 * b->tangent * width * sum;
}

static void impact(const struct body *b, double *vx, double vy, double *spin) {
    double stiffness = 4.0 / 3.0 * b->normal * sqrt(b->radius);
    double deepest = pow(1.25 * b->mass * vy * vy / stiffness, 0.4);
    double dt = 2.94328 * deepest / -vy / STEPS, width = 1.001 * sqrt(b->radius * deepest) / SPRINGS;
    double u[SPRINGS] = {0.0}, d = 0.0, rate = -vy;
    do {
        rate -= 0.5 * dt * stiffness * d * sqrt(d) / b->mass;
        d = fmax(d + dt * rate, 0.0);
        rate -= 0.5 * dt * stiffness * d * sqrt(d) / b->mass;
        double force = springs_move(b, u, width, d, dt * (*vx + b->radius * *spin));
        *vx -= dt * force / b->mass;
        *spin -= dt * 2.5 * force / (b->mass * b->radius);
    } while (d > 0.0);
}

int main(int count, char **a) {
    if (count != 8) {
        fputs("maw E1 NU1 E2 NU2 MU R M\n", stderr);
        return 2;
    }
    double p[7], vx, vy;
    for (int k = 0; k < 7; k++)
        p[k] = atof(a[k + 1]);
    struct body b = {.friction = p[4], .radius = p[5], .mass = p[6]};
    b.normal = 1.0 / ((1.0 - p[1] * p[1]) / p[0] + (1.0 - p[3] * p[3]) / p[2]);
    b.tangent = 2.0 / ((2.0 - p[1]) * (1.0 + p[1]) / p[0] + (2.0 - p[3]) * (1.0 + p[3]) / p[2]);
    while (scanf("%lf %lf", &vx, &vy) == 2) {
        double spin = 0.0;
        impact(&b, &vx, vy, &spin);
        printf("%.12g %.12g\n", vx, spin);
    }
    return 0;
}
