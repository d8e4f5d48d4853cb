/* SPDX-License-Identifier: BSD-3-Clause */
/* From the rows of a solved step to W and q. Read local_form.h first. */
#include "physics/hard/local_form.h"
#include "base/memory.h"
#include <stdlib.h>
#include <string.h>

static const char what[] = "contact problem of a step";

/* A row with its bodies, on its way to rank 0. */
struct record {
    struct hard_row row;
    struct hard_body body[2];
    int64_t id[2];       /* of a wall -(number + 1) */
    double frame[3][3];  /* normal and two tangents */
    uint32_t end[2];     /* numbers of the bodies */
    struct hard_arm arm; /* that of the row, if it has one */
    double turn[2][HARD_TENSOR];
};

/* An end of a record, to find which records share bodies. */
struct end {
    int64_t id;
    uint32_t record;
    int side;
};

/* All records, the bodies, and the records of each body. */
struct net {
    size_t records, bodies;
    struct record *record;
    struct hard_body *body; /* as the solver has left them */
    uint32_t *first, *of;   /* bodies + 1; 2 x records */
};

static int64_t lower_id(const struct record *a) {
    return a->id[0] < a->id[1] ? a->id[0] : a->id[1];
}

static int record_order(const void *x, const void *y) {
    const struct record *a = x, *b = y;
    int64_t low = lower_id(a) - lower_id(b), sum = (a->id[0] + a->id[1]) - (b->id[0] + b->id[1]);
    if (low != 0 || sum != 0)
        return low != 0 ? (low > 0) - (low < 0) : (sum > 0) - (sum < 0);
    int normal = memcmp(a->row.normal, b->row.normal, sizeof a->row.normal);
    return normal ? normal : memcmp(a->arm.lever, b->arm.lever, sizeof a->arm.lever); /* of two bodies */
}

static int end_order(const void *x, const void *y) {
    const struct end *a = x, *b = y;
    if (a->id != b->id)
        return a->id < b->id ? -1 : 1;
    return a->record != b->record ? (a->record < b->record ? -1 : 1) : a->side - b->side;
}

/* The normal and two tangents across it. */
static void frame_make(struct record *record) {
    const double *n = record->row.normal;
    double axis[3] = {0.0, 0.0, 0.0}, size;
    axis[fabs(n[0]) < 0.6 ? 0 : fabs(n[1]) < 0.6 ? 1 : 2] = 1.0;
    memcpy(record->frame[0], n, sizeof record->frame[0]);
    vector_cross(n, axis, record->frame[1]);
    size = sqrt(vector_dot(record->frame[1], record->frame[1]));
    for (int d = 0; d < 3; d++)
        record->frame[1][d] /= size;
    vector_cross(n, record->frame[1], record->frame[2]);
}

/* Takes what the arm of a row has into the record. */
static void arm_take(struct record *record) {
    if (record->row.arm == NULL)
        return;
    record->arm = *record->row.arm;
    for (int e = 0; e < 2; e++)
        if (record->arm.turn[e])
            memcpy(record->turn[e], record->arm.turn[e], sizeof record->turn[e]);
}

/* Points to it, where the record now is. */
static void arm_point(struct record *record) {
    if (record->row.arm == NULL)
        return;
    record->row.arm = &record->arm;
    for (int e = 0; e < 2; e++)
        if (record->arm.turn[e])
            record->arm.turn[e] = record->turn[e];
}

/* This rank's rows, gathered on rank 0 in the order of ids. Collective. */
static void records_gather(struct net *net, const struct hard_solver *solver,
                           const struct particles *particles) {
    const struct hard_problem *problem = &solver->problem;
    struct record *mine = memory_allocate_zero(problem->rows + 1, sizeof *mine, what);
    void *all;
    for (size_t r = 0; r < problem->rows; r++) {
        const struct hard_row *row = &problem->row[r];
        size_t wall = r - solver->contacts.pair_rows;
        bool walled = r >= solver->contacts.pair_rows;
        mine[r].row = *row;
        for (int e = 0; e < 2; e++)
            mine[r].body[e] = problem->body[row->body[e]];
        mine[r].id[0] = particles->id[row->body[0]];
        mine[r].id[1] =
            walled ? -(int64_t)(solver->contacts.wall[wall].place.wall + 1) : particles->id[row->body[1]];
        frame_make(&mine[r]);
        arm_take(&mine[r]);
    }
    net->records =
        comm_gather_varying(solver->comm, mine, problem->rows * sizeof *mine, &all, NULL) / sizeof *mine;
    net->record = all;
    memory_free(mine);
    if (net->records > 1)
        qsort(net->record, net->records, sizeof *net->record, record_order);
    for (size_t r = 0; r < net->records; r++)
        arm_point(&net->record[r]);
}

/* Numbers the bodies; each contact with a wall has a body of its own. */
static void bodies_number(struct net *net) {
    struct end *end = memory_allocate(2 * net->records, sizeof *end, what);
    for (size_t k = 0; k < 2 * net->records; k++)
        end[k] = (struct end){net->record[k / 2].id[k % 2], (uint32_t)(k / 2), (int)(k % 2)};
    qsort(end, 2 * net->records, sizeof *end, end_order);
    net->body = memory_allocate(2 * net->records, sizeof *net->body, what);
    net->first = memory_allocate(2 * net->records + 1, sizeof *net->first, what);
    net->of = memory_allocate(2 * net->records, sizeof *net->of, what);
    for (size_t k = 0; k < 2 * net->records; k++) {
        struct record *record = &net->record[end[k].record];
        if (k == 0 || end[k].id < 0 || end[k].id != end[k - 1].id) {
            net->first[net->bodies] = (uint32_t)k;
            net->body[net->bodies++] = record->body[end[k].side];
        }
        record->end[end[k].side] = (uint32_t)net->bodies - 1;
        net->of[k] = end[k].record;
    }
    net->first[net->bodies] = (uint32_t)(2 * net->records);
    memory_free(end);
}

static struct hard_body stilled(struct hard_body body) {
    memset(body.v, 0, sizeof body.v);
    memset(body.w, 0, sizeof body.w);
    return body;
}

/* The velocity of a contact in its frame. */
static void velocity_of(const struct record *record, const struct hard_body *a, const struct hard_body *b,
                        double u[3]) {
    double space[3];
    hard_velocity(&record->row, a, b, space);
    for (int k = 0; k < 3; k++)
        u[k] = vector_dot(space, record->frame[k]);
}

/* The contacts that share a body with contact c, increasing and each once. Returns how many. */
static size_t partners_of(const struct net *net, size_t c, uint32_t *partner) {
    const struct record *record = &net->record[c];
    uint32_t k[2] = {net->first[record->end[0]], net->first[record->end[1]]},
             end[2] = {net->first[record->end[0] + 1], net->first[record->end[1] + 1]};
    size_t count = 0;
    while (k[0] < end[0] || k[1] < end[1]) {
        int side = k[1] == end[1] || (k[0] < end[0] && net->of[k[0]] <= net->of[k[1]]) ? 0 : 1;
        uint32_t next = net->of[k[side]++];
        if (count == 0 || partner[count - 1] != next)
            partner[count++] = next;
    }
    return count;
}

/* One column of W: what a unit impulse of contact c along axis k of its frame does to its partners. */
static void column_fill(const struct net *net, size_t c, int k, const uint32_t *partner, size_t partners,
                        double *value, int32_t *row) {
    const struct record *record = &net->record[c];
    struct hard_body pushed[2];
    double none[3] = {0.0, 0.0, 0.0};
    for (int e = 0; e < 2; e++)
        pushed[e] = stilled(net->body[record->end[e]]);
    hard_apply(&record->row, &pushed[0], &pushed[1], k == 0 ? 1.0 : 0.0, k == 0 ? none : record->frame[k]);
    for (size_t p = 0; p < partners; p++) {
        const struct record *other = &net->record[partner[p]];
        struct hard_body end[2];
        for (int e = 0; e < 2; e++) {
            end[e] = stilled(net->body[other->end[e]]);
            for (int s = 0; s < 2; s++)
                if (other->end[e] == record->end[s])
                    end[e] = pushed[s];
        }
        velocity_of(other, &end[0], &end[1], &value[3 * p]);
        for (int l = 0; l < 3; l++)
            row[3 * p + (size_t)l] = (int32_t)(3 * partner[p] + (size_t)l);
    }
}

static bool matrix_make(struct hard_form *local, const struct net *net) {
    uint32_t *partner = memory_allocate(2 * net->records, sizeof *partner, what);
    size_t entries = 0;
    for (size_t c = 0; c < net->records; c++)
        entries += 9 * partners_of(net, c, partner);
    bool fits = entries <= INT32_MAX;
    local->start = memory_allocate(3 * net->records + 1, sizeof *local->start, what);
    local->row = memory_allocate(fits ? entries : 1, sizeof *local->row, what);
    local->value = memory_allocate(fits ? entries : 1, sizeof *local->value, what);
    entries = 0;
    for (size_t column = 0; fits && column < 3 * net->records; column++) {
        size_t c = column / 3, partners = partners_of(net, c, partner);
        local->start[column] = (int32_t)entries;
        column_fill(net, c, (int)(column % 3), partner, partners, &local->value[entries],
                    &local->row[entries]);
        for (size_t k = entries; k < entries + 3 * partners; k++)
            if (local->row[k] == (int32_t)column)
                local->value[k] += local->soft[column];
        entries += 3 * partners;
        local->start[column + 1] = (int32_t)entries;
    }
    memory_free(partner);
    return fits;
}

/* Springs and biases of a row at its solution: soft in normal and tangential direction, bias of the normal row. */
static void springs_of(const struct record *record, double u_n, double dt, double soft[2], double *bias) {
    const struct hard_row *row = &record->row;
    double push = hard_push(row, &record->body[0], &record->body[1]), free = u_n - push * row->p;
    soft[0] = row->soft_n;
    soft[1] = row->soft_t;
    *bias = row->bias;
    if (row->hertz > 0.0) {
        double root = sqrt(row->deep);
        *bias = row->gap / dt;
        soft[0] = soft[1] = 0.0;
        if (row->deep > 0.0) {
            soft[0] = 1.0 / (1.5 * row->hertz * dt * root + row->damper * sqrt(root));
            *bias = -u_n - soft[0] * row->p;
        }
        if (row->shear * root > 0.0)
            soft[1] = 1.0 / (row->shear * root);
    } else if (row->release - free < -(free + row->bias) * push / (push + row->soft_n)) {
        soft[0] = HARD_RELEASE_PART * row->soft_n;
        *bias = HARD_RELEASE_PART * (row->release + row->bias) - row->release;
    }
}

static void vectors_make(struct hard_form *local, const struct net *net, double dt) {
    struct hard_body *body = memory_allocate(net->bodies, sizeof *body, what);
    memcpy(body, net->body, net->bodies * sizeof *body);
    for (size_t c = 0; c < net->records; c++) {
        const struct hard_row *row = &net->record[c].row;
        double back[3] = {-row->q[0], -row->q[1], -row->q[2]};
        hard_apply(row, &body[net->record[c].end[0]], &body[net->record[c].end[1]], -row->p, back);
    }
    for (size_t c = 0; c < net->records; c++) {
        const struct record *record = &net->record[c];
        const uint32_t *end = record->end;
        double after[3], before[3], soft[2], bias;
        velocity_of(record, &net->body[end[0]], &net->body[end[1]], after);
        velocity_of(record, &body[end[0]], &body[end[1]], before);
        springs_of(record, after[0], dt, soft, &bias);
        local->mu[c] = record->row.friction;
        memcpy(&local->id[2 * c], record->id, sizeof record->id);
        for (size_t k = 0; k < 3; k++) {
            size_t at = 3 * c + k;
            local->r[at] = k == 0 ? record->row.p : vector_dot(record->row.q, record->frame[k]);
            local->soft[at] = soft[k > 0];
            local->shift[at] = k == 0 ? bias : -soft[1] * vector_dot(record->row.hold, record->frame[k]);
            local->q[at] = before[k] + local->shift[at];
            local->u[at] = after[k] + local->shift[at] + local->soft[at] * local->r[at];
        }
    }
    memory_free(body);
}

bool hard_form_make(struct hard_form *local, const struct hard_solver *solver,
                    const struct particles *particles) {
    struct net net = {0};
    bool fits = true;
    records_gather(&net, solver, particles);
    *local = (struct hard_form){.contacts = net.records};
    if (net.records > 0) {
        double **vector[] = {&local->q, &local->r, &local->u, &local->soft, &local->shift};
        for (size_t k = 0; k < sizeof vector / sizeof vector[0]; k++)
            *vector[k] = memory_allocate(3 * net.records, sizeof **vector[k], what);
        local->mu = memory_allocate(net.records, sizeof *local->mu, what);
        local->id = memory_allocate(2 * net.records, sizeof *local->id, what);
        bodies_number(&net);
        vectors_make(local, &net, solver->problem.dt);
        fits = matrix_make(local, &net);
    }
    memory_free(net.record);
    memory_free(net.body);
    memory_free(net.first);
    memory_free(net.of);
    return fits;
}

void hard_form_free(struct hard_form *local) {
    memory_free(local->start);
    memory_free(local->row);
    memory_free(local->value);
    memory_free(local->q);
    memory_free(local->mu);
    memory_free(local->r);
    memory_free(local->u);
    memory_free(local->soft);
    memory_free(local->shift);
    memory_free(local->id);
    *local = (struct hard_form){0};
}
