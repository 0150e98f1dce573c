"""Define the conditions under which a section measures, and its measurement."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any


@dataclass(frozen=True)
class Conditions:
    """The conditions under which a section measures."""

    device: str  # the simulator's name of the device
    quick: bool  # whether to use small grids and short runs

    @property
    def is_cuda(self) -> bool:
        return self.device != "cpu"

    @property
    def profile(self) -> str:
        """Return ``full`` or ``quick``, the key of values that differ between them."""
        return "quick" if self.quick else "full"


@dataclass(frozen=True)
class Measurement:
    """The rows and traces of a section.

    A row holds the name of its case and plain numbers. A trace is a table for one case,
    with a list of values for each column.
    """

    rows: Sequence[Mapping[str, Any]]
    traces: Mapping[str, Mapping[str, Sequence[float]]] = field(default_factory=dict)


def measurement_of(returned: Any) -> Any:
    """Convert the result of ``measure`` to a measurement.

    ``measure`` can also return only rows: a list of dicts or of dataclasses, or a data
    frame, whose index names the cases unless it has a column ``case``.
    """
    if hasattr(returned, "traces"):
        return returned
    # A data frame is recognized by its methods, because pandas may not be installed.
    if hasattr(returned, "reset_index"):
        table = returned if "case" in returned else returned.rename_axis("case")
        table = table.reset_index(drop="case" in returned)
        texts = {*table.select_dtypes(exclude="number")}
        returned = [
            # A data frame contains NaN, which differs from itself, for a missing text.
            {key: cell for key, cell in row.items() if key not in texts or cell == cell}
            for row in table.to_dict("records")
        ]
    if isinstance(returned, Mapping | str):
        raise TypeError(f"it is a {type(returned).__name__}")
    return Measurement(
        [row if isinstance(row, Mapping) else asdict(row) for row in returned]
    )


def absent(names: Iterable[str], reason: str) -> dict[str, object]:
    """Return columns with None instead of numbers, and columns with the reason."""
    names = tuple(names)
    return dict.fromkeys(names) | {f"{name}_reason": reason for name in names}
