/* Makes the spheres of the bidisperse benchmark: a periodic cube with LARGE spheres of radius RATIO and SMALL
 * of radius 1, none inside another, as a LAMMPS data file on standard output.
 *
 *     bidisperse_pack RATIO EDGE LARGE SMALL [SEED]
 *
 * The large ones are placed at random without overlap, the small ones at random outside the large. Then small
 * ones that overlap are pushed apart, each pair until it just touches, over and over until hardly anything
 * overlaps: a random packing in which neighbours touch and nothing is pressed. Large spheres stay. Velocities
 * are normal with sigma 1 in each component; spins are zero. The random numbers are those of SplitMix64
 * (Steele, Lea and Flood 2014), so a file depends on the arguments alone. */
#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double OVERLAP_MEAN = 1e-5; /* where relaxation ends: mean overlap a contact ... */
static const double OVERLAP_MAX = 0.02;  /* ... and the largest; radius of the small: 1 */
enum { SWEEPS_MAX = 2000, TRIES_MAX = 1000000 };

struct packing {
    double edge, ratio;
    long large, small;
    double (*boulder)[3]; /* centres of the large ones */
    double (*x)[3];       /* centres of the small ones */
    uint64_t random;      /* state of the generator */
};

struct cells {
    long side;   /* cells along an edge */
    double size; /* of a cell, >= 2 */
    long *first; /* cell c holds item[first[c]] ... item[first[c + 1] - 1] */
    long *item;
    long *of; /* cell of each small sphere */
};

/* What a sweep met. */
struct sweep {
    long contacts;
    double sum, max;
};

static void *allocate(size_t count, size_t size) {
    void *memory = calloc(count ? count : 1, size);
    if (!memory) {
        fprintf(stderr, "bidisperse_pack: no memory for %zu times %zu bytes\n", count, size);
        exit(1);
    }
    return memory;
}

static double uniform(struct packing *packing) {
    uint64_t z = (packing->random += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return ((double)(z >> 11) + 0.5) * 0x1p-53;
}

/* Box and Muller. */
static double normal(struct packing *packing) {
    double radius = sqrt(-2 * log(uniform(packing)));
    return radius * cos(2 * M_PI * uniform(packing));
}

static double nearest(double d, double edge) {
    return d - edge * rint(d / edge);
}

/* Vector from b to a, nearest image; returns its square. */
static double separation(const struct packing *packing, const double a[3], const double b[3], double d[3]) {
    double square = 0;
    for (int k = 0; k < 3; k++) {
        d[k] = nearest(a[k] - b[k], packing->edge);
        square += d[k] * d[k];
    }
    return square;
}

/* A random point farther than `distance` from the first `count` large spheres. */
static void place(struct packing *packing, double x[3], long count, double distance) {
    for (int attempt = 0; attempt < TRIES_MAX; attempt++) {
        double d[3];
        long free = 0;
        for (int k = 0; k < 3; k++)
            x[k] = packing->edge * uniform(packing);
        while (free < count && separation(packing, x, packing->boulder[free], d) > distance * distance)
            free++;
        if (free == count)
            return;
    }
    fprintf(stderr, "bidisperse_pack: the large spheres leave no room in a cube of edge %g\n", packing->edge);
    exit(2);
}

static void wrap(double x[3], double edge) {
    for (int k = 0; k < 3; k++) {
        x[k] -= edge * floor(x[k] / edge);
        if (x[k] >= edge)
            x[k] = 0;
    }
}

/* Counting sort of the small spheres into cells. */
static void cells_fill(struct cells *cells, struct packing *packing) {
    long count = cells->side * cells->side * cells->side;
    memset(cells->first, 0, (size_t)(count + 1) * sizeof *cells->first);
    for (long i = 0; i < packing->small; i++) {
        long at[3];
        wrap(packing->x[i], packing->edge);
        for (int k = 0; k < 3; k++) {
            at[k] = (long)(packing->x[i][k] / cells->size);
            at[k] = at[k] < cells->side ? at[k] : cells->side - 1;
        }
        cells->of[i] = at[0] + cells->side * (at[1] + cells->side * at[2]);
        cells->first[cells->of[i] + 1]++;
    }
    for (long c = 0; c < count; c++)
        cells->first[c + 1] += cells->first[c];
    for (long i = packing->small - 1; i >= 0; i--)
        cells->item[--cells->first[cells->of[i] + 1]] = i;
    /* Each entry first[c + 1] now points to the start of cell c: move them down. */
    memmove(cells->first, cells->first + 1, (size_t)count * sizeof *cells->first);
    cells->first[count] = packing->small;
}

/* Pushes a, and with `both` b, out of each other if they overlap. */
static void push(const struct packing *packing, double a[3], double b[3], double touch, struct sweep *sweep) {
    double d[3], square = separation(packing, a, b, d);
    if (square >= touch * touch || square == 0)
        return;
    double distance = sqrt(square), overlap = touch - distance;
    double share = touch > 2 ? 1 : 0.5; /* a large sphere stays where it is */
    sweep->contacts++;
    sweep->sum += overlap;
    sweep->max = overlap > sweep->max ? overlap : sweep->max;
    for (int k = 0; k < 3; k++) {
        a[k] += share * overlap * d[k] / distance;
        if (share < 1)
            b[k] -= share * overlap * d[k] / distance;
    }
}

static void push_cells(struct packing *packing, const struct cells *cells, long c, long d,
                       struct sweep *sweep) {
    for (long a = cells->first[c]; a < cells->first[c + 1]; a++)
        for (long b = c == d ? a + 1 : cells->first[d]; b < cells->first[d + 1]; b++)
            push(packing, packing->x[cells->item[a]], packing->x[cells->item[b]], 2, sweep);
}

/* All pairs of small spheres once: each cell with itself and 13 of its neighbours. */
static void sweep_small(struct packing *packing, const struct cells *cells, struct sweep *sweep) {
    long side = cells->side;
    for (long c = 0; c < side * side * side; c++) {
        long at[3] = {c % side, c / side % side, c / side / side};
        push_cells(packing, cells, c, c, sweep);
        for (int n = 14; n < 27; n++) {
            long x = (at[0] + n % 3 - 1 + side) % side;
            long y = (at[1] + n / 3 % 3 - 1 + side) % side;
            long z = (at[2] + n / 9 - 1 + side) % side;
            push_cells(packing, cells, c, x + side * (y + side * z), sweep);
        }
    }
}

/* The small spheres near one large one: its cells, with room for half a cell's move since the last sort. */
static void sweep_large(struct packing *packing, const struct cells *cells, double large[3],
                        struct sweep *sweep) {
    double touch = packing->ratio + 1;
    long reach = (long)(touch / cells->size) + 2, side = cells->side, base[3];
    if (2 * reach + 1 > side)
        reach = (side - 1) / 2; /* all cells once, but for the farthest layer of an even number */
    for (int k = 0; k < 3; k++)
        base[k] = (long)(large[k] / cells->size);
    for (long dz = -reach; dz <= reach; dz++)
        for (long dy = -reach; dy <= reach; dy++)
            for (long dx = -reach; dx <= reach; dx++) {
                long x = (base[0] + dx + 2 * side) % side, y = (base[1] + dy + 2 * side) % side;
                long z = (base[2] + dz + 2 * side) % side, c = x + side * (y + side * z);
                for (long k = cells->first[c]; k < cells->first[c + 1]; k++)
                    push(packing, packing->x[cells->item[k]], large, touch, sweep);
            }
}

static void relax(struct packing *packing) {
    struct cells cells = {.side = (long)(packing->edge / 2.1)};
    long count = cells.side * cells.side * cells.side;
    if (cells.side < 3 || packing->edge < 2 * (packing->ratio + 1) + 8) {
        fprintf(stderr, "bidisperse_pack: the cube is too small for spheres of radius %g\n", packing->ratio);
        exit(2);
    }
    cells.size = packing->edge / (double)cells.side;
    cells.first = allocate((size_t)count + 1, sizeof *cells.first);
    cells.item = allocate((size_t)packing->small, sizeof *cells.item);
    cells.of = allocate((size_t)packing->small, sizeof *cells.of);
    for (int k = 0; k < SWEEPS_MAX; k++) {
        struct sweep sweep = {0, 0, 0};
        cells_fill(&cells, packing);
        for (long b = 0; b < packing->large; b++)
            sweep_large(packing, &cells, packing->boulder[b], &sweep);
        sweep_small(packing, &cells, &sweep);
        if (sweep.max < OVERLAP_MAX && sweep.sum < OVERLAP_MEAN * (double)packing->small) {
            fprintf(stderr, "bidisperse_pack: %d sweeps, %ld contacts, mean overlap %.3g, largest %.3g\n",
                    k + 1, sweep.contacts, sweep.sum / (double)(sweep.contacts ? sweep.contacts : 1),
                    sweep.max);
            break;
        }
        if (k == SWEEPS_MAX - 1) {
            fprintf(stderr, "bidisperse_pack: still overlapping after %d sweeps: too dense\n", SWEEPS_MAX);
            exit(2);
        }
    }
    free(cells.first);
    free(cells.item);
    free(cells.of);
}

static void write_data(struct packing *packing) {
    long count = packing->large + packing->small;
    printf("bidisperse spheres, radius 1 and %g, periodic cube, units lj\n\n%ld atoms\n2 atom types\n\n",
           packing->ratio, count);
    printf("0 %.15g xlo xhi\n0 %.15g ylo yhi\n0 %.15g zlo zhi\n\nAtoms # sphere\n\n", packing->edge,
           packing->edge, packing->edge);
    for (long i = 0; i < count; i++) {
        int is_large = i < packing->large;
        double *x = is_large ? packing->boulder[i] : packing->x[i - packing->large];
        printf("%ld %d %g 1 %.12g %.12g %.12g\n", i + 1, 1 + is_large, is_large ? 2 * packing->ratio : 2,
               x[0], x[1], x[2]);
    }
    printf("\nVelocities\n\n");
    for (long i = 0; i < count; i++) {
        double v[3] = {normal(packing), normal(packing), normal(packing)};
        printf("%ld %.9g %.9g %.9g 0 0 0\n", i + 1, v[0], v[1], v[2]);
    }
}

int main(int argc, char **argv) {
    struct packing packing = {0};
    if (argc < 5 || argc > 6) {
        fprintf(stderr, "usage: bidisperse_pack RATIO EDGE LARGE SMALL [SEED]\n");
        return 2;
    }
    packing.ratio = atof(argv[1]);
    packing.edge = atof(argv[2]);
    packing.large = atol(argv[3]);
    packing.small = atol(argv[4]);
    packing.random = argc > 5 ? (uint64_t)atoll(argv[5]) : 1;
    if (packing.ratio <= 1 || packing.edge <= 0 || packing.large < 0 || packing.small < 1) {
        fprintf(stderr, "bidisperse_pack: RATIO above 1, EDGE above 0, LARGE at least 0, SMALL at least 1\n");
        return 2;
    }
    packing.boulder = allocate((size_t)packing.large, sizeof *packing.boulder);
    packing.x = allocate((size_t)packing.small, sizeof *packing.x);
    for (long i = 0; i < packing.large; i++)
        place(&packing, packing.boulder[i], i, 2 * packing.ratio);
    for (long i = 0; i < packing.small; i++)
        place(&packing, packing.x[i], packing.large, packing.ratio + 1);
    relax(&packing);
    write_data(&packing);
    free(packing.boulder);
    free(packing.x);
    if (fflush(stdout) || ferror(stdout)) {
        fprintf(stderr, "bidisperse_pack: %s\n", strerror(errno));
        return 1;
    }
    return 0;
}
