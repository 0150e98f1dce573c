"""Section runs: the way of a section from its first batch to its record."""

import inspect
import pickle
import re
import sys
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from types import ModuleType

from tqdm import tqdm

from measured_report.editions.devices import needs_gpu
from measured_report.editions.project import Project
from measured_report.files.cache import Cache
from measured_report.measuring.batch import Batch, Plan
from measured_report.measuring.executors import WHOLE, Task
from measured_report.measuring.host import host
from measured_report.measuring.machine import commit, kind_of
from measured_report.measuring.measurement import Measurement
from measured_report.measuring.outcome import Done, Failed, now
from measured_report.records.columns import UNBELIEVED, is_number, number_problem, units_of
from measured_report.records.identity import Identity, identity_of
from measured_report.records.record import Record, write_record
from measured_report.records.traces import packed

NAME = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*")


@dataclass
class SectionRun:
    """A section on its way to a record."""

    project: Project
    section: str
    device: str
    """``cuda`` or ``cpu``: what it measures on, whatever else the hosts have."""
    plan: Plan
    identity: Identity
    known: Mapping[str, float]
    """Seconds that it took the last time, by section and by ``section/batch``."""
    stage: list[Batch] = field(default_factory=list)
    """What was yielded last."""
    waiting: list[Batch] = field(default_factory=list)
    """What of it is neither done nor running."""
    done: dict[str, Done] = field(default_factory=dict)
    alone: set[str] = field(default_factory=set)
    tries: Counter = field(default_factory=Counter)
    kind: tuple | None = None
    """The kind of machine that its first batch is measured on, and so all others."""
    is_over: bool = False
    failure: str = ""

    def tasks(self) -> list[Task]:
        """List what can be started; a batch that is new takes no longer than its section did."""
        known = self.known.get(self.section, 0.0)
        tasks = (Task(self.section, batch) for batch in self.waiting)
        return [Task(self.section, task.batch, self.known.get(task.name, known)) for task in tasks]

    def take(self, batch: Batch, done: Done) -> None:
        """Keep what a batch has returned."""
        self.done[batch.name] = done
        if batch.name != WHOLE:
            Cache(self.project.root).put(self._kept_start + batch.name, self.identity, done)

    def go_on(self, kinds: set[tuple]) -> None:
        """Ask for the next batches as long as all that were asked for are done, and write the record at the end.

        Those that were measured before, on one of these ``kinds`` of machine, are found again.
        """
        while not self.is_over and all(batch.name in self.done for batch in self.stage):
            results = [pickle.loads(self.done[batch.name].content) for batch in self.stage]
            try:
                stage = self.plan.send(results or None)
            except StopIteration as end:
                self._write(end.value)
                return
            self.stage = list(stage)
            names = [batch.name for batch in self.stage]
            if not all(map(NAME.fullmatch, names)) or len({*names, *self.done}) < max(1, len(names)) + len(self.done):
                fault = "batches need names of their own, lower-case words joined by hyphens"
                raise ValueError(f"{fault}: {', '.join(names)}")
            self.alone |= {batch.name for batch in self.stage if batch.exclusive}
            for batch in self.stage:
                kept = Cache(self.project.root).get(self._kept_start + batch.name, self.identity)
                if kept and kind_of(kept.machine) in ({self.kind} if self.kind else kinds):
                    self.kind = kind_of(kept.machine)
                    self.done[batch.name] = kept
            self.waiting = [batch for batch in self.stage if batch.name not in self.done]

    @property
    def _kept_start(self) -> str:
        """How the names begin under which its batches are kept."""
        return f"batch.{self.project.profile}.{self.project.release}.{self.section}."

    def _write(self, measurement: Measurement) -> None:
        """Write the record; the batches that it is made of need not be kept any longer."""
        parts = list(self.done.values())
        on_cpu = {"device": "cpu", "gpu": None, "driver": None, "gpu_uuid": None} if self.device == "cpu" else {}
        machines = [{**part.machine, **on_cpu} for part in parts]
        names = dict.fromkeys(name for machine in machines for name in machine)
        seconds = round(sum(part.seconds for part in parts), 1)
        batches = sorted(self.done.keys() - {WHOLE})
        times = {f"batch_{name}_s": self.done[name].seconds for name in batches if name not in self.alone}
        times |= {f"alone_{name}_s": self.done[name].alone_s for name in batches if name in self.alone}
        prepared = sum(self.done[name].seconds - self.done[name].alone_s for name in self.alone)
        times |= {"prepared_s": round(prepared, 1)} if prepared > 0.05 else {}
        record = Record(
            section=self.section,
            identity=self.identity,
            machine={name: _together(machine.get(name) for machine in machines) for name in names},
            measured={
                "date": now(),
                "started": min(part.started for part in parts),
                "ended": max(part.ended for part in parts),
                "commit": commit(),
                "command": self.project.rerun(self.section, machines[0]["device"]),
                "seconds": seconds,
                **times,
            },
            units=units_of(measurement.rows),
            rows=[believable(row) for row in measurement.rows],
        )
        path = self.project.record_path(self.section)
        write_record(path, record, {case: packed(path, case, table) for case, table in measurement.traces.items()})
        self.is_over = True
        Cache(self.project.root).remove(self._kept_start)
        tqdm.write(f"{self.section}: {len(record.rows)} rows in {seconds:.0f} s → {path}")

    def fail(self, failed: Failed) -> None:
        """Give the section up, and say why."""
        if not self.is_over:
            self.is_over, self.failure, self.waiting = True, failed.reason, []
            said = f"{self.section}: measuring failed; what was there is kept: {failed.reason}"
            tqdm.write(failed.trace + said, file=sys.stderr)


def section_run(
    project: Project, section: str, module: ModuleType, device: str, known: Mapping[str, float]
) -> SectionRun:
    """Return the run of a section: of one that declares no batches, all of it as one."""
    device = device if needs_gpu(section, project.root) else "cpu"
    identity = identity_of(section, project.profile, project.root)
    alias = "cuda:0" if device == "cuda" else "cpu"  # of the only device of its kind that a process measures on
    conditions = host().Conditions(device=alias, quick=project.profile == "quick")
    plans = inspect.isgeneratorfunction(module.measure)
    plan = module.measure(conditions) if plans else _as_one(Batch(WHOLE, module.measure, (conditions,)))
    return SectionRun(project, section, device, plan, identity, known)


def _as_one(batch: Batch) -> Plan:
    [measurement] = yield [batch]
    return measurement


def _together(values: Iterable[str | None]) -> str | None:
    """Join what several machines say: what they agree on, or each of what they say."""
    found = sorted({*values} - {None}, key=str) or [None]
    said = ", ".join(map(str, found))
    return found[0] if len(found) == 1 else said if len(said) <= 400 else f"{len(found)} different ones"


def believable(row: Mapping[str, object]) -> dict[str, object]:
    """The row with None, and the reason, for each number that no record may hold: one must not cost the others."""
    lost = [name for name, value in row.items() if is_number(value) and number_problem(name, value)]
    return {**row, **dict.fromkeys(lost)} | {f"{name}_reason": f"{UNBELIEVED}{row[name]}" for name in lost}
