"""The outcome of a batch: done, lost or failed."""

import pickle
import time
import traceback
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from datetime import datetime, timezone
from typing import Any, TypeAlias

from measured_report.measuring.reasons import is_expected, reason_of


@dataclass(frozen=True)
class Done:
    """What a batch has returned, as bytes, and what measured it."""

    content: bytes
    machine: Mapping[str, Any]
    started: str
    ended: str
    seconds: float


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


def run_batch(function: Callable, arguments: tuple, machine: Mapping[str, Any]) -> Done | Failed:
    """Measure a batch in this process."""
    started, start = now(), time.perf_counter()
    try:
        content = pickle.dumps(function(*arguments), protocol=pickle.HIGHEST_PROTOCOL)
    except Exception as error:  # one batch's fault must not cost the others
        return failed(error)
    return Done(content, machine, started, now(), round(time.perf_counter() - start, 1))


def failed(error: Exception) -> Failed:
    """Say why a step failed, and where, unless the reason says all there is."""
    return Failed(reason_of(error), "" if is_expected(error) else "".join(traceback.format_exception(error)))


def now() -> str:
    """The time, as records have it."""
    return datetime.now(timezone.utc).isoformat(timespec="seconds")
