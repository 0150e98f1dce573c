"""Turns on a host: what measures times has the host for itself, and what prepares for that is beside its like.

All batches that this user measures on a host share a lock. One about times alone holds it for itself, or, where it
prepares first, within ``alone``::

    simulation = build()
    with alone():
        times = frame_times(simulation)

Who asks first is served first. So while one is timed the next ones gather, and when all have been, they prepare
together again.
"""

import fcntl
import os
import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

PLACE = Path(tempfile.gettempdir()) / f"measured-report-{os.getuid()}.turns"
QUEUE = ".queue"
"""What the name of the file ends with whose lock is held by whoever is next."""
PATIENCE_S = 30.0
"""How long others are waited for without a word."""
WAITING = "waiting for what else is measured on this host"


@dataclass
class Turn:
    """The part that a batch has in the lock."""

    place: int
    """Descriptor of the lock's file."""
    queue: int
    prepares: bool
    is_alone: bool = False
    since: float = 0.0
    alone_s: float = 0.0
    """How long it was alone."""
    waited_s: float = 0.0
    """How long it has waited for others."""

    def take(self, *, alone: bool) -> None:
        """Hold the host alone or together with others, when all who have asked before have had their turn."""
        self.end()
        asked = time.perf_counter()
        with suppress(OSError):  # a file system without locks: what measures there is then up to its users
            fcntl.flock(self.place, fcntl.LOCK_UN)
            fcntl.flock(self.queue, fcntl.LOCK_EX)
            fcntl.flock(self.place, fcntl.LOCK_EX if alone else fcntl.LOCK_SH)
            fcntl.flock(self.queue, fcntl.LOCK_UN)
        self.is_alone, self.since = alone, time.perf_counter()
        self.waited_s += self.since - asked

    def end(self) -> None:
        """Be alone no longer, as far as it is counted."""
        self.alone_s += time.perf_counter() - self.since if self.is_alone else 0.0
        self.is_alone = False


_turns: list[Turn] = []
"""That of the batch which this process measures, if it does."""


@contextmanager
def turn(*, alone: bool, prepares: bool = False) -> Iterator[Turn]:
    """Hold this host for a batch: what ``prepares`` is alone only within ``alone``."""
    with ExitStack() as stack:
        place, queue = (_opened(ending, stack) for ending in ("", QUEUE))
        mine = Turn(place, queue, prepares)
        # What waits later does so for its like, which take turns.
        word = threading.Timer(PATIENCE_S, print, [WAITING], {"file": sys.stderr, "flush": True})
        word.daemon = True
        word.start()
        stack.callback(word.cancel)
        mine.take(alone=alone and not prepares)
        word.cancel()
        _turns.append(mine)
        stack.callback(_turns.remove, mine)
        stack.callback(mine.end)
        yield mine


def _opened(ending: str, stack: ExitStack) -> int:
    path = PLACE.with_name(PLACE.name + ending)
    descriptor = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC | os.O_NOFOLLOW, 0o600)
    stack.callback(os.close, descriptor)
    return descriptor


@contextmanager
def alone() -> Iterator[None]:
    """Have the host for oneself, in a batch that prepares; in any other nothing changes."""
    mine = _turns[-1] if _turns else None
    if mine is None or not mine.prepares or mine.is_alone:
        yield
        return
    mine.take(alone=True)
    try:
        yield
    finally:
        mine.take(alone=False)
