"""Make the clips of a release from its kept poses.

This is the module that ``make clips`` runs.
"""

import argparse
import importlib.util
import sys
import time
from datetime import datetime, timezone
from pathlib import Path

import numpy as np
import pandas as pd
import warp as wp
from tqdm import tqdm

from experiments.facts import clip_record as shown
from experiments.facts.kept import KeptRun, kept_run
from experiments.media.clips import (
    FRAME_RATE,
    HEIGHT,
    MAGNIFIED,
    STILL,
    WIDTH,
    Clip,
    long_exposure,
    pictures,
    write_image,
    write_video,
)
from experiments.simulation.host import warp_device
from measured_report.editions.project import PROFILES, Project, own_release
from measured_report.files.atomic import atomic_file
from measured_report.files.config import report
from measured_report.files.errors import ReportError
from measured_report.measuring.machine import commit, machine
from measured_report.measuring.measurement import absent
from measured_report.records.record import Record, load_record, trace_path, write_record
from measured_report.records.traces import load_trace, packed


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="python -m experiments.media.render", description=__doc__.split(":")[0]
    )
    parser.add_argument(
        "--newton", default=own_release(), help="release whose kept poses are shown"
    )
    parser.add_argument(
        "--device", choices=("cuda", "cpu"), help="default: cuda where there is one"
    )
    parser.add_argument("--profile", choices=PROFILES, default="full")
    arguments = parser.parse_args()
    project = Project(arguments.newton, arguments.profile, own_release=own_release())
    try:
        if importlib.util.find_spec("av") is None:
            raise ReportError(
                "making clips needs PyAV, which encodes them: uv sync --group clips installs it"
            )
        make_clips(project, warp_device(arguments.device))
    except ReportError as error:
        print(error, file=sys.stderr)
        return 2
    return 0


def make_clips(project: Project, device: wp.Device) -> None:
    """Render and encode each clip and the still, and write their record."""
    start = time.perf_counter()
    identity = shown.clips_identity(project)
    poses = project.record_path("poses")
    if not poses.exists():
        raise ReportError(
            f"no poses of Newton {project.release} are kept; {project.rerun('poses')} keeps them"
        )
    rows_by_run = {row["case"]: row for row in load_record(poses).rows}

    def run_of(name: str) -> KeptRun:
        return kept_run(rows_by_run[name], load_trace(trace_path(poses, name)))

    names = shown.RUNS[shown.FIRST]
    clips = {
        case: Clip((run_of(left), run_of(right)), names)
        for case, (left, right) in shown.RUNS.items()
    }
    rows = [
        make_clip(project, case, clip, device.alias) for case, clip in clips.items()
    ]
    frequency_hz = rows_by_run[names[0]]["shake_frequency_hz"]
    rows.append(make_still(project, clips[shown.FIRST], frequency_hz, device.alias))
    record = Record(
        section=shown.CLIPS,
        identity=identity,
        machine=machine("cuda" if device.is_cuda else "cpu"),
        measured={
            "date": datetime.now(timezone.utc).isoformat(timespec="seconds"),
            "commit": commit(),
            "command": "make clips"
            + ("" if project.is_own else f" NEWTON={project.release}"),
            "seconds": round(time.perf_counter() - start, 1),
        },
        units=report().columns.units_of(rows),
        rows=rows,
    )
    path = project.record_path(shown.CLIPS)
    traces = {
        case: packed(path, case, readout_table(clip)) for case, clip in clips.items()
    }
    write_record(path, record, traces)
    print(f"{len(rows)} files in {record.measured['seconds']:.0f} s → {path}")


def readout_table(clip: Clip) -> pd.DataFrame:
    """Return the displacements of each frame over the time of the clip."""
    return (
        pd.DataFrame(clip.readout())
        .round(5)
        .assign(time_s=np.arange(len(clip.frames)) / FRAME_RATE)
    )


def make_clip(
    project: Project, case: str, clip: Clip, device: str
) -> dict[str, object]:
    """Render and encode a clip and its poster (its last picture) and return the row."""
    video = shown.media_path(project, case, "mp4")
    poster = shown.media_path(project, case, "jpg")
    frame_count = len(clip.frames)
    frames = tqdm(
        pictures(clip, device), desc=case, unit="frame", total=frame_count, delay=3.0
    )
    with atomic_file(video) as temporary:
        last = write_video(temporary, frames)
    with atomic_file(poster) as temporary:
        write_image(temporary, last)
    row = {"case": case, **_described("file", video), **_described("poster", poster)}
    row |= {
        "width_px": WIDTH,
        "height_px": HEIGHT,
        "frame_rate_hz": FRAME_RATE,
        "frame_count": frame_count,
    }
    readout = clip.readout()
    row |= {
        "duration_s": frame_count / FRAME_RATE,
        "shake_duration_s": float(readout["time_s"][-1]),
    }
    for name in clip.names:
        column = f"{name}_mm".replace("-", "_")
        slip_mm = float(readout[f"{name}_mm"][-1])
        row |= (
            absent([column], "the cube is out of the grasp")
            if np.isnan(slip_mm)
            else {column: slip_mm}
        )
    return row


def make_still(
    project: Project, clip: Clip, frequency_hz: float, device: str
) -> dict[str, object]:
    """Render the long exposure and return its row.

    The row also names it as the poster, because all rows need the same columns of text.
    """
    path = shown.media_path(project, shown.STILL, "jpg")
    with atomic_file(path) as temporary:
        write_image(temporary, long_exposure(clip, frequency_hz, device))
    width, height = STILL
    row = {
        "case": shown.STILL,
        **_described("file", path),
        **_described("poster", path),
    }
    return row | {"width_px": width, "height_px": height, "magnified": MAGNIFIED}


def _described(kind: str, path: Path) -> dict[str, object]:
    return {
        kind: path.name,
        f"{kind}_sha256": shown.sha256(path),
        f"{kind}_bytes": path.stat().st_size,
    }


if __name__ == "__main__":
    sys.exit(main())
