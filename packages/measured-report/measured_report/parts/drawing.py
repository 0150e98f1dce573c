"""Drawing: all figures of a build at once, on every processor that there is."""

import gc
import os
import sys
from collections.abc import Callable, Sequence

from measured_report.files.processes import workers
from measured_report.parts.section import Figure, Pictures

_figures: Sequence[Figure] = ()
"""What the worker processes draw; they are forks of this one, so that a figure can hold functions."""


def draw_all(figures: Sequence[Figure], meanwhile: Callable[[], None]) -> list[Pictures]:
    """Each figure as it is drawn, in their order; ``meanwhile`` is done in any case, while others draw."""
    global _figures
    count = min(_processor_count(), len(figures))
    _figures, places = figures, range(len(figures))
    if count < 2:
        meanwhile()
        return [*map(_draw, places)]
    # A drawing makes many objects, and all of a process's drawings together fit into memory.
    with workers(count, "fork", gc.disable) as pool:
        drawing = pool.map(_draw, places)
        meanwhile()
        return list(drawing)


def _draw(index: int) -> Pictures:
    return _figures[index].drawn()


def _processor_count() -> int:
    """The processors that may be used; one where a fork is not safe, or not there."""
    return len(os.sched_getaffinity(0)) if sys.platform == "linux" else 1
