"""How long a study would take with more GPUs, worked out on paper from how long each batch took the last time:
``python -m measured_report.measuring.on_paper 1 2 8 64``.

Batches are given out as a study gives them out, and each is taken to last as long as it did, wherever it runs. What is
left out is what no record says: how long workers take to start and to load their kernels, and that a batch may wait for
others of its section.
"""

import argparse
import heapq
import sys
from collections.abc import Sequence

from measured_report.editions.project import Project, own_release
from measured_report.editions.status import records_of
from measured_report.measuring.batch import Batch
from measured_report.measuring.course import WHOLE, Task
from measured_report.measuring.measure import BATCH
from measured_report.measuring.scheduler import Host, Place, next_start
from measured_report.records.record import Record

GPUS_PER_HOST = 8


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="python -m measured_report.measuring.on_paper", description=__doc__.split(":")[0]
    )
    parser.add_argument("gpus", nargs="+", type=int, metavar="GPUS", help="how many, eight of them on a host")
    parser.add_argument("--edition", metavar="LABEL", help="whose records; default: the project's own")
    parser.add_argument("--profile", choices=("full", "quick"), default="full")
    arguments = parser.parse_args()
    if min(arguments.gpus) < 1:
        parser.error("GPUS are one or more")
    project = Project(arguments.edition or own_release(), arguments.profile)
    tasks = [task for record in records_of(project) for task in tasks_of(record)]
    if not tasks:
        print(f"newton {project.release} has no records", file=sys.stderr)
        return 2
    once = sum(task.seconds for task in tasks)
    print(f"newton {project.release}: {len(tasks)} batches, {once:.0f} s one after the other")
    for count in arguments.gpus:
        seconds = makespan(tasks, hosts_of(count))
        unit = "GPU " if count == 1 else "GPUs"
        print(f"{count:4} {unit}  {seconds:6.0f} s  {once / seconds:5.1f} times as fast")
    longest = max(tasks, key=lambda task: task.seconds)
    print(f"never less than {longest.seconds:.0f} s, which {longest.name} takes by itself")
    return 0


def tasks_of(record: Record) -> list[Task]:
    """The batches that a record was made of, with how long they took."""
    found = [
        Task(record.section, Batch(match[2], print, alone=match[1] == "alone"), seconds)
        for name, seconds in record.measured.items()
        if (match := BATCH.fullmatch(name))
    ]
    return found or [Task(record.section, Batch(WHOLE, print), record.measured["seconds"])]


def hosts_of(gpu_count: int) -> list[Host]:
    """Hosts with eight GPUs each; the last with what is left."""
    sizes = [GPUS_PER_HOST] * (gpu_count // GPUS_PER_HOST) + [gpu_count % GPUS_PER_HOST]
    slots = [[str(slot) for slot in range(size)] for size in sizes if size]
    return [Host(f"host {number}", (), names) for number, names in enumerate(slots)]


def makespan(tasks: Sequence[Task], hosts: Sequence[Host]) -> float:
    """Seconds until the last task has ended."""
    waiting, busy, now = list(tasks), {}, 0.0
    ends: list[tuple[float, Place]] = []
    while waiting or busy:
        while found := next_start([(task, None) for task in waiting], hosts, busy):
            task, _, place = found
            waiting = [other for other in waiting if other is not task]
            busy[place] = task
            heapq.heappush(ends, (now + task.seconds, place))
        now, place = heapq.heappop(ends)
        del busy[place]
    return now


if __name__ == "__main__":
    sys.exit(main())
