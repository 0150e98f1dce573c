"""Queries: a claim or a value that editions are asked for, by a command or by ``report.toml``, which must not err."""

import ast
import math
import re
import sys
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from difflib import get_close_matches
from importlib.util import find_spec
from itertools import chain, pairwise
from pathlib import Path
from statistics import fmean, median
from typing import Any

from measured_report.changes.moves import CHOSEN_SHARE, Move, few
from measured_report.editions.status import aligned
from measured_report.files.config import FILE, config, report
from measured_report.files.errors import ReportError, suggestion
from measured_report.findings.chapters import Chapters, Releases
from measured_report.findings.editions import Edition
from measured_report.findings.sections import file_of, outline_of
from measured_report.parts.claim import WITHIN, Claim
from measured_report.records.code import CARRIED, files, roots_of
from measured_report.records.columns import (
    REASON,
    UNBELIEVED,
    column_of,
    columns_of,
    parameters,
)
from measured_report.records.identity import package_versions, sections
from measured_report.values.format import format_share, label_of
from measured_report.values.noise import FALSE_SHARE, LEAST_RUNS, NORMAL, TINY, Z
from measured_report.values.quantities import Quantity, absent
from measured_report.values.results import Results, Row

Answer = str | float


@dataclass(frozen=True)
class Query:
    text: str  # as CLAIM= or VALUE= says it: `section.claim`, `section.value` or `section.case.column`
    is_claim: bool = False
    label: str = ""
    device: str = ""  # of a case that is there on several devices, the one that is meant, at the least cost

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
        quantity = self.quantity(chapters)
        value: Any = getattr(quantity, "value", quantity)  # yes and no are plain, and texts, of which nothing is told
        return None if isinstance(value, str) else value

    def quantity(self, chapters: Chapters) -> Quantity | bool | str | None:
        """Return the value that is asked for, or what a row has in its place; None where there is none."""
        if self.case:
            return self.cell(chapters)
        chapter = chapters.get(self.section)
        return chapter.results.derived.get(self.column) if chapter else None

    def cell(self, chapters: Chapters, release: str = "") -> Quantity:
        """Return what a row of the edition ``release`` has; no number, and a reason, when that has nothing."""
        alike = config().changes.equivalent_sections
        sections = (self.section, *(alike if self.section in alike else ()))
        rows = (self._row(chapters[section].results) for section in sections if section in chapters)
        if (row := next(filter(None, rows), None)) and self.column in row:
            return row[self.column]
        edition = f" with {config().name_of(release)}" if release else ""
        return absent(self.unit, f"{self.section} has not been measured so{edition}")

    def _row(self, results: Results) -> Row | None:
        if not self.device:
            return results.row[self.case]
        rows = (row for row in results.rows if (row.case, row.plain.get("device")) == (self.case, self.device))
        return min(rows, key=lambda row: [row.plain.get(term) or 0 for term in config().cost_terms], default=None)

    def claim(self, chapters: Chapters) -> Claim | None:
        chapter = chapters.get(self.section)
        claims = chapter.section.claims if chapter else ()
        return next((claim for claim in claims if f"{self.section}.{claim.name}" == self.text), None)

    def names(self, chapters: Chapters) -> Iterator[str]:
        """Yield what an edition can be asked: claims, or else values and, of the section meant, numbers of rows."""
        for name, chapter in chapters.items():
            names = [claim.name for claim in chapter.section.claims] if self.is_claim else chapter.results.derived
            yield from (f"{name}.{label}" for label in names)
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
    release: str
    answer: Answer  # of this edition
    noise: float | None  # how far the truth may be from it; None where nobody knows, or where it is no number
    text: str
    mark: str = ""  # against the answer before: better, worse, moved or flipped; empty where it is the same, or first


def points(releases: Releases, query: Query) -> list[Point]:
    """Return what the editions answer that can, oldest first, with where that changed."""
    answered: list[Point] = []
    for release, chapters in releases.items():
        answer, claim = query.answer(chapters), query.claim(chapters)
        if answer is not None:
            noise = None if claim else getattr(query.quantity(chapters), "noise", None)
            number = "" if claim else f"{answer:.4g}" + (f" ± {noise:.2g}" if noise else "")
            answered.append(Point(release, answer, noise, claim.outcome.answer if claim else number))
    if query.is_claim:
        pairs = enumerate(pairwise(answered), 1)
        marks = {index: "flipped" for index, (before, after) in pairs if before.answer != after.answer}
    else:
        numbers = [float(point.answer) for point in answered]
        ends = [0, *changes_in(numbers, [point.noise for point in answered], query.column), len(numbers)]
        means = {start: fmean(numbers[start:end]) for start, end in pairwise(ends) if numbers}
        marks = {end: Move(query.column, means[start], means[end]).mark for start, end in pairwise(means)}
    return [replace(point, mark=marks.get(index, "")) for index, point in enumerate(answered)]


def changes_in(numbers: Sequence[float], noises: Sequence[float | None], column: str) -> list[int]:
    """Return where a series changed: where it splits best in two that differ, and so on in either.

    Scott and Knott (1974), Biometrics 30, 507-512, with a two-sample test by the noise. Where nobody knows that, it is
    what most neighbours are apart; of few, none.
    """
    if None in noises:
        steps = [abs(after - before) for before, after in pairwise(numbers)]
        usual = Z * median(steps) / (math.sqrt(2) * NORMAL.inv_cdf(0.75)) if len(numbers) >= LEAST_RUNS else 0.0
        return changes_in(numbers, [usual if noise is None else noise for noise in noises], column)
    count, known = len(numbers), [noise or 0.0 for noise in noises]
    apart = {split: abs(fmean(numbers[split:]) - fmean(numbers[:split])) for split in range(1, count)}
    best = max(apart, key=lambda split: apart[split] * math.sqrt(split * (count - split)), default=0)
    if not best or apart[best] <= column_of(column).resolution:
        return []
    error = math.hypot(math.hypot(*known[:best]) / best, math.hypot(*known[best:]) / (count - best)) / Z
    if (count - 1) * math.erfc(apart[best] / max(error, TINY) / math.sqrt(2)) > FALSE_SHARE:
        return []
    later = changes_in(numbers[best:], known[best:], column)
    return [*changes_in(numbers[:best], known[:best], column), best, *(best + index for index in later)]


def history(releases: Releases, query: Query) -> str:
    """Return a line for each edition that answers or says why it can't, oldest first."""
    answered = {point.release: point for point in points(releases, query)}
    lines = [
        (release, point.text, point.mark) if (point := answered.get(release)) else (release, "cannot tell", why)
        for release, chapters in releases.items()
        if (why := _reason(query, chapters)) or release in answered
    ]
    return "\n".join([query.text, aligned(lines) or "no edition can tell"])


def _reason(query: Query, chapters: Chapters) -> str:
    claim, number = query.claim(chapters), query.quantity(chapters)
    if claim:
        return claim.outcome.reason
    return number.reason if isinstance(number, Quantity) and number.source else ""


def refuse_unknown_names(editions: Mapping[str, Edition], edition: Edition | None) -> None:
    """Raise ReportError, one line, for the first name of nothing; what was not measured yet is not asked for."""
    if edition is None or edition.project.profile != "full" or edition.project.root != report().root:
        return
    rules, section_names = config().changes, sections(edition.project.root)
    _refuse_empty_pages(edition)
    if not _is_there(config().host):
        raise ReportError(f"{FILE}: host = {config().host!r}: there is no such module")
    _refuse("noise_section", [config().noise_section], "section", section_names)
    for setting in ("upgrade_sections", "equivalent_sections"):
        _refuse(f"changes.{setting}", getattr(rules, setting), "section", section_names)
    queries = [("thresholds", Query(name)) for name in rules.thresholds]
    queries += [("headlines", Query(name)) for name in rules.headlines.values()]
    queries += [("explanation", Query(rules.explanation, is_claim=True))] if rules.explanation else []
    for setting, query in queries:
        _refuse(f"changes.{setting}", [query.section], "section", section_names)
        answer = query.claim(edition.chapters) if query.is_claim else query.quantity(edition.chapters)
        is_nothing = answer in (None, "") or (isinstance(answer, str) and setting == "thresholds")
        if query.section in edition.chapters and (is_nothing or (isinstance(answer, Quantity) and not answer.source)):
            _refuse(f"changes.{setting}", [query.text], "value", [*query.names(edition.chapters)])
    if chapter := edition.chapters.get(config().noise_section):  # repeats are of cases beside them, if any are
        rows = chapter.results.record.rows
        cases = [row["case"] for row in rows if "of" not in row]
        if unknown := [row["of"] for row in rows if cases and row.get("of", cases[0]) not in cases]:
            raise ReportError(f"{chapter.name}: of = {unknown[0]} names no case{suggestion(str(unknown[0]), cases)}")
    if edition.project.named.is_installed_with(package_versions()):
        _refuse_absent_imports(edition.project.root)
    _refuse("changes.package_groups", chain(*rules.package_groups), "package", config().packages)
    if not edition.left_out:
        columns = {*parameters()}.union(*(columns_of(_rows(edition)) for edition in editions.values()))
        for table in config().columns:
            others = (table.rate_of, table.known_within, table.grows_with, table.trials, table.unless)
            _refuse("columns", (*table.names, *others), "column", columns)
        for setting in ("repeating", "cost_terms"):
            _refuse(setting, getattr(config(), setting), "column", columns)


def _refuse(setting: str, names: Iterable[str], kind: str, existing: Collection[str]) -> None:
    for name in names:
        if name and name not in existing:
            raise ReportError(f"{FILE}: {setting} names {name}, which is no {kind} here{suggestion(name, existing)}")


def _is_there(module: str) -> bool:
    """Tell whether a module can be found, which is not imported: it may take long."""
    try:
        return bool(find_spec(module))
    except ModuleNotFoundError:  # of a package that it is in
        return False


def _refuse_empty_pages(edition: Edition) -> None:
    """Raise ReportError for a page that has neither a template nor a section."""
    pages = {outline_of(section).page for section in sections(edition.project.root)}
    for page in config().pages:
        paths = [edition.project.templates / text for text in page.texts]
        if page not in pages and not any(path.is_file() for path in paths):
            raise ReportError(f"{FILE}: the page {page.name} has no section, nor templates/{page.texts[0]}")


def _refuse_absent_imports(root: Path) -> None:
    """Raise ReportError where a module measures nothing, or imports first of all what is not installed."""
    graph, modules = files().graph(roots_of(root)), [file_of("experiments", section) for section in sections(root)]
    measuring = {path for module in modules if module for path in graph.closure(str(module), CARRIED)}
    for module in filter(None, modules):
        if "measure" not in graph.source(str(module)).top:
            raise ReportError(f"{graph.name_of(str(module))} has no function measure(conditions)")
    for path in sorted(measuring):
        for node in ast.parse(Path(path).read_bytes()).body:
            names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            names += [node.module or ""] if isinstance(node, ast.ImportFrom) and not node.level else []
            for name in names:
                package = name.partition(".")[0]
                if not (package in sys.modules or find_spec(package)):
                    place = f"{graph.name_of(path)}:{node.lineno}"
                    raise ReportError(f"{place}: it imports {name}, and no {package} is installed")


def gaps(edition: Edition) -> list[str]:
    """Say which rows nothing tells apart, what is no number, and which claims can't tell for lack of something."""
    lines = []
    for name, chapter in edition.chapters.items():
        rows = [row for row in chapter.results.record.rows if "of" not in row]
        exact = (tuple(item for item in row.items() if not isinstance(item[1], float)) for row in rows)
        doubles = dict.fromkeys(dict(cells)["case"] for cells, count in Counter(exact).items() if count > 1)
        lines += [f"{name}: several rows of case {case}, which nothing tells apart" for case in doubles]
        texts = ((row["case"], column.removesuffix(REASON), str(cell)) for row in rows for column, cell in row.items())
        lost = ((case, column, text) for case, column, text in texts if text.startswith(UNBELIEVED))
        lines += [f"{name}: {case} has no {column}: {text}" for case, column, text in lost]
        claims, figures = chapter.section.claims, chapter.section.figures.items()
        lines += [f"{name}: the figure {key} has no sources" for key, figure in figures if not figure.sources]
        unread = ((claim.name, number) for claim in claims for number in claim.unread)
        lines += [f"{name}.{claim} prints {number}, which its test has not read" for claim, number in unread]
        for claim, outcome in ((claim.name, claim.outcome) for claim in claims if claim.outcome.name == "unknown"):
            if not outcome.is_inconclusive and outcome.reason != WITHIN:
                lines.append(f"{name}.{claim} cannot tell: {outcome.reason}")
    return lines


def blind_spots(edition: Edition) -> list[str]:
    """Say of which columns no noise is known, and which thresholds raise an alarm later than they say, or never."""
    unknown: dict[str, None] = {}
    for chapter in edition.chapters.values():
        for column in chapter.results.record.units:
            is_asked = column_of(column).kinds.isdisjoint(("uncompared", "cost", "parameter", "setting"))
            cells = (row[column] for row in chapter.results.rows if is_asked and row.plain.get(column) is not None)
            unknown |= {column: None} if any(cell.noise is None for cell in cells if cell.value is not None) else {}
    late = []
    for name, threshold in config().changes.thresholds.items():
        number = Query(name).quantity(edition.chapters)
        if isinstance(number, Quantity) and number.value is None and Query(name).section in edition.chapters:
            late.append(f"{name} can raise no alarm: {number.reason}")
        elif isinstance(number, Quantity) and number.value:
            least = CHOSEN_SHARE if number.noise is None else math.sqrt(2) * number.noise / abs(number.value)
            text = f"{name}: threshold {format_share(threshold)}, but noise hides changes below {format_share(least)}"
            late += [text] if least > threshold else []
    return ([f"no noise is known of {few(list(unknown), 8)}"] if unknown else []) + late


def _rows(edition: Edition) -> list[Mapping[str, Any]]:
    return [row for chapter in edition.chapters.values() for row in chapter.results.record.rows]


def idle_labels(editions: Mapping[str, Edition], edition: Edition) -> list[str]:
    """Say which labels are of cases that no edition has, as one that is mistyped, or whose row is lost."""
    lines = []
    for name, chapter in edition.chapters.items():
        records = [same.chapters[name].results.record for same in editions.values() if name in same.chapters]
        names = {str(row[key]) for record in records for row in record.rows for key in ("case", "of") if key in row}
        idle = [label for label in chapter.results.labels if all(label_of(case, {label: ""}) for case in names)]
        lines += [f"{name}: labels has {label}, which is no case here{suggestion(label, names)}" for label in idle]
    return lines


def idle_settings(edition: Edition) -> list[str]:
    """Say which settings are of columns or cells that no row has, as a pattern that is mistyped."""
    rows, settings = _rows(edition), config()
    columns = {*columns_of(rows), *parameters(), ""}
    patterns = [*(table.pattern for table in settings.columns), settings.changes.endings, *settings.changes.keys]
    idle = [pattern for pattern in patterns if not any(re.fullmatch(pattern, column) for column in columns)]
    for name, cells in settings.repeating.items():
        present = {str(row.get(name, parameters().get(name))) for row in rows}
        idle += [f"{name} = {cell}" for cell in map(str, cells) if cell not in present]
    return [f"{FILE}: no row has {name}" for name in idle] if not edition.left_out else []
