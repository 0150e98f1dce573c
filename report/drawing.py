"""Drawing: all figures of a build at once, on every processor that there is."""

import os
import sys
from collections.abc import Sequence

from markupsafe import Markup

from report.parts import Figure
from report.records.processes import workers

_figures: Sequence[Figure] = ()
"""What the worker processes draw; they are forks of this one, so that a figure can hold functions."""


def draw_all(figures: Sequence[Figure]) -> list[Markup]:
    """Each figure as HTML, in their order."""
    global _figures
    count = min(_processor_count(), len(figures))
    if count < 2:
        return [figure.drawn() for figure in figures]
    _figures = figures
    with workers(count, "fork") as pool:
        return list(pool.map(_draw, range(len(figures))))


def _draw(index: int) -> Markup:
    return _figures[index].drawn()


def _processor_count() -> int:
    """The processors that may be used; one where a fork is not safe, or not there."""
    return len(os.sched_getaffinity(0)) if sys.platform == "linux" else 1
