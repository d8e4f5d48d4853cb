noinst_LTLIBRARIES += libparticles.la
libparticles_la_SOURCES =
