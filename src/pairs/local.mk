noinst_LTLIBRARIES += libpairs.la
libpairs_la_SOURCES =
