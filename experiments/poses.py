"""Record the joint positions and the pose of the cube in each frame of the runs that
the clips show.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import warp as wp

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, HOLD, STIFF_PADS, Case
from experiments.facts.kept import CUBE_PLACE, CUBE_TURN, JOINTS
from experiments.facts.trace import Trace
from experiments.simulation.measurement import (
    SETUP_FRAME_COUNT,
    Conditions,
    Measurement,
    absent,
    summarize,
)
from experiments.simulation.scene import ROBOT_POSITION
from experiments.simulation.simulation import Simulation, run
from experiments.simulation.task import FRAME_RATE

FAR_SHAKE_M = 0.10  # amplitude at which shipped pads lose the cube
SHAKEN = (
    AS_SHIPPED,
    STIFF_PADS,
    *(
        replace(case, name=f"{case.name}-10cm", shake_amplitude_m=FAR_SHAKE_M)
        for case in (AS_SHIPPED, STIFF_PADS)
    ),
)
HELD = replace(
    HOLD, name="hold-60s", frame_count=SETUP_FRAME_COUNT + 60 * FRAME_RATE + 1
)
# Frames between two kept frames of the held arm, which hardly moves.
HELD_FRAME_STEP = 6

COORDINATES = (*JOINTS, *CUBE_PLACE, *CUBE_TURN)


def measure(conditions: Conditions) -> Measurement:
    held = replace(HELD, frame_count=conditions.frame_count(HELD.frame_count))
    shaken = [
        replace(case, frame_count=conditions.frame_count(case.frame_count))
        for case in SHAKEN
    ]
    simulations = [
        KeptSimulation(cases, wp.get_device(conditions.device))
        for cases in (shaken, [held])
    ]
    traces = [trace for worlds in run(simulations, "poses") for trace in worlds]
    coordinates = [kept for simulation in simulations for kept in simulation.kept()]
    rows, tables = [], {}
    for case, trace, kept in zip([*shaken, held], traces, coordinates, strict=True):
        step = HELD_FRAME_STEP if case is held else 1
        rows.append(
            summarize(case, trace) | left_grasp(trace) | drawing_columns(case, step)
        )
        tables[case.name] = pose_table(trace, kept, step)
    return Measurement(rows, tables)


class KeptSimulation(Simulation):
    """Run a simulation and keep its joint coordinates after every frame.

    The recorder does not keep them.
    """

    def __init__(self, cases: Sequence[Case], device: wp.Device):
        super().__init__(cases, device)
        self.coordinates = wp.zeros(
            (self.case.frame_count, self.state.joint_q.size), dtype=float, device=device
        )
        self.frame_count = 0
        # The array is written on a stream other than the one that created it.
        wp.synchronize_device(device)

    def frame(self) -> None:
        super().frame()
        wp.copy(self.coordinates[self.frame_count], self.state.joint_q)
        self.frame_count += 1

    def kept(self) -> list[np.ndarray]:
        """Return the joint positions and the cube's pose in each world.

        The shape is [frames, len(COORDINATES)].
        """
        worlds = self.coordinates.numpy().reshape(
            self.case.frame_count, self.world_count, -1
        )
        return list(worlds.swapaxes(0, 1))


def left_grasp(trace: Trace) -> dict[str, object]:
    """Return the time in the shake at which the cube leaves the grasp.

    It is absent if the cube stays close enough to the TCP.
    """
    shaken = trace.poses[trace.phase == metrics.SHAKE]
    distance = np.linalg.norm(
        metrics.relative_position(shaken, metrics.CUBE, metrics.TCP), axis=1
    )
    far = np.flatnonzero(distance > metrics.DROP_DISTANCE)
    if trace.failure or not len(far):
        return absent(
            ["left_grasp_s"], str(trace.failure or "the cube stays in the grasp")
        )
    return {"left_grasp_s": float(far[0] * trace.frame_dt)}


def drawing_columns(case: Case, frame_step: int) -> dict[str, float]:
    """Return the columns that a picture needs in addition to the poses.

    These are the position of the robot, the size of the cube, and the kept frames.
    """
    base = dict(zip(("base_x_m", "base_y_m", "base_z_m"), ROBOT_POSITION, strict=True))
    return base | {
        "cube_edge_m": case.cube_edge_m,
        "frame_rate_hz": FRAME_RATE,
        "kept_frame_step": frame_step,
    }


def pose_table(
    trace: Trace, coordinates: np.ndarray, frame_step: int
) -> dict[str, np.ndarray]:
    """Return every ``frame_step``-th frame, including the last one.

    The table contains the coordinates in single precision, the displacement of the cube
    in the TCP frame since the first frame of the shake (NaN before it), and the contact
    forces.
    """
    frames = np.arange(len(trace.phase))[
        (len(trace.phase) - 1) % frame_step :: frame_step
    ]
    moved = np.full((len(trace.phase), 3), np.nan)
    moved[trace.phase == metrics.SHAKE] = 1e3 * metrics.displacement(trace).vector_m
    table = {"frame": frames, "phase": trace.phase[frames]}
    table |= dict(zip(COORDINATES, coordinates[frames].T, strict=True))
    table |= {
        f"{axis}_mm": moved[frames, column].round(6)
        for column, axis in enumerate("xyz")
    }
    table |= {
        name: trace.column(name)[frames].round(3)
        for name in ("normal_force_n", "tangential_force_n")
    }
    return table | {
        "penetration_mm": (1e3 * trace.column("penetration_m")[frames]).round(5)
    }
