noinst_LTLIBRARIES += libcontact.la
libcontact_la_SOURCES =
