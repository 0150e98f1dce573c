"""Batches: the parts of a section that can be measured apart, by any process of any host, in any order.

A section that has batches yields those that can run now, and is sent what they return, in that order::

    points, cells = yield [Batch("points", measure_points, (conditions,)), Batch("map", measure_map, (conditions,))]
    [times] = yield [Batch("times", time_cell, (conditions, cells[0]), exclusive=True)]
"""

import gc
import os
import pickle
import re
import tempfile
import time
from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from datetime import datetime, timedelta, timezone
from pathlib import Path
from typing import Any, TypeAlias

from measured_report.files.atomic import locked
from measured_report.files.config import Report
from measured_report.files.config import report as current
from measured_report.files.errors import ReportError, bug_of
from measured_report.measuring.machine import machine
from measured_report.measuring.measurement import Measurement

OUT_OF_MEMORY = re.compile(
    "out of memory|failed to allocate|cannot allocate|bad_alloc", re.IGNORECASE
)
LOCK = Path(tempfile.gettempdir()) / f"measured-report-{os.getuid()}"
"""A lock by which two runs of ``make`` spoil no times of each other."""


@dataclass(frozen=True)
class Batch:
    """Describes a call that a process of its own can make."""

    name: str  # unlike all others of its section: lower-case words, numbers and hyphens
    function: Callable[..., Any]  # a function of a module; what it returns is pickled
    arguments: tuple[Any, ...] = ()
    exclusive: bool = False
    """Measures times, so that nothing else is measured on its host meanwhile."""


Plan: TypeAlias = Generator[Sequence[Batch], Sequence[Any], Measurement]


@dataclass(frozen=True)
class Result:
    value: bytes  # pickled, and read where an error costs this batch alone
    machine: Mapping[str, Any]
    started: str
    ended: str
    seconds: float


def device_lock(*, exclusive: bool) -> AbstractContextManager[None]:
    """Hold the lock of this host, together with others unless it is ``exclusive``."""
    LOCK.mkdir(mode=0o700, exist_ok=True)
    return locked(LOCK, alone=exclusive)


def measure_batch(packed: bytes, device: str) -> Result:
    """Measure a pickled batch in this process, on a kind of device; raise ReportError if it fails."""
    try:
        batch = pickle.loads(packed)
        description = machine(device)
        gc.collect()  # earlier simulations that are kept make frames take longer
        with device_lock(exclusive=batch.exclusive):
            started = now()
            start = time.perf_counter()
            value = batch.function(*batch.arguments)
            seconds = time.perf_counter() - start
        ended = started + timedelta(seconds=seconds)  # whatever the clock does
        return Result(
            pickle.dumps(value),
            description,
            started.isoformat(timespec="seconds"),
            ended.isoformat(timespec="seconds"),
            round(seconds, 1),
        )
    # sys.exit too: a fault of a section must not end the process.
    except BaseException as error:
        raise ReportError(reason_of(error, current())) from None


def reason_of(error: BaseException, report: Report) -> str:
    """Return why measuring failed, in one line, with what to do."""
    message = " ".join(str(error).split())
    if is_out_of_memory(error):
        return f"the memory is too small ({message:.200}); free some of it, or PROFILE=quick measures small grids"
    if explained := report.host.explained(error):
        return str(explained)
    if isinstance(error, OSError):
        message = error.strerror or message or type(error).__name__
        return f"{error.filename}: {message}" if error.filename else message
    return str(error) if isinstance(error, ReportError) else bug_of(error)


def is_out_of_memory(error: BaseException) -> bool:
    return isinstance(error, MemoryError) or bool(OUT_OF_MEMORY.search(str(error)))


def now() -> datetime:
    """Return the time; raise ReportError if the clock is not set, since no record may have such a time."""
    time = datetime.now(timezone.utc)
    if time.year not in range(2000, 2100):
        raise ReportError(f"the clock of this machine says {time:%Y-%m-%d}: set it")
    return time
