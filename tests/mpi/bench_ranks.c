/* SPDX-License-Identifier: BSD-3-Clause */
/* Measures the work that depends on the rank count, for pretended rank counts on one process: the division of
 * the box, the search for neighbours, the owner of a position, the sorting of items by rank. None of this work
 * communicates. Not a test; make tests/mpi/bench_ranks.
 *
 *   bench_ranks [RANKS...]     one line of JSON for each; default: 1000 10000 100000 1000000
 *
 * Seconds: brick, bisection (the making of the domain, neighbours included), divide (the cut tree from the corners of all
 * subdomains, as after Zoltan), groups (one sorting of the copies of a rank). Nanoseconds: owner_brick,
 * owner_bisection. Bytes: brick_bytes, tree_bytes, groups_bytes. */
#include "kernel/comm/domain.h"
#include "kernel/comm/domain_tree.h"
#include "kernel/comm/rank_groups.h"
#include "base/memory.h"
#include "base/random.h"
#include "base/timer.h"
#include <stdio.h>
#include <stdlib.h>

enum { LOOKS = 100000, COPIES = 16384, REPETITIONS = 5 };

static struct domain *divide(int ranks, const struct box *box, enum domain_kind kind) {
    struct comm comm = {.handle = MPI_COMM_NULL, .rank = ranks / 2, .size = ranks};
    struct domain_options options = {.kind = kind};
    struct error error = {0};
    struct domain *domain = domain_create(&comm, box, &options, &error);
    if (domain == NULL) {
        fprintf(stderr, "%s\n", error.text);
        exit(1);
    }
    return domain;
}

/* Prints the costs of a kind of domain. */
static void time_domain(int ranks, const struct box *box, enum domain_kind kind, const char *name) {
    double start = timer_now();
    size_t before = memory_in_use(), neighbours;
    struct domain *domain = divide(ranks, box, kind);
    double made = timer_now() - start;
    size_t bytes = memory_in_use() - before;
    domain_neighbours(domain, &neighbours);
    struct random_sequence random = random_sequence(1, RANDOM_TEST, 0);
    double(*x)[3] = memory_allocate(LOOKS, sizeof *x, "positions");
    for (int k = 0; k < LOOKS; k++)
        for (int d = 0; d < 3; d++)
            x[k][d] = box->edge[d] * random_uniform(&random);
    int64_t sum = 0;
    start = timer_now();
    for (int k = 0; k < LOOKS; k++)
        sum += domain_owner(domain, x[k]);
    double looked = timer_now() - start;
    if (sum < 0) /* keeps the compiler from leaving the loop out */
        exit(1);
    memory_free(x);
    printf("\"%s\": %.4g, \"%s_bytes\": %zu, \"neighbours_%s\": %zu, \"owner_%s\": %.4g, ", name, made, name,
           bytes, name, neighbours, name, 1e9 * looked / LOOKS);
    domain_destroy(&domain);
}

static void time_tree(int ranks, const struct box *box) {
    size_t before = memory_in_use();
    struct domain_tree *tree = domain_tree_halve(ranks, box);
    size_t bytes = memory_in_use() - before;
    double(*lower)[3] = memory_allocate((size_t)ranks, sizeof *lower, "subdomains");
    double(*upper)[3] = memory_allocate((size_t)ranks, sizeof *upper, "subdomains");
    for (int k = 0; k < ranks; k++)
        for (int d = 0; d < 3; d++)
            lower[k][d] = 0, upper[k][d] = box->edge[d];
    for (int k = 0; k < ranks; k++)
        domain_tree_bounds(tree, k, lower[k], upper[k]);
    double start = timer_now();
    struct domain_tree *again =
        domain_tree_from_bounds(ranks, 3, (const double(*)[3])lower, (const double(*)[3])upper);
    double made = timer_now() - start;
    if (again == NULL) {
        fprintf(stderr, "no tree has these subdomains\n");
        exit(1);
    }
    printf("\"tree_bytes\": %zu, \"divide\": %.4g, ", bytes, made);
    domain_tree_destroy(&again);
    domain_tree_destroy(&tree);
    memory_free(lower);
    memory_free(upper);
}

/* Copies for 26 neighbours, spread over the rank numbers. */
static void time_groups(int ranks) {
    int *rank = memory_allocate(COPIES, sizeof *rank, "ranks of copies");
    for (int k = 0; k < COPIES; k++)
        rank[k] = (int)((int64_t)ranks * (k % 26) / 26);
    double least = 1e300;
    size_t before = memory_in_use(), most = 0;
    for (int k = 0; k < REPETITIONS; k++) {
        struct groups groups;
        memory_peak_reset();
        double start = timer_now();
        rank_groups_make(&groups, rank, COPIES, ranks);
        double seconds = timer_now() - start;
        least = seconds < least ? seconds : least;
        most = memory_peak() - before;
        rank_groups_free(&groups);
    }
    printf("\"groups\": %.4g, \"groups_bytes\": %zu}\n", least, most);
    memory_free(rank);
}

int main(int count, char **argument) {
    static char *usual[] = {"", "1000", "10000", "100000", "1000000"};
    const struct box box = {.dimension = 3, .edge = {1, 1, 1}, .periodic = {true, true, true}};
    if (count < 2) {
        count = sizeof usual / sizeof usual[0];
        argument = usual;
    }
    for (int k = 1; k < count; k++) {
        int ranks = atoi(argument[k]);
        if (ranks < 2) {
            fprintf(stderr, "usage: bench_ranks [RANKS...]\n");
            return 2;
        }
        printf("{\"series\": \"lengths\", \"ranks\": %d, ", ranks);
        time_domain(ranks, &box, DOMAIN_BRICK, "brick");
        time_domain(ranks, &box, DOMAIN_BISECTION, "bisection");
        time_tree(ranks, &box);
        time_groups(ranks);
        fflush(stdout);
    }
    return 0;
}
