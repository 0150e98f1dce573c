"""Sections, from the first batch to the record, and the loop that measures them."""

import inspect
import pickle
import re
import sys
from collections.abc import Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, wait
from dataclasses import dataclass, field, replace
from types import ModuleType
from typing import Any

from tqdm import tqdm

from measured_report.editions.project import Project
from measured_report.files.columns import REASON, UNBELIEVED, Schema, is_number, plain
from measured_report.files.errors import ReportError
from measured_report.measuring.batch import (
    Batch,
    BatchError,
    Plan,
    Result,
    measure_batch,
    reason_of,
)
from measured_report.measuring.machine import KIND, commit, needs_device
from measured_report.measuring.measurement import Measurement
from measured_report.records.record import NAME, Basis, Record
from measured_report.records.traces import packed

WHOLE = "whole"  # name of the one batch of a section that has declared none
GONE = "the scheduler is gone; what is finished is kept"


@dataclass
class Section:
    project: Project
    name: str
    device: str
    plan: Plan
    basis: Basis
    stage: list[Batch] = field(default_factory=list)
    waiting: list[Batch] = field(default_factory=list)
    results: dict[str, Result] = field(default_factory=dict)
    lost: set[str] = field(default_factory=set)
    is_over: bool = False
    has_failed: bool = False

    def is_exclusive(self, batch: Batch) -> bool:
        """Tell whether it is measured alone, as is one that may have killed its process and those beside it."""
        return batch.exclusive or batch.name in self.lost

    def advance(self) -> None:
        """Ask for the next batches once all of a stage are done, and write the record at the end."""
        try:
            while not self.is_over and all(
                batch.name in self.results for batch in self.stage
            ):
                values = [self.results[batch.name].value for batch in self.stage]
                try:
                    self.stage = self.waiting = list(self.plan.send(values or None))  # type: ignore[arg-type]
                except StopIteration as end:
                    self._write(end.value)
                    return
                assert all(isinstance(batch, Batch) for batch in self.stage), (
                    "it yields no Batch: rows are returned"
                )
                names = [batch.name for batch in self.stage]
                if not names or len({*names, *self.results}) < len(names) + len(
                    self.results
                ):
                    raise ValueError(
                        f"batches need names of their own: {', '.join(names)}"
                    )
        except Exception as error:  # a fault of the section must not cost the others
            self.fail(reason_of(error, self.project.report))

    def lose(self, batch: Batch) -> None:
        """Measure a batch whose process was killed again, alone, but no more than once."""
        if batch.name in self.lost:
            self.fail(
                f"{batch.name}: its process was killed, and once more when it was alone"
            )
        elif not self.is_over:
            self.lost.add(batch.name)
            tqdm.write(
                f"{self.name}/{batch.name}: its process was killed; it is tried again alone",
                file=sys.stderr,
            )
            self.waiting = [*self.waiting, batch]

    def fail(self, reason: str) -> None:
        if not self.is_over:
            self.is_over = self.has_failed = True
            self.waiting = []
            tqdm.write(
                f"{self.name}: measuring failed; what was there is kept: {reason}",
                file=sys.stderr,
            )

    def _write(self, measurement: Measurement) -> None:
        results, path = list(self.results.values()), self.project.record_path(self.name)
        columns = self.project.report.columns
        try:
            rows = [believable(row, columns) for row in measurement.rows]
            traces = {
                case: packed(path, case, table, columns)
                for case, table in measurement.traces.items()
            }
        except (AttributeError, TypeError) as error:
            raise ReportError(
                f"it returned no Measurement of rows and traces: {error}"
            ) from None
        if not rows or not all("case" in row for row in rows):
            raise ReportError("it returned no rows, or one without a case")
        if len({tuple(map(result.machine.get, KIND)) for result in results}) > 1:
            raise ReportError(
                "its batches were measured on different kinds of machines"
            )
        names = {
            name: {result.machine[name] for result in results} - {None}
            for name in results[0].machine
        }
        machine = {
            name: ", ".join(sorted(values)) or None for name, values in names.items()
        }
        started, ended = (
            min(result.started for result in results),
            max(result.ended for result in results),
        )
        seconds = round(sum(result.seconds for result in results), 1)
        measured: dict[str, Any] = {
            "date": ended,
            "started": started,
            "ended": ended,
            "commit": commit(self.project.report.root),
        }
        measured |= {
            "command": self.project.rerun(self.name, results[0].machine["device"]),
            "seconds": seconds,
        }
        self.basis.write(
            Record(
                self.name,
                self.basis.identity,
                machine,
                measured,
                columns.units_of(rows),
                rows,
            ),
            traces,
        )
        self.is_over = True
        tqdm.write(
            f"{self.name}: {len(rows)} rows in {seconds:.0f} s → {path.relative_to(self.project.root)}"
        )


class Loop:
    """Measure sections by a pool for batches that share their host and one for those that are exclusive there."""

    def __init__(self, sections: Sequence[Section], shared: Any, exclusive: Any):
        self.sections, self.shared, self.exclusive = sections, shared, exclusive
        self.running: dict[Future[Any], tuple[Section, Batch]] = {}

    def run(self) -> bool:
        """Measure all sections; tell whether any failed."""
        for section in self.sections:
            section.advance()
        with tqdm(unit="batch", leave=False, disable=not sys.stderr.isatty()) as bar:
            while self._submit():
                for future in wait(self.running, return_when=FIRST_COMPLETED).done:
                    self._take(future, *self.running.pop(future))
                    bar.update()
        return any(section.has_failed for section in self.sections)

    def _submit(self) -> bool:
        for pool, is_exclusive in ((self.shared, False), (self.exclusive, True)):
            if all(
                section.is_exclusive(batch) == is_exclusive
                for section, batch in self.running.values()
            ):
                waiting = [
                    (section, batch)
                    for section in self.sections
                    for batch in section.waiting
                ]
                ready = [
                    (section, batch)
                    for section, batch in waiting
                    if section.is_exclusive(batch) == is_exclusive
                ]
                for section, batch in ready[: max(0, pool.limit - len(self.running))]:
                    section.waiting = [
                        candidate
                        for candidate in section.waiting
                        if candidate is not batch
                    ]
                    self.running[pool.submit(measure_batch, batch, section.device)] = (
                        section,
                        batch,
                    )
        return bool(self.running)

    def _take(self, future: Future[Any], section: Section, batch: Batch) -> None:
        pool = self.exclusive if section.is_exclusive(batch) else self.shared
        try:
            result = future.result()
            section.results[batch.name] = replace(
                result, value=pickle.loads(result.value)
            )
        except pool.lost:
            section.lose(batch)
        except CancelledError:
            raise ReportError(GONE) from None
        except BatchError as error:
            section.fail(
                str(error) if batch.name == WHOLE else f"{batch.name}: {error}"
            )
        except Exception as error:  # what it returns, or is given, can't travel
            section.fail(f"{batch.name}: {reason_of(error, section.project.report)}")
        else:
            section.advance()


def section_of(
    project: Project, basis: Basis, module: ModuleType, device: str
) -> Section:
    """Return the section that a module measures, as one batch if it declares none."""
    name = basis.section
    device = device if needs_device(name, project) else "cpu"
    alias = (
        "cpu" if device == "cpu" else f"{device}:0"
    )  # of the only device of its kind that a process measures on
    conditions = project.report.host.Conditions(
        device=alias, quick=project.profile == "quick"
    )
    plans = inspect.isgeneratorfunction(module.measure)
    plan = (
        module.measure(conditions)
        if plans
        else _as_one(Batch(WHOLE, module.measure, (conditions,)))
    )
    return Section(project, name, device, plan, basis)


def _as_one(batch: Batch) -> Plan:
    [measurement] = yield [batch]
    return measurement


def believable(row: Mapping[str, object], columns: Schema) -> dict[str, object]:
    """Return the row in plain numbers, with None, and the reason, for each that no record may hold."""
    row = {str(name): plain(value, str(name)) for name, value in row.items()}
    if wrong := [name for name in row if not re.fullmatch(NAME, name)]:
        raise ReportError(
            f"the column {wrong[0]!r} is not called in small letters, digits and _, as rebound_mm"
        )
    lost = [
        name
        for name, value in row.items()
        if is_number(value) and columns.number_problem(name, value)
    ]
    lost += [
        name
        for name in row
        if row[name] is None and name + REASON not in row and columns[name].unit != "1"
    ]
    return {**row, **dict.fromkeys(lost)} | {
        f"{name}_reason": f"{UNBELIEVED}{row[name]!s:.40}" for name in lost
    }
