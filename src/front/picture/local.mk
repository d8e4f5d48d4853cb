# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libpicture.la
libpicture_la_SOURCES = \
	src/front/picture/camera.c src/front/picture/camera.h \
	src/front/picture/paint.c src/front/picture/paint.h \
	src/front/picture/picture.c src/front/picture/picture.h \
	src/front/picture/shapes.c src/front/picture/shapes.h \
	src/front/picture/picture_source.c src/front/picture/picture_source.h
libpicture_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS) $(HDF5_CPPFLAGS) $(HDF5_CFLAGS)
