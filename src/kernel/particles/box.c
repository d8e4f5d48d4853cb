/* SPDX-License-Identifier: BSD-3-Clause */
/* Images of the box and its motion. Read box.h first. */
#include "kernel/particles/box.h"
#include <stddef.h>

/* Fills row[code] with the sums of three vectors, times those of the image. */
static void images_fill(double vector[3][3], double row[IMAGE_CODES][4]) {
    for (int sz = -1; sz <= 1; sz++)
        for (int sy = -1; sy <= 1; sy++)
            for (int sx = -1; sx <= 1; sx++) {
                double *sum = row[image_code(sx, sy, sz)];
                const int image[3] = {sx, sy, sz};
                for (int c = 0; c < 3; c++) {
                    sum[c] = image[c] * vector[c][c];
                    for (int d = 0; d < 3; d++)
                        if (d != c && vector[d][c] != 0)
                            sum[c] += image[d] * vector[d][c];
                }
                sum[3] = 0;
            }
}

void box_image_shifts(const struct box *box, double shift[IMAGE_CODES][4]) {
    double vector[3][3] = {{0}};
    for (int d = 0; d < 3; d++)
        vector[d][d] = box->edge[d];
    if (box->motion.shears)
        vector[box->motion.gradient][box->motion.flow] = box->motion.offset;
    images_fill(vector, shift);
}

void box_image_velocities(const struct box *box, double velocity[IMAGE_CODES][4]) {
    double vector[3][3] = {{0}};
    for (int d = 0; d < 3; d++)
        vector[d][d] = box->motion.speed[d];
    if (box->motion.shears)
        vector[box->motion.gradient][box->motion.flow] = box->motion.slide;
    images_fill(vector, velocity);
}

void box_images(const struct box *box, const double vector[3], int32_t image[3]) {
    const struct box_motion *motion = &box->motion;
    for (int k = 0; k < 3; k++) {
        int d = motion->shears ? (motion->gradient + k) % 3 : k;
        bool carried = motion->shears && d == motion->flow;
        double along = vector[d] - (carried ? image[motion->gradient] * motion->offset : 0);
        image[d] = box->periodic[d] ? (int32_t)rint(along / box->edge[d]) : 0;
    }
}

void box_unwrap(const struct box *box, const int32_t crossed[3], double shift[3]) {
    const struct box_motion *motion = &box->motion;
    for (int d = 0; d < 3; d++)
        shift[d] = crossed[d] * box->edge[d];
    if (motion->shears)
        shift[motion->flow] +=
            crossed[motion->gradient] * (motion->offset + motion->turns * box->edge[motion->flow]);
}

void box_unwrap_velocity(const struct box *box, const int32_t crossed[3], double change[3]) {
    const struct box_motion *motion = &box->motion;
    box_drift(box, crossed, change);
    if (motion->shears)
        change[motion->flow] += crossed[motion->gradient] * motion->turns * motion->speed[motion->flow];
}

void box_wrap(const struct box *box, double x[3], double velocity[3]) {
    const struct box_motion *motion = &box->motion;
    for (int k = 0; k < 3; k++) {
        int d = motion->shears ? (motion->gradient + k) % 3 : k;
        double turns = box->periodic[d] ? floor(x[d] / box->edge[d]) : 0;
        bool slides = motion->shears && d == motion->gradient;
        if (turns == 0)
            continue;
        x[d] -= turns * box->edge[d];
        if (slides)
            x[motion->flow] -= turns * motion->offset;
        if (velocity == NULL || !motion->moves)
            continue;
        velocity[d] -= turns * motion->speed[d];
        if (slides)
            velocity[motion->flow] -= turns * motion->slide;
    }
}

bool box_follow(struct box *box, double change[4]) {
    struct box_motion *motion = &box->motion;
    double slide = motion->shears ? motion->shear * box->edge[motion->gradient] +
                                        motion->stretch[motion->flow] * motion->offset
                                  : 0;
    change[3] = slide - motion->slide;
    motion->slide = slide;
    bool changes = change[3] != 0;
    for (int d = 0; d < 3; d++) {
        double speed = motion->stretch[d] * box->edge[d];
        change[d] = speed - motion->speed[d];
        motion->speed[d] = speed;
        changes = changes || change[d] != 0;
    }
    return changes;
}

void box_accelerate(const struct box *box, const double change[4], const double x[3], double velocity[3]) {
    const struct box_motion *motion = &box->motion;
    for (int d = 0; d < 3; d++)
        velocity[d] = change[d] * (x[d] / box->edge[d]);
    if (!motion->shears)
        return;
    double slide = change[3] - change[motion->flow] * motion->offset / box->edge[motion->flow];
    velocity[motion->flow] += slide * (x[motion->gradient] / box->edge[motion->gradient] - 0.5);
}

void box_flow(const struct box *box, const double x[3], double velocity[3]) {
    const double *speed = box->motion.speed;
    box_accelerate(box, (double[4]){speed[0], speed[1], speed[2], box->motion.slide}, x, velocity);
}

double box_rate(const struct box *box) {
    const struct box_motion *motion = &box->motion;
    double rate = 0;
    for (int d = 0; d < 3; d++)
        rate += fabs(motion->speed[d] / box->edge[d]);
    if (motion->shears)
        rate += fabs(motion->slide - motion->speed[motion->flow] * motion->offset / box->edge[motion->flow]) /
                box->edge[motion->gradient];
    return rate;
}

void box_advance(struct box *box, double dt) {
    box->motion.offset += dt * box->motion.slide;
    for (int d = 0; d < 3; d++)
        box->edge[d] += dt * box->motion.speed[d];
}

void box_settle(struct box *box) {
    struct box_motion *motion = &box->motion;
    if (!motion->shears)
        return;
    double turns = floor(motion->offset / box->edge[motion->flow] + 0.5);
    motion->offset -= turns * box->edge[motion->flow];
    motion->slide -= turns * motion->speed[motion->flow];
    motion->turns += turns;
}

/* The part of the deformation that shears: displacement along the flow per length along the gradient. */
static double sheared(const struct box *now, const struct box *then) {
    int flow = now->motion.flow, gradient = now->motion.gradient;
    double growth = now->edge[flow] / then->edge[flow];
    double turned = (now->motion.turns - then->motion.turns) * now->edge[flow];
    return (now->motion.offset + turned - growth * then->motion.offset) / then->edge[gradient];
}

void box_affine(const struct box *now, const struct box *then, const double x[3], double u[3]) {
    int gradient = now->motion.gradient;
    for (int d = 0; d < 3; d++)
        u[d] = (now->edge[d] / then->edge[d] - 1) * x[d];
    if (now->motion.shears)
        u[now->motion.flow] += sheared(now, then) * (x[gradient] - 0.5 * then->edge[gradient]);
}

double box_nearing(const struct box *now, const struct box *then) {
    int flow = now->motion.flow, gradient = now->motion.gradient;
    double least = 1;
    for (int d = 0; d < now->dimension; d++)
        least = fmin(least, now->edge[d] / then->edge[d]);
    if (now->motion.shears) { /* the smallest singular value of [a b; 0 c] */
        double a = now->edge[flow] / then->edge[flow], c = now->edge[gradient] / then->edge[gradient];
        double b = sheared(now, then), sum = hypot(a + c, b), difference = hypot(a - c, b);
        least = fmin(least, 0.5 * (sum - difference));
    }
    return 1 - least;
}

bool box_may_lose(const struct box *box) {
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++)
            if (!box->periodic[d] && box->leave[d][side] == BOX_DELETE)
                return true;
    return false;
}
