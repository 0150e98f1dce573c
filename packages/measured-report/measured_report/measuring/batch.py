"""Define batches: the parts of a section that any process of any host can measure.

A section yields the batches that can run now, and receives their results in the same
order::

    points, cells = yield [
        Batch("points", measure_points, (conditions,)),
        Batch("map", measure_map, (conditions,)),
    ]
    [times] = yield [
        Batch("times", time_cell, (conditions, cells[0]), exclusive=True)
    ]
"""

import gc
import os
import pickle
import re
import sys
import tempfile
import time
import warnings
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from datetime import datetime, timedelta, timezone
from pathlib import Path
from typing import Any, TypeAlias

from measured_report.files.atomic import locked
from measured_report.files.config import Report
from measured_report.files.config import report as current
from measured_report.files.errors import (
    UNPRINTABLE,
    ReportError,
    bug_of,
    without_secrets,
)
from measured_report.measuring.machine import machine
from measured_report.records.record import LINE_LIMIT

OUT_OF_MEMORY = re.compile(
    "out of memory|failed to allocate|cannot allocate|bad_alloc", re.IGNORECASE
)
LOCK = Path(tempfile.gettempdir()) / f"measured-report-{os.getuid()}"
"""A lock that keeps two runs of ``make`` from disturbing each other's timings."""


STARTED = "subprocess.Popen"  # the event of Python that lists a program's arguments
OPENED: set[tuple[str, str]] = set()
"""The files that this process read or started since it was last cleared.

Each of them is a path after the event of Python that names it.
"""


def note_opened() -> None:
    """Add the files that this process and its forks open from now on to ``OPENED``."""

    def note(event: str, arguments: tuple[Any, ...]) -> None:
        is_written = event == "open" and arguments[2] & (os.O_WRONLY | os.O_RDWR)
        if event in ("open", "sqlite3.connect", STARTED) and not is_written:
            names = arguments[1] if event == STARTED else arguments[:1]
            OPENED.update((event, os.path.abspath(str(name))) for name in names)

    sys.addaudithook(note)


@dataclass(frozen=True)
class Batch:
    """Describe a function call that a separate process can make."""

    name: str  # unique in its section: lower-case words, digits and hyphens
    function: Callable[..., Any]  # a function of a module; its result is pickled
    arguments: tuple[Any, ...] = ()
    exclusive: bool = False
    """Whether the batch measures times, so that its host must not measure anything else
    at the same time.
    """


Plan: TypeAlias = Generator[Sequence[Batch], Sequence[Any], Any]


@dataclass(frozen=True)
class Result:
    value: bytes  # pickled; an error while unpickling then fails only this batch
    machine: Mapping[str, Any]
    started: str
    ended: str
    seconds: float
    opened: frozenset[tuple[str, str]] = frozenset()  # see ``OPENED``
    deprecated: frozenset[str] = frozenset()  # see ``deprecations``


def device_lock(*, exclusive: bool) -> AbstractContextManager[None]:
    """Hold the lock of this host, shared with other processes unless ``exclusive``."""
    LOCK.mkdir(mode=0o700, exist_ok=True)
    return locked(LOCK, alone=exclusive)


def measure_batch(packed: bytes, device: str) -> Result:
    """Measure a pickled batch in this process and return its result.

    Raise ReportError if the batch fails.
    """
    try:
        OPENED.clear()  # other sections and preparations of this process read them
        batch = pickle.loads(packed)
        description = machine(device)
        gc.collect()  # simulations that are no longer used would make frames slower
        with device_lock(exclusive=batch.exclusive):
            started = utc_time()
            start = time.perf_counter()
            with deprecations() as deprecated:
                value = batch.function(*batch.arguments)
            seconds = time.perf_counter() - start
        # The end is computed, because the clock may have been set during the
        # measurement.
        ended = started + timedelta(seconds=seconds)
        return Result(
            value=pickle.dumps(value),
            machine=description,
            started=started.isoformat(timespec="seconds"),
            ended=ended.isoformat(timespec="seconds"),
            seconds=round(seconds, 1),
            opened=frozenset(OPENED),
            deprecated=frozenset(deprecated),
        )
    # Catch SystemExit too: a section that fails must not end the process.
    except BaseException as error:
        raise ReportError(reason_of(error, current())) from None


@contextmanager
def deprecations() -> Iterator[set[str]]:
    """Collect the warnings of features that a later release removes, as lines.

    They are not printed. All other warnings are.
    """
    lines = set()

    def show(*warning: Any) -> None:
        message, category, *_ = warning
        if issubclass(category, DeprecationWarning):
            line = UNPRINTABLE.sub("?", " ".join(str(message).split()))
            lines.add(without_secrets(line)[:LINE_LIMIT])
        else:
            show_others(*warning)

    with warnings.catch_warnings():
        warnings.simplefilter("default", DeprecationWarning)
        show_others = warnings.showwarning
        warnings.showwarning = show  # type: ignore[assignment]
        yield lines


def reason_of(error: BaseException, report: Report) -> str:
    """Return one line with the reason why a measurement failed and a remedy."""
    message = " ".join(str(error).split())
    if is_out_of_memory(error):
        return (
            f"memory ran out ({message:.200}): free some memory, or use PROFILE=quick "
            "to measure small grids"
        )
    if explained := report.host.explained(error):
        return str(explained)
    if isinstance(error, OSError):
        message = error.strerror or message or type(error).__name__
        return f"{error.filename}: {message}" if error.filename else message
    return str(error) if isinstance(error, ReportError) else bug_of(error)


def is_out_of_memory(error: BaseException) -> bool:
    return isinstance(error, MemoryError) or bool(OUT_OF_MEMORY.search(str(error)))


def utc_time() -> datetime:
    return datetime.now(timezone.utc)
