"""Drawing: all figures of a build at once, on every processor that there is."""

import multiprocessing
import os
from collections.abc import Sequence

from markupsafe import Markup

from report.parts import PlacedFigure

_figures: Sequence[PlacedFigure] = ()
"""What the worker processes draw; they are forks of this one, so that a figure can hold functions."""


def draw_all(figures: Sequence[PlacedFigure]) -> list[Markup]:
    """Each figure as HTML, in their order."""
    global _figures
    workers = min(_processor_count(), len(figures))
    if workers < 2 or "fork" not in multiprocessing.get_all_start_methods():
        return [figure.drawn() for figure in figures]
    _figures = figures
    with multiprocessing.get_context("fork").Pool(workers) as pool:
        return pool.map(_draw, range(len(figures)), chunksize=1)


def _draw(index: int) -> Markup:
    return _figures[index].drawn()


def _processor_count() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
