/* SPDX-License-Identifier: BSD-3-Clause */
/* Particles of a fluid in a periodic square or cube. Read fluid_cloud.h first. */
#include "tests/test.h"

#include "tests/physics/fluid/fluid_cloud.h"
#include "base/memory.h"
#include "base/random.h"
#include "kernel/pairs/classes_choose.h"
#include "physics/fluid/lattice/body_surfaces.h"
#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <string.h>

static double kernel_range(const void *context, int kind_a, double a, int kind_b, double b) {
    (void)kind_a, (void)kind_b;
    return isinf(b) ? -INFINITY : *(const double *)context - a - b;
}

static void place(struct fluid_cloud *c, const struct arrangement *lattice, const int64_t at[3], double chi) {
    size_t k = particles_append(c->particles);
    struct particle_state *s = &c->particles->state[k];
    struct random_sequence random = random_sequence(5, RANDOM_TEST, k);
    for (int d = 0; d < c->dimension; d++) {
        s->x[d] =
            ((double)at[d] + 0.5) * lattice->step[d] + chi * (random_uniform(&random) - 0.5) * c->spacing;
        s->x[d] -= floor(s->x[d]);
    }
    s->radius = 0.5 * c->spacing;
    c->particles->id[k] = (int64_t)k + 1;
}

static void places(struct fluid_cloud *c, enum fluid_arrangement arrangement, double chi) {
    const struct fluid_options options = {.spacing = c->spacing, .fill = {.arrangement = arrangement}};
    struct arrangement lattice = arrangement_make(&options, &c->box);
    int64_t at[3], layers = c->dimension == 3 ? lattice.planes[2] : 1;
    c->particles = particles_create((size_t)(lattice.planes[0] * lattice.planes[1] * layers));
    for (at[2] = 0; at[2] < layers; at[2]++)
        for (at[1] = 0; at[1] < lattice.planes[1]; at[1]++)
            for (at[0] = 0; at[0] < lattice.planes[0]; at[0]++)
                if (arrangement_has(&lattice, at))
                    place(c, &lattice, at, chi);
    assert_true(fabs((double)c->particles->owned * lattice.volume - 1) < 1e-12);
}

static void view_take(struct fluid_cloud *c) {
    const bool wrap[3] = {true, true, c->dimension == 3};
    pairlist_view(&c->view, c->particles, &c->classes, &c->box, wrap);
    c->view.threads = c->threads;
}

void fluid_cloud_pair(struct fluid_cloud *c) {
    view_take(c);
    index_build(c->index, &c->view);
    pairlist_build(c->set.all, c->index, &c->view, &c->box);
    pair_rows_build(&c->rows, c->set.all, c->particles->owned);
}

void fluid_cloud_make(struct fluid_cloud *c, int dimension, int side, double reach, double chi, int threads) {
    fluid_cloud_make_on(c, FLUID_CUBIC, dimension, side, reach, chi, threads);
}

void fluid_cloud_make_on(struct fluid_cloud *c, enum fluid_arrangement arrangement, int dimension, int side,
                         double reach, double chi, int threads) {
    *c = (struct fluid_cloud){.dimension = dimension, .side = side, .spacing = 1.0 / side};
    c->reach = reach * c->spacing;
    c->box =
        (struct box){.dimension = dimension, .edge = {1, 1, 1}, .periodic = {true, true, dimension == 3}};
    interactions_add(&c->set, &(struct interaction){"kernel", kernel_range, &c->reach});
    places(c, arrangement, chi);
    struct classes_options options = {.method = CLASSES_ONE, .skin_given = true};
    struct classes_range range = interactions_range(&c->set);
    struct error error = {0};
    double radius = 0.5 * c->spacing;
    assert_true(classes_choose(&c->classes, &options, &range, &radius, 1, &error));
    particles_classify(c->particles, &c->classes);
    const struct index_params params = {0};
    omp_set_num_threads(threads);
    c->threads = threads;
    c->index = index_create("linkcell", &params, &error);
    interactions_create(&c->set, &(struct pairlist_options){.threads = threads});
    fluid_cloud_pair(c);
    c->input = (struct weights_input){.particles = c->particles,
                                      .end = c->particles->owned,
                                      .pairs = &c->rows,
                                      .shift = (const double(*)[4])c->set.all->shift,
                                      .dimension = dimension};
}

void fluid_cloud_free(struct fluid_cloud *c) {
    pair_rows_free(&c->rows);
    interactions_free(&c->set);
    index_destroy(&c->index);
    particles_destroy(&c->particles);
}

struct weights fluid_cloud_weigh(const struct fluid_cloud *c, enum kernel_name name, int operators,
                                 bool lattice) {
    struct weights weights = {0};
    struct weights_options options = {
        .kernel = kernel_make(name, c->reach, c->dimension),
        .operators = operators > WEIGHTS_MLS ? WEIGHTS_MLS : (enum weights_operators)operators,
        .order = operators - WEIGHTS_MLS,
        .spacing = c->spacing,
        .volume = lattice ? kernel_power(c->spacing, c->dimension) : 0};
    weights_make(&weights, &c->input, &options);
    return weights;
}

void fluid_cloud_apart(const struct fluid_cloud *c, const struct weights *w, size_t row, size_t e,
                       double apart[3]) {
    const double *shift = c->input.shift[pair_image(w->partner[e])];
    for (int d = 0; d < 3; d++)
        apart[d] = c->particles->state[pair_partner(w->partner[e])].x[d] -
                   c->particles->state[w->first + row].x[d] + shift[d];
}

double fluid_cloud_identities(const struct fluid_cloud *c, const struct weights *w) {
    double worst = 0;
    size_t n = (size_t)c->dimension;
    for (size_t row = 0; row < w->rows; row++) {
        double first[3][3] = {{0}}, mean[3] = {0}, second[3][3] = {{0}}, apart[3];
        for (size_t e = w->start[row]; e < w->start[row + 1]; e++) {
            fluid_cloud_apart(c, w, row, e, apart);
            for (size_t p = 0; p < n; p++) {
                mean[p] += weights_scalar(w, e) * apart[p];
                for (size_t q = 0; q < n; q++) {
                    first[p][q] += weights_vector(w, e)[p] * apart[q];
                    second[p][q] += weights_scalar(w, e) * apart[p] * apart[q];
                }
            }
        }
        for (size_t p = 0; p < n; p++) {
            worst = fmax(worst, fabs(mean[p]) * c->spacing);
            for (size_t q = 0; q < n; q++) {
                worst = fmax(worst, fabs(first[p][q] - (p == q)));
                worst = fmax(worst, fabs(second[p][q] - 2 * (p == q)));
            }
        }
    }
    return worst;
}

struct fluid_cloud_errors fluid_cloud_errors(int dimension, int side, double reach, double chi,
                                             int operators) {
    struct fluid_cloud c;
    fluid_cloud_make(&c, dimension, side, reach, chi, 2);
    return fluid_cloud_errors_of(&c, operators);
}

struct fluid_cloud_errors fluid_cloud_errors_of(struct fluid_cloud *c, int operators) {
    double gap[2] = {0}, size[2] = {0}, k = 2 * M_PI;
    int dimension = c->dimension;
    struct weights w = fluid_cloud_weigh(c, KERNEL_WENDLAND_C2, operators, false);
    size_t n = c->particles->owned;
    double *f = memory_allocate(n, sizeof *f, "test"), *second = memory_allocate(n, sizeof *second, "test");
    double(*first)[3] = memory_allocate(n, sizeof *first, "test");
    assert_int_equal(w.poor, 0);
    for (size_t i = 0; i < n; i++) {
        f[i] = 1;
        for (int d = 0; d < dimension; d++)
            f[i] *= sin(k * c->particles->state[i].x[d]);
    }
    operators_gradient(&w, (struct operators_values){.value = f, .stride = 1}, first);
    operators_laplacian(&w, (struct operators_values){.value = f, .stride = 1}, second);
    for (size_t i = 0; i < n; i++) {
        for (int d = 0; d < dimension; d++) {
            double exact = k;
            for (int q = 0; q < dimension; q++)
                exact *= q == d ? cos(k * c->particles->state[i].x[q]) : sin(k * c->particles->state[i].x[q]);
            gap[0] += pow(first[i][d] - exact, 2);
            size[0] += exact * exact;
        }
        gap[1] += pow(second[i] + dimension * k * k * f[i], 2);
        size[1] += pow(dimension * k * k * f[i], 2);
    }
    memory_free(f);
    memory_free(first);
    memory_free(second);
    weights_free(&w);
    fluid_cloud_free(c);
    return (struct fluid_cloud_errors){sqrt(gap[0] / size[0]), sqrt(gap[1] / size[1])};
}

size_t fluid_cloud_plane(struct fluid_cloud *c, double height, uint8_t **kinds, int64_t **bodies) {
    fluid_cloud_make(c, 3, 10, 2.2, 0, 2);
    size_t n = c->particles->owned, fluid = 0, at = 0;
    uint8_t *kind = memory_allocate(n, 1, "test");
    int64_t *body = memory_allocate(n, sizeof *body, "test");
    uint32_t *order = memory_allocate(n, sizeof *order, "test");
    for (int pass = 0; pass < 2; pass++)
        for (size_t k = 0; k < n; k++)
            if ((c->particles->state[k].x[2] < height || c->particles->state[k].x[2] > 0.8) == (pass == 1))
                order[at++] = (uint32_t)k;
    particles_reorder(c->particles, order);
    for (size_t k = 0; k < n; k++) {
        bool outside = c->particles->state[k].x[2] < height || c->particles->state[k].x[2] > 0.8;
        kind[k] = outside ? KIND_BOUNDARY : KIND_FLUID;
        fluid += !outside;
        body[k] = body_of_wall(0);
    }
    fluid_cloud_pair(c);
    c->input.kind = kind;
    c->input.end = fluid;
    memory_free(order);
    *kinds = kind;
    *bodies = body;
    return fluid;
}
