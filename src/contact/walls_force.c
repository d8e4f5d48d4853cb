/* Forces of the walls on the particles: one sphere and its contacts at a time, by the law of the pairs. */
#include "contact/walls_parts.h"
#include "core/memory.h"
#include <string.h>

/* One evaluation of one particle. */
struct wall_task {
    struct walls *walls;
    const struct force_context *context;
    struct wall_scratch *scratch;
    struct law_case law;
    struct law_step step;
    size_t candidate; /* its number */
    size_t particle;
};

/* A contact as the law took it. */
struct wall_contact {
    struct law_contact in;
    struct law_response out;
    struct law_vector at; /* the contact point, in the wall's image */
    double lever;
};

static struct law_vector spring_at(const double *value) {
    return value ? wall_vector(value) : (struct law_vector){0.0, 0.0, 0.0};
}

/* The springs that a contact goes on with, turned where they come from another feature. */
static void recall_springs(const struct wall_task *task, int w, const struct wall_touch *touch, int32_t from,
                           struct law_vector x, struct law_contact *in) {
    if (from < 0)
        return;
    const struct walls *walls = task->walls;
    const struct wall_records *old = &walls->records[walls->now];
    size_t record = walls->first[task->candidate] + (size_t)from;
    const double *value = old->value + record * (size_t)walls->law->history_components;
    in->spring = spring_at(value);
    if (task->law.rolling)
        in->roll = spring_at(value + 3);
    if (old->key[record].feature == touch->feature)
        return;
    double distance;
    struct law_vector before = walls_toward(&walls->wall[w], old->key[record].feature, x, &distance);
    in->spring = walls_carry(in->spring, before, touch->normal);
    in->roll = walls_carry(in->roll, before, touch->normal);
}

/* Evaluates the contact `touch` of the task's particle with wall w; `from` is its old record. */
static struct wall_contact evaluate(const struct wall_task *task, int w, const struct wall_touch *touch,
                                    int32_t from) {
    const struct wall *wall = &task->walls->wall[w];
    const struct particles *p = task->context->particles;
    const struct particle_state *state = &p->state[task->particle];
    const struct law *law = task->context->law;
    struct wall_contact c = {0};
    struct wall_sphere sphere = {
        .x = law_add(wall_vector(state->x), -1.0, walls_shift(task->walls, w, touch->image)),
        .v = wall_vector(state->v),
        .radius = state->radius};
    c.in = (struct law_contact){.overlap = state->radius - touch->distance,
                                .mass = state->inverse_mass > 0.0 ? 1.0 / state->inverse_mass : 0.0,
                                .radius = state->radius,
                                .normal = touch->normal,
                                .coefficients =
                                    law->pair[particles_material(p, task->particle)][wall->options.material]};
    c.lever = law_max(law_lever(task->law, state->radius, c.in.overlap), 0.0);
    c.at = law_add(sphere.x, c.lever, touch->normal);
    c.in.velocity = law_add(wall_twist_at(&wall->twist, c.at), -1.0, sphere.v);
    if (task->law.friction) {
        struct law_vector omega = wall_vector(p->omega[task->particle]);
        c.in.surface = law_scale(c.lever, omega);
        c.in.spin = law_add(wall->twist.omega, -1.0, omega);
        c.in.half_normal =
            task->law.synchronised ? walls_half_normal(wall, touch, &sphere, task->step.dt) : touch->normal;
        recall_springs(task, w, touch, from, sphere.x, &c.in);
    }
    c.out = law_respond(task->law, task->step, &c.in);
    return c;
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

/* Force and torque on wall w. */
static void apply_to_wall(const struct wall_task *task, int w, const struct wall_contact *c) {
    struct law_vector arm = law_add(c->at, -1.0, task->walls->wall[w].centre_now);
    struct law_vector torque = law_add(law_cross(arm, c->out.force), 1.0, c->out.rolling);
    if (task->scratch->exact) {
        add_exactly(task->scratch->exact[w], c->out.force);
        add_exactly(task->scratch->exact[w] + 3, torque);
        return;
    }
    add_to(task->scratch->force[w], 1.0, c->out.force);
    add_to(task->scratch->force[w] + 3, 1.0, torque);
}

/* Forces and torques on the particle and on the wall. */
static void apply(const struct wall_task *task, int w, const struct wall_contact *c) {
    struct particles *p = task->context->particles;
    double *force = p->force + task->particle * (size_t)p->force_stride;
    add_to(force, -1.0, c->out.force);
    if (task->law.friction) {
        add_to(force + 4, c->lever, c->out.moment);
        add_to(force + 4, -1.0, c->out.rolling);
    }
    apply_to_wall(task, w, c);
}

static void account(const struct wall_task *task, int w, const struct wall_contact *c) {
    struct force_sums *sums = &task->scratch->sums;
    double relative = c->in.overlap / c->in.radius;
    sums->contact_sides += 2;
    if (relative > sums->overlap_max) {
        sums->overlap_max = relative;
        sums->overlap_id[0] = task->context->particles->id[task->particle];
        sums->overlap_id[1] = -(int64_t)(w + 1);
    }
    if (!task->law.energies)
        return;
    struct law_vector d = law_scale(c->lever, c->in.normal), f = c->out.force;
    sums->elastic_normal += c->out.normal_energy;
    sums->elastic_tangential += c->out.spring_energy;
    sums->taken += c->out.taken;
    sums->virial[0] += d.x * f.x;
    sums->virial[1] += d.y * f.y;
    sums->virial[2] += d.z * f.z;
    sums->virial[3] += 0.5 * (d.x * f.y + d.y * f.x);
    sums->virial[4] += 0.5 * (d.x * f.z + d.z * f.x);
    sums->virial[5] += 0.5 * (d.y * f.z + d.z * f.y);
}

/* Writes the record that follows: the springs of this contact. */
static void remember(const struct wall_task *task, int w, const struct wall_touch *touch,
                     const struct wall_contact *c) {
    struct walls *walls = task->walls;
    size_t components = (size_t)walls->law->history_components;
    struct wall_records *new = &walls->records[1 - walls->now];
    size_t record = walls->first[task->candidate] + (size_t) new->count[task->candidate]++;
    const double spring[HISTORY_COMPONENTS_MAX] = {c->out.spring.x, c->out.spring.y, c->out.spring.z,
                                                   c->out.roll.x,   c->out.roll.y,   c->out.roll.z};
    new->key[record] = (struct wall_key){w, touch->feature};
    memcpy(new->value + record *components, spring, components * sizeof *spring);
}

/* Finds the contacts of candidate k with the wall of the pieces from `first` on, in scratch; sets *last to
 * the end of those pieces. */
static size_t find_contacts(const struct walls *walls, size_t k, size_t first, size_t *last,
                            struct law_vector x, double radius, struct wall_scratch *scratch) {
    int w = walls->piece[first].wall;
    *last = first + 1;
    while (*last < walls->first[k + 1] && walls->piece[*last].wall == w)
        ++*last;
    size_t count = walls_touch(walls, walls->piece + first, *last - first, x, radius, scratch);
    if (walls->law->history_components > 0 && count > 0)
        walls_recall(walls, k, w, count, x, radius, scratch);
    else
        for (size_t c = 0; c < count; c++)
            scratch->from[c] = -1;
    return count;
}

static void force_particle(struct wall_task *task) {
    struct walls *walls = task->walls;
    struct wall_scratch *scratch = task->scratch;
    const struct particle_state *state = &task->context->particles->state[task->particle];
    size_t k = task->candidate, last;
    walls->records[1 - walls->now].count[k] = 0;
    for (size_t first = walls->first[k]; first < walls->first[k + 1]; first = last) {
        int w = walls->piece[first].wall;
        size_t count = find_contacts(walls, k, first, &last, wall_vector(state->x), state->radius, scratch);
        for (size_t c = 0; c < count; c++) {
            struct wall_contact contact = evaluate(task, w, &scratch->touch[c], scratch->from[c]);
            apply(task, w, &contact);
            account(task, w, &contact);
            if (walls->law->history_components > 0)
                remember(task, w, &scratch->touch[c], &contact);
        }
    }
}

/* The first candidate that is particle `first` or a later one. */
static size_t candidate_from(const struct walls *walls, size_t first) {
    size_t low = 0, high = walls->candidates;
    while (low < high) {
        size_t middle = (low + high) / 2;
        if (walls->particle[middle] < first)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

void walls_force_block(struct walls *walls, const struct force_context *context, int thread, size_t first,
                       size_t last) {
    struct wall_task task = {.walls = walls,
                             .context = context,
                             .scratch = walls->scratch[thread],
                             .law = law_case_of(&context->law->options, context->want_sums),
                             .step = law_step_of(&context->law->options, context->dt)};
    for (size_t k = candidate_from(walls, first); k < walls->candidates && walls->particle[k] < last; k++) {
        task.candidate = k;
        task.particle = walls->particle[k];
        force_particle(&task);
    }
}

/* Adds one thread's sums; largest overlaps are compared. */
static void add_sums(struct force_sums *total, const struct force_sums *part) {
    total->elastic_normal += part->elastic_normal;
    total->elastic_tangential += part->elastic_tangential;
    total->taken += part->taken;
    for (int c = 0; c < 6; c++)
        total->virial[c] += part->virial[c];
    total->contact_sides += part->contact_sides;
    total->contacts = total->contact_sides / 2;
    if (part->overlap_max > total->overlap_max) {
        total->overlap_max = part->overlap_max;
        memcpy(total->overlap_id, part->overlap_id, sizeof total->overlap_id);
    }
}

/* Work on the particles in this step, with the mean of the forces before and after it. */
static double wall_work(const struct wall *wall, const double before[6], const double now[6], double dt) {
    struct law_vector velocity = wall_twist_at(&wall->twist, wall->centre_now);
    struct law_vector force = law_add(wall_vector(before), 1.0, wall_vector(now));
    struct law_vector torque = law_add(wall_vector(before + 3), 1.0, wall_vector(now + 3));
    return -0.5 * dt * (law_dot(force, velocity) + law_dot(torque, wall->twist.omega));
}

/* The forces on a wall are known. */
static void set_force(struct walls *walls, int w, const double force[6], double dt) {
    if (walls->wall[w].moving)
        walls->work += wall_work(&walls->wall[w], walls->force[w], force, dt);
    memcpy(walls->force[w], force, sizeof walls->force[w]);
}

static void join_threads(struct walls *walls) {
    size_t bytes = (size_t)walls->count * sizeof *walls->exact;
    memset(walls->exact, 0, bytes);
    for (int t = 0; t < walls->threads; t++) {
        for (int w = 0; w < walls->count; w++)
            for (int c = 0; c < 6; c++)
                exact_join(&walls->exact[w][c], &walls->scratch[t]->exact[w][c]);
        memset(walls->scratch[t]->exact, 0, bytes);
    }
}

void walls_set_exact(struct walls *walls) {
    size_t count = (size_t)walls->count;
    walls->exact = memory_allocate_zero(count, sizeof *walls->exact, "forces on walls");
    for (int t = 0; t < walls->threads; t++)
        walls->scratch[t]->exact =
            memory_allocate_zero(count, sizeof *walls->scratch[t]->exact, "forces on walls");
}

int64_t *walls_exact(struct walls *walls, int *count) {
    *count = 6 * walls->count * (int)EXACT_WORDS;
    return walls->exact[0][0].word;
}

void walls_close(struct walls *walls, double dt, bool mine) {
    for (int w = 0; w < walls->count; w++) {
        double force[6] = {0};
        for (int c = 0; mine && c < 6; c++)
            force[c] = exact_value(&walls->exact[w][c]);
        set_force(walls, w, force, dt);
    }
}

void walls_finish(struct walls *walls, const struct force_context *context, struct force_sums *sums) {
    if (walls->exact)
        join_threads(walls);
    for (int w = 0; walls->exact == NULL && w < walls->count; w++) {
        double force[6] = {0};
        for (int t = 0; t < walls->threads; t++)
            for (int c = 0; c < 6; c++)
                force[c] += walls->scratch[t]->force[w][c];
        set_force(walls, w, force, context->dt);
    }
    for (int t = 0; t < walls->threads; t++) {
        add_sums(sums, &walls->scratch[t]->sums);
        walls->scratch[t]->sums = (struct force_sums){0};
        memset(walls->scratch[t]->force, 0, (size_t)walls->count * sizeof *walls->force);
    }
    walls->now = 1 - walls->now;
}

void walls_forces(const struct walls *walls, double (*force_torque)[6]) {
    memcpy(force_torque, walls->force, (size_t)walls->count * sizeof *walls->force);
}

void walls_set_forces(struct walls *walls, double (*force_torque)[6]) {
    memcpy(walls->force, force_torque, (size_t)walls->count * sizeof *walls->force);
}

double walls_work(const struct walls *walls) {
    return walls->work;
}

void walls_set_work(struct walls *walls, double work) {
    walls->work = work;
}

static struct force_contact contact_of(const struct wall_task *task, int w, const struct wall_contact *c) {
    return (struct force_contact){.id_i = task->context->particles->id[task->particle],
                                  .id_j = -(int64_t)(w + 1),
                                  .normal = {c->in.normal.x, c->in.normal.y, c->in.normal.z},
                                  .overlap = c->in.overlap,
                                  .force = {c->out.force.x, c->out.force.y, c->out.force.z}};
}

size_t walls_contacts(const struct walls *walls, const struct force_context *context,
                      struct force_contact **contacts) {
    struct wall_scratch scratch = {0};
    struct wall_task task = {.walls = (struct walls *)walls, /* only read */
                             .context = context,
                             .scratch = &scratch,
                             .law = law_case_of(&context->law->options, false),
                             .step = law_step_of(&context->law->options, 0.0)};
    size_t count = 0;
    *contacts = memory_allocate(walls->first[walls->candidates], sizeof **contacts, "contact list");
    for (size_t k = 0; k < walls->candidates; k++) {
        const struct particle_state *state = &context->particles->state[walls->particle[k]];
        size_t last;
        task.candidate = k;
        task.particle = walls->particle[k];
        walls_scratch_reserve(&scratch, walls->first[k + 1] - walls->first[k]);
        for (size_t first = walls->first[k]; first < walls->first[k + 1]; first = last) {
            int w = walls->piece[first].wall;
            size_t found =
                find_contacts(walls, k, first, &last, wall_vector(state->x), state->radius, &scratch);
            for (size_t c = 0; c < found; c++) {
                struct wall_contact contact = evaluate(&task, w, &scratch.touch[c], scratch.from[c]);
                (*contacts)[count++] = contact_of(&task, w, &contact);
            }
        }
    }
    memory_free(scratch.near);
    memory_free(scratch.touch);
    memory_free(scratch.from);
    memory_free(scratch.taken);
    return count;
}
