/* SPDX-License-Identifier: BSD-3-Clause */
/* What this binary is, for the report and for every file that it writes. */
#ifndef SCREE_CORE_VERSION_H
#define SCREE_CORE_VERSION_H

#include <stddef.h>

/* The version of the release ("0.1.0"). Static text, as all of these. */
const char *version_number(void);

/* The git revision it was built from: twelve digits, with "-modified" where the tree differed from the
 * commit; "unknown" where there was no git. */
const char *version_revision(void);

/* Compiler with version, and the flags given to it. */
const char *version_compiler(void);
const char *version_flags(void);

/* Writes the name of this machine to `name` (`size` bytes, always ended by a zero; "unknown" on failure). */
void version_host(char *name, size_t size);

/* Writes the CPU's model name likewise ("unknown" where the system does not tell). */
void version_cpu(char *name, size_t size);

#endif
