# SPDX-License-Identifier: BSD-3-Clause
"""Makes a wheel of the package scree for pip (PEP 517). It needs nothing but Python: the package is Python code and two headers."""

import base64
import hashlib
import os
import pathlib
import re
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[3]


def _library():
    """The library that the package loads: $SCREE_LIBRARY, else that of the build folder, else the installed one."""
    built = ROOT / "build" / ".libs" / "libscree.so"
    return os.environ.get("SCREE_LIBRARY") or (str(built) if built.exists() else "libscree.so.0")


def _files(name, version):
    """What the wheel holds: path and bytes."""
    for path in sorted((ROOT / "src/front/python/scree").glob("*.py")) + [ROOT / "src/scree.h", ROOT / "src/scree_pairs.h"]:
        yield "scree/" + path.name, path.read_bytes()
    yield "scree/_where.py", f'LIBRARY = "{_library()}"\n'.encode()
    metadata = (
        f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\nSummary: particles of very different sizes\n"
        "License: BSD-3-Clause\nRequires-Python: >=3.8\nRequires-Dist: cffi\nRequires-Dist: numpy\n"
        "Provides-Extra: tables\nRequires-Dist: pandas; extra == 'tables'\n"
    )
    yield f"{name}-{version}.dist-info/METADATA", metadata.encode()
    yield f"{name}-{version}.dist-info/WHEEL", b"Wheel-Version: 1.0\nGenerator: scree\nRoot-Is-Purelib: true\nTag: py3-none-any\n"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Called by pip: writes the wheel and returns its name."""
    version = re.search(r"AC_INIT\(\[scree\], \[([^]]*)\]", (ROOT / "configure.ac").read_text()).group(1)
    wheel = f"scree-{version}-py3-none-any.whl"
    record = f"scree-{version}.dist-info/RECORD"
    rows = []
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, content in _files("scree", version):
            archive.writestr(path, content)
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            rows.append(f"{path},sha256={digest},{len(content)}\n")
        archive.writestr(record, "".join(rows) + f"{record},,\n")
    return wheel
