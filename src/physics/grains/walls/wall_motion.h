/* SPDX-License-Identifier: BSD-3-Clause */
/* How a wall moves: rigid transforms as functions of time, in closed form, and the velocity of the step
 * between two times. Nothing is accumulated but the displacement of a servo, which the owner of the wall
 * keeps.
 *
 * A motion k maps points by M_k(t); the wall's motions together by M = M_n ... M_2 M_1, the first applied
 * first. A motion is frozen outside of its span: its time is cut to [start, stop]. Points are box-relative.
 * */
#ifndef SCREE_WALLS_WALL_MOTION_H
#define SCREE_WALLS_WALL_MOTION_H

#include "physics/grains/laws/law_kernel.h"
#include "physics/grains/walls/wall.h"

/* x -> R x + t, R row by row. */
struct wall_transform {
    double rotation[9];
    double translation[3];
};

/* A field of rigid velocities: v(x) = velocity + omega x x. */
struct wall_twist {
    struct law_vector velocity, omega;
};

struct wall_transform wall_transform_identity(void);
/* A displacement; and a turn by `angle` (rad) about an axis of length 1 through a point. */
struct wall_transform wall_transform_shift(struct law_vector by);
struct wall_transform wall_transform_turn(struct law_vector axis, double angle, struct law_vector point);
/* First b, then a. */
struct wall_transform wall_transform_compose(const struct wall_transform *a, const struct wall_transform *b);
struct wall_transform wall_transform_inverse(const struct wall_transform *a);
/* True if no entry of R differs by more than 1e-9, and none of t by more than 1e-9 of 1 + its size. */
bool wall_transform_near(const struct wall_transform *a, const struct wall_transform *b);

static inline struct law_vector wall_turn(const double r[9], struct law_vector x) {
    return (struct law_vector){r[0] * x.x + r[1] * x.y + r[2] * x.z, r[3] * x.x + r[4] * x.y + r[5] * x.z,
                               r[6] * x.x + r[7] * x.y + r[8] * x.z};
}

static inline struct law_vector wall_turn_back(const double r[9], struct law_vector x) {
    return (struct law_vector){r[0] * x.x + r[3] * x.y + r[6] * x.z, r[1] * x.x + r[4] * x.y + r[7] * x.z,
                               r[2] * x.x + r[5] * x.y + r[8] * x.z};
}

static inline struct law_vector wall_vector(const double a[3]) {
    return (struct law_vector){a[0], a[1], a[2]};
}

/* R x + t, and the opposite. */
static inline struct law_vector wall_transform_point(const struct wall_transform *a, struct law_vector x) {
    return law_add(wall_turn(a->rotation, x), 1.0, wall_vector(a->translation));
}
static inline struct law_vector wall_transform_back(const struct wall_transform *a, struct law_vector x) {
    return wall_turn_back(a->rotation, law_add(x, -1.0, wall_vector(a->translation)));
}

/* Velocity at a point. */
static inline struct law_vector wall_twist_at(const struct wall_twist *twist, struct law_vector x) {
    return law_add(twist->velocity, 1.0, law_cross(twist->omega, x));
}

/* The motions of one wall. */
struct wall_motions;

/* Reads tables and checks the motions of `options`; `origin` is the box's lower corner. Fails (user) on a bad
 * table (file and line), a direction of no length, a servo without a force to reach, more than one servo, or
 * a span that ends before it starts. One thread. Destroy frees and nulls. */
bool wall_motions_create(struct wall_motions **motions, const struct wall_options *options,
                         const double origin[3], struct error *error);
/* In two dimensions: fails (user; file and line) on a table that moves along z or turns about x or y. */
bool wall_motions_flat(const struct wall_motions *motions, struct error *error);
void wall_motions_destroy(struct wall_motions **motions);

/* M(t), with the servo displaced by servo_offset. */
struct wall_transform wall_motions_place(const struct wall_motions *motions, double t, double servo_offset);

/* The mean velocity of the step from t to t + dt, as a field at the half step; servo_offset is that of the
 * half step, servo_speed the servo's speed. Exact for each single motion. */
struct wall_twist wall_motions_twist(const struct wall_motions *motions, double t, double dt,
                                     double servo_offset, double servo_speed);

/* The same of the surface alone, to be added; 0 without a motion of the surface. */
struct wall_twist wall_motions_surface(const struct wall_motions *motions, double t, double dt,
                                       double servo_offset);

/* True if the surface has a motion of its own. */
bool wall_motions_slides(const struct wall_motions *motions);

bool wall_motions_has_servo(const struct wall_motions *motions);
/* Speed along the servo's direction, which the motions behind it turn, for the step that starts at t, from
 * what the particles do to the wall; 0 without a servo or outside of its span. Without a gain of the user's the
 * speed is the force error over twice the impedance of the grains that touch the wall, speed_max while none
 * does. */
double wall_motions_servo_speed(const struct wall_motions *motions, double t, const struct wall_push *push);

/* The speed that the servo takes: the speed of the step before, plus a part of the difference to
 * wall_motions_servo_speed. With the whole difference the speed would change sign with each step as soon as the
 * contacts' dampers answer the speed with more than the force sought. With a gain of the user's the part is a
 * fiftieth, and the dampers may answer with a hundred times that force. Else the part is a tenth: the dampers
 * answer with at most the force sought, as the speed follows from the impedance of the same contacts. */
double wall_motions_servo_follow(const struct wall_motions *motions, double t, const struct wall_push *push,
                                 double before);

/* The unit of the impedance of a wall with a servo: a power of two, a millionth of the least impedance that
 * makes a difference. 0 without a servo, or where the user gives the gain. */
double wall_motions_servo_unit(const struct wall_motions *motions);

/* The point about which the wall turns first (box-relative); false if the wall never turns. */
bool wall_motions_pivot(const struct wall_motions *motions, struct law_vector *point);

#endif
