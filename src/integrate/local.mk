# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libintegrate.la
libintegrate_la_SOURCES = \
	src/integrate/carried.c \
	src/integrate/carried.h \
	src/integrate/integrator.c \
	src/integrate/integrator.h \
	src/integrate/stability.c \
	src/integrate/stability.h \
	src/integrate/timestep.c \
	src/integrate/timestep.h
