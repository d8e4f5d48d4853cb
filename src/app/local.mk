noinst_LTLIBRARIES += libapp.la
libapp_la_SOURCES =
