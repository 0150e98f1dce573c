"""Test that clips show and print the kept runs."""

import re
import shutil
from pathlib import Path

import pytest
from toys import link

from experiments.facts.clip_record import CLIPS, FIRST, RUNS, clips_state
from experiments.facts.kept import kept_run
from experiments.media.clips import Clip
from measured_report.editions.project import Project, own_release
from measured_report.records.record import load_record, trace_path
from measured_report.records.traces import load_trace

OWN = Project(own_release())


@pytest.fixture(scope="module")
def clip(poses_path) -> Clip:
    rows = {row["case"]: row for row in load_record(poses_path).rows}
    left, right = (
        kept_run(rows[run], load_trace(trace_path(poses_path, run)))
        for run in RUNS[FIRST]
    )
    return Clip((left, right), RUNS[FIRST])


@pytest.mark.skipif(
    not OWN.record_path(CLIPS).exists(), reason="no clips were made yet"
)
def test_the_tracked_clips_are_whole_small_and_say_what_was_measured():
    state = clips_state(OWN)
    assert state.kind != "damaged", state.notes
    sizes = [row["file_bytes"] for row in state.record.rows]
    assert (
        max(sizes) <= 1.2e6
        and sum(sizes) + sum(row.get("poster_bytes", 0) for row in state.record.rows)
        <= 4e6
    )
    slips = {
        row["case"]: row["slip_mm"]
        for row in load_record(OWN.record_path("poses")).rows
    }
    readout = load_trace(trace_path(OWN.record_path(CLIPS), FIRST)).iloc[-1]
    [row] = [row for row in state.record.rows if row["case"] == FIRST]
    for run in RUNS[FIRST]:
        assert readout[f"{run}_mm"] == pytest.approx(slips[run], abs=1e-4)
        assert row[f"{run.replace('-', '_')}_mm"] == pytest.approx(slips[run], abs=1e-4)


def _poster_elsewhere(results: Path) -> None:
    record = results / "clips.json"
    own = re.search(r'"poster":"([^"]+)"', record.read_text())
    shutil.copy(
        results / own[1], results.parents[1] / "secret.jpg"
    )  # the same bytes, so that only the place is wrong
    record.write_text(record.read_text().replace(own[0], '"poster":"../../secret.jpg"'))


CLIP_DAMAGES = {
    "replaced": lambda results: next(results.glob("clips.*.mp4")).write_text(
        "<script>alert(1)</script>"
    ),
    "elsewhere": _poster_elsewhere,
}


@pytest.fixture
def project(tmp_path) -> Project:
    """Return a project with copies of the clips."""
    if not OWN.record_path(CLIPS).exists():
        pytest.skip("no clips were made yet")
    link(tmp_path, "experiments", "report", "assets", "pyproject.toml")
    project = Project(own_release(), root=tmp_path)
    project.results.mkdir(parents=True)
    for path in OWN.results.glob("clips.*"):
        shutil.copy(path, project.results)
    return project


@pytest.mark.parametrize("damage", CLIP_DAMAGES.values(), ids=CLIP_DAMAGES)
def test_finding_4_a_clip_that_is_not_the_one_that_was_made_is_named(project, damage):
    assert clips_state(project).kind != "damaged"
    damage(project.results)
    state = clips_state(project)
    assert (
        state.kind == "damaged" and "clips" in state.words and "\n" not in state.words
    )
