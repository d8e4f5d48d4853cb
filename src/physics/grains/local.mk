# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libgrains.la
libgrains_la_SOURCES = \
	%D%/grains.c %D%/grains_balance.c %D%/grains_notes.c %D%/grains_physics.c %D%/limit.c %D%/obstacles.c \
	%D%/overlaps.c %D%/record.c %D%/sorts.c %D%/stable.c %D%/start.c %D%/grains.h %D%/grains_own.h \
	%D%/overlaps.h %D%/sorts.h
PHYSICS_LIBS += libgrains.la
