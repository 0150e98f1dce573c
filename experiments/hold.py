"""Measure the same grasp with the arm held still.

This shows the creep without a load cycle, and whether rounding moves the cube.
"""

import copy
from collections.abc import Callable
from dataclasses import replace

import mujoco
import numpy as np
import warp as wp

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, HOLD, STIFF_PADS, Case
from experiments.facts.trace import Trace
from experiments.simulation.measurement import (
    SETUP_FRAME_COUNT,
    Conditions,
    displacement_table,
    summarize,
)
from experiments.simulation.reference import ENGINES_AGREE
from experiments.simulation.simulation import Simulation
from experiments.simulation.task import FRAME_RATE
from measured_report.measuring.measurement import Measurement, absent

LONG_FRAME_COUNT = SETUP_FRAME_COUNT + 60 * FRAME_RATE + 1
CASES = (
    HOLD,
    replace(HOLD, name="hold-60s", frame_count=LONG_FRAME_COUNT),
    replace(
        STIFF_PADS,
        name="hold-60s-stiff",
        shake_amplitude_m=0.0,
        frame_count=LONG_FRAME_COUNT,
    ),
    AS_SHIPPED,
)
CREEP_COLUMNS = ("creep_z_mm_s", "increment_final_mm")
SETTLE_FRAME_COUNT = SETUP_FRAME_COUNT + 5 * FRAME_RATE
"""Frames before the measurement, which are the setup and the time until the arm is at
rest.
"""
SECONDS = {"full": 4, "quick": 1}


def measure(conditions: Conditions) -> Measurement:
    traces = conditions.simulate(CASES, title="hold")
    rows = [
        summarize(case, trace) | creep(trace)
        for case, trace in zip(CASES, traces, strict=True)
    ]
    rows += measure_precision(conditions)
    return Measurement(
        rows,
        {
            case.name: displacement_table(trace)
            for case, trace in zip(CASES, traces, strict=True)
        },
    )


def creep(trace: Trace) -> dict[str, object]:
    """Return the creep rate along the tool, and the path in the last whole second.

    The path is measured in the direction of the final displacement. The columns are
    absent if there is no whole second.
    """
    moved = metrics.displacement(trace)
    if trace.failure or len(moved.time_s) <= FRAME_RATE:
        reason = str(
            trace.failure or "the time after the lift is shorter than a second"
        )
        return absent(CREEP_COLUMNS, reason)
    slope = 1e3 * np.polyfit(moved.time_s, moved.vector_m, 1)[0]
    way = moved.vector_m @ (moved.vector_m[-1] / np.linalg.norm(moved.vector_m[-1]))
    return dict(
        zip(
            CREEP_COLUMNS,
            (float(slope[2]), 1e3 * float(np.diff(way[::FRAME_RATE])[-1])),
            strict=True,
        )
    )


def measure_precision(conditions: Conditions) -> list[dict[str, object]]:
    """Measure the creep in MuJoCo Warp and in MuJoCo's C engine.

    The C engine runs without Newton, with positions in double precision and rounded to
    single precision.
    """
    seconds = SECONDS[conditions.profile]
    hold = replace(HOLD, frame_count=1, **ENGINES_AGREE)
    in_c = _settled(replace(hold, backend="mujoco"), "cpu")
    runs = {
        "precision-warp": _in_warp(_settled(hold, conditions.device), seconds),
        "precision-c-double": _in_c(in_c, seconds, lambda data: None),
        "precision-c-single": _in_c(in_c, seconds, _round_positions),
    }
    return [
        {
            "case": case,
            "creep_mm_s": float(
                np.linalg.norm(1e3 * (place_m[-1] - place_m[0]) / seconds)
            ),
        }
        for case, place_m in runs.items()
    ]


def _settled(case: Case, device: str) -> Simulation:
    simulation = Simulation([case], wp.get_device(device))
    for _ in range(SETTLE_FRAME_COUNT):
        simulation.step()
    return simulation


def _in_warp(simulation: Simulation, seconds: int) -> list[np.ndarray]:
    """Return the cube's positions in the TCP frame, one second apart."""
    held = []
    for second in range(seconds + 1):
        for _ in range(FRAME_RATE if second else 0):
            simulation.step()
        poses = simulation.recorder.poses.numpy()[:, 0]
        held.append(metrics.relative_position(poses, metrics.CUBE, metrics.TCP)[0])
    return held


def _in_c(
    simulation: Simulation, seconds: int, after_step: Callable[[mujoco.MjData], None]
) -> list[np.ndarray]:
    """Return the cube's positions in the TCP frame from a copy without Newton.

    Newton would write its state in single precision at every step.
    """
    engine, data = simulation.solver.mj_model, copy.copy(simulation.solver.mj_data)
    cube = engine.geom_bodyid[simulation.recorder.cube_geom]
    tcp = next(
        body
        for body in range(engine.nbody)
        if engine.body(body).name.endswith("fr3_hand_tcp")
    )
    places_m = []
    for second in range(seconds + 1):
        for _ in range(FRAME_RATE * simulation.case.substeps if second else 0):
            mujoco.mj_step(engine, data)
            after_step(data)
        mujoco.mj_kinematics(engine, data)
        places_m.append(
            data.xmat[tcp].reshape(3, 3).T @ (data.xpos[cube] - data.xpos[tcp])
        )
    return places_m


def _round_positions(data: mujoco.MjData) -> None:
    data.qpos[:] = data.qpos.astype(np.float32)
