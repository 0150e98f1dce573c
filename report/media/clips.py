"""Write the clips of a release as HTML for its pages."""

from dataclasses import dataclass
from pathlib import Path

from markupsafe import Markup

from experiments.facts.clip_record import CLIPS, FIRST, RUNS, STILL, files_of
from measured_report.editions.project import Project
from measured_report.editions.status import State
from measured_report.files.root import ROOT
from measured_report.parts.macros import macros
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results, Row
from report.shared.arithmetic import CASES

MACROS = ROOT / "templates/clips.html.j2"


@dataclass(frozen=True)
class Clips:
    """The clips of a release. Their files are stored beside their record."""

    project: Project
    state: State  # ``fresh`` or ``stale``; clips in other states are not shown
    root: str = ""  # path from the page to the root of the site

    @property
    def results(self) -> Results:
        return Results(self.state.record, self.project.record_path(CLIPS))

    @property
    def files(self) -> list[Path]:
        """Return the files that the site has to contain, the record first."""
        names = [name for name, _ in files_of(self.state.record)]
        return [self.results.path, *map(self.project.results.joinpath, names)]

    def video(self, case: str, caption: Markup) -> Markup:
        """Return a clip that the reader starts. Before that, only its poster is loaded."""
        row = self.results.row[case]
        poster = self.picture if case == FIRST else self._address(row.poster)
        label = (
            "Two runs of the shake side by side, with a plot of both displacements."
            f" {self._slip_text(row)}"
        )
        return macros(MACROS).video(
            row,
            self.root + poster,
            self.root + self._address(row.file),
            label,
            self._sources(row),
            self._with_badge(caption),
        )

    def still(self, link: str, caption: Markup) -> Markup:
        """Return the long exposure, as a link to ``link`` if that is not empty."""
        first = self.results.row[FIRST]
        alt = (
            "The picture shows the hand and the cube in every second cycle of the shake."
            f" {self._slip_text(first)}"
        )
        return macros(MACROS).still(
            self.results.row[STILL],
            self.root + self.picture,
            alt,
            self._sources(first),
            link,
            self._with_badge(caption),
        )

    @property
    def picture(self) -> str:
        """Return the address of the long exposure, relative to the root of the site."""
        return self._address(self.results.row[STILL].file)

    @property
    def magnified(self) -> Quantity:
        """Return the factor by which the long exposure magnifies the displacement."""
        return self.results.row[STILL].magnified

    def _with_badge(self, caption: Markup) -> Markup:
        return macros(MACROS).stale(caption, self.state.words)

    def _slips(self, row: Row) -> dict[str, Quantity]:
        columns = {name: f"{name.replace('-', '_')}_mm" for name in RUNS[FIRST]}
        return {CASES[name]: row[column] for name, column in columns.items()}

    def _sources(self, row: Row) -> str:
        slips = self._slips(row).values()
        return " ".join(slip.source for slip in slips if slip.value is not None)

    def _slip_text(self, row: Row) -> str:
        """Return sentences with the slip in each run, or with the reason why there is
        no slip.
        """
        texts = []
        sentences = []
        for name, slip in self._slips(row).items():
            if slip.reason:
                reason = slip.reason.removeprefix(f"{row.case}: ")
                sentences.append(f"With {name}, {reason}.")
            else:
                texts.append(f"{slip} with {name}")
        if texts:
            slipped = " and ".join(texts)
            sentences.insert(0, f"At the end, the cube has slipped {slipped}.")
        return " ".join(sentences)

    def _address(self, name: str) -> str:
        return f"data/{self.project.results.name}/{name}"
