/* SPDX-License-Identifier: BSD-3-Clause */
/* The particles of a simulation in another program: fields, box, particles that come and go. Read scree.h first. */
#include "front/library/scree_parts.h"
#include "base/memory.h"
#include "data/scene/scene_shapes.h"
#include "engine/sources.h"
#include "kernel/particles/fields.h"
#include <math.h>
#include <string.h>

struct scree_box scree_box(const struct scree_simulation *simulation) {
    if (simulation == NULL || simulation->state == NULL)
        return (struct scree_box){.dimension = 3};
    const struct box *box = &simulation->state->box;
    struct scree_box out = {.dimension = box->dimension};
    memcpy(out.origin, box->origin, sizeof out.origin);
    memcpy(out.edge, box->edge, sizeof out.edge);
    memcpy(out.periodic, box->periodic, sizeof out.periodic);
    return out;
}

static const struct particles *particles_of(const struct scree_simulation *simulation) {
    return simulation && simulation->state ? simulation->state->particles : NULL;
}

bool scree_field(const struct scree_simulation *simulation, const char *name, struct scree_field *field) {
    static const enum scree_type types[] = {[FIELD_DOUBLE] = SCREE_DOUBLE,
                                            [FIELD_INT64] = SCREE_INT64,
                                            [FIELD_INT32] = SCREE_INT32,
                                            [FIELD_UINT8] = SCREE_UINT8};
    const struct particles *particles = particles_of(simulation);
    int f = particles && name && field ? fields_find(particles, name) : -1;
    if (f < 0)
        return false;
    const struct field *row = fields_get(particles, f);
    *field = (struct scree_field){.type = types[row->type],
                                  .components = row->components,
                                  .count = particles->owned,
                                  .unit = row->unit ? row->unit : ""};
    field->data = fields_base(particles, f, &field->stride);
    return true;
}

const char *scree_field_name(const struct scree_simulation *simulation, int k) {
    const struct particles *particles = particles_of(simulation);
    return particles && k >= 0 && k < fields_count(particles) ? fields_get(particles, k)->name : NULL;
}

void scree_changed(struct scree_simulation *simulation) {
    if (simulation == NULL || simulation->state == NULL)
        return;
    simulation->changed = true;
    simulation->state->classes_stale = true;
}

/* Mass over volume of a new particle. */
static double density_of(const struct scree_simulation *simulation, const struct scree_particle *p) {
    double given = p->density > 0 ? p->density : simulation->scene->material[p->material].density;
    return particles_density(&simulation->state->box, p->radius, given);
}

/* The form of what a particle becomes. False, with an error, where no entry has the name, or it cannot be turned so. */
static bool form_of(const struct scree_simulation *simulation, const struct scree_particle *p, size_t k,
                    struct source_form *form, struct error *error) {
    const struct scene_shapes *shapes = simulation->scene->shapes;
    const double *q = p->orientation;
    const bool turned = q[0] != 0 || q[1] != 0 || q[2] != 0 || q[3] != 0;
    char why[1200];
    *form = (struct source_form){.shape = p->shape ? -1 : 0, .ball = 1};
    if (turned && !scene_shapes_may_turn(q, simulation->state->box.dimension))
        return error_set(
            error, ERROR_USER,
            "new particle %zu: its orientation must be finite, and in two dimensions about z alone", k);
    if (p->shape == NULL || p->shape[0] == '\0')
        return true;
    const int entry = scene_shapes_find(shapes, p->shape, why, sizeof why);
    if (entry < 0)
        return error_set(error, ERROR_USER, "new particle %zu: shape: %s", k, why);
    *form = shapes->entry[entry].form;
    return true;
}

/* Refuses a particle that cannot be. */
static bool particle_suits(const struct scree_simulation *simulation, const struct scree_particle *p,
                           size_t k, struct error *error) {
    const struct scene *scene = simulation->scene;
    const struct box *box = &simulation->state->box;
    bool finite = isfinite(p->radius) && p->radius > 0 && isfinite(p->density) && p->density >= 0;
    for (int d = 0; d < 3; d++)
        finite = finite && isfinite(p->position[d] + p->velocity[d] + p->angular_velocity[d]);
    if (!finite)
        return error_set(error, ERROR_USER,
                         "new particle %zu: numbers must be finite, radius > 0 and density >= 0", k);
    if (p->group < 0 || p->group >= scene->groups || p->material < 0 ||
        p->material >= (scene->materials > 0 ? scene->materials : 1))
        return error_set(error, ERROR_USER,
                         "new particle %zu: the scene has no material %d or no group %d; there are %d and %d",
                         k, p->material, p->group, scene->materials, scene->groups);
    for (int d = 0; d < box->dimension; d++) {
        double x = p->position[d] - box->origin[d];
        if (x < 0 || x >= box->edge[d])
            return error_set(error, ERROR_USER, "new particle %zu: %c = %.9g is outside of the box", k,
                             'x' + d, p->position[d]);
    }
    if (p->density == 0 && scene->materials == 0)
        return error_set(error, ERROR_USER, "new particle %zu: needs a density, as there are no materials",
                         k);
    double mass = particles_sphere_mass(p->radius, density_of(simulation, p));
    return (isnormal(mass) && isnormal(1 / mass)) ||
           error_set(error, ERROR_USER, "new particle %zu: its mass, %g, is beyond what numbers hold", k,
                     mass);
}

/* Asks the physics whether a particle may come. */
static bool is_admitted(const struct scree_simulation *simulation, const struct insertion_candidate *given,
                        struct error *error) {
    const struct physics_grain grain = {.material = given->material,
                                        .radius = given->radius,
                                        .density = given->density,
                                        .variant = -1,
                                        .shape = given->shape};
    return physics_admit(&simulation->state->physics, &grain, error);
}

/* Makes a candidate of particle k. False, with an error, where it cannot be. */
static bool candidate_make(const struct scree_simulation *simulation, const struct scree_particle *p,
                           size_t k, struct insertion_candidate *given, struct error *error) {
    const struct box *box = &simulation->state->box;
    struct source_form form;
    if (!particle_suits(simulation, p, k, error) || !form_of(simulation, p, k, &form, error))
        return false;
    *given = (struct insertion_candidate){.radius = p->radius * form.ball,
                                          .density = density_of(simulation, p),
                                          .temperature = NAN,
                                          .material = p->material,
                                          .group = p->group,
                                          .shape = form.shape};
    memcpy(given->orientation, p->orientation, sizeof given->orientation);
    for (int d = 0; d < 3; d++) {
        given->x[d] = p->position[d] - box->origin[d];
        given->v[d] = p->velocity[d];
        given->omega[d] = p->angular_velocity[d];
    }
    if (box->dimension == 2) { /* in the plane of all */
        given->x[2] = box->edge[2] / 2;
        given->v[2] = given->omega[0] = given->omega[1] = 0;
    }
    return is_admitted(simulation, given, error);
}

bool scree_add(struct scree_simulation *simulation, const struct scree_particle *particles, size_t count,
               struct scree_error *error) {
    struct error own = {0};
    if (simulation == NULL || simulation->state == NULL || (particles == NULL && count > 0))
        error_set(&own, ERROR_USER, "new particles: there is no simulation, or no particle");
    if (own.kind != ERROR_NONE)
        return scree_parts_tell(&own, error);
    struct insertion_candidate *given = memory_allocate_zero(count, sizeof *given, "new particles");
    bool good = true;
    for (size_t k = 0; k < count && good; k++)
        good = candidate_make(simulation, &particles[k], k, &given[k], &own);
    for (size_t k = 0; k < count && good; k++)
        sources_give(&simulation->state->sources.given, &given[k]);
    memory_free(given);
    simulation->changed = simulation->changed || (good && count > 0);
    return scree_parts_tell(&own, error);
}

void scree_delete(struct scree_simulation *simulation, const int64_t *ids, size_t count) {
    if (simulation == NULL || simulation->state == NULL || ids == NULL)
        return;
    if (count > 0 && !physics_admit(&simulation->state->physics, NULL, &simulation->error))
        return;
    for (size_t k = 0; k < count; k++)
        sources_take(&simulation->state->sources.given, ids[k]);
    simulation->changed = simulation->changed || count > 0;
}
