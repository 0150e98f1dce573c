"""The outcome of a batch: done, lost or failed."""

import pickle
import time
import traceback
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime, timezone
from typing import Any, TypeAlias

from measured_report.measuring.batch import Batch
from measured_report.measuring.error_text import is_expected, reason_of
from measured_report.measuring.turns import turn


@dataclass(frozen=True)
class Done:
    """What a batch has returned, as bytes, and what measured it."""

    content: bytes
    machine: Mapping[str, Any]
    started: str
    ended: str
    seconds: float
    """How long it took, without what it has waited for."""
    alone_s: float = 0.0
    """How long of that nothing else might run on its GPU or host."""


@dataclass(frozen=True)
class Lost:
    """A batch whose process, worker or host is gone: it is tried again."""

    reason: str


@dataclass(frozen=True)
class Failed:
    """A batch that raised an error, and would raise it again."""

    reason: str
    trace: str = ""


BatchOutcome: TypeAlias = Done | Lost | Failed


def run_batch(batch: Batch, machine: Mapping[str, Any]) -> Done | Failed:
    """Measure a batch in this process."""
    start = time.perf_counter()
    try:
        with turn(alone=batch.exclusive, on_host=batch.exclusive) as mine:
            started = now()
            content = pickle.dumps(batch.function(*batch.arguments), protocol=pickle.HIGHEST_PROTOCOL)
    except Exception as error:  # one batch's fault must not cost the others
        return failed(error)
    seconds = time.perf_counter() - start - mine.waited_s
    return Done(content, machine, started, now(), round(seconds, 1), round(mine.alone_s, 1))


def failed(error: Exception) -> Failed:
    """Say why a step failed, and where, unless the reason says all there is."""
    return Failed(reason_of(error), "" if is_expected(error) else "".join(traceback.format_exception(error)))


def now() -> str:
    """The time, as records have it."""
    return datetime.now(timezone.utc).isoformat(timespec="seconds")
