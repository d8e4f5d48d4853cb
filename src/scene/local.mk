noinst_LTLIBRARIES += libscene.la
libscene_la_SOURCES =
libscene_la_CPPFLAGS = $(AM_CPPFLAGS) $(YAML_CFLAGS) $(MPI_CFLAGS)
libscene_la_LIBADD = $(YAML_LIBS)
