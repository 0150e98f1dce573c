"""Check ``report.toml`` against the results, and list gaps in the results."""

import math
import re
from collections import Counter
from collections.abc import Collection, Iterable, Mapping
from itertools import chain
from typing import Any

from measured_report.changes.moves import CHOSEN_SHARE
from measured_report.changes.query import Query
from measured_report.files.columns import columns_of, implausible_cells, is_number
from measured_report.files.config import FILE
from measured_report.files.errors import ReportError, suggestion
from measured_report.findings.editions import Edition
from measured_report.parts.claim import WITHIN
from measured_report.parts.section import unrecorded
from measured_report.records.identity import package_versions, sections
from measured_report.values.evidence import key_of, split_repeats
from measured_report.values.format import format_share
from measured_report.values.quantities import Quantity

JITTER = 0.01  # the largest relative change of a setting in a repeat


def refuse_unknown_names(
    editions: Mapping[str, Edition], edition: Edition | None
) -> None:
    """Raise ReportError for the first name in report.toml that does not exist.

    The values of sections that were not measured yet are not checked.
    """
    if edition is None or edition.project.profile != "full":
        return
    report = edition.project.report
    measurable = sections(edition.project.root)
    if report.root.resolve() != edition.project.root.resolve():
        # The results belong to another folder and may lack names of this report.
        return
    settings = report.settings
    rules = settings.changes
    _refuse("noise_section", [settings.noise_section], "section", measurable)
    for setting in ("upgrade_sections", "equivalent_sections"):
        _refuse(f"changes.{setting}", getattr(rules, setting), "section", measurable)
    queries = [("thresholds", Query(name)) for name in rules.thresholds]
    queries += [("headlines", Query(name)) for name in rules.headlines.values()]
    if rules.explanation:
        queries.append(("explanation", Query(rules.explanation, is_claim=True)))
    for setting, query in queries:
        _refuse(f"changes.{setting}", [query.section], "section", measurable)
        if query.section in edition.chapters and not _exists(query, edition):
            names = [*query.names(edition.chapters)]
            _refuse(f"changes.{setting}", [query.text], "value", names)
    lists = {
        "changes.package_groups": rules.package_groups,
        "implied": settings.implied.items(),
    }
    for setting, groups in lists.items():
        _refuse(setting, chain(*groups), "package", settings.packages)
    if edition.left_out:
        return
    columns = {*report.columns.parameters}
    for measured_edition in editions.values():
        columns.update(_columns_of(measured_edition))
    for table in settings.columns:
        related_columns = (
            table.rate_of,
            table.known_within,
            table.grows_with,
            table.trials,
            table.unless,
        )
        _refuse("columns", (*table.names, *related_columns), "column", columns)
    for setting in ("repeating", "cost_terms"):
        _refuse(setting, getattr(settings, setting), "column", columns)


def _refuse(
    setting: str, names: Iterable[str], kind: str, existing: Collection[str]
) -> None:
    for name in names:
        if name and name not in existing:
            similar = suggestion(name, existing)
            raise ReportError(
                f"{FILE}: {setting} names {name}, which is not a {kind} of this "
                f"report: correct the name{similar}"
            )


def _exists(query: Query, edition: Edition) -> bool:
    """Return whether a claim or number exists, even if the number could not be measured."""
    if query.is_claim:
        return query.claim(edition.chapters) is not None
    number = query.quantity(edition.chapters)
    return isinstance(number, bool) or (
        isinstance(number, Quantity) and bool(number.source)
    )


def _columns_of(edition: Edition) -> list[str]:
    chapters = edition.chapters.values()
    return columns_of(
        [row for chapter in chapters for row in chapter.results.record.rows]
    )


def gaps(edition: Edition) -> list[str]:
    """Return a line for each gap in the results.

    Gaps are rows that cannot be distinguished, missing numbers, figures without
    sources, claims that cannot tell, and claims that print untested numbers.
    """
    lines = []
    every_case = {
        row["case"]
        for chapter in edition.chapters.values()
        for row in chapter.results.record.rows
    }
    for name, chapter in edition.chapters.items():
        columns = edition.report.columns
        rows, repeats = split_repeats(chapter.results.record.rows, name, columns)
        keys = Counter(key_of(row, columns) for row in rows)
        for row in rows:
            if keys.pop(key_of(row, columns), 1) > 1:
                lines.append(
                    f"{name}: case {row['case']} has several rows that cannot be "
                    "distinguished"
                )
        cases = {row["case"] for row in rows if "of" not in row}
        if name == columns.settings.noise_section:  # It can repeat any case.
            cases = every_case
            if edition.left_out:  # One of these sections may have the case.
                cases = cases | {row["of"] for row in repeats}
        for row in [*rows, *repeats] if repeats else []:
            if row.get("of", row["case"]) not in cases:
                lines.append(
                    f"{name}: case {row['case']} repeats {row['of']}, which is not a "
                    "case, or repeats another one"
                )
        originals = {row["case"]: row for row in rows}
        set_columns = {
            column
            for column in columns_of(repeats)
            if columns[column].is_setting or column in columns.settings.repeating
        }
        lines += {
            f"{name}: {column} of {row['of']} is {original[column]}, and that of a repeat "
            f"is {row[column]}: repeat a case with its own settings": None
            for row in repeats
            if (original := originals.get(row["of"]))
            for column in sorted(set_columns & row.keys() & original.keys())
            if not _is_same(row[column], original[column])
        }
        for column in chapter.results.record.units:
            if problem := columns.unit_problem(column):
                lines.append(f"{name}: {problem}")
        for row in rows:
            for column, reason in implausible_cells(row).items():
                lines.append(f"{name}: {row['case']} has no {column}: {reason}")
        for key, figure in chapter.section.figures.items():
            if not figure.is_there:
                reasons = [source.reason for source in figure.sources]
                lines.append(
                    f"{name}: figure {key} is left out: {[*reasons, 'no sources'][0]}"
                )
            else:
                for reason in unrecorded(figure.sources):
                    lines.append(f"{name}: figure {key} lacks a source: {reason}")
        for key, table in chapter.section.tables.items():
            for reason in getattr(table, "missing", ()):
                lines.append(f"{name}: table {key} lacks a number: {reason}")
        for claim in chapter.section.claims:
            for number in claim.unread(columns):
                lines.append(
                    f"{name}.{claim.name} is given {number}, which its test does not read"
                )
            outcome = claim.outcome
            is_near = outcome.is_inconclusive or outcome == WITHIN
            if outcome.name == "unknown" and not is_near:
                lines.append(f"{name}.{claim.name} cannot tell: {outcome.reason}")
    return lines


def blind_spots(edition: Edition) -> list[str]:
    """Return a line for each threshold below the noise or with a missing number."""
    lines = []
    for name, threshold in edition.project.report.settings.changes.thresholds.items():
        query = Query(name)
        number = query.quantity(edition.chapters)
        if not isinstance(number, Quantity) or query.section not in edition.chapters:
            continue
        if number.value is None:
            lines.append(f"{name} cannot raise an alarm: {number.reason}")
        elif number.value:
            least = CHOSEN_SHARE
            if number.noise is not None:
                least = math.sqrt(2) * number.noise / abs(number.value)
            if least > threshold:
                hidden = f"noise hides changes below {format_share(least)}"
                lines.append(
                    f"{name} has the threshold {format_share(threshold)}, but {hidden}"
                )
    return lines


def idle_settings(edition: Edition) -> list[str]:
    """Return a line for each setting that names a column or cell which does not exist
    in any row, and for each page that does not exist. The cause may be a typing error
    in a pattern.
    """
    if edition.left_out:
        return []
    schema = edition.project.report.columns
    settings = schema.settings
    columns = {*_columns_of(edition), *schema.parameters, ""}
    patterns = [table.pattern for table in settings.columns]
    patterns += [settings.changes.endings, *settings.changes.keys]
    idle = [
        pattern
        for pattern in patterns
        if not any(re.fullmatch(pattern, column) for column in columns)
    ]
    for name, cells in settings.repeating.items():
        present = {
            str(row.get(name, schema.parameters.get(name)))
            for chapter in edition.chapters.values()
            for row in chapter.results.record.rows
        }
        idle += [f"{name} = {cell}" for cell in cells if str(cell) not in present]
    packages = {*package_versions(settings), *settings.implied}.union(
        *(
            chapter.results.record.identity.packages
            for chapter in edition.chapters.values()
        )
    )
    lines = [f"{FILE}: no row has {name}" for name in idle]
    lines += [
        f"{FILE}: page {page.name} has no section and is left out: set always = true, "
        "or name the page in a section"
        for page in settings.pages
        if page not in edition.pages
    ]
    return lines + [
        f"{FILE}: packages names {name}, which is not installed: correct the name"
        for name in settings.packages
        if name not in packages
    ]


def _is_same(first: Any, second: Any) -> bool:
    """Return whether settings are the same, or differ as little as for a repeat."""
    if is_number(first) and is_number(second):
        return math.isclose(first, second, rel_tol=JITTER)
    return first == second
