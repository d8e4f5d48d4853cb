/* SPDX-License-Identifier: BSD-3-Clause */
/* A function that is compiled for several instruction sets, of which the processor's best one is taken as the program starts: in
 * front of a static function whose loop is worth it. All versions give the same bits, as products and sums are not contracted. One
 * version where the compiler or the processor has no such thing. */
#ifndef SCREE_BASE_CLONES_H
#define SCREE_BASE_CLONES_H

#if defined __x86_64__ && defined __GLIBC__ && defined __GNUC__ && !defined __clang__ &&                     \
    !defined __SANITIZE_ADDRESS__ && !defined __SANITIZE_THREAD__
#define SCREE_CLONES __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define SCREE_CLONES
#endif

#endif
