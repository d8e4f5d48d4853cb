/* SPDX-License-Identifier: BSD-3-Clause */
/* Contacts of a law with parts, one after another. Read force_general.h first. */
#include "physics/grains/batch/force_general.h"
#include "physics/grains/laws/law_general.h"
#include <string.h>

_Static_assert((int)LAW_MEMORY_MAX <= (int)HISTORY_COMPONENTS_MAX, "a law remembers more than history holds");

/* What the normal direction of contact k needs. */
static void contact_take(const struct law *law, struct force_batch *b, int k, struct law_general *in) {
    double ri = b->walk.radius[0][k], rj = b->walk.radius[1][k];
    in->contact.overlap = b->overlap[k];
    in->contact.mass = b->mass[k];
    in->contact.radius = isinf(rj) ? ri : ri * rj / (ri + rj);
    in->contact.normal = force_vector(b->normal, k);
    in->contact.velocity = force_vector(b->velocity, k);
    in->contact.coefficients = force_coefficients_of(b, k);
    in->extra = b->extra[k];
    in->radius[0] = ri;
    in->radius[1] = rj;
    for (int c = 0; c < law->history_components; c++)
        in->value[c] = b->walk.history[c][k];
}

/* Entries behind the last contact repeat it, for loops over whole vectors. */
static void contact_pad(struct force_batch *b) {
    int last = b->walk.count - 1;
    for (int k = b->walk.count; k < b->walk.padded; k++) {
        for (int c = 0; c < FORCE_SPRINGS; c++)
            b->springs[c][k] = b->springs[c][last];
        for (int c = 0; c < 3; c++)
            b->energy[c][k] = b->energy[c][last];
    }
}

void force_general_push(const struct law *law, struct law_step step, struct force_batch *b) {
    struct law_general in = {0};
    for (int k = 0; k < b->walk.count; k++) {
        struct law_push push;
        contact_take(law, b, k, &in);
        bool interacts = law_general_push(law, step, &in, &push);
        b->effective[k] = in.contact.radius;
        b->springs[0][k] = push.force;
        b->springs[1][k] = push.base;
        b->springs[2][k] = push.grip.tangential;
        b->springs[3][k] = push.press;
        b->springs[4][k] = push.grip.touches ? 1.0 : 0.0;
        b->springs[5][k] = interacts ? 1.0 : 0.0;
        b->springs[6][k] = push.grip.a;
        b->springs[7][k] = push.grip.spring;
        b->energy[0][k] = push.grip.energy;
        b->energy[1][k] = 0.0;
        b->energy[2][k] = push.taken;
        for (int c = law->history_odd; c < law->history_components; c++)
            b->walk.history[c][k] = in.value[c];
    }
    contact_pad(b);
}

void force_general_respond(const struct law *law, struct law_step step, struct force_batch *b) {
    struct law_general in = {0};
    for (int k = 0; k < b->walk.count; k++) {
        struct law_response out;
        contact_take(law, b, k, &in);
        if (law->spin) {
            in.contact.half_normal = force_vector(b->half_normal, k);
            in.contact.surface = force_vector(b->surface, k);
            in.contact.spin = force_vector(b->spin, k);
        }
        b->springs[5][k] = law_general_respond(law, step, &in, &out) ? 1.0 : 0.0;
        force_set(b->walk.out + FORCE_OUT, k, out.force);
        force_set(b->walk.out + FORCE_MOMENT, k, out.moment);
        force_set(b->walk.out + FORCE_ROLLING, k, out.rolling);
        b->energy[0][k] = out.normal_energy;
        b->energy[1][k] = out.spring_energy;
        b->energy[2][k] = out.taken;
        for (int c = 0; c < law->history_components; c++)
            b->walk.history[c][k] = in.value[c];
    }
    contact_pad(b);
}
