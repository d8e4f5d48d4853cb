/* SPDX-License-Identifier: BSD-3-Clause */
/* Reads the options of a packing from texts. */
#ifndef SCREE_PACK_OPTIONS_READ_H
#define SCREE_PACK_OPTIONS_READ_H

#include "base/error.h"
#include "front/pack/options.h"
#include <stdbool.h>

/* Fills the options from the law's name and texts KEY=VALUE (borrowed): first the law's defaults, then the
 * texts, then derived values (numbers and box of the published systems). Fails (user) and names the allowed
 * values. */
bool pack_options_read(struct pack_options *options, const char *law, const char *const *setting,
                       int settings, struct error *error);

#endif
