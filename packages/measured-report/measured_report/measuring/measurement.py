"""Conditions that a section is given to measure under, and the measurement that it hands over."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class Conditions:
    """Say under which conditions a section is measured."""

    device: str  # alias, as the simulator calls it
    quick: bool  # small grids and short runs

    @property
    def is_cuda(self) -> bool:
        return self.device != "cpu"

    @property
    def profile(self) -> str:
        """Return ``full`` or ``quick``: the key of what is measured in either."""
        return "quick" if self.quick else "full"


@dataclass(frozen=True)
class Measurement:
    """Hold rows, each with its case's name and plain numbers, and traces: a table (column: values) for each case."""

    rows: Sequence[Mapping[str, Any]]
    traces: Mapping[str, Mapping[str, Sequence[float]]] = field(default_factory=dict)


def absent(names: Iterable[str], reason: str) -> dict[str, object]:
    """Return columns without a number: None under each name, and beside it the reason."""
    names = tuple(names)
    return dict.fromkeys(names) | {f"{name}_reason": reason for name in names}
