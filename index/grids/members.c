/* SPDX-License-Identifier: BSD-3-Clause */
/* Counts and places the members of groups, with threads. Read members.h first. */
#include "index/grids/members.h"

#include "base/memory.h"

#include <omp.h>

/* Counts the groups of [begin, end), run by run; true if they never descend. */
static bool count_groups(const struct index_view *view, size_t begin, size_t end, const int *group_of,
                         size_t *count) {
    bool ascending = true;
    int previous = 0;
    for (size_t k = begin, next; k < end; k = next) {
        int group = group_of[view->size_class[k]];
        next = members_run(view->size_class, k, end);
        ascending = ascending && group >= previous;
        previous = group;
        count[group] += next - k;
    }
    return ascending;
}

struct share {
    size_t count[INDEX_CLASS_MAX]; /* then: place of the thread's next member of the group */
    bool ascending;
};

/* Turns the counts of all threads into places; true if the whole range ascends. */
static bool place_groups(struct members *members, struct share *shares, int threads) {
    bool ascending = true;
    int highest = 0;
    size_t sum = 0;
    for (int t = 0; t < threads; t++) {
        ascending = ascending && shares[t].ascending;
        for (int g = 0; g < INDEX_CLASS_MAX; g++) {
            ascending = ascending && (shares[t].count[g] == 0 || g >= highest);
            highest = shares[t].count[g] > 0 && g > highest ? g : highest;
        }
    }
    for (int g = 0; g < INDEX_CLASS_MAX; g++) {
        members->begin[g] = sum;
        for (int t = 0; t < threads; t++) {
            size_t count = shares[t].count[g];
            shares[t].count[g] = sum;
            sum += count;
        }
    }
    members->begin[INDEX_CLASS_MAX] = sum;
    return ascending;
}

void members_split(struct members *members, const struct index_view *view, size_t first, size_t last,
                   const int *group_of) {
    members->first = first;
    struct share *shares = memory_allocate_zero((size_t)view->threads, sizeof *shares, "class counts");
#pragma omp parallel num_threads(view->threads) if (last - first > 10000)
    {
        size_t threads = (size_t)omp_get_num_threads();
        size_t thread = (size_t)omp_get_thread_num();
        size_t begin = first + (last - first) * thread / threads;
        size_t end = first + (last - first) * (thread + 1) / threads;
        struct share *share = &shares[thread];
        share->ascending = count_groups(view, begin, end, group_of, share->count);
#pragma omp barrier
#pragma omp single
        {
            members->contiguous = place_groups(members, shares, (int)threads);
            if (!members->contiguous && last - first > members->capacity) {
                members->capacity = last - first;
                memory_free(members->list);
                members->list = memory_allocate(members->capacity, sizeof *members->list, "class members");
            }
        }
        if (!members->contiguous) {
            for (size_t k = begin; k < end; k++) {
                members->list[share->count[group_of[view->size_class[k]]]++] = (uint32_t)k;
            }
        }
    }
    memory_free(shares);
}

void members_free(struct members *members) {
    memory_free(members->list);
    *members = (struct members){0};
}
