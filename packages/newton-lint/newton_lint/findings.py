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
    """Advice: changes, what they gain and cost, and other ways of which one is enough, the mildest first."""

    changes: tuple[Change, ...]
    gain: str
    others: tuple["Advice", ...] = ()
    """One that tells no gain is not said."""

    def __str__(self) -> str:
        own = f"{', '.join(map(str, self.changes))}: {self.gain}" if self.changes else self.gain
        return "; or ".join([own, *(str(other) for other in self.others if other.gain)])


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


def alike(findings: Iterable[Finding]) -> list[list[Finding]]:
    """Return the findings that say the same, of whichever shapes, in the order of the first of each."""
    groups: dict[Finding, list[Finding]] = {}
    for finding in findings:
        groups.setdefault(replace(finding, shape="", against=()), []).append(finding)
    return list(groups.values())
