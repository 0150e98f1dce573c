"""Measure the error and the run time of the shake with different numerical settings."""

import os
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import Any

import numpy as np
import warp as wp

from experiments.error_runtime.settings import (
    FRAME_COUNT,
    PADS,
    Setting,
    native_of,
    reference_of,
    settings,
)
from experiments.facts import metrics
from experiments.facts.case import FIXED, Case, differences
from experiments.facts.trace import Trace
from experiments.simulation import frame_benchmark
from experiments.simulation.frame_benchmark import (
    Frames,
    WarmState,
    build_frames,
    untimed,
    warm_state,
)
from experiments.simulation.measurement import Conditions, Measurement, absent
from experiments.simulation.paired_timing import PairedTimes, time_in_turn
from experiments.simulation.reference import (
    NativeShake,
    Start,
    pilot_at_shake,
    starts_of,
)
from experiments.simulation.simulation import Simulation, run
from experiments.simulation.task import FRAME_RATE
from experiments.simulation.timing import (
    WARMUP_COUNT,
    elapsed_ms,
    invalid_reason,
    put_in_state_of,
)
from measured_report.measuring.batch import Batch, Plan

REFERENCE_SUBSTEPS = {"full": 1024, "quick": 128}
"""Number of substeps in the reference.

A second reference with half as many substeps shows how well it has converged.
"""
WORLD_COUNTS = {
    "cuda": (1, 4, 16, 64, 256, 1024, 4096, 16384),
    "cpu": (1, 4, 16, 64),
    "quick": (1, 4),
}
# Frames in C that are timed together. In half a cycle, the force on the cube takes all
# its values.
HALF_CYCLE = 30
CAP_S = 64.0  # time limit for the comparison of settings [s]
# Time limit for the numbers of worlds [s]. Times of C on a shared core never reach the
# resolution, so there must be a limit.
WORLDS_CAP_S = 10.0
# The setting with which all times are compared.
REFERENCE = "as-shipped/newton/substeps-16"
ERROR_COLUMNS = ("grasp_error_mm_per_cycle", "numerical_error_mm")
RATIO = ("time_ratio", "time_ratio_p5", "time_ratio_p95", "ratio_resolution")
TIME_COLUMNS = ("ms_per_s", "ms_per_s_p5", "ms_per_s_p95", *RATIO)
# The fixed scene in C on one core.
ONE_CORE = replace(
    FIXED,
    name="one-core",
    backend="mujoco",
    frame_count=FRAME_COUNT,
)


def measure(conditions: Conditions) -> Plan:
    by_pads = yield [
        Batch(f"points-{pads}", measure_points, (conditions, pads)) for pads in PADS
    ]
    rows = [row for point_rows in by_pads for row in point_rows]
    valid = [
        row["case"] for row in rows if row["valid"] and row["method"] != "reference"
    ]
    valid.sort(key=lambda name: name != REFERENCE)
    times, worlds = yield [
        Batch("times", measure_times, (conditions, valid), exclusive=True),
        Batch("worlds", measure_worlds, (conditions,), exclusive=True),
    ]
    return Measurement([row | times.get(row["case"], {}) for row in rows] + worlds)


def measure_points(conditions: Conditions, pads: str) -> list[dict]:
    """Return a row for each setting and reference with these pads, without times.

    All runs start in the same state of the shake.
    """
    device = wp.get_device(conditions.device)
    points = [
        point
        for point in settings(conditions.profile, cpu_too=conditions.is_cuda)
        if point.pads == pads
    ]
    finest = REFERENCE_SUBSTEPS[conditions.profile]
    references = list(
        dict.fromkeys(
            reference_of(point, n) for point in points for n in (finest, finest // 2)
        )
    )

    pilot = pilot_at_shake(PADS.values(), device)  # type: ignore[arg-type]  # they are iterated only once
    shakes = {
        point: in_warp(point, pilot, device) for point in points if not point.is_native
    }
    start = starts_by_pads(pilot, FRAME_COUNT)[pads]
    natives = {
        point: NativeShake(point.case, start)
        for point in (*references, *points)
        if point.is_native
    }
    # C runs on the CPU, in parallel with the GPU.
    with ThreadPoolExecutor(max(1, (os.cpu_count() or 1) - 1)) as pool:
        native_traces = pool.map(NativeShake.run, natives.values())
        traces = run_shakes(shakes)
        traces |= dict(zip(natives, native_traces, strict=True))

    rows = []
    for point in points:
        native = native_of(point)
        row = describe(point, traces[point], natives[native])
        row |= errors(traces[point], traces[reference_of(point, finest)])
        if not point.is_native:
            row |= number("c_difference_mm", distance_mm(traces[point], traces[native]))
            row["backend"] = backend_on(shakes[point].device)
        rows.append(
            row if row["valid"] else row | untimed(TIME_COLUMNS, row["invalid_reason"])
        )
    for point in references:
        if point.case.substeps == finest:
            # The error of the reference is its distance from the solution with twice
            # the step. The integrator has an order above one, so halving the step
            # removes more than half of the error. The remaining error is therefore
            # smaller than this distance.
            row = describe(point, traces[point], natives[point])
            row |= errors(traces[point], traces[reference_of(point, finest // 2)])
            rows.append(
                row
                | absent(
                    TIME_COLUMNS, "a reference runs beside others and is not timed"
                )
            )
    return rows


def starts_by_pads(pilot: Simulation, frame_count: int) -> Mapping[str, Start]:
    return dict(zip(PADS, starts_of(pilot, frame_count), strict=True))


def in_warp(point: Setting, pilot: Simulation, device: wp.Device) -> Simulation:
    """Return a setting as a simulation of one world at the start of the shake.

    It is compiled and captured.
    """
    simulation = Simulation(
        [point.case], wp.get_device(point.case.device) if point.case.device else device
    )
    world = list(PADS).index(point.pads)
    put_in_state_of(simulation, pilot, world)
    simulation.step()
    # The frame that was captured must not count.
    put_in_state_of(
        simulation,
        pilot,
        world,
    )
    simulation.recorder.cursor.zero_()
    wp.synchronize_device(simulation.device)
    return simulation


def backend_on(device: wp.Device) -> str:
    return "warp-cuda" if device.is_cuda else "warp-cpu"


def run_shakes(shakes: Mapping[Setting, Simulation]) -> dict[Setting, Trace]:
    """Run all frames of all settings, side by side on each device."""
    traces: dict[Setting, Trace] = {}
    for device in dict.fromkeys(shake.device.alias for shake in shakes.values()):
        mine = {
            point: shake
            for point, shake in shakes.items()
            if shake.device.alias == device
        }
        results = run(list(mine.values()), title=f"error_runtime on {device}")
        traces |= {point: trace for point, [trace] in zip(mine, results, strict=True)}
    return traces


def describe(point: Setting, trace: Trace, native: NativeShake) -> dict[str, Any]:
    """Return the columns that describe a setting, and whether its run is valid."""
    case, reason = point.case, invalid_reason(point.case, trace)
    return {
        "case": case.name,
        **differences(case),
        "backend": "mujoco-c",
        "pads": point.pads,
        "method": point.method,
        "knob": point.knob,
        "substeps": case.substeps,
        "substep_ms": 1e3 / FRAME_RATE / case.substeps,
        "timeconst_ms": 1e3 * native.pad_timeconst_s,
        "valid": reason is None,
        "invalid_reason": reason,
        "iteration_peak_count": trace.peak_iteration_count,
        "frame_count": len(trace.phase),
    }


def errors(trace: Trace, reference: Trace) -> dict[str, object]:
    """Return the grasp error and the numerical error of a run."""
    grasp = metrics.cycle_drift_mm(
        metrics.displacement(trace), PADS["as-shipped"].shake_frequency_hz
    )
    return number("grasp_error_mm_per_cycle", grasp) | number(
        "numerical_error_mm", distance_mm(trace, reference)
    )


def distance_mm(trace: Trace, other: Trace) -> float:
    """Return the distance between the cube's paths in two runs [mm].

    This is the root mean square over the shake, in the TCP frame.
    """
    paths = (
        metrics.relative_position(motion.poses, metrics.CUBE, metrics.TCP)
        for motion in (trace, other)
    )
    return metrics.distance_rms_mm(*paths)


def number(name: str, value: float) -> dict[str, object]:
    """Return a column, and the reason if its number does not exist."""
    return (
        {name: float(value)}
        if np.isfinite(value)
        else absent((name,), "the positions are not finite")
    )


def measure_times(
    conditions: Conditions, names: Sequence[str]
) -> dict[str, dict[str, object]]:
    """Return the columns with the times of the settings, by name.

    Frames of the settings are timed in turn and compared with the first setting.
    """
    device = wp.get_device(conditions.device)
    by_name = {
        point.case.name: point
        for point in settings(conditions.profile, cpu_too=conditions.is_cuda)
    }
    warm = warm_state(conditions.device)
    starts = starts_by_pads(
        pilot_at_shake(PADS.values(), device),  # type: ignore[arg-type]  # as above
        WARMUP_COUNT + HALF_CYCLE,
    )
    blocks = {name: blocks_of(by_name[name], warm, starts) for name in names}
    found = time_in_turn(list(blocks.values()), cap_s=CAP_S)
    columns = {
        name: time_columns(blocks[name].reason, each)
        for name, each in zip(names, found, strict=True)
    }
    if names[:1] == [REFERENCE]:
        return columns
    no_ratio = absent(RATIO, f"{REFERENCE} has no time here")
    return {name: row | no_ratio for name, row in columns.items()}


def blocks_of(
    point: Setting, warm: WarmState, starts: Mapping[str, Start]
) -> "Frames | NativeFrames":
    if point.is_native:
        return NativeFrames(point.case, starts[point.pads])
    return build_frames(
        point.case, 1, warm, point.case.device and wp.get_device(point.case.device)
    )


class NativeFrames:
    """Time blocks of frames in C.

    Each block is half a cycle from the start of the shake, after a few frames that are
    not timed.
    """

    def __init__(self, case: Case, start: Start, reason: str | None = None):
        self.shake = NativeShake(case, start)
        self.reason = reason

    def __call__(self, _: int) -> float:
        """Return the mean time of a frame in a block [ms]."""
        shake, start = self.shake, self.shake.start
        shake.data.qpos[:], shake.data.qvel[:] = start.qpos, start.qvel
        shake.data.qacc_warmstart[:] = start.qacc_warmstart
        shake.frame_index = 0
        self._run(WARMUP_COUNT)
        return (
            elapsed_ms(wp.get_device("cpu"), lambda: self._run(HALF_CYCLE)) / HALF_CYCLE
        )

    def _run(self, frame_count: int) -> None:
        for _ in range(frame_count):
            self.shake.frame()


def time_columns(reason: str | None, found: PairedTimes) -> dict[str, object]:
    """Return the wall time per simulated second and its ratio to the reference.

    Return the reason instead if the run is not valid.
    """
    if reason:
        return untimed(TIME_COLUMNS, reason)
    return frame_benchmark.time_columns(
        replace(found, times=FRAME_RATE * found.times), "ms_per_s", "time_ratio"
    )


def measure_worlds(conditions: Conditions) -> list[dict]:
    """Return a row for each number of worlds, and one for C on one core.

    All of them are timed in turn.
    """
    device = wp.get_device(conditions.device)
    warm = warm_state(conditions.device)
    start = starts_by_pads(pilot_at_shake(PADS.values(), device), FRAME_COUNT)["stiff"]  # type: ignore[arg-type]  # as above
    native = NativeFrames(
        ONE_CORE, start, invalid_reason(ONE_CORE, NativeShake(ONE_CORE, start).run())
    )
    counts = WORLD_COUNTS[
        "quick" if conditions.quick else "cuda" if conditions.is_cuda else "cpu"
    ]
    worlds = [
        build_frames(replace(FIXED, name=f"worlds-{count}"), count, warm)
        for count in counts
    ]
    one_core, *found = time_in_turn([native, *worlds], cap_s=WORLDS_CAP_S)

    def row_of(
        case: Case,
        backend: str,
        world_count: int,
        reason: str | None,
        times: PairedTimes,
    ) -> dict:
        row = {
            "case": case.name,
            **differences(case),
            "backend": backend,
            "method": "worlds",
            "worlds": world_count,
        }
        row |= {"valid": reason is None, "invalid_reason": reason}
        return (
            row
            | absent(ERROR_COLUMNS, "only the time is measured here")
            | time_columns(reason, times)
        )

    rows = [
        row_of(frames.case, backend_on(device), count, frames.reason, times)
        for count, frames, times in zip(counts, worlds, found, strict=True)
    ]
    return [*rows, row_of(ONE_CORE, "mujoco-c", 1, native.reason, one_core)]
