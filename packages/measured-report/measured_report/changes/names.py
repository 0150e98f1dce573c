"""Names in ``report.toml``: one of nothing would ask for what is never done, and nobody would be told."""

from collections.abc import Iterator, Mapping

from measured_report.changes.query import Query
from measured_report.files.config import FILE, config
from measured_report.files.errors import ReportError, suggestion
from measured_report.files.root import ROOT
from measured_report.pages.editions import Edition
from measured_report.records.columns import columns_of, parameters
from measured_report.records.identity import sections
from measured_report.values.quantities import Quantity


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
    """Yield the names of columns with the settings that they stand in."""
    for table in config().columns:
        others = (table.given_beside, table.rate_of, table.known_within, table.grows_with, table.trials)
        yield from (("columns", name) for name in (*table.names, *filter(None, others)))
    yield from (("repeating", name) for name in config().repeating)
    yield from (("cost_terms", name) for name in config().cost_terms)


def _refuse(setting: str, name: str, kind: str, known) -> None:
    if name not in known:
        raise ReportError(f"{FILE}: {setting} names {name}, which is no {kind} here{suggestion(name, known)}")
