/* SPDX-License-Identifier: BSD-3-Clause */
/* The mean stress, of the whole box or of the particles whose centres lie in a region:
 *
 *     sigma = (sum over free particles of m v (x) v  +  sum over contacts of w l (x) f) / V
 *
 * Here l is the vector from one centre to the other, or from the centre to the wall, and f the force along l
 * (on the second particle, on the wall), so that pressure is positive. Off the diagonal sigma is the mean of
 * ij and ji. For the box every w is 1. For a region, a contact of two particles counts one half for each of
 * the two that lies in the region, and a contact with a wall counts 1 if its particle lies in the region; a
 * region that is the whole box gives the stress of the box. The static part is that of Christoffersen,
 * Mehrabadi and Nemat-Nasser, J. Appl. Mech. 48 (1981) 339; shared out by halves, particles at the rim of a
 * small region count with parts that lie outside, so the error goes with diameter over width. The kinetic
 * part uses v itself, the mean flow included; in a box that moves, v relative to its mean flow (box_flow), as
 * images of a particle have different velocities there.
 *
 * A force on a grain that a body carries acts at the centre of the body, and the velocity of this centre counts: what holds the
 * body together then has no part in the stress (carried_stress). */
#include "data/observe/observables_kinds.h"

#include <math.h>

void observables_stress_flux(const struct output_view *view, const struct observable_item *item, size_t i,
                             double *part) {
    double v[3], flow[3], inverse = view->particles->state[i].inverse_mass;
    if (!(inverse > 0) || !observables_item_counts(view, item, i))
        return;
    integrator_full_step(view->particles, view->motion, i, v, NULL);
    if (view->motion->carried && view->motion->carried->pose_of[i] >= 0)
        carried_stress(view->motion->carried, view->particles, i, true, v, part);
    if (view->box->motion.moves) {
        box_flow(view->box, view->particles->state[i].x, flow);
        for (int d = 0; d < 3; d++)
            v[d] -= flow[d];
    }
    const double flux[6] = {v[0] * v[0], v[1] * v[1], v[2] * v[2], v[0] * v[1], v[0] * v[2], v[1] * v[2]};
    for (int c = 0; c < 6; c++)
        part[c] += flux[c] / inverse;
}

static void add_contact(const struct force_contact *contact, double weight, double *part) {
    static const int row[6] = {0, 1, 2, 0, 0, 1}, column[6] = {0, 1, 2, 1, 2, 2};
    const double *l = contact->branch, *f = contact->force;
    for (int c = 0; c < 6; c++)
        part[c] += weight * 0.5 * (l[row[c]] * f[column[c]] + l[column[c]] * f[row[c]]);
}

void observables_stress_contacts(const struct observable_context *context, struct observable_item *item,
                                 double *part) {
    const struct output_view *view = context->view;
    if (item->region == NULL) {
        for (int c = 0; view->sums && c < 6; c++)
            part[c] += view->sums->virial[c];
        return;
    }
    const struct contact_list *list = context->contacts;
    for (size_t k = 0; k < list->particle_count; k++) {
        const struct force_contact *contact = &list->particle[k];
        int inside = observables_item_counts(view, item, contact->number_i) +
                     observables_item_counts(view, item, contact->number_j);
        add_contact(contact, 0.5 * inside, part);
    }
    for (size_t k = 0; k < list->wall_count; k++)
        add_contact(&list->wall[k], observables_item_counts(view, item, list->wall[k].number_i), part);
}

/* The part of a region along a direction: [from, to) of the box's, in the user's coordinates. */
struct extent {
    double from, to;
};

static double length_inside(const struct box *box, int d, struct extent extent) {
    double from = fmax(extent.from, box->origin[d]), to = fmin(extent.to, box->origin[d] + box->edge[d]);
    return to > from ? to - from : 0;
}

static bool is_inside(const struct box *box, int d, struct extent extent) {
    double spare = 1e-9 * box->edge[d];
    return extent.from >= box->origin[d] - spare && extent.to <= box->origin[d] + box->edge[d] + spare;
}

/* The plane of a flat scene. */
static double plane_of(const struct box *box) {
    return box->origin[2] + box->edge[2] / 2;
}

static double box_volume(const struct output_region *region, const struct box *box) {
    double volume = 1;
    for (int d = 0; d < box->dimension; d++)
        volume *= length_inside(box, d, (struct extent){region->lower[d], region->upper[d]});
    if (box->dimension == 2 && !(region->lower[2] <= plane_of(box) && plane_of(box) < region->upper[2]))
        return 0;
    return volume;
}

/* The volume of a sphere that lies in the box; in two dimensions the area of its cut with the plane. */
static double sphere_volume(const struct output_region *region, const struct box *box) {
    double square = region->radius * region->radius, off = region->centre[2] - plane_of(box);
    if (box->dimension == 2)
        square -= off * off;
    double radius = square > 0 ? sqrt(square) : 0;
    for (int d = 0; d < box->dimension; d++)
        if (!is_inside(box, d, (struct extent){region->centre[d] - radius, region->centre[d] + radius}))
            return 0;
    return box->dimension == 2 ? M_PI * square : 4 * M_PI / 3 * square * radius;
}

static bool is_along(const double axis[3], int d) {
    double other = hypot(axis[(d + 1) % 3], axis[(d + 2) % 3]);
    return other <= 1e-12 * fabs(axis[d]);
}

/* The volume of a cylinder along a direction of the box (cut at its sides), or of a cylinder that lies in the
 * box. */
static double cylinder_volume(const struct output_region *region, const struct box *box) {
    const double *axis = region->axis;
    double norm = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    double half = region->length > 0 ? region->length / 2 : INFINITY, length = region->length;
    for (int d = 0; d < 3; d++) {
        double c = region->centre[d], along = fabs(axis[d]) / norm;
        if (is_along(axis, d)) {
            length = length_inside(box, d, (struct extent){c - half, c + half});
            continue;
        }
        double reach = region->radius * sqrt(fmax(1 - along * along, 0)) + (along > 0 ? half * along : 0);
        if (d < box->dimension && !is_inside(box, d, (struct extent){c - reach, c + reach}))
            return 0;
    }
    double section = M_PI * region->radius * region->radius;
    if (box->dimension == 3)
        return section * length;
    bool cuts = is_along(axis, 2) && fabs(region->centre[2] - plane_of(box)) < half;
    return cuts ? section : 0;
}

/* Volume, in two dimensions area, of the part of a region that lies in the box; 0 where it is not known. */
static double region_volume(const struct output_region *region, const struct box *box) {
    switch (region->shape) {
    case OUTPUT_REGION_BOX:
        return box_volume(region, box);
    case OUTPUT_REGION_SPHERE:
        return sphere_volume(region, box);
    default:
        return cylinder_volume(region, box);
    }
}

double observables_volume(const struct box *box, const struct output_region *region) {
    if (region)
        return region_volume(region, box);
    return box->edge[0] * box->edge[1] * (box->dimension == 2 ? 1 : box->edge[2]);
}

bool observables_volume_check(const struct output_view *view, const struct output_region *region,
                              struct error *error) {
    return region_volume(region, view->box) > 0 ||
           error_set(error, ERROR_USER,
                     "observables: the volume of region \"%s\" is not known: it must be a box (cut at "
                     "the simulation's sides), or lie inside of that; only a cylinder along x, y or z may be "
                     "longer",
                     region->name);
}

void observables_stress_finish(const struct output_view *view, const struct observable_item *item,
                               double *part) {
    double volume = observables_volume(view->box, item->region);
    for (int c = 0; c < 6; c++)
        part[c] /= volume;
}
