"""Drawing: the figures of a build on every processor that there is, from when the first of them is derived."""

import gc
import os
import pickle
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from multiprocessing import get_context
from multiprocessing.process import BaseProcess
from tempfile import TemporaryFile
from typing import IO

from measured_report.files.errors import ReportError
from measured_report.files.processes import KILLED, begin
from measured_report.parts.section import Figure, Pictures

AT_ONCE = 6
"""So many figures have to wait before a process is begun while others are derived: it takes as long as half of one."""
TURN = 4
"""Bytes of a number that says which figure is next."""
Key = tuple[str, int]
"""Tells figures apart: the id, and what draws it."""
Queue = tuple[Sequence[Figure], IO[bytes]]
"""Figures that processes draw in turn, and the file with their numbers, of which each process takes the next one."""


@dataclass(frozen=True)
class _Share:
    """Figures that a process draws, which is a fork of this one, so that a figure can hold functions."""

    process: BaseProcess
    file: IO[bytes]
    """Where it writes the drawings, or the error that stopped it."""

    def read(self) -> dict[Key, Pictures]:
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
        self._begun: set[Key] = set()
        self._queues: list[Queue] = []
        self._shares: list[_Share] = []

    def __enter__(self) -> "Drawing":
        return self

    def __exit__(self, *_: object) -> None:
        for share in self._shares:
            share.process.kill()
        for queue in self._queues:
            queue[1].close()

    def begin(self, figures: Iterable[Figure]) -> None:
        """Draw these, which ``all`` is to be asked for, on the processors that this process leaves to others."""
        self._waiting |= {_key(figure): figure for figure in figures if figure.is_there}
        if len(self._waiting) >= AT_ONCE and self._running < _processor_count() - 1:
            self._start(1)

    def all(self, figures: Sequence[Figure], meanwhile: Callable[[], None]) -> list[Pictures]:
        """Each figure as it is drawn, in their order; ``meanwhile`` is done in any case, while others draw."""
        self._waiting |= {_key(figure): figure for figure in figures if _key(figure) not in self._begun}
        begun = sum(len(queue[0]) for queue in self._queues) if self._running else 0
        count = min(_processor_count(), len(self._waiting) + begun)
        if count > 1:  # a single one is drawn here
            self._start(count)
        meanwhile()
        drawn = {key: figure.drawn() for key, figure in self._waiting.items()}
        for share in self._shares:
            drawn |= share.read()
        return [drawn[_key(figure)] for figure in figures]

    @property
    def _running(self) -> int:
        return sum(share.process.exitcode is None for share in self._shares)

    def _start(self, count: int) -> None:
        """Let ``count`` processes more draw what waits, and what is left of what others have begun with."""
        turns = TemporaryFile()  # noqa: SIM115
        turns.write(b"".join(number.to_bytes(TURN, "big") for number in range(len(self._waiting))))
        turns.seek(0)
        self._queues.append((list(self._waiting.values()), turns))
        self._begun |= self._waiting.keys()
        self._waiting = {}
        for _ in range(count):
            file = TemporaryFile()  # noqa: SIM115
            process = get_context("fork").Process(target=_draw, args=(os.getpid(), self._queues, file))
            process.start()
            self._shares.append(_Share(process, file))


def _key(figure: Figure) -> Key:
    return figure.anchor, id(figure.draw)


def _draw(parent: int, queues: Sequence[Queue], file: IO[bytes]) -> None:
    begin(parent, gc.disable)  # a drawing makes many objects, and all of a process's drawings together fit into memory
    found: object
    try:
        found = {_key(figure): figure.drawn() for queue in queues for figure in _taken(*queue)}
    except Exception as error:
        found = error
    pickle.dump(found, file)
    file.flush()


def _taken(figures: Sequence[Figure], turns: IO[bytes]) -> Iterator[Figure]:
    """Those that no other process takes: where the file is read next is the same for all of them."""
    while turn := os.read(turns.fileno(), TURN):
        yield figures[int.from_bytes(turn, "big")]


def _processor_count() -> int:
    """The processors that may be used; one where a fork is not safe, or not there."""
    return len(os.sched_getaffinity(0)) if sys.platform == "linux" else 1
