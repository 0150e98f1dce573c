"""Queries: a claim or a value that editions are asked for, by a command or by ``report.toml``, which must not err."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Any

from measured_report.changes.compare import flips
from measured_report.changes.moves import CHOSEN_SHARE, Move, few
from measured_report.editions.status import aligned
from measured_report.files.config import FILE, config
from measured_report.files.errors import ReportError, suggestion
from measured_report.files.root import ROOT
from measured_report.pages.editions import Chapters, Edition, Releases
from measured_report.parts.claim import NEAR_NOISE, Claim
from measured_report.records.columns import column_of, columns_of, parameters
from measured_report.records.identity import sections
from measured_report.values.quantities import Quantity, absent
from measured_report.values.results import Results, Row

Answer = str | float


@dataclass(frozen=True)
class Query:
    """Ask each edition for a claim, or a value, of the page or of a row."""

    text: str
    """As CLAIM= or VALUE= says it: ``section.claim``, ``section.value`` or ``section.case.column``."""
    is_claim: bool = False
    label: str = ""
    device: str = ""
    """For a section that has the case on several devices, and with one or more worlds: of which to take that of one."""

    @property
    def section(self) -> str:
        return self.text.partition(".")[0]

    @property
    def case(self) -> str:
        """Name the case of a number of a row; empty for others."""
        return self.text.partition(".")[2].rpartition(".")[0]

    @property
    def column(self) -> str:
        return self.text.rpartition(".")[2]

    @property
    def unit(self) -> str:
        return column_of(self.column).unit

    def answer(self, chapters: Chapters) -> Answer | None:
        """Return what the chapters of an edition say; None where they can't tell."""
        if self.is_claim:
            claim = self.claim(chapters)
            return claim.outcome.name if claim and claim.outcome.name != "unknown" else None
        found = self.quantity(chapters)
        value: Any = getattr(found, "value", found)  # yes and no are plain, and so are texts, which nothing is told of
        return None if isinstance(value, str) else value

    def quantity(self, chapters: Chapters) -> Quantity | bool | str | None:
        """Return the value that is asked for, or what a row has in its place; None where there is none."""
        if self.case:
            return self.cell(chapters)
        chapter = chapters.get(self.section)
        return chapter.results.derived.get(self.column) if chapter else None

    def cell(self, chapters: Chapters, release: str = "") -> Quantity:
        """Return what a row of the edition ``release`` has; no number, and a reason, when that has nothing."""
        same = config().changes.same_runs
        sections = (self.section, *(same if self.section in same else ()))
        rows = (self._row(chapters[section].results) for section in sections if section in chapters)
        row = next(filter(None, rows), None)
        if row and self.column in row:
            return row[self.column]
        return absent(self.unit, f"{self.section} has not been measured so with {config().edition_name} {release}")

    def _row(self, results: Results) -> Row | None:
        if not self.device:
            return results.row[self.case]
        rows = (row for row in results.rows if "device" in row and row.worlds.value == 1)
        return next((row for row in rows if (row.case, row.device) == (self.case, self.device)), None)

    def claim(self, chapters: Chapters) -> Claim | None:
        """Return the claim that is asked for; None where there is none."""
        chapter = chapters.get(self.section)
        claims = chapter.section.claims if chapter else ()
        return next((claim for claim in claims if f"{self.section}.{claim.name}" == self.text), None)

    def names(self, chapters: Chapters) -> Iterator[str]:
        """Yield what an edition can be asked: claims, or else values and, of the section meant, numbers of rows."""
        for name, chapter in chapters.items():
            found = [claim.name for claim in chapter.section.claims] if self.is_claim else chapter.results.derived
            yield from (f"{name}.{each}" for each in found)
        for name in [] if self.is_claim else get_close_matches(self.section, chapters, n=1):
            for case, row in chapters[name].results.row.items():
                numbers = (column for column in row.plain if isinstance(row[column], Quantity))
                yield from (f"{name}.{case}.{column}" for column in numbers)

    def is_first(self, answer: Answer, first: Answer, last: Answer) -> bool:
        """Tell whether an answer is the first one rather than the last; of numbers, whether it is nearer."""
        if self.is_claim:
            return answer == first
        return abs(float(answer) - float(first)) < abs(float(answer) - float(last))


@dataclass(frozen=True)
class Point:
    """Hold an answer of one edition."""

    release: str
    answer: Answer
    noise: float | None
    """Difference between two runs; None where nobody knows, or where it is no number."""
    said: str
    mark: str = ""
    """Against the answer before: better, worse, moved or flipped; empty where it is the same, or first."""


def points(releases: Releases, query: Query) -> list[Point]:
    """Return what the editions answer that can, oldest first."""
    found: list[Point] = []
    for release, chapters in releases.items():
        answer, claim = query.answer(chapters), query.claim(chapters)
        if claim and answer is not None:
            mark = "flipped" if found and found[-1].answer != answer else ""
            found.append(Point(release, answer, None, claim.outcome.said, mark))
        elif answer is not None:
            noise = getattr(query.quantity(chapters), "noise", None)
            least = max(noise or 0.0, found[-1].noise or 0.0) if found else 0.0
            mark = Move(query.column, found[-1].answer, answer, least).mark if found else ""
            found.append(Point(release, answer, noise, f"{answer:.4g}" + (f" ± {noise:.2g}" if noise else ""), mark))
    return found


def history(releases: Releases, query: Query) -> str:
    """Return a line for each edition that answers or says why it can't, oldest first."""
    found = {point.release: point for point in points(releases, query)}
    lines = [
        (release, found[release].said, found[release].mark) if release in found else (release, "cannot tell", why)
        for release, chapters in releases.items()
        if (why := _reason(query, chapters)) or release in found
    ]
    return "\n".join([query.text, aligned(lines) or "no edition can tell"])


def _reason(query: Query, chapters: Chapters) -> str:
    claim, number = query.claim(chapters), query.quantity(chapters)
    if claim:
        return claim.outcome.reason
    return number.reason if isinstance(number, Quantity) and number.source else ""


def flip_history(releases: Releases, shown: str) -> str:
    """Return a line for each claim that flips, with what each edition says to it; none where that can't compare."""
    lines = []
    for flip in (flip for flip in flips(releases, shown) if flip.is_decided):
        said = {release: claim.outcome.said for names, claim in flip.said for release in names}
        lines.append((flip.claim, *(said.get(release, "") for release in releases)))
    return "\n".join(["claims that flip", aligned([("", *releases), *lines])]) if lines else "no claim flips"


def refuse_unknown_names(editions: Mapping[str, Edition], own: Edition | None) -> None:
    """Raise ReportError, one line, for the first name of nothing; what was not measured yet is not asked for."""
    if own is None or own.project.profile != "full" or own.project.root != ROOT:
        return
    rules, known = config().changes, sections(own.project.root)
    named = [("noise_section", [config().noise_section]), ("changes.deciding", rules.deciding)]
    for setting, names in [*named, ("changes.same_runs", rules.same_runs)]:
        for name in filter(None, names):
            _refuse(setting, name, "section", known)
    asked = [("thresholds", Query(name)) for name in rules.thresholds]
    asked += [("headlines", Query(name)) for name in rules.headlines.values()]
    for setting, query in [*asked, *([("cause", Query(rules.cause, is_claim=True))] if rules.cause else [])]:
        _refuse(f"changes.{setting}", query.section, "section", known)
        found = query.claim(own.chapters) if query.is_claim else query.quantity(own.chapters)
        if query.section in own.chapters and not (found and (not isinstance(found, Quantity) or found.source)):
            _refuse(f"changes.{setting}", query.text, "value", [*query.names(own.chapters)])
    if not own.left_out:
        rows = (chapter.results.record.rows for each in editions.values() for chapter in each.chapters.values())
        columns = {column for each in rows for column in columns_of(each)} | {*parameters()}
        for setting, name in _columns():
            _refuse(setting, name, "column", columns)


def _columns() -> Iterator[tuple[str, str]]:
    for table in config().columns:
        others = (table.rate_of, table.known_within, table.grows_with, table.trials)
        yield from (("columns", name) for name in (*table.names, *filter(None, others)))
    yield from (("repeating", name) for name in config().repeating)
    yield from (("cost_terms", name) for name in config().cost_terms)


def _refuse(setting: str, name: str, kind: str, known) -> None:
    if name not in known:
        raise ReportError(f"{FILE}: {setting} names {name}, which is no {kind} here{suggestion(name, known)}")


def blind_spots(edition: Edition) -> list[str]:
    """Say of which columns no noise is known, and which thresholds ring later than they say, or never."""
    unknown: dict[str, None] = {}
    for chapter in edition.chapters.values():
        for column in chapter.results.record.units:
            is_asked = column_of(column).kinds.isdisjoint(("chance", "cost", "parameter", "setting"))
            found = (row[column] for row in chapter.results.rows if is_asked and row.plain.get(column) is not None)
            unknown |= {column: None} if any(number.noise is None for number in found) else {}
    late = []
    for name, threshold in config().changes.thresholds.items():
        number = Query(name).quantity(edition.chapters)
        if isinstance(number, Quantity) and number.value is None:
            late.append(f"{name} never, {number.reason}")
        elif isinstance(number, Quantity) and number.value:
            least = NEAR_NOISE * (CHOSEN_SHARE if number.noise is None else number.noise / abs(number.value))
            late += [f"{name} from {100 * least:.2g} %"] if least > threshold else []
    said = [f"no noise is known of {few(list(unknown), 8)}"] if unknown else []
    return said + ([f"thresholds that ring later than they say, or never: {few(late)}"] if late else [])
