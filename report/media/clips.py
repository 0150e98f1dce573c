"""How a page shows the clips of a release."""

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
    """The clips of a release as a page shows them; their files lie beside its record."""

    project: Project
    state: State  # ``fresh`` or ``stale``: others are not shown
    root: str = ""  # the way from the page to the root of the site

    @property
    def results(self) -> Results:
        return Results(self.state.record, self.project.record_path(CLIPS))

    @property
    def files(self) -> list[Path]:
        """Return what the site has to carry, the record first."""
        names = [name for name, _ in files_of(self.state.record)]
        return [self.results.path, *map(self.project.results.joinpath, names)]

    def video(self, case: str, caption: Markup) -> Markup:
        """Return a clip that plays when asked to; only its poster is fetched before."""
        row = self.results.row[case]
        poster = self.picture if case == FIRST else self._address(row.poster)
        label = (
            "Two runs side by side, with a plot of both displacements."
            f" At the end of the film: {self._said(row)}."
        )
        return macros(MACROS).video(
            row,
            self.root + poster,
            self.root + self._address(row.file),
            label,
            self._sources(row),
            self._marked(caption),
        )

    def still(self, link: str, caption: Markup) -> Markup:
        """Return the long exposure, which leads to ``link``, if any."""
        first = self.results.row[FIRST]
        alt = (
            "The hand and the cube in it, every second cycle drawn into one picture:"
            f" {self._said(first)}."
        )
        return macros(MACROS).still(
            self.results.row[STILL],
            self.root + self.picture,
            alt,
            self._sources(first),
            link,
            self._marked(caption),
        )

    @property
    def picture(self) -> str:
        """Return the address of the long exposure, seen from the root of the site."""
        return self._address(self.results.row[STILL].file)

    @property
    def magnified(self) -> Quantity:
        """Return how many times the displacement is in it."""
        return self.results.row[STILL].magnified

    def _marked(self, caption: Markup) -> Markup:
        return macros(MACROS).stale(caption, self.state.words)

    def _moved(self, row: Row) -> dict[str, Quantity]:
        columns = {name: f"{name.replace('-', '_')}_mm" for name in RUNS[FIRST]}
        return {CASES[name]: row[column] for name, column in columns.items()}

    def _sources(self, row: Row) -> str:
        slips = self._moved(row).values()
        return " ".join(slip.source for slip in slips if slip.value is not None)

    def _said(self, row: Row) -> str:
        slips = self._moved(row).items()
        return ", ".join(f"{name} {slip.reason or slip}" for name, slip in slips)

    def _address(self, name: str) -> str:
        return f"data/{self.project.results.name}/{name}"
