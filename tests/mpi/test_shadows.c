/* SPDX-License-Identifier: BSD-3-Clause */
/* One sphere through the whole box, in 26 directions, with radii up to one and a half subdomains and up to
 * two subdomains a step: after each step every rank has exactly the copies that the rule demands, and the
 * state of a reference sphere that is never synchronised. The skin is 0, so every step is a rebuild.
 *
 * Ranks: 8 27 Long: 125 343 */
#include "tests/test.h"

#include "kernel/comm/ghosts.h"
#include "team.h"
#include "kernel/pairs/classes_choose.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { STEPS = 3 };

/* A sphere on its way. */
struct flight {
    struct team *team;
    struct box box;
    struct domain *domain;
    struct ghosts *ghosts;
    struct particles *particles;
    struct size_classes classes;
    double x[3], v[3], radius; /* the reference; subdomains have the edge 1 */
};

static int side_of(const struct team *team) {
    return (int)lround(cbrt(team->comm.size));
}

static void flight_start(struct flight *flight, struct team *team, bool periodic, enum domain_kind kind,
                         double radius) {
    int side = side_of(team);
    struct error error = {0};
    struct domain_options options = {.kind = kind};
    struct ghosts_options ghosts = {.newton = true, .reduced = true, .sync = GHOSTS_SHADOW};
    struct classes_options classes = classes_options_default();
    *flight = (struct flight){.team = team, .box = {.dimension = 3}, .radius = radius};
    for (int d = 0; d < 3; d++) {
        flight->box.edge[d] = side;
        flight->box.periodic[d] = periodic;
        flight->x[d] = 0.5 * side + 0.0317 * (d + 1);
    }
    classes.method = CLASSES_ONE;
    classes.skin_given = true;
    assert_true(classes_choose(&flight->classes, &classes, NULL, (double[]){radius}, 1, &error));
    flight->domain = domain_create(&team->comm, &flight->box, &options, &error);
    assert_non_null(flight->domain);
    flight->ghosts = ghosts_create(&team->comm, flight->domain, &flight->box, &ghosts);
    flight->particles = particles_create(0);
    if (domain_owner(flight->domain, flight->x) != team->comm.rank)
        return;
    size_t k = particles_append(flight->particles);
    memcpy(flight->particles->state[k].x, flight->x, sizeof flight->x);
    flight->particles->state[k].radius = radius;
    flight->particles->state[k].inverse_mass = 1;
    flight->particles->id[k] = 1;
}

static void flight_end(struct flight *flight) {
    ghosts_destroy(&flight->ghosts);
    particles_destroy(&flight->particles);
    domain_destroy(&flight->domain);
}

/* One step: the owner moves the sphere, and all ranks move the reference. */
static void flight_step(struct flight *flight) {
    struct particles *particles = flight->particles;
    ghosts_drop(flight->ghosts, particles);
    for (size_t k = 0; k < particles->owned; k++)
        for (int d = 0; d < 3; d++) {
            particles->state[k].v[d] = flight->v[d];
            particles->state[k].x[d] += flight->v[d];
        }
    for (int d = 0; d < 3; d++) {
        double edge = flight->box.edge[d];
        flight->x[d] += flight->v[d];
        if (flight->box.periodic[d] && !(flight->x[d] >= 0 && flight->x[d] < edge))
            flight->x[d] -= floor(flight->x[d] / edge) * edge;
    }
    particles_wrap(particles, &flight->box);
    ghosts_migrate(flight->ghosts, particles, NULL);
    particles_classify(particles, &flight->classes);
    ghosts_make(flight->ghosts, particles, &flight->classes);
}

/* The rule: as a pair of spheres of this radius may need it. */
static bool needed(const struct flight *flight, const int image[3]) {
    double lower[3], upper[3], squared = 0;
    bool wrap[3], self = domain_owner(flight->domain, flight->x) == flight->team->comm.rank;
    domain_bounds(flight->domain, flight->team->comm.rank, lower, upper);
    domain_wrap(flight->domain, wrap);
    for (int d = 0; d < 3; d++) {
        if (image[d] != 0 && (wrap[d] || !flight->box.periodic[d]))
            return false;
        double y = flight->x[d] + image[d] * flight->box.edge[d];
        double gap = fmax(0, fmax(lower[d] - y, y - upper[d]));
        squared += wrap[d] ? 0 : gap * gap;
        self = self && image[d] == 0;
    }
    return !self && sqrt(squared) <= 2 * flight->radius;
}

static void expect_copies(struct flight *flight) {
    const struct particles *particles = flight->particles;
    size_t expected = 0;
    for (int turn = 0; turn < 27; turn++) {
        const int image[3] = {turn % 3 - 1, turn / 3 % 3 - 1, turn / 9 - 1};
        size_t count = 0;
        for (size_t g = 0; g < particles->ghosts; g++) {
            const struct particle_state *copy = &particles->state[particles->owned + g];
            if (ghosts_image(flight->ghosts, g) != image_code(image[0], image[1], image[2]))
                continue;
            count++;
            for (int d = 0; d < 3; d++)
                team_expect(flight->team,
                            copy->x[d] == flight->x[d] + image[d] * flight->box.edge[d] &&
                                copy->v[d] == flight->v[d],
                            "a copy at %g with speed %g, not %g", copy->x[d], copy->v[d], flight->x[d]);
        }
        bool wanted = needed(flight, image);
        expected += wanted;
        team_expect(flight->team, count == wanted,
                    "radius %g at %g %g %g, image %d %d %d: %zu copies, not %d", flight->radius, flight->x[0],
                    flight->x[1], flight->x[2], image[0], image[1], image[2], count, wanted);
    }
    team_expect(flight->team, particles->ghosts == expected, "%zu copies, not %zu", particles->ghosts,
                expected);
}

static void expect_owner(struct flight *flight) {
    bool mine = domain_owner(flight->domain, flight->x) == flight->team->comm.rank;
    team_expect(flight->team, flight->particles->owned == mine, "%zu spheres are owned",
                flight->particles->owned);
    for (size_t k = 0; k < flight->particles->owned; k++)
        for (int d = 0; d < 3; d++)
            team_expect(flight->team, flight->particles->state[k].x[d] == flight->x[d],
                        "the sphere is at %g, not %g", flight->particles->state[k].x[d], flight->x[d]);
}

/* A sphere in each of 26 directions; speeds in turn. */
static void fly(struct team *team, bool periodic, enum domain_kind kind, double radius) {
    static const double speeds[] = {0.31, 2, 0.5, 0.77};
    struct flight flight;
    flight_start(&flight, team, periodic, kind, radius);
    for (int turn = 0; turn < 27; turn++) {
        const int way[3] = {turn % 3 - 1, turn / 3 % 3 - 1, turn / 9 - 1};
        double speed = speeds[turn % 4];
        int steps = turn == 13 ? 0 : side_of(team) < 7 ? STEPS : 1;
        for (int step = 0; step < steps; step++) {
            for (int d = 0; d < 3; d++)
                flight.v[d] = speed * way[d] * (periodic || step % 2 == 0 ? 1 : -1);
            flight_step(&flight);
            expect_owner(&flight);
            expect_copies(&flight);
        }
    }
    flight_end(&flight);
}

static void through_a_periodic_box(void **state) {
    struct team *team = *state;
    static const double radii[] = {0.1, 0.4, 0.5, 0.9, 1.4}, large[] = {1.6, 3};
    int side = side_of(team);
    for (int k = 0; k < 5 && side < 7; k++)
        fly(team, true, k % 2 ? DOMAIN_BISECTION : DOMAIN_BRICK, fmin(radii[k], 0.47 * side));
    for (int k = 0; k < 2; k++)
        if (2 * large[k] < side)
            fly(team, true, k % 2 ? DOMAIN_BISECTION : DOMAIN_BRICK, large[k]);
    team_finish(team);
}

static void through_an_open_box(void **state) {
    struct team *team = *state;
    if (side_of(team) > 5)
        team_skip(team, "the open box has 2, 3 and 5 subdomains a side");
    fly(team, false, DOMAIN_BRICK, 0.3);
    fly(team, false, DOMAIN_BISECTION, 1);
    fly(team, false, DOMAIN_BRICK, 1.6);
    fly(team, false, DOMAIN_BRICK, 3);
    team_finish(team);
}

/* A subdomain that a ball misses by rounding alone passes the ball on, and keeps no copy: slabs of
 * thickness 1 along x, 4 along y, and a reach of 3 less some digits, where 3 would touch the next row. */
static void what_is_handed_on_is_not_kept(void **state) {
    struct team *team = *state;
    int side = side_of(team), along = team->comm.size / side;
    if (side > 5)
        team_skip(team, "8, 27 and 125 ranks are enough");
    for (int digits = -1; digits <= 1; digits += 2) {
        struct flight flight;
        flight_start(&flight, team, false, DOMAIN_BRICK, 1.5 * (1 + 20 * digits * DBL_EPSILON));
        struct domain_options grid = {.grid = {along, side, 1}};
        struct ghosts_options options = {.newton = true, .reduced = true, .sync = GHOSTS_SHADOW};
        struct error error = {0};
        const double edge[3] = {along, 4.0 * side, 1}, centre[3] = {0.5, 1, 0.5};
        ghosts_destroy(&flight.ghosts);
        domain_destroy(&flight.domain);
        for (int d = 0; d < 3; d++) {
            flight.box.edge[d] = edge[d];
            flight.x[d] = centre[d];
            if (flight.particles->owned > 0)
                memcpy(flight.particles->state[0].x, centre, sizeof centre);
        }
        flight.domain = domain_create(&team->comm, &flight.box, &grid, &error);
        assert_non_null(flight.domain);
        flight.ghosts = ghosts_create(&team->comm, flight.domain, &flight.box, &options);
        flight_step(&flight);
        expect_copies(&flight);
        int64_t copies = (int64_t)flight.particles->ghosts;
        comm_sum_int(&team->comm, &copies, 1);
        int row = along < 4 ? along - 1 : 3; /* of the own row: up to 3.5 */
        team_expect(team, copies == row + (digits > 0), "%lld copies", (long long)copies);
        flight_end(&flight);
    }
    team_finish(team);
}

/* Next-neighbour synchronisation reports a particle that reaches too far; the copies are right even then. */
static void neighbours_refuse(void **state) {
    struct team *team = *state;
    static const double radii[] = {0.3, 0.7};
    if (side_of(team) < 3 || side_of(team) > 5)
        team_skip(team, "with fewer than 27 ranks all subdomains are neighbours; 125 are enough");
    for (int k = 0; k < 2; k++) {
        struct flight flight;
        flight_start(&flight, team, false, DOMAIN_BRICK, radii[k]);
        struct ghosts_options options = {.newton = true, .reduced = true, .sync = GHOSTS_NEIGHBOURS};
        ghosts_destroy(&flight.ghosts);
        flight.ghosts = ghosts_create(&team->comm, flight.domain, &flight.box, &options);
        for (int d = 0; d < 3; d++)
            flight.v[d] = -1; /* into a corner: from the middle everything is next door */
        flight_step(&flight);
        expect_copies(&flight);
        struct error error = {0};
        int64_t refused = !ghosts_fit(flight.ghosts, &error);
        if (refused)
            team_expect(team,
                        error.kind == ERROR_USER &&
                            strstr(error.text, "sync: neighbours: particle 1 of radius 0.7"),
                        "%s", error.text);
        comm_sum_int(&team->comm, &refused, 1);
        team_expect(team, refused == k, "radius %g: %d ranks refuse", radii[k], (int)refused);
        flight_end(&flight);
    }
    team_finish(team);
}

TEAM_MAIN(shadows, team_case(through_a_periodic_box), team_case(through_an_open_box),
          team_case(what_is_handed_on_is_not_kept), team_case(neighbours_refuse))
