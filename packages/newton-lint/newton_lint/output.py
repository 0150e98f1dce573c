"""Writes reports as text, JSON and GitHub annotations."""

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from newton_lint.findings import (
    SEVERITIES,
    Finding,
    grouped,
    named,
    number,
    rounded,
    sentence,
)
from newton_lint.law import M
from newton_lint.prediction import Load, Prediction
from newton_lint.report import Report, as_json

# At most this many predictions of creep are printed.
WORST = 5


def printable(text: str) -> str:
    """Return a text on one line, with unprintable characters escaped."""
    return "".join(
        char
        if char.isprintable()
        else char.encode("unicode_escape", "replace").decode()
        for char in text
    )


@dataclass(frozen=True)
class Detail:
    """How much of a report is printed."""

    notes: bool = False
    """Whether to print notes too."""
    rules: Mapping[str, str] = field(default_factory=dict)
    """Descriptions of the rules, if details are printed."""


def written(reports: Sequence[Report], form: str, detail: Detail = Detail()) -> str:
    """Return reports in a format.

    Args:
        form: ``text``, ``json`` or ``github``.
    """
    if form == "json":
        objects = [as_json(report) for report in reports]
        answer = objects[0] if len(objects) == 1 else objects
        # Numbers of NumPy become those of Python.
        return json.dumps(answer, indent=1, default=lambda number: number.item())
    lines_of = _github if form == "github" else text_of
    lines = [line for report in reports for line in lines_of(report, detail)]
    return "\n".join(map(printable, lines))


def text_of(report: Report, detail: Detail = Detail()) -> Iterator[str]:
    """Yield the lines of a report, one for each group of findings."""
    groups = grouped(
        sorted(report.findings, key=lambda finding: -SEVERITIES.index(finding.severity))
    )
    shapes = _counted(report.shape_count, "shape")
    size = f"{shapes}, {_counted(report.pair_count, 'pair')}, dt {report.dt_s:g} s"
    counts = {
        name: sum(group[0].severity == name for group in groups) for name in SEVERITIES
    }
    notes = counts.pop("note")
    totals = [
        _counted(counts[name], name) for name in ("error", "warning") if counts[name]
    ]
    total = ", ".join(totals) or "nothing found"
    if notes:
        hidden = "" if detail.notes else " (--notes prints them)"
        total += f", {_counted(notes, 'note')}{hidden}"
    yield f"{report.target}: {size}: {total}"
    for group in groups:
        if group[0].severity != "note" or detail.notes:
            yield from _lines(group, detail)
    if report.creep and any(vars(report.load).values()):
        yield "predicted creep:"
        yield from (
            f"  {creep_line(prediction, report.load)}"
            for prediction in report.creep[:WORST]
        )
        if len(report.creep) > WORST:
            yield f"  and {len(report.creep) - WORST} more, which --json prints"


def _lines(group: Sequence[Finding], detail: Detail) -> Iterator[str]:
    """Yield the line of a group of findings, and more with ``--explain``."""
    finding = group[0]
    element = finding.element
    place = f"{element.file}:{element.line}: " if element else ""
    first = f"{finding.cures[0]}." if finding.cures else finding.hint
    text = " ".join(filter(None, [f"{sentence(group)}.", first]))
    yield f"  {place}{finding.severity} {finding.rule}: {text}"
    if not detail.rules:
        return
    yield f"      Rule: {detail.rules[finding.rule]}"
    for cure in finding.cures:
        places = [
            f"{change} ({change.place})" for change in cure.changes if change.place
        ]
        yield f"      Change: {cure}"
        yield from (f"        {line}" for line in places)
    if finding.hint and finding.cures:
        yield f"      Or: {finding.hint}"


def creep_line(prediction: Prediction, load: Load) -> str:
    count = len(prediction.pairs)
    shapes, partners = zip(*prediction.pairs, strict=True)
    parts = [
        f"timeconst {prediction.timeconst_s:.3g} s",
        f"{number(M * prediction.acceleration_response_s)} mm/s per m/s² of"
        " acceleration of a turning support",
    ]
    if load.acceleration_m_s2:
        parts.append(
            f"{rounded(prediction.acceleration_mm_s, 'mm/s')} at {load.acceleration_m_s2:g} m/s²"
        )
    if load.load_n:
        least = prediction.load_deep_mm_s
        most = prediction.load_shallow_mm_s
        between = " to ".join(
            dict.fromkeys([rounded(least, "mm/s"), rounded(most, "mm/s")])
        )
        parts.append(f"{between} under {load.load_n:g} N on a contact point")
    counted = f" ({count} pairs)" if count > 1 else ""
    return f"{named(shapes)} on {named(partners)}{counted}: {'; '.join(parts)}"


def _github(report: Report, detail: Detail) -> Iterator[str]:
    for group in grouped(report.findings):
        finding = group[0]
        if finding.severity == "note" and not detail.notes:
            continue
        location = f"file={report.target}"
        if element := finding.element:
            location = f"file={element.file},line={element.line}"
        # In GitHub's workflow commands % starts an escape and a newline ends a command.
        text = ". ".join(filter(None, [sentence(group), finding.advice]))
        message = text.replace("%", "%25").replace("\n", "%0A")
        level = finding.severity.replace("note", "notice")
        yield f"::{level} {location},title=newton-lint {finding.rule}::{message}"


def _counted(count: int, noun: str) -> str:
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"
