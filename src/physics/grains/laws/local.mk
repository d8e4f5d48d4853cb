# SPDX-License-Identifier: BSD-3-Clause
noinst_LTLIBRARIES += libcontact.la
libcontact_la_SOURCES = \
	src/physics/grains/batch/force.c src/physics/grains/batch/force_contacts.c \
	src/physics/grains/batch/force_general.c %D%/law.c %D%/law_check.c %D%/law_cohesion.c %D%/law_general.c \
	%D%/law_grip.c %D%/law_parts.c %D%/law_resist.c %D%/law_restitution.c %D%/law_springs.c %D%/law_table.c \
	%D%/law_user.c src/physics/grains/batch/force.h src/physics/grains/batch/force_account.h \
	src/physics/grains/batch/force_general.h src/physics/grains/batch/force_grip.h \
	src/physics/grains/batch/force_kernel.h src/physics/grains/batch/force_physics.h \
	src/physics/grains/batch/force_resist.h %D%/law.h \
	%D%/law_cohesion.h %D%/law_custom.h %D%/law_eepa.h %D%/law_form.h %D%/law_general.h %D%/law_grip.h \
	%D%/law_hertz.h %D%/law_hooke.h %D%/law_kernel.h %D%/law_luding.h %D%/law_part.h %D%/law_parts.h \
	%D%/law_resist.h %D%/law_restitution.h %D%/law_rigid.h %D%/law_root.h %D%/law_spheres.h %D%/law_spring.h \
	%D%/law_table.h %D%/law_thornton.h %D%/law_user.h %D%/law_vector.h
# One header a part: a new one needs no line
EXTRA_DIST += %D%/parts
libcontact_la_CPPFLAGS = $(AM_CPPFLAGS) $(KERNEL_CPPFLAGS)
libcontact_la_LIBADD = libforce_baseline.la

# A law of the user's is compiled against the text of this header
include_HEADERS += src/physics/grains/laws/scree_law.h
src/physics/grains/laws/scree_law.text: src/physics/grains/laws/scree_law.h
	$(AM_V_GEN)$(MKDIR_P) src/physics/grains/laws && sed 's/\\/\\\\/g; s/"/\\"/g; s/^/"/; s/$$/\\n"/' $(srcdir)/src/physics/grains/laws/scree_law.h >$@
$(libcontact_la_OBJECTS): src/physics/grains/laws/scree_law.text
BUILT_SOURCES += src/physics/grains/laws/scree_law.text
CLEANFILES += src/physics/grains/laws/scree_law.text

# The laws over a batch, once for each instruction set
FORCE_SOURCES = src/physics/grains/batch/force_block.c
noinst_LTLIBRARIES += libforce_baseline.la
libforce_baseline_la_SOURCES = $(FORCE_SOURCES)
libforce_baseline_la_CFLAGS = $(KERNEL_CFLAGS)
libforce_baseline_la_CPPFLAGS = $(AM_CPPFLAGS) $(KERNEL_CPPFLAGS) -DFORCE_KERNEL=force_kernel_baseline \
	-DFORCE_KERNEL_NAME='"baseline"'
if X86_KERNELS
noinst_LTLIBRARIES += libforce_v3.la libforce_v4.la
libforce_v3_la_SOURCES = $(FORCE_SOURCES)
libforce_v3_la_CFLAGS = $(KERNEL_CFLAGS) $(KERNEL_V3)
libforce_v3_la_CPPFLAGS = $(AM_CPPFLAGS) $(KERNEL_CPPFLAGS) -DFORCE_KERNEL=force_kernel_v3 \
	-DFORCE_KERNEL_NAME='"x86-64-v3"'
libforce_v4_la_SOURCES = $(FORCE_SOURCES)
libforce_v4_la_CFLAGS = $(KERNEL_CFLAGS) $(KERNEL_V4)
libforce_v4_la_CPPFLAGS = $(AM_CPPFLAGS) $(KERNEL_CPPFLAGS) -DFORCE_KERNEL=force_kernel_v4 \
	-DFORCE_KERNEL_NAME='"x86-64-v4"'
libcontact_la_LIBADD += libforce_v3.la libforce_v4.la
endif
