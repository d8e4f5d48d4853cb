/* SPDX-License-Identifier: BSD-3-Clause */
/* Passes the contacts of all ranks to stability.h and iterates. Read limit.h first. */
#include "engine/limit.h"
#include "particles/spin.h"
#include "core/memory.h"
#include "integrate/stability.h"
#include "particles/fields.h"
#include <math.h>
#include <string.h>

/* Sends the sums of copies to their originals, by the exchange of forces: a few components at a time, in the
 * memory of the forces. The forces are restored afterwards. */
static void sums_home(struct simulation *s, struct stability *stability) {
    struct particles *p = s->particles;
    struct field_list fields = fields_one(FIELD_FORCE);
    size_t stride = (size_t)p->force_stride, sums = (size_t)stability->sums, bytes;
    size_t width = spin_of(p) ? 6 : 3;
    if (spin_of(p))
        fields.field[fields.count++] = fields_find(p, "torque");
    double *kept = memory_allocate(stability->count * stride, sizeof *kept, "stability of contacts");
    bytes = stability->count * stride * sizeof *kept;
    memcpy(kept, p->force, bytes);
    for (size_t first = 0; first < sums; first += width) {
        size_t part = sums - first < width ? sums - first : width;
        memset(p->force, 0, bytes);
        for (size_t k = 0; k < stability->count; k++)
            for (size_t c = 0; c < part; c++)
                p->force[k * stride + c + c / 3] = stability->sum[k * sums + first + c];
        ghosts_reverse(s->ranks.ghosts, p, &fields);
        for (size_t k = 0; k < p->owned; k++)
            for (size_t c = 0; c < part; c++)
                stability->sum[k * sums + first + c] = p->force[k * stride + c + c / 3];
    }
    memcpy(p->force, kept, bytes);
    memory_free(kept);
}

/* Sends the results of originals to their copies, in the memory of the velocity. The velocity is restored
 * afterwards. */
static void local_out(struct simulation *s, struct stability *stability) {
    struct particles *p = s->particles;
    struct field_list fields = fields_one(FIELD_VELOCITY);
    struct particle_state *kept = memory_allocate(stability->count, sizeof *kept, "stability of contacts");
    memcpy(kept, p->state, stability->count * sizeof *kept);
    for (size_t k = 0; k < p->owned; k++)
        p->state[k].v[0] = stability->local[k];
    ghosts_forward_begin(s->ranks.ghosts, p, &fields);
    ghosts_forward_end(s->ranks.ghosts, p);
    for (size_t k = p->owned; k < stability->count; k++)
        stability->local[k] = p->state[k].v[0];
    memcpy(p->state, kept, stability->count * sizeof *kept);
    memory_free(kept);
}

static void walls_give(struct simulation *s, struct stability *stability) {
    struct force_contact *contacts = NULL;
    int material[WALLS_MAX];
    size_t count = walls_contacts(s->grains.walls, &s->grains.contact, &contacts);
    for (int w = 0; w < walls_count(s->grains.walls); w++)
        material[w] = walls_options(s->grains.walls, w)->material;
    stability_walls(stability, &s->grains.contact, contacts, count, material);
    memory_free(contacts);
}

/* The bound on the largest eigenvalue at step h; the scheme is stable up to 4. */
static double eigenvalue_at(struct simulation *s, double h) {
    struct stability stability;
    stability_create(&stability, &s->grains.contact, h);
    stability_pairs(&stability, &s->grains.contact);
    if (s->grains.walls)
        walls_give(s, &stability);
    if (!s->ranks.alone && s->search.view.newton)
        sums_home(s, &stability);
    physics_stiffen(&s->physics, &stability);
    stability_solve(&stability, s->particles);
    if (!s->ranks.alone)
        local_out(s, &stability);
    double worst = stability_worst(&stability, &s->grains.contact);
    worst = fmax(worst, physics_stiffest(&s->physics, &stability));
    stability_free(&stability);
    comm_max(s->comm, &worst, 1);
    return worst;
}

/* The eigenvalue is S h^2 + D h; S and D depend on h little or not at all. The root for the springs alone
 * lies above the limit. From there the root of a straight line lies slightly below the limit. */
double limit_of_contacts(struct simulation *s, double most) {
    double worst = eigenvalue_at(s, most), h;
    if (worst <= 4)
        return most;
    h = most * sqrt(4 / worst);
    return h * fmin(1, 4 / eigenvalue_at(s, h));
}
