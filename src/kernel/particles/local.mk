# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libparticles.la
libparticles_la_SOURCES = \
	%D%/box.c %D%/classes.c %D%/fields.c %D%/groups.c %D%/kinds.c %D%/material.c %D%/particles.c %D%/shape.c \
	%D%/spin.c %D%/storage.c %D%/box.h %D%/classes.h %D%/fields.h %D%/groups.h %D%/kinds.h %D%/material.h \
	%D%/particles.h %D%/shape.h %D%/spin.h %D%/storage.h
