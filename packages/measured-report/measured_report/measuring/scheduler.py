"""A study: sections measured batch by batch by a crew, kept on disk as they come, and put together as records."""

import sys
import time
import traceback
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

from tqdm import tqdm

from measured_report.measuring.batch import Batch
from measured_report.measuring.course import WHOLE, Course, Task
from measured_report.measuring.failing import is_expected, reason_of
from measured_report.measuring.machine import kind_of
from measured_report.measuring.outcome import Done, Failed, Lost, run_batch

TRY_COUNT = 3
"""How often a batch is begun whose process is killed."""
PATIENCE_S = 120.0
"""How long nothing may run, for want of a host that may run what is left."""


@dataclass(frozen=True)
class Host:
    """Where batches run, all of it of one kind of machine."""

    name: str
    kind: tuple
    slots: Sequence[str]
    """One batch at once in each."""
    shared: Sequence[str] = ()
    """Slots that share its GPUs: where there are any, the others are left to what must be alone."""

    def slots_for(self, batch: Batch) -> Sequence[str]:
        return self.slots if batch.alone else self.shared or self.slots


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
    in_turn = sum(len(host.shared or host.slots) for host in hosts) == 1
    for host in hosts:
        beside = [task for (name, _), task in busy.items() if name == host.name]
        fit = [task for task, kind in ready if kind in (None, host.kind)]
        if any(task.batch.alone for task in beside):
            continue
        shared = fit if in_turn else [task for task in fit if not task.batch.alone]
        if candidates := shared or ([] if beside else fit):
            task = candidates[0] if in_turn else max(candidates, key=lambda task: task.seconds)
            if free := [slot for slot in host.slots_for(task.batch) if (host.name, slot) not in busy]:
                return task, host, (host.name, free[0])
    return None


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
