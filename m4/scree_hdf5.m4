# SCREE_HDF5
# Finds an HDF5 that was built with MPI: the pkg-config name of Debian's first, then the common one.
# Sets HDF5_CFLAGS and HDF5_LIBS. Needs SCREE_MPI before it.
AC_DEFUN([SCREE_HDF5], [
PKG_CHECK_MODULES([HDF5], [hdf5-openmpi], [],
    [PKG_CHECK_MODULES([HDF5], [hdf5], [],
        [AC_MSG_ERROR([parallel HDF5 not found; install it (Debian: libhdf5-openmpi-dev) or set HDF5_CFLAGS and HDF5_LIBS])])])
scree_save_CPPFLAGS=$CPPFLAGS
CPPFLAGS="$CPPFLAGS $HDF5_CFLAGS $MPI_CFLAGS"
AC_MSG_CHECKING([whether HDF5 was built with MPI])
AC_COMPILE_IFELSE([AC_LANG_SOURCE([[
#include <hdf5.h>
#ifndef H5_HAVE_PARALLEL
#error no MPI
#endif
]])], [AC_MSG_RESULT([yes])],
      [AC_MSG_RESULT([no])
       AC_MSG_ERROR([this HDF5 has no MPI support; install a parallel one (Debian: libhdf5-openmpi-dev)])])
CPPFLAGS=$scree_save_CPPFLAGS
])
