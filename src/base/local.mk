# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libcore.la
libcore_la_SOURCES = \
	src/base/checksum.c \
	src/base/checksum.h \
	src/base/eigen3.c \
	src/base/eigen3.h \
	src/base/error.c \
	src/base/error.h \
	src/base/exact.c \
	src/base/exact.h \
	src/base/hash.c \
	src/base/hash.h \
	src/base/image.h \
	src/base/log.c \
	src/base/log.h \
	src/base/memory.c \
	src/base/memory.h \
	src/base/mix.h \
	src/base/program.c \
	src/base/program.h \
	src/base/random.c \
	src/base/random.h \
	src/base/scan.c \
	src/base/scan.h \
	src/base/stream.h \
	src/base/team.c \
	src/base/team.h \
	src/base/threads.c \
	src/base/threads.h \
	src/base/timer.c \
	src/base/timer.h \
	src/base/version.c \
	src/base/version.h

noinst_LTLIBRARIES += libfiles.la
libfiles_la_SOURCES = \
	src/base/file.c \
	src/base/file.h \
	src/base/lines.c \
	src/base/lines.h \
	src/base/numbers.c \
	src/base/numbers.h
libfiles_la_CPPFLAGS = $(AM_CPPFLAGS) $(ZLIB_CFLAGS)
libfiles_la_LIBADD = $(ZLIB_LIBS)

# The git revision, for the report: asked at every make, written only when it changes. A tarball carries it as a file.
BUILT_SOURCES += src/base/revision.h
CLEANFILES += src/base/revision.h
src/base/version.lo: src/base/revision.h
src/base/revision.h: revision-asked
	@$(MKDIR_P) src/base
	@revision=`cat $(srcdir)/.revision 2>/dev/null`; \
	if test -n "$(GIT)" && test -e $(srcdir)/.git; then \
	    revision=`cd $(srcdir) && $(GIT) rev-parse --short=12 HEAD 2>/dev/null`; \
	    test -z "`cd $(srcdir) && $(GIT) --no-optional-locks status --porcelain -uno 2>/dev/null`" \
	        || revision="$$revision-modified"; \
	fi; \
	echo "#define SCREE_REVISION \"$${revision:-unknown}\"" > src/base/revision.new; \
	if cmp -s src/base/revision.new src/base/revision.h; then rm -f src/base/revision.new; \
	else mv -f src/base/revision.new src/base/revision.h; fi
revision-asked:
.PHONY: revision-asked

dist-hook: src/base/revision.h
	$(SED) 's/.*"\(.*\)"/\1/' src/base/revision.h > $(distdir)/.revision
