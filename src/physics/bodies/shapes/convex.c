/* SPDX-License-Identifier: BSD-3-Clause */
/* Calls Qhull for the corners of a convex hull. Read convex.h first. */
#include "physics/bodies/shapes/convex.h"
#include "base/memory.h"
#include <libqhull_r/qhull_ra.h>
#include <stdio.h>
#include <string.h>

static int compare(const void *a, const void *b) {
    const int *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

/* The vertices of a hull that Qhull has made. */
static size_t corners_take(qhT *qh, int *corner) {
    size_t count = 0;
    for (vertexT *vertex = qh->vertex_list; vertex && vertex->next; vertex = vertex->next)
        corner[count++] = qh_pointid(qh, vertex->point);
    qsort(corner, count, sizeof *corner, compare);
    return count;
}

size_t convex_corners(const double (*point)[3], size_t points, int *corner) {
    char options[] = "qhull Pp";
    size_t count = 0;
    int rest, blocks;
    if (points < 4)
        return 0;
    FILE *nowhere = fopen("/dev/null", "w");
    double(*copy)[3] = memory_allocate(points, sizeof *copy, "points of a hull");
    memcpy(copy, point, points * sizeof *copy);
    qhT qh;
    qh_zero(&qh, nowhere ? nowhere : stderr);
    if (qh_new_qhull(&qh, 3, (int)points, copy[0], False, options, nowhere, nowhere) == 0)
        count = corners_take(&qh, corner);
    qh_freeqhull(&qh, !qh_ALL);
    qh_memfreeshort(&qh, &rest, &blocks);
    memory_free(copy);
    if (nowhere)
        fclose(nowhere);
    return count;
}
