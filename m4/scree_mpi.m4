# SCREE_MPI
# Asks the MPI compiler wrapper (MPICC) for its flags, so that CC stays the plain compiler and only what calls MPI
# is linked with it. Sets MPICC, MPI_CFLAGS, MPI_LIBS and MPIRUN.
AC_DEFUN([SCREE_MPI], [
AC_ARG_VAR([MPICC], [MPI compiler wrapper whose flags are used])
AC_ARG_VAR([MPIRUN], [program that starts MPI tests])
AC_PATH_PROGS([MPICC], [mpicc mpicc.openmpi])
AC_PATH_PROGS([MPIRUN], [mpirun mpirun.openmpi mpiexec])
AS_IF([test -z "$MPICC"], [AC_MSG_ERROR([mpicc not found; install Open MPI (Debian: libopenmpi-dev openmpi-bin) or set MPICC])])
AS_IF([test -z "$MPIRUN"], [AC_MSG_ERROR([mpirun not found; install Open MPI (Debian: openmpi-bin) or set MPIRUN])])
AC_MSG_CHECKING([for the flags of $MPICC])
AS_IF([MPI_CFLAGS=`$MPICC --showme:compile 2>/dev/null`],
      [MPI_LIBS=`$MPICC --showme:link`],
      [AC_MSG_ERROR([$MPICC does not answer --showme:compile; is it Open MPI?])])
AC_MSG_RESULT([$MPI_CFLAGS $MPI_LIBS])
AC_SUBST([MPI_CFLAGS])
AC_SUBST([MPI_LIBS])
scree_save_CPPFLAGS=$CPPFLAGS
scree_save_LIBS=$LIBS
CPPFLAGS="$CPPFLAGS $MPI_CFLAGS"
LIBS="$MPI_LIBS $LIBS"
AC_MSG_CHECKING([whether MPI programs link])
AC_LINK_IFELSE([AC_LANG_PROGRAM([[#include <mpi.h>]], [[int argc = 0; char **argv = 0; MPI_Init(&argc, &argv);]])],
               [AC_MSG_RESULT([yes])],
               [AC_MSG_RESULT([no])
                AC_MSG_ERROR([a program with MPI_Init does not link, see config.log])])
CPPFLAGS=$scree_save_CPPFLAGS
LIBS=$scree_save_LIBS
])
