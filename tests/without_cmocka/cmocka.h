/* SPDX-License-Identifier: BSD-3-Clause */
/* Stands in for CMocka's header where configure has not found it. */
#error "make check needs CMocka (Debian: libcmocka-dev): install it and call configure again"
