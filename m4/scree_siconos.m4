# SCREE_SICONOS
# Siconos (numerics), which tests/physics/hard/oracle.c calls to solve contact problems again. Sets SICONOS_CFLAGS, SICONOS_LIBS and
# have_siconos, and the condition HAVE_SICONOS. Only tests need it.
AC_DEFUN([SCREE_SICONOS], [
AC_ARG_VAR([SICONOS_CFLAGS], [C preprocessor flags for Siconos])
AC_ARG_VAR([SICONOS_LIBS], [linker flags for Siconos])
AS_IF([test -z "$SICONOS_CFLAGS"],
      [SICONOS_CFLAGS="-isystem /usr/include/siconos/numerics -isystem /usr/include/siconos -isystem /usr/include/suitesparse"])
AS_IF([test -z "$SICONOS_LIBS"], [SICONOS_LIBS="-lsiconos_numerics -lsiconos_externals"])
scree_save_CPPFLAGS=$CPPFLAGS
scree_save_LIBS=$LIBS
CPPFLAGS="$CPPFLAGS $SICONOS_CFLAGS"
LIBS="$SICONOS_LIBS $LIBS"
AC_MSG_CHECKING([for Siconos])
AC_LINK_IFELSE([AC_LANG_PROGRAM([[
#include <FrictionContactProblem.h>
#include <Friction_cst.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <NumericsSparseMatrix.h>
#include <SolverOptions.h>
]], [[NumericsMatrix *w = NM_create(NM_SPARSE, 3, 3);
NM_triplet_alloc(w, 9);
return fc3d_driver(frictionContactProblem_new_with_data(3, 1, w, 0, 0), 0, 0, solver_options_create(SICONOS_FRICTION_3D_NSGS));]])],
    [have_siconos=yes], [have_siconos=no])
AC_MSG_RESULT([$have_siconos])
CPPFLAGS=$scree_save_CPPFLAGS
LIBS=$scree_save_LIBS
AS_IF([test "$have_siconos" = yes], [siconos_said=yes],
      [siconos_said="no (contact problems are not solved again by tests; Debian: libsiconos-numerics-dev)"])
AM_CONDITIONAL([HAVE_SICONOS], [test "$have_siconos" = yes])
])
