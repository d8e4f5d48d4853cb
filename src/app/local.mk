noinst_LTLIBRARIES += libapp.la
libapp_la_SOURCES =
libapp_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
