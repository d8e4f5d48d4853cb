/* SPDX-License-Identifier: BSD-3-Clause */
/* Shifts of the images of the box. Read box.h first. */
#include "particles/box.h"

void box_image_shifts(const struct box *box, double shift[IMAGE_CODES][4]) {
    for (int sz = -1; sz <= 1; sz++)
        for (int sy = -1; sy <= 1; sy++)
            for (int sx = -1; sx <= 1; sx++) {
                double *row = shift[image_code(sx, sy, sz)];
                row[0] = sx * box->edge[0];
                row[1] = sy * box->edge[1];
                row[2] = sz * box->edge[2];
                row[3] = 0;
            }
}
