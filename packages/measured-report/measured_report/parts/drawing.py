"""Drawing: all figures of a build at once, on every processor that there is."""

import gc
import os
import pickle
import signal
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from multiprocessing import get_context
from typing import BinaryIO

from markupsafe import Markup

from measured_report.files.processes import obey, workers
from measured_report.parts.parts import Figure, Pictures

Place = tuple[str, str]
"""Where a figure is shown: the release, and its id on the page."""
AT_ONCE = 2
"""Figures that one fork draws: less than half a second, in which others are derived."""

_figures: Sequence[Figure] = ()
"""What the worker processes draw; they are forks of this one, so that a figure can hold functions."""


def draw_all(figures: Sequence[Figure], meanwhile: Callable[[], None]) -> list[Pictures]:
    """Each figure as it is drawn, in their order; ``meanwhile`` is done in any case, while others draw."""
    global _figures
    count = min(_processor_count(), len(figures))
    if count < 2:
        meanwhile()
        return [_pictures(figure) for figure in figures]
    _figures = figures
    with workers(count, "fork", _begin) as pool:
        drawing = pool.map(_draw, range(2 * len(figures)))
        meanwhile()
        drawn = list(drawing)
    return list(zip(drawn[::2], drawn[1::2], strict=True))


def _begin() -> None:
    """Look for no garbage: a drawing makes many objects, and all of a process's drawings together fit into memory."""
    gc.disable()


def _draw(index: int) -> Markup:
    return _figures[index // 2].picture(is_narrow=bool(index % 2))


def _pictures(figure: Figure) -> Pictures:
    return figure.picture(is_narrow=False), figure.picture(is_narrow=True)


@dataclass
class Beside:
    """Figures drawn on a second processor while this process derives more of them.

    What it does not draw, for want of time or of luck, is left to whoever draws the rest.
    """

    _drawn: dict[Place, Pictures] = field(default_factory=dict)
    _waiting: dict[Place, Figure] = field(default_factory=dict)
    _fork: "_Fork | None" = None

    def draw(self, figures: Mapping[Place, Figure]) -> None:
        """Draw these as soon as there is a processor for it."""
        if _processor_count() > 1:
            self._waiting |= {place: figure for place, figure in figures.items() if figure.is_there}
            if not (self._fork and self._fork.process.is_alive()):
                self._take()
                some = dict(list(self._waiting.items())[:AT_ONCE])
                self._waiting = {place: figure for place, figure in self._waiting.items() if place not in some}
                self._fork = _Fork(some) if some else None

    def drawn(self) -> dict[Place, Pictures]:
        """What it has drawn; what still waits is dropped."""
        self._waiting.clear()
        self._take()
        return self._drawn

    def _take(self) -> None:
        if self._fork:
            self._drawn |= self._fork.drawn()
            self._fork = None


class _Fork:
    """A process that draws some figures and ends."""

    def __init__(self, figures: Mapping[Place, Figure]):
        self._file: BinaryIO = os.fdopen(os.memfd_create("figures"), "w+b")
        self.process = get_context("fork").Process(target=self._run, args=(figures, os.getpid()), daemon=True)
        # Until it has said that it leaves Ctrl-C to this process, none may reach it.
        before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        try:
            self.process.start()
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)

    def _run(self, figures: Mapping[Place, Figure], parent: int) -> None:
        obey(parent)
        _begin()
        try:
            pickle.dump({place: _pictures(figure) for place, figure in figures.items()}, self._file)
            self._file.flush()
        except BaseException:
            os._exit(1)  # whoever draws them instead says why that can't be done

    def drawn(self) -> dict[Place, Pictures]:
        """What it has drawn, once it has; nothing where it could not, or was killed."""
        self.process.join()
        with self._file as file:
            file.seek(0)
            return {} if self.process.exitcode else pickle.load(file)


def _processor_count() -> int:
    """The processors that may be used; one where a fork is not safe, or not there."""
    return len(os.sched_getaffinity(0)) if sys.platform == "linux" else 1
