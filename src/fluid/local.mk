# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libfluid.la
libfluid_la_SOURCES = \
	src/fluid/body.c \
	src/fluid/body.h \
	src/fluid/fluid.h \
	src/fluid/kernel.c \
	src/fluid/kernel.h \
	src/fluid/mirror.c \
	src/fluid/mirror.h \
	src/fluid/operators.c \
	src/fluid/operators.h \
	src/fluid/tensors.c \
	src/fluid/tensors.h \
	src/fluid/weights.c \
	src/fluid/weights.h
libfluid_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
FLUID_LIBS = libfluid.la $(PAIRS_LIBS)
