"""Compare the benchmark of the engine with the frames of this report.

``mujoco_warp.testspeed`` of the installed release runs in its own process, on the lean
scene as MJCF. A keyframe contains the cube in the hand, and the frames start in the
same state. Each of the other ways to run differs from the next by one change, so that
together they explain the difference.
"""

import json
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from xml.etree.ElementTree import SubElement, fromstring, tostring

import mujoco
import mujoco_warp as mjw
import warp as wp

from experiments.facts.case import LEAN
from experiments.lab import scene_mjcf
from experiments.simulation.frame_benchmark import (
    EngineSteps,
    build_frames,
    time_columns,
    warm_state,
    world_rate,
)
from experiments.simulation.measurement import Conditions
from experiments.simulation.paired_timing import time_in_turn
from experiments.simulation.simulation import Simulation, captured
from experiments.simulation.timing import elapsed_ms

# Steps of the benchmark by the number of worlds.
STEP_COUNTS = {
    1: 1000,
    4096: 300,
    16384: 200,
}
# Approximate time limit for all ways to run one number of worlds [s].
CAP_S = 12.0
TIMEOUT_S = 300.0


def measure_ways(
    conditions: Conditions, world_count: int, step_count: int
) -> list[dict[str, object]]:
    """Return a row for the benchmark, and one row for each way to run."""
    warm = warm_state(conditions.device)
    whole = build_frames(LEAN, world_count, warm)
    simulation = whole.simulation
    warm.put(simulation, LEAN)
    simulation.step()
    wp.synchronize_device(warm.device)
    mjcf = with_keyframe(scene_mjcf(), simulation)
    bare, ours = Bare(mjcf, world_count, warm.device), simulation.solver.mjw_data
    # By name: the function that runs a frame, and the data with its contacts and rows.
    ways: dict[str, tuple[Callable[[int], float], mjw.Data]] = {
        "whole": (whole, ours),
        "each-step-waited-for": (lambda _: bare.frame_ms(bare.each_step), bare.data),
        "steps-in-one-graph": (lambda _: bare.frame_ms(bare.steps), bare.data),
        "collision-once": (
            lambda _: bare.frame_ms(bare.steps_collision_once),
            bare.data,
        ),
        "our-engine-steps": (EngineSteps(whole), ours),
    }
    about = {
        "worlds": world_count,
        "contact_max": LEAN.contact_max,
        "constraint_max": LEAN.constraint_max,
    }
    rows = [about | testspeed(mjcf, world_count, step_count)]
    results = time_in_turn([run for run, _ in ways.values()], cap_s=CAP_S)
    for (name, (_, data)), found in zip(ways.items(), results, strict=True):
        row = {
            "case": f"{name}-{world_count}",
            "way": name,
            **about,
            **time_columns(found),
        }
        counts = {
            "contact_count": data.nacon.numpy()[0] / world_count,
            "row_count": data.nefc.numpy().mean(),
        }
        row |= world_rate(LEAN, world_count, found) | {
            column: float(value) for column, value in counts.items()
        }
        rows.append(row)
    return rows


def with_keyframe(mjcf: str, simulation: Simulation) -> str:
    """Return the MJCF with the state of the first world as a keyframe.

    The time step is set to the substep.
    """
    root = fromstring(mjcf)
    data = simulation.solver.mjw_data
    [option] = root.findall("option")
    option.set("timestep", repr(simulation.substep_dt))
    state = {name: getattr(data, name).numpy()[0] for name in ("qpos", "qvel", "ctrl")}
    key = {
        name: " ".join(repr(float(value)) for value in values)
        for name, values in state.items()
    }
    SubElement(SubElement(root, "keyframe"), "key", key, name="in-the-hand")
    return tostring(root, encoding="unicode")


def testspeed(mjcf: str, world_count: int, step_count: int) -> dict[str, object]:
    """Run the benchmark and return its row.

    Raises:
        RuntimeError: The benchmark failed; the message contains the end of its output.
    """
    options = {
        "nworld": world_count,
        "nstep": step_count,
        "nconmax": LEAN.contact_max,
        "njmax": LEAN.constraint_max,
    }
    flags = [
        f"--{name}={value}"
        for name, value in (options | {"noise_std": 0.0, "format": "json"}).items()
    ]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "scene.xml")
        path.write_text(mjcf)
        call = [sys.executable, "-m", "mujoco_warp.testspeed", str(path), *flags]
        process = subprocess.run(
            call, capture_output=True, text=True, timeout=TIMEOUT_S, check=False
        )
    lines = [line for line in process.stdout.splitlines() if line.startswith("{")]
    if process.returncode or not lines:
        message = " ".join((process.stdout + process.stderr).split())[-300:]
        raise RuntimeError(
            f"mujoco_warp.testspeed failed with status {process.returncode}: {message}"
        )
    summary = json.loads(lines[-1])
    row = {
        "case": f"testspeed-{world_count}",
        "way": "testspeed",
        "step_count": step_count,
    }
    names = {
        "world_substeps_per_s": "steps_per_second",
        "contact_count": "ncon_mean",
        "row_count": "nefc_mean",
    }
    return row | {column: float(summary[name]) for column, name in names.items()}


class Bare:
    """Run only the engine on the MJCF in three ways, each as graphs.

    Each run takes the substeps of a frame from the keyframe.
    """

    def __init__(self, mjcf: str, world_count: int, device: wp.Device):
        model = mujoco.MjModel.from_xml_string(mjcf)
        state = mujoco.MjData(model)
        mujoco.mj_resetDataKeyframe(model, state, 0)
        self.device = device
        with wp.ScopedDevice(device):
            self.model = mjw.put_model(model)
            self.model.opt.warn_overflow = False
            sizes = {
                "nworld": world_count,
                "nconmax": LEAN.contact_max,
                "njmax": LEAN.constraint_max,
            }
            self.data = mjw.put_data(model, state, **sizes)
            arrays = (self.data.qpos, self.data.qvel, self.data.qacc_warmstart)
            self.state = [(array, wp.clone(array)) for array in arrays]
            self._step()  # compiles, which is not allowed during a capture
            self.step, self.steps, self.steps_collision_once = map(
                captured, (self._step, self._steps, self._steps_collision_once)
            )
        for run in (self.step, self.steps, self.steps_collision_once):
            # The first launch of a graph takes 20 ms more, and allocates memory.
            self.frame_ms(run)

    def each_step(self) -> None:
        """Run the steps of a frame and wait after each one, as the benchmark does."""
        for _ in range(LEAN.substeps):
            self.step()
            wp.synchronize_device(self.device)

    def frame_ms(self, run: Callable[[], None]) -> float:
        """Return the time of a frame's steps from the keyframe [ms]."""
        with wp.ScopedDevice(self.device):
            for array, start in self.state:
                wp.copy(array, start)
            return elapsed_ms(self.device, run)

    def _step(self) -> None:
        mjw.step(self.model, self.data)

    def _steps(self) -> None:
        for _ in range(LEAN.substeps):
            self._step()

    def _steps_collision_once(self) -> None:
        for substep in range(LEAN.substeps):
            self.model.opt.run_collision_detection = substep == 0
            self._step()
        self.model.opt.run_collision_detection = True
