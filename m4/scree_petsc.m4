# SCREE_PETSC
# --with-petsc=auto|yes|no: PETSc, by pkg-config, of which only -I, -L and -l are taken. Sets PETSC_CFLAGS, PETSC_LIBS, DL_LIBS
# and have_petsc, and the condition HAVE_PETSC. Needs SCREE_MPI before it.
AC_DEFUN([SCREE_PETSC], [
AC_ARG_WITH([petsc],
    [AS_HELP_STRING([--with-petsc=auto|yes|no], [PETSc, which solves the equations of a fluid (auto: if it is there)])],
    [], [with_petsc=auto])
AC_ARG_VAR([PETSC_CFLAGS], [C preprocessor flags for PETSc])
AC_ARG_VAR([PETSC_LIBS], [linker flags for PETSc])
have_petsc=no
petsc_said="no (no fluids; Debian: libpetsc-real-dev)"
AS_IF([test "$with_petsc" != no], [
    AS_IF([test -z "$PETSC_CFLAGS"],
          [PETSC_CFLAGS=`$PKG_CONFIG --cflags-only-I PETSc 2>/dev/null | sed 's/-I/-isystem /g'`])
    AS_IF([test -z "$PETSC_LIBS"],
          [PETSC_LIBS="`$PKG_CONFIG --libs-only-L PETSc 2>/dev/null` `$PKG_CONFIG --libs-only-l PETSc 2>/dev/null`"])
    scree_save_CPPFLAGS=$CPPFLAGS
    scree_save_LIBS=$LIBS
    CPPFLAGS="$CPPFLAGS $MPI_CFLAGS $PETSC_CFLAGS"
    LIBS="$PETSC_LIBS $MPI_LIBS $LIBS"
    AC_MSG_CHECKING([for PETSc 3.18 or later, real, with integers of 32 bits])
    AC_LINK_IFELSE([AC_LANG_PROGRAM([[
#include <petscksp.h>
#if PETSC_VERSION_LT(3, 18, 0) || defined(PETSC_USE_COMPLEX) || defined(PETSC_USE_64BIT_INDICES) || !defined(PETSC_USE_REAL_DOUBLE)
#error another PETSc
#endif
]], [[KSP solver; return KSPCreate(PETSC_COMM_SELF, &solver);]])], [have_petsc=yes])
    AC_MSG_RESULT([$have_petsc])
    CPPFLAGS=$scree_save_CPPFLAGS
    LIBS=$scree_save_LIBS
    AS_IF([test "$have_petsc" = yes], [petsc_said=yes],
          [test "$with_petsc" = yes],
          [AC_MSG_ERROR([PETSc not found (Debian: libpetsc-real-dev), see config.log])])
    scree_save_LIBS=$LIBS
    AC_SEARCH_LIBS([dlopen], [dl], [AS_IF([test "$ac_cv_search_dlopen" != "none required"], [DL_LIBS=$ac_cv_search_dlopen])])
    LIBS=$scree_save_LIBS
])
AC_SUBST([DL_LIBS])
AM_CONDITIONAL([HAVE_PETSC], [test "$have_petsc" = yes])
])
