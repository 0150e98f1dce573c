"""Drawing: the figures of a build on every processor that there is, from when the first of them is derived."""

import gc
import os
import pickle
import sys
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from multiprocessing import get_context
from multiprocessing.connection import wait
from multiprocessing.process import BaseProcess
from tempfile import TemporaryFile
from typing import IO

from measured_report.files.errors import ReportError
from measured_report.files.processes import KILLED, begin
from measured_report.parts.section import Figure, Pictures

AT_ONCE = 6
"""Figures that a process draws: with fewer it takes longer to begin one, and with more the last ends late."""
Key = tuple[str, int]
"""Tells figures apart: the id, and what draws it."""


@dataclass(frozen=True)
class _Share:
    """Figures that a process draws, which is a fork of this one, so that a figure can hold functions."""

    process: BaseProcess
    file: IO[bytes]
    """Where it writes the drawings, or the error that stopped it."""
    keys: Sequence[Key]

    def read(self) -> list[Pictures]:
        """Wait for the drawings; what stopped the process is raised here."""
        self.process.join()
        if self.process.exitcode:
            raise ReportError(KILLED)
        with self.file:
            self.file.seek(0)
            found = pickle.load(self.file)
        if isinstance(found, Exception):
            raise found
        return found


class Drawing:
    """Draws figures; what is under way when the block is left by an error, or by Ctrl-C, is dropped."""

    def __init__(self) -> None:
        self._waiting: dict[Key, Figure] = {}
        self._shares: list[_Share] = []

    def __enter__(self) -> "Drawing":
        return self

    def __exit__(self, *_: object) -> None:
        for share in self._shares:
            share.process.kill()

    def begin(self, figures: Iterable[Figure]) -> None:
        """Draw these, which ``all`` is to be asked for, on the processors that this process leaves to others."""
        self._waiting |= {_key(figure): figure for figure in figures if figure.is_there}
        self._start(_processor_count() - 1, least=AT_ONCE)

    def all(self, figures: Sequence[Figure], meanwhile: Callable[[], None]) -> list[Pictures]:
        """Each figure as it is drawn, in their order; ``meanwhile`` is done in any case, while others draw."""
        begun = {key for share in self._shares for key in share.keys}
        self._waiting |= {_key(figure): figure for figure in figures if _key(figure) not in begun}
        count = min(_processor_count(), len(self._waiting))
        self._start(count if count > 1 else 0)  # a single one is drawn here
        meanwhile()
        while count > 1 and self._waiting:
            if running := self._running:  # they may have ended meanwhile, and of none there is nothing to wait for
                wait([process.sentinel for process in running])
            self._start(count)
        drawn = {key: figure.drawn() for key, figure in self._waiting.items()}
        for share in self._shares:
            drawn |= zip(share.keys, share.read(), strict=True)
        return [drawn[_key(figure)] for figure in figures]

    @property
    def _running(self) -> list[BaseProcess]:
        return [share.process for share in self._shares if share.process.exitcode is None]

    def _start(self, count: int, least: int = 1) -> None:
        """Let ``count`` processes draw what waits, as long as that are ``least`` figures."""
        while len(self._waiting) >= least and len(self._running) < count:
            keys = list(self._waiting)[:AT_ONCE]
            figures, file = [self._waiting.pop(key) for key in keys], TemporaryFile()  # noqa: SIM115
            process = get_context("fork").Process(target=_draw, args=(os.getpid(), figures, file))
            process.start()
            self._shares.append(_Share(process, file, keys))


def _key(figure: Figure) -> Key:
    return figure.anchor, id(figure.draw)


def _draw(parent: int, figures: Sequence[Figure], file: IO[bytes]) -> None:
    begin(parent, gc.disable)  # a drawing makes many objects, and all of a process's drawings together fit into memory
    try:
        found: object = [figure.drawn() for figure in figures]
    except Exception as error:
        found = error
    pickle.dump(found, file)
    file.flush()


def _processor_count() -> int:
    """The processors that may be used; one where a fork is not safe, or not there."""
    return len(os.sched_getaffinity(0)) if sys.platform == "linux" else 1
