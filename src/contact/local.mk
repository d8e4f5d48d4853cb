noinst_LTLIBRARIES += libcontact.la
libcontact_la_SOURCES = \
	src/contact/force.c \
	src/contact/force.h \
	src/contact/force_account.h \
	src/contact/force_contacts.c \
	src/contact/force_four.h \
	src/contact/force_kernel.h \
	src/contact/force_kernels.c \
	src/contact/force_ordered.c \
	src/contact/force_ordered.h \
	src/contact/force_physics.h \
	src/contact/law.c \
	src/contact/law.h \
	src/contact/law_kernel.h
libcontact_la_CPPFLAGS = $(AM_CPPFLAGS)
libcontact_la_LIBADD = libforce_baseline.la

# The kernel of the force loop, once for each instruction set; force.c chooses at run time. Nobody looks at the floating
# point exceptions that a select may raise. (Clang says so when it leaves a loop alone, as it does in checked builds.)
FORCE_CFLAGS = $(AM_CFLAGS) -fno-trapping-math -Wno-pass-failed -Wno-psabi
FORCE_SOURCES = src/contact/force_block.c
FORCE_V3 = -march=x86-64-v3
FORCE_V4 = -march=x86-64-v4 -mprefer-vector-width=512

noinst_LTLIBRARIES += libforce_baseline.la
libforce_baseline_la_SOURCES = $(FORCE_SOURCES)
libforce_baseline_la_CFLAGS = $(FORCE_CFLAGS)
libforce_baseline_la_CPPFLAGS = $(AM_CPPFLAGS) -DFORCE_KERNEL=force_kernel_baseline -DFORCE_KERNEL_NAME='"baseline"'
if X86_KERNELS
noinst_LTLIBRARIES += libforce_v3.la libforce_v4.la
libforce_v3_la_SOURCES = $(FORCE_SOURCES)
libforce_v3_la_CFLAGS = $(FORCE_CFLAGS) $(FORCE_V3)
libforce_v3_la_CPPFLAGS = $(AM_CPPFLAGS) -DFORCE_KERNEL=force_kernel_v3 -DFORCE_KERNEL_NAME='"x86-64-v3"' \
	-DFORCE_X86_KERNELS
libforce_v4_la_SOURCES = $(FORCE_SOURCES)
libforce_v4_la_CFLAGS = $(FORCE_CFLAGS) $(FORCE_V4)
libforce_v4_la_CPPFLAGS = $(AM_CPPFLAGS) -DFORCE_KERNEL=force_kernel_v4 -DFORCE_KERNEL_NAME='"x86-64-v4"' \
	-DFORCE_X86_KERNELS
libcontact_la_CPPFLAGS += -DFORCE_X86_KERNELS
libcontact_la_LIBADD += libforce_v3.la libforce_v4.la
endif
