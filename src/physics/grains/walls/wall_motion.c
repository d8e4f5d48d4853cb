/* SPDX-License-Identifier: BSD-3-Clause */
/* The motions of a wall, each in closed form. Read wall_motion.h first. */
#include "physics/grains/walls/wall_motion.h"
#include "base/numbers.h"
#include "base/memory.h"
#include <string.h>

enum { TABLE_COLUMNS = 7 };

struct wall_motions {
    int count;
    struct wall_motion motion[WALL_MOTIONS_MAX]; /* points box-relative, directions of length 1 */
    struct numbers table[WALL_MOTIONS_MAX];      /* TABLE: rows t x y z a b c */
};

struct wall_transform wall_transform_identity(void) {
    return (struct wall_transform){.rotation = {1, 0, 0, 0, 1, 0, 0, 0, 1}};
}

struct wall_transform wall_transform_compose(const struct wall_transform *a, const struct wall_transform *b) {
    struct wall_transform c;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            c.rotation[3 * i + j] = a->rotation[3 * i] * b->rotation[j] +
                                    a->rotation[3 * i + 1] * b->rotation[3 + j] +
                                    a->rotation[3 * i + 2] * b->rotation[6 + j];
    struct law_vector t = wall_transform_point(a, wall_vector(b->translation));
    memcpy(c.translation, &t, sizeof c.translation);
    return c;
}

struct wall_transform wall_transform_inverse(const struct wall_transform *a) {
    struct wall_transform c;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            c.rotation[3 * i + j] = a->rotation[3 * j + i];
    struct law_vector t = law_scale(-1.0, wall_turn(c.rotation, wall_vector(a->translation)));
    memcpy(c.translation, &t, sizeof c.translation);
    return c;
}

bool wall_transform_near(const struct wall_transform *a, const struct wall_transform *b) {
    for (int k = 0; k < 9; k++)
        if (!(fabs(a->rotation[k] - b->rotation[k]) <= 1e-9))
            return false;
    for (int k = 0; k < 3; k++)
        if (!(fabs(a->translation[k] - b->translation[k]) <= 1e-9 * (1.0 + fabs(b->translation[k]))))
            return false;
    return true;
}

/* A displacement as a transform. */
struct wall_transform wall_transform_shift(struct law_vector d) {
    struct wall_transform m = wall_transform_identity();
    memcpy(m.translation, &d, sizeof m.translation);
    return m;
}

/* Turns by `angle` about the axis `n` (length 1) through `point` (Rodrigues' formula). */
struct wall_transform wall_transform_turn(struct law_vector n, double angle, struct law_vector point) {
    double c = cos(angle), s = sin(angle), half = sin(0.5 * angle), d = 2.0 * half * half;
    struct wall_transform m = {
        .rotation = {c + d * n.x * n.x, d * n.x * n.y - s * n.z, d * n.x * n.z + s * n.y,
                     d * n.y * n.x + s * n.z, c + d * n.y * n.y, d * n.y * n.z - s * n.x,
                     d * n.z * n.x - s * n.y, d * n.z * n.y + s * n.x, c + d * n.z * n.z}};
    struct law_vector t = law_add(point, -1.0, wall_turn(m.rotation, point));
    memcpy(m.translation, &t, sizeof m.translation);
    return m;
}

/* The time of a motion: t cut to its span. */
static double motion_time(const struct wall_motion *motion, double t) {
    t = t < motion->stop ? t : motion->stop;
    return t > motion->start ? t : motion->start;
}

/* Displacement and rotation vector at time t. */
static void table_value(const struct numbers *table, double t, struct law_vector value[2]) {
    double number[TABLE_COLUMNS - 1];
    numbers_at(table, t, number);
    value[0] = wall_vector(number);
    value[1] = wall_vector(number + 3);
}

/* The part of a step from t on that lies within the span of a motion, as time; no digits are lost where it is
 * the whole step. */
static double motion_duration(const struct wall_motion *motion, double t, double dt) {
    if (t >= motion->start && t + dt <= motion->stop)
        return dt;
    return motion_time(motion, t + dt) - motion_time(motion, t);
}

/* Mean rates of displacement and rotation vector in a step of length dt, of which the motion takes `duration`
 * from t on; by slopes, as differences of values would lose digits. */
static void table_rate(const struct numbers *table, double t, double duration, double dt,
                       struct law_vector rate[2]) {
    double end = t + duration;
    rate[0] = rate[1] = (struct law_vector){0.0, 0.0, 0.0};
    for (size_t row = numbers_row(table, t); row + 1 < table->rows; row++) {
        const double *a = table->value + row * TABLE_COLUMNS, *b = a + TABLE_COLUMNS;
        if (a[0] >= end)
            break;
        bool whole = a[0] <= t && end <= b[0];
        double part = whole ? duration : (end < b[0] ? end : b[0]) - (t > a[0] ? t : a[0]);
        double weight = part > 0.0 ? part / dt / (b[0] - a[0]) : 0.0;
        for (int k = 0; k < 2; k++) {
            struct law_vector step = law_add(wall_vector(b + 1 + 3 * k), -1.0, wall_vector(a + 1 + 3 * k));
            rate[k] = law_add(rate[k], weight, step);
        }
    }
}

/* The angular velocity of a rotation vector that changes at a rate: J(v) dv/dt with J = s/a I + (1 - s/a) nn
 * + (1 - c)/a [n], a = |v| (left Jacobian of the rotation group). */
static struct law_vector vector_spin(struct law_vector v, struct law_vector rate) {
    double angle = sqrt(law_dot(v, v));
    if (angle < 1e-12)
        return rate;
    struct law_vector n = law_scale(1.0 / angle, v);
    double s = sin(angle) / angle, half = sin(0.5 * angle);
    struct law_vector spin = law_scale(s, rate);
    spin = law_add(spin, (1.0 - s) * law_dot(n, rate), n);
    return law_add(spin, 2.0 * half * half / angle, law_cross(n, rate));
}

/* amplitude x sin(2 pi f t + phase) at t; and its mean rate in a step (see table_rate). */
static double wave_value(const struct wall_motion *motion, double t) {
    return motion->amplitude * sin(2.0 * M_PI * motion->frequency * t + motion->phase);
}

static double wave_rate(const struct wall_motion *motion, double t, double duration, double dt) {
    double turn = M_PI * motion->frequency, middle = turn * (2.0 * t + duration) + motion->phase;
    return motion->amplitude * 2.0 * cos(middle) * sin(turn * duration) / dt;
}

static struct wall_transform motion_place(const struct wall_motions *motions, int k, double t, double servo) {
    const struct wall_motion *motion = &motions->motion[k];
    struct law_vector axis = wall_vector(motion->direction), point = wall_vector(motion->point), value[2];
    if (motion->surface)
        return wall_transform_identity();
    t = motion_time(motion, t);
    switch (motion->kind) {
    case WALL_TRANSLATE:
        return wall_transform_shift(law_scale(t - motion->start, wall_vector(motion->velocity)));
    case WALL_ROTATE:
        return wall_transform_turn(axis, motion->rate * (t - motion->start), point);
    case WALL_OSCILLATE:
        return wall_transform_shift(law_scale(wave_value(motion, t), axis));
    case WALL_OSCILLATE_ROTATION:
        return wall_transform_turn(axis, wave_value(motion, t), point);
    case WALL_SERVO:
        return wall_transform_shift(law_scale(servo, axis));
    case WALL_TABLE:
        break;
    }
    table_value(&motions->table[k], t, value);
    double angle = sqrt(law_dot(value[1], value[1]));
    axis = angle > 0.0 ? law_scale(1.0 / angle, value[1]) : (struct law_vector){0.0, 0.0, 1.0};
    struct wall_transform turn = wall_transform_turn(axis, angle, point),
                          shift = wall_transform_shift(value[0]);
    return wall_transform_compose(&shift, &turn);
}

/* The twist of a turn about a point that itself travels. */
static struct wall_twist twist_about(struct law_vector omega, struct law_vector point,
                                     struct law_vector velocity) {
    return (struct wall_twist){.velocity = law_add(velocity, 1.0, law_cross(point, omega)), .omega = omega};
}

static struct wall_twist motion_twist(const struct wall_motions *motions, int k, double t, double dt,
                                      double servo) {
    const struct wall_motion *motion = &motions->motion[k];
    struct law_vector axis = wall_vector(motion->direction), point = wall_vector(motion->point);
    struct law_vector rest = {0.0, 0.0, 0.0}, value[2], rate[2];
    double begin = motion_time(motion, t), duration = motion_duration(motion, t, dt), active = duration / dt;
    switch (motion->kind) {
    case WALL_TRANSLATE:
        return (struct wall_twist){.velocity = law_scale(active, wall_vector(motion->velocity))};
    case WALL_ROTATE:
        return twist_about(law_scale(active * motion->rate, axis), point, rest);
    case WALL_OSCILLATE:
        return (struct wall_twist){.velocity = law_scale(wave_rate(motion, begin, duration, dt), axis)};
    case WALL_OSCILLATE_ROTATION:
        return twist_about(law_scale(wave_rate(motion, begin, duration, dt), axis), point, rest);
    case WALL_SERVO:
        return (struct wall_twist){.velocity = law_scale(servo, axis)};
    case WALL_TABLE:
        break;
    }
    table_value(&motions->table[k], begin + 0.5 * duration, value);
    table_rate(&motions->table[k], begin, duration, dt, rate);
    return twist_about(vector_spin(value[1], rate[1]), law_add(point, 1.0, value[0]), rate[0]);
}

struct wall_transform wall_motions_place(const struct wall_motions *motions, double t, double servo_offset) {
    struct wall_transform all = wall_transform_identity();
    for (int k = 0; k < motions->count; k++) {
        struct wall_transform one = motion_place(motions, k, t, servo_offset);
        all = wall_transform_compose(&one, &all);
    }
    return all;
}

/* The twist of the motions of the wall, or of those of its surface. */
static struct wall_twist motions_twist(const struct wall_motions *motions, bool surface, double t, double dt,
                                       double servo_offset, double servo_speed) {
    struct wall_twist all = {0};
    for (int k = 0; k < motions->count; k++) {
        struct wall_transform half = motion_place(motions, k, t + 0.5 * dt, servo_offset);
        struct law_vector omega = wall_turn(half.rotation, all.omega);
        struct law_vector velocity = law_add(wall_turn(half.rotation, all.velocity), 1.0,
                                             law_cross(wall_vector(half.translation), omega));
        struct wall_twist one = {0};
        if (motions->motion[k].surface == surface)
            one = motion_twist(motions, k, t, dt, servo_speed);
        all.omega = law_add(omega, 1.0, one.omega);
        all.velocity = law_add(velocity, 1.0, one.velocity);
    }
    return all;
}

struct wall_twist wall_motions_twist(const struct wall_motions *motions, double t, double dt,
                                     double servo_offset, double servo_speed) {
    return motions_twist(motions, false, t, dt, servo_offset, servo_speed);
}

struct wall_twist wall_motions_surface(const struct wall_motions *motions, double t, double dt,
                                       double servo_offset) {
    return motions_twist(motions, true, t, dt, servo_offset, 0.0);
}

bool wall_motions_slides(const struct wall_motions *motions) {
    for (int k = 0; k < motions->count; k++)
        if (motions->motion[k].surface)
            return true;
    return false;
}

static int motions_servo(const struct wall_motions *motions) {
    for (int k = 0; k < motions->count; k++)
        if (motions->motion[k].kind == WALL_SERVO)
            return k;
    return -1;
}

bool wall_motions_has_servo(const struct wall_motions *motions) {
    return motions_servo(motions) >= 0;
}

/* The direction of servo k as the motions behind it have turned it at time t. */
static struct law_vector servo_direction(const struct wall_motions *motions, int k, double t) {
    struct law_vector direction = wall_vector(motions->motion[k].direction);
    for (int behind = k + 1; behind < motions->count; behind++) {
        struct wall_transform one = motion_place(motions, behind, t, 0.0);
        direction = wall_turn(one.rotation, direction);
    }
    return direction;
}

/* Outside of its span a motion is frozen. */
static bool servo_stands(const struct wall_motions *motions, int k, double t) {
    return k < 0 || t < motions->motion[k].start || t >= motions->motion[k].stop;
}

double wall_motions_servo_speed(const struct wall_motions *motions, double t, const struct wall_push *push) {
    int k = motions_servo(motions);
    if (servo_stands(motions, k, t))
        return 0.0;
    const struct wall_motion *servo = &motions->motion[k];
    double most = servo->speed_max;
    double error = law_dot(wall_vector(push->force), servo_direction(motions, k, t)) - servo->force;
    double impedance = servo->gain > 0.0 ? fabs(servo->force) / servo->gain : 2.0 * push->impedance;
    if (!(fabs(error) < impedance * most)) /* an impedance of 0, too */
        return error > 0.0 ? most : error < 0.0 ? -most : 0.0;
    return error / impedance;
}

double wall_motions_servo_follow(const struct wall_motions *motions, double t, const struct wall_push *push,
                                 double before) {
    int k = motions_servo(motions);
    if (servo_stands(motions, k, t))
        return 0.0;
    double part = motions->motion[k].gain > 0.0 ? 0.02 : 0.1;
    return before + part * (wall_motions_servo_speed(motions, t, push) - before);
}

double wall_motions_servo_unit(const struct wall_motions *motions) {
    int k = motions_servo(motions);
    if (k < 0 || motions->motion[k].gain > 0.0)
        return 0.0;
    return exp2(ilogb(fabs(motions->motion[k].force) / motions->motion[k].speed_max) - 20);
}

bool wall_motions_pivot(const struct wall_motions *motions, struct law_vector *point) {
    for (int k = 0; k < motions->count; k++) {
        const struct wall_motion *motion = &motions->motion[k];
        if (motion->kind == WALL_ROTATE || motion->kind == WALL_OSCILLATE_ROTATION ||
            motion->kind == WALL_TABLE) {
            *point = wall_vector(motion->point);
            return true;
        }
    }
    return false;
}

/* Brings one motion into the form that the functions above expect. */
static bool motion_prepare(struct wall_motions *motions, int k, const char *name, const double origin[3],
                           struct error *error) {
    struct wall_motion *motion = &motions->motion[k];
    struct law_vector direction = wall_vector(motion->direction);
    double length = sqrt(law_dot(direction, direction));
    bool directed = motion->kind != WALL_TRANSLATE && motion->kind != WALL_TABLE;
    for (int d = 0; d < 3; d++)
        motion->point[d] -= origin[d];
    if (!isfinite(motion->start))
        return error_set(error, ERROR_USER, "wall '%s': the start of motion %d is not finite", name, k + 1);
    if (!(motion->stop >= motion->start))
        return error_set(error, ERROR_USER, "wall '%s': motion %d stops (%g) before it starts (%g)", name,
                         k + 1, motion->stop, motion->start);
    if (directed && !(length > 0.0 && isfinite(length)))
        return error_set(error, ERROR_USER, "wall '%s': the direction of motion %d has no length", name,
                         k + 1);
    for (int d = 0; directed && fabs(length - 1.0) > 1e-15 && d < 3; d++)
        motion->direction[d] /= length;
    if (motion->kind == WALL_TABLE)
        return numbers_read(&motions->table[k], motion->table, TABLE_COLUMNS, error) &&
               numbers_check_times(&motions->table[k], motion->table, "t x y z a b c", error);
    if (motion->kind != WALL_SERVO)
        return true;
    if (motions_servo(motions) != k)
        return error_set(error, ERROR_USER, "wall '%s': motion %d is a second servo; one is allowed", name,
                         k + 1);
    if (motion->force == 0.0 || !isfinite(motion->force) || !(motion->speed_max > 0.0))
        return error_set(error, ERROR_USER,
                         "wall '%s': motion %d: a servo needs a force other than 0 and a speed_max above 0",
                         name, k + 1);
    return true;
}

bool wall_motions_create(struct wall_motions **motions, const struct wall_options *options,
                         const double origin[3], struct error *error) {
    *motions = memory_allocate_zero(1, sizeof **motions, "motions of a wall");
    (*motions)->count = options->motions;
    memcpy((*motions)->motion, options->motion, (size_t)options->motions * sizeof *options->motion);
    for (int k = 0; k < options->motions; k++)
        if (!motion_prepare(*motions, k, options->name, origin, error)) {
            wall_motions_destroy(motions);
            return false;
        }
    return true;
}

bool wall_motions_flat(const struct wall_motions *motions, struct error *error) {
    for (int k = 0; k < motions->count; k++)
        for (size_t row = 0; row < motions->table[k].rows; row++) {
            const double *value = motions->table[k].value + row * TABLE_COLUMNS;
            if (value[3] != 0.0 || value[4] != 0.0 || value[5] != 0.0)
                return error_set(error, ERROR_USER,
                                 "%s:%u: leaves the plane of a two-dimensional scene; allowed: t x y 0 0 0 c",
                                 motions->motion[k].table, motions->table[k].line[row]);
        }
    return true;
}

void wall_motions_destroy(struct wall_motions **motions) {
    if (*motions == NULL)
        return;
    for (int k = 0; k < (*motions)->count; k++)
        numbers_free(&(*motions)->table[k]);
    memory_free(*motions);
    *motions = NULL;
}
