# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libcore.la
libcore_la_SOURCES = \
	src/core/checksum.c \
	src/core/checksum.h \
	src/core/error.c \
	src/core/error.h \
	src/core/exact.c \
	src/core/exact.h \
	src/core/image.h \
	src/core/log.c \
	src/core/log.h \
	src/core/memory.c \
	src/core/memory.h \
	src/core/program.c \
	src/core/program.h \
	src/core/random.c \
	src/core/random.h \
	src/core/scan.c \
	src/core/scan.h \
	src/core/stream.h \
	src/core/team.c \
	src/core/team.h \
	src/core/threads.c \
	src/core/threads.h \
	src/core/timer.c \
	src/core/timer.h \
	src/core/version.c \
	src/core/version.h

# The git revision, for the report: asked at every make, written only when it changes. A tarball carries it as a file.
BUILT_SOURCES += src/core/revision.h
CLEANFILES += src/core/revision.h
src/core/version.lo: src/core/revision.h
src/core/revision.h: revision-asked
	@$(MKDIR_P) src/core
	@revision=`cat $(srcdir)/.revision 2>/dev/null`; \
	if test -n "$(GIT)" && test -e $(srcdir)/.git; then \
	    revision=`cd $(srcdir) && $(GIT) rev-parse --short=12 HEAD 2>/dev/null`; \
	    test -z "`cd $(srcdir) && $(GIT) --no-optional-locks status --porcelain -uno 2>/dev/null`" \
	        || revision="$$revision-modified"; \
	fi; \
	echo "#define SCREE_REVISION \"$${revision:-unknown}\"" > src/core/revision.new; \
	if cmp -s src/core/revision.new src/core/revision.h; then rm -f src/core/revision.new; \
	else mv -f src/core/revision.new src/core/revision.h; fi
revision-asked:
.PHONY: revision-asked

dist-hook: src/core/revision.h
	$(SED) 's/.*"\(.*\)"/\1/' src/core/revision.h > $(distdir)/.revision
