# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libdensity.la
libdensity_la_SOURCES = %D%/density.c %D%/density_rows.c %D%/density.h
PHYSICS_LIBS += libdensity.la
