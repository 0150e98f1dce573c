"""Time frames of the shake, and compare cases in turn from the same states."""

import gc
from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np
import warp as wp

from experiments.facts.case import AS_SHIPPED, STIFF_PADS, Case, build_key
from experiments.simulation.measurement import absent
from experiments.simulation.paired_timing import (
    BATCH_COUNT,
    CAP_S,
    PairedTimes,
    pool_builds,
    time_in_turn,
)
from experiments.simulation.simulation import Simulation, captured
from experiments.simulation.timing import (
    ENGINE_ARRAYS,
    STATE_ARRAYS,
    TASK_ARRAYS,
    WARMUP_COUNT,
    batch_invalid_reason,
    buffer_bytes_per_world,
    elapsed_ms,
    in_the_shake,
    memory_bytes,
    put_in_state_of,
    run_frames,
    spread,
)
from measured_report.measuring.batch import is_out_of_memory

STATE_FRAME_STEP = 7
"""Frames between two start states.

Eight rounds then cover about one cycle of the shake.
"""
BLOCK_FRAME_COUNT = 4
"""Frames in a block with few worlds.

A block with many worlds has fewer frames because they are slow. On a CPU a block has
one frame.
"""
LARGE_BATCH = 8192  # a batch of this size or larger has one frame per block
BUILD_COUNT = {"cuda": 2, "cpu": 1}
"""How often each simulation that needs at most SHARE_AGAIN is built.

See ``paired_timing`` for the reason.
"""
# Share of a device's memory up to which a simulation is built again.
SHARE_AGAIN = 1 / 32
SHARE_BUILT = 1 / 8
"""Share of a device's memory that the cases after the first one may use.

If they need more, they are timed before the next cases are built.
"""
PADS = AS_SHIPPED, STIFF_PADS  # cases with the pads of the timed frames
RATIO = ("frame_ratio", "frame_ratio_p5", "frame_ratio_p95", "ratio_resolution")
"""Ratio of the frame time to the time of the reference, and half its interval."""
TIMES = ("frame_ms", "frame_ms_p5", "frame_ms_p95", *RATIO)
TIMED = (*TIMES, "buffer_bytes_per_world")


class WarmState:
    """The start states of blocks.

    In each round, all cases with the same pads start from the same state. Each round of
    ``paired_timing`` has its own state.
    """

    def __init__(self, device: wp.Device):
        self.device = device
        simulation = in_the_shake(PADS, device)
        self.states = []
        for _ in range(BATCH_COUNT):
            self.states.append(_state_of(simulation))
            run_frames(simulation, STATE_FRAME_STEP)

    def put(self, target: Simulation, case: Case, number: int = 0) -> None:
        """Put all worlds of ``target`` into the state of a case in this round."""
        world = [(pads.pad_ke, pads.pad_kd) for pads in PADS].index(
            (case.pad_ke, case.pad_kd)
        )
        put_in_state_of(target, self.states[number % BATCH_COUNT], world)


@cache
def warm_state(device: str) -> WarmState:
    """Return the warm states of a device, which are built once per process."""
    return WarmState(wp.get_device(device))


def _state_of(simulation: Simulation) -> Any:
    """Return a copy of the arrays that ``put_in_state_of`` reads."""

    def copied(holder: object, names: Sequence[str]) -> SimpleNamespace:
        return SimpleNamespace(
            **{name: wp.clone(getattr(holder, name)) for name in names}
        )

    wp.synchronize_device(simulation.device)
    state = SimpleNamespace(
        world_count=simulation.world_count,
        task=copied(simulation.task, TASK_ARRAYS),
        state=copied(simulation.state, STATE_ARRAYS),
        solver=SimpleNamespace(
            mjw_data=copied(simulation.solver.mjw_data, ENGINE_ARRAYS)
        ),
    )
    wp.synchronize_device(simulation.device)
    return state


class Clone(Simulation):
    """Build a simulation once more, with its own memory for changing state.

    The model and the collision pipeline are shared.
    """

    def __init__(self, of: Simulation):
        vars(self).update(vars(of))
        self.stream, self.stream_beside = (
            wp.Stream(self.device) if self.device.is_cuda else None for _ in range(2)
        )
        with wp.ScopedDevice(self.device):
            self.contacts = self.pipeline and self.pipeline.contacts()
            self._build_state()
        wp.synchronize_device(self.device)
        self._start_uncaptured()


class Frames:
    """Run a case in blocks of frames.

    Cases that differ only in RUN_TIME_FIELDS may share a simulation.
    """

    def __init__(self, simulation: Simulation, case: Case, warm: WarmState):
        self.simulation, self.case, self.warm = simulation, case, warm
        most = LARGE_BATCH // simulation.world_count if simulation.device.is_cuda else 1
        self.frame_count = max(1, min(BLOCK_FRAME_COUNT, most))
        simulation.vary(case)
        warm.put(simulation, case)
        run_frames(simulation, WARMUP_COUNT)
        self.parts = simulation.parts, simulation.part_beside
        self.reason = batch_invalid_reason(simulation)

    def __call__(self, number: int) -> float:
        """Return the mean time of a frame in the block of this round [ms]."""
        simulation = self.simulation
        simulation.parts, simulation.part_beside = self.parts
        self.warm.put(simulation, self.case, number)
        return (
            elapsed_ms(
                simulation.device, lambda: run_frames(simulation, self.frame_count)
            )
            / self.frame_count
        )

    def columns(self, found: PairedTimes) -> dict[str, object]:
        """Return the times, the ratio and the memory, or the reason if the frames are
        not valid.
        """
        if self.reason:
            return untimed(TIMED, self.reason)
        memory = buffer_bytes_per_world(
            self.simulation.solver, self.simulation.contacts
        )
        return time_columns(found) | {"buffer_bytes_per_world": memory}


class EngineSteps:
    """Time the engine's own steps in the frames of a case (CUDA only).

    CUDA events surround each ``mjw.step`` inside the graph of whole frames. The IK runs
    before the physics here, so that the engine has the device for itself.
    """

    def __init__(self, frames: Frames):
        self.frames = frames
        self.events: list[tuple[wp.Event, wp.Event]] = []
        simulation = frames.simulation
        solver, step = simulation.solver, simulation.solver._mujoco_warp_step

        def timed_step() -> None:
            start, end = (
                wp.Event(simulation.device, enable_timing=True) for _ in range(2)
            )
            self.events.append((start, end))
            wp.record_event(start)
            step()
            wp.record_event(end)

        command, physics, solve = (
            simulation.queue_targets,
            simulation.queue_physics,
            simulation.task.solve,
        )
        with wp.ScopedDevice(simulation.device), wp.ScopedStream(simulation.stream):
            solver._mujoco_warp_step = timed_step
            self.parts = [captured(command), captured(solve), captured(physics)]
            del solver._mujoco_warp_step

    def __call__(self, number: int) -> float:
        """Return the mean time of the engine's steps in a frame of this round [ms]."""
        frames, simulation, total = self.frames, self.frames.simulation, 0.0
        frames.warm.put(simulation, frames.case, number)
        with wp.ScopedDevice(simulation.device), wp.ScopedStream(simulation.stream):
            for _ in range(frames.frame_count):
                for part in self.parts:
                    part()
                wp.synchronize_device(simulation.device)
                total += sum(
                    wp.get_event_elapsed_time(start, end) for start, end in self.events
                )
        return total / frames.frame_count


def build_frames(
    case: Case, world_count: int, warm: WarmState, device: wp.Device | None = None
) -> Frames:
    """Return the frames of a case in this number of worlds.

    The default is the device of the warm states.
    """
    case = replace(case, frame_count=1)  # the recorder keeps only the last frame
    return Frames(Simulation([case] * world_count, device or warm.device), case, warm)


def time_columns(
    times: PairedTimes, name: str = "frame_ms", ratio: str = "frame_ratio"
) -> dict[str, Any]:
    """Return the columns of the time, the ratio and the resolution of the ratio.

    The percentiles of the ratio are taken over the rounds.
    """
    low, high = (float(value) for value in np.percentile(times.ratios, (5, 95)))
    row = spread(name, times.times) | {
        ratio: times.ratio,
        f"{ratio}_p5": low,
        f"{ratio}_p95": high,
    }
    return row | {"ratio_resolution": times.resolution}


def world_rate(case: Case, world_count: int, times: PairedTimes) -> dict[str, float]:
    """Return the number of substeps per second in all worlds together."""
    return {
        "world_substeps_per_s": world_count
        * case.substeps
        / (1e-3 * float(np.median(times.times)))
    }


def untimed(names: Sequence[str], reason: str) -> dict[str, object]:
    """Return the columns of times without values, with the reason."""
    return absent(names, f"not timed: {reason}")


def time_cases(
    cases: Sequence[Case], world_count: int, device: wp.Device, cap_s: float = CAP_S
) -> dict[str, dict]:
    """Time frames of the shake in ``world_count`` worlds, relative to the first case.

    Return the columns of each case by its name. If memory runs out or the frames are
    not valid, every number is None, with a reason. Cases that differ only in run-time
    fields share a simulation. As many simulations as fit into memory are built before
    any is timed, because building after timing makes all later frames of the process
    slower. Therefore, cases that need little memory should come first.
    """
    groups: dict[Case, list[Case]] = {}
    for case in cases:
        groups.setdefault(build_key(case), []).append(case)
    waiting, comparison = list(groups.values()), Comparison(cases, world_count, device)
    while waiting:
        gc.collect()  # frees the timed simulations, except for the reference
        built = comparison.build(waiting.pop(0))
        start = memory_bytes(device)
        while (
            waiting
            and memory_bytes(device) - start <= SHARE_BUILT * device.total_memory
        ):
            built += comparison.build(waiting.pop(0))
        comparison.time(built, cap_s)
        built.clear()
    return comparison.columns()


class Comparison:
    """Time the cases in turn with the first case, a few of them at a time."""

    def __init__(self, cases: Sequence[Case], world_count: int, device: wp.Device):
        self.first, self.world_count, self.device = cases[0], world_count, device
        self.warm = warm_state(device.alias)
        # The first build of the first case, after it was timed.
        self.reference: Frames | None = None
        # Columns by case of its first build, or the reason if there are none.
        self.rows: dict[str, dict] = {}
        self.builds: dict[str, list[PairedTimes]] = {}
        """Yields the builds of the first case, and of the cases that have other
        simulations.
        """

    def build(self, group: Sequence[Case]) -> list[Frames]:
        """Build the simulation of cases with the same ``build_key``.

        The first of them is built again if it needs little memory.
        """
        built: list[Frames] = []
        start = memory_bytes(self.device)
        try:
            simulation = Simulation(
                [replace(group[0], frame_count=1)] * self.world_count, self.device
            )
            built += [Frames(simulation, case, self.warm) for case in group]
            if (
                memory_bytes(self.device) - start
                <= SHARE_AGAIN * self.device.total_memory
            ):
                more = BUILD_COUNT["cuda" if self.device.is_cuda else "cpu"] - 1
                built += [
                    Frames(Clone(simulation), group[0], self.warm) for _ in range(more)
                ]
        except (RuntimeError, MemoryError) as error:
            if not is_out_of_memory(error):
                raise
            lost = absent(TIMED, " ".join(str(error).split())[:120])
            self.rows |= {case.name: lost for case in group[len(built) :]}
        self.rows |= {
            frames.case.name: untimed(TIMED, frames.reason)
            for frames in built
            if frames.reason
        }
        return [frames for frames in built if frames.case.name not in self.rows]

    def time(self, built: Sequence[Frames], cap_s: float) -> None:
        """Time the builds of all cases together, relative to the reference if possible."""
        if not built:
            return
        if self.reference is None and built[0].case is self.first:
            self.reference = built[0]
        reference = self.reference or built[0]
        together = [*([] if reference in built else [reference]), *built]
        results = time_in_turn(together, cap_s=cap_s * max(1, len(together) - 1))
        for frames, times in zip(together, results, strict=True):
            name, is_variant = (
                frames.case.name,
                frames is not reference and frames.simulation is reference.simulation,
            )
            # the reference keeps its first times
            if frames in built:
                self.rows.setdefault(name, frames.columns(times))
                if not is_variant:
                    self.builds.setdefault(name, []).append(times)

    def columns(self) -> dict[str, dict]:
        """Return the columns of each case, pooled over its builds."""
        together = zip(
            self.builds, pool_builds(list(self.builds.values())), strict=True
        )
        rows = self.rows | {
            name: self.rows[name] | time_columns(times) for name, times in together
        }
        if self.reference:
            return rows
        no_ratio = absent(RATIO, "what it is compared with has no time here")
        return {
            name: row if row["frame_ms"] is None else row | no_ratio
            for name, row in rows.items()
        }
