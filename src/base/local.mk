# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libcore.la
libcore_la_SOURCES = \
	%D%/checksum.c %D%/eigen3.c %D%/eigen6.c %D%/error.c %D%/exact.c %D%/hash.c %D%/log.c %D%/memory.c \
	%D%/moments.c %D%/program.c %D%/random.c %D%/rotor.c %D%/scan.c %D%/team.c %D%/threads.c %D%/timer.c \
	%D%/version.c %D%/checksum.h %D%/clones.h %D%/eigen3.h %D%/eigen6.h %D%/error.h %D%/exact.h %D%/hash.h \
	%D%/image.h %D%/log.h %D%/memory.h %D%/mix.h %D%/moments.h %D%/program.h %D%/random.h %D%/rotor.h %D%/scan.h \
	%D%/stream.h %D%/team.h %D%/threads.h %D%/timer.h %D%/vector.h %D%/version.h

noinst_LTLIBRARIES += libfiles.la
libfiles_la_SOURCES = %D%/file.c %D%/lines.c %D%/numbers.c %D%/file.h %D%/lines.h %D%/numbers.h
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
