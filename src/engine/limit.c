#include "engine/limit.h"
#include "core/memory.h"
#include "integrate/stability.h"
#include <math.h>
#include <string.h>

/* Sends the sums of copies to their originals, as forces go: a few components at a time. */
static void sums_home(struct simulation *s, struct stability *stability) {
    struct particles carrier = *s->particles;
    size_t stride = (size_t)carrier.force_stride, sums = (size_t)stability->sums;
    size_t width = s->law.spin ? 6 : 3;
    carrier.force = memory_allocate_zero(stability->count * stride, sizeof(double), "stability of contacts");
    for (size_t first = 0; first < sums; first += width) {
        size_t part = sums - first < width ? sums - first : width;
        for (size_t k = 0; k < stability->count; k++)
            for (size_t c = 0; c < part; c++)
                carrier.force[k * stride + c + c / 3] = stability->sum[k * sums + first + c];
        ghosts_reverse(s->ghosts, &carrier);
        for (size_t k = 0; k < carrier.owned; k++)
            for (size_t c = 0; c < part; c++)
                stability->sum[k * sums + first + c] = carrier.force[k * stride + c + c / 3];
    }
    memory_free(carrier.force);
}

/* Tells copies what was found for their originals, in place of a velocity. */
static void local_out(struct simulation *s, struct stability *stability) {
    struct particles carrier = *s->particles;
    carrier.state = memory_allocate(carrier.capacity, sizeof *carrier.state, "stability of contacts");
    memcpy(carrier.state, s->particles->state, stability->count * sizeof *carrier.state);
    for (size_t k = 0; k < carrier.owned; k++)
        carrier.state[k].v[0] = stability->local[k];
    ghosts_forward_begin(s->ghosts, &carrier);
    ghosts_forward_end(s->ghosts, &carrier);
    for (size_t k = carrier.owned; k < stability->count; k++)
        stability->local[k] = carrier.state[k].v[0];
    memory_free(carrier.state);
}

static void walls_give(struct simulation *s, struct stability *stability) {
    struct force_contact *contacts = NULL;
    int material[WALLS_MAX];
    size_t count = walls_contacts(s->walls, &s->contact, &contacts);
    for (int w = 0; w < walls_count(s->walls); w++)
        material[w] = walls_options(s->walls, w)->material;
    stability_walls(stability, &s->contact, contacts, count, material);
    memory_free(contacts);
}

/* The bound on the largest eigenvalue at step h; the scheme is stable up to 4. */
static double eigenvalue_at(struct simulation *s, double h) {
    struct stability stability;
    stability_create(&stability, &s->contact, h);
    stability_pairs(&stability, &s->contact);
    if (s->walls)
        walls_give(s, &stability);
    if (!s->alone && s->view.newton)
        sums_home(s, &stability);
    stability_solve(&stability, s->particles);
    if (!s->alone)
        local_out(s, &stability);
    double worst = stability_worst(&stability, &s->contact);
    stability_free(&stability);
    comm_max(s->comm, &worst, 1);
    return worst;
}

/* The eigenvalue is S h^2 + D h with S and D that depend on h little or not at all: the root of its springs
 * alone is above the limit, and from there the root of a straight line is below it, by little. */
double limit_of_contacts(struct simulation *s, double most) {
    double worst = eigenvalue_at(s, most), h;
    if (worst <= 4)
        return most;
    h = most * sqrt(4 / worst);
    return h * fmin(1, 4 / eigenvalue_at(s, h));
}
