/* SPDX-License-Identifier: BSD-3-Clause */
/* What holds for any library behind solve.h: means over regions, the age of a preconditioner, the true residual,
 * the report. */
#include "physics/solve/solve.h"
#include "base/memory.h"
#include "physics/solve/backend.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The course of all systems of a prefix. */
struct total {
    char prefix[32]; /* "": free */
    struct solve_report report;
};

struct solve {
    const struct solve_backend *backend;
    const struct comm *comm;
    void *library;
    struct timers *timers; /* NULL: none */
    struct total total[SOLVE_PREFIXES_MAX];
};

struct solve_system {
    struct solve *solve;
    void *back;
    int32_t count;
    double tolerance;
    bool ends_otherwise;  /* than by the tolerance alone */
    double *product;      /* [count]: A x */
    int regions;          /* 0: not singular */
    int32_t *region;      /* [count]; NULL: all in region 0 */
    double *region_rows;  /* [regions]: over all ranks */
    double *region_sum;   /* [regions] */
    bool changed;         /* the values, since the last set-up */
    bool stale;           /* the preconditioner may not be kept */
    int age, reuse;       /* solves since the last set-up with old values, and how many there may be */
    int iterations_fresh; /* of the first solve after the last set-up; -1: not known yet */
    struct solve_report report;
    struct solve_report *total; /* of the system's prefix */
};

const char *solve_preconditioners(void) {
    return "boomeramg, gamg, ml, ilu, sor, jacobi, none";
}

const char *solve_methods(void) {
    return "fgmres, gmres, lgmres, bicgstab, cg";
}

struct solve_options solve_options_singular(const char *prefix) {
    return (struct solve_options){.prefix = prefix,
                                  .method = "fgmres",
                                  .preconditioner = "boomeramg",
                                  .tolerance = 1e-5,
                                  .iterations = 200,
                                  .restart = 30,
                                  .pin = 1e-9};
}

struct solve_options solve_options_regular(const char *prefix) {
    return (struct solve_options){.prefix = prefix,
                                  .method = "bicgstab",
                                  .preconditioner = "jacobi",
                                  .tolerance = 1e-8,
                                  .iterations = 500,
                                  .restart = 30};
}

/* A failure inside the library ends all ranks; a wrong option does not. */
static bool survive(bool good, struct error *error) {
    if (!good && error->kind != ERROR_USER)
        error_fatal("%s", error->text);
    return good;
}

/* As survive, where no option can be at fault. */
static void must(bool good, const struct error *error) {
    if (!good)
        error_fatal("%s", error->text);
}

struct solve *solve_begin(const struct comm *comm, const char *options, struct error *error) {
    const struct solve_backend *backend = solve_load(error);
    if (!comm_agree(comm, error))
        return NULL;
    void *library = backend->begin(comm, options, error);
    if (!survive(library != NULL, error))
        return NULL;
    struct solve *solve = memory_allocate_zero(1, sizeof *solve, "linear solver");
    *solve = (struct solve){.backend = backend, .comm = comm, .library = library};
    return solve;
}

void solve_charge(struct solve *solve, struct timers *timers) {
    solve->timers = timers;
}

/* The total of a prefix, which is added where there is none. */
static struct solve_report *total_of(struct solve *solve, const char *prefix) {
    int k = 0;
    while (solve->total[k].prefix[0] && strcmp(solve->total[k].prefix, prefix) != 0) {
        k++;
        assert(k < SOLVE_PREFIXES_MAX);
    }
    snprintf(solve->total[k].prefix, sizeof solve->total[k].prefix, "%s", prefix);
    return &solve->total[k].report;
}

const struct solve_report *solve_total(const struct solve *solve, const char *prefix) {
    static const struct solve_report none = {.reason = "not solved yet"};
    for (int k = 0; k < SOLVE_PREFIXES_MAX; k++)
        if (strcmp(solve->total[k].prefix, prefix) == 0)
            return &solve->total[k].report;
    return &none;
}

/* Times a piece of work: the stage of that name, and the seconds of a system and of its prefix. */
static double work_begin(const struct solve *solve, const char *stage) {
    timer_enter(solve->timers, stage);
    return timer_now();
}

static double work_end(const struct solve *solve, const char *stage, double began) {
    timer_leave(solve->timers, stage);
    return timer_now() - began;
}

void solve_end(struct solve **solve, char *unused, size_t size) {
    if (*solve == NULL)
        return;
    (*solve)->backend->end((*solve)->library, unused, size);
    memory_free(*solve);
    *solve = NULL;
}

static struct solve_system *wrap(struct solve *solve, void *back, int32_t count,
                                 const struct solve_options *options, struct error *error) {
    if (!survive(back != NULL, error))
        return NULL;
    struct solve_system *system = memory_allocate_zero(1, sizeof *system, "linear system");
    system->solve = solve;
    system->back = back;
    system->count = count;
    system->tolerance = options->tolerance;
    system->reuse = options->reuse;
    system->changed = true;
    system->iterations_fresh = -1;
    system->product = memory_allocate((size_t)count, sizeof(double), "linear system");
    system->report.reason = "not solved yet";
    system->report.rows = count;
    comm_sum_int(solve->comm, &system->report.rows, 1);
    system->total = total_of(solve, options->prefix);
    system->total->reason = system->total->reason ? system->total->reason : system->report.reason;
    system->total->rows = system->report.rows;
    return system;
}

struct solve_system *solve_create(struct solve *solve, const struct solve_rows *rows,
                                  const struct solve_options *options, struct error *error) {
    double began = work_begin(solve, "assembly");
    void *back = solve->backend->create(solve->library, rows, options, error);
    double seconds = work_end(solve, "assembly", began);
    struct solve_system *system = wrap(solve, back, rows->count, options, error);
    if (system == NULL)
        return NULL;
    system->report.entries = rows->start[rows->count];
    comm_sum_int(solve->comm, &system->report.entries, 1);
    system->total->entries = system->report.entries;
    system->report.seconds_matrix += seconds;
    system->total->seconds_matrix += seconds;
    return system;
}

struct solve_system *solve_create_free(struct solve *solve, const struct solve_free *work,
                                       const struct solve_options *options, struct error *error) {
    void *back = solve->backend->create_free(solve->library, work, options, error);
    struct solve_system *system = wrap(solve, back, work->count, options, error);
    if (system != NULL)
        system->ends_otherwise = work->enough != NULL;
    return system;
}

void solve_destroy(struct solve_system **system) {
    struct solve_system *s = *system;
    if (s == NULL)
        return;
    s->solve->backend->destroy(s->back);
    memory_free(s->product);
    memory_free(s->region);
    memory_free(s->region_rows);
    memory_free(s->region_sum);
    memory_free(s);
    *system = NULL;
}

void solve_values(struct solve_system *system, const double *value) {
    struct error error = {0};
    double began = work_begin(system->solve, "assembly");
    must(system->solve->backend->values(system->back, value, &error), &error);
    double seconds = work_end(system->solve, "assembly", began);
    system->report.seconds_matrix += seconds;
    system->total->seconds_matrix += seconds;
    system->changed = true;
}

void solve_null_space(struct solve_system *system, int regions, const int32_t *region) {
    struct error error = {0};
    size_t count = (size_t)system->count;
    memory_free(system->region);
    system->region = NULL;
    system->region_rows = memory_resize(system->region_rows, (size_t)regions, sizeof(double), "regions");
    system->region_sum = memory_resize(system->region_sum, (size_t)regions, sizeof(double), "regions");
    system->regions = regions;
    memset(system->region_rows, 0, (size_t)regions * sizeof(double));
    if (region != NULL && regions > 1) {
        system->region = memory_allocate(count, sizeof *region, "regions");
        memcpy(system->region, region, count * sizeof *region);
        for (size_t i = 0; i < count; i++)
            system->region_rows[region[i]] += 1;
    } else {
        system->region_rows[0] = (double)count;
    }
    comm_sum(system->solve->comm, system->region_rows, regions);
    must(system->solve->backend->null_space(system->back, regions, system->region, system->region_rows,
                                            &error),
         &error);
}

void solve_renew(struct solve_system *system) {
    system->changed = system->stale = true;
}

void solve_tolerance(struct solve_system *system, double tolerance) {
    system->tolerance = tolerance;
}

/* Subtracts the mean over each region. */
static void subtract_means(const struct solve_system *system, double *value) {
    double *sum = system->region_sum;
    memset(sum, 0, (size_t)system->regions * sizeof *sum);
    for (int32_t i = 0; i < system->count; i++)
        sum[system->region ? system->region[i] : 0] += value[i];
    comm_sum(system->solve->comm, sum, system->regions);
    for (int r = 0; r < system->regions; r++)
        sum[r] /= fmax(system->region_rows[r], 1);
    for (int32_t i = 0; i < system->count; i++)
        value[i] -= sum[system->region ? system->region[i] : 0];
}

static double norm(const struct solve_system *system, const double *value) {
    double sum = 0;
    for (int32_t i = 0; i < system->count; i++)
        sum += value[i] * value[i];
    comm_sum(system->solve->comm, &sum, 1);
    return sqrt(sum);
}

/* Makes the preconditioner if the old one does not serve any more. */
static void set_up(struct solve_system *system) {
    if (!system->changed)
        return;
    struct solve_report *report = &system->report;
    bool slow = system->iterations_fresh >= 0 && 2 * report->iterations > 3 * system->iterations_fresh + 1;
    bool keep = report->set_ups > 0 && system->age < system->reuse && !slow && !system->stale;
    struct error error = {0};
    double began = work_begin(system->solve, "preconditioner");
    must(system->solve->backend->set_up(system->back, keep, &error), &error);
    double seconds = work_end(system->solve, "preconditioner", began);
    system->changed = system->stale = false;
    system->age = keep ? system->age + 1 : 0;
    if (!keep)
        system->iterations_fresh = -1;
    struct solve_report *const reports[2] = {report, system->total};
    for (int k = 0; k < 2; k++) {
        reports[k]->seconds_set_up += seconds;
        *(keep ? &reports[k]->kept : &reports[k]->set_ups) += 1;
    }
}

void solve_prepare(struct solve_system *system) {
    set_up(system);
}

/* The end of one solve. */
struct ending {
    struct solve_outcome outcome;
    double residual;
    int products;
    double seconds, seconds_products;
};

static void note(struct solve_system *system, const struct ending *ending) {
    double doubt = system->ends_otherwise ? 0 : ending->residual / system->tolerance;
    struct solve_report *const reports[2] = {&system->report, system->total};
    for (int k = 0; k < 2; k++) {
        struct solve_report *report = reports[k];
        report->iterations = ending->outcome.iterations;
        report->converged = ending->outcome.converged;
        report->reason = ending->outcome.reason;
        report->solves++;
        report->iterations_all += ending->outcome.iterations;
        report->residual = ending->residual;
        report->tolerance = system->tolerance;
        report->residual_worst = fmax(report->residual_worst, ending->residual);
        report->doubt = fmax(report->doubt, doubt);
        report->doubtful += !(doubt <= SOLVE_DOUBT); /* NaN is doubtful */
        report->products += ending->products;
        report->seconds_solve += ending->seconds;
        report->seconds_products += ending->seconds_products;
    }
    if (system->iterations_fresh < 0)
        system->iterations_fresh = ending->outcome.iterations;
}

/* |b - A x|. */
static double residual_of(struct solve_system *system, const double *b, const double *x,
                          struct ending *ending) {
    double before = timer_now();
    solve_multiply(system, x, system->product);
    ending->seconds_products = timer_now() - before;
    ending->products = 1;
    for (int32_t i = 0; i < system->count; i++)
        system->product[i] = b[i] - system->product[i];
    return norm(system, system->product);
}

bool solve_solve(struct solve_system *system, double *b, double *x, bool guess) {
    struct error error = {0};
    struct ending ending = {.outcome = {.converged = true, .reason = "right-hand side of zero"}};
    set_up(system);
    double began = work_begin(system->solve, "solve");
    if (system->regions > 0)
        subtract_means(system, b);
    double size = norm(system, b);
    if (size == 0) {
        memset(x, 0, (size_t)system->count * sizeof *x);
    } else {
        must(system->solve->backend->solve(system->back, b, x, guess, system->tolerance, &ending.outcome,
                                           &error),
             &error);
        ending.residual = residual_of(system, b, x, &ending) / size;
        if (system->regions > 0)
            subtract_means(system, x);
    }
    ending.seconds = work_end(system->solve, "solve", began);
    note(system, &ending);
    return ending.outcome.converged;
}

void solve_multiply(struct solve_system *system, const double *x, double *y) {
    struct error error = {0};
    must(system->solve->backend->multiply(system->back, x, y, &error), &error);
}

void solve_cycle(struct solve_system *system, const double *r, double *z) {
    struct error error = {0};
    set_up(system);
    must(system->solve->backend->cycle(system->back, r, z, &error), &error);
}

const struct solve_report *solve_report(const struct solve_system *system) {
    return &system->report;
}
