"""Turns: what measures times has its GPU or host for itself, and what prepares for that is beside its like.

All batches that this user measures on a host share a lock, and those of a process that has one GPU share that GPU's.
One about times alone holds the last of them for itself, or, where it prepares first, within ``alone``::

    simulation = build()
    with alone():
        times = frame_times(simulation)

Who asks first is served first. What prepares gives way to whoever is alone next, once that waits for nothing else: as
soon as its device is done with what it was given it pauses, and goes on afterwards. So GPUs of one host disturb each
other as little as they do when they belong to two. What times the CPU has the host for itself, and waits until no GPU
of it is used or wanted.
"""

import _thread
import fcntl
import os
import re
import signal
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Sequence
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


@dataclass(frozen=True)
class Place:
    """A host or a GPU, as descriptors of the files whose locks are held by whoever is there."""

    lock: int
    queue: int
    preparing: int
    probe: int
    """Of the lock's file as well, for the thread that asks who waits."""

    def take(self, *, alone: bool, prepares: bool, in_turn: bool) -> None:
        """Be there alone or beside others, ``in_turn`` when all who have asked before have had their turn."""
        if in_turn:
            fcntl.flock(self.queue, fcntl.LOCK_EX)
        fcntl.flock(self.lock, fcntl.LOCK_EX if alone else fcntl.LOCK_SH)
        if alone or prepares:
            fcntl.flock(self.preparing, fcntl.LOCK_EX if alone else fcntl.LOCK_SH)
        if prepares:
            fcntl.flock(self.lock, fcntl.LOCK_UN)  # so that whoever is next has it while this is waited for
        fcntl.flock(self.queue, fcntl.LOCK_UN)

    def leave(self) -> None:
        fcntl.flock(self.lock, fcntl.LOCK_UN)
        fcntl.flock(self.preparing, fcntl.LOCK_UN)

    def is_awaited(self) -> bool:
        """Whether one who is to be alone waits for nothing but what prepares."""
        try:
            fcntl.flock(self.probe, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except OSError as error:
            return isinstance(error, BlockingIOError)
        fcntl.flock(self.probe, fcntl.LOCK_UN)
        return False


@dataclass
class Turn:
    """The part that a batch has in the locks."""

    places: Sequence[Place]
    """Its host, and its GPU if it has one."""
    prepares: bool
    on_host: bool
    """Whether it is alone on its host, GPU or not."""
    is_alone: bool = False
    can_give_way: bool = False
    since: float = 0.0
    alone_s: float = 0.0
    """How long it was alone."""
    waited_s: float = 0.0
    """How long it has waited for others."""

    def take(self, *, alone: bool, in_turn: bool = True) -> None:
        """Be alone or beside others, ``in_turn`` when all who have asked before have had theirs."""
        self.can_give_way = False
        self.end()
        asked = time.perf_counter()
        with suppress(OSError):  # a file system without locks: what measures there is then up to its users
            for place in self.places:
                place.leave()
            for place in self.places:
                is_last = place is self.places[-1]
                is_mine = alone and (is_last or self.on_host)
                # Who asked for a host with GPUs in turn would keep all of them from those who are served sooner.
                fair = in_turn and (is_last or not is_mine)
                place.take(alone=is_mine, prepares=self.prepares and not alone, in_turn=fair)
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
                if self.can_give_way and any(place.is_awaited() for place in self.places):
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


_turns: list[Turn] = []
"""That of the batch which this process measures, if it does."""


@contextmanager
def turn(*, alone: bool, prepares: bool = False, on_host: bool = False) -> Iterator[Turn]:
    """Hold this host for a batch: what ``prepares`` is alone only within ``alone``."""
    with ExitStack() as stack:
        places = [Place(*(_opened(name + ending, stack) for ending in ("", QUEUE, PREPARING, ""))) for name in _names()]
        mine = Turn(places, prepares, on_host)
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


def _names() -> list[str]:
    """What the names of the files end with of the places that this process has a part in."""
    gpu = os.environ.get("CUDA_VISIBLE_DEVICES", "")
    return ["", f".{gpu}"] if re.fullmatch(r"GPU-[0-9a-f-]+", gpu) else [""]


def _opened(ending: str, stack: ExitStack) -> int:
    path = PLACE.with_name(PLACE.name + ending)
    descriptor = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC | os.O_NOFOLLOW, 0o600)
    stack.callback(os.close, descriptor)
    return descriptor


@contextmanager
def alone() -> Iterator[None]:
    """Have the GPU or host for oneself, in a batch that prepares; in any other nothing changes."""
    mine = _turns[-1] if _turns else None
    if mine is None or not mine.prepares or mine.is_alone:
        yield
        return
    mine.take(alone=True)
    try:
        yield
    finally:
        mine.take(alone=False)
