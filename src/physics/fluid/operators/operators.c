/* SPDX-License-Identifier: BSD-3-Clause */
/* Operators on arrays, row by row. Read operators.h first. */
#include "physics/fluid/operators/operators.h"

static const double *at(struct operators_values values, size_t particle) {
    return values.value + values.stride * particle;
}

static const double *partner_at(const struct weights *weights, struct operators_values values, size_t entry) {
    return at(values, pair_partner(weights->partner[entry]));
}

/* The first wall entry of a row at which a pressure may change; the end of the row without open sides. */
static size_t open_from(const struct weights *weights, size_t row) {
    return weights->wall_start[row + (weights->opens == 0)];
}

double operators_pressure_step(const struct weights *weights, size_t wall, struct operators_values p,
                               double own) {
    const struct weights_foot *foot = weights_foot_of(weights, wall);
    const struct weights_image *image = weights_image_of(weights, wall);
    double given = p.open * foot->pressure;
    if (image != NULL && foot->open)
        return (foot->pressed ? 2 * given - *at(p, image->particle) : *at(p, image->particle)) - own;
    return foot->pressed ? -(1 + weights->mirror[wall]) * (own - given) : 0;
}

/* Takes the part along the normal out of what a wall entry has added to a gradient, if it is at an open side of given
 * velocity: the pressure goes on evenly there, but its gradient along the normal is not 0. share[d] becomes the part of a
 * unit gradient that the entry would have added for a linear pressure, from which the other entries make up for it. */
static void open_part(const struct weights *weights, size_t wall, const double *vector, double difference,
                      double sum[3], double share[3]) {
    const struct weights_foot *foot = weights_foot_of(weights, wall);
    for (int d = 0; d < weights->dimension && foot->open && !foot->pressed; d++)
        if (foot->normal[d] != 0) {
            sum[d] -= vector[d] * difference;
            share[d] -= vector[d] * foot->normal[d] * (1 + weights->mirror[wall]) * foot->distance;
        }
}

void operators_gradient(const struct weights *weights, struct operators_values p, double (*out)[3]) {
    size_t dimension = (size_t)weights->dimension;
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        double own = *at(p, weights->first + row), sum[3] = {0}, share[3] = {0};
        for (size_t e = weights->start[row]; e < weights_walls(weights, row); e++) {
            double difference = *partner_at(weights, p, e) - own;
            for (size_t d = 0; d < dimension; d++)
                sum[d] += weights_vector(weights, e)[d] * difference;
        }
        size_t e = weights_walls(weights, row);
        for (size_t k = open_from(weights, row); k < weights->wall_start[row + 1]; k++, e++) {
            double difference = operators_pressure_step(weights, k, p, own);
            for (size_t d = 0; d < dimension; d++)
                sum[d] += weights_vector(weights, e)[d] * difference;
            open_part(weights, k, weights_vector(weights, e), difference, sum, share);
        }
        double whole[3] = {0};
        weights_whole(weights, weights->first + row, sum, whole);
        for (int d = 0; d < 3; d++)
            out[row][d] = whole[d] / (1 - share[d]);
    }
}

void operators_laplacian(const struct weights *weights, struct operators_values p, double *out) {
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        double own = *at(p, weights->first + row), sum = 0;
        for (size_t e = weights->start[row]; e < weights_walls(weights, row); e++)
            sum += weights_scalar(weights, e) * (*partner_at(weights, p, e) - own);
        size_t e = weights_walls(weights, row);
        for (size_t k = open_from(weights, row); k < weights->wall_start[row + 1]; k++, e++)
            sum += weights_scalar(weights, e) * operators_pressure_step(weights, k, p, own);
        out[row] = sum;
    }
}

/* u_i - u_w of a wall entry. */
static void relative_to_wall(const struct weights *weights, size_t wall, const double *own, double out[3]) {
    const double *velocity = weights_foot_of(weights, wall)->velocity;
    for (int d = 0; d < 3; d++)
        out[d] = own[d] - velocity[d];
}

/* u_j - u_i at an open side, from the image m of j. */
static void open_mirror(const struct weights_foot *foot, const struct weights_image *image, const double *m,
                        const double *own, double difference[3]) {
    for (int d = 0; d < 3; d++)
        difference[d] = (foot->pressed ? m[d] : 2 * image->velocity[d] - m[d]) - own[d];
}

void operators_mirror(const struct weights *weights, size_t wall, struct operators_values u,
                      const double *own, double difference[3]) {
    const struct weights_foot *foot = weights_foot_of(weights, wall);
    const double *normal = foot->normal;
    const struct weights_image *image = weights_image_of(weights, wall);
    if (image != NULL) {
        open_mirror(foot, image, at(u, image->particle), own, difference);
        return;
    }
    double relative[3], across = 0, along = weights_tangential_factor(weights, wall),
                        straight = 1 + weights->mirror[wall];
    relative_to_wall(weights, wall, own, relative);
    for (int d = 0; d < 3; d++)
        across += relative[d] * normal[d];
    for (int d = 0; d < 3; d++)
        difference[d] = foot->pressed       ? 0
                        : weights->slip > 0 ? -along * relative[d] - (straight - along) * across * normal[d]
                                            : -straight * relative[d];
    for (int d = 0; d < 3; d++)
        difference[d] += weights_turn(weights, wall, d);
}

/* What a fluid neighbour j adds to a divergence: b . (C_j u_j - C_i u_i), C of gradient_correction.h. */
static inline double inner_flux(const struct weights *weights, size_t entry, const double *own,
                                const double *other, int dimension) {
    const double *b = weights_vector(weights, entry);
    double sum = 0, whole[3] = {0};
    if (weights->whole != NULL) {
        weights_whole(weights, pair_partner(weights->partner[entry]), other, whole);
        other = whole;
    }
    for (int d = 0; d < dimension; d++)
        sum += b[d] * (other[d] - own[d]);
    return sum;
}

/* What a wall neighbour adds to a divergence; `difference` is operators_mirror's. With C of gradient_correction.h the flux b . (C_i u_i + C_j u_j) of i is
 * what j loses: a body lets nothing through, and an open side what its image and its velocity say. */
static double wall_flux(const struct weights *weights, size_t row, size_t entry, size_t wall,
                        const double *own, const double *difference) {
    const struct weights_foot *foot = weights_foot_of(weights, wall);
    const struct weights_image *image = weights_image_of(weights, wall);
    const double *b = weights_vector(weights, entry);
    double sum = 0, to[3], from[3], beyond[3], from_whole[3],
           body = weights->whole != NULL ? 2 : weights_divergence_factor(weights, wall);
    size_t i = weights->first + row;
    for (int d = 0; d < weights->dimension; d++) {
        from[d] = foot->open ? own[d] : 0;
        to[d] = foot->open ? own[d] + difference[d] : body * (foot->velocity[d] - own[d]);
    }
    weights_whole(weights, i, from, from_whole);
    weights_whole(weights, foot->open && image != NULL ? image->particle : i, to, beyond);
    for (int d = 0; d < weights->dimension; d++)
        sum += b[d] * (beyond[d] - from_whole[d] + weights_turn(weights, wall, d));
    return sum;
}

void operators_divergence(const struct weights *weights, struct operators_values u, double *out) {
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        const double *own = at(u, weights->first + row);
        double sum = 0, difference[3], whole[3];
        size_t e = weights->start[row];
        weights_whole(weights, weights->first + row, own, whole);
        for (; e < weights_walls(weights, row); e++)
            sum += inner_flux(weights, e, whole, partner_at(weights, u, e), weights->dimension);
        for (size_t k = weights->wall_start[row]; k < weights->wall_start[row + 1]; k++, e++) {
            if (weights_foot_of(weights, k)->open)
                operators_mirror(weights, k, u, own, difference);
            sum += wall_flux(weights, row, e, k, own, difference);
        }
        out[row] = sum;
    }
}

void operators_laplacian_velocity(const struct weights *weights, struct operators_values u,
                                  double (*out)[3]) {
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        const double *own = at(u, weights->first + row);
        double sum[3] = {0}, difference[3];
        size_t e = weights->start[row];
        for (; e < weights_walls(weights, row); e++) {
            const double *other = partner_at(weights, u, e);
            for (int d = 0; d < 3; d++)
                sum[d] += weights_scalar(weights, e) * (other[d] - own[d]);
        }
        for (size_t k = weights->wall_start[row]; k < weights->wall_start[row + 1]; k++, e++) {
            operators_mirror(weights, k, u, own, difference);
            for (int d = 0; d < 3; d++)
                sum[d] += weights_scalar(weights, e) * difference[d];
        }
        for (int d = 0; d < 3; d++)
            out[row][d] = sum[d];
    }
}

/* What the neighbours of a row add up to: of the pressure its gradient, of the velocity Laplacian and divergence. */
struct stokes_sums {
    double gradient[3], laplacian[3], divergence;
    double share[3]; /* open_part */
};

/* Adds the fluid neighbours of a row, in 2 or 3 dimensions. */
static inline void stokes_inner(const struct weights *weights, size_t row, struct operators_values u,
                                struct operators_values p, int dimension, struct stokes_sums *sums) {
    const double *own = at(u, weights->first + row), pressure = *at(p, weights->first + row);
    double whole[3];
    weights_whole(weights, weights->first + row, own, whole);
    for (size_t e = weights->start[row]; e < weights_walls(weights, row); e++) {
        size_t j = pair_partner(weights->partner[e]);
        const double *other = at(u, j), *b = weights_vector(weights, e);
        double w = weights_scalar(weights, e), step = *at(p, j) - pressure;
        for (int d = 0; d < dimension; d++) {
            sums->laplacian[d] += w * (other[d] - own[d]);
            sums->gradient[d] += b[d] * step;
        }
        sums->divergence += inner_flux(weights, e, whole, other, dimension);
    }
}

/* Adds the wall neighbours of a row. */
static void stokes_walls(const struct weights *weights, size_t row, struct operators_values u,
                         struct operators_values p, struct stokes_sums *sums) {
    const double *own = at(u, weights->first + row), pressure = *at(p, weights->first + row);
    size_t e = weights_walls(weights, row);
    for (size_t k = weights->wall_start[row]; k < weights->wall_start[row + 1]; k++, e++) {
        const double *b = weights_vector(weights, e);
        double w = weights_scalar(weights, e), difference[3], step = 0;
        operators_mirror(weights, k, u, own, difference);
        if (weights->opens > 0)
            step = operators_pressure_step(weights, k, p, pressure);
        sums->divergence += wall_flux(weights, row, e, k, own, difference);
        for (int d = 0; d < weights->dimension; d++) {
            sums->laplacian[d] += w * difference[d];
            sums->gradient[d] += b[d] * step;
        }
        if (weights->opens > 0)
            open_part(weights, k, b, step, sums->gradient, sums->share);
    }
}

void operators_stokes(const struct weights *weights, struct operators_values u, struct operators_values p,
                      const struct operators_stokes *factor, double *out) {
    size_t rows = weights->rows, dimension = (size_t)weights->dimension;
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < rows; row++) {
        struct stokes_sums sums = {0};
        if (dimension == 3)
            stokes_inner(weights, row, u, p, 3, &sums);
        else
            stokes_inner(weights, row, u, p, 2, &sums);
        stokes_walls(weights, row, u, p, &sums);
        double gradient[3];
        weights_whole(weights, weights->first + row, sums.gradient, gradient);
        for (size_t d = 0; d < dimension; d++)
            out[d * rows + row] =
                factor->gradient * gradient[d] / (1 - sums.share[d]) - factor->viscous * sums.laplacian[d];
        out[dimension * rows + row] = -factor->divergence * sums.divergence;
    }
}

void operators_divergence_inner(const struct weights *weights, struct operators_values g, double *out) {
    size_t dimension = (size_t)weights->dimension;
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        const double *own = at(g, weights->first + row);
        double sum = 0;
        for (size_t e = weights->start[row]; e < weights_walls(weights, row); e++) {
            const double *other = partner_at(weights, g, e);
            for (size_t d = 0; d < dimension; d++)
                sum += weights_vector(weights, e)[d] * (other[d] - own[d]);
        }
        out[row] = sum;
    }
}

/* u_j - u_i of a wall entry as operators_mirror has it, with `part` of what the flow there is relative to its body. */
static void mirror_part(const struct weights *weights, size_t wall, struct operators_values u,
                        const double *own, double part, double difference[3]) {
    operators_mirror(weights, wall, u, own, difference);
    for (int d = 0; d < 3; d++) {
        double turn = weights_turn(weights, wall, d);
        difference[d] = turn + part * (difference[d] - turn);
    }
}

void operators_advection(const struct weights *weights, struct operators_values carrier,
                         struct operators_values u, double (*out)[3]) {
    size_t dimension = (size_t)weights->dimension;
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        const double *own = at(u, weights->first + row), *way = at(carrier, weights->first + row);
        double sum[3] = {0}, difference[3];
        size_t e = weights->start[row], wall = weights->wall_start[row], walls = weights_walls(weights, row);
        for (; e < weights->start[row + 1]; e++) {
            double along = 0;
            for (size_t d = 0; d < dimension; d++)
                along += way[d] * weights_vector(weights, e)[d];
            if (e >= walls) {
                double part = weights_divergence_factor(weights, wall) / (1 + weights->mirror[wall]);
                mirror_part(weights, wall++, u, own, part, difference);
            }
            for (int d = 0; d < 3; d++)
                sum[d] += along * (e >= walls ? difference[d] : partner_at(weights, u, e)[d] - own[d]);
        }
        for (int d = 0; d < 3; d++)
            out[row][d] = sum[d];
    }
}

/* True if a row has a wall or a grain within its support. */
static bool beside_body(const struct weights *weights, size_t row) {
    bool beside = false;
    for (size_t k = weights->foot_start[row]; k < weights->foot_start[row + 1]; k++)
        beside = beside || !weights->foot[k].open;
    return beside;
}

/* The value of a row, and by how much that of an entry differs. */
struct link {
    const double *own;
    double difference[3];
};

/* Adds to a sum what an entry brings to the inertia of i: 1/2 b . (g_i + g_j) (u_j - u_i) + share b . (g_j - g_i) u_i, less what diffusion its
 * link lacks: `diffusion` is that which it has, INFINITY where it wants no more. */
static inline void add_inertia(const double *b, int dimension, double diffusion, double share,
                               const struct link *g, const struct link *u, double sum[3]) {
    double carry = 0, spread = 0;
    for (int d = 0; d < dimension; d++) {
        carry += 0.5 * b[d] * (2 * g->own[d] + g->difference[d]);
        spread += share * b[d] * g->difference[d];
    }
    carry -= fmax(0, fabs(carry) / OPERATORS_LINK_PECLET - diffusion);
    for (int d = 0; d < 3; d++)
        sum[d] += carry * u->difference[d] + spread * u->own[d];
}

static void link_to(const double *other, struct link *link) {
    for (int d = 0; d < 3; d++)
        link->difference[d] = other[d] - link->own[d];
}

void operators_inertia(const struct weights *weights, const struct operators_stream *stream, double viscosity,
                       double (*out)[3]) {
    const struct operators_values flow = stream->flow, of = stream->velocity;
    const bool same = flow.value == of.value;
#pragma omp parallel for schedule(static)
    for (size_t row = 0; row < weights->rows; row++) {
        struct link g = {.own = at(flow, weights->first + row)}, u = {.own = at(of, weights->first + row)};
        const struct link *carried = same ? &g : &u;
        double sum[3] = {0};
        size_t e = weights->start[row], wall = weights->wall_start[row];
        double enough = beside_body(weights, row) ? 0 : INFINITY;
        for (; e < weights_walls(weights, row); e++) {
            link_to(partner_at(weights, flow, e), &g);
            if (!same)
                link_to(partner_at(weights, of, e), &u);
            add_inertia(weights_vector(weights, e), weights->dimension,
                        enough + viscosity * fmax(weights_scalar(weights, e), 0), stream->share, &g, carried,
                        sum);
        }
        for (; wall < weights->wall_start[row + 1]; e++, wall++) {
            double part = weights_image_of(weights, wall) != NULL ? 1 : 2 / (1 + weights->mirror[wall]);
            mirror_part(weights, wall, flow, g.own, part, g.difference);
            if (!same)
                mirror_part(weights, wall, of, u.own, part, u.difference);
            add_inertia(weights_vector(weights, e), weights->dimension, INFINITY, stream->share, &g, carried,
                        sum);
        }
        for (int d = 0; d < 3; d++)
            out[row][d] = sum[d];
    }
}
