"""Make the clips of a release from its kept poses: ``python -m experiments.media.render``, run by ``make clips``."""

import argparse
import importlib.util
import sys
import time
from collections.abc import Mapping
from datetime import datetime, timezone
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import warp as wp
from tqdm import tqdm

from experiments.facts import clip_record as shown
from experiments.facts.kept import kept_run
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
from measured_report.files.errors import ReportError
from measured_report.measuring.machine import commit, machine
from measured_report.records.columns import units_of
from measured_report.records.record import Record, load_record, trace_path, write_record
from measured_report.records.traces import load_trace, packed


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m experiments.media.render", description=__doc__.split(":")[0])
    parser.add_argument("--newton", default=own_release(), help="release whose kept poses are shown")
    parser.add_argument("--device", choices=("cuda", "cpu"), help="default: cuda where there is one")
    parser.add_argument("--profile", choices=PROFILES, default="full")
    arguments = parser.parse_args()
    project = Project(arguments.newton, arguments.profile, own_release=own_release())
    try:
        if importlib.util.find_spec("av") is None:
            raise ReportError("making clips needs PyAV, which encodes them: uv sync --group clips installs it")
        make_clips(project, warp_device(arguments.device))
    except ReportError as error:
        print(error, file=sys.stderr)
        return 2
    return 0


def make_clips(project: Project, device: wp.Device) -> None:
    """Render and encode each clip and the still, and write their record."""
    start = time.perf_counter()
    identity = shown.clips_identity(project)
    if not project.record_path("poses").exists():
        raise ReportError(f"no poses of Newton {project.release} are kept; {project.rerun('poses')} keeps them")
    poses = load_record(project.record_path("poses"))
    clips, path = {}, project.record_path("poses")
    for case, pair in shown.RUNS.items():
        left, right = (kept_run(row_of(poses, run), load_trace(trace_path(path, run))) for run in pair)
        clips[case] = Clip((left, right), shown.RUNS[shown.FIRST])
    rows = [make_clip(project, case, clip, device.alias) for case, clip in clips.items()]
    frequency_hz = row_of(poses, shown.RUNS[shown.FIRST][0])["shake_frequency_hz"]
    rows.append(make_still(project, clips[shown.FIRST], frequency_hz, device.alias))
    record = Record(
        section=shown.CLIPS,
        identity=identity,
        machine=machine("cuda" if device.is_cuda else "cpu"),
        measured={
            "date": datetime.now(timezone.utc).isoformat(timespec="seconds"),
            "commit": commit(),
            "command": "make clips" + ("" if project.is_own else f" NEWTON={project.release}"),
            "seconds": round(time.perf_counter() - start, 1),
        },
        units=units_of(rows),
        rows=rows,
    )
    path = project.record_path(shown.CLIPS)
    traces = {}
    for case, clip in clips.items():  # what is read out in each frame, over the clip's own time
        table = pd.DataFrame(clip.readout()).round(5).assign(time_s=np.arange(len(clip.frames)) / FRAME_RATE)
        traces[case] = packed(path, case, table)
    write_record(path, record, traces)
    print(f"{len(rows)} files in {record.measured['seconds']:.0f} s → {path}")


def row_of(poses: Record, run: str) -> Mapping[str, Any]:
    return next(row for row in poses.rows if row["case"] == run)


def make_clip(project: Project, case: str, clip: Clip, device: str) -> dict[str, object]:
    """Render and encode a clip and its poster, which is its last picture; its row."""
    video, poster = (shown.media_path(project, case, suffix) for suffix in ("mp4", "jpg"))
    frames = tqdm(pictures(clip, device), desc=case, unit="frame", total=len(clip.frames), delay=3.0)
    with atomic_file(video) as temporary:
        last = write_video(temporary, frames)
    with atomic_file(poster) as temporary:
        write_image(temporary, last)
    ends = {name: float(values[-1]) for name, values in clip.readout().items()}
    row = {"case": case, **_described("file", video), **_described("poster", poster)}
    row |= {"width_px": WIDTH, "height_px": HEIGHT, "frame_rate_hz": FRAME_RATE, "frame_count": len(clip.frames)}
    row |= {"duration_s": len(clip.frames) / FRAME_RATE, "shake_duration_s": ends.pop("time_s")}
    for name, value in ends.items():
        column = name.replace("-", "_")
        row[column] = None if np.isnan(value) else value
        row |= {f"{column}_reason": "the cube is out of the grasp"} if np.isnan(value) else {}
    return row


def make_still(project: Project, clip: Clip, frequency_hz: float, device: str) -> dict[str, object]:
    path = shown.media_path(project, shown.STILL, "jpg")
    with atomic_file(path) as temporary:
        write_image(temporary, long_exposure(clip, frequency_hz, device))
    width, height = STILL
    return {
        "case": shown.STILL,
        **_described("file", path),
        **_described("poster", path),  # every row of a record has the same texts
        "width_px": width,
        "height_px": height,
        "magnified": MAGNIFIED,
    }


def _described(kind: str, path: Path) -> dict[str, object]:
    return {kind: path.name, f"{kind}_sha256": shown.sha256(path), f"{kind}_bytes": path.stat().st_size}


if __name__ == "__main__":
    sys.exit(main())
