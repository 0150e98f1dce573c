"""Run the same case several times with each setting that promises identical results."""

import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from inspect import signature

import mujoco_warp
import newton
import numpy as np
import warp as wp
from newton.solvers import SolverMuJoCo

from experiments.facts.case import AS_SHIPPED, Case
from experiments.facts.trace import Trace
from experiments.simulation.frame_benchmark import (
    BLOCK_FRAME_COUNT,
    TIMES,
    time_columns,
    untimed,
)
from experiments.simulation.measurement import (
    SETUP_FRAME_COUNT,
    Conditions,
    Measurement,
    absent,
    summarize,
)
from experiments.simulation.paired_timing import time_in_turn
from experiments.simulation.scene import Scene
from experiments.simulation.simulation import Simulation, run
from experiments.simulation.stepper import CONTACT_MAX
from experiments.simulation.stepper_c import MuJoCoStepper
from experiments.simulation.timing import (
    SHAKE_FRAME_COUNT,
    batch_invalid_reason,
    elapsed_ms,
    run_frames,
)
from measured_report.measuring.batch import Batch, Plan

SETTINGS = ("default", "contacts", "engine", "solver")
"""The parts that are deterministic.

In turn, these are: none, Newton's list of contacts, this list and MuJoCo Warp by its
own option, and both by the option of ``SolverMuJoCo``, which compiles the kernels of MuJoCo
Warp in another mode.
"""
RUN_COUNT = {"full": 3, "quick": 2}
FRAME_COUNT = 480
"""Number of frames, until about four seconds into the shake.

A whole run with a deterministic engine takes minutes.
"""
NUMBERS = ("identical_count", "slip_range_mm", "different_frame")


def measure(conditions: Conditions) -> Plan:
    """Return a row for each setting, and a row with its time if it compiles."""
    settings = [setting for setting in SETTINGS if is_offered(setting)]
    found = yield [
        Batch(f"runs-{setting}", measure_runs, (conditions, setting))
        for setting in settings
    ]
    rows = [row for rows in found for row in rows]
    # A setting that does not compile would leave its kernels behind, half built.
    timed = [row["setting"] for row in rows if row["identical_count"] is not None]
    [times] = yield [Batch("times", measure_times, (conditions, timed), exclusive=True)]
    return Measurement([*rows, *times])


def is_offered(setting: str) -> bool:
    """Return whether the release has the setting."""
    if setting == "engine":
        return hasattr(mujoco_warp, "DeterminismType")
    return setting != "solver" or "deterministic" in signature(SolverMuJoCo).parameters


class RepeatableStepper(MuJoCoStepper):
    """Step a batch with one of SETTINGS."""

    def __init__(self, setting: str, scene: Scene, cases: Sequence[Case]):
        self.setting = setting
        super().__init__(scene, cases)

    def _build_collision(self):
        pipeline = newton.CollisionPipeline(
            self.model,
            broad_phase=self.case.broad_phase,
            reduce_contacts=True,
            rigid_contact_max=self.world_count * CONTACT_MAX,
            deterministic=self.setting != "default",
        )
        return pipeline, pipeline.contacts()

    def _build_solver(self) -> SolverMuJoCo:
        with compiled_for(self.setting):
            solver = super()._build_solver()
        if self.setting == "engine":
            every = mujoco_warp.DeterminismType.ALL
            solver.mjw_model.opt.deterministic = int(every)
        return solver


@contextmanager
def compiled_for(setting: str) -> Iterator[None]:
    """Compile a solver without an option of its own as the setting requires."""
    if setting != "solver":
        yield
        return
    before = wp.config.deterministic
    wp.config.deterministic = wp.DeterministicMode.RUN_TO_RUN
    try:
        yield
    finally:
        wp.config.deterministic = before


class RepeatableSimulation(Simulation):
    def __init__(self, setting: str, cases: Sequence[Case], device: wp.Device):
        self.stepper_of = partial(RepeatableStepper, setting)
        super().__init__(cases, device)


def measure_runs(conditions: Conditions, setting: str) -> list[dict[str, object]]:
    """Return a row with the differences between several runs of the scene as shipped."""
    count, device = RUN_COUNT[conditions.profile], wp.get_device(conditions.device)
    frame_count = conditions.frame_count(FRAME_COUNT)
    case = replace(AS_SHIPPED, name=setting, frame_count=frame_count)
    row = {"case": setting, "setting": setting, "run_count": count}
    try:
        runs = [RepeatableSimulation(setting, [case], device) for _ in range(count)]
        traces = [trace for [trace] in run(runs, setting)]
    # A setting that does not compile is a result.
    except Exception as error:
        return [row | absent(("slip_mm", *NUMBERS), reason_of(error))]
    slips_mm = [summarize(case, trace)["slip_mm"] for trace in traces]
    if None in slips_mm:
        return [row | absent(("slip_mm", *NUMBERS), "the shake was never reached")]
    row |= {"slip_mm": slips_mm[0], "slip_range_mm": float(np.ptp(slips_mm))}
    return [row | differences_of(traces)]


def differences_of(traces: Sequence[Trace]) -> dict[str, object]:
    """Return how many further runs equal the first one, and the first frame that differs.

    All poses of all bodies are compared bit by bit. The sums of contact forces are not,
    because the recorder adds them in any order.
    """
    first, *others = (
        np.ascontiguousarray(trace.poses).reshape(len(trace.poses), -1).view(np.int32)
        for trace in traces
    )
    differing = [(other != first).any(axis=1) for other in others]
    frames = [int(differs.argmax()) for differs in differing if differs.any()]
    row: dict[str, object] = {"identical_count": len(others) - len(frames)}
    if not frames:
        return row | absent(["different_frame"], "all runs are identical")
    return row | {"different_frame": min(frames)}


def reason_of(error: Exception) -> str:
    """Return the name of a kernel that does not compile, if any, and the reason."""
    text = " ".join(str(error).split())
    kernel = re.search(r'parsing function "(\w+)"', text)
    cause = text.rpartition(";")[2][:160]
    return f"{kernel[1]}: {cause}" if kernel else cause


def measure_times(
    conditions: Conditions, settings: Sequence[str]
) -> list[dict[str, object]]:
    """Return a row for each setting, timed in turn with the default."""
    device, rows = wp.get_device(conditions.device), []
    reference = Blocks("default", device)
    for setting in settings:
        others = [Blocks(setting, device)] if setting != "default" else []
        blocks = [reference, *others]
        times = time_in_turn(blocks)[-1]
        invalid = batch_invalid_reason(blocks[-1].simulation)
        row = {"case": f"{setting}/time", "setting": setting, "worlds": 1}
        rows.append(row | (untimed(TIMES, invalid) if invalid else time_columns(times)))
    return rows


class Blocks:
    """Run blocks of frames from the shake."""

    def __init__(self, setting: str, device: wp.Device):
        case = replace(AS_SHIPPED, name="timed", frame_count=1)
        self.simulation = RepeatableSimulation(setting, [case], device)
        self.frame_count = BLOCK_FRAME_COUNT if device.is_cuda else 1
        run_frames(self.simulation, SETUP_FRAME_COUNT + SHAKE_FRAME_COUNT)

    def __call__(self, _: int) -> float:
        """Return the mean time of a frame in a block [ms]."""
        simulation, count = self.simulation, self.frame_count
        return (
            elapsed_ms(simulation.device, lambda: run_frames(simulation, count)) / count
        )
