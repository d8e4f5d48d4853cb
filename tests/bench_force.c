/* SPDX-License-Identifier: BSD-3-Clause */
/* Times the force loop and the integrator on a dense cloud: spheres on a jittered cubic lattice in memory
 * order, with about 3.2 pairs and 1.1 contacts each (as the bidisperse benchmark has). Not a test; make
 * tests/bench_force.
 *
 *   bench_force [THREADS [EDGE [KERNEL [LAW]]]]     EDGE^3 spheres; LAW: smooth, rough (LAMMPS's
 * gran/hooke/history), hooke, hertz, rolling */
#include "physics/grains/batch/force.h"
#include "base/memory.h"
#include "base/random.h"
#include "base/timer.h"
#include "physics/grains/motion/integrator.h"
#include "tests/fields_by_hand.h"
#include "tests/own_law.h"
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static const double spacing = 2.06, jitter = 0.36, skin = 0.5, block_rows = 2048;

static struct law bench_law(const char *name) {
    static struct law_pair pair[2][2];
    const struct law_material material = {"m", 1.0, 1e4, 0.25};
    struct law_options o = law_options_default();
    struct law law;
    struct error error = {0};
    o.normal = strcmp(name, "hertz") == 0 ? LAW_HERTZ : LAW_HOOKE;
    o.rolling = strcmp(name, "rolling") == 0 ? LAW_ROLLING_SPRING : LAW_ROLLING_NONE;
    if (strcmp(name, "smooth") == 0)
        o.tangential = LAW_FRICTIONLESS;
    if (strcmp(name, "rough") == 0 || strcmp(name, "smooth") == 0) {
        o.damping = LAW_DAMPING_COEFFICIENT;
        o.synchronised = false;
    }
    pair[0][0] = (struct law_pair){.restitution = 0.5,
                                   .friction = 0.5,
                                   .rolling_friction = 0.1,
                                   .k_n = 1000.0,
                                   .k_t = 1000.0 * 2.0 / 7.0,
                                   .gamma_n = 50.0,
                                   .gamma_t = 25.0};
    if (!law_prepare(&law, &o, 1, &material, pair[0], &error)) {
        fprintf(stderr, "%s\n", error.text);
        exit(1);
    }
    return law;
}

static struct particles *bench_cloud(const struct law *law, int edge) {
    size_t n = (size_t)edge * (size_t)edge * (size_t)edge;
    struct particles *p = particles_with(law->spin ? WITH_SPIN : 0, n);
    for (size_t k = 0; k < n; k++) {
        struct random_sequence r = random_sequence(1, RANDOM_TEST, k);
        const size_t cell[3] = {k % (size_t)edge, k / (size_t)edge % (size_t)edge,
                                k / (size_t)edge / (size_t)edge};
        particles_append(p);
        p->state[k].radius = 1.0;
        p->state[k].inverse_mass = 1.0 / particles_sphere_mass(1.0, 1.0);
        p->id[k] = (int64_t)k + 1;
        for (int c = 0; c < 3; c++) {
            p->state[k].x[c] = spacing * (double)cell[c] + jitter * (2.0 * random_uniform(&r) - 1.0);
            p->state[k].v[c] = random_normal(&r);
        }
    }
    return p;
}

/* Appends pairs of rows [first, last) with one of the 13 or all 26 lattice neighbours: crossing thread ranges
 * or not. */
static void bench_pairs(struct pairlist *list, const struct particles *p, int edge, size_t first, size_t last,
                        const size_t range[2], bool crossing) {
    for (size_t i = first; i < last; i++)
        for (int o = crossing ? 0 : 14; o < 27; o++) {
            long step[3] = {o % 3 - 1, o / 3 % 3 - 1, o / 9 - 1}, at[3];
            size_t cell = i, j = 0, factor = 1;
            bool inside = o != 13;
            for (int c = 0; c < 3; c++, cell /= (size_t)edge, factor *= (size_t)edge) {
                at[c] = (long)(cell % (size_t)edge) + step[c];
                inside = inside && at[c] >= 0 && at[c] < edge;
                j += (size_t)(inside ? at[c] : 0) * factor;
            }
            if (!inside || (j >= range[0] && j < range[1]) == crossing)
                continue;
            double square = 0.0;
            for (int c = 0; c < 3; c++)
                square += (p->state[j].x[c] - p->state[i].x[c]) * (p->state[j].x[c] - p->state[i].x[c]);
            if (square >= (2.0 + skin) * (2.0 + skin))
                continue;
            list->i[list->pair_count] = (uint32_t)i;
            list->j[list->pair_count++] = (uint32_t)j;
        }
}

static struct pairlist bench_list(const struct particles *p, int edge, int threads) {
    struct pairlist list = {.threads = threads};
    size_t n = p->owned;
    list.i = memory_allocate(8 * n, sizeof *list.i, "pairs");
    list.j = memory_allocate(8 * n, sizeof *list.j, "pairs");
    list.blocks =
        memory_allocate(n / (size_t)block_rows + 2 * (size_t)threads + 1, sizeof *list.blocks, "blocks");
    list.thread_block = memory_allocate((size_t)threads + 1, sizeof *list.thread_block, "blocks");
    for (int t = 0; t < threads; t++) {
        const size_t range[2] = {n * (size_t)t / (size_t)threads, n * ((size_t)t + 1) / (size_t)threads};
        list.thread_block[t] = list.block_count;
        for (size_t row = range[0]; row < range[1]; row += (size_t)block_rows) {
            size_t last = row + (size_t)block_rows < range[1] ? row + (size_t)block_rows : range[1];
            struct pair_block *block = &list.blocks[list.block_count++];
            *block = (struct pair_block){
                (uint32_t)row, (uint32_t)last, list.pair_count, 0, 0, 0, PAIR_BLOCK_ROWS, 0};
            bench_pairs(&list, p, edge, row, last, range, false);
            block->one_sided = list.pair_count;
            bench_pairs(&list, p, edge, row, last, range, true);
            block->slotted = block->end_pair = list.pair_count;
        }
    }
    list.thread_block[threads] = list.block_count;
    return list;
}

/* One pass over all blocks: forces, integration, or each block integrated just before its forces (for timing:
 * wrong physics). */
static void bench_pass(struct force_loop *loop, const struct force_context *force,
                       const struct integrator_context *advance, const char *what) {
    const struct pairlist *list = force->list;
    struct force_sums sums;
#pragma omp parallel num_threads(list->threads)
    {
        int t = omp_get_thread_num();
        for (int b = list->thread_block[t]; b < list->thread_block[t + 1]; b++) {
            if (what[0] != 'f')
                integrator_advance(force->particles, advance, list->blocks[b].first_row,
                                   list->blocks[b].last_row);
            if (what[0] != 'a')
                force_loop_block(loop, force, t, b);
        }
    }
    if (what[0] != 'a')
        force_loop_finish(loop, force, &sums);
}

/* Processor seconds of all threads so far: on a busy machine it says more than the clock. */
static double bench_cpu(void) {
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int bench_compare(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Times 21 passes: prints the median and the fastest by the clock, and the median of the processor's time a
 * thread, which is returned; milliseconds. */
static double bench_time(struct force_loop *loop, const struct force_context *force,
                         const struct integrator_context *advance, const char *what) {
    enum { PASSES = 21 };
    double clock[PASSES], cpu[PASSES];
    for (int n = 0; n < PASSES; n++) {
        double start = timer_now(), start_cpu = bench_cpu();
        bench_pass(loop, force, advance, what);
        clock[n] = 1e3 * (timer_now() - start);
        cpu[n] = 1e3 * (bench_cpu() - start_cpu) / force->list->threads;
    }
    qsort(clock, PASSES, sizeof *clock, bench_compare);
    qsort(cpu, PASSES, sizeof *cpu, bench_compare);
    printf("%-8s clock %7.2f ms, fastest %7.2f, cpu %7.2f, fastest %7.2f", what, clock[PASSES / 2], clock[0],
           cpu[PASSES / 2], cpu[0]);
    return cpu[0];
}

int main(int count, char **argument) {
    int threads = count > 1 ? atoi(argument[1]) : 2, edge = count > 2 ? atoi(argument[2]) : 89;
    OWN_LAW law = bench_law(count > 4 ? argument[4] : "rough");
    struct particles *p = bench_cloud(&law, edge);
    struct pairlist list = bench_list(p, edge, threads);
    struct history *history = law.spin ? history_create(law.history_components, threads) : NULL;
    struct force_loop *loop = force_loop_create(threads);
    struct force_context force = {
        .particles = p, .list = &list, .history = history, .law = &law, .dt = 1e-12};
    const struct integrator_context advance = {.dt = 1e-12, .dimension = 3, .groups = 1};
    struct force_sums sums;
    if (count > 3 && !force_loop_choose(loop, argument[3]))
        return 1;
    force_loop_prepare(loop, &force);
    force_loop_run(loop, &force, &sums);
    double pairs = (double)list.pair_count, contacts = (double)sums.contacts;
    printf("%s, %d threads, %zu spheres, %.2f pairs and %.2f contacts each\n", force_loop_kernel(loop),
           threads, p->owned, pairs / (double)p->owned, contacts / (double)p->owned);
    double ms = bench_time(loop, &force, &advance, "force");
    printf("  %.2f ns a pair, %.2f ns a contact (times threads)\n", 1e6 * ms * threads / pairs,
           1e6 * ms * threads / contacts);
    ms = bench_time(loop, &force, &advance, "advance");
    printf("  %.2f ns a particle\n", 1e6 * ms * threads / (double)p->owned);
    ms = bench_time(loop, &force, &advance, "both");
    printf("  one visit a block\n");
    return 0;
}
