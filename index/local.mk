noinst_LTLIBRARIES += libindex.la
libindex_la_SOURCES =
