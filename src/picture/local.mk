# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libpicture.la
libpicture_la_SOURCES = \
	src/picture/camera.c src/picture/camera.h \
	src/picture/paint.c src/picture/paint.h \
	src/picture/picture.c src/picture/picture.h \
	src/picture/shapes.c src/picture/shapes.h \
	src/picture/source.c src/picture/source.h
libpicture_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS) $(HDF5_CPPFLAGS) $(HDF5_CFLAGS)
