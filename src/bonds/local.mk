# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libbonds.la
libbonds_la_SOURCES = \
	src/bonds/bond.c \
	src/bonds/bond.h \
	src/bonds/bonds.h \
	src/bonds/bonds_rows.c \
	src/bonds/fields.c \
	src/bonds/links.c \
	src/bonds/make.c \
	src/bonds/physics.c \
	src/bonds/state.h \
	src/bonds/table.c
libbonds_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
PHYSICS_LIBS += libbonds.la
