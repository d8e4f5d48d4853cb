# SPDX-License-Identifier: BSD-3-Clause
"""scree.Simulation: the same bits as the command line, arrays, callbacks, forces, mistakes."""

import json
import os
import subprocess

import numpy as np
import pytest
import scree

SCENE = {
    "units": "none",
    "reproducible": True,
    "threads": 2,
    "gravity": [0, 0, -1],
    "box": {"lower": [-3, -3, 0], "upper": [3, 3, 10]},
    "step": {"dt": 0.001, "count": 400},
    "materials": [{"name": "stone", "density": 1, "young": 3000, "poisson": 0.3}],
    "material_pairs": [{"restitution": 0.5, "friction": 0.5}],
    "walls": [{"name": "floor", "shape": "plane", "point": [0, 0, 0], "normal": [0, 0, 1]}],
    "particles": {
        "from": "random",
        "region": {"shape": "box", "lower": [-3, -3, 0], "upper": [3, 3, 6]},
        "count": 250,
        "sizes": {"law": "power", "min": 0.15, "max": 0.6, "exponent": -2},
        "velocity": [0.3, 0, -1],
    },
    "observables": {
        "every": 50,
        "list": [{"name": "momentum"}, {"name": "energy_kinetic"}, {"name": "position", "id": 5, "label": "five"}],
    },
    "output": {"checkpoint": {"at_end": True}},
}


def by_id(simulation, name):
    """A field in the order of the ids."""
    return simulation.field(name)[np.argsort(simulation.id)].copy()


def test_numbers_equal_those_of_the_command_line(tmp_path):
    simulation = scree.Simulation(SCENE)
    (tmp_path / "scene.yaml").write_text(simulation.scene)
    done = subprocess.run(
        [os.environ["SCREE"], "run", "scene.yaml", "-o", "out", "--quiet"], cwd=tmp_path, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    simulation.run()
    assert simulation.step == 400 and simulation.steps_left == 0
    table = simulation.observables
    lines = (tmp_path / "out/observables.csv").read_text().splitlines()
    assert [name.split("[")[0] for name in lines[0].split(",")] == list(table.columns)
    assert lines[1:] == [",".join("%.15g" % value for value in row) for row in table.to_numpy()]
    other = scree.Simulation(tmp_path / "scene.yaml", resume=tmp_path / "out/checkpoint-400.h5")
    for name in ("position", "velocity", "force", "angular_velocity"):
        assert np.array_equal(by_id(simulation, name), by_id(other, name)), name
    assert table.attrs["units"]["time"] == "s" and len(table) == 9
    report, wanted = simulation.report(), json.loads((tmp_path / "out/report.json").read_text())
    assert list(report) == list(wanted)
    for key in ("steps", "last_step", "time", "particles", "contacts", "law", "integrator", "classes", "seed"):
        assert report[key] == wanted[key], key
    assert other.report()["steps"] == 0 and 0 < report["seconds"] < report["seconds"] + report["seconds_setup"]


def test_a_report_is_of_the_present_stage():
    scene = dict(SCENE, stages=[{"name": "a", "duration": 0.02}, {"name": "b", "duration": 0.03}])
    scene["step"] = {"dt": 0.001}
    simulation = scree.Simulation(scene, log=lambda line: None)
    simulation.run(25)
    assert simulation.stage == "b" and simulation.report()["steps"] == 5


def test_arrays_are_the_memory_of_the_simulation():
    with scree.Simulation(scree.Scene(SCENE, set={"reproducible": False, "threads": 1})) as simulation:
        assert len(simulation) == 250 and simulation.position.shape == (250, 3) and simulation.radius.shape == (250,)
        assert simulation.position.base is not None and np.shares_memory(simulation.position, simulation.position)
        assert simulation.id.dtype == np.int64 and set(simulation.id) == set(range(1, 251))
        simulation.velocity[:] = 0
        assert np.all(simulation.velocity == 0)
        simulation.run(1)
        assert abs(simulation.velocity[:, 2]).max() > 0
        simulation.position[:, 2] += 0.5
        simulation.changed()
        highest = simulation.position[:, 2].max()
        simulation.run(1)
        assert abs(simulation.position[:, 2].max() - highest) < 0.05
        assert np.array_equal(simulation.origin, [-3, -3, 0]) and np.array_equal(simulation.edge, [6, 6, 10])
        with pytest.raises(KeyError, match="temperature.*position"):
            simulation.field("temperature")
    with pytest.raises(scree.Error, match="closed"):
        simulation.run(1)


def test_an_array_keeps_its_simulation():
    position = scree.Simulation(SCENE).position
    assert np.isfinite(position).all()


def test_callbacks_come_every_so_many_steps():
    seen = []
    scree.Simulation(SCENE).run(25, callback=lambda simulation: seen.append(simulation.step), every=10)
    assert seen == [10, 20]


def test_a_force_of_ones_own():
    scene = {key: SCENE[key] for key in ("units", "materials", "material_pairs", "box")}
    scene.update(step={"dt": 0.001}, duration=10, particles={"from": "single", "position": [1, 0, 5], "radius": 0.5})

    def pull(simulation):
        x = simulation.position + simulation.origin - [0, 0, 5]
        simulation.force[:] -= 4 * x / simulation.field("inverse_mass")[:, None]

    simulation = scree.Simulation(scene, force=pull)
    simulation.run(3000)
    assert abs(simulation.position[0, 0] - 3 - np.cos(2 * simulation.time)) < 1e-5


def test_failures_in_functions_of_the_user_come_back():
    def wrong(simulation):
        raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="mine"):
        scree.Simulation(SCENE, force=wrong)


def test_particles_come_and_go():
    simulation = scree.Simulation(SCENE)
    simulation.add([[0, 0, 9], [1, 1, 9]], radius=0.2, velocity=[0, 0, -1])
    simulation.delete([3, 5, 8])
    simulation.run(1)
    assert len(simulation) == 249 and 252 in simulation.id and 5 not in simulation.id
    with pytest.raises(scree.Error, match="outside of the box"):
        simulation.add([0, 0, 11], radius=0.1)


def test_bodies_come_and_go_as_a_whole():
    dumbbell = {"spheres": [{"centre": [-1, 0, 0], "radius": 1}, {"centre": [1, 0, 0], "radius": 1}]}
    two = {"sources": [{"from": "single", "position": [0, 0, z], "radius": 0.2} for z in (5, 7)]}
    simulation = scree.Simulation({**SCENE, "particles": two, "bodies": {"clumps": [dumbbell]}, "step": {"dt": 0.0002, "count": 400}})
    member = simulation.id[simulation.field("body") == 1][0]
    simulation.add([0, 0, 9], radius=0.3)
    simulation.delete([member])
    simulation.run(1)
    body, identity = simulation.field("body"), simulation.id
    assert sorted(identity[simulation.field("kind") == 3]) == [2, max(identity) - 2]
    assert sorted(body[body >= 0]) == [2, 2, max(identity) - 2, max(identity) - 2]


def test_rocks_come_by_their_shapes():
    cube = {"name": "cube", "vertices": [float(x) for k in range(8) for x in (k & 1, k >> 1 & 1, k >> 2)], "rounding": 0.05}
    slab = {"name": "slab", "vertices": [float(x) for k in range(8) for x in (3 * (k & 1), 2 * (k >> 1 & 1), k >> 2)], "rounding": 0.05}
    one = {"sources": [{"from": "single", "position": [0, 0, 5], "radius": 0.2, "shape": "cube"}]}
    simulation = scree.Simulation({**SCENE, "particles": one, "bodies": {"shapes": [cube, slab]}, "step": {"dt": 0.0002, "count": 400}})
    simulation.add([[0, 0, 2], [1, 1, 2], [2, 2, 2]], radius=0.3, shape=["slab", "cube", ""], orientation=[0, 0, 0, 2])
    simulation.run(1)
    ball = simulation.field("kind") == 0
    columns = (simulation.field(name)[ball] for name in ("rock_shape", "inverse_mass"))
    rock = {tuple(np.round(x, 2)): (s, 1 / w) for x, s, w in zip(simulation.position[ball] + simulation.origin, *columns)}
    assert rock[1, 1, 2][0] == 0 and abs(rock[1, 1, 2][1] / (4 / 3 * np.pi * 0.3**3) - 1) < 1e-12  # a source names cubes
    assert rock[0, 0, 2][0] == 1 and abs(rock[0, 0, 2][1] / (6 * (0.3 / 1.84095) ** 3) - 1) < 1e-4  # the radius of the ball
    assert rock[2, 2, 2][0] == -1
    body = simulation.field("kind") == 3
    slab_turn = simulation.field("orientation")[body & (simulation.field("body_part") == 1)][0]
    assert np.all(np.min(np.abs(np.abs(slab_turn)[:, None] - np.sqrt([0, 0.25, 0.5, 1])), axis=1) < 1e-12)  # along the axes
    wrong = (
        ({"shape": "brick"}, "no entry of bodies has the name 'brick'; allowed: cube, slab"),
        ({"orientation": [np.nan, 0, 0, 0]}, "orientation"),
        ({"shape": ["cube"] * 2}, "shape is a name"),
    )
    for words, what in wrong:
        with pytest.raises(scree.Error, match=what):
            simulation.add([0, 0, 8], radius=0.3, **words)


def test_ids_of_files_stand_beside_added_particles(tmp_path):
    (tmp_path / "rows.txt").write_text("id radius x y z\n7 0.3 1 1 1\n900 0.3 2 1 1\n")
    sources = [{"file": str(tmp_path / "rows.txt"), "format": "table"}, {"from": "single", "position": [0, 1, 1], "radius": 0.3}]
    simulation = scree.Simulation({**SCENE, "particles": {"sources": sources}})
    simulation.add([-1, 1, 1], radius=0.3)
    simulation.run(1)
    assert sorted(simulation.id) == [1, 7, 900, 901]


def test_mistakes_and_guards_are_told():
    said = []
    with pytest.raises(scree.Error, match="'mist'|mist") as raised:
        scree.Simulation({**SCENE, "mist": 1})
    assert raised.value.status == 2
    with pytest.raises(scree.Error, match="no/such.yaml"):
        scree.Simulation("no/such.yaml")
    weak = {"guards.overlap_bound": 1e-9, "guards.overlap": "warn", "guards.speed": "off"}
    scree.Simulation(scree.Scene(SCENE, set=weak), log=said.append).run(200)
    assert any("guards.overlap" in line for line in said)
    stops = scree.Simulation(scree.Scene(SCENE, set={**weak, "guards.overlap": "stop"}))
    with pytest.raises(scree.Error, match="overlap") as raised:
        stops.run(200)
    assert raised.value.status == 3


STAGES = {
    **{key: value for key, value in SCENE.items() if key not in ("step", "observables")},
    "step": {"dt": 0.001},
    "stages": [
        {"name": "fall", "every": 50, "until": [{"name": "centre", "component": "z", "at_most": 2.0}]},
        {"name": "open", "duration": 0.1, "set": {"walls[floor]": None, "observables.every": 25}},
        {"name": "tilt", "duration": 0.05, "set": {"gravity": [1, 0, -1]}},
    ],
    "observables": {
        "every": 50,
        "list": [{"name": "momentum"}, {"name": "energy_kinetic"}, {"name": "energy_elastic_normal"}, {"name": "centre"}],
    },
}


def test_stages_have_the_bits_of_the_command_line(tmp_path):
    said, seen = [], []
    simulation = scree.Simulation(STAGES, log=said.append, folder=tmp_path)
    (tmp_path / "scene.yaml").write_text(json.dumps(STAGES))
    done = subprocess.run(
        [os.environ["SCREE"], "run", "scene.yaml", "-o", "out", "--quiet"], cwd=tmp_path, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    assert simulation.stage == "fall" and simulation.steps_left > 1000000
    simulation.run(callback=lambda simulation: seen.append((simulation.step, simulation.stage)), every=7)
    ends = [stage["last"] for stage in json.loads((tmp_path / "out/report.json").read_text())["scene_stages"]]
    assert simulation.step == ends[2] and simulation.steps_left == 0 and simulation.stage == ""
    assert ends[0] % 50 == 1 and [b - a for a, b in zip(ends, ends[1:])] == [100, 50]
    assert {stage for step, stage in seen} == {"fall", "open", "tilt"}
    assert all((stage == "fall") == (step < ends[0]) for step, stage in seen)
    assert [line.split("'")[1] for line in said if line.startswith("stage")] == ["fall", "open", "tilt"]
    table = simulation.observables
    lines = (tmp_path / "out/observables.csv").read_text().splitlines()
    assert lines[1:] == [",".join("%.15g" % value for value in row) for row in table.to_numpy()]
    run = contents(tmp_path / "out", ends[2])
    assert len(run) > 15 and run == contents(tmp_path, ends[2])
    assert simulation.run(5).step == ends[2]  # no stage is left


def test_a_condition_of_a_stage_looks_at_the_end_of_its_step():
    # many grains far from the floor, which nobody looks at in between: the condition holds just after step 35, not in it
    scene = {
        **STAGES,
        "reproducible": False,
        "observables": {"every": 100000, "list": STAGES["observables"]["list"]},
        "particles": {"from": "lattice", "lattice": "sc", "spacing": 0.5, "region": {"shape": "box", "lower": [-2.5, -2.5, 5], "upper": [2.5, 2.5, 9]}, "sizes": 0.2},
    }
    heights = []
    free = scree.Simulation({key: value for key, value in scene.items() if key != "stages"} | {"step": {"dt": 0.001, "count": 100}})
    for _ in range(36):
        heights.append(free.run(1).observe()["centre_z"])
    until = {"name": "centre", "component": "z", "at_most": (heights[34] + heights[35]) / 2}
    scene["stages"] = [{"name": "fall", "every": 7, "until": [until]}]
    simulation = scree.Simulation(scene).run()
    assert simulation.step == 43  # the step after the look at 42


def contents(folder, step):
    """Name, bytes and checksum of each dataset of a checkpoint, without the texts that name the run, and the sums, which are
    those of the steps that somebody looks at."""
    with open(folder / f"checkpoint-{step}.h5", "rb") as file:
        rows = [line.split() for line in file.read(8192).decode(errors="ignore").splitlines() if line.startswith("dataset ")]
    return {row[1]: (row[3], row[5]) for row in rows if not any(word in row[1] for word in ("scene", "lineage", "sums"))}


def test_stages_go_on_from_a_checkpoint_and_are_observed_at_their_ends(tmp_path):
    whole = scree.Simulation(STAGES, log=lambda line: None, folder=tmp_path)
    while whole.stage == "fall":
        whole.run(1)
    first = whole.step
    end = whole.observe()
    assert end["energy_elastic_normal"] > 0  # of the end of the stage, not of the beginning of the next one
    assert (tmp_path / f"checkpoint-{first}.h5").exists()
    part = scree.Simulation(STAGES, log=lambda line: None, resume=tmp_path / f"checkpoint-{first}.h5")
    assert part.stage == "open" and part.step == first
    whole.run(), part.run()
    assert whole.step == part.step == first + 150
    assert np.array_equal(by_id(whole, "position"), by_id(part, "position"))
    with pytest.raises(scree.Error, match="all 3 stages are over"):
        scree.Simulation(STAGES, resume=tmp_path / f"checkpoint-{whole.step}.h5")


def test_observables_without_rows_are_those_of_now():
    scene = {key: value for key, value in SCENE.items() if key != "observables"}
    simulation = scree.Simulation(scene).run(5)
    table = simulation.observables
    assert len(table) == 1 and table["time"][0] == simulation.time and table["energy_kinetic"][0] > 0
    assert simulation.observe()["energy_kinetic"] == table["energy_kinetic"][0]


def test_arguments_are_looked_at():
    simulation = scree.Simulation(SCENE)
    x = [0, 0, 9]
    for wrong, said in [
        (lambda: simulation.run(-1), "steps"),
        (lambda: simulation.run(1.5), "steps"),
        (lambda: simulation.run("1"), "steps"),
        (lambda: simulation.run(1, callback=print, every=0), "every"),
        (lambda: simulation.run(1, callback=3), "callback"),
        (lambda: simulation.delete([1.5]), "ids"),
        (lambda: simulation.delete([[1, 2]]), "ids"),
        (lambda: simulation.delete(["1"]), "ids"),
        (lambda: simulation.add([[0, 0], [1, 1]], radius=0.1), "position"),
        (lambda: simulation.add(5, radius=0.1), "position"),
        (lambda: simulation.add(x, radius=[0.1, 0.2]), "radius"),
        (lambda: simulation.add(x, radius=np.nan), "finite"),
        (lambda: simulation.add(x, radius=-1), "radius"),
        (lambda: simulation.add(x, radius=1e-120), "mass"),
        (lambda: simulation.add([0, 0, np.nan], radius=0.1), "finite"),
        (lambda: simulation.add(x, radius=0.1, material=0.5), "material"),
        (lambda: simulation.add(x, radius=0.1, material=-1), "material"),
        (lambda: simulation.add(x, radius=0.1, material=1 << 40), "material"),
        (lambda: simulation.add(x, radius=0.1, group=7), "group"),
        (lambda: simulation.add(x, radius=0.1, velocity=[1, 2]), "velocity"),
        (lambda: simulation.checkpoint("no/such/folder"), "no/such/folder"),
        (lambda: scree.Simulation(SCENE, force=1), "force"),
    ]:
        with pytest.raises(scree.Error, match=said):
            wrong()
    simulation.add([], radius=0.1)
    simulation.delete([])
    simulation.run(0)
    simulation.run(1)
    assert simulation.step == 1 and len(simulation) == 250


@pytest.mark.parametrize("name", ["run", "close", "observe", "checkpoint"])
@pytest.mark.parametrize("late", [False, True])
def test_what_a_force_may_not_do_is_refused(tmp_path, name, late):
    def force(simulation):
        simulation.columns = simulation.fields, len(simulation), simulation.steps_left, simulation.scene, simulation.stage
        if simulation.step >= late * 2:
            getattr(simulation, name)(*([tmp_path] if name == "checkpoint" else []))

    with pytest.raises(scree.Error, match="a function that the simulation calls|still being made"):
        scree.Simulation(SCENE, force=force).run(3)


def test_a_force_that_is_no_number_stops_the_simulation():
    def force(simulation):
        simulation.force[7] = np.nan

    with pytest.raises(scree.Error, match="guards.nan: .* of particle ") as raised:
        scree.Simulation(SCENE, force=force).run(3)
    assert raised.value.status == 3


def test_a_simulation_that_failed_or_is_closed_has_nothing():
    kept = []

    def force(simulation):
        kept.append(simulation)
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        scree.Simulation(SCENE, force=force)
    simulation = scree.Simulation(SCENE)
    simulation.close()
    simulation.close()
    for call in (lambda: simulation.step, lambda: simulation.run(1), lambda: simulation.field("radius"), lambda: len(simulation)):
        with pytest.raises(scree.Error, match="closed"):
            call()
