"""A study: sections measured batch by batch by a crew, kept on disk as they come, and put together as records."""

import inspect
import pickle
import re
import sys
import time
import traceback
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime, timezone
from types import ModuleType
from typing import TYPE_CHECKING, Any, Protocol

from tqdm import tqdm

from experiments.batch import Batch, Plan
from experiments.failing import is_expected, reason_of
from experiments.machine import alias_of, commit, kind_of
from report.records.cache import Cache
from report.records.columns import UNBELIEVED, is_number, number_problem, units_of
from report.records.identity import Identity, identity_of
from report.records.project import Project
from report.records.record import Record, write_record
from report.records.traces import packed

if TYPE_CHECKING:
    from experiments.measurement import Measurement

NAME = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*")
WHOLE = "whole"
"""The one batch of a section that has declared none."""
CLOCK = "experiments/timing.py"
"""What reads this measures times: where it is one batch, it is alone on its host."""
TRY_COUNT = 3
"""How often a batch is begun whose process is killed."""
PATIENCE_S = 120.0
"""How long nothing may run, for want of a host that may run what is left."""


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


@dataclass(frozen=True)
class Host:
    """Where batches run: as many at once as it has slots, all of them of one kind of machine."""

    name: str
    kind: tuple
    slots: Sequence[str]


@dataclass(frozen=True)
class Task:
    """A batch of a section."""

    section: str
    batch: Batch
    seconds: float
    """How long it is expected to take; 0 where nobody knows."""

    @property
    def name(self) -> str:
        return self.section if self.batch.name == WHOLE else f"{self.section}/{self.batch.name}"


Place = tuple[str, str]
"""The name of a host, and a slot of it."""


class Crew(Protocol):
    """Whoever measures."""

    @property
    def hosts(self) -> Sequence[Host]:
        """The hosts that are there now."""

    def start(self, task: Task, place: Place) -> None: ...

    def wait(self) -> Iterable[tuple[Task, Done | Lost | Failed]]:
        """What has ended since it was last asked, after a while if nothing has."""


def run_batch(function: Callable, arguments: tuple, machine: Mapping[str, Any]) -> Done | Failed:
    """Measure a batch in this process."""
    started, start = now(), time.perf_counter()
    try:
        content = pickle.dumps(function(*arguments), protocol=pickle.HIGHEST_PROTOCOL)
    except Exception as error:  # one batch's fault must not cost the others
        return Failed(reason_of(error), "" if is_expected(error) else traceback.format_exc())
    return Done(content, machine, started, now(), round(time.perf_counter() - start, 1))


class Here:
    """This process alone, in which one batch is measured after the other."""

    def __init__(self, machine: Mapping[str, Any]):
        self.machine = machine
        self.hosts = [Host("", kind_of(machine), [""])]
        self._started: list[Task] = []

    def start(self, task: Task, place: Place) -> None:
        self._started.append(task)

    def wait(self) -> Iterable[tuple[Task, Done | Failed]]:
        while self._started:
            task = self._started.pop()
            yield task, run_batch(task.batch.function, task.batch.arguments, self.machine)


def next_start(
    ready: Sequence[tuple[Task, tuple | None]], hosts: Sequence[Host], busy: Mapping[Place, Task]
) -> tuple[Task, Host, Place] | None:
    """What is to be started next, and where; None when nothing can be.

    Where more than one batch runs at a time the longest goes first, and what must be alone on its host goes when
    nothing else is left to run there.

    Args:
        ready: Tasks, each with the kind of machine that its section is bound to, if it is.
        busy: What runs, by its place.
    """
    in_turn = sum(len(host.slots) for host in hosts) == 1
    for host in hosts:
        beside = [task for (name, _), task in busy.items() if name == host.name]
        free = [slot for slot in host.slots if (host.name, slot) not in busy]
        fit = [task for task, kind in ready if kind in (None, host.kind)]
        if not fit or not free or any(task.batch.alone for task in beside):
            continue
        shared = fit if in_turn else [task for task in fit if not task.batch.alone]
        if candidates := shared or ([] if beside else fit):
            task = candidates[0] if in_turn else max(candidates, key=lambda task: task.seconds)
            return task, host, (host.name, free[0])
    return None


@dataclass
class Course:
    """A section on its way to a record."""

    project: Project
    section: str
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
        """What can be started."""
        return [Task(self.section, batch, self.known.get(self._key(batch), 0.0)) for batch in self.waiting]

    def _key(self, batch: Batch) -> str:
        return self.section if batch.name == WHOLE else f"{self.section}/{batch.name}"

    @property
    def batch_count(self) -> int:
        return len({*self.done, *(batch.name for batch in self.stage)})

    def begin(self, kinds: set[tuple]) -> None:
        """Ask for the first batches. Those that were measured before, on one of the ``kinds``, are found again."""
        self._advance(None, kinds)
        self._go_on(kinds)

    def take(self, batch: Batch, done: Done, kinds: set[tuple]) -> None:
        """Keep what a batch has returned, and go on when it was the last that the section waits for."""
        self.done[batch.name] = done
        if batch.name != WHOLE:
            Cache(self.project.root).put(self._kept_as(batch), self.identity, done)
        self._go_on(kinds)

    def _go_on(self, kinds: set[tuple]) -> None:
        while not self.is_over and all(batch.name in self.done for batch in self.stage):
            self._advance([pickle.loads(self.done[batch.name].content) for batch in self.stage], kinds)

    def _advance(self, results: list | None, kinds: set[tuple]) -> None:
        try:
            self.stage = list(self.plan.send(results))
        except StopIteration as end:
            self._write(end.value)
            return
        names = [batch.name for batch in self.stage]
        if not names or not all(map(NAME.fullmatch, names)) or len({*names, *self.done}) < len(names) + len(self.done):
            raise ValueError(f"batches need names of their own, lower-case words joined by hyphens: {', '.join(names)}")
        self.alone |= {batch.name for batch in self.stage if batch.alone}
        for batch in self.stage:
            kept = Cache(self.project.root).get(self._kept_as(batch), self.identity)
            if kept and kind_of(kept.machine) in ({self.kind} if self.kind else kinds):
                self.kind = kind_of(kept.machine)
                self.done[batch.name] = kept
        self.waiting = [batch for batch in self.stage if batch.name not in self.done]

    def _kept_as(self, batch: Batch) -> str:
        return f"{self._kept_start()}{batch.name}"

    def _kept_start(self) -> str:
        return f"batch.{self.project.profile}.{self.project.release}.{self.section}."

    def _write(self, measurement: "Measurement") -> None:
        """Write the record; the batches that it is made of need not be kept any longer."""
        parts = list(self.done.values())
        machines = [part.machine for part in parts]
        seconds = round(sum(part.seconds for part in parts), 1)
        each = {
            f"{'alone' if name in self.alone else 'batch'}_{name}_s": self.done[name].seconds
            for name in sorted(self.done)
            if name != WHOLE or self.alone
        }
        record = Record(
            section=self.section,
            identity=self.identity,
            machine={name: _together(machine[name] for machine in machines) for name in machines[0]},
            measured={
                "date": now(),
                "started": min(part.started for part in parts),
                "ended": max(part.ended for part in parts),
                "commit": commit(),
                "command": self.project.rerun(self.section, machines[0]["device"]),
                "seconds": seconds,
                **each,
            },
            units=units_of(measurement.rows),
            rows=[believable(row) for row in measurement.rows],
        )
        path = self.project.record_path(self.section)
        write_record(path, record, {case: packed(path, case, table) for case, table in measurement.traces.items()})
        self.is_over = True
        Cache(self.project.root).remove(self._kept_start())
        tqdm.write(f"{self.section}: {len(record.rows)} rows in {seconds:.0f} s → {path}")

    def fail(self, reason: str, trace: str = "") -> None:
        if not self.is_over:
            self.is_over, self.failure, self.waiting = True, reason, []
            tqdm.write(f"{trace}{self.section}: measuring failed; what was there is kept: {reason}", file=sys.stderr)


def course_of(project: Project, section: str, module: ModuleType, device: str, known: Mapping[str, float]) -> Course:
    """The way of a section: of one that declares no batches, all of it as one."""
    from experiments.measurement import Conditions

    identity = identity_of(section, project.profile, project.root)
    conditions = Conditions(device=alias_of(device), quick=project.profile == "quick")
    if inspect.isgeneratorfunction(module.measure):
        plan = module.measure(conditions)
    else:
        plan = _as_one(Batch(WHOLE, module.measure, (conditions,), alone=CLOCK in identity.files))
    return Course(project, section, plan, identity, known)


def _as_one(batch: Batch) -> Plan:
    [measurement] = yield [batch]
    return measurement


class Study:
    """All sections that are to be measured, and what becomes of them."""

    def __init__(self, courses: Sequence[Course], crew: Crew):
        self.courses = {course.section: course for course in courses}
        self.crew = crew
        self.busy: dict[Place, Task] = {}
        self.since: dict[Place, float] = {}
        self._announced: list[str] = []

    def run(self) -> bool:
        """Measure all; whether any section failed. On Ctrl-C what runs is dropped, and what is finished is kept."""
        for course in self.courses.values():
            self._try(course, course.begin, self.kinds)
        idle_since = time.monotonic()
        while not all(course.is_over for course in self.courses.values()):
            self._start()
            if self.busy:
                idle_since = time.monotonic()
            for task, outcome in self.crew.wait():
                self._take(task, outcome)
                self._start()
            if time.monotonic() - idle_since > PATIENCE_S:
                self._give_up()
        return any(course.failure for course in self.courses.values())

    @property
    def kinds(self) -> set[tuple]:
        return {host.kind for host in self.crew.hosts}

    def _start(self) -> None:
        while found := next_start(self._ready(), self.crew.hosts, self.busy):
            task, host, place = found
            course = self.courses[task.section]
            course.kind = course.kind or host.kind
            course.waiting.remove(task.batch)
            course.tries[task.batch.name] += 1
            if task.section not in self._announced:
                self._announced.append(task.section)
                tqdm.write(f"[{len(self._announced)}/{len(self.courses)}] {task.section}")
            self.busy[place], self.since[place] = task, time.monotonic()
            self.crew.start(task, place)

    def _ready(self) -> list[tuple[Task, tuple | None]]:
        return [(task, course.kind) for course in self.courses.values() for task in course.tasks()]

    def _take(self, task: Task, outcome: Done | Lost | Failed) -> None:
        course = self.courses[task.section]
        self.busy = {place: other for place, other in self.busy.items() if other is not task}
        if isinstance(outcome, Failed):
            course.fail(_named(task, outcome.reason), outcome.trace)
        elif isinstance(outcome, Done):
            self._try(course, course.take, task.batch, outcome, self.kinds)
        elif course.tries[task.batch.name] >= TRY_COUNT:
            course.fail(_named(task, f"{outcome.reason}, {TRY_COUNT} times"))
        elif not course.is_over:
            tqdm.write(f"{task.name}: {outcome.reason}; it is tried again", file=sys.stderr)
            course.waiting.append(task.batch)

    def _try(self, course: Course, step: Callable, *arguments) -> None:
        """A step of a section, whose fault must not cost the others."""
        try:
            step(*arguments)
        except Exception as error:
            course.fail(reason_of(error), "" if is_expected(error) else traceback.format_exc())

    def _give_up(self) -> None:
        for course in self.courses.values():
            course.fail(f"no host is left that may measure it, for {PATIENCE_S:.0f} s")

    def status(self) -> str:
        """How far it is: batches done, what runs where, and for how long it will."""
        courses = self.courses.values()
        done, count = sum(len(course.done) for course in courses), sum(course.batch_count for course in courses)
        running = [f"{task.name} on {host}" if host else task.name for (host, _), task in list(self.busy.items())]
        left = self.seconds_left()
        said = f"{done} of {count} batches; {', '.join(running) or 'nothing'} running"
        return said if left is None else f"{said}; about {_minutes(left)} left"

    def seconds_left(self) -> float | None:
        """From what the sections took the last time; None when that is not known of one."""
        found, slots = 0.0, sum(len(host.slots) for host in self.crew.hosts)
        for course in self.courses.values():
            if not course.is_over:
                if course.section not in course.known:
                    return None
                spent = sum(done.seconds for done in list(course.done.values()))
                running = [place for place, task in list(self.busy.items()) if task.section == course.section]
                spent += sum(time.monotonic() - self.since[place] for place in running)
                found += max(0.0, course.known[course.section] - spent)
        return found / slots if slots else None


def _named(task: Task, reason: str) -> str:
    return reason if task.batch.name == WHOLE else f"{task.batch.name}: {reason}"


def _minutes(seconds: float) -> str:
    return f"{seconds / 60:.0f} min" if seconds > 90 else f"{seconds:.0f} s"


def _together(values: Iterable[str | None]) -> str | None:
    """What several machines say: what they agree on, or each of what they say."""
    found = sorted({*values}, key=str)
    said = ", ".join(map(str, found))
    return found[0] if len(found) == 1 else said if len(said) <= 400 else f"{len(found)} different ones"


def now() -> str:
    return datetime.now(timezone.utc).isoformat(timespec="seconds")


def believable(row: dict[str, object]) -> dict[str, object]:
    """The row with None, and the reason, for each number that no record may hold: one must not cost the others."""
    lost = [name for name, value in row.items() if is_number(value) and number_problem(name, value)]
    return row | dict.fromkeys(lost) | {f"{name}_reason": f"{UNBELIEVED}{row[name]}" for name in lost}
