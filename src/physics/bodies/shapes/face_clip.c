/* SPDX-License-Identifier: BSD-3-Clause */
/* Cuts one face by the edges of another one. Read face_clip.h first. */
#include "physics/bodies/shapes/face_clip.h"
#include "physics/bodies/shapes/touch_key.h"
#include <math.h>
#include <string.h>

/* Corners that lie outside of an edge by less than this part of the edge are inside. */
static const double on_edge = 1e-9;

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Two axes that make a right-handed frame with the normal. */
static void axes_make(const double normal[3], double axis[2][3]) {
    int least = 0;
    for (int d = 1; d < 3; d++)
        least = fabs(normal[d]) < fabs(normal[least]) ? d : least;
    double length = 0;
    for (int d = 0; d < 3; d++) {
        axis[0][d] = (d == least) - normal[least] * normal[d];
        length += axis[0][d] * axis[0][d];
    }
    for (int d = 0; d < 3; d++)
        axis[0][d] /= sqrt(length);
    for (int d = 0; d < 3; d++) {
        int e = (d + 1) % 3, f = (d + 2) % 3;
        axis[1][d] = normal[e] * axis[0][f] - normal[f] * axis[0][e];
    }
}

/* The plane of a face as heights along the normal. */
static void plane_make(const struct face_clip *clip, const struct posed *posed, int face, const double *apart,
                       const double normal[3], double plane[3]) {
    double own[3];
    posed_normal(posed, face, own);
    double along = dot(own, normal), offset = posed->scale * posed->core->face[face].offset;
    offset += apart ? dot(own, apart) : 0;
    plane[0] = -dot(own, clip->axis[0]) / along;
    plane[1] = -dot(own, clip->axis[1]) / along;
    plane[2] = offset / along;
}

static void project(const struct face_clip *clip, const double corner[3], const double *apart, double at[2]) {
    for (int c = 0; c < 2; c++)
        at[c] = dot(corner, clip->axis[c]) + (apart ? dot(apart, clip->axis[c]) : 0);
}

/* The corner that two edges of a solid have in common. */
static int common(const struct solid *solid, int e, int f) {
    const int *one = solid->edge[e].end, *other = solid->edge[f].end;
    return one[0] == other[0] || one[0] == other[1] ? one[0] : one[1];
}

/* An edge of B, seen from inside on its left. */
struct cut {
    double from[2], along[2];
    int edge;
};

static double side_of(const struct cut *cut, const double at[2]) {
    return cut->along[0] * (at[1] - cut->from[1]) - cut->along[1] * (at[0] - cut->from[0]);
}

/* Where the side behind a corner crosses the cut. */
static struct face_clip_corner crossing(const struct posed *b, const struct cut *cut,
                                        const struct face_clip_corner *from,
                                        const struct face_clip_corner *to, double before, double after) {
    double t = before / (before - after);
    struct face_clip_corner corner = {.edge = from->edge};
    for (int c = 0; c < 2; c++)
        corner.at[c] = from->at[c] + t * (to->at[c] - from->at[c]);
    corner.key = from->edge >= 0 ? touch_key(TOUCH_EDGES, from->edge, cut->edge)
                                 : touch_key(TOUCH_CORNER_B, common(b->core, ~from->edge, cut->edge), 0);
    return corner;
}

/* Leaves what lies on the left of the cut. */
static void cut_by(struct face_clip *clip, const struct posed *b, const struct cut *cut) {
    struct face_clip_corner old[FACE_CLIP_MAX];
    const int count = clip->count;
    const double near = on_edge * (cut->along[0] * cut->along[0] + cut->along[1] * cut->along[1]);
    memcpy(old, clip->corner, (size_t)count * sizeof *old);
    clip->count = 0;
    for (int k = 0; k < count; k++) {
        const struct face_clip_corner *from = &old[k], *to = &old[(k + 1) % count];
        double before = side_of(cut, from->at), after = side_of(cut, to->at);
        bool inside = before >= -near, stays = after >= -near;
        if (inside && clip->count < FACE_CLIP_MAX)
            clip->corner[clip->count++] = *from;
        if (inside == stays || clip->count == FACE_CLIP_MAX)
            continue;
        struct face_clip_corner corner = crossing(b, cut, from, to, before, after);
        corner.edge = inside ? ~cut->edge : from->edge;
        clip->corner[clip->count++] = corner;
    }
}

void face_clip_make(struct face_clip *clip, const struct posed *a, int face_a, const struct posed *b,
                    int face_b, const double apart[3], const double normal[3]) {
    const struct solid_face *fa = &a->core->face[face_a], *fb = &b->core->face[face_b];
    const int *ring_a = a->core->ring + fa->first, *ring_b = b->core->ring + fb->first;
    axes_make(normal, clip->axis);
    plane_make(clip, a, face_a, NULL, normal, clip->plane[0]);
    plane_make(clip, b, face_b, apart, normal, clip->plane[1]);
    clip->count = fa->sides;
    for (int k = 0; k < fa->sides; k++) {
        struct face_clip_corner *corner = &clip->corner[k];
        project(clip, a->corner[ring_a[k]], NULL, corner->at);
        corner->key = touch_key(TOUCH_CORNER_A, ring_a[k], 0);
        corner->edge = a->core->rim[fa->first + k];
    }
    for (int k = 0; k < fb->sides && clip->count > 0;
         k++) { /* seen from A the ring of B runs the other way round */
        double to[2];
        struct cut cut = {.edge = b->core->rim[fb->first + k]};
        project(clip, b->corner[ring_b[(k + 1) % fb->sides]], apart, cut.from);
        project(clip, b->corner[ring_b[k]], apart, to);
        cut.along[0] = to[0] - cut.from[0];
        cut.along[1] = to[1] - cut.from[1];
        cut_by(clip, b, &cut);
    }
}

void face_clip_heights(const struct face_clip *clip, int k, double *of_a, double *of_b) {
    const double *at = clip->corner[k].at;
    *of_a = clip->plane[0][0] * at[0] + clip->plane[0][1] * at[1] + clip->plane[0][2];
    *of_b = clip->plane[1][0] * at[0] + clip->plane[1][1] * at[1] + clip->plane[1][2];
}
