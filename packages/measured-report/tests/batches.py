"""Provide batches without physics for the tests of measuring.

Each batch writes a line with the process that measured it.
"""

import os
import pickle
import signal
import time
import warnings
from dataclasses import dataclass, field
from pathlib import Path

from measured_report.measuring.batch import Batch, Plan, Result
from measured_report.measuring.run import Section
from measured_report.records.record import basis_of, load_record


@dataclass(frozen=True)
class Rows:
    """Stand in for the result of a section, without the simulator that Measurement
    imports.
    """

    rows: list
    traces: dict = field(default_factory=dict)


def work(log: str, name: str, seconds: float = 0.0) -> dict:
    note(log, f"begin {name}")
    time.sleep(seconds)
    note(log, f"end {name}")
    return {"case": name, "slip_mm": float(len(name))}


def meet(log: str, name: str, names: list[str]) -> dict:
    """Wait until all of these batches have begun."""
    note(log, f"begin {name}")
    while not {*names} <= {*begun(Path(log))}:
        time.sleep(0.01)
    note(log, f"end {name}")
    return {"case": name, "slip_mm": 1.0}


def warn(name: str) -> dict:
    home = os.path.expanduser("~")  # noqa: PTH111
    for _ in range(2):
        warnings.warn(f"{home}/x is\ndeprecated", DeprecationWarning, stacklevel=1)
    warnings.warn("take care", stacklevel=1)
    return {"case": name, "slip_mm": 1.0}


def note(log: str, words: str) -> None:
    with Path(log).open("a", encoding="utf-8") as file:
        file.write(f"{words} {time.monotonic()} {os.getpid()}\n")


def fail(log: str) -> None:
    note(log, "begin fail")
    raise ValueError("as a test")


def die(log: str, times: int) -> dict:
    """Kill the process of this batch the given number of times, and then measure."""
    note(log, "begin die")
    if Path(log).read_text(encoding="utf-8").count("begin die") <= times:
        os.kill(os.getpid(), signal.SIGKILL)
    return {"case": "die", "slip_mm": 1.0}


def die_after(log: str) -> None:
    """Kills its process each time it is measured once ``die`` has begun.

    A broken pool also loses the batches that have not begun.
    """
    while "begin die" not in Path(log).read_text(encoding="utf-8"):
        time.sleep(0.01)
    os.kill(os.getpid(), signal.SIGKILL)


def is_running(process: int) -> bool:
    try:
        return (
            Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0]
            != "Z"
        )
    except OSError:
        return False


GARBAGE = (
    None,
    3,
    b"x",
    Result(b"x", {}, "", "", 0.0),
    Result(pickle.dumps(1), None, "soon", "late", "long"),
)


def garbage(batch: Batch, device: str) -> object:
    """Results that a worker may return instead of a valid one, by the name of the
    batch.
    """
    return GARBAGE[int(batch.name)]


def double(rows: list) -> dict:
    return {"case": "sum", "slip_mm": 2.0 * sum(row["slip_mm"] for row in rows)}


def plan(log: str, names: str, seconds: float = 0.0, exclusive: str = "") -> Plan:
    """Plan a batch for each letter, run those of ``exclusive`` one at a time, and add
    one that needs all others.
    """
    rows = yield [
        Batch(name, work, (log, name, seconds), exclusive=name in exclusive)
        for name in names
    ]
    [last] = yield [Batch("sum", double, (rows,))]
    return Rows([*rows, last])


def all_of(found: list[Batch]) -> Plan:
    return Rows((yield found))


def single(batch: Batch) -> Plan:
    return all_of([batch])


def section_of(toy, plan: Plan, name: str = "toy") -> Section:
    basis = basis_of("toy", toy.project.record_path(name), "full", toy.project.root)
    return Section(toy.project, name, "cpu", plan, basis)


def begun(log: Path) -> list[str]:
    """Return the names of the batches that were begun, in order."""
    return [
        line.split()[1]
        for line in log.read_text().splitlines()
        if line.startswith("begin")
    ]


def spans(log: Path) -> dict[str, tuple[float, float]]:
    """Return when each batch last began and ended."""
    found: dict[str, list[float]] = {}
    for line in log.read_text().splitlines():
        found.setdefault(line.split()[1], []).append(float(line.split()[2]))
    return {
        name: (times[-2], times[-1]) for name, times in found.items() if len(times) > 1
    }


def running(log: Path) -> list[int]:
    """Return the processes that measured and still exist a moment later."""
    numbers = {int(line.split()[-1]) for line in log.read_text().splitlines()}
    deadline = (
        time.monotonic() + 60.0
    )  # a process still counts after the longest time in which a busy machine ends it
    while (
        left := [number for number in numbers if is_running(number)]
    ) and time.monotonic() < deadline:
        time.sleep(0.05)
    return left


def rows_of(toy) -> list:
    return load_record(toy.record_path).rows
