/* SPDX-License-Identifier: BSD-3-Clause */
/* What physics give to the report of a run (struct physics_shown). */
#ifndef SCREE_ENGINE_REPORT_PART_H
#define SCREE_ENGINE_REPORT_PART_H

#include <stdint.h>

enum { REPORT_SOLVERS_MAX = 8 };

/* The linear systems of one kind. Seconds are those of this rank; the rest is the same on all ranks. */
struct report_solver {
    const char *name;       /* borrowed until the report is made, as the next texts */
    uint64_t rows, entries; /* of the matrix, over all ranks; 0 entries: without a matrix */
    uint64_t solves, iterations;
    uint64_t set_ups, kept; /* preconditioners made; solves of a new matrix with an old preconditioner */
    uint64_t doubtful;      /* solves with a true residual far above the tolerance */
    uint64_t products;      /* of the matrix with a vector, those that are timed */
    double residual;        /* true, relative, of the last solve */
    double residual_worst;
    double seconds_matrix, seconds_set_up, seconds_solve, seconds_products;
};

/* What hard contacts have seen since this program began, this rank's part. */
struct report_contacts {
    double overlap;  /* largest, over the smaller radius */
    double approach; /* largest speed at which touching grains still approach after a solve, over g dt */
    double news;     /* speed of news by kappa; 0: by the law's own stiffness */
    double fastest;  /* largest speed of a grain */
};

struct report_part {
    const char *law, *simd;                 /* of contacts; the instruction set of their loop. NULL: none */
    const struct report_contacts *contacts; /* NULL: none */
    int solvers;
    struct report_solver solver[REPORT_SOLVERS_MAX];
};

#endif
