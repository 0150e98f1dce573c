"""The runs that are shown moving: what they come to, and how the hand moves by the record of its joints."""

import numpy as np
import pandas as pd

from experiments.facts.kept import DESCRIPTION, JOINTS, TCP
from experiments.facts.kinematics import link_poses, read_joints
from experiments.facts.metrics import SHAKE
from report.shared import Results, Section, by_case

order = 125
page = "fix"
label = "see it move"
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
}
COLUMNS |= {"out of the grasp after": "left_grasp_s", "cube ends at": "cube_height_m"}
AXES = ("along", "across", "up")  # of the shake, which are those of the world
# Units by name: √2 of the hand's deviation, its strongest rate, mean squared speed, its arc at held joint speeds.
MOTION = {
    f"{name}_{axis}": unit
    for name, unit in (("amplitude", "mm"), ("rate", "Hz"))
    for axis in AXES
}
MOTION |= {"speed_squared": "m²/s²", "arc": "m"}
AHEAD_S = 1e-2  # how far ahead, and back, joints are taken to go on at the speeds that they have


def derive(results: Results) -> Section:
    row, trace = results.row["as-shipped"], results.trace("as-shipped")
    read = trace, row.frame_rate_hz, row.shake_frequency_hz
    for name, unit in MOTION.items():
        results.value(
            name,
            f"{name} of the hand, by the positions of its joints in pairs of whole cycles after the first",
            lambda *read, name=name: _motion(*read)[name],
            *read,
            unit=unit,
        )
    return Section(tables={"runs": by_case(results.rows, COLUMNS)})


def _motion(
    run: pd.DataFrame, frames_per_s: float, cycles_per_s: float
) -> dict[str, float]:
    """Return how the hand moves in pairs of whole cycles, after the first, by the positions of its joints alone."""
    joints = run.loc[run["phase"] == SHAKE, list(JOINTS)].to_numpy()
    speeds = (
        frames_per_s
        * (8.0 * (joints[3:-1] - joints[1:-3]) - joints[4:] + joints[:-4])
        / 12.0
    )
    cycle = round(frames_per_s / cycles_per_s)
    pairs = slice(cycle, cycle + (len(speeds) - cycle) // (2 * cycle) * 2 * cycle)
    steps = [
        joints[2:-2][pairs] + ahead * speeds[pairs]
        for ahead in (-AHEAD_S, 0.0, AHEAD_S)
    ]
    back, here, ahead = (
        link_poses(read_joints(DESCRIPTION), step, np.zeros(3))[TCP][:, :3, 3]
        for step in steps
    )
    speed = np.linalg.norm(ahead - back, axis=1) / (2.0 * AHEAD_S)
    bend = -(ahead - 2.0 * here + back)[:, 0] / AHEAD_S**2
    waves = (
        np.abs(np.fft.rfft(here - here.mean(axis=0), axis=0)).argmax(axis=0)
        * frames_per_s
        / len(here)
    )
    ends = (
        *1e3 * np.sqrt(2.0) * here.std(axis=0),
        *waves,
        (speed**2).mean(),
        speed.sum() / (bend / speed).sum(),
    )
    return dict(zip(MOTION, map(float, ends), strict=True))
