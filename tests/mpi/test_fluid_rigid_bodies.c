/* SPDX-License-Identifier: BSD-3-Clause */
/* What is rigid in a fluid: masses, moments and distances from the surface of a block, of two spheres that touch, of a disc as a grain and as a body, against
 * closed forms; forces and motions there and back.
 * Ranks: 1 */
#include "tests/test.h"

#include "base/memory.h"
#include "fluid_run.h"
#include "team.h"
#include "physics/bodies/bodies_links.h"
#include "physics/bodies/bodies_parts.h"
#include "base/rotor.h"
#include "physics/fluid/coupling/rigid_bodies.h"
#include "physics/fluid/coupling/rigid_grains.h"
#include "tests/near.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { TEXT_MAX = 2048 };
static const double fluid_density = 1.5;

/* A body in a cube of 16 spacings, which its entry's axes reach by the quaternion (2, 0.3, 1, -0.4). */
static bool cube_make(struct fluid_run *run, struct team *team, const char *entry) {
    char text[TEXT_MAX];
    snprintf(text, sizeof text,
             "units: none\nthreads: 1\nbox: {lower: [0, 0, 0], upper: [24, 24, 24], periodic: true}\n"
             "particles: {from: single, position: [12.1, 12.2, 12.3], radius: 6, density: 2}\n"
             "bodies: {%s, orientation: given, quaternion: [2, 0.3, 1, -0.4]}]}\n"
             "fluid: {spacing: 1.5, density: %g, viscosity: 1, grains: free}\n"
             "step: {dt: 0.1, count: 1, force: true}\n",
             entry, fluid_density);
    return fluid_run_begin(run, team, text, false);
}

/* From the axes of the entry to space. */
static void turn_make(double turn[9]) {
    double q[4] = {2, 0.3, 1, -0.4}, size = 0;
    for (int c = 0; c < 4; c++)
        size += q[c] * q[c];
    for (int c = 0; c < 4; c++)
        q[c] /= sqrt(size);
    rotor_matrix(q, turn);
}

static size_t body_of(const struct fluid_run *run) {
    struct kind_span bodies = kinds_span(run->context->particles, run->context->classes, KIND_BODY);
    assert_int_equal(bodies.end - bodies.first, 1);
    return bodies.first;
}

/* The first member of the body, or the one behind it. */
static size_t member_of(const struct fluid_run *run, size_t number) {
    struct kind_span span = rigid_bodies_span(run->context);
    for (size_t i = span.first; i < span.end; i++)
        if (rigid_bodies_member(run->context->particles, i) && number-- == 0)
            return i;
    fail();
    return 0;
}

/* a (xx, yy, zz, yz, xz, xy) is turn diag(moment) turn^T, within a part of the largest moment. */
static void tensor_is(const double a[6], const double turn[9], const double moment[3], double within) {
    static const int row[6] = {0, 1, 2, 1, 0, 0}, column[6] = {0, 1, 2, 2, 2, 1};
    double most = fmax(moment[0], fmax(moment[1], moment[2]));
    for (int k = 0; k < 6; k++) {
        double sum = 0;
        for (int d = 0; d < 3; d++)
            sum += turn[3 * row[k] + d] * moment[d] * turn[3 * column[k] + d];
        assert_near(a[k], sum, within * most);
    }
}

/* A force on a member, of the arm that the carrier tells, is a force and a torque on the body; a torque for a time changes the spin by I^-1 T t; the motion that was
 * set is the motion of the body. */
static void motions_go_there_and_back(const struct fluid_run *run, const struct rigid_inertia *inertia) {
    struct particles *p = run->context->particles;
    const double force[3] = {3, -1, 2}, torque[3] = {0.2, -0.5, 0.7}, motion[6] = {1, 2, -3, 0.1, 0.2, -0.3};
    double arm[3] = {0}, distance, on[6], change[3], spin[3], found[6];
    size_t body = body_of(run), member = member_of(run, 0);
    memset(p->force, 0, p->owned * (size_t)p->force_stride * sizeof *p->force);
    memcpy(p->force + member * (size_t)p->force_stride, force, sizeof force);
    assert_int_equal(rigid_bodies_carrier(run->context, member, arm, &distance), body);
    bodies_motion_gather(bodies_of(run->context->set)->links, run->context);
    rigid_bodies_contact(run->context, body, on);
    for (int d = 0; d < 3; d++) {
        int next = (d + 1) % 3, last = (d + 2) % 3;
        assert_near(on[d], force[d], 1e-13);
        assert_near(on[3 + d], arm[next] * force[last] - arm[last] * force[next], 1e-12);
    }
    rigid_bodies_turn(run->context, body, torque, 0.5, change);
    rigid_grains_spin(inertia->own, change, spin);
    for (int d = 0; d < 3; d++)
        assert_near(spin[d], 0.5 * torque[d], 1e-12);
    rigid_bodies_set(run->context, body, motion);
    rigid_bodies_motion(run->context, body, found);
    for (int d = 0; d < 6; d++)
        assert_near(found[d], motion[d], 1e-12);
    rigid_bodies_given(run->context, body, found); /* nothing is given: its own motion */
    assert_near(found[5], motion[5], 1e-12);
}

/* A block of 8 x 6 x 4: mass, m (b^2 + c^2) / 12, and those of the fluid in its place; a place 1 off the middle of a face is 1 from its surface. */
static void a_block(void **state) {
    struct fluid_run run;
    const char *entry =
        "shapes: [{name: block, vertices: [-4,-3,-2, 4,-3,-2, -4,3,-2, 4,3,-2, -4,-3,2, 4,-3,2,"
        " -4,3,2, 4,3,2], rounding: 0.25, size: drawn";
    const double mass = 2 * 192, edge[3] = {8, 6, 4};
    if (cube_make(&run, *state, entry)) {
        double turn[9], moment[3], displaced[3];
        const struct rigid_inertia inertia = rigid_bodies_inertia(run.context, NULL, body_of(&run));
        turn_make(turn);
        assert_true(inertia.body && inertia.moves && inertia.turns);
        assert_near(inertia.mass, mass, 1e-9 * mass);
        assert_near(inertia.displaced, fluid_density * 192, 1e-9 * mass);
        for (int d = 0; d < 3; d++) {
            int next = (d + 1) % 3, last = (d + 2) % 3;
            double square = (edge[next] * edge[next] + edge[last] * edge[last]) / 12;
            moment[d] = mass * square;
            displaced[d] = inertia.displaced * square;
        }
        tensor_is(inertia.own, turn, moment, 1e-9);
        tensor_is(inertia.fluid, turn, displaced, 1e-9);
        for (int d = 0; d < 3; d++) {
            double own[3] = {0}, arm[3], wanted[3], distance;
            own[d] = 0.5 * edge[d] + 1;
            rotor_turn(turn, own, wanted);
            memcpy(arm, wanted, sizeof arm);
            rigid_bodies_carrier(run.context, member_of(&run, 0), arm, &distance);
            assert_near(distance, 1, 1e-9);
            for (int c = 0; c < 3; c++)
                assert_near(arm[c], wanted[c], 1e-9);
        }
        motions_go_there_and_back(&run, &inertia);
    }
    fluid_run_free(&run);
    team_finish(*state);
}

/* Two spheres of radius 3 that touch: 2/5 m r^2 each, and m r^2 more across their line; a place 1 off a sphere is 1 from its surface. */
static void two_spheres(void **state) {
    struct fluid_run run;
    const char *entry =
        "clumps: [{name: two, spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}]";
    const double r = 3, mass = 2 * 2 * 4.0 / 3 * M_PI * r * r * r, axial = 0.4 * r * r, across = 1.4 * r * r;
    if (cube_make(&run, *state, entry)) {
        double turn[9], line[3], along = 0;
        const double part = fluid_density / 2;
        const struct rigid_inertia inertia = rigid_bodies_inertia(run.context, NULL, body_of(&run));
        turn_make(turn);
        assert_near(inertia.mass, mass, 1e-4 * mass);
        assert_near(inertia.displaced, part * mass, 1e-4 * mass);
        tensor_is(inertia.own, turn, (double[3]){mass * axial, mass * across, mass * across}, 1e-4);
        tensor_is(inertia.fluid, turn,
                  (double[3]){part * mass * axial, part * mass * across, part * mass * across}, 1e-4);
        rotor_turn(turn, (double[3]){r, 0, 0}, line);
        for (size_t k = 0; k < 2; k++) {
            double arm[3] = {0, 0, 4}, distance, side = 0;
            rigid_bodies_carrier(run.context, member_of(&run, k), arm, &distance);
            assert_near(distance, 1, 1e-12);
            arm[2] -= 4;
            for (int d = 0; d < 3; d++)
                side += arm[d] * line[d] / (r * r);
            for (int d = 0; d < 3; d++)
                assert_near(arm[d], side * line[d], 1e-9);
            assert_near(fabs(side), 1, 1e-9);
            along += side;
        }
        assert_near(along, 0, 1e-9);
        motions_go_there_and_back(&run, &inertia);
    }
    fluid_run_free(&run);
    team_finish(*state);
}

/* A disc of radius 4 in two dimensions, in a group that turns by 0.02; `more`: sections of the scene. */
static bool disc_make(struct fluid_run *run, struct team *team, const char *more) {
    char text[TEXT_MAX];
    snprintf(text, sizeof text,
             "units: none\nthreads: 1\n"
             "box: {lower: [0, 0, 0], upper: [24, 16, 0], dimension: 2, periodic: true}\n"
             "contact: {law: hertz}\nmaterials: [{name: glass, density: 2, young: 1000, poisson: 0.3}]\n"
             "material_pairs: [{restitution: 0.2, friction: 0.3}]\n"
             "particles: {from: single, position: [12.3, 8.4, 0], radius: 4%s\n"
             "step: {dt: 0.01, count: 1, force: true}\n"
             "fluid: {spacing: 1, density: %g, viscosity: 0.2, grains: {motion: free, coupling: rigid}}\n",
             more, fluid_density);
    return fluid_run_begin(run, team, text, false);
}

/* As a grain: 2/5 m r^2 of a sphere, and the fluid of a disc, m r^2 / 2; a torque for a time changes the spin by T t / I; its force is that of its contacts. */
static void a_disc(void **state) {
    struct fluid_run run;
    const double mass = 2 * 4.0 / 3 * M_PI * 64, displaced = fluid_density * M_PI * 16;
    const double torque[3] = {0, 0, 0.6}, motion[6] = {0.1, 0.2, 0, 0, 0, -0.4};
    if (disc_make(&run, *state, "}")) {
        double change[3], found[6], on[6];
        struct particles *p = run.context->particles;
        struct kind_span span = rigid_bodies_span(run.context);
        size_t i = span.first;
        assert_int_equal(span.end - span.first, 1);
        const struct rigid_inertia inertia = rigid_bodies_inertia(run.context, NULL, i);
        assert_true(!inertia.body && inertia.moves && inertia.turns && !rigid_bodies_member(p, i));
        assert_near(inertia.mass, mass, 1e-9 * mass);
        assert_near(inertia.displaced, displaced, 1e-9 * mass);
        for (int k = 0; k < 6; k++) {
            assert_near(inertia.own[k], k < 3 ? 0.4 * mass * 16 : 0, 1e-9 * mass);
            assert_near(inertia.fluid[k], k < 3 ? 0.5 * displaced * 16 : 0, 1e-9 * mass);
        }
        rigid_bodies_turn(run.context, i, torque, 2, change);
        assert_near(change[2], 2 * 0.6 / inertia.own[2], 1e-12);
        rigid_bodies_set(run.context, i, motion);
        rigid_bodies_motion(run.context, i, found);
        for (int d = 0; d < 6; d++)
            assert_near(found[d], motion[d], 1e-15);
        double *force = p->force + i * (size_t)p->force_stride;
        for (int d = 0; d < 7; d++)
            force[d] = d;
        rigid_bodies_contact(run.context, i, on);
        for (int d = 0; d < 6; d++)
            assert_near(on[d], d < 3 ? d : d + 1, 0);
    }
    fluid_run_free(&run);
    team_finish(*state);
}

/* As a body of one sphere, whose section is counted: the same fluid within a thousandth. Its group turns it: it has that motion, and does not move by itself. */
static void a_disc_as_a_body(void **state) {
    struct fluid_run run;
    const double displaced = fluid_density * M_PI * 16;
    const char *more = ", group: turned}\ngroups: [{name: turned, motion: moving, omega: [0, 0, 0.02]}]\n"
                       "bodies: {clumps: [{name: one, spheres: [{centre: [0, 0, 0], radius: 1}]}]}";
    if (disc_make(&run, *state, more)) {
        double found[6];
        double(*section)[2] = rigid_bodies_sections(run.context);
        const struct rigid_inertia inertia =
            rigid_bodies_inertia(run.context, (const double(*)[2])section, body_of(&run));
        assert_true(inertia.body && !inertia.moves);
        assert_near(inertia.displaced / displaced, 1, 1e-3);
        assert_near(inertia.fluid[2] / (0.5 * displaced * 16), 1, 1e-3);
        rigid_bodies_given(run.context, body_of(&run), found);
        for (int d = 0; d < 6; d++)
            assert_near(found[d], d == 5 ? 0.02 : 0, 1e-15);
        memory_free(section);
    }
    fluid_run_free(&run);
    team_finish(*state);
}

TEAM_MAIN(fluid_rigid_bodies, team_case(a_block), team_case(two_spheres), team_case(a_disc),
          team_case(a_disc_as_a_body))
