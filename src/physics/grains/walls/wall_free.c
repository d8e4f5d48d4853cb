/* SPDX-License-Identifier: BSD-3-Clause */
/* The motion of a free wall. Read wall_free.h first. */
#include "physics/grains/walls/wall_free.h"
#include "base/moments.h"
#include "base/rotor.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static void put(double out[3], struct law_vector v) {
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
}

static bool single(const struct wall_free *free) {
    return free->options.freedom == WALL_FREE_ALONG || free->options.freedom == WALL_FREE_ABOUT;
}

/* What a rate of the one freedom moves: mass, or inertia about the axis. */
static double inertia_of(const struct wall_free *free) {
    return free->options.freedom == WALL_FREE_ALONG ? free->mass : free->inertia[0];
}

static struct law_vector direction_of(const struct wall_free *free) {
    return wall_vector(free->options.direction);
}

struct wall_transform wall_free_place(const struct wall_free *free) {
    const struct wall_free_state *state = &free->state;
    struct wall_transform place = wall_transform_identity();
    const double back[4] = {free->axes[0], -free->axes[1], -free->axes[2], -free->axes[3]};
    double turn[4];
    if (free->options.freedom == WALL_FREE_ABOUT)
        return wall_transform_turn(direction_of(free), state->way, wall_vector(free->options.point));
    if (free->options.freedom == WALL_FREE_ALONG)
        return wall_transform_shift(law_scale(state->way, direction_of(free)));
    struct law_vector moved = law_add(free->centre, 1.0, wall_vector(state->place));
    if (free->options.freedom == WALL_FREE_ALL) {
        rotor_product(state->turn, back, turn);
        rotor_matrix(turn, place.rotation);
    }
    put(place.translation, law_add(moved, -1.0, wall_turn(place.rotation, free->centre)));
    return place;
}

/* The centre of mass now. */
static struct law_vector centre_now(const struct wall_free *free) {
    struct wall_transform place = wall_free_place(free);
    return wall_transform_point(&place, free->centre);
}

struct law_vector wall_free_centre(const struct wall_free *free, const struct wall_transform *base) {
    if (free->options.freedom != WALL_FREE_ABOUT)
        return free->rest;
    return wall_transform_back(base, wall_vector(free->options.point));
}

struct wall_twist wall_free_twist(const struct wall_free *free) {
    const struct wall_free_state *state = &free->state;
    struct law_vector along = law_scale(state->rate, direction_of(free));
    if (free->options.freedom == WALL_FREE_ALONG)
        return (struct wall_twist){.velocity = along};
    if (free->options.freedom == WALL_FREE_ABOUT)
        return (struct wall_twist){.velocity = law_cross(wall_vector(free->options.point), along),
                                   .omega = along};
    struct law_vector omega = wall_vector(state->omega), centre = centre_now(free);
    return (struct wall_twist){
        .velocity = law_add(wall_vector(state->velocity), 1.0, law_cross(centre, omega)), .omega = omega};
}

/* Angular velocity of a wall that turns freely, for an angular momentum. */
static void omega_of(const struct wall_free *free, const double spin[3], double omega[3]) {
    double turn[9];
    rotor_matrix(free->state.turn, turn);
    rotor_velocity(turn, spin, free->inertia, omega);
}

/* The velocities that the options give. */
static void given_of(const struct wall_free_options *options, double given[WALL_FREE_GIVEN]) {
    for (int d = 0; d < 3; d++) {
        given[WALL_FREE_VELOCITY + d] = options->velocity_given ? options->velocity[d] : NAN;
        given[WALL_FREE_OMEGA + d] = options->omega_given ? options->omega[d] : NAN;
    }
    given[WALL_FREE_SPEED] = options->speed;
}

/* True if one of the numbers is given, and is not what it was. */
static bool given_anew(const double *now, const double *before, int count) {
    bool anew = false;
    for (int k = 0; k < count; k++)
        anew = anew || (!isnan(now[k]) && now[k] != before[k]);
    return anew;
}

static void take_velocity(struct wall_free *free) {
    const double speed = free->options.speed;
    free->state.rate = single(free) && !isnan(speed) ? speed : 0.0;
    if (!single(free))
        memcpy(free->state.velocity, free->options.velocity, sizeof free->state.velocity);
}

static void take_omega(struct wall_free *free) {
    struct wall_free_state *state = &free->state;
    double turn[9], own[3];
    memcpy(state->omega, free->options.omega, sizeof state->omega);
    rotor_matrix(state->turn, turn);
    rotor_turn_back(turn, state->omega, own);
    for (int d = 0; d < 3; d++)
        own[d] *= free->inertia[d];
    rotor_turn(turn, own, state->spin);
}

void wall_free_begin(struct wall_free *free, const struct wall_transform *base) {
    struct wall_free_state *state = &free->state;
    const bool fresh = state->known == 0.0, turns = free->options.freedom == WALL_FREE_ALL;
    const int first = single(free) ? WALL_FREE_SPEED : WALL_FREE_VELOCITY;
    double given[WALL_FREE_GIVEN];
    free->centre = wall_transform_point(base, free->rest);
    moments_quaternion(base->rotation, free->axes);
    rotor_product(free->axes, free->axes_rest, free->axes);
    given_of(&free->options, given);
    free->new_velocity = fresh || given_anew(given + first, state->given + first, single(free) ? 1 : 3);
    free->new_omega =
        turns && (fresh || given_anew(given + WALL_FREE_OMEGA, state->given + WALL_FREE_OMEGA, 3));
    if (fresh) {
        *state = (struct wall_free_state){.known = 0.0};
        memcpy(state->turn, free->axes, sizeof state->turn);
    }
    memcpy(state->given, given, sizeof given);
    if (free->new_velocity)
        take_velocity(free);
    if (free->new_omega)
        take_omega(free);
}

/* Force or torque along the one freedom, without the damper. */
static double drive(const struct wall_free *free, const struct wall_push *push, const double gravity[3]) {
    struct law_vector direction = direction_of(free), weight = law_scale(free->mass, wall_vector(gravity));
    double rest = free->options.load - free->options.spring * free->state.way;
    if (free->options.freedom == WALL_FREE_ALONG)
        return law_dot(law_add(weight, 1.0, wall_vector(push->force)), direction) + rest;
    struct law_vector arm = law_add(centre_now(free), -1.0, wall_vector(free->options.point));
    return law_dot(law_add(law_cross(arm, weight), 1.0, wall_vector(push->torque)), direction) + rest;
}

/* Adds `time` x acceleration to the velocity, and to the angular momentum, of a wall of several freedoms. */
static void push_along(const struct wall_free *free, const struct wall_push *push, const double gravity[3],
                       double time, double velocity[3]) {
    for (int d = 0; d < (free->flat ? 2 : 3); d++)
        velocity[d] += time * (push->force[d] / free->mass + gravity[d]);
}

static void push_round(const struct wall_free *free, const struct wall_push *push, double time,
                       double spin[3]) {
    for (int d = free->flat ? 2 : 0; free->options.freedom == WALL_FREE_ALL && d < 3; d++)
        spin[d] += time * push->torque[d];
}

/* One step of the one freedom: (1 + a) q'+ = (1 - a) q'- + dt Q / M with a = dt c / 2 M. */
static void advance_single(struct wall_free *free, const struct wall_push *push, const double gravity[3],
                           double dt) {
    struct wall_free_state *state = &free->state;
    double inertia = inertia_of(free), damper = free->options.damper, a = 0.5 * dt * damper / inertia;
    double before = state->rate;
    state->rate = ((1.0 - a) * before + dt * drive(free, push, gravity) / inertia) / (1.0 + a);
    double mean = 0.5 * (before + state->rate);
    state->taken += dt * damper * mean * mean;
    state->way += dt * state->rate;
}

void wall_free_advance(struct wall_free *free, const struct wall_push *push, const double gravity[3],
                       double dt) {
    struct wall_free_state *state = &free->state;
    double before[3], after[3];
    state->known = 1.0;
    free->new_velocity = free->new_omega = false;
    if (single(free)) {
        advance_single(free, push, gravity, dt);
        return;
    }
    push_along(free, push, gravity, dt, state->velocity);
    push_round(free, push, dt, state->spin);
    for (int d = 0; d < 3; d++)
        state->place[d] += dt * state->velocity[d];
    if (free->options.freedom == WALL_FREE_SHIFT)
        return;
    omega_of(free, state->spin, before);
    rotor_advance(state->turn, state->spin, free->inertia, dt);
    omega_of(free, state->spin, after);
    for (int d = 0; d < 3; d++)
        state->omega[d] = 0.5 * (before[d] + after[d]);
}

void wall_free_stagger(struct wall_free *free, const struct wall_push *push, const double gravity[3],
                       double dt, double step) {
    struct wall_free_state *state = &free->state;
    const double back = 0.5 * (free->new_velocity ? step : dt);
    const double turn_back = 0.5 * (free->new_omega ? step : dt);
    state->known = 1.0;
    free->new_velocity = free->new_omega = false;
    if (back != 0.0 && single(free))
        state->rate -=
            back * (drive(free, push, gravity) - free->options.damper * state->rate) / inertia_of(free);
    else if (back != 0.0)
        push_along(free, push, gravity, -back, state->velocity);
    if (turn_back == 0.0 || free->options.freedom != WALL_FREE_ALL)
        return;
    push_round(free, push, -turn_back, state->spin);
    omega_of(free, state->spin, state->omega);
}

/* The way of the one freedom at the full step. */
static void full_single(struct wall_free *free, const struct wall_push *push, const double gravity[3],
                        double half) {
    const struct wall_free_options *options = &free->options;
    struct wall_free_full *full = &free->full;
    double inertia = inertia_of(free), way = free->state.way;
    double rate = (free->state.rate + half * drive(free, push, gravity) / inertia) /
                  (1.0 + half * options->damper / inertia);
    bool along = options->freedom == WALL_FREE_ALONG;
    put(full->velocity, law_scale(along ? rate : 0.0, direction_of(free)));
    put(full->omega, law_scale(along ? 0.0 : rate, direction_of(free)));
    full->motion = 0.5 * inertia * rate * rate + 0.5 * options->spring * way * way;
    full->energy = full->motion - options->load * way;
    full->taken = free->state.taken + half * options->damper * rate * rate;
}

void wall_free_find_full(struct wall_free *free, const struct wall_push *push, const double gravity[3],
                         double dt) {
    struct wall_free_full *full = &free->full;
    *full = (struct wall_free_full){.taken = free->state.taken};
    if (single(free)) {
        full_single(free, push, gravity, 0.5 * dt);
    } else {
        double spin[3];
        memcpy(full->velocity, free->state.velocity, sizeof full->velocity);
        memcpy(spin, free->state.spin, sizeof spin);
        push_along(free, push, gravity, 0.5 * dt, full->velocity);
        push_round(free, push, 0.5 * dt, spin);
        if (free->options.freedom == WALL_FREE_ALL)
            omega_of(free, spin, full->omega);
        for (int d = 0; d < 3; d++)
            full->motion +=
                0.5 * free->mass * full->velocity[d] * full->velocity[d] + 0.5 * spin[d] * full->omega[d];
        full->energy = full->motion;
    }
    struct law_vector moved = law_add(centre_now(free), -1.0, free->centre);
    full->energy -= free->mass * law_dot(wall_vector(gravity), moved);
}

double wall_free_yield(const struct wall_free *free, struct law_vector at, struct law_vector along) {
    struct law_vector direction = direction_of(free);
    double part, torque[3], omega[3];
    switch (free->options.freedom) {
    case WALL_FREE_SHIFT:
        return 1.0 / free->mass;
    case WALL_FREE_ALONG:
        part = law_dot(along, direction);
        return part * part / free->mass;
    case WALL_FREE_ABOUT:
        part = law_dot(law_cross(law_add(at, -1.0, wall_vector(free->options.point)), along), direction);
        return part * part / free->inertia[0];
    case WALL_FREE_ALL:
        break;
    }
    put(torque, law_cross(law_add(at, -1.0, centre_now(free)), along));
    for (int d = 0; d < 2 && free->flat; d++)
        torque[d] = 0.0;
    omega_of(free, torque, omega);
    return 1.0 / free->mass + torque[0] * omega[0] + torque[1] * omega[1] + torque[2] * omega[2];
}

double wall_free_turn_yield(const struct wall_free *free) {
    bool turns = free->options.freedom == WALL_FREE_ALL || free->options.freedom == WALL_FREE_ABOUT;
    return turns ? 1.0 / free->inertia[0] : 0.0;
}

/* The vector from the centre of mass to a place, or from the axis. */
static struct law_vector arm_of(const struct wall_free *free, struct law_vector at) {
    if (free->options.freedom != WALL_FREE_ABOUT)
        return law_add(at, -1.0, centre_now(free));
    return law_project(law_add(at, -1.0, wall_vector(free->options.point)), direction_of(free));
}

/* At a distance from the centre of mass or the axis. */
static double yield_at(const struct wall_free *free, double far) {
    double push = free->options.freedom == WALL_FREE_ABOUT ? 0.0 : 1.0 / free->mass;
    double turn = wall_free_turn_yield(free);
    return turn > 0.0 ? push + far * far * turn : push;
}

double wall_free_yield_worst(const struct wall_free *free, struct law_vector at) {
    struct law_vector arm = arm_of(free, at);
    return yield_at(free, sqrt(law_dot(arm, arm)));
}

double wall_free_yield_most(const struct wall_free *free) {
    struct law_vector arm = arm_of(free, free->centre);
    bool about = free->options.freedom == WALL_FREE_ABOUT;
    return yield_at(free, free->extent + (about ? sqrt(law_dot(arm, arm)) : 0.0));
}

double wall_free_yield_spread(const struct wall_free *free) {
    return free->options.freedom == WALL_FREE_ABOUT ? wall_free_yield_most(free) / 3.0 : 1.0 / free->mass;
}

void wall_free_describe(const struct wall_free *free, char *text, size_t room) {
    const double *inertia = free->inertia;
    switch (free->options.freedom) {
    case WALL_FREE_SHIFT:
        snprintf(text, room, "  free without turning, mass %.4g", free->mass);
        return;
    case WALL_FREE_ALONG:
        snprintf(text, room, "  free along its direction, mass %.4g", free->mass);
        return;
    case WALL_FREE_ABOUT:
        snprintf(text, room, "  free about its axis, mass %.4g, inertia %.4g", free->mass, inertia[0]);
        return;
    case WALL_FREE_ALL:
        snprintf(text, room, "  free, mass %.4g, inertia %.4g %.4g %.4g", free->mass, inertia[0], inertia[1],
                 inertia[2]);
        return;
    }
}
