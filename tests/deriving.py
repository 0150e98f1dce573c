"""Derive sections from tracked records in which a test sets some cells.

A test sets cells by case, ``{"pad-mu-0.2": {"slip_mm": 6.5}}``; later ones override
earlier ones. In a case ``*`` stands for any text, and the cells are then set only in
rows that have the column. A case may be followed by its device and number of worlds,
``"without-all cuda 1"``. To remove the rows of a case, set it to ``None``. ``("poses", "arc"): 0.1`` sets
a value of another section, ``("cure", "plain-c"): {...}`` cells of another section, and
``(NOISE, "slip_mm"): 0.1`` the noise of each number in a column.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from fnmatch import fnmatchcase
from functools import cache
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pandas as pd
import pytest
from current_columns import units_of
from markupsafe import Markup

from measured_report.editions.project import Project
from measured_report.findings.sections import derive_section, outline_of
from measured_report.parts.section import Section
from measured_report.records.record import Record, load_record
from measured_report.values.evidence import Evidence, Repeats
from measured_report.values.noise import Z
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results, Series
from tests.perturbed import load_trace_once

NOISE = "noise of"
NOISES = dict.fromkeys(
    (
        *("along_mm", "creep_mm_s", "displacement_mm", "friction_residual_mm"),
        *("increment_final_mm", "normal_residual_mm", "slide_mm", "numerical_error_mm"),
        *("grasp_error_mm_per_cycle", "left_out_mm_s", "step_mm_s"),
    ),
    1e-9,
)
NOISES |= {"slip_mm": 0.001, "drift_mm_s": 0.0001}
"""Noise of columns unless a test sets it. The noise of other columns is unknown."""
RUN_COUNT = 10**9  # enough runs to know their scatter
FLAGS = {
    ("drift_law", "law/follows"): ["follows"],
    ("envelope", "maps/keeps"): ["stiff_pads_never_drop"],
    ("envelope", "maps/drops"): ["as_shipped_drops"],
    ("error_runtime", "numerical/rk4_warp"): ["rk4_warp"],
    ("hold", "motion/is_so"): ["creep_goes_on", "stiff_pads_keep_creep"],
    ("scenes", "creep/predicted"): ["predicted"],
    ("stability", "maps/is_so"): ["safe_settings"],
    ("stiffness", "sweep/is_so"): ["ke_alone_does_not_help", "together_they_hold"],
}
"""Claims that have to hold if a flag of a figure is set."""


@dataclass(frozen=True)
class TracedResults(Results):
    """Holds results with traces, which are read once or replaced by one given trace."""

    frame: pd.DataFrame | None = None

    def loaded(self, path: Path) -> pd.DataFrame:
        return load_trace_once(path)

    def trace(self, case: str) -> Series:
        if self.frame is None:
            return super().trace(case)
        return Series(self.frame, f"{case}.csv.gz")


@cache
def tracked(section: str, release: str) -> Record:
    """Return the full record, or the quick one if a section has no full record yet."""
    full = Project(release).record_path(section)
    if full.exists():
        return load_record(full)
    quick = load_record(Project(release, "quick").record_path(section))
    return replace(quick, machine=tracked("noise", release).machine)


@cache
def read(section: str, release: str) -> Results:
    """Return the tracked results of a section that another one reads."""
    found = results_with(section, release=release)
    if not outline_of(section).compares:
        derive_section(found, {})
    return found


def results_with(
    section: str,
    *changes: Mapping[Any, Any],
    release: str = "1.4.0",
    frame: pd.DataFrame | None = None,
) -> TracedResults:
    """Return the results of a section with some cells set and nothing derived yet."""
    outline = outline_of(section)
    record = tracked(section, release)
    others = {other: read(other, release) for other in outline.reads}
    noises = dict(NOISES)
    for place, new in (item for change in changes for item in change.items()):
        if isinstance(place, str):
            record = with_cells(record, place, new)
        elif place[0] == NOISE:
            noises[place[1]] = new
        else:
            others[place[0]] = changed(others[place[0]], {place[1]: new})
    repeats = {
        name: Repeats(1e9, (noise / Z) ** 2, RUN_COUNT)
        for name, noise in noises.items()
    }
    return TracedResults(
        record,
        Project(release).record_path(section),
        others,
        evidence=Evidence(repeats={"runs": repeats}),
        label=outline.label,
        labels=outline.labels,
        frame=frame,
    )


def chapters_with(
    *changes: Mapping[str, Mapping[str, Any]], release: str = "1.4.0"
) -> dict[str, Any]:
    """Return tracked chapters by section with some cells and values set, as if another
    release had been measured.
    """
    chapters = {}
    for section in dict.fromkeys(name for change in changes for name in change):
        results = read(section, "1.4.0")
        for change in changes:
            results = changed(results, change.get(section, {}))
        identity = results.record.identity
        identity = replace(identity, packages=identity.packages | {"newton": release})
        results = replace(results, record=replace(results.record, identity=identity))
        chapters[section] = SimpleNamespace(results=results, section=Section())
    return chapters


def changed(results: Results, changes: Mapping[str, Any]) -> Results:
    """Return results with cells of cases, or derived values, set."""
    for name, new in changes.items():
        if isinstance(new, Mapping):
            results = replace(results, record=with_cells(results.record, name, new))
        else:
            value = replace(results.derived[name], value=new, noise=0.0)
            results = replace(results, derived=results.derived | {name: value})
    return results


def with_cells(record: Record, case: str, cells: Mapping[str, Any] | None) -> Record:
    """Return a record with some cells of a case set. A case without a row gets one."""
    rows = [dict(row) for row in record.rows]
    mine = [row for row in rows if fnmatchcase(name_of(row, case), case)]
    if cells is None:
        rows = [row for row in rows if row not in mine]
    elif not mine:
        assert "*" not in case, f"{record.section} has no {case}"
        mine = [{"case": case}]
        rows += mine
    for row in mine if cells else ():
        for column, value in cells.items():
            if "*" in case and column not in row:
                continue
            row.pop(f"{column}_reason", None)
            row[column] = value
            if value is None:
                row[f"{column}_reason"] = "as a test"
    return replace(record, rows=rows, units=record.units | units_of(rows))


def name_of(row: Mapping[str, Any], case: str) -> str:
    """Return the case of a row, with its device and worlds if ``case`` contains them."""
    columns = [name for name in ("device", "worlds") if name in row and " " in case]
    return " ".join(str(row[name]) for name in ("case", *columns))


def found_with(section: str, *changes: Mapping[Any, Any], **options: Any) -> dict:
    """Derive a section with some cells set, and return all that it found."""
    results = results_with(section, *changes, **options)
    derived = derive_section(results, {})
    found = found_in(derived, results)
    for (name, flag), claims in FLAGS.items():
        if name == section and found.get(flag):
            assert only(found, claims) == dict.fromkeys(claims, "holds"), flag
    flags = {name for name, value in shown_numbers(derived) if value is True}
    assert flags <= {flag for name, flag in FLAGS if name == section}
    return found


def found_in(section: Section, results: Results | None = None) -> dict[str, Any]:
    """Return values, outcomes, numbers of claims and figures, and cells, by name.

    A number of a claim is below ``claim/number``, a cell below ``table/column/line``.
    """
    found: dict[str, Any] = {}
    if results:
        found |= {name: plain(value) for name, value in results.derived.items()}
    found |= {name: plain(number) for name, number in shown_numbers(section)}
    for claim in section.claims:
        found[claim.name] = claim.outcome.answer
        found[f"{claim.name}/effect"] = claim.effect.answer
        for name, number in claim.numbers.items():
            found[f"{claim.name}/{name}"] = plain(number)
    for name, table in section.tables.items():
        for column, cells in getattr(table, "frame", {}).items():
            label = " ".join(column.split())
            for line, cell in enumerate(cells):
                found[f"{name}/{label}/{line}"] = plain(cell)
    return found


def shown_numbers(section: Section) -> list[tuple[str, Any]]:
    """Return the numbers that captions of figures and tables can name."""
    shown = {**section.figures, **section.tables}.items()
    numbers = [(name, getattr(thing, "numbers", {})) for name, thing in shown]
    return [(f"{name}/{key}", each[key]) for name, each in numbers for key in each]


def plain(found: Any) -> Any:
    """Return the number of a quantity, and a text without tags and wide blanks."""
    if isinstance(found, Quantity):
        return found.value
    if isinstance(found, str):
        return " ".join(Markup(found).striptags().split())
    return found


def only(found: Mapping[str, Any], expected: Iterable[str]) -> dict[str, Any]:
    """Return the findings with the expected names."""
    return {name: found.get(name, "nothing is found so named") for name in expected}


def near(expected: Mapping[str, Any]) -> dict[str, Any]:
    """Return an object that equals the number within the digits that are computed by
    hand.
    """
    return {
        name: pytest.approx(value, rel=2e-4, abs=1e-9)
        if type(value) in (int, float)
        else value
        for name, value in expected.items()
    }


def assert_found(
    section: str,
    *changes: Mapping[Any, Any],
    expected: Mapping[str, Any],
    release: str = "1.4.0",
    frame: pd.DataFrame | None = None,
) -> None:
    """Assert that a section with some cells set finds the expected numbers."""
    found = found_with(section, *changes, release=release, frame=frame)
    assert only(found, expected) == near(expected)
