/* SPDX-License-Identifier: BSD-3-Clause */
/* A law that a block of a test owns: its tables go at the end of the block. */
#ifndef SCREE_TESTS_OWN_LAW_H
#define SCREE_TESTS_OWN_LAW_H

#include "physics/grains/laws/law.h"

#define OWN_LAW __attribute__((cleanup(law_free))) struct law

#endif
