/* SPDX-License-Identifier: BSD-3-Clause */
/* Forces of the walls on the particles: contacts are found one sphere at a time, and collected in a batch of contacts, which
 * goes through the law as those of pairs do (physics/grains/batch/force_kernel.h). */
#include "physics/grains/walls/walls_history.h"
#include "physics/grains/walls/walls_touch.h"
#include "kernel/particles/material.h"
#include "physics/grains/walls/walls_near.h"
#include "kernel/particles/spin.h"
#include "base/memory.h"
#include <string.h>

/* One evaluation of one particle. */
struct wall_task {
    struct walls *walls;
    const struct force_context *context;
    struct wall_scratch *scratch;
    struct law_case law;
    struct force_form form;
    const double (*omega)[4]; /* NULL without spin */
    const uint8_t *material;  /* NULL where all are of one */
    size_t candidate;         /* its number */
    size_t particle;
    struct force_contact *list; /* the list, if contacts are only listed; NULL with load NULL: contacts act */
    struct wall_load *load;     /* the same for loads */
    size_t listed;
};

/* What contact k goes on with of its old record; vectors are turned where they come from another feature. */
static void recall(const struct wall_task *task, int w, const struct wall_touch *touch, int32_t from,
                   struct law_vector x, int k) {
    const struct walls *walls = task->walls;
    const struct wall_records *old = &walls->records[walls->now];
    struct force_batch *b = &task->scratch->batch->contact;
    size_t record = walls->first[task->candidate] + (size_t)(from < 0 ? 0 : from);
    int components = walls->law->history_components;
    for (int c = 0; c < components; c++)
        b->walk.history[c][k] = from < 0 ? 0.0 : old->value[record * (size_t)components + (size_t)c];
    if (from < 0 || components == 0 || old->key[record].feature == touch->feature)
        return;
    double distance;
    struct law_vector before = walls_toward(&walls->wall[w], old->key[record].feature, x, &distance);
    for (int c = 0; c < walls->law->history_odd; c += 3)
        force_set(b->walk.history + c, k,
                  walls_carry(force_vector(b->walk.history + c, k), before, touch->normal));
}

/* The lever of force and torque: at walls pair_style granular of LAMMPS has the radius. */
static double lever_of(const struct wall_task *task, double radius, double overlap) {
    if (task->context->law->options.lammps_granular)
        return radius;
    return law_max(law_lever(task->law, radius, overlap), 0.0);
}

/* The lever for the slip velocity: the lever of half a step ago, if springs advance in that plane. */
static double lever_of_slip(const struct wall_task *task, int k, double lever, double radius) {
    struct force_batch *b = &task->scratch->batch->contact;
    if (!task->law.synchronised)
        return lever;
    double growth = -law_dot(force_vector(b->velocity, k), force_vector(b->normal, k)); /* of the overlap */
    return law_max(law_lever(task->law, radius, b->overlap[k] - 0.5 * task->form.step.dt * growth), 0.0);
}

/* Puts the contact `touch` of the task's particle with wall w into the batch; `from` is its old record. */
static void collect(const struct wall_task *task, int w, const struct wall_touch *touch, int32_t from) {
    struct force_batch *b = &task->scratch->batch->contact;
    int k = b->walk.count++;
    struct wall_entry *entry = &task->scratch->batch->entry[k];
    const struct wall *wall = &task->walls->wall[w];
    const struct particles *p = task->context->particles;
    const struct particle_state *state = &p->state[task->particle];
    struct wall_sphere sphere = {
        .x = law_add(wall_vector(state->x), -1.0, walls_shift(task->walls, w, touch->image)),
        .v = wall_vector(state->v),
        .radius = state->radius};
    double overlap = state->radius - touch->distance;
    double lever = lever_of(task, state->radius, overlap);
    struct law_vector at = law_add(sphere.x, lever, touch->normal);
    *entry = (struct wall_entry){
        .candidate = task->candidate,
        .particle = task->particle,
        .key = {.wall = (int16_t)w, .image = (int16_t)touch->image, .feature = touch->feature},
        .triangle = touch->triangle,
        .at = at,
        .lever = lever,
        .radius = state->radius};
    b->overlap[k] = overlap;
    double inverse = state->inverse_mass + walls_yield_of(wall, at, touch->normal);
    b->mass[k] = inverse > 0.0 ? 1.0 / inverse : 0.0;
    b->effective[k] = state->radius;
    force_set(b->normal, k, touch->normal);
    struct law_vector surface = wall_twist_at(&wall->twist, at), spin = wall->twist.omega;
    if (wall->slides) {
        surface = law_add(surface, 1.0, walls_slip(wall, at, touch->normal));
        spin = law_add(spin, 1.0, wall->surface.omega);
    }
    force_set(b->velocity, k, law_add(surface, -1.0, sphere.v));
    b->material[0][k] = (uint8_t)material_of(task->material, task->particle);
    b->material[1][k] = (uint8_t)wall->options.material;
    b->walk.radius[0][k] = state->radius;
    b->walk.radius[1][k] = INFINITY;
    recall(task, w, touch, from, sphere.x, k);
    if (!task->law.friction)
        return;
    struct law_vector omega = wall_vector(task->omega[task->particle]);
    force_set(b->surface, k, law_scale(lever_of_slip(task, k, lever, state->radius), omega));
    force_set(b->spin, k, law_add(spin, -1.0, omega));
    force_set(b->half_normal, k,
              task->law.synchronised ? walls_half_normal(wall, touch, &sphere, task->form.step.dt)
                                     : touch->normal);
}

static void add_to(double *out, double s, struct law_vector v) {
    out[0] += s * v.x;
    out[1] += s * v.y;
    out[2] += s * v.z;
}

static void add_exactly(struct exact *out, struct law_vector v) {
    exact_add(&out[0], v.x);
    exact_add(&out[1], v.y);
    exact_add(&out[2], v.z);
}

/* The power that the surface takes from the particle at contact k, which pushes the wall with this force: with the
 * moment of rolling resistance, too. */
static double surface_power(const struct wall_task *task, const struct wall *wall, int k,
                            struct law_vector force) {
    struct force_batch *b = &task->scratch->batch->contact;
    struct law_vector at = task->scratch->batch->entry[k].at, normal = force_vector(b->normal, k);
    double power = law_dot(force, walls_slip(wall, at, normal));
    if (task->law.rolling)
        power += law_dot(force_vector(b->walk.out + FORCE_ROLLING, k), wall->surface.omega);
    return power;
}

/* Force and torque of contact k on its wall, and the power of its surface. */
static void apply_to_wall(const struct wall_task *task, int k) {
    struct force_batch *b = &task->scratch->batch->contact;
    const struct wall_entry *entry = &task->scratch->batch->entry[k];
    int w = entry->key.wall;
    const struct wall *wall = &task->walls->wall[w];
    struct law_vector arm = law_add(entry->at, -1.0, wall->centre_now);
    struct law_vector force = force_vector(b->walk.out + FORCE_OUT, k), torque = law_cross(arm, force);
    if (task->law.rolling)
        torque = law_add(torque, 1.0, force_vector(b->walk.out + FORCE_ROLLING, k));
    double power = wall->slides ? -surface_power(task, wall, k, force) : 0.0;
    if (task->scratch->exact) {
        add_exactly(task->scratch->exact[w] + WALL_FORCE, force);
        add_exactly(task->scratch->exact[w] + WALL_TORQUE, torque);
        exact_add(&task->scratch->exact[w][WALL_POWER], power);
        return;
    }
    add_to(task->scratch->load[w] + WALL_FORCE, 1.0, force);
    add_to(task->scratch->load[w] + WALL_TORQUE, 1.0, torque);
    task->scratch->load[w][WALL_POWER] += power;
}

/* Adds the impedance of contact k to that of its wall. */
static void impede(const struct wall_task *task, int k) {
    const struct force_batch *b = &task->scratch->batch->contact;
    int w = task->scratch->batch->entry[k].key.wall;
    double push = 0.0;
    if (!(task->walls->wall[w].unit > 0.0))
        return;
    for (int d = 0; d < 3; d++)
        push += b->walk.out[FORCE_OUT + d][k] * b->normal[d][k];
    if (push > 0.0 && b->overlap[k] > 0.0)
        walls_impede(task->walls, task->scratch, w, sqrt(b->mass[k] * push / b->overlap[k]));
}

/* Forces and torques of contact k on the particle and on the wall. */
static void apply(const struct wall_task *task, int k) {
    struct particles *p = task->context->particles;
    struct force_batch *b = &task->scratch->batch->contact;
    const struct wall_entry *entry = &task->scratch->batch->entry[k];
    double *force = p->force + entry->particle * (size_t)p->force_stride;
    add_to(force, -1.0, force_vector(b->walk.out + FORCE_OUT, k));
    if (task->law.friction)
        add_to(force + 4, entry->lever, force_vector(b->walk.out + FORCE_MOMENT, k));
    if (task->law.rolling)
        add_to(force + 4, -1.0, force_vector(b->walk.out + FORCE_ROLLING, k));
    apply_to_wall(task, k);
    impede(task, k);
}

static void account(const struct wall_task *task, int k) {
    struct force_sums *sums = &task->scratch->sums;
    struct force_batch *b = &task->scratch->batch->contact;
    const struct wall_entry *entry = &task->scratch->batch->entry[k];
    double relative = b->overlap[k] / entry->radius;
    sums->contact_sides += 2;
    if (relative > sums->overlap_max) {
        sums->overlap_max = relative;
        sums->overlap_id[0] = task->context->particles->id[entry->particle];
        sums->overlap_id[1] = -(int64_t)(entry->key.wall + 1);
    }
    if (!task->law.energies)
        return;
    sums->elastic_normal += b->energy[0][k];
    sums->elastic_tangential += b->energy[1][k];
    sums->taken += b->energy[2][k];
    if (task->context->wall_work) {
        task->context->wall_work[entry->particle].taken += b->energy[2][k];
        task->context->wall_work[entry->particle].stored += b->energy[1][k];
    }
    if (!task->context->want_virial)
        return;
    struct law_vector d = law_scale(entry->lever, force_vector(b->normal, k)),
                      f = force_vector(b->walk.out + FORCE_OUT, k);
    force_add_virial(sums->virial, 1.0, (double[3]){d.x, d.y, d.z}, (double[3]){f.x, f.y, f.z});
}

/* Writes the springs of contact k to the new record. */
static void remember(const struct wall_task *task, int k) {
    struct walls *walls = task->walls;
    const struct force_batch *b = &task->scratch->batch->contact;
    const struct wall_entry *entry = &task->scratch->batch->entry[k];
    int components = walls->law->history_components;
    struct wall_records *new = &walls->records[1 - walls->now];
    size_t record = walls->first[entry->candidate] + (size_t) new->count[entry->candidate]++;
    new->key[record] = entry->key;
    for (int c = 0; c < components; c++)
        new->value[record * (size_t)components + (size_t)c] = b->walk.history[c][k];
}

/* Contact k for the contact list. */
static struct force_contact contact_of(const struct wall_task *task, int k) {
    struct force_batch *b = &task->scratch->batch->contact;
    const struct wall_entry *entry = &task->scratch->batch->entry[k];
    struct law_vector n = force_vector(b->normal, k), f = force_vector(b->walk.out + FORCE_OUT, k);
    return (struct force_contact){.id_i = task->context->particles->id[entry->particle],
                                  .id_j = -(int64_t)(entry->key.wall + 1),
                                  .number_i = entry->particle,
                                  .number_j = SIZE_MAX,
                                  .branch = {entry->lever * n.x, entry->lever * n.y, entry->lever * n.z},
                                  .normal = {n.x, n.y, n.z},
                                  .overlap = b->overlap[k],
                                  .force = {f.x, f.y, f.z}};
}

/* Contact k as the load of a wall. */
static struct wall_load load_of(const struct wall_task *task, int k) {
    struct force_batch *b = &task->scratch->batch->contact;
    const struct wall_entry *entry = &task->scratch->batch->entry[k];
    struct law_vector force = force_vector(b->walk.out + FORCE_OUT, k);
    return (struct wall_load){.wall = entry->key.wall,
                              .triangle = entry->triangle,
                              .at = {entry->at.x, entry->at.y, entry->at.z},
                              .force = {force.x, force.y, force.z},
                              .push = law_dot(force, force_vector(b->normal, k))};
}

/* Takes the batch through the law and applies the results. */
static void flush(struct wall_task *task) {
    struct force_batch *b = &task->scratch->batch->contact;
    if (b->walk.count == 0)
        return;
    b->walk.padded = (b->walk.count + FORCE_LANES - 1) / FORCE_LANES * FORCE_LANES;
    task->walls->kernel->contacts(&task->form, b);
    for (int k = 0; k < b->walk.count; k++) {
        if (!b->active[k])
            continue;
        if (task->load)
            task->load[task->listed++] = load_of(task, k);
        else if (task->list)
            task->list[task->listed++] = contact_of(task, k);
        if (task->load || task->list)
            continue;
        apply(task, k);
        account(task, k);
        if (task->walls->law->history_components > 0)
            remember(task, k);
    }
    b->walk.count = 0;
}

/* How far from its centre the task's particle feels a wall. */
static double reach_of(const struct wall_task *task, int w, double radius) {
    const struct law *law = task->context->law;
    int material = material_of(task->material, task->particle);
    return radius + (law->general ? law_range_of(law, material, task->walls->wall[w].options.material, radius,
                                                 INFINITY)
                                  : 0.0);
}

/* Collects the contacts of the task's particle. */
static void take_particle(struct wall_task *task) {
    struct walls *walls = task->walls;
    struct wall_scratch *scratch = task->scratch;
    const struct particle_state *state = &task->context->particles->state[task->particle];
    size_t k = task->candidate, last;
    bool fixed = walls->fixed_too && walls_at_rest(task->context->particles, task->particle);
    if (task->context->alone && task->context->alone(task->context->joined_context, task->particle))
        return;
    for (size_t first = walls->first[k]; first < walls->first[k + 1]; first = last) {
        int w = walls->piece[first].wall;
        size_t count = walls_find(walls, k, first, &last, wall_vector(state->x),
                                  reach_of(task, w, state->radius), scratch);
        if (fixed && !wall_moves(&walls->wall[w].options))
            continue;
        for (size_t c = 0; c < count; c++) {
            if (scratch->batch->contact.walk.count == FORCE_BATCH)
                flush(task);
            collect(task, w, &scratch->touch[c], scratch->from[c]);
        }
    }
}

static struct wall_task task_of(struct walls *walls, const struct force_context *context,
                                struct wall_scratch *scratch, double dt, bool energies) {
    struct wall_task task = {.walls = walls,
                             .context = context,
                             .scratch = scratch,
                             .law = law_case_of(&context->law->options, energies),
                             .omega = spin_values(context->particles),
                             .material = material_numbers(context->particles)};
    walls->kernel->begin(&task.form, &scratch->batch->contact, context->law, dt, energies);
    return task;
}

void walls_force_share(struct walls *walls, const struct force_context *context, int thread) {
    struct wall_task task = task_of(walls, context, walls->scratch[thread], context->dt, context->want_sums);
    size_t first = walls->candidates * (size_t)thread / (size_t)walls->threads;
    size_t last = walls->candidates * ((size_t)thread + 1) / (size_t)walls->threads;
    for (size_t k = first; k < last; k++) {
        task.candidate = k;
        task.particle = walls->particle[k];
        walls->records[1 - walls->now].count[k] = 0;
        take_particle(&task);
    }
    flush(&task);
}

/* Lists all contacts of this rank as `contacts` or as `loads`. Returns their number. */
static size_t list_all(const struct walls *walls, const struct force_context *context,
                       struct force_contact *contacts, struct wall_load *loads) {
    struct wall_scratch scratch = {.batch = memory_allocate_zero(1, sizeof *scratch.batch, "contact list")};
    struct wall_task task = task_of((struct walls *)walls, context, &scratch, 0.0, false); /* only read */
    task.list = contacts;
    task.load = loads;
    for (size_t k = 0; k < walls->candidates; k++) {
        task.candidate = k;
        task.particle = walls->particle[k];
        walls_scratch_reserve(&scratch, walls->first[k + 1] - walls->first[k]);
        take_particle(&task);
    }
    flush(&task);
    walls_scratch_free(&scratch);
    return task.listed;
}

size_t walls_contacts(const struct walls *walls, const struct force_context *context,
                      struct force_contact **contacts) {
    if (context->solved)
        return context->solved(context->solver, true, contacts);
    *contacts = memory_allocate(walls->first[walls->candidates], sizeof **contacts, "contact list");
    return list_all(walls, context, *contacts, NULL);
}

size_t walls_loads(const struct walls *walls, const struct force_context *context, struct wall_load **loads) {
    *loads = memory_allocate(walls->first[walls->candidates] + 1, sizeof **loads, "loads of walls");
    return list_all(walls, context, NULL, *loads);
}
