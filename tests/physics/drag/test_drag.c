/* SPDX-License-Identifier: BSD-3-Clause */
/* Laws of drag against their formulas at known points, and the part of the kernel before a wall against a quadrature. */
#include "tests/test.h"

#include "physics/drag/drag.h"
#include "physics/drag/drag_law.h"
#include "physics/drag/porosity.h"
#include <math.h>
#include "tests/near.h"

static double factor(int law, double speed, double porosity) {
    const struct drag_case at = {
        .density = 1000, .viscosity = 1e-3, .diameter = 1e-3, .speed = speed, .porosity = porosity};
    return drag_law_get(law)->factor(&at);
}

/* pi/8 density d^2 C |w| */
static double by_coefficient(double c, double speed) {
    return M_PI / 8 * 1000 * 1e-6 * c * speed;
}

static void alone(void **state) {
    (void)state;
    const double stokes = 3 * M_PI * 1e-6;
    assert_near(factor(DRAG_STOKES, 0.7, 1), stokes, 1e-20);
    for (int law = DRAG_SCHILLER_NAUMANN; law < DRAG_LAWS;
         law++) /* all laws become Stokes's, Dallavalle's but for 4 % */
        assert_near(factor(law, 1e-9, 1) / stokes, 1, law == DRAG_DI_FELICE ? 0.05 : 1e-4);
    /* Re = 100 */
    assert_near(factor(DRAG_SCHILLER_NAUMANN, 0.1, 1), stokes * (1 + 0.15 * pow(100, 0.687)), 1e-18);
    assert_near(factor(DRAG_DI_FELICE, 0.1, 1), by_coefficient(pow(0.63 + 0.48, 2), 0.1), 1e-18);
    /* Newton's coefficient beyond Re = 1000, without a jump of more than a hundredth */
    assert_near(factor(DRAG_SCHILLER_NAUMANN, 5, 1), by_coefficient(0.44, 5), 1e-15);
    assert_near(factor(DRAG_SCHILLER_NAUMANN, 0.9999, 1) / factor(DRAG_SCHILLER_NAUMANN, 1.0001, 1), 1, 0.01);
}

static void in_a_bed(void **state) {
    (void)state;
    double off = 1.5 - 2, power = 3.7 - 0.65 * exp(-0.5 * off * off);
    assert_near(factor(DRAG_DI_FELICE, 0.1, 0.5) / factor(DRAG_DI_FELICE, 0.1, 1), pow(0.5, -power - 1),
                1e-11);
    /* Ergun's pressure drop over the number of grains in a volume: V / (1 - e) of a bed carries (1 - e) V of grains */
    double e = 0.4, w = 0.1, d = 1e-3;
    double drop = 150 * 1e-3 * pow(1 - e, 2) * w / (pow(e, 3) * d * d) +
                  1.75 * 1000 * (1 - e) * w * w / (pow(e, 3) * d);
    assert_near(factor(DRAG_GIDASPOW, w, e) * w, drop * porosity_volume(d / 2) / (1 - e), 1e-16);
    assert_near(factor(DRAG_GIDASPOW, w, 0.9), factor(DRAG_SCHILLER_NAUMANN, w, 1) * pow(0.9, -4.65), 1e-18);
    assert_true(drag_law_get(DRAG_GIDASPOW)->porous && !drag_law_get(DRAG_SCHILLER_NAUMANN)->porous);
}

/* The share of Wendland's C2 kernel in the planes before a wall at z supports. */
static double front_by_planes(double z) {
    enum { PLANES = 4000, RINGS = 1000 };
    double sum = 0;
    for (int k = 0; k < PLANES; k++) {
        double at = -1 + (z + 1) * (k + 0.5) / PLANES, over = 1 - at * at;
        for (int r = 0; r < RINGS; r++) { /* rings of equal area */
            double q = sqrt(at * at + over * (r + 0.5) / RINGS);
            sum += 21 / (2 * M_PI) * pow(1 - q, 4) * (1 + 4 * q) * M_PI * over / RINGS * (z + 1) / PLANES;
        }
    }
    return sum;
}

static void before_a_wall(void **state) {
    (void)state;
    assert_near(porosity_front(0), 0.5, 1e-15);
    assert_near(porosity_front(1), 1, 1e-14);
    assert_near(porosity_front(3), 1, 1e-14);
    assert_near(porosity_front(0.1), front_by_planes(0.1), 2e-5);
    assert_near(porosity_front(0.5), front_by_planes(0.5), 2e-5);
}

TEST_MAIN(drag, cmocka_unit_test(alone), cmocka_unit_test(in_a_bed), cmocka_unit_test(before_a_wall))
