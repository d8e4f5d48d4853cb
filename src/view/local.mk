# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libview.la
libview_la_SOURCES = \
	src/view/board.c src/view/board.h \
	src/view/server.c src/view/server.h \
	src/view/shot.c src/view/shot.h \
	src/view/view.c src/view/view.h
libview_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS) $(MICROHTTPD_CFLAGS)
libview_la_LIBADD = $(MICROHTTPD_LIBS) -lpthread

# The page of the live view lies beside that of reports, of which it has the plots. The module of three.js names its base by
# a name that a page on its own does not know.
view_files = src/view/view.html src/view/view.css src/view/view.js src/view/three.module.min.js src/view/three.LICENSE
dist_page_DATA += $(view_files)
nodist_page_DATA = page/OrbitControls.js
EXTRA_DIST += src/view/OrbitControls.js
page/OrbitControls.js: src/view/OrbitControls.js page/copied
	@sed "s|from 'three'|from './three.module.min.js'|" $(srcdir)/src/view/OrbitControls.js >$@
