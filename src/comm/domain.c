#include "comm/domain.h"

#include "core/memory.h"

#include <assert.h>
#include <math.h>

/* Rank (i, j, k) of the grid is number i + grid[0] (j + grid[1] k). */
struct domain {
    int rank, size;
    int grid[3];
    double edge[3];
    bool periodic[3], wrapped[3];
    double *cut[3]; /* grid[d] + 1 faces of the subdomains in direction d, from 0 to the edge */
};

/* How good a grid is: the area along which it cuts the box, then the thinnest part that a cut leaves. */
struct grid_price {
    double area, thinnest;
};

static struct grid_price price_of(const int grid[3], const struct box *box) {
    struct grid_price price = {0, INFINITY};
    for (int d = 0; d < 3; d++) {
        if (grid[d] == 1)
            continue;
        int faces = box->periodic[d] ? grid[d] : grid[d] - 1;
        price.area += faces * box->edge[(d + 1) % 3] * box->edge[(d + 2) % 3];
        price.thinnest = fmin(price.thinnest, box->edge[d] / grid[d]);
    }
    return price;
}

static bool price_better(struct grid_price a, struct grid_price b) {
    const double equal = 1e-12;
    if (fabs(a.area - b.area) > equal * b.area)
        return a.area < b.area;
    return a.thinnest > b.thinnest * (1 + equal);
}

static bool grid_allowed(const int grid[3], const struct box *box, const struct domain_options *options) {
    for (int d = 0; d < 3; d++)
        if (options->grid[d] != 0 && options->grid[d] != grid[d])
            return false;
    return box->dimension == 3 || grid[2] == 1;
}

/* Tries all ways to write `size` as a product of three. Larger numbers first in x: with gravity along z the
 * columns are filled alike. */
static bool grid_choose(int size, const struct box *box, const struct domain_options *options, int best[3]) {
    struct grid_price least = {INFINITY, 0};
    bool found = false;
    for (int a = size; a >= 1; a--) {
        if (size % a != 0)
            continue;
        for (int b = size / a; b >= 1; b--) {
            int grid[3] = {a, b, size / a / b};
            if (size / a % b != 0 || !grid_allowed(grid, box, options))
                continue;
            struct grid_price price = price_of(grid, box);
            if (found && !price_better(price, least))
                continue;
            least = price;
            found = true;
            for (int d = 0; d < 3; d++)
                best[d] = grid[d];
        }
    }
    return found;
}

static bool grid_refuse(int size, const struct box *box, const struct domain_options *options,
                        struct error *error) {
    const int *grid = options->grid;
    if (box->dimension == 2 && grid[2] > 1)
        return error_set(error, ERROR_USER,
                         "domain grid %d x %d x %d: a 2D box is not divided in z; allowed there are 0 and 1",
                         grid[0], grid[1], grid[2]);
    return error_set(error, ERROR_USER,
                     "domain grid %d x %d x %d does not fit %d rank%s: the product must be the number of "
                     "ranks; 0 leaves a direction to the program",
                     grid[0], grid[1], grid[2], size, size == 1 ? "" : "s");
}

struct domain *domain_create(const struct comm *comm, const struct box *box,
                             const struct domain_options *options, struct error *error) {
    int grid[3];
    if (!grid_choose(comm->size, box, options, grid)) {
        grid_refuse(comm->size, box, options, error);
        return NULL;
    }
    struct domain *domain = memory_allocate_zero(1, sizeof *domain, "domain");
    domain->rank = comm->rank;
    domain->size = comm->size;
    for (int d = 0; d < 3; d++) {
        int n = grid[d];
        domain->grid[d] = n;
        domain->edge[d] = box->edge[d];
        domain->periodic[d] = box->periodic[d];
        domain->wrapped[d] = box->periodic[d] && n == 1;
        domain->cut[d] = memory_allocate((size_t)n + 1, sizeof(double), "domain faces");
        for (int i = 0; i < n; i++)
            domain->cut[d][i] = box->edge[d] * i / n;
        domain->cut[d][n] = box->edge[d];
    }
    return domain;
}

void domain_destroy(struct domain **domain) {
    if (*domain == NULL)
        return;
    for (int d = 0; d < 3; d++)
        memory_free((*domain)->cut[d]);
    memory_free(*domain);
    *domain = NULL;
}

/* The slab that holds a coordinate: the first guess may be off by rounding, the faces decide. */
static int slab_of(const struct domain *domain, int d, double x) {
    int n = domain->grid[d];
    const double *cut = domain->cut[d];
    if (n == 1 || !(x >= cut[1]))
        return 0;
    if (x >= cut[n - 1])
        return n - 1;
    int i = (int)(x * n / domain->edge[d]);
    while (x < cut[i])
        i--;
    while (x >= cut[i + 1])
        i++;
    return i;
}

static int rank_of(const struct domain *domain, const int slab[3]) {
    return slab[0] + domain->grid[0] * (slab[1] + domain->grid[1] * slab[2]);
}

int domain_owner(const struct domain *domain, const double x[3]) {
    int slab[3];
    for (int d = 0; d < 3; d++)
        slab[d] = slab_of(domain, d, x[d]);
    return rank_of(domain, slab);
}

static double slab_lower(const struct domain *domain, int d, int i) {
    return i == 0 && !domain->periodic[d] ? -INFINITY : domain->cut[d][i];
}

static double slab_upper(const struct domain *domain, int d, int i) {
    return i == domain->grid[d] - 1 && !domain->periodic[d] ? INFINITY : domain->cut[d][i + 1];
}

void domain_bounds(const struct domain *domain, int rank, double lower[3], double upper[3]) {
    assert(rank >= 0 && rank < domain->size);
    int slab[3] = {rank % domain->grid[0], rank / domain->grid[0] % domain->grid[1],
                   rank / domain->grid[0] / domain->grid[1]};
    for (int d = 0; d < 3; d++) {
        lower[d] = slab_lower(domain, d, slab[d]);
        upper[d] = slab_upper(domain, d, slab[d]);
    }
}

/* A search for the subdomains that a ball touches. */
struct touching {
    const struct domain *domain;
    const double *x;
    double radius;
    struct domain_touch *touch;
    int room, found;
    int slab[3]; /* where the search stands */
    signed char image[3];
};

static void touching_put(struct touching *search) {
    if (search->found < search->room) {
        struct domain_touch *touch = &search->touch[search->found];
        touch->rank = rank_of(search->domain, search->slab);
        for (int d = 0; d < 3; d++)
            touch->image[d] = search->image[d];
    }
    search->found++;
}

static void touching_axis(struct touching *search, int d, double squared);

/* The slabs of direction d near one image of the ball. Distances are formed exactly as those of pairs are
 * (x + shift first, squares added in the order x, y, z), so that rounding never makes a subdomain look
 * farther away than a particle in it. */
static void touching_slabs(struct touching *search, int d, int image, double squared) {
    const struct domain *domain = search->domain;
    double y = search->x[d] + image * domain->edge[d];
    int first = slab_of(domain, d, y - search->radius), last = slab_of(domain, d, y + search->radius);
    if (first > 0)
        first--; /* y - radius may have been rounded over a face */
    if (last < domain->grid[d] - 1)
        last++;
    search->image[d] = (signed char)image;
    for (int i = first; i <= last; i++) {
        double distance = fmax(0, fmax(slab_lower(domain, d, i) - y, y - slab_upper(domain, d, i)));
        double sum = squared + distance * distance;
        search->slab[d] = i;
        if (sum <= search->radius * search->radius)
            touching_axis(search, d + 1, sum);
    }
}

static void touching_axis(struct touching *search, int d, double squared) {
    if (d == 3) {
        touching_put(search);
        return;
    }
    if (search->domain->wrapped[d]) {
        search->slab[d] = 0;
        search->image[d] = 0;
        touching_axis(search, d + 1, squared);
        return;
    }
    int images = search->domain->periodic[d] ? 1 : 0;
    for (int image = -images; image <= images; image++)
        touching_slabs(search, d, image, squared);
}

int domain_touching(const struct domain *domain, const double x[3], double radius, struct domain_touch *touch,
                    int room) {
    struct touching search = {.domain = domain, .x = x, .radius = radius, .touch = touch, .room = room};
    touching_axis(&search, 0, 0);
    return search.found;
}

void domain_wrap(const struct domain *domain, bool wrap[3]) {
    for (int d = 0; d < 3; d++)
        wrap[d] = domain->wrapped[d];
}

void domain_grid(const struct domain *domain, int grid[3]) {
    for (int d = 0; d < 3; d++)
        grid[d] = domain->grid[d];
}
