/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes the tables of a page again: make src/engine/document && src/engine/document <docs/output.md >new */
#include "engine/grains.h"
#include "engine/stages.h"
#include "observe/describe.h"

int main(void) {
    struct error error = {0};
    struct timers stages = {0};
    stages_register_all(&stages, &grains_physics);
    if (!describe_page(stdin, stdout, &stages, &error))
        fprintf(stderr, "%s\n", error.text);
    return fflush(stdout) != 0 || error.kind != ERROR_NONE;
}
