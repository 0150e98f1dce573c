"""The scheduler: gives the batches of sections to an executor, and brings each section to its record."""

import sys
import time
from collections.abc import Callable, Mapping, Sequence

from tqdm import tqdm

from measured_report.measuring.executors import WHOLE, Executor, Host, Task
from measured_report.measuring.outcome import BatchOutcome, Done, Failed, failed
from measured_report.measuring.section_run import SectionRun

TRY_COUNT = 3
"""How often a batch is begun whose process is killed."""
PATIENCE_S = 120.0
"""How long nothing may run, for want of a host that may run what is left."""


def next_start(
    ready: Sequence[tuple[Task, tuple | None]], hosts: Sequence[Host], busy: Mapping[tuple[str, str], Task]
) -> tuple[Task, Host, tuple[str, str]] | None:
    """Choose which of the tasks, each with the kind of machine that its section is bound to, to start next, and where.

    Where more than one batch runs at a time the longest goes first, to the host that has least to do, and those that
    must be alone there go when nothing else is left to run. None when nothing can be started beside what is ``busy``.
    """
    in_turn = sum(len({*host.processes, *host.alone}) for host in hosts) == 1
    for host in sorted(hosts, key=lambda host: len(host.those_of(busy))):
        beside = host.those_of(busy)
        fit = [task for task, kind in ready if kind in (None, host.kind)]
        shared = fit if in_turn else [task for task in fit if not task.batch.exclusive]
        timed = fit if not beside else []
        candidates = [] if shared and any(task.batch.exclusive for task in beside) else shared or timed
        if candidates:
            task = candidates[0] if in_turn else max(candidates, key=lambda task: task.seconds)
            names = host.alone if task.batch.exclusive else host.processes
            if free := [(host.name, name) for name in names if (host.name, name) not in busy]:
                return task, host, free[0]
    return None


class Scheduler:
    """All sections that are to be measured, and what becomes of them."""

    def __init__(self, runs: Sequence[SectionRun], executor: Executor):
        self.runs = {run.section: run for run in runs}
        self.executor = executor
        self.busy: dict[tuple[str, str], Task] = {}
        self.since: dict[tuple[str, str], float] = {}

    def run(self) -> bool:
        """Measure all; whether any section failed. On Ctrl-C what runs is dropped, and what is finished is kept."""
        for run in self.runs.values():
            self._go_on(run)
        idle_since = time.monotonic()
        while not all(run.is_over for run in self.runs.values()):
            self._start()
            if self.busy:
                idle_since = time.monotonic()
            for task, outcome in self.executor.wait():
                self._take(task, outcome)
                self._start()
            if time.monotonic() - idle_since > PATIENCE_S:
                for run in self.runs.values():
                    run.fail(Failed(f"no host is left that may measure it, for {PATIENCE_S:.0f} s"))
        return any(run.failure for run in self.runs.values())

    def _go_on(self, run: SectionRun, step: Callable = lambda: None) -> None:
        """Take a step of a section and ask for its next batches; its fault must not cost the others."""
        try:
            step()
            run.go_on({host.kind for host in self.executor.hosts})
        except Exception as error:
            run.fail(failed(error))

    def _start(self) -> None:
        """Start all that can be."""
        runs, hosts = self.runs.values(), self.executor.hosts
        while found := next_start([(task, run.kind) for run in runs for task in run.tasks()], hosts, self.busy):
            task, host, process = found
            run = self.runs[task.section]
            run.kind = run.kind or host.kind
            run.waiting.remove(task.batch)
            if not run.tries:
                begun = sum(bool(each.tries) for each in runs)
                tqdm.write(f"[{begun + 1}/{len(self.runs)}] {task.section}")
            run.tries[task.batch.name] += 1
            self.busy[process], self.since[process] = task, time.monotonic()
            self.executor.start(task, process)

    def _take(self, task: Task, outcome: BatchOutcome) -> None:
        run, batch = self.runs[task.section], task.batch
        self.busy = {process: other for process, other in self.busy.items() if other is not task}
        name = "" if batch.name == WHOLE else f"{batch.name}: "
        if isinstance(outcome, Done):
            self._go_on(run, lambda: run.take(batch, outcome))
        elif isinstance(outcome, Failed):
            run.fail(Failed(name + outcome.reason, outcome.trace))
        elif run.tries[batch.name] >= TRY_COUNT:
            run.fail(Failed(f"{name}{outcome.reason}, {TRY_COUNT} times"))
        elif not run.is_over:
            tqdm.write(f"{task.name}: {outcome.reason}; it is tried again", file=sys.stderr)
            run.waiting.append(batch)

    def status(self) -> str:
        """Say how far it is: batches done, what runs where, and for how long it will."""
        runs, left = self.runs.values(), self.seconds_left()
        done = sum(len(run.done) for run in runs)
        count = sum(len({*run.done, *(batch.name for batch in run.stage)}) for run in runs)
        running = [f"{task.name} on {host}" if host else task.name for (host, _), task in list(self.busy.items())]
        said = f"{done} of {count} batches; {', '.join(running) or 'nothing'} running"
        if left is None:
            return said
        return f"{said}; about {f'{left / 60:.0f} min' if left > 90 else f'{left:.0f} s'} left"

    def seconds_left(self) -> float | None:
        """Estimate it from what the sections took the last time; None when that is not known of one."""
        runs = [run for run in self.runs.values() if not run.is_over]
        count = sum(len(host.processes) for host in self.executor.hosts)
        if not count or any(run.section not in run.known for run in runs):
            return None
        found, now = 0.0, time.monotonic()
        for run in runs:
            spent = sum(done.seconds for done in list(run.done.values()))
            running = [process for process, task in list(self.busy.items()) if task.section == run.section]
            spent += sum(now - self.since[process] for process in running)
            found += max(0.0, run.known[run.section] - spent)
        return found / count
