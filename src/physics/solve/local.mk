# SPDX-License-Identifier: BSD-3-Clause
# Linear systems. What includes PETSc is a module, which the program loads when it first needs it.
noinst_LTLIBRARIES += libsolve.la
libsolve_la_SOURCES = src/physics/solve/backend.h src/physics/solve/solve.h src/physics/solve/system.c
libsolve_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
libsolve_la_LIBADD =
SOLVE_LIBS = libsolve.la $(COMM_LIBS)
if HAVE_PETSC
libsolve_la_SOURCES += src/physics/solve/load_petsc.c
libsolve_la_CPPFLAGS += -DSCREE_MODULES='"$(pkglibdir)"'
libsolve_la_LIBADD += $(DL_LIBS)
pkglib_LTLIBRARIES += libsolve_petsc.la
libsolve_petsc_la_SOURCES = \
	src/physics/solve/petsc.c \
	src/physics/solve/petsc_free.c src/physics/solve/petsc_free.h \
	src/physics/solve/petsc_matrix.c src/physics/solve/petsc_matrix.h \
	src/physics/solve/petsc_solver.c src/physics/solve/petsc_solver.h \
	src/physics/solve/petsc_system.c src/physics/solve/petsc_system.h
libsolve_petsc_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS) $(PETSC_CFLAGS)
libsolve_petsc_la_LDFLAGS = $(AM_LDFLAGS) -module -avoid-version -export-symbols-regex '^petsc_backend$$'
libsolve_petsc_la_LIBADD = libcore.la $(PETSC_LIBS) $(MPI_LIBS)
else
libsolve_la_SOURCES += src/physics/solve/missing.c
endif
