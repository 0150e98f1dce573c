"""Batches without physics, for the tests of the scheduler: each leaves a line of who measured it."""

import os
import signal
import time
from dataclasses import dataclass, field
from pathlib import Path

from measured_report.measuring.batch import Batch, Plan
from measured_report.measuring.section_run import SectionRun
from measured_report.records.identity import identity_of
from measured_report.records.reading import load_record


@dataclass(frozen=True)
class Rows:
    """What a section hands over, without the simulator that Measurement brings."""

    rows: list
    traces: dict = field(default_factory=dict)


def work(log: str, name: str, seconds: float = 0.0) -> dict:
    note(log, f"begin {name}")
    time.sleep(seconds)
    note(log, f"end {name}")
    return {"case": name, "slip_mm": float(len(name))}


def note(log: str, words: str) -> None:
    with Path(log).open("a", encoding="utf-8") as file:
        file.write(f"{words} {time.monotonic()} {os.getpid()}\n")


def fail(log: str) -> None:
    note(log, "begin fail")
    raise ValueError("as a test")


def die(log: str, times: int) -> dict:
    """Killed so often, and then measured."""
    note(log, "begin die")
    if Path(log).read_text(encoding="utf-8").count("begin die") <= times:
        os.kill(os.getpid(), signal.SIGKILL)
    return {"case": "die", "slip_mm": 1.0}


def is_running(process: int) -> bool:
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def double(rows: list) -> dict:
    return {"case": "sum", "slip_mm": 2.0 * sum(row["slip_mm"] for row in rows)}


def section(log: str, names: str, seconds: float = 0.0, alone: str = "") -> Plan:
    """A batch for each letter, those of ``alone`` by themselves, and one that needs them all."""
    rows = yield [Batch(name, work, (log, name, seconds), exclusive=name in alone) for name in names]
    [last] = yield [Batch("sum", double, (rows,))]
    return Rows([*rows, last])


def single(batch: Batch) -> Plan:
    [row] = yield [batch]
    return Rows([row])


def slow_after(log: str, names: str, seconds: float = 600.0) -> Plan:
    """Quick batches, and then one that takes long."""
    rows = yield [Batch(name, work, (log, name)) for name in names]
    rows += yield [Batch("slow", work, (log, "slow", seconds))]
    return Rows(rows)


def kill_worker(log: str) -> dict:
    """The first time the worker that asks for this is killed."""
    note(log, "begin worker")
    if Path(log).read_text(encoding="utf-8").count("begin worker") == 1:
        os.kill(os.getppid(), signal.SIGKILL)
        time.sleep(60.0)
    return {"case": "worker", "slip_mm": 1.0}


def run_of(toy, plan, section: str = "toy") -> SectionRun:
    return SectionRun(toy.project, section, "cpu", plan, identity_of("toy", "full", toy.project.root), {})


def begun(log: Path) -> list[str]:
    """Names of the batches that were begun, in order."""
    return [line.split()[1] for line in log.read_text().splitlines() if line.startswith("begin")]


def rows_of(toy) -> list:
    return load_record(toy.record_path).rows
