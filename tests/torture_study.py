"""Kills of workers and the driver while sections are measured, for tests/torture.py: the records must be as without."""

import json
import os
import random
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from batches import is_running

SECTIONS = ("many", "gap")
"""One without physics, which has many short batches, and one of the report's own."""
BATCH_COUNT = 60
MANY = f"""import os
import random
import time
from pathlib import Path
from measured_report.measuring.batch import Batch, Plan

LOG = Path(__file__).resolve().parent.parent / "many.log"


def measure(conditions) -> Plan:
    from experiments.simulation.measurement import Measurement

    rows = yield [Batch(f"b{{number}}", work, (number,), exclusive=number % 10 == 9) for number in range({BATCH_COUNT})]
    [total] = yield [Batch("sum", add, (rows,))]
    return Measurement([*rows, total])


def work(number: int) -> dict:
    note(f"begin b{{number}}")
    chance = random.Random(number)
    time.sleep(chance.uniform(0.5, 1.5))
    note(f"end b{{number}}")
    return {{"case": f"b{{number}}", "slip_mm": chance.random()}}


def add(rows: list) -> dict:
    return {{"case": "sum", "slip_mm": sum(row["slip_mm"] for row in rows)}}


def note(words: str) -> None:
    with LOG.open("a") as file:
        file.write(f"{{words}} {{os.getpid()}}\\n")
"""
PROCESS_KILLS, WORKER_KILLS = 20, 5


def studies(world, trial, moments: int) -> Iterator:
    """Processes and workers killed at random while they measure, no batch twice, and the driver now and then."""
    trial.name = f"a study on two processes: {PROCESS_KILLS} processes, {WORKER_KILLS} workers and the driver killed"
    root = world.root
    (root / "experiments" / "many.py").write_text(MANY, encoding="utf-8")
    _forget(root)
    _start(root).wait()
    whole = _rows(root)
    if not trial.tried:
        killed, found = _killed(root, random.Random(0))
        trial(f"{killed['process']} processes and {killed['worker']} workers", *found, *_differs(root, whole))
        yield trial
    for number in range(trial.tried, 4):
        _kill_driver(root, 5.0 * number)
        trial(f"the driver after {5 * number} s", *_differs(root, whole))
        yield trial


def _start(root: Path, *cluster: str) -> subprocess.Popen:
    options = ("--device", "cpu", "--profile", "quick", *cluster)
    command = [sys.executable, "-m", "measured_report.measuring.run", *SECTIONS, *options]
    with (root / "driver.log").open("w") as log:
        env = os.environ | {"PYTHONPATH": os.pathsep.join(map(str, (root / "packages").iterdir()))}
        return subprocess.Popen(command, cwd=root, env=env, stderr=log, stdout=log, start_new_session=True)


def _forget(root: Path) -> None:
    for path in root.glob("results/quick/newton-*/*"):
        path.unlink()
    (root / "many.log").write_text("")


def _rows(root: Path) -> dict[str, list]:
    """The rows of each record, without the times."""
    found = {path.stem: json.loads(path.read_text())["rows"] for path in root.glob("results/quick/newton-*/*.json")}
    for row in (row for rows in found.values() for row in rows):
        row.pop("wall_s", None)
    return found


def _killed(root: Path, chance: random.Random) -> tuple[Counter, list[str]]:
    """Measure while processes are killed; how many were, and what was wrong."""
    _forget(root)
    wanted = ["process"] * PROCESS_KILLS + ["worker"] * WORKER_KILLS
    chance.shuffle(wanted)
    driver, hit, killed = _start(root, "--cluster", "local:2"), set(), Counter()
    while driver.poll() is None:
        time.sleep(chance.uniform(0.1, 0.5))
        at_work = {number: name for number, name in _at_work(root).items() if name not in hit}
        if not wanted or not at_work or (wanted[0] == "worker" and len(at_work) < len(_at_work(root))):
            continue
        victim = chance.choice(sorted(at_work))
        try:
            parent = int(Path(f"/proc/{victim}/stat").read_text().rpartition(")")[2].split()[1])
            os.kill(victim if wanted[0] == "process" else parent, signal.SIGKILL)
        except OSError:
            continue
        hit |= set(at_work.values()) if wanted[0] == "worker" else {at_work[victim]}
        killed[wanted.pop(0)] += 1
    found = [f"status {driver.returncode}: {(root / 'driver.log').read_text()[-300:]}"] if driver.returncode else []
    return killed, found + [f"{len(wanted)} kills were left" for _ in wanted[:1]]


def _at_work(root: Path) -> dict[int, str]:
    """The batch of section many that each process is measuring."""
    last = {int(line.split()[-1]): line.split()[:2] for line in (root / "many.log").read_text().splitlines()}
    return {number: name for number, (state, name) in last.items() if state == "begin" and is_running(number)}


def _kill_driver(root: Path, moment_s: float) -> None:
    """Kill the driver so long after the first batch is begun, and let another one finish, without a cluster."""
    _forget(root)
    driver = _start(root, "--cluster", "local:2")
    while not _at_work(root) and driver.poll() is None:
        time.sleep(0.1)
    time.sleep(moment_s)
    os.kill(driver.pid, signal.SIGKILL)
    driver.wait()
    deadline = time.monotonic() + 5.0
    while _at_work(root) and time.monotonic() < deadline:
        time.sleep(0.1)
    _start(root).wait()


def _differs(root: Path, whole: dict[str, list]) -> list[str]:
    """Say what is wrong with what measuring has left."""
    found = [] if _rows(root) == whole and whole.keys() == set(SECTIONS) else ["other rows than without"]
    lines = [line.split() for line in (root / "many.log").read_text().splitlines()]
    times = Counter((state, name) for state, name, _ in lines)
    found += [f"{state} {name}: {count} times" for (state, name), count in times.items() if count > 2]
    time.sleep(2.0)
    return found + [f"process {line[-1]} still runs" for line in lines if is_running(int(line[-1]))][:1]
