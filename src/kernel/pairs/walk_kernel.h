/* SPDX-License-Identifier: BSD-3-Clause */
/* The compiled forms of the walk: walk_block.c once for each instruction set. Included by walk*.c alone. */
#ifndef SCREE_PAIRS_WALK_KERNEL_H
#define SCREE_PAIRS_WALK_KERNEL_H

#include "kernel/pairs/walk.h"

struct walk_kernel {
    void (*block)(const struct walk_task *task); /* takes a block through all operations */
};

/* The compiled form of a level (walk_level), which the CPU must have. */
const struct walk_kernel *walk_kernel_get(int level);

extern const struct walk_kernel walk_kernel_baseline;
#ifdef SCREE_X86_KERNELS
extern const struct walk_kernel walk_kernel_v3; /* x86-64-v3: AVX2 */
extern const struct walk_kernel walk_kernel_v4; /* x86-64-v4: AVX-512 */
#endif

#endif
