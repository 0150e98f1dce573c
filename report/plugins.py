"""Add the clips, the replay and the downloads to the pages of this report."""

from collections.abc import Mapping, Sequence
from contextlib import suppress
from functools import cached_property
from pathlib import Path
from typing import Any

from markupsafe import Markup

from experiments.facts.clip_record import CLIPS, FIRST, clips_state
from measured_report.editions.status import State
from measured_report.files.atomic import short_path
from measured_report.files.errors import ReportError
from measured_report.files.root import ROOT
from measured_report.findings.chapters import results_digest
from measured_report.pages import plugins
from measured_report.pages.prose import Templates
from measured_report.parts.section import Section
from measured_report.values.results import ResultsError
from report.media.clips import Clips
from report.media.replay import REPLAY, SCRIPT, replay_page
from report.shared.arithmetic import sections_of
from report.shared.wheel import wheel

LINT = ROOT / "packages/newton-lint"
LAB = (
    ROOT / "assets/lab"
)  # the engine that runs in a page, and the scripts that start it
STEP = ROOT / "assets/step.js"  # the choice of a time step on the front page


class Plugins(plugins.Plugins):
    """The clips, the replay and the downloads of one edition."""

    @cached_property
    def clips(self) -> Clips | None:
        state = self._clips_state
        if not state.record:
            return None
        return Clips(self.edition.project, state, self.edition.root)

    @cached_property
    def _clips_state(self) -> State:
        project = self.edition.project
        state = clips_state(project)
        try:
            if state.record:
                # Pages print these. They raise an error if the record is damaged.
                clips = Clips(project, state)
                _ = clips.picture, clips.video(FIRST, Markup())
        except (AttributeError, LookupError, TypeError, ResultsError) as error:
            place = short_path(project.record_path(CLIPS))
            why = str(error).split()
            note = f"{place}: no clip can be shown ({' '.join(why)})"
            return State(CLIPS, "damaged", notes=(note,))
        return state

    @property
    def left_out(self) -> Sequence[State]:
        return [self._clips_state] if self._clips_state.kind == "damaged" else []

    @cached_property
    def replay(self) -> dict[str, Any] | None:
        """Return the runs of the replay, or None unless all of them are stored and complete."""
        if "poses" not in self.edition.chapters:
            return None
        project = self.edition.project
        results = self.edition.chapters["poses"].results

        def make() -> dict[str, Any] | None:
            # Imported here because importing NumPy is slow.
            from report.media.packed import packed_runs

            with suppress(ReportError, LookupError, TypeError, ValueError):
                return packed_runs(results)
            return None

        name = f"{project.profile}.{project.release}.replay"
        code = Path(__file__).parent / "media/packed.py"
        return self.edition.cache.value(name, code, [results_digest(results)], make)

    @property
    def picture(self) -> str:  # type: ignore[override]
        return self.clips.picture if self.clips else ""

    def names(self, section: Section) -> Mapping[str, Any]:
        sections = sections_of(self.edition.chapters)
        chapters = self.edition.chapters.values()
        records = [chapter.results.record for chapter in chapters]
        machine = ""
        packages = {}
        if records:
            machine = records[0].machine_text.partition(" (")[0]
            packages = records[0].identity.packages
        # These two packages decide most results. The foot of the page lists all
        # packages.
        engine = (self.edition.report.settings.edition, "mujoco-warp")
        engines = [f"{name} {packages[name]}" for name in engine if name in packages]
        return {
            "value": sections.value,
            "cell": sections.cell,
            "clips": self.clips,
            "replay": REPLAY if self.replay else "",
            "machine": machine,
            "packages": " and ".join(engines),
            "lint": wheel(LINT)[0],
            "root": self.edition.root,
        }

    @property
    def data(self) -> Sequence[Path]:
        return self.clips.files if self.clips else ()

    def pages(self, templates: Templates) -> Mapping[str, str]:
        """Return the page of the replay if all of its runs are stored."""
        if not self.replay:
            return {}
        project = self.edition.project
        poses = self.edition.chapters["poses"]
        return {
            REPLAY: replay_page(
                project, poses, self.replay, self.clips, templates, self.edition.root
            )
        }

    @property
    def files(self) -> Mapping[str, Path | bytes]:
        name, packed = wheel(LINT)
        files = (
            (*LAB.glob("dist/*"), LAB / "lab.css")
            if "lab" in self.edition.chapters
            else ()
        )
        return {
            f"download/{name}": packed,
            **{f"lab/{file.name}": file for file in files},
            **({SCRIPT.name: SCRIPT} if self.replay else {}),
            **({STEP.name: STEP} if "time_step" in self.edition.chapters else {}),
        }


def scripts() -> Sequence[str]:
    return (
        SCRIPT.read_text(encoding="utf-8"),
        STEP.read_text(encoding="utf-8"),
        *(path.read_text(encoding="utf-8") for path in LAB.glob("dist/*.js")),
    )
