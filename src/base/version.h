/* SPDX-License-Identifier: BSD-3-Clause */
/* The identity of this binary, for the report and for every file that the program writes. */
#ifndef SCREE_BASE_VERSION_H
#define SCREE_BASE_VERSION_H

#include <stddef.h>

/* The version of the release ("0.1.0"). All functions here that return text return static text. */
const char *version_number(void);

/* The git revision that the binary was built from: twelve digits, with "-modified" if the tree differed from
 * the commit; "unknown" without git. */
const char *version_revision(void);

/* Compiler with version, and the flags given to it. */
const char *version_compiler(void);
const char *version_flags(void);

/* Writes the name of this machine to `name` (`size` bytes, always ended by a zero; "unknown" on failure). */
void version_host(char *name, size_t size);

/* Writes the CPU's model name to `name` likewise ("unknown" if the system does not give the name). */
void version_cpu(char *name, size_t size);

#endif
