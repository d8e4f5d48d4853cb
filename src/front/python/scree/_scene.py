# SPDX-License-Identifier: BSD-3-Clause
"""Scenes: a dict, a YAML text or a YAML file."""

import json
import os


def _plain(value):
    """A numpy number or array as Python has it, for JSON, which YAML includes."""
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    raise TypeError(f"a scene cannot hold a {type(value).__name__}")


class Scene:
    """A scene with the keys of docs/scene.md.

    `source` is a dict, the path of a YAML file, or a YAML text (a str with a line break, or that begins with {). `set` overrides keys:
    {"index.name": "brute"}, as --set of the program. `folder` is where relative paths of a dict or a text start from
    (the present one). Mistakes are found when a Simulation is made."""

    def __init__(self, source, set=None, folder="."):
        self.set = dict(set or {})
        if isinstance(source, dict):
            self.file = os.path.join(folder, "scene")
            self.text = json.dumps(source, default=_plain, allow_nan=False)
        elif isinstance(source, str) and ("\n" in source or source.lstrip().startswith("{")):
            self.file = os.path.join(folder, "scene")
            self.text = source
        else:
            self.file = os.fspath(source)
            self.text = None

    def settings(self):
        """The overrides as "KEY=VALUE"."""
        words = []
        for key, value in self.set.items():
            text = value if isinstance(value, str) else json.dumps(value, default=_plain, allow_nan=False)
            words.append(f"{key}={text}")
        return words

    def __repr__(self):
        return f"Scene({self.file!r})" if self.text is None else f"Scene({self.text!r})"
