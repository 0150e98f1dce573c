"""Measure sections and write their records.

Usage: ``python -m measured_report.measuring.run SECTION [SECTION …]``. One loop
measures all sections with two pools of processes. Each section goes from its first
batch to its record.
"""

import argparse
import gc
import importlib
import inspect
import os
import pickle
import re
import signal
import sys
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from types import ModuleType
from typing import Any

from tqdm import tqdm

from measured_report.editions.project import Project, own_release
from measured_report.editions.release import read_label
from measured_report.files.atomic import short_path
from measured_report.files.columns import IMPLAUSIBLE, REASON, Schema, is_number, plain
from measured_report.files.config import FILE, Report
from measured_report.files.config import report as current
from measured_report.files.errors import ReportError, bug_of
from measured_report.files.processes import KILLED
from measured_report.measuring.batch import (
    OPENED,
    STARTED,
    Batch,
    Plan,
    Result,
    measure_batch,
    note_opened,
    reason_of,
    utc_time,
)
from measured_report.measuring.machine import (
    KIND,
    commit,
    machine,
    measuring_device,
    needs_device,
    read_device,
)
from measured_report.measuring.measure import FAILED, UNFIT
from measured_report.measuring.measurement import measurement_of
from measured_report.measuring.pool import environments, gather, host_pools
from measured_report.records.code import Code
from measured_report.records.identity import package_versions, sections
from measured_report.records.record import NAME, Basis, Record, basis_of
from measured_report.records.traces import packed

WHOLE = "whole"  # name of the batch of a section that does not declare batches
SETTINGS = (FILE, "pyproject.toml", "uv.lock")  # files that this package itself reads
GONE = (
    "the connection to the scheduler is lost: start it and measure again (finished "
    "records are kept)"
)


@dataclass
class Section:
    """The progress of a section from its first batch to its record."""

    project: Project
    name: str
    device: str
    plan: Plan
    basis: Basis
    stage: list[Batch] = field(default_factory=list)  # yielded together
    waiting: list[Batch] = field(default_factory=list)  # not submitted yet
    results: dict[str, Result] = field(default_factory=dict)
    killed: set[str] = field(default_factory=set)  # batches whose process was killed
    opened: set[tuple[str, str]] = field(default_factory=set)
    """The files that its module and its plan read in this process, see ``OPENED``."""
    is_over: bool = False
    has_failed: bool = False

    def is_exclusive(self, batch: Batch) -> bool:
        """Return whether a batch must run by itself, because it measures times or may
        have caused a process to be killed.
        """
        return batch.exclusive or batch.name in self.killed

    def advance(self) -> None:
        """Request the next batches after a stage; write the record at the end."""
        try:
            while not self.is_over and all(
                batch.name in self.results for batch in self.stage
            ):
                values = [self.results[batch.name].value for batch in self.stage]
                OPENED.clear()  # the records of other sections read files
                try:
                    stage = self.plan.send(values or None)  # type: ignore[arg-type]
                    self.stage = list(stage)
                except StopIteration as end:
                    self._write(end.value)
                    return
                self.opened |= OPENED
                assert all(isinstance(batch, Batch) for batch in self.stage), (
                    "measure yields something other than a Batch: return rows "
                    "instead of yielding them"
                )
                names = [*self.results, *(batch.name for batch in self.stage)]
                if not self.stage or len({*names}) < len(names):
                    raise ValueError(
                        f"batch names {names} are empty or not unique: give each batch "
                        "another name"
                    )
                self.waiting = self.stage
        except Exception as error:
            # An error in this section must not stop the others.
            self.fail(reason_of(error, self.project.report))

    def retry_alone(self, batch: Batch) -> None:
        """Measure a batch by itself after its process was killed, but only once."""
        if batch.name in self.killed:
            self.fail(
                f"the process of {batch.name} was killed twice, the second time "
                "while it ran by itself: use less memory"
            )
        elif not self.is_over:
            self.killed.add(batch.name)
            self.waiting = [*self.waiting, batch]
            tqdm.write(
                f"the process of {self.name}/{batch.name} was killed; the batch is "
                "measured again by itself",
                file=sys.stderr,
            )

    def fail(self, reason: str) -> None:
        if not self.is_over:
            self.is_over = True
            self.has_failed = True
            self.waiting = []
            tqdm.write(
                f"{self.name} could not be measured (an existing record is kept): "
                f"{reason}",
                file=sys.stderr,
            )

    def _refuse_undeclared(self, results: Sequence[Result]) -> None:
        """Raise ReportError for a file of the report that was read but not declared.

        The record would stay fresh when this file changes.
        """
        files = self.basis.identity.files
        root = self.project.root
        codes = (root / file for file in files if file.endswith(".py"))
        # The names of files of packages are relative to the package.
        texts = [code.read_text(encoding="utf-8") for code in codes if code.exists()]
        opened = self.opened.union(OPENED, *(result.opened for result in results))
        for event, file in sorted(opened):
            path = Path(file)
            # Path.is_file would raise OSError for a long argument of a program.
            is_file = os.path.isfile(file)  # noqa: PTH113
            # Packages read files outside of the report that its code does not name.
            is_named = path.suffix and any(path.name in text for text in texts)
            is_own = is_named or path.is_relative_to(root)
            name = Path(os.path.relpath(file, root)).as_posix()
            # Environments and outputs can be below the root, but are not its sources.
            is_other = re.search(
                r"(^|/)(\.(?!\./)|site-packages/|results/|site/)", name
            )
            # The identity covers imported files already.
            is_module = path.suffix in (".py", ".pyc") and event != STARTED
            is_known = is_module or name in SETTINGS or name in files
            if is_file and is_own and not (is_other or is_known):
                raise ReportError(
                    f"measure reads {name}, but its record would not depend on this "
                    "file: move it to assets/ and write its path in the code, as in "
                    f'"assets/{path.name}"'
                )

    def _write(self, returned: Any) -> None:
        """Write the record and the traces that ``measure`` returned."""
        report = self.project.report
        path = self.project.record_path(self.name)
        results = list(self.results.values())
        try:
            measurement = measurement_of(returned)
            rows = [plausible_row(row, report.columns) for row in measurement.rows]
            traces = {
                case: packed(path, case, table, report.columns)
                for case, table in measurement.traces.items()
            }
        except (AttributeError, TypeError) as error:
            raise ReportError(
                "measure returns neither rows nor a Measurement of rows and traces "
                f"({error}): return one of them"
            ) from None
        if not rows or not all("case" in row for row in rows):
            raise ReportError(
                "measure returns no rows or a row without a case: return rows with the "
                "key case"
            )
        self._refuse_undeclared(results)
        measured_on = {}
        # A section may not be able to measure anything on this device.
        machines = [result.machine for result in results] or [machine(self.device)]
        for name in machines[0]:
            properties = {each[name] for each in machines}
            if name in KIND and len(properties) > 1:
                raise ReportError(
                    "batches were measured on different kinds of machines: use "
                    "machines of one kind"
                )
            measured_on[name] = ", ".join(sorted(filter(None, properties))) or None
        now = utc_time().isoformat(timespec="seconds")
        ended = max((result.ended for result in results), default=now)
        seconds = round(sum(result.seconds for result in results), 1)
        measured: dict[str, Any] = {
            "date": ended,
            "started": min((result.started for result in results), default=now),
            "ended": ended,
            "commit": commit(),
            "command": self.project.rerun(self.name, measured_on["device"]),
            "seconds": seconds,
        }
        units = report.columns.units_of(rows)
        identity = self.basis.identity
        record = Record(
            section=self.name,
            identity=identity,
            machine=measured_on,
            measured=measured,
            units=units,
            rows=rows,
            deprecated=tuple(
                sorted(set().union(*(result.deprecated for result in results)))
            ),
        )
        self.basis.write(record, traces)
        self.is_over = True
        file = path.relative_to(self.project.root)
        tqdm.write(f"{self.name}: {len(rows)} rows in {seconds:.0f} s → {file}")


class Loop:
    """Measure sections with a pool for shared batches and one for exclusive batches."""

    def __init__(self, sections: Sequence[Section], shared: Any, exclusive: Any):
        self.sections = sections
        self.pools = {False: shared, True: exclusive}
        self.running: dict[Future[Any], tuple[Section, Batch]] = {}

    def run(self) -> bool:
        """Measure all sections and return whether any of them failed."""
        for section in self.sections:
            section.advance()
        with tqdm(unit="batch", leave=False, disable=not sys.stderr.isatty()) as bar:
            while self._submit():
                for future in wait(self.running, return_when=FIRST_COMPLETED).done:
                    self._take(future, *self.running.pop(future))
                    bar.update()
        return any(section.has_failed for section in self.sections)

    def _submit(self) -> bool:
        """Submit all batches that can start; return whether any batch is running."""
        for is_exclusive, pool in self.pools.items():
            for section in self.sections:
                for batch in list(section.waiting):
                    is_of_pool = section.is_exclusive(batch) == is_exclusive
                    if is_of_pool and self._has_room(pool, is_exclusive):
                        section.waiting = [
                            waiting
                            for waiting in section.waiting
                            if waiting is not batch
                        ]
                        self._start(pool, section, batch)
        return bool(self.running)

    def _has_room(self, pool: Any, is_exclusive: bool) -> bool:
        return len(self.running) < pool.limit and all(
            section.is_exclusive(batch) == is_exclusive
            for section, batch in self.running.values()
        )

    def _start(self, pool: Any, section: Section, batch: Batch) -> None:
        try:
            content = pickle.dumps(batch)
        except Exception as error:
            section.fail(f"{batch.name}: {reason_of(error, section.project.report)}")
            return
        future = pool.submit(measure_batch, content, section.device)
        self.running[future] = section, batch

    def _take(self, future: Future[Any], section: Section, batch: Batch) -> None:
        pool = self.pools[section.is_exclusive(batch)]
        try:
            result = future.result()
            value = pickle.loads(result.value)
        except pool.killed:
            section.retry_alone(batch)
        except CancelledError:
            raise ReportError(GONE) from None
        except Exception as error:
            reason = reason_of(error, section.project.report)
            section.fail(reason if batch.name == WHOLE else f"{batch.name}: {reason}")
        else:
            section.results[batch.name] = replace(result, value=value)
            section.advance()


def section_of(project: Project, basis: Basis, device: str) -> Section:
    """Return the section that a module measures, as one batch if it declares none."""
    name = basis.section
    OPENED.clear()  # the modules of other sections read files, too
    module = section_module(name)
    device = device if needs_device(name, project) else "cpu"
    # A process sees only one device of its kind, so that its number is 0.
    alias = "cpu" if device == "cpu" else f"{device}:0"
    is_quick = project.profile == "quick"
    conditions = project.report.host.Conditions(device=alias, quick=is_quick)
    if inspect.isgeneratorfunction(module.measure):
        plan = module.measure(conditions)
    else:
        plan = _as_one(Batch(WHOLE, module.measure, (conditions,)))
    return Section(
        project=project,
        name=name,
        device=device,
        plan=plan,
        basis=basis,
        opened=set(OPENED),
    )


def _as_one(batch: Batch) -> Plan:
    [measurement] = yield [batch]
    return measurement


def plausible_row(row: Mapping[str, object], columns: Schema) -> dict[str, object]:
    """Return a row with plain Python numbers.

    A number outside the range of its column becomes None, and the column with the
    ending ``_reason`` contains the reason.
    """
    cells = {str(name): plain(value, str(name)) for name, value in row.items()}
    implausible = {}
    for name, cell in cells.items():
        if not re.fullmatch(NAME, name):
            raise ReportError(
                f"column {name!r} has an invalid name: use lower-case letters, "
                "digits and _, as in rebound_mm"
            )
        is_invalid = is_number(cell) and columns.number_problem(name, cell)
        is_absent = cell is None and columns[name].unit != "1"
        if is_invalid or (is_absent and name + REASON not in cells):
            implausible[name] = f"{IMPLAUSIBLE}{cell!s:.40}"
    reasons = {name + REASON: reason for name, reason in implausible.items()}
    return {**cells, **dict.fromkeys(implausible), **reasons}


def main() -> int:
    # Records replace older ones in one step, so Ctrl-C leaves nothing to clean up.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    tqdm.monitor_interval = 0  # a process with threads must not be forked
    parser = argparse.ArgumentParser(prog="python -m measured_report.measuring.run")
    parser.add_argument("section", nargs="+")
    parser.add_argument("--device", default="")
    parser.add_argument("--profile", choices=("full", "quick"), default="full")
    parser.add_argument("--edition", help="label of the results")
    parser.add_argument("--aside", default="", help="folder below results/")
    parser.add_argument("--cluster", help="address of a Dask scheduler")
    arguments = parser.parse_args()
    report = current()
    status = UNFIT
    try:
        release = edition_of(arguments.edition, report)
        own = own_release(report=report)
        project = Project(
            release,
            profile=arguments.profile,
            root=report.root,
            own_release=own,
            aside=arguments.aside,
        )
        device = arguments.device or measuring_device(None, "quick") or "cpu"
        requested = requested_sections(project, arguments.section, device)
        with pools(report, arguments.cluster, requested) as (shared, exclusive):
            status = FAILED
            return int(Loop(requested, shared, exclusive).run())
    except ReportError as error:
        print(error, file=sys.stderr)
        return status


def requested_sections(
    project: Project, names: Sequence[str], device: str
) -> Sequence[Section]:
    """Return the sections with these names.

    Raise ReportError if they cannot be measured here.
    """
    code = Code(project.root)
    for name in names:
        if not name.isidentifier() or not code.module(f"experiments.{name}"):
            raise ReportError(
                f"SECTION={name} is not a section: use one of {', '.join(sections())}"
            )
    # Start with the batches that need only the CPU, because they are few and long.
    ordered = sorted(names, key=partial(needs_device, project=project))
    # Compute the identities before the import of any module of the report.
    bases = [
        basis_of(name, project.record_path(name), project.profile, project.root)
        for name in ordered
    ]
    device = read_device(device)
    note_opened()
    gc.disable()  # garbage collection doubles the time to load a simulator
    project.report.host.be_quiet()
    requested = [section_of(project, basis, device) for basis in bases]
    gc.freeze()
    gc.enable()
    return requested


@contextmanager
def pools(
    report: Report, cluster: str | None, requested: Sequence[Section]
) -> Iterator[Any]:
    """Open the pools that measure, on this host or on the workers of a cluster."""
    devices = sorted({section.device for section in requested})
    if cluster:
        from measured_report.measuring.cluster import cluster_pools

        with cluster_pools(cluster) as opened:
            yield opened
        return
    exclusive: Mapping[str, str] = {}
    shared = environments(devices[-1], requested[0].project.profile, report)
    if devices[-1] == "cpu":
        machine("cpu")  # once here, so that all forks inherit it
    else:
        exclusive = {**shared[0], **report.accelerator.ALONE}
    with host_pools(shared, exclusive) as opened:
        prepare = report.host.prepare
        try:
            calls = [opened[0].submit(prepare, device) for device in devices]
            gather(calls, "kernels")
        except BrokenProcessPool:
            raise ReportError(KILLED) from None
        yield opened


def section_module(section: str) -> ModuleType:
    """Return the module that measures a section.

    Raise ReportError if it cannot be imported.
    """
    try:
        module = importlib.import_module(f"experiments.{section}")
    except (Exception, SystemExit) as error:
        raise ReportError(bug_of(error)) from error
    if hasattr(module, "measure"):
        return module
    raise ReportError(
        f"{short_path(Path(str(module.__file__)))} has no function "
        "measure(conditions): define one"
    )


def edition_of(requested: str | None, report: Report | None = None) -> str:
    """Return the label of the installed edition.

    Raise ReportError if another edition was requested.
    """
    settings = (report or current()).settings
    installed = package_versions(settings)
    spec = requested or installed[settings.edition]
    label = read_label(spec, settings)
    if label is None or not label.is_installed_with(installed):
        packages = ", ".join(f"{name} {version}" for name, version in installed.items())
        raise ReportError(
            f"{settings.option}={spec} is not installed here ({packages}): measure it "
            "with make report or make upgrade"
        )
    return str(label)


if __name__ == "__main__":
    sys.exit(main())
