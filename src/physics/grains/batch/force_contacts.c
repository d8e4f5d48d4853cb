/* SPDX-License-Identifier: BSD-3-Clause */
/* The list of present contacts, for output: a client of the walk that computes contacts as the force loop does, and writes them
 * down. */
#include "physics/grains/batch/force_kernel.h"
#include "base/memory.h"

/* A thread's batch, and the list, which all threads share: they take turns. */
struct force_listing {
    struct force_thread thread;
    struct force_list {
        struct force_contact *contact;
        size_t count, capacity;
    } * list;
};

/* For a pair whose mirror another thread or rank computes: true if this side reports the contact. `d` is x_j - x_i. */
static bool force_home(int64_t id_i, int64_t id_j, const double d[3]) {
    if (id_i != id_j)
        return id_i < id_j;
    double first = d[0] != 0.0 ? d[0] : d[1] != 0.0 ? d[1] : d[2];
    return first > 0.0;
}

static struct force_contact force_contact_of(struct force_batch *b, int k, const int64_t *id) {
    const double *d = b->walk.record[k];
    size_t i = b->walk.i[k], j = b->walk.j[k];
    struct law_vector normal = force_vector(b->normal, k), force = force_vector(b->walk.out + FORCE_OUT, k);
    return (struct force_contact){.id_i = id[i],
                                  .id_j = id[j],
                                  .number_i = i,
                                  .number_j = j,
                                  .branch = {d[0], d[1], d[2]},
                                  .normal = {normal.x, normal.y, normal.z},
                                  .overlap = b->overlap[k],
                                  .force = {force.x, force.y, force.z}};
}

/* The client's `note`: appends the contacts of a batch. */
static void force_list_batch(const struct walk_task *task, struct walk_batch *batch) {
    struct force_listing *own = (struct force_listing *)batch;
    struct force_list *list = own->list;
    const int64_t *id = task->work->particles->id;
    for (int k = 0; k < batch->count; k++) {
        bool one = k >= batch->both && k < batch->one;
        if (!own->thread.batch.active[k] ||
            (one && !force_home(id[batch->i[k]], id[batch->j[k]], batch->record[k])))
            continue;
        if (list->count == list->capacity)
            list->contact =
                memory_resize(list->contact, list->capacity *= 2, sizeof *list->contact, "contact list");
        list->contact[list->count++] = force_contact_of(&own->thread.batch, k, id);
    }
}

size_t force_loop_contacts(const struct force_context *context, struct force_contact **contacts) {
    if (context->solved)
        return context->solved(context->solver, false, contacts);
    const struct force_kernel *kernel = force_kernel_find(NULL);
    const struct walk_client client = {.name = "contact list",
                                       .memory = sizeof(struct force_listing),
                                       .scatter = WALK_NOTHING,
                                       .select = force_walk_select,
                                       .compute = kernel->compute,
                                       .note = force_list_batch};
    struct force_context still = *context; /* springs stay */
    still.dt = 0.0;
    still.want_sums = still.ordered = false;
    struct walk_work work = force_walk_work(&still);
    const struct pairlist *pairs = context->list;
    struct walk *walk = walk_create(&client, pairs->threads);
    struct force_list list = {.capacity = 1024};
    list.contact = memory_allocate(list.capacity, sizeof *list.contact, "contact list");
    walk_prepare(walk, &work);
    for (int t = 0; t < pairs->threads; t++) {
        struct force_listing *own = (struct force_listing *)walk_batch_of(walk, t);
        own->list = &list;
        force_thread_begin(&own->thread, kernel, &still, t);
        for (int b = pairs->thread_block[t]; b < pairs->thread_block[t + 1]; b++)
            walk_block(walk, &work, t, b);
    }
    walk_abandon(walk, &work);
    walk_destroy(&walk);
    *contacts = list.contact;
    return list.count;
}
