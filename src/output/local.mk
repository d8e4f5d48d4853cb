noinst_LTLIBRARIES += liboutput.la
liboutput_la_SOURCES =
liboutput_la_CPPFLAGS = $(AM_CPPFLAGS) $(HDF5_CFLAGS) $(MPI_CFLAGS)
liboutput_la_LIBADD = $(HDF5_LIBS)
