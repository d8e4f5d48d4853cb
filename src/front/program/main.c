/* SPDX-License-Identifier: BSD-3-Clause */
/* The program is a call of the library. */
#include "scree.h"

int main(int argc, char **argv) {
    return scree_main(argc, argv);
}
