/* SPDX-License-Identifier: BSD-3-Clause */
/* Block incomplete Cholesky without fill. Read newton_blocks.h first. */
#include "physics/hard/newton_blocks.h"
#include "base/memory.h"
#include <stdlib.h>
#include <string.h>

enum { SIX = 6, NONE = -1, ATTEMPTS_MOST = 30 }; /* not a number never factors */

/* A factor that breaks down begins again with this much more on the diagonal, and with four times more each time. */
static const double shift_first = 1e-3, shift_more = 4.0;

void hard_blocks_free(struct hard_blocks *blocks) {
    memory_free(blocks->start);
    memory_free(blocks->column);
    memory_free(blocks->of_row);
    memory_free(blocks->value);
    memory_free(blocks->diagonal);
    *blocks = (struct hard_blocks){0};
}

/* A row in the list of the later of its bodies. */
struct entry {
    uint32_t column, row;
};

static int by_column(const void *a, const void *b) {
    const struct entry *x = a, *y = b;
    if (x->column != y->column)
        return x->column < y->column ? -1 : 1;
    return x->row < y->row ? -1 : x->row > y->row;
}

/* The later body of a row that couples two bodies of this rank; NONE: it does not. */
static int64_t head_of(const struct hard_problem *problem, size_t r, size_t bodies) {
    const uint32_t *body = problem->row[r].body;
    if (body[0] >= bodies || body[1] >= bodies || body[0] == body[1] ||
        !(problem->body[body[0]].lightness > 0.0) || !(problem->body[body[1]].lightness > 0.0))
        return NONE;
    return body[0] > body[1] ? body[0] : body[1];
}

/* Rows by the later of their bodies, then by the other one. `start` gets where each body's begin. */
static struct entry *entries_make(const struct hard_problem *problem, size_t bodies, size_t *start) {
    memset(start, 0, (bodies + 1) * sizeof *start);
    for (size_t r = 0; r < problem->rows; r++) {
        int64_t head = head_of(problem, r, bodies);
        if (head >= 0)
            start[head + 1]++;
    }
    for (size_t i = 0; i < bodies; i++)
        start[i + 1] += start[i];
    struct entry *entry = memory_allocate(start[bodies], sizeof *entry, "blocks of contacts");
    size_t *at = memory_allocate(bodies, sizeof *at, "blocks of contacts");
    memcpy(at, start, bodies * sizeof *at);
    for (size_t r = 0; r < problem->rows; r++) {
        int64_t head = head_of(problem, r, bodies);
        const uint32_t *body = problem->row[r].body;
        if (head >= 0)
            entry[at[head]++] = (struct entry){body[0] < body[1] ? body[0] : body[1], (uint32_t)r};
    }
    memory_free(at);
    for (size_t i = 0; i < bodies; i++)
        qsort(entry + start[i], start[i + 1] - start[i], sizeof *entry, by_column);
    return entry;
}

void hard_blocks_shape(struct hard_blocks *blocks, const struct hard_problem *problem, size_t bodies) {
    blocks->bodies = bodies;
    blocks->start = hard_problem_grow(blocks->start, &blocks->start_room, bodies + 1, sizeof *blocks->start);
    blocks->of_row =
        hard_problem_grow(blocks->of_row, &blocks->row_room, problem->rows, sizeof *blocks->of_row);
    memset(blocks->of_row, 0xff, problem->rows * sizeof *blocks->of_row);
    struct entry *entry = entries_make(problem, bodies, blocks->start);
    blocks->column = hard_problem_grow(blocks->column, &blocks->column_room, blocks->start[bodies],
                                       sizeof *blocks->column);
    size_t count = 0;
    for (size_t i = 0; i < bodies; i++) {
        size_t first = count, e = blocks->start[i];
        blocks->start[i] = first;
        for (; e < blocks->start[i + 1]; e++) {
            if (count == first || blocks->column[count - 1] != entry[e].column)
                blocks->column[count++] = entry[e].column;
            blocks->of_row[entry[e].row] = (uint32_t)(count - 1);
        }
    }
    blocks->start[bodies] = count;
    memory_free(entry);
    blocks->value = hard_problem_grow(blocks->value, &blocks->block_room, count, sizeof *blocks->value);
    blocks->diagonal =
        hard_problem_grow(blocks->diagonal, &blocks->body_room, problem->bodies, sizeof *blocks->diagonal);
}

/* The velocity at a contact by a body's velocity and spin: `sign` 1 and the matrix `arm`, each times the body's root. */
struct arm {
    double sign, arm[3][3];
};

static struct arm arm_of(const struct hard_row *row, int e, const struct hard_body *body,
                         const double root[HARD_ROOT]) {
    struct arm arm = {.sign = (e ? 1.0 : -1.0) * sqrt(body->lightness)};
    double lever[3], way[6], u[3];
    hard_lever(row, e, lever);
    for (int k = 0; k < 3; k++) {
        const double x[6] = {0.0, 0.0, 0.0, k == 0, k == 1, k == 2};
        hard_root_times(body, root, x, way);
        vector_cross(way + 3, lever, u);
        for (int d = 0; d < 3; d++)
            arm.arm[d][k] = e ? u[d] : -u[d];
    }
    return arm;
}

static void derivative_of(const struct hard_row *row, const struct hard_newton_row *newton, double g[3][3]) {
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++) {
            g[a][b] = (newton->push - newton->grip) * row->normal[a] * row->normal[b];
            g[a][b] += a == b ? newton->grip : 0.0;
            g[a][b] -= newton->slip > 0.0 ? newton->slip * newton->along[a] * newton->along[b] : 0.0;
        }
}

/* Adds the block of a row between its ends: of a the rows, of b the columns. */
static void add(hard_block block, double g[3][3], const struct arm *a, const struct arm *b) {
    double right[3][3], both[3][3] = {{0.0}}, left[3][3] = {{0.0}};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            right[i][k] = g[i][0] * b->arm[0][k] + g[i][1] * b->arm[1][k] + g[i][2] * b->arm[2][k];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            for (int m = 0; m < 3; m++) {
                both[i][k] += a->arm[m][i] * right[m][k];
                left[i][k] += a->arm[m][i] * g[m][k];
            }
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            block[i][k] += a->sign * b->sign * g[i][k];
            block[i][3 + k] += a->sign * right[i][k];
            block[3 + i][k] += b->sign * left[i][k];
            block[3 + i][3 + k] += both[i][k];
        }
}

struct filling {
    struct hard_blocks *blocks;
    const struct hard_problem *problem;
    const struct hard_newton_row *newton;
};

static void fill(void *context, size_t row, size_t end) {
    const struct filling *f = context;
    for (size_t r = row; r < end; r++) {
        const struct hard_row *contact = &f->problem->row[r];
        const uint32_t *body = contact->body;
        double g[3][3];
        struct arm arm[2];
        if (!(f->newton[r].push > 0.0) && !(f->newton[r].grip > 0.0))
            continue;
        derivative_of(contact, &f->newton[r], g);
        for (int e = 0; e < 2; e++)
            arm[e] = arm_of(contact, e, &f->problem->body[body[e]], hard_root_at(f->blocks->root, body[e]));
        for (int e = 0; e < 2; e++)
            add(f->blocks->diagonal[body[e]], g, &arm[e], &arm[e]);
        int late = body[0] > body[1] ? 0 : 1;
        if (f->blocks->of_row[r] != UINT32_MAX)
            add(f->blocks->value[f->blocks->of_row[r]], g, &arm[late], &arm[1 - late]);
    }
}

/* Adds the diagonal blocks of copies to those of their originals, which are symmetric: six numbers at a time. */
static void diagonals_collect(struct hard_blocks *blocks, size_t bodies, struct hard_border *border) {
    if (border->ghosts == NULL)
        return;
    double(*value)[SIX] = memory_allocate_zero(bodies, sizeof *value, "blocks of contacts");
    for (int i = 0; i < SIX; i++) {
        for (size_t k = 0; k < bodies; k++)
            memcpy(value[k], blocks->diagonal[k][i], sizeof *value);
        hard_border_collect(border, value);
        for (size_t k = 0; k < blocks->bodies; k++)
            memcpy(blocks->diagonal[k][i], value[k], sizeof *value);
    }
    memory_free(value);
}

/* c -= a b^T */
static void subtract(hard_block c, const hard_block a, const hard_block b) {
    for (int i = 0; i < SIX; i++)
        for (int k = 0; k < SIX; k++) {
            double sum = 0.0;
            for (int m = 0; m < SIX; m++)
                sum += a[i][m] * b[k][m];
            c[i][k] -= sum;
        }
}

/* a becomes the inverse of its lower triangular factor; false: it has none. */
static bool invert(hard_block a) {
    hard_block inverse = {{0.0}};
    for (int i = 0; i < SIX; i++)
        for (int k = 0; k <= i; k++) {
            double sum = a[i][k];
            for (int m = 0; m < k; m++)
                sum -= a[i][m] * a[k][m];
            if (i == k && !(sum > 0.0))
                return false;
            a[i][k] = i == k ? sqrt(sum) : sum / a[k][k];
        }
    for (int k = 0; k < SIX; k++)
        for (int i = k; i < SIX; i++) {
            double sum = i == k ? 1.0 : 0.0;
            for (int m = k; m < i; m++)
                sum -= a[i][m] * inverse[m][k];
            inverse[i][k] = sum / a[i][i];
        }
    memcpy(a, inverse, sizeof inverse);
    return true;
}

/* The block of body i becomes its column j of the factor. */
static void column_make(struct hard_blocks *blocks, size_t i, size_t at) {
    size_t j = blocks->column[at], left = blocks->start[i], other = blocks->start[j];
    while (left < at && other < blocks->start[j + 1]) {
        if (blocks->column[left] < blocks->column[other])
            left++;
        else if (blocks->column[left] > blocks->column[other])
            other++;
        else
            subtract(blocks->value[at], (const double(*)[SIX])blocks->value[left++],
                     (const double(*)[SIX])blocks->value[other++]);
    }
    hard_block a;
    memcpy(a, blocks->value[at], sizeof a);
    for (int r = 0; r < SIX; r++)
        for (int k = 0; k < SIX; k++) {
            double sum = 0.0;
            for (int m = 0; m <= k; m++)
                sum += a[r][m] * blocks->diagonal[j][k][m];
            blocks->value[at][r][k] = sum;
        }
}

static bool factor(struct hard_blocks *blocks) {
    for (size_t i = 0; i < blocks->bodies; i++) {
        for (size_t at = blocks->start[i]; at < blocks->start[i + 1]; at++) {
            column_make(blocks, i, at);
            subtract(blocks->diagonal[i], (const double(*)[SIX])blocks->value[at],
                     (const double(*)[SIX])blocks->value[at]);
        }
        if (!invert(blocks->diagonal[i]))
            return false;
    }
    return true;
}

void hard_blocks_make(struct hard_blocks *blocks, const struct hard_problem *problem,
                      const struct hard_newton_row *newton, struct hard_border *border) {
    struct filling filling = {blocks, problem, newton};
    size_t all = border->ghosts ? border->particles->owned + border->particles->ghosts : blocks->bodies;
    hard_block *whole = memory_allocate(blocks->bodies, sizeof *whole, "blocks of contacts");
    double shift = 0.0;
    bool again = true;
    for (int attempt = 0; again; attempt++) {
        memset(blocks->value, 0, blocks->start[blocks->bodies] * sizeof *blocks->value);
        memset(blocks->diagonal, 0, problem->bodies * sizeof *blocks->diagonal);
        hard_problem_visit(problem, fill, &filling);
        if (attempt == 0) {
            diagonals_collect(blocks, all, border);
            memcpy(whole, blocks->diagonal, blocks->bodies * sizeof *whole);
        }
        memcpy(blocks->diagonal, whole, blocks->bodies * sizeof *whole);
        for (size_t i = 0; i < blocks->bodies; i++)
            for (int k = 0; k < SIX; k++)
                blocks->diagonal[i][k][k] = 1.0 + (1.0 + shift) * blocks->diagonal[i][k][k];
        again = !factor(blocks) && attempt < ATTEMPTS_MOST;
        shift = shift > 0.0 ? shift * shift_more : shift_first;
    }
    memory_free(whole);
}

void hard_blocks_solve(const struct hard_blocks *blocks, const double (*r)[6], double (*z)[6]) {
    for (size_t i = 0; i < blocks->bodies; i++) {
        double sum[SIX];
        memcpy(sum, r[i], sizeof sum);
        for (size_t at = blocks->start[i]; at < blocks->start[i + 1]; at++)
            for (int a = 0; a < SIX; a++)
                for (int b = 0; b < SIX; b++)
                    sum[a] -= blocks->value[at][a][b] * z[blocks->column[at]][b];
        for (int a = 0; a < SIX; a++) {
            z[i][a] = 0.0;
            for (int b = 0; b <= a; b++)
                z[i][a] += blocks->diagonal[i][a][b] * sum[b];
        }
    }
    for (size_t i = blocks->bodies; i-- > 0;) {
        double sum[SIX] = {0.0};
        for (int a = 0; a < SIX; a++)
            for (int b = 0; b <= a; b++)
                sum[b] += blocks->diagonal[i][a][b] * z[i][a];
        memcpy(z[i], sum, sizeof sum);
        for (size_t at = blocks->start[i]; at < blocks->start[i + 1]; at++)
            for (int a = 0; a < SIX; a++)
                for (int b = 0; b < SIX; b++)
                    z[blocks->column[at]][b] -= blocks->value[at][a][b] * sum[a];
    }
}
