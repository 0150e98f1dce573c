"""Shake a cube, a thin plate and a sharp edge between hydroelastic pads."""

import gc
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import warp as wp

from experiments.facts.case import AS_SHIPPED, STIFF_PADS
from experiments.facts.trace import ContactRows, Trace
from experiments.hydroelastic.grasp import KH_N_M3, Grasp, GraspSimulation
from experiments.simulation.frame_benchmark import TIMES, time_columns, untimed
from experiments.simulation.measurement import (
    Conditions,
    Measurement,
    absent,
    summarize,
)
from experiments.simulation.paired_timing import time_in_turn
from experiments.simulation.simulation import run
from experiments.simulation.task import FRAME_RATE, LIFT, PHASE_SECONDS
from experiments.simulation.timing import (
    SHAKE_FRAME_COUNT,
    batch_invalid_reason,
    elapsed_ms,
    memory_bytes,
    run_frames,
)
from measured_report.measuring.batch import Batch, Plan

GAP_M = 0.005  # contact gap of the cube, so that the grids are fine; the pads' is equal
SMALL_GAP = replace(
    AS_SHIPPED,
    cube_gap_m=GAP_M,
    visuals=False,
    broad_phase="explicit",
    contact_max=512,
    constraint_max=1536,
)
STIFFNESSES_N_M3 = (1e7, 1e8, 1e9, KH_N_M3, 1e11, 1e12)
RESOLUTIONS = (16, 32, 128)
COLLIDE_COUNTS = (4, 16)
SUBSTEPS = (4, 64)
THIN = {"plate": {"finger_closed_m": -0.029}, "edge": {"finger_closed_m": -0.002}}
"""Objects other than the cube, with a target of the fingers that gives the same force."""
WORLD_COUNTS = (1, 64)
START_FRAME_COUNT = round(PHASE_SECONDS[LIFT] * FRAME_RATE) + SHAKE_FRAME_COUNT
"""Number of frames, with the cube in the hand at the start, until the shake has begun.
"""
CONTACTS = ("row_count", "loaded_row_count", "timeconst_ms", "penetration_mm")


def measure(conditions: Conditions) -> Plan:
    """Return rows for each grasp, and for the frame times with each number of worlds."""
    if not conditions.is_cuda:
        reason = "Newton builds the grids of hydroelastic shapes only on a CUDA device"
        row = {"case": "hydroelastic", "pads": "hydroelastic"}
        return Measurement([row | absent(("slip_mm", "drift_mm_s"), reason)])
    found = yield [
        Batch("shakes", measure_shakes, (conditions,)),
        Batch("times", measure_times, (conditions,), exclusive=True),
    ]
    return Measurement([row for rows in found for row in rows])


def grasps() -> list[Grasp]:
    """Return the grasps: points and areas, and areas with single changes."""
    area = Grasp(replace(SMALL_GAP, name="area"))

    def changed(name: str, **changes) -> Grasp:
        return replace(area, case=replace(SMALL_GAP, name=f"area/{name}", **changes))

    found = [
        Grasp(replace(SMALL_GAP, name="points"), is_hydroelastic=False),
        Grasp(
            replace(
                SMALL_GAP,
                name="points/stiff",
                pad_ke=STIFF_PADS.pad_ke,
                pad_kd=STIFF_PADS.pad_kd,
            ),
            is_hydroelastic=False,
        ),
        Grasp(
            replace(SMALL_GAP, name="points/held", shake_amplitude_m=0.0),
            is_hydroelastic=False,
        ),
        area,
        changed("held", shake_amplitude_m=0.0),
        changed("held-collide-16", shake_amplitude_m=0.0, collide_count=16),
        changed("term-restored", contact_bias=True),
        changed("default-gap", cube_gap_m=AS_SHIPPED.cube_gap_m),
        *(changed(f"collide-{n}", collide_count=n) for n in COLLIDE_COUNTS),
        *(changed(f"substeps-{n}", substeps=n) for n in SUBSTEPS),
    ]
    found += [
        replace(changed(f"kh-{kh:.0e}"), kh_n_m3=kh)
        for kh in STIFFNESSES_N_M3
        if kh != KH_N_M3
    ]
    found += [replace(changed(f"resolution-{n}"), resolution=n) for n in RESOLUTIONS]
    for shape, changes in THIN.items():
        case = replace(SMALL_GAP, **changes)  # type: ignore[arg-type]  # of the fingers
        found += [
            Grasp(
                replace(case, name=f"{kind}/{shape}"),
                is_hydroelastic=kind == "area",
                shape=shape,
            )
            for kind in ("points", "area")
        ]
    return found


def measure_shakes(conditions: Conditions) -> list[dict[str, object]]:
    """Return a row for each grasp; those with the same key are worlds of one batch."""
    groups: dict[object, list[Grasp]] = {}
    for grasp in grasps():
        count = conditions.frame_count(grasp.case.frame_count)
        grasp = replace(grasp, case=replace(grasp.case, frame_count=count))
        groups.setdefault(grasp.key, []).append(grasp)
    device, middle = wp.get_device(conditions.device), conditions.contact_frames()[1]
    rows: list[dict[str, object]] = []
    running: dict[GraspSimulation, list[Grasp]] = {}
    for group in groups.values():
        try:
            running[GraspSimulation(group, device)] = group
        # A release that cannot build the scene is a result.
        except Exception as error:
            numbers = absent(("slip_mm", "drift_mm_s", *CONTACTS), reason_of(error))
            rows += [columns_of(grasp) | numbers for grasp in group]
    traces = run(list(running), "hydroelastic", (middle,))
    for group, found in zip(running.values(), traces, strict=True):
        rows += [row_of(*pair) for pair in zip(group, found, strict=True)]
    return rows


def reason_of(error: Exception) -> str:
    """Return a line with the reason why a scene has no result."""
    return " ".join(str(error).split())[:120] or type(error).__name__


def columns_of(grasp: Grasp) -> dict[str, object]:
    return {
        "case": grasp.case.name,
        "pads": "hydroelastic" if grasp.is_hydroelastic else "points",
        "shape": grasp.shape,
        "kh_n_m3": grasp.kh_n_m3,
        "resolution": grasp.resolution,
        "substeps": grasp.case.substeps,
        "collide_count": grasp.case.collide_count,
    }


def row_of(grasp: Grasp, trace: Trace) -> dict[str, object]:
    """Return slip and drift of a run, and the contacts in the middle of its shake."""
    row = summarize(grasp.case, trace) | columns_of(grasp)
    return row | contact_columns(trace.contact_rows)


def contact_columns(frames: Sequence[ContactRows]) -> dict[str, object]:
    """Return the number of contacts on the pads, and means over those with a force."""
    if not frames:
        return absent(CONTACTS, "the run ended before contacts were kept")
    [rows] = frames
    loaded = rows.force_n[:, 0] > 0.0
    counts = {"row_count": len(loaded), "loaded_row_count": int(loaded.sum())}
    if not loaded.any():
        return counts | absent(CONTACTS[2:], "no contact carries force")
    return counts | {
        "timeconst_ms": 1e3 * float(np.median(rows.solref[loaded, 0])),
        "penetration_mm": -1e3 * float(rows.distance_m[loaded].min()),
    }


def measure_times(conditions: Conditions) -> list[dict[str, object]]:
    """Return frame time and memory for each number of worlds, of points and of areas."""
    rows, device = [], wp.get_device(conditions.device)
    counts = WORLD_COUNTS[: 1 if conditions.quick else None]
    for count in counts:
        reference = Blocks(False, count, device)
        for is_hydroelastic in (False, True):
            pads = "hydroelastic" if is_hydroelastic else "points"
            row: dict = {"case": f"{pads}/worlds-{count}", "pads": pads}
            row["worlds"] = count
            try:
                other = [Blocks(True, count, device)] if is_hydroelastic else []
                row |= reference_times([reference, *other])
            # Memory runs out, or the release cannot run the scene.
            except Exception as error:
                row |= absent((*TIMES, "bytes_per_world"), reason_of(error))
            rows.append(row)
    return rows


class Blocks:
    """Run blocks of frames from the shake in identical worlds."""

    def __init__(self, is_hydroelastic: bool, world_count: int, device: wp.Device):
        gc.collect()
        before = memory_bytes(device)
        case = replace(SMALL_GAP, name="timed", cube_in_hand=True, frame_count=1)
        grasp = Grasp(case, is_hydroelastic=is_hydroelastic)
        self.simulation = GraspSimulation([grasp] * world_count, device)
        run_frames(self.simulation, START_FRAME_COUNT)
        gc.collect()
        self.bytes_per_world = (memory_bytes(device) - before) / world_count

    def __call__(self, _: int) -> float:
        """Return the time of a frame [ms]."""
        device = self.simulation.device
        return elapsed_ms(device, self.simulation.step)


def reference_times(blocks: Sequence[Blocks]) -> dict[str, object]:
    """Return the times of the last block, timed in turn with the first one."""
    times, last = time_in_turn(blocks)[-1], blocks[-1]
    memory = {"bytes_per_world": last.bytes_per_world}
    reason = batch_invalid_reason(last.simulation)
    return memory | (untimed(TIMES, reason) if reason else time_columns(times))
