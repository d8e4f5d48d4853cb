/* SPDX-License-Identifier: BSD-3-Clause */
/* Image codes: which periodic image of a particle is meant. An image is a vector of {-1, 0, 1}^3, in edges of
 * the box; its code has 5 bits, 0 is no shift, and the code of the opposite vector is (27 - code) % 27. */
#ifndef SCREE_BASE_IMAGE_H
#define SCREE_BASE_IMAGE_H

enum { IMAGE_CODES = 27 };

/* The code of the image vector (sx, sy, sz), each -1, 0 or 1. */
static inline unsigned image_code(int sx, int sy, int sz) {
    return (unsigned)((sx + 1) + 3 * (sy + 1) + 9 * (sz + 1) + 14) % 27u;
}

/* The code of the opposite image. */
static inline unsigned image_opposite(unsigned code) {
    return (27u - code) % 27u;
}

/* The place, 0 ... 26, that an image has where images are sorted by z, then y, then x. */
static inline unsigned image_place(unsigned code) {
    return (code + 13) % 27u;
}

/* The image vector of a code. */
static inline void image_vector(unsigned code, int image[3]) {
    int place = (int)image_place(code);
    image[0] = place % 3 - 1;
    image[1] = place / 3 % 3 - 1;
    image[2] = place / 9 - 1;
}

#endif
