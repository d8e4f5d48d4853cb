noinst_LTLIBRARIES += libintegrate.la
libintegrate_la_SOURCES =
