"""What a lint finds, put together."""

from collections.abc import Iterable
from dataclasses import dataclass, field, replace

from newton_lint.source import Element

SEVERITIES = ("note", "warning", "error")


@dataclass(frozen=True)
class Change:
    """A change of a file: attributes of one element, and the place."""

    subject: str
    """What has the attributes: a geom's name, or ``option``."""
    attributes: tuple[tuple[str, str], ...]
    element: Element | None = None
    """Where it stands; None where no file is known to say it."""

    def __str__(self) -> str:
        said = " ".join(f'{name}="{value}"' for name, value in self.attributes)
        place = f" ({self.element.place})" if self.element else ""
        return f"{said} on {self.subject}{place}"


@dataclass(frozen=True)
class Advice:
    """Advice: changes, and what they gain and cost."""

    changes: tuple[Change, ...]
    gain: str

    def __str__(self) -> str:
        return f"{', '.join(map(str, self.changes))}: {self.gain}" if self.changes else self.gain


@dataclass(frozen=True)
class Finding:
    """A thing that is authored and not what the solver does."""

    rule: str
    shape: str
    """Body and shape that it is about, as ``cube/box``; empty for what is said of the whole scene."""
    against: tuple[str, ...]
    """The other shapes of the pairs that it is about; empty where it is about the shape alone."""
    parameter: str
    value: float
    """As authored, or as what is authored comes out."""
    used: float | None
    """What is used instead; None where nothing is. Of a dampratio the critical one."""
    unit: str
    message: str
    severity: str = "warning"
    element: Element | None = field(default=None, compare=False)
    advice: Advice | None = field(default=None, compare=False)


@dataclass(frozen=True)
class Group:
    """Findings that say the same of the same body."""

    first: Finding
    subject: str
    against: str
    count: int
    """Pairs of shapes, or shapes where it is about these alone."""


def grouped(findings: Iterable[Finding]) -> list[Group]:
    """Return the findings with those put together that only differ in the shapes of the bodies they are about."""
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


def alike(findings: Iterable[Finding]) -> list[list[Finding]]:
    """Return the findings that say the same, of whichever shapes, in the order of the first of each."""
    groups: dict[Finding, list[Finding]] = {}
    for finding in findings:
        groups.setdefault(replace(finding, shape="", against=()), []).append(finding)
    return list(groups.values())
