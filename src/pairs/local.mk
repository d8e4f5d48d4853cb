noinst_LTLIBRARIES += libpairs.la
libpairs_la_SOURCES = \
	src/pairs/history.c src/pairs/history.h \
	src/pairs/history_keep.c src/pairs/history_keep.h \
	src/pairs/pairlist.c src/pairs/pairlist.h \
	src/pairs/pairlist_build.c src/pairs/pairlist_build.h \
	src/pairs/skin.c src/pairs/skin.h \
	src/pairs/sweep.c src/pairs/sweep.h
