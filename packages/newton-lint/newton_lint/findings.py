"""What a lint finds, put together and said."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

SHOWN = 3
"""Names that a line of text has before it counts the rest."""


@dataclass(frozen=True)
class Finding:
    """One thing that is authored and not what the solver does."""

    rule: str
    shape: str
    """Body and shape that it is about, as ``cube/box``; empty for a buffer."""
    against: tuple[str, ...]
    """The other shapes of the pairs that it is about; empty where it is about the shape alone."""
    parameter: str
    value: float
    """As authored, or as what is authored comes out."""
    used: float | None
    """What is used instead; None where nothing is. Of a buffer what was needed, of a dampratio the critical one."""
    unit: str
    message: str


@dataclass(frozen=True)
class Group:
    """Findings that say the same of the same body."""

    first: Finding
    subject: str
    against: str
    count: int
    """Pairs of shapes, or shapes where it is about these alone."""


@dataclass(frozen=True)
class Buffer:
    """A buffer of the engine or of the collision pipeline, per world."""

    name: str
    capacity: int
    peak: int
    """Most that a run needed."""


def grouped(findings: Iterable[Finding]) -> list[Group]:
    """The findings with those put together that only differ in the shapes of the bodies they are about."""
    groups: dict[object, list[Finding]] = {}
    for finding in findings:
        subject = body_of(finding.shape)
        groups.setdefault((subject, replace(finding, shape="", against=())), []).append(finding)
    return [
        Group(
            first=members[0],
            subject=subject or members[0].parameter,
            against=", ".join(dict.fromkeys(body_of(other) for finding in members for other in finding.against)),
            count=sum(max(1, len(finding.against)) for finding in members),
        )
        for (subject, _), members in groups.items()
    ]


def body_of(shape: str) -> str:
    return shape.split("/", 1)[0]


def columns(group: Group) -> dict[str, object]:
    """A group as columns of a row; values in a column that says their unit."""
    finding = group.first
    unit = "" if finding.unit == "1" else f"_{finding.unit}"
    used = {f"used{unit}": finding.used}
    if finding.used is None:
        used[f"used{unit}_reason"] = "the solver does not read it"
    return {
        "rule": finding.rule,
        "subject": group.subject,
        "against": group.against,
        "pair_count": group.count,
        "parameter": finding.parameter,
        f"authored{unit}": finding.value,
        **used,
        "message": finding.message,
    }


def lines(findings: Iterable[Finding]) -> list[str]:
    """The findings as text: a line for all that say the same, of whichever shapes."""
    alike: dict[Finding, list[Finding]] = {}
    for finding in findings:
        alike.setdefault(replace(finding, shape="", against=()), []).append(finding)
    return [_line(members) for members in alike.values()]


def _line(members: Sequence[Finding]) -> str:
    finding = members[0]
    unit = f" {finding.unit}" if finding.unit in ("m", "s") else ""
    said = f"{finding.parameter} {finding.value:g}{unit} {finding.message}"
    if finding.used is not None:
        said += f" ({_word(finding.rule)}: {finding.used:g}{unit})"
    if not finding.shape:
        return f"{finding.rule:13} {said}"
    place = named(member.shape for member in members)
    if finding.against:
        count = sum(len(member.against) for member in members)
        place += f" against {named(other for member in members for other in member.against)}"
        place += f" ({count} pairs)" if count > 1 else ""
    return f"{finding.rule:13} {place}: {said}"


def _word(rule: str) -> str:
    return {"buffer": "peak", "dampratio": "critical"}.get(rule, "used")


def named(names: Iterable[str]) -> str:
    """The names, each once, and no more than a line has room for."""
    different = list(dict.fromkeys(names))
    if len(different) > SHOWN + 1:
        return f"{', '.join(different[:SHOWN])} and {len(different) - SHOWN} more"
    return ", ".join(different)


def tally(findings: Iterable[Finding]) -> list[dict[str, object]]:
    """What is found, without the shapes: one for each rule, parameter and value, with the number of pairs or shapes."""
    alike: dict[tuple, int] = {}
    for finding in findings:
        key = (finding.rule, finding.parameter, finding.value, finding.used, finding.unit)
        alike[key] = alike.get(key, 0) + max(1, len(finding.against))
    names = ("rule", "parameter", "value", "used", "unit")
    return [{**dict(zip(names, key, strict=True)), "count": count} for key, count in alike.items()]
