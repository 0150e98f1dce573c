"""Find the clips of a release and check whether their sources have changed."""

import hashlib
import re
from dataclasses import replace
from pathlib import Path

from measured_report.editions.project import Project
from measured_report.editions.status import State
from measured_report.files.atomic import RecordError, read_file, short_path
from measured_report.records.identity import (
    Identity,
    changes,
    files_digest,
    identity_at,
)
from measured_report.records.record import Record, load_record, trace_path

CLIPS = "clips"
BYTE_LIMIT = 64 << 20
RUNS = {
    "3cm": ("as-shipped", "stiff-pads"),
    "10cm": ("as-shipped-10cm", "stiff-pads-10cm"),
}
"""The runs of section poses that each clip shows, left and right."""
FIRST = "3cm"
STILL = "long-exposure"  # the picture that shows the runs of FIRST
MESHES = "assets/visual"


def media_path(project: Project, case: str, suffix: str) -> Path:
    """Return the path of a clip, its poster or the still, next to the record."""
    return project.results / f"{CLIPS}.{case}.{suffix}"


def clips_identity(project: Project) -> Identity:
    """Return the identity of the clips.

    They depend on the code that renders them, the meshes and the kept poses, but not on
    packages.
    """
    identity = identity_at(
        "experiments.media.clips", project.profile, project.root, packages={}
    )
    poses = [
        trace_path(project.record_path("poses"), run)
        for runs in RUNS.values()
        for run in runs
    ]
    files = [*(project.root / MESHES).glob("*.*"), *poses]
    digests = {
        path.relative_to(project.root).as_posix(): sha256(path)
        for path in files
        if path.is_file()
    }
    config = hashlib.sha256(
        (identity.config + files_digest(files, project.root)).encode()
    ).hexdigest()
    return replace(identity, config=config, files={**identity.files, **digests})


def sha256(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def clips_state(project: Project) -> State:
    """Return the state of the clips: missing, damaged, stale or fresh."""
    path = project.record_path(CLIPS)
    if not path.exists():
        return State(CLIPS, "missing")
    try:
        record = load_record(path)
    except RecordError as error:
        return State(CLIPS, "damaged", notes=(str(error),))
    try:
        wrong = [
            name for name, digest in files_of(record) if _digest(path, name) != digest
        ]
    except (KeyError, TypeError, ValueError) as error:
        message = " ".join(str(error).split())
        return State(
            CLIPS,
            "damaged",
            notes=(f"{short_path(path)} names no files of its own: {message}",),
        )
    if wrong:
        notes = tuple(
            f"{short_path(path)}: {name} is not the file that was made"
            for name in wrong
        )
        return State(CLIPS, "damaged", notes=notes)
    changed = changes(record.identity, clips_identity(project))
    return State(CLIPS, "stale" if changed else "fresh", record, tuple(changed))


def files_of(record: Record) -> list[tuple[str, str]]:
    """Return the name and digest of each file in a record."""
    return [
        (row[kind], row[f"{kind}_sha256"])
        for row in record.rows
        for kind in ("file", "poster")
    ]


def _digest(record: Path, name: str) -> str:
    """Return the digest of a file beside the record, or an empty string.

    Raise ValueError for a name that leads to another folder.
    """
    if not re.fullmatch(rf"{CLIPS}\.[\w.-]+", name):
        raise ValueError(f"{name!r:.80} is no name of a file there")
    try:
        return hashlib.sha256(read_file(record.with_name(name), BYTE_LIMIT)).hexdigest()
    except RecordError:
        return ""
