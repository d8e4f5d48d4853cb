/* SPDX-License-Identifier: BSD-3-Clause */
/* Version, revision, compiler, flags, host and processor of this binary. Read version.h first. */
#include "base/version.h"

#include "config.h"
#include "base/revision.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

const char *version_number(void) {
    return PACKAGE_VERSION;
}

const char *version_revision(void) {
    return SCREE_REVISION;
}

const char *version_compiler(void) {
#ifdef __clang__
    return __VERSION__; /* the text contains the compiler's name */
#else
    return "gcc " __VERSION__;
#endif
}

const char *version_flags(void) {
    return SCREE_FLAGS;
}

void version_host(char *name, size_t size) {
    if (gethostname(name, size) != 0) {
        snprintf(name, size, "unknown");
    }
    name[size - 1] = '\0';
}

void version_cpu(char *name, size_t size) {
    snprintf(name, size, "unknown");
    FILE *file = fopen("/proc/cpuinfo", "r");
    if (file == NULL) {
        return;
    }
    char line[512];
    while (fgets(line, sizeof line, file) != NULL) {
        char *value = strchr(line, ':');
        if (strncmp(line, "model name", 10) == 0 && value != NULL) {
            line[strcspn(line, "\n")] = '\0';
            snprintf(name, size, "%s", value + 1 + strspn(value + 1, " \t"));
            break;
        }
    }
    fclose(file);
}
