/* One impact in a plane, integrated on its own: two spheres, or a sphere onto a plane, by the midpoint rule
 * in some 200,000 steps a contact. A second solution of the equations of docs/physics.md that shares no line
 * with scree.
 *
 * impact hertz E1 NU1 E2 NU2 | hooke KN KT 0 0   E MU   R1 M1 R2 M2     R2 = 0: body 2 is a plane at rest
 *
 * Body 1 is above (y > 0), body 2 below; they touch at the origin. Lines of standard input: vx1 vy1 w1 vx2
 * vy2 w2, spins counter-clockwise. A line of output for each: the six afterwards, the largest overlap, the
 * largest normal force, the duration. The contact ends at zero overlap. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BODY = 5, STATE = 11 }; /* x y vx vy w of each body, then the tangential spring */

struct contact {
    bool hertz, plane;
    double kn, kt, cn, ct, mu; /* hertz: kn sqrt(R* d) is the force over the overlap */
    double r[2], m[2], mass, radius;
};

struct touch {
    double overlap, normal_force, tangent_force, stretch_rate;
    double nx, ny, lever[2];
};

static struct touch touch_of(const struct contact *c, const double s[STATE]) {
    struct touch t = {.nx = 0.0, .ny = -1.0};
    double distance = s[1];
    if (c->plane) {
        t.overlap = c->r[0] - distance;
    } else {
        distance = hypot(s[5] - s[0], s[6] - s[1]);
        t.nx = (s[5] - s[0]) / distance;
        t.ny = (s[6] - s[1]) / distance;
        t.overlap = c->r[0] + c->r[1] - distance;
    }
    double depth = fmax(t.overlap, 0.0), half = c->hertz ? 0.5 * depth : 0.0;
    t.lever[0] = c->r[0] - half;
    t.lever[1] = c->plane ? 0.0 : c->r[1] - half;
    double rx = s[7] - s[2], ry = s[8] - s[3];
    double scale = c->hertz ? sqrt(c->radius * depth) : 1.0, stiffness = c->kn * scale;
    double base = sqrt(c->mass * stiffness);
    t.normal_force = fmax(stiffness * depth - c->cn * base * (rx * t.nx + ry * t.ny), 0.0);
    double slip = -rx * t.ny + ry * t.nx - t.lever[0] * s[4] - t.lever[1] * s[9];
    double kt = c->kt * scale, ct = c->ct * base, limit = c->mu * fabs(t.normal_force);
    t.tangent_force = -kt * s[10] - ct * slip;
    t.stretch_rate = slip;
    if (fabs(t.tangent_force) > limit) {
        t.tangent_force = copysign(limit, t.tangent_force);
        t.stretch_rate = ct > 0.0 ? -(t.tangent_force + kt * s[10]) / ct : slip;
    }
    return t;
}

static void rates_of(const struct contact *c, const double s[STATE], double rate[STATE]) {
    struct touch t = touch_of(c, s);
    double fx = t.normal_force * t.nx - t.tangent_force * t.ny;
    double fy = t.normal_force * t.ny + t.tangent_force * t.nx;
    for (int b = 0; b < 2; b++) {
        double sign = b ? 1.0 : -1.0, share = b && c->plane ? 0.0 : 1.0 / c->m[b];
        const double *from = s + b * BODY;
        double *to = rate + b * BODY;
        to[0] = from[2];
        to[1] = from[3];
        to[2] = sign * fx * share;
        to[3] = sign * fy * share;
        to[4] = share > 0.0 ? -t.lever[b] * t.tangent_force * share / (0.4 * c->r[b] * c->r[b]) : 0.0;
    }
    rate[10] = t.stretch_rate;
}

/* Without a damper a sliding spring carries the whole limit. */
static void cut(const struct contact *c, double s[STATE]) {
    struct touch t = touch_of(c, s);
    double kt = c->kt * (c->hertz ? sqrt(c->radius * fmax(t.overlap, 0.0)) : 1.0);
    if (c->ct == 0.0 && kt > 0.0)
        s[10] = -t.tangent_force / kt;
}

static void advance(const struct contact *c, double s[STATE], double dt) {
    double rate[STATE], middle[STATE];
    rates_of(c, s, rate);
    for (int k = 0; k < STATE; k++)
        middle[k] = s[k] + 0.5 * dt * rate[k];
    cut(c, middle);
    rates_of(c, middle, rate);
    for (int k = 0; k < STATE; k++)
        s[k] += dt * rate[k];
    cut(c, s);
}

/* Damping ratio of the linear spring-dashpot that ends at zero force with restitution e: e(zeta) of Schwager
 * and Poeschel (2007), inverted by bisection; e > 0.14, where zeta < 1. */
static double damping_ratio(double e) {
    double low = 0.0, high = 1.0;
    while (e < 1.0 && high - low > 1e-15) {
        double z = 0.5 * (low + high);
        if (exp(-2.0 * z * acos(z) / sqrt(1.0 - z * z)) > e)
            low = z;
        else
            high = z;
    }
    return low;
}

static bool contact_read(struct contact *c, char **a) {
    double p[10];
    for (int k = 0; k < 10; k++)
        p[k] = atof(a[k + 1]);
    c->hertz = strcmp(a[0], "hertz") == 0;
    c->mu = p[5];
    c->r[0] = p[6];
    c->m[0] = p[7];
    c->r[1] = p[8];
    c->m[1] = p[9];
    c->plane = p[8] == 0.0;
    c->mass = c->plane ? p[7] : 1.0 / (1.0 / p[7] + 1.0 / p[9]);
    c->radius = c->plane ? p[6] : 1.0 / (1.0 / p[6] + 1.0 / p[8]);
    double zeta = damping_ratio(p[4]), tangent = p[0];
    c->kn = p[0];
    c->kt = p[1];
    c->cn = 2.0 * zeta;
    if (c->hertz) {
        c->kn = 4.0 / 3.0 / ((1.0 - p[1] * p[1]) / p[0] + (1.0 - p[3] * p[3]) / p[2]);
        c->kt = 4.0 / ((2.0 - p[1]) * (1.0 + p[1]) / p[0] + (2.0 - p[3]) * (1.0 + p[3]) / p[2]);
        c->cn = sqrt(5.0) * zeta;
        tangent = 1.5 * c->kn;
    }
    c->ct = c->cn * sqrt(c->kt / tangent);
    return c->mass > 0.0 && c->kn > 0.0;
}

/* Contact time of the undamped contact. */
static double time_scale(const struct contact *c, double speed) {
    if (!c->hertz)
        return acos(-1.0) * sqrt(c->mass / c->kn);
    double k = c->kn * sqrt(c->radius);
    return 2.94328 * pow(1.25 * c->mass * speed * speed / k, 0.4) / speed;
}

int main(int count, char **arguments) {
    struct contact c;
    if (count != 12 || !contact_read(&c, arguments + 1)) {
        fputs("impact LAW E1 NU1 E2 NU2 E MU R1 M1 R2 M2\n", stderr);
        return 2;
    }
    double v[6];
    while (scanf("%lf %lf %lf %lf %lf %lf", v, v + 1, v + 2, v + 3, v + 4, v + 5) == 6) {
        double s[STATE] = {0.0, c.r[0], v[0], v[1], v[2], 0.0, -c.r[1], v[3], v[4], v[5], 0.0};
        double dt = time_scale(&c, v[4] - v[1]) / 2e5, overlap = 0.0, force = 0.0, time = 0.0;
        for (int step = 0; step < 4000000; step++, time += dt) {
            struct touch t = touch_of(&c, s);
            if (step > 10 && t.overlap <= 0.0)
                break;
            overlap = fmax(overlap, t.overlap);
            force = fmax(force, t.normal_force);
            advance(&c, s, dt);
        }
        printf("%.12g %.12g %.12g %.12g %.12g %.12g %.12g %.12g %.12g\n", s[2], s[3], s[4], s[7], s[8], s[9],
               overlap, force, time);
    }
    return 0;
}
