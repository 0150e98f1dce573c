"""Test the loop that measures sections in batches in processes of this host, and its
failures.
"""

import importlib
import os
import pickle
import re
import signal
import subprocess
import sys
import time
from dataclasses import dataclass, replace
from datetime import datetime
from pathlib import Path

import batches
import numpy as np
import pandas as pd
import pytest
from batches import begun, rows_of, running, section_of
from toys import program

from measured_report.files.errors import ReportError
from measured_report.measuring import batch
from measured_report.measuring.batch import Batch, Plan, measure_batch
from measured_report.measuring.measure import MODULE
from measured_report.measuring.pool import host_pools
from measured_report.measuring.run import Loop, section_module
from measured_report.records.identity import identity_of
from measured_report.records.record import load_record, write_record


def fails(*sections, count: int = 1) -> bool:
    """Measure sections, and return whether one of them failed."""
    with host_pools([{}] * count, {}) as pools:
        return Loop(sections, *pools).run()


def test_a_record_is_put_together_from_its_batches(toy, log):
    assert not fails(section_of(toy, batches.plan(str(log), "abc", exclusive="b")))
    assert begun(log) == ["a", "c", "b"], "what measures times is measured last"
    record = load_record(toy.record_path)
    assert [(row["case"], row["slip_mm"]) for row in record.rows] == [
        ("a", 1.0),
        ("b", 1.0),
        ("c", 1.0),
        ("sum", 6.0),
    ]
    assert record.machine["host"]


def test_a_record_keeps_what_will_be_removed_and_other_warnings_are_printed(toy):
    with (
        pytest.warns(UserWarning, match="take care"),
        batch.deprecations() as deprecated,
    ):
        batches.warn("a")
    assert deprecated == {"~/x is deprecated"}
    calls = [Batch(name, batches.warn, (name,)) for name in "ab"]
    assert not fails(section_of(toy, batches.all_of(calls)))
    record = load_record(toy.record_path)
    assert record.deprecated == ("~/x is deprecated",)
    toy.measure()
    write_record(
        toy.record_path,
        replace(load_record(toy.record_path), deprecated=record.deprecated),
    )
    toy.build()
    assert "<dd>~/x is deprecated</dd>" in toy.page


def test_batches_are_measured_side_by_side_but_for_those_about_time(toy, log):
    pair = [
        Batch(name, batches.meet, (str(log), name, ["a", "b"])) for name in "ab"
    ]  # each of them waits for the other
    alone = [
        Batch(name, batches.work, (str(log), name), exclusive=True) for name in "de"
    ]
    assert not fails(section_of(toy, batches.all_of([*alone, *pair])), count=2)
    assert [line.split()[:2] for line in log.read_text().splitlines()][-4:] == [
        *(["begin", "d"], ["end", "d"], ["begin", "e"], ["end", "e"])
    ]
    assert not running(log)


def test_a_batch_that_fails_names_itself_and_costs_no_other_section(toy, log, capsys):
    failing = section_of(
        toy, batches.single(Batch("bad", batches.fail, (str(log),))), "bad-one"
    )
    ending = section_of(
        toy, batches.single(Batch("end", sys.exit, ("ended",))), "ending-one"
    )
    odd = section_of(
        toy, batches.single(Batch("odd", os.listdir, (lambda: None,))), "odd-one"
    )
    assert fails(failing, ending, odd, section_of(toy, batches.plan(str(log), "a")))
    lines = capsys.readouterr().err
    start = r"could not be measured \(an existing record is kept\):"
    assert re.search(
        rf"bad-one {start} bad: batches.py:\d+: ValueError: as a test\n", lines
    )
    assert re.search(rf"odd-one {start} odd: .", lines)
    assert re.search(rf"ending-one {start} end: .*SystemExit: ended\n", lines)
    assert len(rows_of(toy)) == 2


class Clock(datetime):
    """Prints the given texts one after the other."""

    @classmethod
    def now(cls, zone):
        return cls.fromisoformat(TOLD.pop(0))


TOLD: list[str] = []


def test_a_clock_that_is_put_back_turns_no_times_around(monkeypatch):
    monkeypatch.setattr(batch, "datetime", Clock)
    TOLD[:] = (
        "2026-01-02T00:00:00+00:00",
        "2026-01-01T00:00:00+00:00",
    )
    result = measure_batch(pickle.dumps(Batch("a", int)), "cpu")
    assert result.started <= result.ended


def test_a_file_that_a_process_read_before_a_batch_does_not_belong_to_it(monkeypatch):
    monkeypatch.setattr(batch, "OPENED", {("open", "/read/by/another/section")})
    assert not measure_batch(pickle.dumps(Batch("a", int)), "cpu").opened


def test_a_killed_process_costs_nothing_but_what_it_measured(toy, log, capsys):
    mortal = section_of(
        toy, batches.single(Batch("die", batches.die, (str(log), 1))), "mortal"
    )
    doomed = section_of(
        toy, batches.single(Batch("die", batches.die_after, (str(log),))), "doomed"
    )
    assert fails(
        mortal, doomed, section_of(toy, batches.plan(str(log), "efgh", 0.1)), count=2
    )
    lines, reason = (
        capsys.readouterr().err,
        "the process of die was killed twice, the second time while it ran by itself: use less memory",
    )
    assert (
        "the process of mortal/die was killed; the batch is measured again by itself"
        in lines
    )
    assert (
        f"doomed could not be measured (an existing record is kept): {reason}" in lines
    )
    assert [row["case"] for row in rows_of(toy)] == [*"efgh", "sum"]
    assert (
        begun(log).count("die") == 2
        and toy.project.record_path("mortal").is_file()
        and not running(log)
    )


def test_numbers_of_numpy_are_kept_as_numbers(toy):
    row = {
        "case": "a",
        "slip_mm": np.float32(1.5),
        "hold_count": np.int64(3),
        "holds": np.bool_(True),
    }
    assert not fails(
        section_of(toy, handed(batches.Rows([row], {"a": {"time_s": np.arange(2.0)}})))
    )
    assert rows_of(toy) == [
        {"case": "a", "slip_mm": 1.5, "hold_count": 3, "holds": True}
    ]


@pytest.mark.parametrize(
    ("returned", "reason"),
    [
        (None, "'NoneType' object is not iterable"),
        ({"case": "a"}, "it is a dict"),
        ([1], r"asdict\(\) should be called on dataclass instances"),
        (batches.Rows([1]), "'int' object has no attribute 'items'"),
        (
            batches.Rows([{"case": "a", "slip_mm": [1.0]}]),
            r"slip_mm contains \[1.0\]: use numbers, text, True or False",
        ),
        (
            batches.Rows([{"case": "a"}], {"a": {"time_s": [[1.0]]}}),
            r"time_s contains \[1.0\]: use numbers.*",
        ),
        (
            batches.Rows([{"case": "a"}], {"a": {"time_s": [1.0], "slip_mm": []}}),
            "its columns have different lengths",
        ),
        ([{"cas": "a"}], "returns no rows or a row without a case"),
        (
            batches.Rows([{"case": "a"}], {1: {1: [1.0]}}),
            "'1' is not a valid column name",
        ),
    ],
)
def test_what_is_no_measurement_is_refused_in_one_line(toy, capsys, returned, reason):
    before = rows_of(toy)
    assert fails(section_of(toy, handed(returned)))
    lines = capsys.readouterr().err
    assert re.fullmatch(
        rf"toy could not be measured \(an existing record is kept\): .*{reason}.*\n",
        lines,
    )
    assert rows_of(toy) == before


@dataclass
class Cells:
    case: str
    slip_mm: float


@pytest.mark.parametrize(
    "returned",
    [
        [{"case": "a", "slip_mm": 1.5}, {"case": "b", "slip_mm": 2.5}],
        [Cells("a", 1.5), Cells("b", 2.5)],
        pd.DataFrame({"case": ["a", "b"], "slip_mm": [1.5, 2.5]}, index=[7, 8]),
        pd.DataFrame({"slip_mm": [1.5, 2.5]}, index=["a", "b"]),
    ],
    ids=["dicts", "dataclasses", "frame with cases", "frame by case"],
)
def test_rows_alone_are_a_measurement(toy, returned):
    assert not fails(section_of(toy, handed(returned)))
    assert [(row["case"], row["slip_mm"]) for row in rows_of(toy)] == [
        ("a", 1.5),
        ("b", 2.5),
    ]


def test_a_text_that_a_row_of_a_frame_lacks_is_left_out(toy):
    frame = pd.DataFrame({"slip_mm": [1.5, 2.5], "of": [None, "a"]}, index=["a", "b"])
    assert not fails(section_of(toy, handed(frame)))
    assert rows_of(toy) == [
        {"case": "a", "slip_mm": 1.5},
        {"case": "b", "slip_mm": 2.5, "of": "a"},
    ]


def test_rows_that_are_yielded_are_no_batches(toy, capsys):
    assert (
        fails(section_of(toy, (rows for rows in [[{"case": "a"}]])))
        and "measure yields something other than a Batch" in capsys.readouterr().err
    )


def handed(returned) -> Plan:
    """Replaces a section: it returns the given object without a measurement."""
    yield [Batch("a", os.getpid)]
    return returned


DRIVER = """
import batches
import signal
import sys
from pathlib import Path
from types import SimpleNamespace
from measured_report.editions.project import Project
from measured_report.measuring.batch import Batch
from measured_report.measuring.run import Loop
from measured_report.measuring.measure import MODULE
from measured_report.measuring.pool import host_pools

signal.signal(signal.SIGINT, signal.SIG_DFL)
root, log = sys.argv[1:]
toy = SimpleNamespace(project=Project("1.4.0", root=Path(root)))
slow = batches.single(Batch("slow", batches.work, (log, "slow", 600.0)))
with host_pools([{}, {}], {}) as pools:
    Loop([batches.section_of(toy, batches.plan(log, "ab")), batches.section_of(toy, slow, "slow")], *pools).run()
"""


@pytest.mark.parametrize("sent", [signal.SIGINT, signal.SIGKILL])
def test_measuring_that_is_stopped_keeps_its_records_and_leaves_nothing_running(
    toy, log, outside, sent
):
    toy.record_path.unlink()
    command = [sys.executable, "-c", DRIVER, str(toy.project.root), str(log)]
    env = {
        **os.environ,
        "TMPDIR": str(outside),
    }  # the lock is in this folder, so these processes have a lock of their own
    driver = subprocess.Popen(
        command,
        cwd=outside,
        env=env,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    while "begin slow" not in log.read_text() or not toy.record_path.exists():
        assert driver.poll() is None, driver.stderr.read()
        time.sleep(0.02)
    driver.send_signal(sent)
    lines = driver.communicate(timeout=300.0)[
        1
    ]  # half of the memory that the batch would need
    assert not running(log)
    assert driver.returncode == -sent and "Traceback" not in lines
    assert [row["case"] for row in rows_of(toy)] == ["a", "b", "sum"]
    assert [path.name for path in Path(toy.record_path).parent.glob("slow*")] == []


def test_a_section_that_cannot_be_imported_is_one_line(tmp_path, monkeypatch):
    (tmp_path / "broken.py").write_text("\nimport nothing\n")
    monkeypatch.setattr(
        importlib.import_module("experiments"), "__path__", [str(tmp_path)]
    )
    with pytest.raises(
        ReportError,
        match=r"^broken.py:2: ModuleNotFoundError: No module named 'nothing'$",
    ):
        section_module("broken")


MEANWHILE = """
from dataclasses import replace
from pathlib import Path

from measured_report.measuring.measurement import Measurement
from measured_report.records.record import load_record, write_record


def measure(conditions):
    {}
    return Measurement([{{"case": "a", "slip_mm": 1.0}}])
"""
READ = """
from pathlib import Path
from measured_report.measuring.measurement import Measurement

FILE = "{declared}"
{early}

def measure(conditions):
    cell = 1.5 if {early!r} else float(Path({read}).read_text())
    Path("log.txt").write_text("done")
    return Measurement([{{"case": "a", "slip_mm": cell}}])
"""


@pytest.mark.parametrize(
    ("folder", "early"),
    [(".", ""), ("experiments", ""), ("assets", "read"), ("..", "")],
)
def test_a_data_file_that_a_record_would_not_depend_on_is_refused(toy, folder, early):
    toy.write(f"{folder}/data.csv", "1.5")
    read = f"'{folder}', 'data.csv'"
    early = early and f"Path({read}).read_text()"
    code = READ.format(declared="assets/y.csv", read=read, early=early)
    toy.write("experiments/toy.py", code)
    done = program("-m", MODULE, "toy", "--device", "cpu", cwd=toy.project.root)
    assert done.returncode == 1 and len(done.stderr.splitlines()) == 1, done.stderr
    name = Path(folder, "data.csv")
    assert f"measure reads {name}, but its record would not depend" in done.stderr


SCRIPT = "tools/script.py"


@pytest.mark.parametrize(
    ("name", "call"),
    [
        (SCRIPT, f"subprocess.run([sys.executable, Path('{SCRIPT}'), 300 * 'a'])"),
        ("data.db", "sqlite3.connect('data' + '.db')"),
    ],
)
def test_a_file_that_python_does_not_open_itself_is_refused_too(toy, name, call):
    toy.write(name, "")
    code = READ.format(declared="assets/y.csv", read="'log.txt'", early="")
    code = code.replace("cell =", f"{call}; cell = 1.5 #")
    toy.write("experiments/toy.py", f"import sqlite3, subprocess, sys\n{code}")
    done = program("-m", MODULE, "toy", "--device", "cpu", cwd=toy.project.root)
    assert f"measure reads {name}, but its record would not depend" in done.stderr


@pytest.mark.parametrize("early", ["", "Path(FILE).read_text()"])
def test_a_section_can_read_a_file_that_another_one_does_not_declare(toy, early):
    toy.write("assets/x.csv", "1.5")
    code = READ.format(declared="assets/x.csv", read="'assets/x.csv'", early=early)
    toy.write("experiments/reading.py", code)
    code = READ.format(declared="assets/y.csv", read="", early="1")
    toy.write("experiments/toy.py", code)
    toy.write("report/sections/reading.py", "")
    done = program(
        "-m", MODULE, "reading", "toy", "--device", "cpu", cwd=toy.project.root
    )
    assert done.returncode == 0, done.stderr


def test_a_declared_data_file_makes_its_record_stale(toy):
    toy.write("assets/x.csv", "1.5")
    code = READ.format(declared="assets/x.csv", read="'assets/x.csv'", early="")
    toy.write("experiments/toy.py", code)
    done = program("-m", MODULE, "toy", "--device", "cpu", cwd=toy.project.root)
    assert done.returncode == 0, done.stderr
    assert rows_of(toy)[0]["slip_mm"] == 1.5
    before = load_record(toy.record_path).identity.config
    toy.write("assets/x.csv", "2.5")
    assert identity_of("toy", "full", toy.project.root).config != before


EDIT = 'Path(__file__).write_text(Path(__file__).read_text().replace("1.0", "2.0"))'
IMPORT = 'scene = Path(__file__).with_name("scene.py"); scene.write_text(scene.read_text() + "LATER = 1")'
NEWER = """path = Path("results/newton-1.4.0/toy.json").resolve()
    write_record(path, replace(load_record(path), rows=[{"case": "newer", "slip_mm": 9.0}]))"""


@pytest.mark.parametrize(
    ("event", "reason", "case"),
    [
        (EDIT, "the code of toy changed in the meantime", "soft"),
        (
            f"from experiments.scene import slip; {IMPORT}",
            "the code of toy changed in the meantime",
            "soft",
        ),
        (
            NEWER,
            "newton-1.4.0/toy.json was changed by another command",
            "newer",
        ),
    ],
    ids=["its module", "a module that it imports", "a newer record"],
)
def test_what_changes_while_a_section_runs_is_seen_and_nothing_is_written(
    toy, event, reason, case
):
    toy.write("experiments/toy.py", MEANWHILE.format(event))
    done = program("-m", MODULE, "toy", "--device", "cpu", cwd=toy.project.root)
    assert (
        done.returncode == 1
        and reason in done.stderr
        and len(done.stderr.splitlines()) == 1
    )
    assert rows_of(toy)[0]["case"] == case
    toy.write("experiments/toy.py", MEANWHILE.format("pass"))
    assert (
        program("-m", MODULE, "toy", "--device", "cpu", cwd=toy.project.root).returncode
        == 0
    )
    assert rows_of(toy)[0]["case"] == "a"
