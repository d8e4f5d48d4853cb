# SPDX-License-Identifier: BSD-3-Clause
"""Loads libscree. The declarations come from the headers that lie beside this file, so they are those of the library."""

import os
import pathlib
import re

import cffi

from . import _where

_here = pathlib.Path(__file__).parent


def _declarations():
    """The functions and types of scree.h, without comments and lines of the preprocessor."""
    text = (_here / "scree_pairs.h").read_text() + (_here / "scree.h").read_text()
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
    text = re.sub(r'^#.*$|^extern "C" \{$|^\}$', "", text, flags=re.MULTILINE)
    return text


ffi = cffi.FFI()
ffi.cdef(_declarations())
lib = ffi.dlopen(os.environ.get("SCREE_LIBRARY", _where.LIBRARY))


class Error(Exception):
    """A failure: a mistake of the user (`status` 2), of the system (1), or a guard that stopped a simulation (3)."""

    def __init__(self, text, status=2):
        super().__init__(text)
        self.status = status


def check(good, error):
    """Raises the failure that `error` (struct scree_error *) tells, unless `good`."""
    if not good:
        raise Error(ffi.string(error.text).decode(errors="replace"), int(error.status))


def version():
    """The version of the library."""
    return ffi.string(lib.scree_version()).decode()
