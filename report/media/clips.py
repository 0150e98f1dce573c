"""How a page shows the clips of a release."""

from dataclasses import dataclass
from pathlib import Path

from markupsafe import Markup

from experiments.facts.clip_record import CLIPS, FIRST, RUNS, STILL, files_of
from measured_report.editions.project import Project
from measured_report.editions.status import State
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results, Row
from report.story.found import CASES


@dataclass(frozen=True)
class Clips:
    """The clips of a release as a page shows them; their files lie below ``data/``, beside those of its record."""

    project: Project
    state: State
    """``fresh`` or ``stale``: others are not shown."""
    root: str = ""
    """The way from the page to the root of the site."""

    @property
    def results(self) -> Results:
        return Results(self.state.record, self.project.record_path(CLIPS))

    @property
    def files(self) -> list[Path]:
        """Return what the site has to carry, the record first."""
        return [self.results.path, *(self.project.results / name for name, _ in files_of(self.state.record))]

    def video(self, case: str, caption: Markup) -> Markup:
        """Return a clip that plays when asked to, and nothing of which is fetched before, but for its poster."""
        row = self.results.row[case]
        size = (row.width_px.value, row.height_px.value)
        files = (self.root + self._address(file) for file in (row.poster, row.file))
        label = f"Two further runs side by side, with a plot of both displacements. At the end: {self._said(row)}."
        return Markup(
            '<figure class="clip"><video controls muted playsinline preload="none" width="{}" height="{}" poster="{}" '
            'src="{}" aria-label="{}"{}></video><figcaption>{}</figcaption></figure>'
        ).format(*size, *files, label, self._sources(row), self._marked(caption))

    def still(self, link: str, caption: Markup) -> Markup:
        """Return the long exposure, which leads to ``link``, where there is one."""
        row, first = self.results.row[STILL], self.results.row[FIRST]
        alt = f"The hand and the cube in it, every second cycle drawn into one picture: {self._said(first)}."
        image = Markup('<img src="{}" width="{}" height="{}" alt="{}"{} loading="lazy">').format(
            self.root + self.picture, row.width_px.value, row.height_px.value, alt, self._sources(first)
        )
        linked = Markup('<a href="{}">{}</a>').format(link, image) if link else image
        caption = self._marked(caption)
        return Markup('<figure class="clip">{}<figcaption>{}</figcaption></figure>').format(linked, caption)

    @property
    def picture(self) -> str:
        """Return the address of the long exposure, seen from the root of the site."""
        return self._address(self.results.row[STILL].file)

    def _marked(self, caption: Markup) -> Markup:
        notes = self.state.words
        return caption + Markup(' <span class="badge" title="{}">stale</span>').format(notes) if notes else caption

    def _moved(self, row: Row) -> dict[str, Quantity]:
        return {CASES[name]: row[f"{name.replace('-', '_')}_mm"] for name in RUNS[FIRST]}

    def _sources(self, row: Row) -> Markup:
        there = [slip.source for slip in self._moved(row).values() if slip.value is not None]
        return Markup(' data-src="{}"').format(" ".join(there)) if there else Markup("")

    def _said(self, row: Row) -> str:
        moved = self._moved(row)
        return ", ".join(f"{name} {slip.reason if slip.value is None else slip}" for name, slip in moved.items())

    def _address(self, name: str) -> str:
        return f"data/{self.project.results.name}/{name}"
