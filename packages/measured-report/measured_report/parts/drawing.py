"""Drawing: the figures of a build on every processor that there is."""

import gc
import os
import sys
from collections.abc import Callable, Sequence

from measured_report.files.processes import workers
from measured_report.parts.section import Figure, Pictures

_figures: list[Figure] = []
"""Those that are drawn: processes are forks of this one, so that a figure can hold functions."""


def draw(figures: Sequence[Figure], meanwhile: Callable[[], None]) -> list[Pictures]:
    """Draw figures, in their order, and do something else ``meanwhile``."""
    # A fork is safe on Linux alone, and a single figure is drawn here.
    count = min(len(os.sched_getaffinity(0)), len(figures)) if sys.platform == "linux" else 1
    if count < 2:
        meanwhile()
        return [figure.drawn() for figure in figures]
    _figures[:] = figures
    with workers(count, "fork", gc.disable) as pool:  # all drawings of a process fit into memory together
        drawn = [pool.submit(_drawn, index) for index in range(len(figures))]
        meanwhile()
        return [each.result() for each in drawn]


def _drawn(index: int) -> Pictures:
    return _figures[index].drawn()
