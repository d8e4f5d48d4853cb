/* SPDX-License-Identifier: BSD-3-Clause */
/* Sets the number of threads of the program's teams. Read threads.h first. */
#include "base/threads.h"

#include <omp.h>

int threads_set(int wanted, int most, struct error *error) {
    int asked = wanted > 0 ? wanted : omp_get_max_threads(), granted = 1;
    if (wanted > most) {
        error_set(error, ERROR_USER, "threads: %d asked for; allowed: up to %d a rank", wanted, most);
        return 0;
    }
    omp_set_dynamic(0);
    omp_set_num_threads(asked < most ? asked : most);
#pragma omp parallel
#pragma omp single
    granted = omp_get_num_threads();
    if (granted < wanted) {
        error_set(error, ERROR_USER,
                  "threads: %d asked for, but OpenMP grants a rank %d only (OMP_THREAD_LIMIT?); allowed: "
                  "up to that, or 0 for as many as there are",
                  wanted, granted);
        return 0;
    }
    omp_set_num_threads(granted);
    return granted;
}
