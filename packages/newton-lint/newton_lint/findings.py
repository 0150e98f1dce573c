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
        attributes = " ".join(f'{name}="{value}"' for name, value in self.attributes)
        place = f" ({self.element.file.name}:{self.element.line})" if self.element else ""
        return f"{attributes} on {self.subject}{place}"


@dataclass(frozen=True)
class Advice:
    """What changes gain and cost, the changes, and alternatives of which one is enough, the mildest first."""

    gain: str
    changes: tuple[Change, ...] = ()
    alternatives: tuple["Advice", ...] = ()
    """One that tells no gain is not said."""

    def __str__(self) -> str:
        first = f"{', '.join(map(str, self.changes))}: {self.gain}" if self.changes else self.gain
        return "; or ".join([first, *(str(advice) for advice in self.alternatives if advice.gain)])


@dataclass(frozen=True)
class Finding:
    """A thing that is authored and not what the solver does."""

    rule: str
    shape: str
    """Body and shape that it is about, as ``cube/box``; empty for what is said of the whole scene."""
    parameter: str
    value: float
    """As authored, or as what is authored comes out."""
    message: str
    against: tuple[str, ...] = ()
    """The other shapes of the pairs that it is about; empty where it is about the shape alone."""
    used: float | None = None
    """What is used instead; None where nothing is. Of a dampratio the critical one."""
    unit: str = "1"
    severity: str = "warning"
    element: Element | None = field(default=None, compare=False)
    advice: Advice | None = field(default=None, compare=False)


def distinct(changes: Iterable[Change]) -> tuple[Change, ...]:
    """Return changes without duplicates: a default's tag is the element of all geoms of its class."""
    return tuple({(change.element or change.subject, change.attributes): change for change in changes}.values())


def grouped(findings: Iterable[Finding]) -> list[list[Finding]]:
    """Return the findings that say the same, of whichever shapes, in the order of the first of each."""
    groups: dict[Finding, list[Finding]] = {}
    for finding in findings:
        groups.setdefault(replace(finding, shape="", against=()), []).append(finding)
    return list(groups.values())
