# SPDX-License-Identifier: BSD-3-Clause
"""Loads libscree. The declarations come from the headers that lie beside this file, so they are those of the library."""

import operator
import os
import pathlib
import re

import cffi
import numpy as np

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


def whole(value, name, least, most):
    """A whole number from `least` to `most`."""
    try:
        number = operator.index(value)
    except TypeError:
        raise Error(f"{name} is a whole number, not {value!r}") from None
    if not least <= number <= most:
        raise Error(f"{name} is a whole number from {least} to {most}, not {number}")
    return number


def spread(values, name, shape, dtype):
    """One value for all, or one for each, as an array of this shape; whole numbers stay whole."""
    array = np.asarray(values)
    if dtype is int and array.size > 0 and array.dtype.kind not in "iu":
        raise Error(f"{name}: whole numbers are needed")
    try:
        return np.broadcast_to(np.asarray(array, np.int64 if dtype is int else np.float64), shape)
    except (TypeError, ValueError):
        raise Error(f"{name} of the shape {array.shape} and type {array.dtype}: one value for all is needed, or {shape}") from None


def version():
    """The version of the library."""
    return ffi.string(lib.scree_version()).decode()
