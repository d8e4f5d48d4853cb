/* SPDX-License-Identifier: BSD-3-Clause */
/* Solves contact problems that a run has written (output.contact_problems) by Siconos, and compares velocities: oracle BOUND FILE...
 *
 * The solver is nonsmooth Gauss and Seidel at 1e-10, on the problem in units of its own largest velocity. Compared are the
 * velocities of the contacts, over g dt. Impulses are shown, and not judged: with rigid contacts they are not unique.
 * A line a file; exit status 1 if a velocity is off by more than BOUND, 2 if Siconos does not converge. */
#include <hdf5.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <FrictionContactProblem.h>
#include <Friction_cst.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <NumericsSparseMatrix.h>
#include <SolverOptions.h>

static void give_up(const char *path, const char *text) {
    fprintf(stderr, "oracle: %s: %s\n", path, text);
    exit(2);
}

/* A dataset as numbers of a type; free. */
static void *read_all(hid_t file, const char *path, const char *name, hid_t type, size_t *count) {
    hid_t data = H5Dopen2(file, name, H5P_DEFAULT), space = data < 0 ? -1 : H5Dget_space(data);
    hssize_t points = space < 0 ? -1 : H5Sget_simple_extent_npoints(space);
    void *value = points < 0 ? NULL : malloc((size_t)points * 8 + 8);
    if (value == NULL || H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, value) < 0)
        give_up(path, name);
    *count = (size_t)points;
    H5Sclose(space);
    H5Dclose(data);
    return value;
}

static double read_attribute(hid_t file, const char *path, const char *name) {
    double value;
    hid_t attribute = H5Aopen_by_name(file, "/scree", name, H5P_DEFAULT, H5P_DEFAULT);
    if (attribute < 0 || H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0)
        give_up(path, name);
    H5Aclose(attribute);
    return value;
}

struct problem {
    size_t contacts, entries;
    int *start, *row;
    double *value, *q, *mu, *r, *soft, *shift, fall; /* fall: g dt */
};

static struct problem problem_read(const char *path) {
    struct problem p;
    size_t count;
    hid_t file = H5Fopen(path, H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file < 0)
        give_up(path, "cannot be opened");
    p.start = read_all(file, path, "/fclib_local/W/p", H5T_NATIVE_INT, &count);
    p.row = read_all(file, path, "/fclib_local/W/i", H5T_NATIVE_INT, &count);
    p.value = read_all(file, path, "/fclib_local/W/x", H5T_NATIVE_DOUBLE, &p.entries);
    p.mu = read_all(file, path, "/fclib_local/vectors/mu", H5T_NATIVE_DOUBLE, &p.contacts);
    p.q = read_all(file, path, "/fclib_local/vectors/q", H5T_NATIVE_DOUBLE, &count);
    p.r = read_all(file, path, "/solution/r", H5T_NATIVE_DOUBLE, &count);
    p.soft = read_all(file, path, "/scree/soft", H5T_NATIVE_DOUBLE, &count);
    p.shift = read_all(file, path, "/scree/shift", H5T_NATIVE_DOUBLE, &count);
    p.fall = read_attribute(file, path, "gravity") * read_attribute(file, path, "dt");
    H5Fclose(file);
    return p;
}

static void problem_free(struct problem *p) {
    void *array[] = {p->start, p->row, p->value, p->mu, p->q, p->r, p->soft, p->shift};
    for (size_t k = 0; k < sizeof array / sizeof array[0]; k++)
        free(array[k]);
}

/* Velocities of the contacts by impulses r: W r + q without springs. */
static double *velocities(const struct problem *p, const double *r) {
    double *u = malloc(3 * p->contacts * sizeof *u);
    for (size_t k = 0; k < 3 * p->contacts; k++)
        u[k] = p->q[k] - p->shift[k] - p->soft[k] * r[k];
    for (size_t column = 0; column < 3 * p->contacts; column++)
        for (int k = p->start[column]; k < p->start[column + 1]; k++)
            u[p->row[k]] += p->value[k] * r[column];
    return u;
}

/* The impulses that Siconos finds; free. */
static double *solve(const struct problem *p, const char *path, int *sweeps) {
    int size = (int)(3 * p->contacts);
    double speed = 0, mobility = INFINITY, *q = malloc((size_t)size * sizeof *q),
           *r = calloc((size_t)size, sizeof *r), *u = calloc((size_t)size, sizeof *u);
    NumericsMatrix *w = NM_create(NM_SPARSE, size, size);
    for (int k = 0; k < size; k++)
        speed = fmax(speed, fabs(p->q[k]));
    for (int column = 0; column < size; column++) /* of the stiffest contact */
        for (int k = p->start[column]; k < p->start[column + 1]; k++)
            if (p->row[k] == column)
                mobility = fmin(mobility, p->value[k]);
    NM_triplet_alloc(w, (CS_INT)p->entries);
    for (int column = 0; column < size; column++) {
        q[column] = p->q[column] / speed;
        for (int k = p->start[column]; k < p->start[column + 1]; k++)
            NM_entry(w, p->row[k], column, p->value[k] / mobility);
    }
    FrictionContactProblem *problem = frictionContactProblem_new_with_data(3, (int)p->contacts, w, q, p->mu);
    SolverOptions *options = solver_options_create(SICONOS_FRICTION_3D_NSGS);
    options->dparam[SICONOS_DPARAM_TOL] = 1e-10;
    options->iparam[SICONOS_IPARAM_MAX_ITER] = 1000000;
    if (fc3d_driver(problem, r, u, options) != 0)
        give_up(path, "Siconos does not converge");
    *sweeps = options->iparam[SICONOS_IPARAM_ITER_DONE];
    for (int k = 0; k < size; k++)
        r[k] *= speed / mobility;
    solver_options_delete(options);
    NM_clear(w);
    free(w);
    free(problem);
    free(q);
    free(u);
    return r;
}

/* Returns by how much a velocity is off, over g dt. */
static double compare(const char *path) {
    struct problem p = problem_read(path);
    int sweeps;
    double *other = solve(&p, path, &sweeps), *here_u = velocities(&p, p.r), *other_u = velocities(&p, other),
           off = 0, apart = 0, most = 0;
    for (size_t k = 0; k < 3 * p.contacts; k++) {
        off = fmax(off, fabs(here_u[k] - other_u[k]));
        apart = fmax(apart, fabs(p.r[k] - other[k]));
        most = fmax(most, fabs(p.r[k]));
    }
    off /= p.fall;
    printf("%s: %zu contacts, %d sweeps of Siconos, velocities differ by %.2g g dt, impulses by %.2g of the "
           "largest\n",
           path, p.contacts, sweeps, off, apart / most);
    free(other);
    free(here_u);
    free(other_u);
    problem_free(&p);
    return off;
}

int main(int argc, char **argv) {
    int bad = argc < 3;
    if (bad)
        fprintf(stderr, "use: oracle BOUND FILE...\n");
    for (int k = 2; k < argc; k++)
        bad |= !(compare(argv[k]) <= atof(argv[1]));
    return bad;
}
