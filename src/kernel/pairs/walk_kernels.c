/* SPDX-License-Identifier: BSD-3-Clause */
/* The instruction sets for which the walk and its clients are compiled, and which of them this CPU runs. */
#include "kernel/pairs/walk_kernel.h"
#include <string.h>

static const char *const names[] = {"baseline", "x86-64-v3", "x86-64-v4"};
enum { LEVELS = 3 };

static bool level_runs(int level) {
#ifdef SCREE_X86_KERNELS
    if (level == 2)
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
               __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512vl") && level_runs(1);
    if (level == 1)
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
               __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
#endif
    return level == 0;
}

int walk_level(const char *name) {
    for (int level = LEVELS - 1; level >= 0; level--)
        if ((name == NULL || strcmp(names[level], name) == 0) && level_runs(level))
            return level;
    return -1;
}

const char *walk_level_name(int level) {
    return names[level];
}

const struct walk_kernel *walk_kernel_get(int level) {
    static const struct walk_kernel *const kernels[LEVELS] = {
        &walk_kernel_baseline,
#ifdef SCREE_X86_KERNELS
        &walk_kernel_v3,
        &walk_kernel_v4,
#endif
    };
    return kernels[level];
}
