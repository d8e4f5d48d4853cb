/* SPDX-License-Identifier: BSD-3-Clause */
/* What the memory and the units of this machine give at most, by loops of our own: the roof under which
 * examples/bench/roofline.sh puts the stages of a step. Not a test; make tests/bench_triad.
 *
 *     bench_triad [THREADS [MEBIBYTES]]
 *
 * MEBIBYTES is the size of each of three arrays, 256; it should be several times the last cache.
 *
 * triad: a = b + s c over doubles, 24 bytes and 2 flops an element. (The line of `a` that is read before it
 * is written is not counted, as is usual.)
 *
 * peak: multiplications and additions in registers, by the widest instructions of this CPU, not fused, as the
 * program computes.
 *
 * One line of JSON each: the fastest of ten repetitions, by wall clock. */
#include "base/memory.h"
#include "base/timer.h"
#include <omp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum { REPETITIONS = 10, LANES = 8, CHAINS = 8, ROUNDS = 2000000 };

#if defined(__x86_64__)
#define WIDEST __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define WIDEST
#endif

typedef double lanes __attribute__((vector_size(LANES * sizeof(double))));

struct arrays {
    double *a, *b, *c;
    size_t n;
};

/* First touched by the thread that will use it. */
static void fill(const struct arrays *x, int threads) {
#pragma omp parallel for schedule(static) num_threads(threads)
    for (size_t k = 0; k < x->n; k++) {
        x->a[k] = 0;
        x->b[k] = 1;
        x->c[k] = 2;
    }
}

static double triad(const struct arrays *x, double s, int threads) {
    double *restrict a = x->a;
    const double *b = x->b, *c = x->c;
    double start = timer_now();
#pragma omp parallel for simd schedule(static) num_threads(threads)
    for (size_t k = 0; k < x->n; k++)
        a[k] = b[k] + s * c[k];
    return timer_now() - start;
}

/* CHAINS sums that do not wait for each other: 2 LANES CHAINS flops a round. */
WIDEST
static double compute(double factor) {
    lanes sum[CHAINS], f, add;
    for (int l = 0; l < LANES; l++) {
        f[l] = factor;
        add[l] = 1e-9 * l;
    }
    for (int c = 0; c < CHAINS; c++)
        sum[c] = add + c;
    for (int r = 0; r < ROUNDS; r++)
        for (int c = 0; c < CHAINS; c++)
            sum[c] = sum[c] * f + add;
    lanes all = {0};
    for (int c = 0; c < CHAINS; c++)
        all += sum[c];
    double total = 0;
    for (int l = 0; l < LANES; l++)
        total += all[l];
    return total;
}

static double peak(double *result, int threads) {
    double total = 0, start = timer_now();
#pragma omp parallel num_threads(threads) reduction(+ : total)
    total += compute(1 - 1e-9 * (1 + omp_get_thread_num()));
    *result += total;
    return timer_now() - start;
}

static void print(const char *loop, int threads, double seconds, double elements, double bytes,
                  double flops) {
    printf("{\"loop\": \"%s\", \"threads\": %d, \"seconds\": %.6g, \"particles\": %.0f, \"ns_per_particle\": "
           "%.6g, \"gigabytes_per_second\": %.5g, \"gigaflops\": %.5g}\n",
           loop, threads, seconds, elements, 1e9 * seconds / elements, 1e-9 * bytes / seconds,
           1e-9 * flops / seconds);
}

int main(int argc, char **argv) {
    int threads = argc > 1 ? atoi(argv[1]) : omp_get_max_threads(),
        mebibytes = argc > 2 ? atoi(argv[2]) : 256;
    if (threads < 1 || mebibytes < 1) {
        fprintf(stderr, "usage: bench_triad [THREADS [MEBIBYTES]]\n");
        return 2;
    }
    struct arrays x = {.n = (size_t)mebibytes << 17};
    x.a = memory_allocate(x.n, sizeof *x.a, "triad");
    x.b = memory_allocate(x.n, sizeof *x.b, "triad");
    x.c = memory_allocate(x.n, sizeof *x.c, "triad");
    fill(&x, threads);
    double moved = 1e30, computed = 1e30, result = 0;
    for (int r = 0; r < REPETITIONS; r++) {
        double seconds = triad(&x, 3 + r, threads);
        moved = seconds < moved ? seconds : moved;
        result += x.a[(size_t)r * x.n / REPETITIONS];
        seconds = peak(&result, threads);
        computed = seconds < computed ? seconds : computed;
    }
    double rounds = (double)ROUNDS * CHAINS * LANES * threads;
    print("triad", threads, moved, (double)x.n, 24 * (double)x.n, 2 * (double)x.n);
    print("peak", threads, computed, rounds, 0, 2 * rounds);
    memory_free(x.a);
    memory_free(x.b);
    memory_free(x.c);
    return result == 0; /* keeps the loops */
}
