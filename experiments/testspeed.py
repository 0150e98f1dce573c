"""The engine's own benchmark on our scene, beside our frames from the same state, and what lies between the two.

``mujoco_warp.testspeed`` of the installed release runs in a process of its own, on the lean scene as MJCF with a
keyframe of the cube in the hand. Between it and our frames lie a few ways to run, each a switch from the one before.
"""

import json
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext
from dataclasses import replace
from functools import partial
from pathlib import Path
from xml.etree.ElementTree import SubElement, fromstring, tostring

import mujoco
import mujoco_warp as mjw
import numpy as np
import warp as wp

from experiments.facts.case import LEAN
from experiments.lab import scene_mjcf
from experiments.simulation.comparing import Frames, Pilot, time_columns
from experiments.simulation.measurement import Conditions, Measurement
from experiments.simulation.resolving import in_turn
from experiments.simulation.simulation import Simulation, captured
from experiments.simulation.switches import SWITCHES
from experiments.simulation.timing import EngineSteps, elapsed_ms
from measured_report.measuring.batch import Batch, Plan

NEEDS_CUDA = "the engine's benchmark runs on CUDA devices only"
STEP_COUNTS = {1: 1000, 4096: 300, 16384: 200}
"""Steps that the benchmark runs, by the number of worlds."""
CAP_S = 12.0
"""Seconds that all ways to run with one number of worlds take at most, about."""
TIMEOUT_S = 300.0
READY = "ready\n"
WAITING = f"""
import sys, warp
from mujoco_warp import testspeed
warp.init()
print(end={READY!r}, flush=True)
sys.stdin.readline()
testspeed.main()
"""
"""The benchmark as a program that says that it is ready, and runs once it is sent a line."""


def measure(conditions: Conditions) -> Plan:
    if not conditions.is_cuda:
        return Measurement((yield [Batch("none", dict, ({"case": "none", "reason": NEEDS_CUDA},))]))
    yield [Batch("compile", measure_worlds, (conditions, 1, 2))]  # what is not compiled yet is, before any time counts
    found = yield [
        Batch(f"worlds-{count}", measure_worlds, (conditions, count, STEP_COUNTS[count]), exclusive=True)
        for count in STEP_COUNTS
    ]
    return Measurement([row for rows in found for row in rows])


def measure_worlds(conditions: Conditions, world_count: int, step_count: int) -> list[dict[str, object]]:
    """A row for the benchmark, and one for each way to run."""
    device = wp.get_device(conditions.device)
    pilot = Pilot([LEAN], device)
    case = replace(LEAN, frame_count=1)
    simulation = Simulation([case] * world_count, device)
    whole = Frames(simulation, case, pilot)
    pilot.put(simulation, case)
    simulation.step()
    wp.synchronize_device(device)
    mjcf = with_keyframe(scene_mjcf(), simulation)
    about = {"worlds": world_count, "contact_max": LEAN.contact_max, "constraint_max": LEAN.constraint_max}
    # Each way's frame, by name, with the engine whose contacts and rows it has.
    steps = EngineSteps(simulation) if device.is_cuda else None
    bare = Ways(mjcf, world_count, device)
    ways: dict[str, tuple[Callable[[int], float], mjw.Data]] = {
        "whole": (whole, simulation.solver.mjw_data),
        "each-step-waited-for": (bare.each_step, bare.data),
        "steps-in-one-graph": (bare.one_graph, bare.data),
        "collision-once": (bare.collision_once, bare.data),
    }
    if steps:

        def of_engine(number: int) -> float:
            pilot.put(simulation, case, number)
            return steps.frame_ms(whole.frame_count)

        ways["our-engine-steps"] = of_engine, simulation.solver.mjw_data
    for name in ("recording", "inverse-kinematics", "control", "collision"):
        ways[f"without-{name}"] = Frames(simulation, case, pilot, SWITCHES[name]), simulation.solver.mjw_data
    with testspeed(mjcf, world_count, step_count) if device.is_cuda else nullcontext(dict) as run_testspeed:
        said = run_testspeed()
        results = in_turn([run for run, _ in ways.values()], cap_s=CAP_S)
    rows: list[dict[str, object]] = []
    if said:
        row = {"case": f"testspeed-{world_count}", "way": "testspeed", "step_count": step_count, **about}
        row |= {"world_substeps_per_s": float(said["steps_per_second"])}
        rows.append(row | {"contact_count": float(said["ncon_mean"]), "row_count": float(said["nefc_mean"])})
    for (name, (_, data)), found in zip(ways.items(), results, strict=True):
        row = {"case": f"{name}-{world_count}", "way": name, **about, **time_columns(found)}
        row |= {"world_substeps_per_s": world_count * LEAN.substeps / (1e-3 * float(np.median(found.times)))}
        counts = {"contact_count": data.nacon.numpy()[0] / world_count, "row_count": data.nefc.numpy().mean()}
        rows.append(row | {column: float(value) for column, value in counts.items()})
    return rows


def with_keyframe(mjcf: str, simulation: Simulation) -> str:
    """Add the state of the first world as a keyframe, and the substep as the time step."""
    root = fromstring(mjcf)
    data = simulation.solver.mjw_data
    [option] = root.findall("option")
    option.set("timestep", repr(simulation.substep_dt))
    state = {name: getattr(data, name).numpy()[0] for name in ("qpos", "qvel", "ctrl")}
    key = {name: " ".join(repr(float(value)) for value in values) for name, values in state.items()}
    SubElement(SubElement(root, "keyframe"), "key", key, name="in-the-hand")
    return tostring(root, encoding="unicode")


@contextmanager
def testspeed(mjcf: str, world_count: int, step_count: int) -> Iterator[Callable[[], dict[str, float]]]:
    """Start the benchmark's process, which waits with the engine loaded, and yield what lets it run."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "scene.xml")
        path.write_text(mjcf)
        options = {
            "nworld": world_count,
            "nstep": step_count,
            "nconmax": LEAN.contact_max,
            "njmax": LEAN.constraint_max,
        }
        flags = [f"--{name}={value}" for name, value in (options | {"noise_std": 0.0, "format": "json"}).items()]
        call = [sys.executable, "-c", WAITING, str(path), *flags]
        pipes = dict.fromkeys(("stdin", "stdout", "stderr"), subprocess.PIPE)
        with subprocess.Popen(call, text=True, **pipes) as process:
            try:
                while process.stdout.readline() not in (READY, ""):
                    pass  # what the engine says of itself
                yield partial(_run, process)
            finally:
                process.kill()


def _run(process: subprocess.Popen) -> dict[str, float]:
    """Let the benchmark run; what it prints.

    Raises:
        RuntimeError: It failed, with the end of what it said.
    """
    found, error = process.communicate("\n", timeout=TIMEOUT_S)
    lines = [line for line in found.splitlines() if line.startswith("{")]
    if process.returncode or not lines:
        said = " ".join((found + error).split())[-300:]
        raise RuntimeError(f"mujoco_warp.testspeed failed with status {process.returncode}: {said}")
    return json.loads(lines[-1])


class Bare:
    """The engine alone on the MJCF, as the benchmark runs it, a frame's substeps at a time from the keyframe."""

    def __init__(self, mjcf: str, world_count: int, device: wp.Device):
        model = mujoco.MjModel.from_xml_string(mjcf)
        state = mujoco.MjData(model)
        mujoco.mj_resetDataKeyframe(model, state, 0)
        self.device = device
        with wp.ScopedDevice(device):
            self.model = mjw.put_model(model)
            self.model.opt.warn_overflow = False
            sizes = {"nworld": world_count, "nconmax": LEAN.contact_max, "njmax": LEAN.constraint_max}
            self.data = mjw.put_data(model, state, **sizes)
            arrays = (self.data.qpos, self.data.qvel, self.data.qacc_warmstart)
            self.state = [(array, wp.clone(array)) for array in arrays]
            self._step()  # compiles, which must not happen inside a capture

    def _step(self) -> None:
        mjw.step(self.model, self.data)

    def _steps(self) -> None:
        for _ in range(LEAN.substeps):
            self._step()

    def _frame_ms(self, run: Callable[[], None]) -> float:
        with wp.ScopedDevice(self.device):
            for array, start in self.state:
                wp.copy(array, start)
            return elapsed_ms(self.device, run)


class Ways(Bare):
    """Three ways to run these steps, each a graph that has been launched."""

    def __init__(self, mjcf: str, world_count: int, device: wp.Device):
        super().__init__(mjcf, world_count, device)
        with wp.ScopedDevice(device):
            self.step = captured(self._step)
            self.steps = captured(self._steps)
            self.steps_collision_once = captured(self._steps_collision_once)
        for run in (self.step, self.steps, self.steps_collision_once):
            self._frame_ms(run)  # the first launch of a graph takes 20 ms more, and memory

    def _steps_collision_once(self) -> None:
        for substep in range(LEAN.substeps):
            self.model.opt.run_collision_detection = substep == 0
            self._step()
        self.model.opt.run_collision_detection = True

    def each_step(self, _: int) -> float:
        """Time of a frame's steps [ms], each launched when the one before is done, as the benchmark does."""

        def run() -> None:
            for _ in range(LEAN.substeps):
                self.step()
                wp.synchronize_device(self.device)

        return self._frame_ms(run)

    def one_graph(self, _: int) -> float:
        """Time of the same steps as one graph [ms]."""
        return self._frame_ms(self.steps)

    def collision_once(self, _: int) -> float:
        """Time of the same with contacts found in the first step only [ms]."""
        return self._frame_ms(self.steps_collision_once)
