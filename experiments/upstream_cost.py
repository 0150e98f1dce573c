"""What the patch for MuJoCo Warp costs: the engine alone, with the option that the patch adds off and on.

The patch is applied to a copy of the installed package. A process of its own finds that copy first and times the two in
turn; in this one, which has the released package, the kernels of the same frame are counted.
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from unittest import mock

import mujoco_warp as mjw
import numpy as np
import warp as wp

from experiments.facts.case import LEAN
from experiments.lab import scene_mjcf
from experiments.simulation.comparing import Pilot, time_columns
from experiments.simulation.measurement import Conditions, Measurement
from experiments.simulation.resolving import in_turn
from experiments.simulation.simulation import Simulation, captured
from experiments.testspeed import Bare, with_keyframe
from measured_report.files.root import ROOT
from measured_report.measuring.batch import Batch, Plan

NEEDS = "mujoco-warp==4.0.0"
"""Read by ``measured_report.editions.devices``: the release that the patch is for."""
PATCH = ROOT / "assets/upstream/mujoco_warp-4.0.0.patch"
WORLD_COUNTS = {"cuda": (1, 4096, 16384), "cpu": (1,)}
RESOLUTION = 0.002
"""One launch more in a hundred is to be seen."""
CAP_S = 5.0
"""Seconds that both ways take at most with one number of worlds, about."""
TIMEOUT_S = 300.0


def measure(conditions: Conditions) -> Plan:
    counts = WORLD_COUNTS["cuda" if conditions.is_cuda else "cpu"]
    [(mjcf, released)] = yield [Batch("compile", measure_released, (conditions,))]
    found = yield [
        Batch(f"worlds-{count}", measure_apart, (conditions, mjcf, count), exclusive=True) for count in counts
    ]
    return Measurement([released, *(row for rows in found for row in rows)])


def measure_released(conditions: Conditions) -> tuple[str, dict[str, object]]:
    """The scene as MJCF with the cube in the hand, and a row for the released package.

    What the patched one has not compiled yet is, before any time counts.
    """
    device = wp.get_device(conditions.device)
    case, pilot = replace(LEAN, frame_count=1), Pilot([LEAN], device)
    simulation = Simulation([case], device)
    pilot.put(simulation, case)
    simulation.step()
    wp.synchronize_device(device)
    mjcf = with_keyframe(scene_mjcf(), simulation)
    measure_apart(conditions, mjcf, 2)
    _, kernel_count = Steps(mjcf, 1, device).frame()
    return mjcf, {"case": "released", "way": "released", "worlds": 1, "kernel_count": kernel_count}


def measure_apart(conditions: Conditions, mjcf: str, world_count: int) -> list[dict[str, object]]:
    """What ``measure_ways`` finds in a process that imports the patched package.

    Raises:
        RuntimeError: The patch does not apply, or the process failed; with the end of what was said.
    """
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(Path(mjw.__file__).parent, Path(folder, mjw.__name__))
        apply(PATCH, Path(folder))
        path = os.pathsep.join([folder, str(ROOT), *filter(None, sys.path)])
        asked = {"mjcf": mjcf, "world_count": world_count, "device": conditions.device}
        answered = _run(
            [sys.executable, "-c", f"from {__name__} import {answer.__name__}; {answer.__name__}()"],
            cwd=folder,
            env={**os.environ, "PYTHONPATH": path},
            input=json.dumps(asked),
            timeout=TIMEOUT_S,
        )
    return json.loads(answered.splitlines()[-1])


def apply(patch: Path, folder: Path) -> None:
    """Apply a patch to the package in a folder; RuntimeError where it is for another release."""
    _run(["patch", "-p1", "--silent", "--forward", "--fuzz=0", f"--input={patch}"], cwd=folder)


def _run(call: list[str], **options) -> str:
    done = subprocess.run(call, capture_output=True, text=True, check=False, **options)
    if done.returncode:
        said = " ".join((done.stdout + done.stderr).split())[-300:]
        raise RuntimeError(f"{Path(call[0]).name} failed with status {done.returncode}: {said}")
    return done.stdout


def answer() -> None:
    """Measure what the process asks for that has started this one."""
    wp.config.enable_backward = False  # as where sections are measured, or kernels are compiled once more
    asked = json.load(sys.stdin)
    print(json.dumps(measure_ways(asked["mjcf"], asked["world_count"], wp.get_device(asked["device"]))))


def measure_ways(mjcf: str, world_count: int, device: wp.Device) -> list[dict[str, object]]:
    """A row for the option off and one for it on, both from the keyframe."""
    steps = Steps(mjcf, world_count, device)
    graphs, rows, asked = [], [], []
    for way, option in (("off", False), ("on", True)):
        steps.model.opt = replace(steps.model.opt, contact_jdotv=option)  # no field of the released package
        asked.append(steps.asked_m_s2())  # compiles, which must not happen inside a capture
        graph, kernel_count = steps.frame()
        graphs.append(graph)
        steps.frame_ms(graph)
        row = {"case": f"{way}-{world_count}", "way": way, "worlds": world_count, "substeps": LEAN.substeps}
        counts = {
            "contact_count": steps.data.nacon.numpy()[0] / world_count,
            "row_count": steps.data.nefc.numpy().mean(),
        }
        rows.append(row | {"kernel_count": kernel_count} | {name: float(count) for name, count in counts.items()})
    rows[1]["asked_change_m_s2"] = float(np.abs(asked[1] - asked[0]).max())
    blocks = [lambda _, graph=graph: steps.frame_ms(graph) for graph in graphs]
    results = in_turn(blocks, resolution=RESOLUTION, cap_s=CAP_S)
    return [row | time_columns(found) for row, found in zip(rows, results, strict=True)]


class Steps(Bare):
    """The engine alone, with its options as they are when a frame is captured."""

    def frame(self) -> tuple[Callable[[], None], int]:
        """What queues a frame's steps, and how many kernels are in them, those of a loop once.

        They share a graph of one step, as in the engine's own benchmark. What counts keeps the arrays of all launches,
        so that a graph of all steps would have memory for each: two take 13 GB of 4,096 worlds.
        """
        with (
            wp.ScopedDevice(self.device),
            mock.patch.object(wp, "launch", wraps=wp.launch) as plain,
            mock.patch.object(wp, "launch_tiled", wraps=wp.launch_tiled) as tiled,
        ):
            step = captured(self._step)

        def steps() -> None:
            for _ in range(LEAN.substeps):
                step()

        return steps, LEAN.substeps * (plain.call_count + tiled.call_count)

    def frame_ms(self, run: Callable[[], None]) -> float:
        """Time [ms] of a run from the keyframe."""
        return self._frame_ms(run)

    def asked_m_s2(self) -> np.ndarray:
        """The accelerations that the rows of the first world ask for in the keyframe, smallest first: rows have no
        order on a GPU."""
        self.frame_ms(self._step)
        return np.sort(self.data.efc.aref.numpy()[0, : self.data.nefc.numpy()[0]])
