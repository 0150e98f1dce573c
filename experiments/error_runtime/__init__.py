"""Error against run time: what each numerical setting makes of the same shake, and how long it takes."""

import os
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import warp as wp

from experiments.error_runtime.settings import FRAME_COUNT, PADS, Setting, native_of, reference_of, settings
from experiments.facts import metrics
from experiments.facts.case import FIXED, Case, differences
from experiments.facts.trace import Trace
from experiments.simulation import comparing
from experiments.simulation.comparing import Frames, Pilot
from experiments.simulation.measurement import Conditions, Measurement, absent
from experiments.simulation.reference import NativeShake, Start, pilot_at_shake, starts_of
from experiments.simulation.resolving import Resolved, in_turn
from experiments.simulation.simulation import Simulation, run
from experiments.simulation.task import FRAME_RATE
from experiments.simulation.timing import WARMUP_COUNT, elapsed_ms, invalid_reason, put_in_state_of
from measured_report.measuring.batch import Batch, Plan

REFERENCE_SUBSTEPS = {"full": 1024, "quick": 128}
"""Of the reference; a second one with half as many tells how far it has converged."""
WORLD_COUNTS = {"cuda": (1, 4, 16, 64, 256, 1024, 4096, 16384), "cpu": (1, 4, 16, 64), "quick": (1, 4)}
HALF_CYCLE = 30
"""Frames in C that are timed together: as long as the force on the cube takes to have had all its sizes."""
PART_COUNT = 4
"""Parts of the settings, each timed in turn by itself, so that one can be built while another is timed."""
CAP_S = 16.0
"""Seconds after which the settings of a part are not looked at again."""
WORLDS_CAP_S = 10.0
"""The same of the numbers of worlds, since C on a core that others share is never known to the resolution."""
REFERENCE = "as-shipped/newton/substeps-16"
"""What the time of each setting is compared with."""
ERROR_COLUMNS = ("grasp_error_mm_per_cycle", "numerical_error_mm")
RATIO = ("time_ratio", "time_ratio_p5", "time_ratio_p95", "ratio_resolution")
TIME_COLUMNS = ("ms_per_s", "ms_per_s_p5", "ms_per_s_p95", *RATIO)
ONE_CORE = replace(FIXED, name="one-core", backend="mujoco", frame_count=FRAME_COUNT)
"""The fixed scene in C on one core."""


def measure(conditions: Conditions) -> Plan:
    by_pads = yield [Batch(f"points-{pads}", measure_points, (conditions, pads)) for pads in PADS]
    rows = [row for found in by_pads for row in found]
    valid = [row["case"] for row in rows if row["valid"] and row["method"] != "reference"]
    reference = [REFERENCE] if REFERENCE in valid else []
    others = [name for name in valid if name != REFERENCE]
    parts = [reference + others[number::PART_COUNT] for number in range(min(PART_COUNT, len(others)))]
    *found, worlds = yield [
        *(
            Batch(f"times-{number}", measure_times, (conditions, part), exclusive=True)
            for number, part in enumerate(parts)
        ),
        Batch("worlds", measure_worlds, (conditions,), exclusive=True),
    ]
    times = {name: columns for part in reversed(found) for name, columns in part.items()}
    return Measurement([row | times.get(row["case"], {}) for row in rows] + worlds)


def measure_points(conditions: Conditions, pads: str) -> list[dict]:
    """A row for each setting and each reference with these pads, all from one state of the shake; none is timed."""
    device = wp.get_device(conditions.device)
    points = [point for point in settings(conditions.profile, cpu_too=conditions.is_cuda) if point.pads == pads]
    finest = REFERENCE_SUBSTEPS[conditions.profile]
    references = list(dict.fromkeys(reference_of(point, n) for point in points for n in (finest, finest // 2)))

    pilot = pilot_at_shake(PADS.values(), device)
    shakes = {point: WarpShake(point, pilot, device) for point in points if not point.is_native}
    starts = dict(zip(PADS, starts_of(pilot, FRAME_COUNT), strict=True))
    natives = {
        point: NativeShake(point.case, starts[point.pads]) for point in (*references, *points) if point.is_native
    }
    with ThreadPoolExecutor(max(1, (os.cpu_count() or 1) - 1)) as pool:  # C runs on the CPU, beside the GPU
        native_traces = pool.map(NativeShake.run, natives.values())
        traces = run_shakes(shakes)
        traces |= dict(zip(natives, native_traces, strict=True))
    rows = [point_row(point, shakes | natives, traces, finest) for point in points]
    return rows + [reference_row(point, natives, traces) for point in references if point.case.substeps == finest]


def measure_times(conditions: Conditions, names: Sequence[str]) -> dict[str, dict[str, object]]:
    """Time frames of the settings of these names in turn, against the first of them; columns by name."""
    device = wp.get_device(conditions.device)
    by_name = {point.case.name: point for point in settings(conditions.profile, cpu_too=conditions.is_cuda)}
    pilot = Pilot(list(PADS.values()), device)
    starts = starts_of(pilot_at_shake(PADS.values(), device), WARMUP_COUNT + HALF_CYCLE)
    blocks = [frames_of(by_name[name], pilot, dict(zip(PADS, starts, strict=True))) for name in names]
    columns = {}
    for name, block, found in zip(names, blocks, in_turn(blocks, cap_s=CAP_S), strict=True):
        reason = block.reason if isinstance(block, Frames) else None
        row = absent(TIME_COLUMNS, f"not timed: {reason}") if reason else time_columns(found)
        columns[name] = row | ({} if names[0] == REFERENCE else absent(RATIO, f"{REFERENCE} has no time here"))
    return columns


def frames_of(point: Setting, pilot: Pilot, starts: Mapping[str, Start]) -> "Frames | NativeFrames":
    """Build what times frames of a setting."""
    if point.is_native:
        return NativeFrames(point.case, starts[point.pads])
    case = replace(point.case, frame_count=1)  # the recorder keeps the last frame only
    device = wp.get_device(case.device) if case.device else pilot.device
    return Frames(Simulation([case], device), case, pilot)


class NativeFrames:
    """Blocks of frames in C, each of half a cycle of the shake from its start, after a few that are not timed."""

    def __init__(self, case: Case, start: Start):
        self.shake = NativeShake(case, start)

    def __call__(self, _: int) -> float:
        """Time of a frame [ms], mean of a block."""
        shake, start = self.shake, self.shake.start
        shake.data.qpos[:], shake.data.qvel[:] = start.qpos, start.qvel
        shake.data.qacc_warmstart[:] = start.qacc_warmstart
        shake.frame_index = 0
        shake.frame_ms(0)  # runs those before
        return elapsed_ms(wp.get_device("cpu"), self._run) / HALF_CYCLE

    def _run(self) -> None:
        for _ in range(HALF_CYCLE):
            self.shake.frame()


def measure_worlds(conditions: Conditions) -> list[dict]:
    """A row for C on one core, and one for each number of worlds, all timed in turn against that."""
    device = wp.get_device(conditions.device)
    pilot = Pilot([FIXED], device)
    start = starts_of(pilot_at_shake(PADS.values(), device), FRAME_COUNT)[list(PADS).index("stiff")]
    reason = invalid_reason(ONE_CORE, NativeShake(ONE_CORE, start).run())
    native = NativeFrames(ONE_CORE, start)
    counts = "quick" if conditions.quick else "cuda" if conditions.is_cuda else "cpu"
    cases = {count: replace(FIXED, name=f"worlds-{count}", frame_count=1) for count in WORLD_COUNTS[counts]}
    worlds = [Frames(Simulation([case] * count, device), case, pilot) for count, case in cases.items()]
    one_core, *found = in_turn([native, *worlds], cap_s=WORLDS_CAP_S)
    rows = [world_row(frames, each) for frames, each in zip(worlds, found, strict=True)]
    row = timed_only(ONE_CORE, reason, "mujoco-c", world_count=1)
    return [*rows, row | (absent(TIME_COLUMNS, f"not timed: {reason}") if reason else time_columns(one_core))]


class WarpShake:
    """One setting as a simulation of one world, compiled, captured and at the start of the shake."""

    def __init__(self, point: Setting, pilot: Simulation, device: wp.Device):
        device = wp.get_device(point.case.device) if point.case.device else device
        built: list[Simulation] = []
        self.build_ms = elapsed_ms(device, lambda: built.append(Simulation([point.case], device)))
        [self.simulation] = built
        world = list(PADS).index(point.pads)
        put_in_state_of(self.simulation, pilot, world)
        self.first_frame_ms = elapsed_ms(device, self.simulation.step)
        # The frame that was captured must not count.
        put_in_state_of(self.simulation, pilot, world)
        self.simulation.recorder.cursor.zero_()
        wp.synchronize_device(device)


def run_shakes(shakes: dict[Setting, WarpShake]) -> dict[Setting, Trace]:
    """Run all frames of all settings, those of one device side by side."""
    traces = {}
    for device in dict.fromkeys(shake.simulation.device.alias for shake in shakes.values()):
        mine = {point: shake.simulation for point, shake in shakes.items() if shake.simulation.device.alias == device}
        results = run(list(mine.values()), title=f"error_runtime on {device}")
        traces |= {point: trace for point, [trace] in zip(mine, results, strict=True)}
    return traces


def point_row(
    point: Setting,
    shakes: dict[Setting, WarpShake | NativeShake],
    traces: dict[Setting, Trace],
    reference_substeps: int,
) -> dict[str, object]:
    """Errors and time of one setting, and how far it is from the same setting in C."""
    shake, trace, native = shakes[point], traces[point], native_of(point)
    row = describe(point, trace, shakes[native])
    row |= errors(trace, traces[reference_of(point, reference_substeps)])
    if not point.is_native:
        row |= number("c_difference_mm", distance_mm(trace, traces[native]))
        row["backend"] = "warp-cuda" if shake.simulation.device.is_cuda else "warp-cpu"
        row |= {"build_s": 1e-3 * shake.build_ms, "capture_s": 1e-3 * shake.first_frame_ms}
    if not row["valid"]:
        row |= absent(TIME_COLUMNS, f"not timed: {row['invalid_reason']}")
    return row


def reference_row(
    point: Setting, natives: dict[Setting, NativeShake], traces: dict[Setting, Trace]
) -> dict[str, object]:
    """A converged solution; as its error counts how far it is from the solution with twice the step.

    The integrator is of higher than first order, so more than half of the error goes when the step is halved, and what
    is left is less than what has just gone.
    """
    row = describe(point, traces[point], natives[point])
    row |= errors(traces[point], traces[reference_of(point, point.case.substeps // 2)])
    return row | absent(TIME_COLUMNS, "a reference runs beside others and is not timed")


def describe(point: Setting, trace: Trace, native: NativeShake) -> dict[str, object]:
    """What a setting is, and whether its run counts."""
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
        **number("cone_use_max", float(np.nanmax(trace.column("cone_use")))),
        "iteration_peak_count": trace.peak_iteration_count,
        "frame_count": len(trace.phase),
    }


def errors(trace: Trace, reference: Trace) -> dict[str, object]:
    """Grasp error and numerical error of a run."""
    grasp = metrics.cycle_drift_mm(metrics.displacement(trace), PADS["as-shipped"].shake_frequency_hz)
    return number("grasp_error_mm_per_cycle", grasp) | number("numerical_error_mm", distance_mm(trace, reference))


def distance_mm(trace: Trace, other: Trace) -> float:
    """How far apart two runs have the cube in the TCP frame, root mean square over the shake [mm]."""
    paths = (metrics.relative_position(each.poses, metrics.CUBE, metrics.TCP) for each in (trace, other))
    return metrics.distance_rms_mm(*paths)


def time_columns(found: Resolved) -> dict[str, object]:
    """Wall time per simulated second, and over that of what it is compared with."""
    return comparing.time_columns(replace(found, times=FRAME_RATE * found.times), "ms_per_s", "time_ratio")


def world_row(frames: Frames, found: Resolved) -> dict[str, object]:
    """The fixed scene in many worlds at once, timed in the shake against C on one core."""
    backend = "warp-cuda" if frames.pilot.device.is_cuda else "warp-cpu"
    row = timed_only(frames.case, frames.reason, backend, frames.simulation.world_count)
    return row | (time_columns(found) if not frames.reason else absent(TIME_COLUMNS, f"not timed: {frames.reason}"))


def timed_only(case: Case, invalid: str | None, backend: str, world_count: int) -> dict[str, object]:
    row = {"case": case.name, **differences(case), "backend": backend, "method": "worlds", "worlds": world_count}
    row |= {"valid": invalid is None, "invalid_reason": invalid}
    return row | absent(ERROR_COLUMNS, "only the time is measured here")


def number(name: str, value: float) -> dict[str, object]:
    """A column, with the reason where the number does not exist."""
    return {name: float(value)} if np.isfinite(value) else absent((name,), "the positions are not finite")
