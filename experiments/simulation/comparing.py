"""Times of frames of the shake, cases compared in turn in one process, all from the state that a pilot is in."""

import gc
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import warp as wp

from experiments.facts.case import AS_SHIPPED, Case, build_key
from experiments.simulation.measurement import SETUP_FRAME_COUNT, absent
from experiments.simulation.recorder import Recorder
from experiments.simulation.resolving import BATCH_COUNT, CAP_S, Resolved, in_turn, of_builds
from experiments.simulation.simulation import Simulation
from experiments.simulation.task import build_task
from experiments.simulation.timing import (
    ENGINE_ARRAYS,
    SHAKE_FRAME_COUNT,
    STATE_ARRAYS,
    TASK_ARRAYS,
    WARMUP_COUNT,
    batch_invalid_reason,
    buffer_bytes_per_world,
    elapsed_ms,
    memory_bytes,
    put_in_state_of,
    spread,
)
from measured_report.measuring.error_text import is_out_of_memory

MOMENT_FRAME_STEP = 7
"""Frames from one state that blocks start from to the next, so that eight rounds see about a cycle of the shake."""
BLOCK_FRAME_COUNT = 4
"""Frames of a block of few worlds; one of many, whose frames take long, has fewer, and one on a CPU has one."""
LARGE_BATCH = 8192
"""From so many worlds on a block is one frame."""
BUILD_COUNT = {"cuda": 2, "cpu": 1}
"""How often each simulation is built that takes no more than ``SHARE_AGAIN``: see ``of_builds``."""
SHARE_AGAIN = 1 / 32
"""Share of a device's memory up to which a simulation is built again."""
SHARE_BUILT = 1 / 8
"""The same of what is built for one comparison beside the first: once it takes more, it is timed before more is."""
RATIO = ("frame_ratio", "frame_ratio_p5", "frame_ratio_p95", "ratio_resolution")
"""Time of a frame over that of the case that it is compared with, and half of the interval of this ratio."""
TIMES = ("frame_ms", "frame_ms_p5", "frame_ms_p95")
TIMED = (*TIMES, *RATIO, "buffer_bytes_per_world")


class Pilot:
    """The states that blocks start from: in each round all cases with the same pads start from the same.

    There are as many as ``resolving`` takes rounds in which each is seen once.
    """

    def __init__(self, cases: Sequence[Case], device: wp.Device):
        self.device = device
        self.pads = list(dict.fromkeys((case.pad_ke, case.pad_kd) for case in cases))
        worlds = [replace(AS_SHIPPED, frame_count=1, pad_ke=ke, pad_kd=kd) for ke, kd in self.pads]
        simulation = Simulation(worlds, device)
        _run(simulation, SETUP_FRAME_COUNT + SHAKE_FRAME_COUNT)
        self.moments = []
        for _ in range(BATCH_COUNT):
            self.moments.append(_moment_of(simulation))
            _run(simulation, MOMENT_FRAME_STEP)

    def put(self, target: Simulation, case: Case, number: int = 0) -> None:
        """Put all worlds of ``target`` where the case starts in the round of that number."""
        world = self.pads.index((case.pad_ke, case.pad_kd))
        put_in_state_of(target, self.moments[number % BATCH_COUNT], world)


def _run(simulation: Simulation, frame_count: int) -> None:
    for _ in range(frame_count):
        simulation.step()


def _moment_of(simulation: Simulation) -> Any:
    """What ``put_in_state_of`` reads of a simulation, as it is now."""
    wp.synchronize_device(simulation.device)

    def kept(holder: object, names: Sequence[str]) -> SimpleNamespace:
        return SimpleNamespace(**{name: wp.clone(getattr(holder, name)) for name in names})

    moment = SimpleNamespace(
        world_count=simulation.world_count,
        task=kept(simulation.task, TASK_ARRAYS),
        state=kept(simulation.state, STATE_ARRAYS),
        solver=SimpleNamespace(mjw_data=kept(simulation.solver.mjw_data, ENGINE_ARRAYS)),
    )
    wp.synchronize_device(simulation.device)
    return moment


class Again(Simulation):
    """The same simulation once more: all that a frame changes has memory of its own, model and collision are shared."""

    def __init__(self, of: Simulation):
        vars(self).update(vars(of))
        self.stream, self.stream_beside = (wp.Stream(self.device) if self.device.is_cuda else None for _ in range(2))
        with wp.ScopedDevice(self.device):
            self.task = build_task(self.scene, self.cases)
            self._start_at_approach_pose()
            self.contacts = self.pipeline and self.pipeline.contacts()
            self.solver = self._build_solver()
            self.recorder = Recorder(self.scene, self.solver, self.contacts, self.world_count, self.case.frame_count)
        wp.synchronize_device(self.device)
        self._start_uncaptured()


class Frames:
    """Blocks of frames of a case, which may share a simulation with others that differ in RUN_TIME_FIELDS only.

    Args:
        switch: What is in force while the frames are captured.
    """

    def __init__(
        self,
        simulation: Simulation,
        case: Case,
        pilot: Pilot,
        switch: Callable[[Simulation], AbstractContextManager] = nullcontext,
    ):
        self.simulation, self.case, self.pilot = simulation, case, pilot
        most = LARGE_BATCH // simulation.world_count if simulation.device.is_cuda else 1
        self.frame_count = max(1, min(BLOCK_FRAME_COUNT, most))
        simulation.vary(case)
        pilot.put(simulation, case)
        with switch(simulation):
            _run(simulation, WARMUP_COUNT)
        self.parts = simulation.parts, simulation.part_beside
        self.reason = batch_invalid_reason(simulation)

    def __call__(self, number: int) -> float:
        """Time of a frame [ms], mean of the block of the round of that number."""
        simulation = self.simulation
        simulation.parts, simulation.part_beside = self.parts
        self.pilot.put(simulation, self.case, number)
        return elapsed_ms(simulation.device, lambda: _run(simulation, self.frame_count)) / self.frame_count

    def columns(self, found: Resolved) -> dict[str, object]:
        """Times, ratio and memory; None, with the reason, where the frames do not count."""
        if self.reason:
            return absent(TIMED, f"not timed: {self.reason}")
        memory = buffer_bytes_per_world(self.simulation.solver, self.simulation.contacts)
        return time_columns(found) | {"buffer_bytes_per_world": memory}


def time_columns(found: Resolved, name: str = "frame_ms", ratio: str = "frame_ratio") -> dict[str, object]:
    """Times as ``spread`` says them, and the ratio with its resolution; the ratios' spread is from round to round."""
    low, high = (float(value) for value in np.percentile(found.ratios, (5, 95)))
    row = spread(name, found.times) | {ratio: found.ratio, f"{ratio}_p5": low, f"{ratio}_p95": high}
    return row | {"ratio_resolution": found.resolution}


def time_cases(cases: Sequence[Case], world_count: int, device: wp.Device, cap_s: float = CAP_S) -> dict[str, dict]:
    """Time frames of the shake in ``world_count`` worlds against the first case; columns by case.

    Where memory runs out or the frames do not count, every number is None, with the reason. What differs only in how it
    is run shares a simulation. As many as have room are built before one is timed: they wait for one turn, and all
    frames of a process that builds after it has timed take longer from then on (docs/cluster.md). So what takes little
    memory should stand first.
    """
    groups: dict[Case, list[Case]] = {}
    for case in cases:
        groups.setdefault(build_key(case), []).append(case)
    waiting, comparison = list(groups.values()), Comparison(cases, world_count, device)
    while waiting:
        gc.collect()  # frees what was timed, but for the reference
        built = comparison.build(waiting.pop(0))
        start = memory_bytes(device)
        while waiting and memory_bytes(device) - start <= SHARE_BUILT * device.total_memory:
            built += comparison.build(waiting.pop(0))
        comparison.time(built, cap_s)
        built.clear()
    return comparison.columns()


class Comparison:
    """Cases timed in turn against the first of them, some at a time."""

    def __init__(self, cases: Sequence[Case], world_count: int, device: wp.Device):
        self.first, self.world_count, self.device = cases[0], world_count, device
        self.pilot = Pilot(cases, device)
        self.reference: list[Frames] = []
        """The first build of the first case, once it is timed."""
        self.rows: dict[str, dict] = {}
        """Columns by case: those of its first build, or why it has none."""
        self.builds: dict[str, list[Resolved]] = {}
        """What was found of the first case, and of those that have other simulations than it."""

    def build(self, group: Sequence[Case]) -> list[Frames]:
        """Build what cases with the same ``build_key`` share, the first of them again where it takes little memory."""
        built: list[Frames] = []
        start = memory_bytes(self.device)
        try:
            simulation = Simulation([replace(group[0], frame_count=1)] * self.world_count, self.device)
            built += [Frames(simulation, case, self.pilot) for case in group]
            if memory_bytes(self.device) - start <= SHARE_AGAIN * self.device.total_memory:
                more = BUILD_COUNT["cuda" if self.device.is_cuda else "cpu"] - 1
                built += [Frames(Again(simulation), group[0], self.pilot) for _ in range(more)]
        except (RuntimeError, MemoryError) as error:
            if not is_out_of_memory(error):
                raise
            lost = absent(TIMED, " ".join(str(error).split())[:120])
            self.rows |= {case.name: lost for case in group[len(built) :]}
        return built

    def time(self, built: Sequence[Frames], cap_s: float) -> None:
        """Time what is built, all of a case's builds at once; without a reference each alone, and it has no ratio."""
        for frames in built:
            if frames.reason:
                self.rows[frames.case.name] = absent(TIMED, f"not timed: {frames.reason}")
        timed = [frames for frames in built if frames.case.name not in self.rows]
        both = [*self.reference, *timed]
        if not self.reference:
            self.reference = [frames for frames in timed[:1] if frames.case is self.first]
        if not self.reference:
            no_ratio = absent(RATIO, "what it is compared with has no time here")
            for frames in timed:
                self.rows[frames.case.name] = frames.columns(in_turn([frames], cap_s=cap_s)[0]) | no_ratio
            return
        [reference] = self.reference
        for frames, found in zip(both, in_turn(both, cap_s=cap_s * max(1, len(both) - 1)), strict=True):
            if frames in timed:  # or it is the reference, which keeps its first times
                self.rows.setdefault(frames.case.name, frames.columns(found))
                if frames is reference or frames.simulation is not reference.simulation:
                    self.builds.setdefault(frames.case.name, []).append(found)

    def columns(self) -> dict[str, dict]:
        """Columns by case, of all of its builds."""
        together = zip(self.builds, of_builds(list(self.builds.values())), strict=True)
        return self.rows | {name: self.rows[name] | time_columns(found) for name, found in together}
