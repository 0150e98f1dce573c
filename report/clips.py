"""The clips of a release: what they were made from, whether it is still what there is, and how a page shows them."""

import hashlib
from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path

from markupsafe import Markup

from report.records.identity import Identity, changes, files_digest, identity_of
from report.records.project import Project
from report.records.record import Record, RecordError, load_record
from report.records.status import State
from report.records.traces import trace_path
from report.results import Results, Row

CLIPS = "clips"
RUNS = {"3cm": ("as-shipped", "stiff-pads"), "10cm": ("as-shipped-10cm", "stiff-pads-10cm")}
"""The runs of section poses that each clip shows, left and right."""
FIRST = "3cm"
STILL = "long-exposure"
"""The picture of the runs of FIRST."""
MESHES = "assets/visual"


def media_path(project: Project, case: str, suffix: str) -> Path:
    """Where a clip, its poster or the still lies, beside its record."""
    return project.results / f"{CLIPS}.{case}.{suffix}"


def clips_identity(project: Project) -> Identity:
    """What the clips depend on: the code that makes them, the meshes, and the kept poses; not the packages."""
    own = identity_of(CLIPS, project.profile, project.root, packages={})
    poses = [trace_path(project.record_path("poses"), run) for runs in RUNS.values() for run in runs]
    files = [*(project.root / MESHES).glob("*.*"), *poses]
    found = {path.relative_to(project.root).as_posix(): sha256(path) for path in files if path.is_file()}
    return replace(own, config=files_digest(files, project.root), files={**own.files, **found})


def sha256(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def clips_state(project: Project) -> State:
    """Whether the clips are there, whole, and made from what there is now."""
    path = project.record_path(CLIPS)
    if not path.exists():
        return State(CLIPS, "missing")
    try:
        record = load_record(path)
    except RecordError as error:
        return State(CLIPS, "damaged", notes=(str(error),))
    wrong = [name for name, digest in _listed(record) if _digest(path.with_name(name)) != digest]
    if wrong:
        return State(CLIPS, "damaged", notes=tuple(f"{name} is not the file that was made" for name in wrong))
    changed = changes(record.identity, clips_identity(project))
    return State(CLIPS, "stale" if changed else "fresh", record, tuple(changed))


def _listed(record: Record) -> Iterable[tuple[str, str]]:
    """Name and digest of each file that was made."""
    for row in record.rows:
        yield row["file"], row["file_sha256"]
        if "poster" in row:
            yield row["poster"], row["poster_sha256"]


def _digest(path: Path) -> str | None:
    return sha256(path) if path.is_file() else None


@dataclass(frozen=True)
class Clips:
    """The clips of a release as a page shows them; their files lie below ``data/``, beside those of its record."""

    project: Project
    state: State
    """``fresh`` or ``stale``: others are not shown."""

    @property
    def results(self) -> Results:
        return Results(self.state.record, self.project.record_path(CLIPS))

    @property
    def files(self) -> list[Path]:
        """What the site has to carry, the record first."""
        path = self.results.path
        return [path, *(path.with_name(name) for name, _ in _listed(self.state.record))]

    def video(self, case: str, caption: Markup) -> Markup:
        """A clip that plays when asked to, and nothing of which is fetched before, but for its poster."""
        row = self.results.row[case]
        return Markup(
            '<figure class="clip"><video controls muted playsinline preload="none" width="{}" height="{}" poster="{}" '
            'src="{}" aria-label="{}"></video><figcaption>{}</figcaption></figure>'
        ).format(
            row.width_px.value,
            row.height_px.value,
            self._address(row.poster),
            self._address(row.file),
            f"{self._said(row)}, side by side, with a plot of both displacements that grows.",
            caption,
        )

    def still(self, link: str, caption: Markup) -> Markup:
        """The long exposure, which leads to ``link``."""
        row, first = self.results.row[STILL], self.results.row[FIRST]
        alt = f"The hand and the cube in it, every second cycle drawn into one picture: {self._said(first)}."
        return Markup(
            '<figure class="clip"><a href="{}"><img src="{}" width="{}" height="{}" alt="{}"></a>'
            "<figcaption>{}</figcaption></figure>"
        ).format(link, self._address(row.file), row.width_px.value, row.height_px.value, alt, caption)

    def _said(self, row: Row) -> str:
        """The runs of a clip, and what is read out at its end."""
        names = (name.replace("-", "_") for name in RUNS[FIRST])
        return ", ".join(f"{name.replace('_', ' ')} {row[f'{name}_mm']}" for name in names)

    def _address(self, name: str) -> str:
        return f"data/{self.project.results.name}/{name}"


def clips_of(project: Project) -> Clips | None:
    """The clips of a release; None when there are none that can be shown."""
    state = clips_state(project)
    return Clips(project, state) if state.record else None
