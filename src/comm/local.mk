noinst_LTLIBRARIES += libcomm.la
libcomm_la_SOURCES =
libcomm_la_CPPFLAGS = $(AM_CPPFLAGS) $(MPI_CFLAGS)
libcomm_la_LIBADD = $(MPI_LIBS)
