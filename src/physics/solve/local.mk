# SPDX-License-Identifier: BSD-3-Clause
# Linear systems. What includes PETSc is a module, which the program loads when it first needs it.
noinst_LTLIBRARIES += libsolve.la
libsolve_la_SOURCES = %D%/system.c %D%/backend.h %D%/solve.h
libsolve_la_CPPFLAGS = $(AM_CPPFLAGS)
libsolve_la_LIBADD =
if HAVE_PETSC
libsolve_la_SOURCES += %D%/load_petsc.c
libsolve_la_CPPFLAGS += -DSCREE_MODULES='"$(pkglibdir)"'
libsolve_la_LIBADD += $(DL_LIBS)
pkglib_LTLIBRARIES += libsolve_petsc.la
libsolve_petsc_la_SOURCES = \
	%D%/petsc.c %D%/petsc_free.c %D%/petsc_matrix.c %D%/petsc_solver.c %D%/petsc_system.c %D%/petsc_parts.h
libsolve_petsc_la_CPPFLAGS = $(AM_CPPFLAGS) $(PETSC_CFLAGS)
libsolve_petsc_la_LDFLAGS = $(AM_LDFLAGS) -module -avoid-version -export-symbols-regex '^petsc_backend$$'
libsolve_petsc_la_LIBADD = libcore.la $(PETSC_LIBS) $(MPI_LIBS)
else
libsolve_la_SOURCES += %D%/missing.c
endif
