# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libview.la
libview_la_SOURCES = \
	%D%/board.c %D%/server.c %D%/shot.c %D%/shot_rocks.c %D%/view.c %D%/board.h %D%/server.h %D%/shot.h \
	%D%/shot_rocks.h %D%/view.h
libview_la_CPPFLAGS = $(AM_CPPFLAGS) $(MICROHTTPD_CFLAGS)
libview_la_LIBADD = $(MICROHTTPD_LIBS) -lpthread

# The page of the live view lies beside that of reports, of which it has the plots. The module of three.js names its base by
# a name that a page on its own does not know.
view_files = src/front/view/view.html src/front/view/view.css src/front/view/view.js src/front/view/three.module.min.js src/front/view/three.LICENSE
dist_page_DATA += $(view_files)
nodist_page_DATA = page/OrbitControls.js
EXTRA_DIST += %D%/OrbitControls.js
page/OrbitControls.js: src/front/view/OrbitControls.js page/copied
	@sed "s|from 'three'|from './three.module.min.js'|" $(srcdir)/src/front/view/OrbitControls.js >$@
