"""Turns on a host: what measures times has the host for itself, and what prepares for that is beside its like.

All batches that this user measures on a host share a lock. One about times alone holds it for itself, or, where it
prepares first, within ``alone``::

    simulation = build()
    with alone():
        times = frame_times(simulation)

Who asks first is served first. What prepares gives way to whoever is alone next, once that waits for nothing else: as
soon as its device is done with what it was given it pauses, and goes on afterwards.
"""

import _thread
import fcntl
import os
import signal
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from measured_report.measuring.host import host

PLACE = Path(tempfile.gettempdir()) / f"measured-report-{os.getuid()}.turns"
QUEUE, PREPARING = ".queue", ".preparing"
"""What the names of the files end with whose locks are held by whoever is next, and by all that prepare."""
PATIENCE_S = 30.0
"""How long others are waited for without a word."""
WAITING = "waiting for what else is measured on this host"
POLL_S = 0.1
"""How soon what prepares notices that another asks to be alone."""
GIVE_WAY = signal.SIGUSR1
"""What the main thread is interrupted with between two steps of Python; no process is sent it."""


@dataclass
class Turn:
    """The part that a batch has in the lock."""

    place: int
    """Descriptor of the lock's file."""
    queue: int
    preparing: int
    prepares: bool
    probe: int
    """Of the lock's file as well, for the thread that asks who waits."""
    is_alone: bool = False
    can_give_way: bool = False
    since: float = 0.0
    alone_s: float = 0.0
    """How long it was alone."""
    waited_s: float = 0.0
    """How long it has waited for others."""

    def take(self, *, alone: bool, in_turn: bool = True) -> None:
        """Hold the host alone or together with others, ``in_turn`` when all who have asked before have had theirs."""
        self.can_give_way = False
        self.end()
        asked = time.perf_counter()
        with suppress(OSError):  # a file system without locks: what measures there is then up to its users
            fcntl.flock(self.place, fcntl.LOCK_UN)
            fcntl.flock(self.preparing, fcntl.LOCK_UN)
            if in_turn:
                fcntl.flock(self.queue, fcntl.LOCK_EX)
            fcntl.flock(self.place, fcntl.LOCK_EX if alone else fcntl.LOCK_SH)
            if alone or self.prepares:
                fcntl.flock(self.preparing, fcntl.LOCK_EX if alone else fcntl.LOCK_SH)
            if self.prepares and not alone:
                fcntl.flock(self.place, fcntl.LOCK_UN)  # so that whoever is next has it while this is waited for
            fcntl.flock(self.queue, fcntl.LOCK_UN)
        self.is_alone, self.since = alone, time.perf_counter()
        self.waited_s += self.since - asked
        self.can_give_way = self.prepares and not alone

    def end(self) -> None:
        """Be alone no longer, as far as it is counted."""
        self.alone_s += time.perf_counter() - self.since if self.is_alone else 0.0
        self.is_alone = False

    @contextmanager
    def giving_way(self, settle: Callable[[], bool]) -> Iterator[None]:
        """Pause whenever it alone is waited for, unless ``settle`` says that what runs can't be left now."""
        over = threading.Event()

        def watch() -> None:
            while not over.wait(POLL_S):
                if self.can_give_way and self._is_awaited():
                    _thread.interrupt_main(GIVE_WAY)

        def give_way(*_: object) -> None:
            if self.can_give_way and settle():
                self.take(alone=False)

        watcher, before = threading.Thread(target=watch, daemon=True), signal.signal(GIVE_WAY, give_way)
        watcher.start()
        try:
            yield
        finally:
            over.set()
            watcher.join()
            signal.signal(GIVE_WAY, before)

    def _is_awaited(self) -> bool:
        try:
            fcntl.flock(self.probe, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except OSError as error:
            return isinstance(error, BlockingIOError)
        fcntl.flock(self.probe, fcntl.LOCK_UN)
        return False


_turns: list[Turn] = []
"""That of the batch which this process measures, if it does."""


@contextmanager
def turn(*, alone: bool, prepares: bool = False) -> Iterator[Turn]:
    """Hold this host for a batch: what ``prepares`` is alone only within ``alone``."""
    with ExitStack() as stack:
        place, queue, preparing, probe = (_opened(ending, stack) for ending in ("", QUEUE, PREPARING, ""))
        mine = Turn(place, queue, preparing, prepares, probe)
        # What waits later does so for its like, which take turns.
        word = threading.Timer(PATIENCE_S, print, [WAITING], {"file": sys.stderr, "flush": True})
        word.daemon = True
        word.start()
        stack.callback(word.cancel)
        mine.take(alone=alone and not prepares, in_turn=not prepares)
        word.cancel()
        _turns.append(mine)
        stack.callback(_turns.remove, mine)
        stack.callback(mine.end)
        if prepares:
            stack.enter_context(mine.giving_way(host().settle))
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
