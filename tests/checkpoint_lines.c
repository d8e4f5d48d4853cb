/* SPDX-License-Identifier: BSD-3-Clause */
/* Prints a checkpoint as lines that can be sorted and compared: a line a particle, a remembered contact, a
 * wall, every number by its bytes. What depends on the layout is left out: the order, and sums that each rank
 * keeps for itself.
 *
 *     checkpoint_lines CHECKPOINT */
#include "kernel/comm/comm.h"
#include "data/formats/checkpoint.h"
#include "kernel/particles/fields.h"
#include "tests/fields_by_hand.h"

#include <stdio.h>
#include <string.h>

static void put_bytes(const char *name, const void *data, size_t bytes) {
    const unsigned char *byte = data;
    printf(" %s ", name);
    for (size_t k = 0; k < bytes; k++)
        printf("%02x", byte[k]);
}

static void put_particles(const struct particles *particles) {
    for (size_t k = 0; k < particles->owned; k++) {
        printf("particle %lld", (long long)particles->id[k]);
        for (int f = 0; f < fields_count(particles); f++) {
            const struct field *field = fields_get(particles, f);
            size_t stride;
            if (!(field->use & FIELD_RESTART))
                continue;
            const char *base = fields_base(particles, f, &stride);
            put_bytes(field->name, base + k * stride, fields_bytes(field));
        }
        printf("\n");
    }
}

static void put_history(const struct checkpoint_loaded *loaded) {
    size_t bytes = (size_t)loaded->history_components * sizeof(double);
    for (size_t k = 0; k < loaded->history.count; k++) {
        const struct history_row *row = &loaded->history.row[k];
        printf("contact %lld %lld", (long long)row->id, (long long)row->partner);
        put_bytes("value", row->value, bytes);
        put_bytes("separation", row->separation, sizeof row->separation);
        printf("\n");
    }
    for (size_t k = 0; k < loaded->wall_history.count; k++) {
        const struct history_row *row = &loaded->wall_history.row[k];
        printf("wall contact %lld %d %d", (long long)row->id, wall_row_wall(row), wall_row_feature(row));
        put_bytes("value", row->value, bytes);
        printf("\n");
    }
}

static void put_rest(const struct checkpoint_loaded *loaded) {
    const struct checkpoint_numbers *numbers = &loaded->numbers;
    for (int w = 0; w < loaded->walls; w++) {
        printf("wall %s", loaded->wall[w].name);
        put_bytes("pose", &loaded->wall[w].pose, sizeof loaded->wall[w].pose);
        printf("\n");
    }
    printf("run");
    put_bytes("step", &numbers->step, sizeof numbers->step);
    put_bytes("time", &numbers->time, sizeof numbers->time);
    put_bytes("dt", &numbers->dt, sizeof numbers->dt);
    put_bytes("next_id", &numbers->next_id, sizeof numbers->next_id);
    for (int kind = 0; kind < RESTART_SUM; kind++)
        for (size_t k = 0; k < loaded->restart.count[kind]; k++)
            if (strncmp(loaded->restart.name[kind][k], "ranks", 5) != 0)
                put_bytes(loaded->restart.name[kind][k], &loaded->restart.value[kind][k], sizeof(uint64_t));
    printf("\n");
}

int main(int argc, char **argv) {
    struct comm comm;
    struct error error = {0};
    struct checkpoint_loaded loaded = {0};
    comm_start(&comm, &argc, &argv);
    struct particles *particles = particles_with(WITH_ALL, 0);
    bool good = argc == 2 && checkpoint_read(&comm, argv[1], particles, &loaded, &error);
    if (good) {
        put_particles(particles);
        put_history(&loaded);
        put_rest(&loaded);
    } else {
        fprintf(stderr, "checkpoint_lines: %s\n", argc == 2 ? error.text : "one file, please");
    }
    checkpoint_loaded_free(&loaded);
    particles_destroy(&particles);
    comm_stop(&comm);
    return !good;
}
