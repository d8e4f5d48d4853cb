/* SPDX-License-Identifier: BSD-3-Clause */
/* Writes docs/scene.md: `make pages` runs it */
#include "data/scene/schema_help.h"

int main(void) {
    scene_document(stdout);
    return fflush(stdout) != 0;
}
