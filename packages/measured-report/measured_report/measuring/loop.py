"""A loop that measures sections: what times nothing side by side, and then, one after the other, what does."""

import sys
from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, wait
from typing import Any, Protocol

from tqdm import tqdm

from measured_report.files.errors import ReportError
from measured_report.measuring.batch import Batch, BatchError, measure_batch, reason_of
from measured_report.measuring.section import WHOLE, Section


class Pool(Protocol):
    """Submit to processes that measure; see ``concurrent.futures.Executor``."""

    limit: int
    """Batches that it is given at once."""
    lost: type[Exception]
    """Error of a batch whose process was killed."""

    def submit(self, function: Callable, *arguments: Any) -> Future:
        """Call a function in one of the processes."""


class Loop:
    """Measure sections, with a pool for batches that share their host and one for those that are exclusive there."""

    def __init__(self, sections: Sequence[Section], shared: Pool, exclusive: Pool):
        self.sections, self.shared, self.exclusive = sections, shared, exclusive
        self.running: dict[Future, tuple[Section, Batch]] = {}

    def run(self) -> bool:
        """Measure all sections; tell whether any failed."""
        for section in self.sections:
            section.advance()
        with tqdm(unit="batch", leave=False, disable=not sys.stderr.isatty()) as bar:
            while self._submit():
                for future in wait(self.running, timeout=1.0, return_when=FIRST_COMPLETED).done:
                    self._take(future, *self.running.pop(future))
                    bar.update()
        return any(section.has_failed for section in self.sections)

    def _submit(self) -> bool:
        """Submit what can run beside what does; tell whether anything runs."""
        for pool, is_exclusive in ((self.shared, False), (self.exclusive, True)):
            if all(section.is_exclusive(batch) == is_exclusive for section, batch in self.running.values()):
                waiting = [(section, batch) for section in self.sections for batch in section.waiting]
                ready = [(section, batch) for section, batch in waiting if section.is_exclusive(batch) == is_exclusive]
                for section, batch in ready[: max(0, pool.limit - len(self.running))]:
                    section.waiting = [other for other in section.waiting if other is not batch]
                    self.running[pool.submit(measure_batch, batch, section.device)] = section, batch
        return bool(self.running)

    def _take(self, future: Future, section: Section, batch: Batch) -> None:
        pool = self.exclusive if section.is_exclusive(batch) else self.shared
        try:
            section.results[batch.name] = future.result()
        except pool.lost:
            section.lose(batch)
        except CancelledError:
            raise ReportError("the scheduler is gone; what is finished is kept") from None
        except BatchError as error:
            reason, trace = error.args
            section.fail(reason if batch.name == WHOLE else f"{batch.name}: {reason}", trace)
        except Exception as error:  # what it returns, or is given, can't travel
            section.fail(f"{batch.name}: {reason_of(error)}")
        else:
            section.advance()
