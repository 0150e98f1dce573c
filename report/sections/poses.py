"""List the runs of the replay, and compute the motion of the hand from its joints."""

import numpy as np
import pandas as pd

from experiments.facts.kept import DESCRIPTION, JOINTS, TCP
from experiments.facts.kinematics import link_poses, read_joints
from experiments.facts.metrics import SHAKE
from report.shared import Results, Section, by_case

order = 125
page = "fix"
label = "the replay"
labels = {
    "as-shipped": "shipped pads",
    "as-shipped-10cm": "shipped pads, 10 cm",
    "stiff-pads-10cm": "stiff pads, 10 cm",
    "hold-#s": "arm held still, {} s",
}

COLUMNS = {
    "amplitude": "shake_amplitude_m",
    "time": "shake_duration_s",
    "slip at the end": "slip_mm",
    "time until it leaves the grasp": "left_grasp_s",
    "final cube height": "cube_height_m",
}
MOTION = {  # units by name; the axes of the shake are the axes of the world
    "amplitude_along": "mm",  # √2 times the standard deviation of the hand's position
    "amplitude_across": "mm",
    "amplitude_up": "mm",
    "rate_along": "Hz",  # the strongest frequency
    "rate_across": "Hz",
    "rate_up": "Hz",
    "speed_squared": "m²/s²",  # mean squared speed
    "arc": "m",  # radius of the hand's arc while joints keep their speeds
}
# Positions this long before and after a frame, at constant joint speeds, give the arc.
AHEAD_S = 1e-2


def derive(results: Results) -> Section:
    row = results.row["as-shipped"]
    for name, unit in MOTION.items():
        results.value(
            name,
            f"{name} of the hand, computed from its joint positions in pairs of whole"
            " cycles after the first cycle",
            lambda *run, name=name: _motion(*run)[name],
            results.trace("as-shipped"),
            row.frame_rate_hz,
            row.shake_frequency_hz,
            unit=unit,
        )
    return Section(tables={"runs": by_case(results.rows, COLUMNS)})


def _motion(run: pd.DataFrame, frames_hz: float, cycles_hz: float) -> dict[str, float]:
    """Return the motion of the hand, computed only from its joint positions.

    It covers as many pairs of whole cycles as possible after the first cycle.
    """
    joints = run.loc[run["phase"] == SHAKE, list(JOINTS)].to_numpy()
    # Central differences of fourth order give the joint speeds.
    differences = 8.0 * (joints[3:-1] - joints[1:-3]) - joints[4:] + joints[:-4]
    speeds = frames_hz * differences / 12.0
    cycle = round(frames_hz / cycles_hz)
    pair_count = (len(speeds) - cycle) // (2 * cycle)
    pairs = slice(cycle, cycle + pair_count * 2 * cycle)

    def place(time_s: float) -> np.ndarray:
        positions = joints[2:-2][pairs] + time_s * speeds[pairs]
        links = link_poses(read_joints(DESCRIPTION), positions, np.zeros(3))
        return links[TCP][:, :3, 3]

    back = place(-AHEAD_S)
    middle = place(0.0)
    ahead = place(AHEAD_S)
    speed = np.linalg.norm(ahead - back, axis=1) / (2.0 * AHEAD_S)
    bend = -(ahead - 2.0 * middle + back)[:, 0] / AHEAD_S**2
    waves = np.abs(np.fft.rfft(middle - middle.mean(axis=0), axis=0)).argmax(axis=0)
    motion = [
        *(1e3 * np.sqrt(2.0) * middle.std(axis=0)),
        *(waves * frames_hz / len(middle)),
        (speed**2).mean(),
        speed.sum() / (bend / speed).sum(),
    ]
    return dict(zip(MOTION, map(float, motion), strict=True))
