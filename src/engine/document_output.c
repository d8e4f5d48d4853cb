/* SPDX-License-Identifier: BSD-3-Clause */
/* Makes the tables of docs/output.md again, from the page to the page: `make pages` runs it */
#include "engine/run_report.h"
#include "engine/stages.h"
#include "data/observe/describe.h"

int main(void) {
    struct error error = {0};
    struct timers stages = {0};
    const struct describe_from from = {run_report_rows, &stages};
    stages_register_all(&stages);
    if (!describe_page(stdin, stdout, &from, &error))
        fprintf(stderr, "%s\n", error.text);
    return fflush(stdout) != 0 || error.kind != ERROR_NONE;
}
