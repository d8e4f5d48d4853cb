/* SPDX-License-Identifier: BSD-3-Clause */
/* Observables of the state of a packing, whether it rests and how it fills, and of the particles that came and went.
 * Read observables_kinds.h first. */
#include "kernel/particles/groups.h"
#include "data/observe/crossing.h"
#include "data/observe/observables_kinds.h"

#include <math.h>

static double length(const double a[3]) {
    return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

static void add_kinetic_mean(const struct output_view *view, const struct observable_item *item, size_t i,
                             double *part) {
    double v[3], inverse = view->particles->state[i].inverse_mass;
    if (!(inverse > 0) || !observables_item_counts(view, item, i))
        return;
    observables_velocity_of_body(view, i, v);
    part[0] += 0.5 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / inverse;
    part[1] += 1;
}

/* part[0] over part[1]; NAN without particles. */
static void finish_mean(const struct output_view *view, const struct observable_item *item, double *part) {
    (void)view, (void)item;
    part[0] = part[1] > 0 ? part[0] / part[1] : NAN;
}

/* The sum of forces on a free particle, gravity included. */
static void add_unbalanced(const struct output_view *view, const struct observable_item *item, size_t i,
                           double *part) {
    (void)item;
    const struct particles *p = view->particles;
    const double *force = p->force + i * (size_t)p->force_stride;
    double sum[3], inverse = p->state[i].inverse_mass;
    if (!(inverse > 0))
        return;
    for (int d = 0; d < 3; d++)
        sum[d] = d < view->box->dimension ? force[d] + view->motion->gravity[d] / inverse : 0;
    part[0] += length(sum);
    part[1] += 1;
}

static void contact_forces(const struct observable_context *context, struct observable_item *item,
                           double *part) {
    (void)item;
    const struct contact_list *list = context->contacts;
    for (size_t k = 0; k < list->particle_count; k++)
        part[2] += length(list->particle[k].force);
    for (size_t k = 0; k < list->wall_count; k++)
        part[2] += length(list->wall[k].force);
    part[3] += (double)(list->particle_count + list->wall_count);
}

static void finish_unbalanced(const struct output_view *view, const struct observable_item *item,
                              double *part) {
    (void)view, (void)item;
    part[0] = part[1] > 0 && part[2] > 0 ? (part[0] / part[1]) / (part[2] / part[3]) : NAN;
}

/* Sides of contacts that touch, of particles that count. */
static void contact_sides(const struct observable_context *context, struct observable_item *item,
                          double *part) {
    const struct contact_list *list = context->contacts;
    for (size_t k = 0; k < list->particle_count; k++) {
        const struct force_contact *contact = &list->particle[k];
        if (contact->overlap > 0)
            part[0] += observables_item_counts(context->view, item, contact->number_i) +
                       observables_item_counts(context->view, item, contact->number_j);
    }
    for (size_t k = 0; k < list->wall_count; k++)
        if (list->wall[k].overlap > 0)
            part[0] += observables_item_counts(context->view, item, list->wall[k].number_i);
}

static void add_counted(const struct output_view *view, const struct observable_item *item, size_t i,
                        double *part) {
    part[1] += observables_item_counts(view, item, i);
}

/* Volumes; in two dimensions the areas of discs. */
static void add_solid(const struct output_view *view, const struct observable_item *item, size_t i,
                      double *part) {
    if (observables_item_counts(view, item, i))
        part[0] += observables_solid(view, i);
}

static void finish_solid(const struct output_view *view, const struct observable_item *item, double *part) {
    part[0] /= observables_volume(view->box, item->region);
}

static void inserted(const struct observable_context *context, struct observable_item *item, double *part) {
    (void)item;
    if (context->view->comm->rank == 0)
        part[0] = (double)context->view->turnover.inserted;
}

static void inserted_mass(const struct observable_context *context, struct observable_item *item,
                          double *part) {
    (void)item;
    if (context->view->comm->rank == 0)
        part[0] = context->view->turnover.inserted_mass;
}

static void deleted(const struct observable_context *context, struct observable_item *item, double *part) {
    (void)item;
    if (context->view->comm->rank == 0)
        part[0] = (double)context->view->turnover.deleted;
}

static void deleted_mass(const struct observable_context *context, struct observable_item *item,
                         double *part) {
    (void)item;
    part[0] = context->view->turnover.deleted_mass;
}

static void add_crossed(const struct output_view *view, const struct observable_item *item, size_t i,
                        double *part) {
    part[0] += crossing_number(view->box, &item->planes[item->plane], view->particles, i);
}

static void crossed_before(const struct observable_context *context, struct observable_item *item,
                           double *part) {
    part[0] += context->view->crossing[item->plane].particles;
}

static void add_crossed_mass(const struct output_view *view, const struct observable_item *item, size_t i,
                             double *part) {
    part[0] += crossing_number(view->box, &item->planes[item->plane], view->particles, i) *
               groups_mass(view->particles, i);
}

static void crossed_mass_before(const struct observable_context *context, struct observable_item *item,
                                double *part) {
    part[0] += context->view->crossing[item->plane].mass;
}

#define OF(target, name, family, unit, help)                                                                 \
    { name, family, unit, help, OBSERVABLE_OF_##target, 1, NULL }

static const struct observable_kind kinds[] = {
    {.info = OF(ALL_OR_REGION, "energy_kinetic_mean", "", "J",
                "translational energy of a free particle, mean of all or of those in a region; a member of a "
                "body moves as its centre"),
     .parts = 2,
     .of_particle = add_kinetic_mean,
     .finish = finish_mean},
    {.info = OF(ALL, "unbalanced_force", "", "1",
                "mean force on a free particle, gravity included, over the mean force of a contact: small at "
                "rest; nan "
                "without contacts"),
     .parts = 4,
     .lists_contacts = true,
     .of_particle = add_unbalanced,
     .of_rank = contact_forces,
     .finish = finish_unbalanced},
    {.info = OF(
         ALL_OR_REGION, "coordination", "", "1",
         "mean number of contacts of a particle, walls included, of all particles or of those in a region"),
     .parts = 2,
     .lists_contacts = true,
     .of_particle = add_counted,
     .of_rank = contact_sides,
     .finish = finish_mean},
    {.info =
         OF(ALL_OR_REGION, "solid_fraction", "", "1",
            "volume of the particles whose centres are in a region, or in the box, over its volume; in two "
            "dimensions areas of discs; of bodies their own volumes"),
     .parts = 1,
     .of_particle = add_solid,
     .finish = finish_solid,
     .check = observables_volume_check},
    {.info =
         OF(ALL, "inserted", "turnover", "1", "particles inserted since the start of the run, over resumes"),
     .parts = 1,
     .of_rank = inserted},
    {.info = OF(ALL, "inserted_mass", "turnover", "kg",
                "mass of the particles inserted since the start of the run"),
     .parts = 1,
     .of_rank = inserted_mass},
    {.info = OF(ALL, "deleted", "turnover", "1",
                "particles deleted since the start of the run, by deletions and by box.leave"),
     .parts = 1,
     .of_rank = deleted},
    {.info = OF(ALL, "deleted_mass", "turnover", "kg",
                "mass of the particles deleted since the start of the run"),
     .parts = 1,
     .of_rank = deleted_mass},
    {.info = OF(PLANE, "crossed", "crossing", "1",
                "particles that have crossed a plane along its normal since the start of the run, less those "
                "that came back"),
     .parts = 1,
     .of_particle = add_crossed,
     .of_rank = crossed_before},
    {.info = OF(PLANE, "crossed_mass", "crossing", "kg",
                "their mass: the slope over time is the mass flow through the plane"),
     .parts = 1,
     .of_particle = add_crossed_mass,
     .of_rank = crossed_mass_before},
};

#undef OF

int observables_state_count(void) {
    return sizeof kinds / sizeof kinds[0];
}

const struct observable_kind *observables_state(int k) {
    return &kinds[k];
}
