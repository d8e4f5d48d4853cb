# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libintegrate.la
libintegrate_la_SOURCES = \
	%D%/carried.c %D%/integrator.c %D%/stability.c %D%/timestep.c %D%/carried.h %D%/integrator.h %D%/stability.h \
	%D%/timestep.h
