/* SPDX-License-Identifier: BSD-3-Clause */
/* Measures displacements and compares them with the skins. Read skin.h first. */
#include "kernel/pairs/skin.h"
#include "base/memory.h"
#include "kernel/particles/kinds.h"
#include <math.h>
#include <string.h>

struct skin *skin_create(void) {
    return memory_allocate_zero(1, sizeof(struct skin), "skin");
}

void skin_destroy(struct skin **skin) {
    if (*skin == NULL)
        return;
    memory_free((*skin)->anchor);
    memory_free(*skin);
    *skin = NULL;
}

void skin_release(struct skin *skin) {
    memory_free(skin->anchor);
    skin->anchor = NULL;
    skin->capacity = 0;
    skin->anchored = false;
}

void skin_follow(struct skin *skin, const struct box *box) {
    skin->box = box;
}

double skin_speed2(const struct box *box, const struct particle_state *state, double dt) {
    double flow[3], x[3], square = 0;
    for (int d = 0; d < 3; d++)
        x[d] = state->x[d] - dt * state->v[d];
    box_flow(box, x, flow);
    for (int d = 0; d < 3; d++)
        square += (state->v[d] - flow[d]) * (state->v[d] - flow[d]);
    return square;
}

/* The flow at the place of a particle differs from that at its place in the frame of the rebuild by no more than
 * the rates of the box times the displacement; and the middle of a box that strains, where the flow of a shear is
 * 0, moves in the step. */
static void skin_strain(struct skin *skin, int classes, double dt) {
    const struct box *box = skin->box;
    const struct box_motion *motion = &box->motion;
    double nearing = box_nearing(box, &skin->then);
    double rate = box_rate(box), growth = 1 / fmax(1 - rate * dt, 0.5);
    /* of second order: the flow changes in the step, and the point at which it is 0 moves */
    double middle = rate * rate * dt * (box->edge[0] + box->edge[1] + box->edge[2]);
    if (motion->shears)
        middle += 0.5 * fabs(motion->speed[motion->flow] *
                             (motion->offset / box->edge[motion->flow] -
                              skin->then.motion.offset / skin->then.edge[motion->flow]));
    middle *= dt;
    for (int c = 0; c < classes; c++) {
        skin->bound[c] = skin->bound[c] * growth + middle;
        skin->second[c] = skin->second[c] * growth + middle;
    }
    skin->nearing_growth = fmax(nearing - skin->nearing, 0);
    skin->nearing = nearing;
}

void skin_moved(struct skin *skin, const double *speed, int classes, double dt, double walls) {
    memcpy(skin->before, skin->bound, sizeof skin->before);
    skin->moves++;
    for (int c = 0; c < classes; c++) {
        skin->bound[c] += speed[c] * dt;
        skin->second[c] += speed[c] * dt;
    }
    if (skin->box)
        skin_strain(skin, classes, dt);
    skin->bound[classes] = walls;
    skin->second[classes] = 0;
}

void skin_settle(struct skin *skin, int classes) {
    for (int c = 0; c <= classes; c++)
        skin->growth[c] = skin->bound[c] - skin->before[c];
}

/* The two largest squared displacements of each class. */
struct largest {
    double first[CLASS_MAX], second[CLASS_MAX];
};

static void largest_put(struct largest *largest, int c, double d2) {
    if (d2 > largest->first[c]) {
        largest->second[c] = largest->first[c];
        largest->first[c] = d2;
    } else if (d2 > largest->second[c]) {
        largest->second[c] = d2;
    }
}

static double displacement2(const struct skin *skin, const double anchor[3], const double x[3]) {
    double square = 0, flown[3] = {0, 0, 0};
    if (skin->box)
        box_affine(skin->box, &skin->then, anchor, flown);
    for (int d = 0; d < 3; d++) {
        double moved = x[d] - anchor[d] - flown[d];
        square += moved * moved;
    }
    return square;
}

void skin_measure(struct skin *skin, const struct particles *particles, int classes) {
    struct largest all = {0};
    if (!skin->anchored)
        return;
#pragma omp parallel
    {
        struct largest mine = {0};
#pragma omp for schedule(static)
        for (size_t k = 0; k < particles->owned; k++) {
            double d2 = displacement2(skin, skin->anchor[k], particles->state[k].x);
            largest_put(&mine, particles->size_class[k], d2);
        }
#pragma omp critical(skin_largest)
        for (int c = 0; c < classes; c++) {
            largest_put(&all, c, mine.first[c]);
            largest_put(&all, c, mine.second[c]);
        }
    }
    for (int c = 0; c < classes; c++) {
        skin->bound[c] = sqrt(all.first[c]);
        skin->second[c] = sqrt(all.second[c]);
    }
}

/* Class pairs that are not wanted have no skin to use up; walls (b = count) always count, but for bodies, which
 * meet no wall: their members do. */
static bool counts(const struct size_classes *classes, int a, int b) {
    return b == classes->count ? classes->kind[a] != KIND_BODY : classes_meet(classes, a, b);
}

/* The bounds, each grown by `more` x its last growth. */
struct grown {
    double first[CLASS_MAX + 1], second[CLASS_MAX + 1], nearing;
};

static void grown_set(const struct skin *skin, const struct size_classes *classes, double more,
                      struct grown *grown) {
    grown->nearing = skin->nearing + more * skin->nearing_growth;
    for (int c = 0; c <= classes->count; c++) {
        grown->first[c] = skin->bound[c] + more * skin->growth[c];
        grown->second[c] = skin->second[c] + more * skin->growth[c];
    }
}

/* The distance by which two particles of the classes a and b may have approached each other; b >= a may be
 * walls. */
static double approach(const struct grown *grown, const struct size_classes *classes, int a, int b) {
    double moved = grown->first[a] + (a == b ? grown->second[b] : grown->first[b]);
    if (grown->nearing > 0 && b < classes->count && counts(classes, a, b))
        moved += grown->nearing * (classes->radius_max[a] + classes->radius_max[b] + classes->margin[a][b]);
    return moved;
}

/* True if the bounds, each grown by `more` x its last growth, exceed a skin. */
static bool exceeded(const struct skin *skin, const struct size_classes *classes, double more) {
    struct grown grown;
    grown_set(skin, classes, more, &grown);
    for (int a = 0; a < classes->count; a++) {
        for (int b = a; b <= classes->count;
             b++) { /* the last is walls; walls among themselves do not matter */
            double moved = approach(&grown, classes, a, b);
            bool still = moved == 0;
            if (!still && moved > classes->skin[a][b] && counts(classes, a, b))
                return true;
        }
    }
    return false;
}

static void anchors_note(struct skin *skin, const struct particles *particles) {
    if (particles->owned > skin->capacity) {
        skin->capacity = particles->owned + particles->owned / 32;
        memory_free(skin->anchor);
        skin->anchor = memory_allocate(skin->capacity, sizeof *skin->anchor, "positions at the rebuild");
    }
#pragma omp parallel for schedule(static)
    for (size_t k = 0; k < particles->owned; k++)
        memcpy(skin->anchor[k], particles->state[k].x, sizeof *skin->anchor);
}

void skin_reset(struct skin *skin, const struct particles *particles, const struct size_classes *classes,
                double steps) {
    memset(skin->bound, 0, sizeof skin->bound);
    memset(skin->second, 0, sizeof skin->second);
    skin->nearing = 0;
    skin->anchored = steps == 0 || exceeded(skin, classes, 2 * steps);
    if (skin->anchored)
        anchors_note(skin, particles);
    skin->moves = 0;
    skin->rebuilds++;
    skin->nearing_growth = 0;
    if (skin->box)
        skin->then = *skin->box;
}

double skin_used(const struct skin *skin, const struct size_classes *classes) {
    struct grown grown;
    double used = 0;
    grown_set(skin, classes, 0, &grown);
    for (int a = 0; a < classes->count; a++)
        for (int b = a; b <= classes->count; b++)
            if (classes->skin[a][b] > 0 && counts(classes, a, b))
                used = fmax(used, approach(&grown, classes, a, b) / classes->skin[a][b]);
    return used;
}

bool skin_due(const struct skin *skin, const struct size_classes *classes) {
    return exceeded(skin, classes, 0);
}

bool skin_surely_due(const struct skin *skin, const struct size_classes *classes) {
    const double rounding = 1 - 1e-6;
    for (int a = 0; a < classes->count && skin->moves == 1; a++)
        for (int b = 0; b <= classes->count; b++)
            if (skin->bound[a] * rounding > classes->skin[a][b] && counts(classes, a, b))
                return true;
    return false;
}

bool skin_nearly_due(const struct skin *skin, const struct size_classes *classes) {
    return exceeded(skin, classes, 1);
}
