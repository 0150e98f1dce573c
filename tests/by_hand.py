"""A section of the tracked records with some cells set by hand, and what has to follow, as anyone can work out.

    all-gaps-zero.slip_mm=6.5 *.mean_row_count=8 -> slip_difference=0.5 not_the_cause=fails

On the left: a case, or a pattern of cases, with a column; ``noise:slip_floor=0.1`` is a value, ``noise:*.slip_mm=1``
are cells of a section that is read; ``!sweep-*`` drops rows; ``@`` parts a case from its device and number of worlds.
On the right: a claim with its outcome, a value, and below ``/`` a number of a claim or a figure or, with its column and
line, a cell of a table. A space is written ``_``. A line without an arrow is given to all that follow it.
"""

import json
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from fnmatch import fnmatchcase
from functools import cache
from pathlib import Path
from types import MappingProxyType, SimpleNamespace
from typing import TYPE_CHECKING, Any

import pytest
from markupsafe import Markup

from measured_report.editions.project import Project
from measured_report.findings.sections import Read, derive_section, outline_of
from measured_report.parts.claim import HOLDS
from measured_report.parts.section import Section
from measured_report.records.columns import units_of
from measured_report.records.record import Record, load_record
from measured_report.values.evidence import Evidence, Repeats
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Series
from tests.perturbed import load_trace_once

if TYPE_CHECKING:
    import pandas as pd

FLOORS = {"slip_floor": 0.01, "drift_floor": 0.001}
"""The noise of slip [mm] and drift [mm/s] unless it is set."""
FLAGS = {
    "drift_law.law.follows": ["follows"],
    "envelope.maps.keeps": ["stiff_pads_never_drop"],
    "envelope.maps.drops": ["as_shipped_drops"],
    "error_runtime.numerical.rk4_warp": ["rk4_warp"],
    "hold.motion.is_so": ["creep_goes_on", "stiff_pads_keep_creep"],
    "scenes.creep.predicted": ["predicted"],
    "stability.maps.is_so": ["safe_settings"],
    "stiffness.sweep.is_so": ["ke_alone_does_not_help", "together_they_hold"],
}
"""Flags of figures and tables, by section: the claims that have to hold where one is set."""


@dataclass(frozen=True)
class Kept(Results):
    """Results whose traces are read once, or are all this one."""

    frame: "pd.DataFrame | None" = None

    def loaded(self, path: Path) -> "pd.DataFrame":
        return load_trace_once(path)

    def trace(self, case: str) -> Series:
        return super().trace(case) if self.frame is None else Series(self.frame, f"{case}.csv.gz")


@cache
def tracked(section: str, release: str) -> Record:
    """The record; of a section that has no full one yet the quick one, as if it were of the others' machine."""
    full, quick = (Project(release, profile).record_path(section) for profile in ("full", "quick"))
    if full.exists():
        return load_record(full)
    assert quick.exists(), f"{section} has no record yet: make rerun SECTION={section} DEVICE=cpu PROFILE=quick"
    return replace(load_record(quick), machine=tracked("noise", release).machine)


@cache
def read(section: str, release: str) -> Results:
    """What another section reads of this one, as tracked."""
    found = results_of(section, release, "")
    if section == "noise":
        derive_section(found, {})
        found.derived.update({name: replace(found.derived[name], value=floor) for name, floor in FLOORS.items()})
    elif not outline_of(section).compares:
        derive_section(found, {})
    return found


def results_of(section: str, release: str, given: str) -> Results:
    """The results of a section with some cells set, and nothing derived yet; runs of one case are all alike."""
    outline, own, elsewhere = outline_of(section), [], dict[str, list[str]]()
    for token in given.split():
        other, is_other, rest = token.partition(":")
        (elsewhere.setdefault(other, []) if is_other else own).append(rest if is_other else token)
    others = {other: changed(read(other, release), elsewhere.pop(other, [])) for other in outline.reads}
    assert not elsewhere, f"{section} does not read {elsewhere}"
    record = with_cells(tracked(section, release), own)
    labels = {"label": outline.label, "labels": outline.labels}
    evidence = Evidence(repeats={"runs": dict.fromkeys(("slip_mm", "drift_mm_s"), Repeats(1.0, 0.0, 8))})
    return Kept(record, Project(release).record_path(section), Read(outline, others), evidence=evidence, **labels)


def releases_of(given: Mapping[str, str]) -> dict[str, dict[str, Any]]:
    """Chapters of releases, as of one with some cells set; of the sections that are named nothing is derived again."""
    releases: dict[str, dict[str, Any]] = {}
    for release, text in given.items():
        tokens: dict[str, list[str]] = {}
        for token in text.split():
            section, _, rest = token.partition(":")
            tokens.setdefault(section, []).append(rest)
        found = {section: changed(read(section, "1.4.0"), list(filter(None, rest))) for section, rest in tokens.items()}
        releases[release] = {name: SimpleNamespace(results=each, section=Section()) for name, each in found.items()}
    return releases


def changed(results: Results, tokens: list[str]) -> Results:
    values = {
        token.partition("=")[0]: token.partition("=")[2] for token in tokens if "." not in token.partition("=")[0]
    }
    cells = [token for token in tokens if token.partition("=")[0] not in values]
    derived = results.derived | {name: replace(results.derived[name], **told(text)) for name, text in values.items()}
    return replace(results, record=with_cells(results.record, cells) if cells else results.record, derived=derived)


def told(text: str) -> Mapping[str, Any]:
    value = parsed(text)
    return {"value": value, "noise": 0.0, "reason": "" if value is not None else "as a test"}


def parsed(text: str) -> Any:
    try:
        return json.loads(text)
    except ValueError:
        return text.replace("_", " ")


def with_cells(record: Record, tokens: list[str]) -> Record:
    rows = [dict(row) for row in record.rows]
    for token in tokens:
        place, _, text = token.partition("=")
        pattern, _, column = place.rpartition(".")
        if place.startswith("!"):
            rows = [row for row in rows if not fnmatchcase(named(row, place), place[1:])]
            continue
        mine = [row for row in rows if fnmatchcase(named(row, pattern), pattern)]
        mine = [row for row in mine if "*" not in pattern or column in row]
        if not mine:
            assert "*" not in pattern, f"{record.section} has no {place}"
            rows.append(row := {"case": pattern})
            mine = [row]
        for row in mine:
            row.pop(f"{column}_reason", None)
            row[column] = parsed(text)
            row |= {f"{column}_reason": "as a test"} if row[column] is None else {}
    return replace(record, rows=rows, units=record.units | units_of(rows))


def named(row: Mapping[str, Any], pattern: str) -> str:
    told = [row["case"], *(str(row[column]) for column in ("device", "worlds") if column in row)]
    return "@".join(told) if "@" in pattern else told[0]


def lines_of(text: str) -> list[tuple[str, str, str]]:
    """What is given to a line by those before it, what it gives itself, and what follows."""
    always, lines = "", list[tuple[str, str, str]]()
    for given, arrow, expected in (line.partition("->") for line in text.splitlines()):
        if not arrow:
            always += f" {given}"
        elif not given and lines and lines[-1][:2] == (always, ""):
            lines[-1] = always, "", lines[-1][2] + expected
        else:
            lines.append((always, given, expected))
    return lines


def mismatches(section: str, release: str, text: str) -> Iterator[str]:
    """What does not follow, line by line."""
    for always, given, expected in lines_of(text):
        results = results_of(section, release, f"{always} {given}")
        derived = derive_section(results, {})
        for wrong in (*unlike(expected, derived, results.derived), *unbacked(section, derived)):
            yield f"{given.strip()} -> {wrong}"


def unbacked(name: str, section: Section) -> Iterator[str]:
    """Flags that words of a figure or a table follow, while the claims do not hold that they rest on."""
    held = {claim.name for claim in section.claims if claim.outcome == HOLDS}
    for thing, shown in {**section.figures, **section.tables}.items():
        for flag, value in getattr(shown, "numbers", {}).items():
            if isinstance(value, bool):
                claims = FLAGS.get(f"{name}.{thing}.{flag}", ["a claim behind it"])
                yield from (f"{thing}/{flag} rests on {claim}" for claim in claims if value and claim not in held)


def unlike(expected: str, section: Section, values: Mapping[str, Value] = MappingProxyType({})) -> Iterator[str]:
    for token in expected.split():
        name, _, told = token.partition("=")
        found = looked_up(name, section, values)
        if not is_as_told(found, told):
            reasons = [claim.outcome.reason for claim in section.claims if claim.name == name and claim.outcome.reason]
            yield "; ".join([f"{name}={found}, not {told}", *reasons])


def looked_up(name: str, section: Section, values: Mapping[str, Value]) -> Any:
    claims = {claim.name: claim for claim in section.claims}
    first, *path = name.split("/")
    if path == ["effect"]:
        return claims[first].effect.answer
    if first in claims and not path:
        return claims[first].outcome.answer
    if first in claims or first in section.figures:
        thing = claims.get(first) or section.figures[first]
        return plain(thing.numbers[path[0]])
    if first in section.tables:
        column, line = path
        frame = section.tables[first].frame
        return plain(frame[next(name for name in frame if bare(name) == column)].iloc[int(line)])
    return plain(values[first])


def bare(text: str) -> str:
    return re.sub(r"\s", "_", text)


def plain(found: Any) -> Any:
    if isinstance(found, Quantity):
        return found.value
    return Markup(found).striptags() if isinstance(found, str) else found


def is_as_told(found: Any, told: str) -> bool:
    expected = parsed(told)
    if isinstance(expected, float | int) and not isinstance(expected, bool):
        return found is not None and not isinstance(found, str) and found == pytest.approx(expected, rel=2e-4, abs=1e-9)
    return bare(found) == told if isinstance(found, str) else found == expected
