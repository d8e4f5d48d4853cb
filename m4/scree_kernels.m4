# SCREE_KERNELS
# Sets the conditional X86_KERNELS where the host is x86-64 and the compiler makes code for its levels 3 and 4 (AVX2, AVX-512),
# whatever this machine's own CPU runs. Sanitizers keep loops from being vectorised, so a checked build has one form alone.
AC_DEFUN([SCREE_KERNELS], [
scree_save_CFLAGS=$CFLAGS
CFLAGS="$CFLAGS -Werror -march=x86-64-v4"
AC_MSG_CHECKING([whether $CC makes code for x86-64-v4])
AC_COMPILE_IFELSE([AC_LANG_SOURCE([[
#ifndef __x86_64__
#error another CPU
#endif
int main(void) { return 0; }]])], [scree_kernels=yes], [scree_kernels=no])
AC_MSG_RESULT([$scree_kernels])
CFLAGS=$scree_save_CFLAGS
AM_CONDITIONAL([X86_KERNELS], [test "$scree_kernels" = yes && test "$enable_sanitizers" = no])
])
