#include "contact/force_kernel.h"
#include <string.h>

/* True if this CPU runs the kernel. */
static bool force_kernel_runs(const struct force_kernel *kernel) {
#ifdef FORCE_X86_KERNELS
    if (kernel == &force_kernel_v4)
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
               __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512vl") && force_kernel_runs(&force_kernel_v3);
    if (kernel == &force_kernel_v3)
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
               __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
#endif
    return kernel == &force_kernel_baseline;
}

/* Kernel number k, best first, or NULL. */
static const struct force_kernel *force_kernel_get(int k) {
    static const struct force_kernel *const kernels[] = {
#ifdef FORCE_X86_KERNELS
        &force_kernel_v4, &force_kernel_v3,
#endif
        &force_kernel_baseline, NULL};
    return kernels[k];
}

const struct force_kernel *force_kernel_find(const char *name) {
    for (int k = 0; force_kernel_get(k); k++)
        if ((name == NULL || strcmp(force_kernel_get(k)->name, name) == 0) &&
            force_kernel_runs(force_kernel_get(k)))
            return force_kernel_get(k);
    return NULL;
}
