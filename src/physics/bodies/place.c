/* SPDX-License-Identifier: BSD-3-Clause */
/* From grains to bodies: the grain becomes the particle of the body, and its members are appended. The first rebuild
 * brings members to the ranks that own their places. Read bodies_parts.h first. */
#include "physics/bodies/bodies_parts.h"
#include "physics/grains/grains.h"
#include "physics/bodies/bodies_fields.h"
#include "physics/bodies/rocks.h"
#include "base/rotor.h"
#include "kernel/particles/material.h"
#include "kernel/particles/spin.h"
#include "base/random.h"
#include "kernel/particles/groups.h"
#include "kernel/particles/fields.h"
#include "kernel/particles/kinds.h"
#include "kernel/particles/shape.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* True of entries that choose grains by themselves, and by the material not against this one. */
static bool entry_chooses(const struct clump_entry *entry, int material) {
    return !entry->named && (entry->material < 0 || entry->material == material);
}

int place_entry(const struct bodies_options *options, const struct physics_grain *grain) {
    if (grain->shape != 0)
        return grain->shape > 0 ? grain->shape - 1 : -1;
    for (int k = 0; k < bodies_entries(options); k++) {
        const struct clump_entry *entry = bodies_entry(options, k);
        if (entry_chooses(entry, grain->material) && grain->radius > entry->radius_above &&
            grain->radius <= entry->radius_upto)
            return k;
    }
    return -1;
}

double place_edge(const struct bodies_options *options, int material, double radius) {
    double least = INFINITY;
    for (int k = 0; k < bodies_entries(options); k++) {
        const struct clump_entry *entry = bodies_entry(options, k);
        const double bound[2] = {entry->radius_above, entry->radius_upto};
        for (int e = 0; e < 2 && entry_chooses(entry, material); e++)
            least = bound[e] > radius ? fmin(least, bound[e]) : least;
    }
    return least;
}

int place_shapes(const struct bodies_options *options, int entry, int *first) {
    const int clumps = options->clumps;
    *first = entry < clumps ? entry : clumps;
    for (int k = clumps; k < entry; k++)
        *first += bodies_variants(&options->rock[k - clumps]);
    return entry < 0 ? 0 : entry < clumps ? 1 : bodies_variants(&options->rock[entry - clumps]);
}

/* The shape of a grain: of those of its entry, one by its variant or its id. -1: none. */
static int shape_of(const struct bodies *bodies, uint64_t seed, const struct physics_grain *grain) {
    int first, variant = grain->variant;
    const int entry = place_entry(bodies->options, grain);
    const int variants = place_shapes(bodies->options, entry, &first);
    if (variant < 0 && entry >= bodies->options->clumps) {
        struct random_sequence random =
            random_sequence(seed, RANDOM_SHAPE, (uint64_t)grain->id + ((uint64_t)1 << 32));
        variant = (int)(random_uniform(&random) * variants);
    }
    variant = variant < 0 ? 0 : variant;
    return variant < variants ? first + variant : -1;
}

/* The shape that particle i becomes, -1: none. */
static int shape_at(const struct bodies *bodies, const struct physics_context *context, size_t i) {
    const struct particles *p = context->particles;
    const int32_t(*shape)[2] = (const int32_t(*)[2])shape_numbers(p);
    const struct physics_grain grain = {.material = material_of(material_numbers(p), i),
                                        .radius = p->state[i].radius,
                                        .id = p->id[i],
                                        .variant = shape[i][1] - 1,
                                        .shape = shape[i][0]};
    return kinds_of(p)[i] == KIND_GRAIN ? shape_of(bodies, context->scene->seed, &grain) : -1;
}

/* Uniform over all rotations (Shoemake, Graphics Gems III (1992) 124); in two dimensions over the circle. */
static void orientation_draw(const struct scene *scene, int64_t id, double q[4]) {
    struct random_sequence random = random_sequence(scene->seed, RANDOM_ORIENTATION, (uint64_t)id);
    double a = random_uniform(&random), b = 2 * M_PI * random_uniform(&random),
           c = 2 * M_PI * random_uniform(&random);
    q[0] = sqrt(1 - a) * sin(b);
    q[1] = sqrt(1 - a) * cos(b);
    q[2] = sqrt(a) * sin(c);
    q[3] = sqrt(a) * cos(c);
    if (scene->box.dimension == 2) {
        q[0] = cos(0.5 * b);
        q[1] = q[2] = 0;
        q[3] = sin(0.5 * b);
    }
}

/* True if a grain brings its orientation. */
static bool turn_given(const double q[4]) {
    return q[0] != 0 || q[1] != 0 || q[2] != 0 || q[3] != 0;
}

/* Replaces the orientation that a grain brings, or that the entry gives, by that of the body. */
static void orientation_choose(const struct physics_context *context, const struct clump_entry *options,
                               const struct clump *clump, int64_t id, double q[4]) {
    double norm = 0;
    if (!turn_given(q) && options->orientation == CLUMP_RANDOM)
        orientation_draw(context->scene, id, q);
    else if (!turn_given(q))
        memcpy(q, options->quaternion, 4 * sizeof *q);
    rotor_product(q, clump->axes, q);
    for (int k = 0; k < 4; k++)
        norm += q[k] * q[k];
    for (int k = 0; k < 4; k++)
        q[k] /= sqrt(norm);
}

/* The radius of the ball around the body that a grain becomes. */
static double ball_of(const struct bodies *bodies, int number, double radius) {
    const struct clump *clump = &bodies->clump[number];
    const enum clump_size size = bodies->entry[number]->size;
    return size == CLUMP_AS_DRAWN    ? clump->extent
           : size == CLUMP_BY_VOLUME ? radius / clump->span * clump->extent
                                     : radius;
}

/* Turns grain i into the particle of a body. */
static void body_make(struct bodies *bodies, const struct physics_context *context, size_t i, int number) {
    const struct clump *clump = &bodies->clump[number];
    struct particles *p = context->particles;
    struct particle_state *state = &p->state[i];
    const uint8_t *group = groups_of(p);
    const struct integrator_motion *motion = group ? &grains_motion(context)->motion[group[i]] : NULL;
    double *omega = spin_of(p)[i], *spin = bodies_spin(p)[i], *q = bodies_orientation(p)[i], turn[9];
    double density = groups_mass(p, i) / particles_sphere_mass(state->radius, 1);
    state->radius = ball_of(bodies, number, state->radius);
    double scale = state->radius / clump->extent;
    bodies_mass(p)[i] = clump_mass(clump, scale, density);
    bodies_part(p)[i] = number;
    const bool brought = turn_given(q); /* such a grain has all of its angular velocity */
    orientation_choose(context, bodies->entry[number], clump, p->id[i], q);
    if (motion && motion->prescribed) {
        memcpy(state->v, motion->velocity, sizeof state->v);
        memcpy(omega, motion->omega, sizeof motion->omega);
    } else {
        for (int d = 0; d < 3 && !brought; d++)
            omega[d] += bodies->entry[number]->angular_velocity[d];
    }
    memcpy(bodies_velocity(p)[i], state->v, sizeof state->v);
    rotor_matrix(q, turn);
    rotor_turn_back(turn, omega, spin);
    for (int d = 0; d < 3; d++)
        spin[d] *= bodies_mass(p)[i] * clump->gyration[d] * scale * scale;
    rotor_turn(turn, spin, spin);
}

double place_swell(const struct clump *clump) {
    double sum = 0;
    for (int k = 0; k < clump->spheres; k++)
        sum += particles_sphere_mass(clump->sphere[k].radius, 1);
    const double swell = cbrt(clump->volume / sum);
    return fabs(swell - 1) > 1e-9 ? swell : 0;
}

/* Wraps a place that may lie across periodic sides, and counts the crossings. */
static void wrap(const struct box *box, double x[3], int32_t *image) {
    for (int d = 0; d < 3; d++) {
        if (!box->periodic[d])
            continue;
        double turns = floor(x[d] / box->edge[d]);
        x[d] -= turns * box->edge[d];
        if (image)
            image[d] += (int32_t)turns;
    }
}

/* Appends member `number` of the body that is particle i. */
static void member_append(const struct bodies *bodies, const struct physics_context *context, size_t i,
                          int number, int64_t id) {
    struct particles *p = context->particles;
    size_t m = particles_append(p);
    const struct clump *clump = &bodies->clump[bodies_part(p)[i]];
    const struct particle_state *body = &p->state[i];
    struct particle_state *state = &p->state[m];
    double scale = body->radius / clump->extent, mass = clump->share[number] * bodies_mass(p)[i], turn[9],
           r[3];
    int32_t(*image)[3] = particles_images(p);
    uint8_t *material = material_numbers(p), *group = groups_of(p);
    double *density = groups_densities(p), (*omega)[4] = spin_of(p),
           *temperature = fields_numbers(p, "temperature");
    rotor_matrix(bodies_orientation(p)[i], turn);
    rotor_turn(turn, clump->sphere[number].centre, r);
    for (int d = 0; d < 3; d++) {
        int e = (d + 1) % 3, f = (d + 2) % 3;
        bool still = d == 2 && context->box->dimension == 2;
        state->x[d] = body->x[d] + (still ? 0 : scale * r[d]);
        state->v[d] = body->v[d] + (still ? 0 : scale * (omega[i][e] * r[f] - omega[i][f] * r[e]));
    }
    state->radius = scale * clump->sphere[number].radius;
    state->inverse_mass = body->inverse_mass > 0 ? 1 / mass : 0;
    memcpy(omega[m], omega[i], sizeof omega[m]);
    if (image)
        memcpy(image[m], image[i], sizeof image[m]);
    wrap(context->box, state->x, image ? image[m] : NULL);
    if (material)
        material[m] = material[i];
    if (group)
        group[m] = group[i];
    if (density)
        density[m] = mass / particles_sphere_mass(state->radius, 1);
    if (temperature)
        temperature[m] = temperature[i];
    if (carried_solid(p))
        carried_solid(p)[m] = place_swell(clump) * state->radius;
    p->id[m] = id;
    carried_by(p)[m] = p->id[i];
    bodies_part(p)[m] = number;
    if (bodies->rocks)
        rocks_member(p, m, clump->core.corners > 0 ? bodies_part(p)[i] : -1, bodies_orientation(p)[i]);
}

/* Members that a body may have: ids of members follow those of all grains, as many for each grain. */
static int64_t members_most(const struct bodies *bodies) {
    int most = 1;
    for (int k = 0; k < bodies->shapes; k++)
        most = bodies->clump[k].spheres > most ? bodies->clump[k].spheres : most;
    return most;
}

/* True if a ball does not meet its own images. */
static bool fits_box(const struct box *box, double radius) {
    bool fits = true;
    for (int d = 0; d < 3; d++)
        fits = fits && !(box->periodic[d] && 2 * radius >= box->edge[d]);
    return fits;
}

/* Makes body `number` of grain i, with its members. */
static void body_join(struct bodies *bodies, const struct physics_context *context, size_t i, int number,
                      int64_t first_id) {
    struct particles *p = context->particles;
    body_make(bodies, context, i, number);
    for (int k = 0; k < bodies->clump[number].spheres; k++)
        member_append(bodies, context, i, k, first_id + k);
    kinds_of(p)[i] = KIND_BODY;
    p->state[i].inverse_mass = 0;
}

bool place_all(struct bodies *bodies, const struct physics_context *context,
               const struct physics_share *share, struct error *error) {
    struct particles *p = context->particles;
    const int64_t most = members_most(bodies), room = (INT64_C(1) << 62) - share->first_id;
    const size_t grains = p->owned;
    size_t members = 0;
    for (size_t i = 0; i < grains; i++) {
        int number = shape_at(bodies, context, i);
        if (number >= 0)
            members += (size_t)bodies->clump[number].spheres;
    }
    particles_reserve(p, grains + members);
    for (size_t i = 0; i < grains; i++) {
        int number = shape_at(bodies, context, i);
        if (number < 0)
            continue;
        if (p->id[i] >= room / most)
            return error_set(error, ERROR_USER,
                             "bodies: particle %" PRId64 " becomes a body of up to %" PRId64
                             " spheres, whose ids would be above 2^62; give particles smaller ids",
                             p->id[i], most);
        if (bodies->clump[number].core.corners > 0 &&
            !fits_box(context->box, ball_of(bodies, number, p->state[i].radius)))
            return error_set(error, ERROR_USER,
                             "bodies.shapes: particle %" PRId64
                             " becomes a rock in a ball of radius %.6g, which is as "
                             "large as a periodic edge of the box: it would meet itself",
                             p->id[i], ball_of(bodies, number, p->state[i].radius));
        body_join(bodies, context, i, number, share->first_id + p->id[i] * most);
    }
    return true;
}

bool place_part(const struct bodies *bodies, uint64_t seed, const struct physics_grain *grain, int number,
                struct physics_part *part) {
    const int shape = shape_of(bodies, seed, grain);
    if (shape < 0 || number >= bodies->clump[shape].spheres)
        return false;
    const struct clump *clump = &bodies->clump[shape];
    const double scale = ball_of(bodies, shape, grain->radius) / clump->extent;
    *part = (struct physics_part){.radius = scale * clump->sphere[number].radius,
                                  .inner = scale * clump_inner(clump, number),
                                  .mass = clump->share[number] * clump_mass(clump, scale, grain->density)};
    return true;
}

void place_join(struct bodies *bodies, const struct physics_context *context, size_t i, int64_t first_id) {
    const int number = shape_at(bodies, context, i);
    if (number >= 0)
        body_join(bodies, context, i, number, first_id);
}

bool place_admit(const struct bodies *bodies, const struct box *box, const struct physics_grain *grain,
                 struct error *error) {
    int first;
    const int entry = place_entry(bodies->options, grain);
    const int shapes = place_shapes(bodies->options, entry, &first);
    for (int s = first; s < first + shapes; s++)
        if (bodies->clump[s].core.corners > 0 && !fits_box(box, ball_of(bodies, s, grain->radius)))
            return error_set(error, ERROR_USER,
                             "the rock '%s' has a ball of radius %.6g, as large as a periodic edge of the "
                             "box: it would meet itself",
                             bodies->entry[s]->name, ball_of(bodies, s, grain->radius));
    return true;
}

/* Grains that come from a source or an insertion. */
struct coming {
    const struct sizes_options *sizes;
    const struct source_form *form;
    int material;
    const char *list;
    int number;
};

/* True if such grains may become shape s. */
static bool may_become(const struct bodies *bodies, const struct coming *coming, int s, double smallest,
                       double largest) {
    const struct clump_entry *entry = bodies->entry[s];
    if (coming->form->shape > 0)
        return entry == bodies_entry(bodies->options, coming->form->shape - 1);
    return entry_chooses(entry, coming->material) && largest > entry->radius_above &&
           smallest <= entry->radius_upto;
}

static bool check_coming(const struct bodies *bodies, const struct physics_context *context,
                         const struct coming *coming, struct error *error) {
    double smallest, largest;
    char key[64];
    snprintf(key, sizeof key, "%s[%d].sizes", coming->list, coming->number);
    sizes_bounds(coming->sizes, &smallest, &largest);
    for (int s = 0; s < bodies->shapes; s++) {
        const struct clump_entry *entry = bodies->entry[s];
        const struct clump *clump = &bodies->clump[s];
        if (!may_become(bodies, coming, s, smallest, largest))
            continue;
        const double ball = ball_of(bodies, s, fmin(largest, entry->radius_upto));
        if (entry->size == CLUMP_AS_DRAWN && fmax(smallest, entry->radius_above) < clump->extent)
            return scene_fail(
                context->scene, error, key,
                "the body '%s' as drawn has a ball of radius %.6g, and finds a place for the radius of "
                "its grain, which may be %.6g: allowed are larger grains, or size: grain",
                entry->name, clump->extent, fmax(smallest, entry->radius_above));
        if (clump->core.corners > 0 && !fits_box(context->box, ball))
            return scene_fail(
                context->scene, error, key,
                "the rock '%s' has a ball of radius %.6g, as large as a periodic edge of the box: it would "
                "meet itself",
                entry->name, ball);
    }
    return true;
}

bool place_check(const struct bodies *bodies, const struct physics_context *context, struct error *error) {
    const struct scene *scene = context->scene;
    bool good = true;
    for (int k = 0; k < scene->sources && good; k++) {
        const struct source_options *source = &scene->source[k];
        const bool sized = source->kind != SOURCE_FILE && source->kind != SOURCE_SINGLE;
        const struct coming coming = {&source->sizes, &source->form, source->material, "particles.sources",
                                      k};
        good = !sized || source->form.shape == 0 || check_coming(bodies, context, &coming, error);
    }
    for (int k = 0; k < scene->insertions && good; k++) {
        const struct insertion_options *insertion = &scene->insertion[k];
        const struct coming coming = {&insertion->sizes, &insertion->form, insertion->material, "insertions",
                                      k};
        good = check_coming(bodies, context, &coming, error);
    }
    return good;
}
