# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libpicture.la
libpicture_la_SOURCES = \
	%D%/camera.c %D%/facets.c %D%/paint.c %D%/picture.c %D%/picture_source.c %D%/polyhedra.c %D%/shapes.c \
	%D%/camera.h %D%/paint.h %D%/picture.h %D%/picture_source.h %D%/polyhedra.h %D%/shapes.h
