"""Pack the stored runs of replay.html into text that its script reads."""

import base64
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from experiments.facts.kept import kept_run
from measured_report.records.record import trace_path
from measured_report.records.traces import load_trace
from measured_report.values.results import Results
from report.media.replay import SHAKES

SAMPLE_RATE_HZ = 30
COLUMNS = (  # numbers of each sample; the cube's pose is in the TCP frame [m]
    *(f"joint_{number}" for number in range(9)),
    *(f"cube_{part}" for part in ("x", "y", "z", "qx", "qy", "qz", "qw")),
    "normal_force_n",
    "tangential_force_n",
    "penetration_mm",
)


def packed_runs(results: Results) -> dict[str, Any]:
    """Return all runs of the page in the format of assets/replay/src/runs.js."""
    rows = {row["case"]: row for row in results.record.rows}
    first = rows["as-shipped"]
    shakes = []
    for name, runs in SHAKES.items():
        packed = [packed_run(runs[case], rows[case], results.path) for case in runs]
        shakes.append({"name": name, "runs": packed})
    return {
        "base_m": [first[f"base_{axis}_m"] for axis in "xyz"],
        "edge_m": first["cube_edge_m"],
        "columns": COLUMNS,
        "shakes": shakes,
    }


def packed_run(name: str, row: Mapping[str, Any], record: Path) -> dict[str, Any]:
    """Return the samples of a run, which include its last frame.

    Each column is stored in 16 bits between its smallest and its largest value.
    """
    run = kept_run(row, load_trace(trace_path(record, row["case"])))
    kept_rate_hz = row["frame_rate_hz"] / row["kept_frame_step"]
    step = max(1, round(kept_rate_hz / SAMPLE_RATE_HZ))
    indices = np.arange(len(run.time_s))[(len(run.time_s) - 1) % step :: step]
    rotations = quaternions(run.cube_in_hand)
    contact = np.stack([run.contact[name] for name in COLUMNS[16:]], axis=1)
    parts = [run.joints, run.cube_in_hand[:, :3, 3], rotations, contact]
    values = np.concatenate(parts, axis=1)[indices]
    # A sample does not resolve a billionth of a metre or a radian, and further digits
    # differ between versions of NumPy.
    low = np.round(values.min(axis=0), 9)
    high = np.round(values.max(axis=0), 9)
    fractions = (values - low) / np.where(high > low, high - low, 1.0)
    levels = np.round(fractions * 65535).astype("<u2")
    return {
        "name": name,
        "start_s": float(run.time_s[indices[0]]),
        "step_s": step * row["kept_frame_step"] / row["frame_rate_hz"],
        "count": len(indices),
        "left_grasp_s": row["left_grasp_s"],
        "begin": {
            "position": run.begin_in_hand[:3, 3].tolist(),
            "quaternion": np.round(rotations[run.shake_start], 9).tolist(),
        },
        "low": low.tolist(),
        "high": high.tolist(),
        "samples": base64.b64encode(levels.T.tobytes()).decode(),
    }


def quaternions(poses: np.ndarray) -> np.ndarray:
    """Return unit quaternions (x, y, z, w) of poses, shape [frames, 4].

    The signs are chosen so that successive quaternions are close to each other.
    """
    vectors = Rotation.from_matrix(poses[:, :3, :3]).as_quat()
    is_flipped = np.sum(vectors[1:] * vectors[:-1], axis=1) < 0.0
    signs = np.where(np.append(0, np.cumsum(is_flipped)) % 2, -1.0, 1.0)
    return vectors * signs[:, None]
