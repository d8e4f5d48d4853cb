/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes the tables of a page again: make src/observe/document && src/observe/document <docs/output.md >new */
#include "observe/describe.h"

int main(void) {
    struct error error = {0};
    if (!describe_page(stdin, stdout, &error))
        fprintf(stderr, "%s\n", error.text);
    return fflush(stdout) != 0 || error.kind != ERROR_NONE;
}
