/* SPDX-License-Identifier: BSD-3-Clause */
/* Collects failures; all ranks agree on the failures. Read team.h first. */
#include "tests/test.h"

#include "team.h"

#include "base/memory.h"

#include <stdio.h>
#include <stdlib.h>

void team_start(struct team *team, int *argc, char ***argv) {
    *team = (struct team){0};
    comm_start(&team->comm, argc, argv);
    if (team->comm.rank > 0 && freopen("/dev/null", "w", stdout) == NULL)
        error_fatal("cannot open /dev/null");
}

int team_stop(struct team *team) {
    comm_stop(&team->comm);
    size_t held = memory_in_use();
    if (held > 0)
        fprintf(stderr, "rank %d still holds %zu bytes\n", team->comm.rank, held);
    return held > 0;
}

bool team_note(struct team *team, bool good, const char *file, int line, const char *format, ...) {
    if (good)
        return true;
    char text[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    error_set(&team->error, ERROR_SYSTEM, "%s:%d: rank %d of %d: %s", file, line, team->comm.rank,
              team->comm.size, text);
    return false;
}

void team_skip(const struct team *team, const char *why) {
    print_message("skipped on %d ranks: %s\n", team->comm.size, why);
    skip();
    abort();
}

void team_finish(struct team *team) {
    bool good = comm_agree(&team->comm, &team->error);
    struct error error = team->error;
    team->error = (struct error){0};
    if (!good)
        fail_msg("%s", error.text);
}
