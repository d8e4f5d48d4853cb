# SPDX-License-Identifier: BSD-3-Clause
"""A running scene."""

import json
import os
import sys
import time

import numpy as np

from ._library import Error, check, ffi, lib, spread, whole
from ._scene import Scene

_CHUNK = 0.2  # seconds between two looks at the keyboard


def _names(shape, n):
    """Names of shapes for C, one for each of n particles: of one for all, or a list."""
    each = [shape] * n if shape is None or isinstance(shape, str) else list(shape)
    if len(each) != n or not all(one is None or isinstance(one, str) for one in each):
        raise Error(f"shape is a name, None, or a list of {n} of them, not {shape!r}")
    return [ffi.NULL if one is None else ffi.new("char[]", one.encode()) for one in each]


class Simulation:
    """A scene that runs.

    scene: a Scene, or what makes one (dict, path, YAML text).
    force: a function of the simulation, called once in each step, that adds to `simulation.force`.
    log: a function of a line, for warnings and notes; by default they go to standard error.
    resume: a checkpoint to go on from.
    folder: of a scene with stages; gets the checkpoint at the end of each stage, which is else deleted.
    comm: a communicator of mpi4py, on whose ranks the simulation runs; None: this process alone."""

    def __init__(self, scene, force=None, log=None, resume=None, folder=None, comm=None):
        if not isinstance(scene, Scene):
            scene = Scene(scene)
        for name, function in (("force", force), ("log", log)):
            if function is not None and not callable(function):
                raise Error(f"{name} is a function, not {function!r}")
        self._raised, self._inside, self._columns = None, False, []
        self._force, self._log = force, log or (lambda line: print(f"scree: {line}", file=sys.stderr))
        options, error = ffi.new("struct scree_options *"), ffi.new("struct scree_error *")
        settings = [ffi.new("char[]", word.encode()) for word in scene.settings()]
        words = ffi.new("char *[]", settings)
        options.set, options.sets = words, len(settings)
        path = ffi.NULL if resume is None else ffi.new("char[]", os.fsencode(resume))
        options.resume = path
        place = ffi.NULL if folder is None else ffi.new("char[]", os.fsencode(folder))
        options.folder = place
        self._callbacks = [
            ffi.callback("void(void *, const char *)", self._say),
            ffi.callback("void(void *, struct scree_simulation *)", self._pull),
        ]
        options.log = self._callbacks[0]
        if force is not None:
            options.force = self._callbacks[1]
        if comm is not None:
            from mpi4py import MPI

            options.communicator = ffi.cast("void *", MPI._addressof(comm))
        text = ffi.NULL if scene.text is None else scene.text.encode()
        self._handle = ffi.NULL
        handle = lib.scree_create(scene.file.encode(), text, options, error)
        self._handle = handle  # also where nothing was made, and a force has seen what was to become of it
        self._pointer = ffi.new("struct scree_simulation **", handle)
        self._raise()
        check(handle != ffi.NULL, error)
        self._columns = [
            (ffi.string(lib.scree_column_name(handle, c)).decode(), ffi.string(lib.scree_column_unit(handle, c)).decode())
            for c in range(lib.scree_columns(handle))
        ]

    def _say(self, context, line):
        self._call(self._log, ffi.string(line).decode(errors="replace"))

    def _pull(self, context, handle):
        self._handle = handle  # the first forces come before scree_create returns
        self._call(self._force, self)

    def _call(self, function, argument):
        """Calls a function of the user from within C, unless one has failed already."""
        if self._raised is None:
            self._inside = True
            try:
                function(argument)
            except BaseException as raised:  # it passes through C and goes on in _raise
                self._raised = raised
            self._inside = False

    def _raise(self):
        raised, self._raised = self._raised, None
        if raised is not None:
            raise raised

    def _open(self):
        if self._handle == ffi.NULL:
            raise Error("the simulation is closed")
        return self._handle

    def close(self):
        """Frees the simulation; its arrays must not be used any more. With ranks: collective."""
        if getattr(self, "_inside", False):
            raise Error("a function that the simulation calls, as `force`, may not close it")
        if getattr(self, "_pointer", None) is not None:
            lib.scree_destroy(self._pointer)
            self._pointer, self._handle = None, ffi.NULL

    def __enter__(self):
        return self

    def __exit__(self, *unused):
        self.close()

    def __del__(self):
        self.close()

    # Time

    @property
    def step(self):
        """The number of the last step."""
        return lib.scree_step_number(self._open())

    @property
    def time(self):
        """The time at the end of the last step."""
        return lib.scree_time(self._open())

    @property
    def time_step(self):
        """The length of a step."""
        return lib.scree_time_step(self._open())

    @property
    def steps_left(self):
        """The number of steps to the end of the scene; with stages: to the end of the present one, at most."""
        return lib.scree_steps_left(self._open())

    @property
    def stage(self):
        """The name of the present stage; "" without stages, and after the last one."""
        return ffi.string(lib.scree_stage(self._open())).decode()

    def run(self, steps=None, callback=None, every=1, progress=False):
        """Runs `steps` steps; None: to the end of the scene. `callback(simulation)` is called after every `every` steps.
        `progress`: a line on standard error. An array from before is invalid then. No step is taken after the last of a
        scene with stages. Returns the simulation."""
        begun, chunk, first = time.monotonic(), 1, self.step
        steps = None if steps is None else whole(steps, "steps", 0, 1 << 62)
        every = whole(every, "every", 1, 1 << 62)
        if callback is not None and not callable(callback):
            raise Error(f"callback is a function, not {callback!r}")
        if self._inside:
            raise Error("a function that the simulation calls, as `force`, may not run it")
        while (left := self.steps_left if steps is None else first + steps - self.step) > 0:
            last = self.step + left
            if callback is not None:
                left = min(left, every - (self.step - first) % every)
            chunk = min(chunk, left)
            before, step = time.monotonic(), self.step
            self._advance(chunk)
            seconds = time.monotonic() - before
            if self.step == step:
                break
            if callback is not None and (self.step - first) % every == 0:
                callback(self)
            chunk = max(1, min(8 * chunk, int(chunk * _CHUNK / max(seconds, 1e-9))))
            if progress:
                self._tell(first, last, time.monotonic() - begun)
        if progress:
            print(file=sys.stderr)
        return self

    def _tell(self, first, last, seconds):
        """The line of progress; the end of a stage may be unknown."""
        target = f" of {last} ({(self.step - first) / max(last - first, 1):.0%})" if last < 1 << 60 else ""
        stage = f", stage {self.stage}" if self.stage else ""
        print(f"\r\033[Kstep {self.step}{target}{stage}, {seconds:.0f} s", end="", file=sys.stderr)

    def _advance(self, steps):
        error = ffi.new("struct scree_error *")
        good = lib.scree_step(self._open(), steps, error)
        self._raise()
        check(good, error)

    # Particles

    def field(self, name):
        """An array on the memory of a field ("torque", "angular_velocity", "temperature" ...; docs/output.md lists all),
        one row for each particle of this process. Writing changes the simulation. The next step makes the array invalid:
        take a copy of what should stay. Raises KeyError if the scene has no such field."""
        field = ffi.new("struct scree_field *")
        if not lib.scree_field(self._open(), name.encode(), field):
            raise KeyError(f"the scene has no field {name!r}; it has {', '.join(self.fields)}")
        kind = np.dtype((np.float64, np.int64, np.int32, np.uint8)[int(field.type)])
        shape, strides = (field.count, field.components), (field.stride, kind.itemsize)
        if field.count == 0:
            array = np.empty(shape, kind)
        else:
            bytes_used = (field.count - 1) * field.stride + field.components * kind.itemsize
            owner = ffi.gc(ffi.cast("char *", field.data), lambda data, keep=self: None)  # the array keeps the simulation
            array = np.ndarray(shape, kind, ffi.buffer(owner, bytes_used), 0, strides)
        return array[:, 0] if field.components == 1 else array

    @property
    def fields(self):
        """The names of all fields."""
        names, k = [], 0
        while (name := lib.scree_field_name(self._open(), k)) != ffi.NULL:
            names.append(ffi.string(name).decode())
            k += 1
        return names

    @property
    def position(self):
        """Positions relative to `origin`, the lower corner of the box: an array on the memory of the simulation (see
        field). After writing call `changed`."""
        return self.field("position")

    @property
    def velocity(self):
        """Velocities of half a step before, v(n - 1/2), which led to the positions (see field)."""
        return self.field("velocity")

    @property
    def radius(self):
        """Radii (see field). After writing call `changed`."""
        return self.field("radius")

    @property
    def force(self):
        """Forces at the positions (see field)."""
        return self.field("force")

    @property
    def id(self):
        """Ids, from 1: steps may bring the particles into another order, in which they keep their ids (see field)."""
        return self.field("id")

    def __len__(self):
        return lib.scree_particles(self._open())

    @property
    def origin(self):
        """The lower corner of the box, in the coordinates of the scene."""
        return np.array(list(lib.scree_box(self._open()).origin))

    @property
    def edge(self):
        """The edges of the box."""
        return np.array(list(lib.scree_box(self._open()).edge))

    @property
    def periodic(self):
        """The periodic directions of the box."""
        return np.array(list(lib.scree_box(self._open()).periodic))

    def changed(self):
        """Tells the simulation that positions or radii were written: the next step searches all pairs again."""
        lib.scree_changed(self._open())

    def add(
        self,
        position,
        radius,
        velocity=(0, 0, 0),
        angular_velocity=(0, 0, 0),
        density=0,
        material=0,
        group=0,
        shape=None,
        orientation=(0, 0, 0, 0),
    ):
        """Adds particles in the next step: `position` (n, 3) in the coordinates of the scene; the others have one value
        for all or one for each. `density` 0: that of the material; material and group are numbers in the scene.
        `shape`: the name of an entry of bodies, or a list of one for each; "": spheres; None: material and radius choose.
        `orientation`: quaternions w x y z of such bodies, of any length; all 0: as the entry says."""
        x = np.asarray(position, float)
        x = x.reshape(-1, 3) if x.size == 0 or x.shape == (3,) else x
        if x.ndim != 2 or x.shape[1] != 3:
            raise Error(f"position has the shape (n, 3), or (3,) for one particle, not {x.shape}")
        n = len(x)
        new = ffi.new("struct scree_particle[]", n)
        columns = [spread(radius, "radius", (n,), float), spread(density, "density", (n,), float)]
        columns += [spread(material, "material", (n,), int), spread(group, "group", (n,), int)]
        v, w = spread(velocity, "velocity", (n, 3), float), spread(angular_velocity, "angular_velocity", (n, 3), float)
        q, names = spread(orientation, "orientation", (n, 4), float), _names(shape, n)
        for k in range(n):
            new[k].position, new[k].velocity, new[k].angular_velocity = list(x[k]), list(v[k]), list(w[k])
            new[k].radius, new[k].density = float(columns[0][k]), float(columns[1][k])
            new[k].material = whole(columns[2][k], "material", 0, (1 << 31) - 1)
            new[k].group = whole(columns[3][k], "group", 0, (1 << 31) - 1)
            new[k].shape, new[k].orientation = names[k], list(q[k])
        error = ffi.new("struct scree_error *")
        check(lib.scree_add(self._open(), new, n, error), error)

    def delete(self, ids):
        """Deletes the particles with these ids in the next step."""
        numbers = np.atleast_1d(np.asarray(ids))
        if numbers.ndim != 1 or (numbers.size > 0 and numbers.dtype.kind not in "iu"):
            raise Error(f"ids are whole numbers in one row, not {ids!r}")
        numbers = np.ascontiguousarray(numbers, np.int64)
        lib.scree_delete(self._open(), ffi.from_buffer("int64_t[]", numbers), len(numbers))

    # Results

    def observe(self):
        """The observables of this moment: a pandas Series."""
        import pandas

        values, error = ffi.new("double[]", max(len(self._columns), 1)), ffi.new("struct scree_error *")
        check(lib.scree_observe(self._open(), values, error), error)
        return pandas.Series(list(values)[: len(self._columns)], [name for name, unit in self._columns], float)

    @property
    def observables(self):
        """The rows that `observables.every` of the scene asks for, so far: a pandas DataFrame with the columns of
        observables.csv. `attrs["units"]` has the units. Without such a key: one row, of this moment."""
        import pandas

        names = ["time"] + [name for name, unit in self._columns]
        count = lib.scree_rows(self._open())
        if count:
            memory = ffi.buffer(lib.scree_row(self._handle, 0), count * len(names) * 8)
            rows = np.frombuffer(memory).reshape(count, len(names)).copy()
        else:
            rows = np.array([[self.time, *self.observe()]])
        table = pandas.DataFrame(rows, columns=names)
        table.attrs["units"] = dict(self._columns, time="s")
        return table

    def report(self):
        """The report of the steps since the start, or since the present stage began, as a dict with the keys of report.json;
        `seconds` are those in `run` alone."""
        error = ffi.new("struct scree_error *")
        text = lib.scree_report(self._open(), error)
        check(text != ffi.NULL, error)
        return json.loads(ffi.string(text))

    def checkpoint(self, folder):
        """Writes FOLDER/checkpoint-STEP.h5, from which the program and `resume` go on; returns the path."""
        error = ffi.new("struct scree_error *")
        check(lib.scree_checkpoint(self._open(), os.fsencode(folder), error), error)
        return f"{os.fspath(folder)}/checkpoint-{self.step}.h5"

    @property
    def scene(self):
        """The effective scene as YAML, with all defaults."""
        return ffi.string(lib.scree_scene(self._open())).decode()
