"""A loop that measures sections: what times nothing side by side, and then, one after the other, what does."""

import sys
import time
from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, wait
from typing import Any, Protocol

from tqdm import tqdm

from measured_report.files.errors import ReportError
from measured_report.measuring.batch import Batch, BatchError, measure_batch
from measured_report.measuring.error_text import reason_of
from measured_report.measuring.section import Section, seconds_of


class Pool(Protocol):
    """Processes that measure; see ``concurrent.futures.Executor``."""

    limit: int
    """Batches that it is given at once."""
    at_once: int
    """Batches that are measured beside each other on a host."""
    lost: type[Exception]
    """Error of a batch whose process was killed."""
    try_count: int
    """Times that such a batch is submitted."""

    def submit(self, function: Callable, *arguments: Any) -> Future:
        """Call a function in one of the processes."""


class Loop:
    """Sections, and the pools for batches that share their host and for those that are exclusive there."""

    def __init__(self, sections: Sequence[Section], shared: Pool, exclusive: Pool):
        self.sections, self.shared, self.exclusive = sections, shared, exclusive
        self.running: dict[Future, tuple[Section, Batch, float]] = {}
        self._begun: set[str] = set()

    def run(self) -> bool:
        """Measure all sections; tell whether any failed."""
        for section in self.sections:
            section.advance()
        with tqdm(bar_format="{elapsed}  {desc}", leave=False, disable=not sys.stderr.isatty()) as bar:
            while self._submit():
                for future in wait(self.running, timeout=1.0, return_when=FIRST_COMPLETED).done:
                    self._take(future, *self.running.pop(future)[:2])
                bar.set_description_str(self.status())
        return any(section.failure for section in self.sections)

    def _submit(self) -> bool:
        """Submit what can run beside what does, the longest first; tell whether anything runs."""
        for pool, is_exclusive in ((self.shared, False), (self.exclusive, True)):
            if all(section.is_exclusive(batch) == is_exclusive for section, batch, _ in self.running.values()):
                waiting = [(section, batch) for section in self.sections for batch in section.waiting]
                ready = [(section, batch) for section, batch in waiting if section.is_exclusive(batch) == is_exclusive]
                ready.sort(key=lambda pair: pair[0].expected_s(pair[1]), reverse=True)
                for section, batch in ready[: max(0, pool.limit - len(self.running))]:
                    self._begin(section, batch, pool)
        return bool(self.running)

    def _begin(self, section: Section, batch: Batch, pool: Pool) -> None:
        if section.name not in self._begun:
            self._begun.add(section.name)
            tqdm.write(f"[{len(self._begun)}/{len(self.sections)}] {section.name}")
        section.waiting = [other for other in section.waiting if other is not batch]
        future = pool.submit(measure_batch, batch, section.device)
        self.running[future] = section, batch, time.monotonic()

    def _take(self, future: Future, section: Section, batch: Batch) -> None:
        pool = self.exclusive if section.is_exclusive(batch) else self.shared
        try:
            section.take(batch, future.result())
        except pool.lost:
            section.lose(batch, pool.try_count)
        except CancelledError:
            raise ReportError("the scheduler is gone; what is finished is kept") from None
        except BatchError as error:
            reason, trace = error.args
            section.fail(reason if section.title(batch) == section.name else f"{batch.name}: {reason}", trace)
        except Exception as error:  # what it returns, or is given, can't travel
            section.fail(f"{batch.name}: {reason_of(error)}")
        else:
            section.advance(self.shared.at_once)

    def status(self) -> str:
        """Say how far it is: batches done, what runs, and for how long it will."""
        done = sum(len(section.results) for section in self.sections)
        count = done + len(self.running) + sum(len(section.waiting) for section in self.sections)
        running = ", ".join(section.title(batch) for section, batch, _ in self.running.values())
        said, left = f"{done} of {count} batches; {running or 'nothing'} running", self._seconds_left()
        if left is None:
            return said
        return f"{said}; about {f'{left / 60:.0f} min' if left > 90 else f'{left:.0f} s'} left"

    def _seconds_left(self) -> float | None:
        """Estimate it from what the batches took the last time; None where a section has no last time."""
        sections = [section for section in self.sections if not section.is_over]
        if not all(section.known for section in sections):
            return None
        left = {(s.name, name): took for s in sections for name, took in s.known.items() if name not in s.times}
        for section, batch, since in self.running.values():
            key = section.name, batch.time_name
            left[key] = max(0.0, left.get(key, 0.0) - (time.monotonic() - since))
        return seconds_of([(name, took) for (_, name), took in left.items()], self.shared.at_once)
