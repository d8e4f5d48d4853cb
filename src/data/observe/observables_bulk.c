/* SPDX-License-Identifier: BSD-3-Clause */
/* Observables of the whole run: energies, momenta, stress, counts. */
#include "data/observe/observables_kinds.h"
#include "base/vector.h"
#include "kernel/particles/spin.h"
#include "kernel/particles/groups.h"
#include "kernel/particles/kinds.h"

#include <math.h>
#include <string.h>

/* Position in the user's coordinates, not wrapped where crossings are counted; the velocity `v` of the particle becomes that of
 * this image (NULL: not wanted). */
static void unwrapped(const struct output_view *view, size_t i, double x[3], double *v) {
    const struct particles *p = view->particles;
    int32_t(*const image)[3] = particles_images(p);
    double shift[3] = {0, 0, 0}, change[3] = {0, 0, 0};
    if (image)
        box_unwrap(view->box, image[i], shift);
    if (image && v && view->box->motion.moves)
        box_unwrap_velocity(view->box, image[i], change);
    for (int d = 0; d < 3; d++)
        x[d] = p->state[i].x[d] + view->box->origin[d] + shift[d];
    for (int d = 0; v && d < 3; d++)
        v[d] += change[d];
}

static bool is_free(const struct particles *particles, size_t i) {
    return particles->state[i].inverse_mass > 0;
}

/* The pose of a body, which has what the masses of its members do not account for; NULL: particle i is none. */
static const struct carried_pose *body_of(const struct output_view *view, size_t i) {
    const struct carried *carried = view->motion->carried;
    const uint8_t *kind = kinds_of(view->particles);
    return carried && kind && kind[i] == KIND_BODY ? &carried->pose[carried->pose_of[i]] : NULL;
}

static bool is_carried(const struct output_view *view, size_t i) {
    const struct carried *carried = view->motion->carried;
    return carried && carried->pose_of[i] >= 0;
}

static void add_kinetic(const struct output_view *view, const struct observable_item *item, size_t i,
                        double *part) {
    (void)item;
    double v[3];
    observables_velocity_of_body(view, i, v);
    if (is_free(view->particles, i))
        part[0] += 0.5 * vector_dot(v, v) / view->particles->state[i].inverse_mass;
}

static void add_rotational(const struct output_view *view, const struct observable_item *item, size_t i,
                           double *part) {
    (void)item;
    const struct particle_state *state = &view->particles->state[i];
    const struct carried_pose *body = body_of(view, i);
    double v[3], w[3], drift[3], square = 0;
    if (body)
        part[0] += body->energy;
    if (!spin_of(view->particles) || !is_free(view->particles, i))
        return;
    integrator_full_step(view->particles, view->motion, i, v, w);
    if (is_carried(view, i)) {
        const struct carried *carried = view->motion->carried;
        const double *centre = carried->pose[carried->pose_of[i]].full_v;
        carried_drift(carried, i, drift);
        for (int d = 0; d < 3; d++)
            square += (v[d] - drift[d] - centre[d]) * (v[d] - drift[d] - centre[d]);
    }
    part[0] += 0.5 * square / state->inverse_mass;
    part[0] +=
        0.2 * state->radius * state->radius * vector_dot(w, w) / state->inverse_mass; /* I = 2/5 m r^2 */
}

static void add_gravity(const struct output_view *view, const struct observable_item *item, size_t i,
                        double *part) {
    (void)item;
    double x[3];
    unwrapped(view, i, x, NULL);
    if (is_free(view->particles, i))
        part[0] -= vector_dot(view->motion->gravity, x) / view->particles->state[i].inverse_mass;
}

static void add_momentum(const struct output_view *view, const struct observable_item *item, size_t i,
                         double *part) {
    (void)item;
    double v[3];
    if (is_carried(view, i) && view->box->motion.moves) /* its own image moves otherwise */
        observables_velocity_of_body(view, i, v);
    else
        observables_velocity(view, i, v, NULL);
    for (int d = 0; is_free(view->particles, i) && d < 3; d++)
        part[d] += v[d] / view->particles->state[i].inverse_mass;
}

static void add_angular_momentum(const struct output_view *view, const struct observable_item *item, size_t i,
                                 double *part) {
    (void)item;
    const struct particle_state *state = &view->particles->state[i];
    const struct carried_pose *body = body_of(view, i);
    double x[3], v[3], w[3] = {0};
    for (int d = 0; body && d < 3; d++)
        part[d] += body->rest[d];
    if (!is_free(view->particles, i))
        return;
    integrator_full_step(view->particles, view->motion, i, v, spin_of(view->particles) ? w : NULL);
    unwrapped(view, i, x, v);
    for (int d = 0; d < 3; d++) {
        int e = (d + 1) % 3, f = (d + 2) % 3;
        part[d] +=
            (x[e] * v[f] - x[f] * v[e] + 0.4 * state->radius * state->radius * w[d]) / state->inverse_mass;
    }
}

static void add_centre(const struct output_view *view, const struct observable_item *item, size_t i,
                       double *part) {
    (void)item;
    double x[3], mass = groups_mass(view->particles, i);
    unwrapped(view, i, x, NULL);
    for (int d = 0; d < 3; d++)
        part[d] += mass * x[d];
    part[3] += mass;
}

static void finish_centre(const struct output_view *view, const struct observable_item *item, double *part) {
    (void)view, (void)item;
    for (int d = 0; d < 3; d++)
        part[d] = part[3] > 0 ? part[d] / part[3] : NAN; /* NAN without particles */
}

static void add_one(const struct output_view *view, const struct observable_item *item, size_t i,
                    double *part) {
    (void)view, (void)item, (void)i;
    part[0] += 1;
}

static void take_speed(const struct output_view *view, const struct observable_item *item, size_t i,
                       double *part) {
    (void)item;
    double v[3];
    observables_velocity(view, i, v, NULL);
    part[0] = fmax(part[0], sqrt(vector_dot(v, v)));
}

static void elastic_normal(const struct observable_context *context, struct observable_item *item,
                           double *part) {
    (void)item;
    part[0] = context->view->sums ? context->view->sums->elastic_normal : 0;
}

static void elastic_tangential(const struct observable_context *context, struct observable_item *item,
                               double *part) {
    (void)item;
    part[0] = context->view->sums ? context->view->sums->elastic_tangential : 0;
}

static void dissipated(const struct observable_context *context, struct observable_item *item, double *part) {
    (void)item;
    const struct force_sums *sums = context->view->sums;
    part[0] = context->view->taken - (sums ? sums->elastic_tangential : 0);
}

static void wall_work(const struct observable_context *context, struct observable_item *item, double *part) {
    (void)item;
    part[0] = context->view->walls ? walls_work(context->view->walls) : 0;
}

/* Every rank knows the free walls: rank 0 gives them. */
static void wall_energy(const struct observable_context *context, struct observable_item *item,
                        double *part) {
    (void)item;
    if (context->view->walls && context->view->comm->rank == 0)
        part[0] = walls_energy(context->view->walls);
}

/* The energy that is constant in a run without error: all forms of energy, plus the energy that left, less
 * the energy that walls brought. */
static void total_of_rank(const struct observable_context *context, struct observable_item *item,
                          double *part) {
    double one[4] = {0};
    elastic_normal(context, item, &one[0]);
    elastic_tangential(context, item, &one[1]);
    dissipated(context, item, &one[2]);
    wall_work(context, item, &one[3]);
    part[0] += one[0] + one[1] + one[2] - one[3] + context->view->held + context->view->gone;
}

static void add_total(const struct output_view *view, const struct observable_item *item, size_t i,
                      double *part) {
    add_kinetic(view, item, i, part);
    add_rotational(view, item, i, part);
    add_gravity(view, item, i, part);
}

static void contacts_of_rank(const struct observable_context *context, struct observable_item *item,
                             double *part) {
    (void)item;
    part[0] = context->view->sums ? 0.5 * (double)context->view->sums->contact_sides : 0;
}

static void overlap_of_rank(const struct observable_context *context, struct observable_item *item,
                            double *part) {
    (void)item;
    part[0] = context->view->sums ? context->view->sums->overlap_max : 0;
}

static void ghosts_of_rank(const struct observable_context *context, struct observable_item *item,
                           double *part) {
    (void)item;
    part[0] = (double)context->view->load.ghosts;
}

static void messages_of_rank(const struct observable_context *context, struct observable_item *item,
                             double *part) {
    (void)item;
    part[0] = (double)context->view->load.messages;
}

static void bytes_of_rank(const struct observable_context *context, struct observable_item *item,
                          double *part) {
    (void)item;
    part[0] = (double)context->view->load.bytes;
}

/* This rank's work over the mean; the largest counts. */
static void imbalance_of_rank(const struct observable_context *context, struct observable_item *item,
                              double *part) {
    (void)item;
    double sum = context->view->load.work;
    comm_sum(context->view->comm, &sum, 1);
    part[0] = sum > 0 ? context->view->load.work * context->view->comm->size / sum : 1;
}

static void sync_of_rank(const struct observable_context *context, struct observable_item *item,
                         double *part) {
    (void)item;
    part[0] = context->view->load.waiting;
    part[1] = context->view->load.waiting + context->view->load.work;
}

static void finish_sync(const struct output_view *view, const struct observable_item *item, double *part) {
    (void)view, (void)item;
    part[0] = part[1] > 0 ? part[0] / part[1] : 0;
}

static bool has_spin(const struct output_view *view) {
    return spin_of(view->particles) != NULL;
}

/* Springs of a solver are no history of the law. */
static bool has_springs(const struct output_view *view) {
    const struct law *law = view->contact ? view->contact->law : NULL;
    return law && (law->history_components > 0 ||
                   (law->options.solved && law->options.tangential != LAW_TANGENTIAL_NONE));
}

static bool has_gravity(const struct output_view *view) {
    return view->staged || vector_dot(view->motion->gravity, view->motion->gravity) > 0;
}

static bool has_walls(const struct output_view *view) {
    return view->staged || (view->walls && walls_count(view->walls) > 0);
}

#define ALL(name, family, unit, components, help)                                                            \
    { name, family, unit, help, OBSERVABLE_OF_ALL, components, NULL }

static const struct observable_kind kinds[] = {
    {.info = ALL("energy_kinetic", "energy", "J", 1,
                 "translational energy of the free particles; of bodies, that of their centres"),
     .parts = 1,
     .of_particle = add_kinetic},
    {.info = ALL("energy_rotational", "energy", "J", 1,
                 "rotational energy of the free particles; of bodies, all but that of their centres"),
     .parts = 1,
     .of_all_kinds = true,
     .of_particle = add_rotational,
     .relevant = has_spin},
    {.info = ALL("energy_gravity", "energy", "J", 1, "potential energy -m g x of the free particles"),
     .parts = 1,
     .of_particle = add_gravity,
     .relevant = has_gravity},
    {.info = ALL("energy_elastic_normal", "energy", "J", 1, "energy stored in normal springs"),
     .parts = 1,
     .needs_sums = true,
     .of_rank = elastic_normal},
    {.info = ALL("energy_elastic_tangential", "energy", "J", 1,
                 "energy stored in tangential and rolling springs"),
     .parts = 1,
     .needs_sums = true,
     .of_rank = elastic_tangential,
     .relevant = has_springs},
    {.info = ALL("energy_dissipated", "energy", "J", 1,
                 "work taken since the start by dampers, sliding and springs of contacts that ended"),
     .parts = 1,
     .needs_sums = true,
     .needs_work = true,
     .of_rank = dissipated},
    {.info = ALL("work_walls", "energy", "J", 1,
                 "work done by walls on particles since the start; of free walls none counts"),
     .parts = 1,
     .of_rank = wall_work,
     .relevant = has_walls},
    {.info = ALL("energy_walls", "", "J", 1,
                 "energy of free walls, part of the balance: of motion and of springs, and of gravity and "
                 "loads from where "
                 "they became free"),
     .parts = 1,
     .of_rank = wall_energy},
    {.info = ALL("energy_balance", "energy", "J", 1,
                 "sum of all energies and of the dissipated energy, less the work of walls: constant except "
                 "for errors of the time step"),
     .parts = 1,
     .needs_sums = true,
     .of_all_kinds = true,
     .of_particle = add_total,
     .needs_work = true,
     .of_rank = total_of_rank},
    {.info = ALL("momentum", "", "kg m/s", 3, "momentum of the free particles"),
     .parts = 3,
     .of_particle = add_momentum},
    {.info = ALL("angular_momentum", "", "kg m2/s", 3,
                 "angular momentum of the free particles about the origin, spin included"),
     .parts = 3,
     .of_all_kinds = true,
     .of_particle = add_angular_momentum},
    {.info = ALL("centre", "", "m", 3, "centre of mass of all particles"),
     .parts = 4,
     .of_particle = add_centre,
     .finish = finish_centre},
    {.info =
         {"stress", "", "Pa",
          "mean stress of the box, or of the particles in a region, positive in compression: kinetic part "
          "and contacts; in two dimensions a force over a length",
          OBSERVABLE_OF_ALL_OR_REGION, 6, "N/m"},
     .parts = 6,
     .needs_sums = true,
     .needs_contacts = true,
     .of_particle = observables_stress_flux,
     .of_rank = observables_stress_contacts,
     .finish = observables_stress_finish,
     .check = observables_volume_check},
    {.info = ALL("particles", "", "1", 1, "number of particles; those of a fluid do not count"),
     .parts = 1,
     .of_particle = add_one},
    {.info = ALL("contacts", "", "1", 1, "number of contacts, walls included"),
     .parts = 1,
     .of_rank = contacts_of_rank},
    {.info = ALL("overlap_max", "", "1", 1, "largest overlap over the smaller radius"),
     .parts = 1,
     .combine = OBSERVABLE_MAX,
     .of_rank = overlap_of_rank},
    {.info = ALL("speed_max", "", "m/s", 1, "largest speed of a particle; those of a fluid do not count"),
     .parts = 1,
     .combine = OBSERVABLE_MAX,
     .of_particle = take_speed},
    {.info = ALL("ghosts", "load", "1", 1, "copies held by all ranks"),
     .parts = 1,
     .of_rank = ghosts_of_rank},
    {.info = ALL("messages", "load", "1", 1, "messages between ranks since the start"),
     .parts = 1,
     .of_rank = messages_of_rank},
    {.info = ALL("bytes", "load", "1", 1, "bytes sent between ranks since the start"),
     .parts = 1,
     .of_rank = bytes_of_rank},
    {.info = ALL("imbalance", "load", "1", 1, "largest over mean time of work of the ranks since the start"),
     .parts = 1,
     .combine = OBSERVABLE_MAX,
     .of_rank = imbalance_of_rank},
    {.info = ALL("sync_share", "load", "1", 1,
                 "communication's share of the time of communication and work since the start"),
     .parts = 2,
     .of_rank = sync_of_rank,
     .finish = finish_sync},
};

#undef ALL

int observables_bulk_count(void) {
    return sizeof kinds / sizeof kinds[0];
}

const struct observable_kind *observables_bulk(int k) {
    return &kinds[k];
}
