"""The scheduler: sections in batches, measured by this process and its forks, and what may go wrong meanwhile."""

import os
import subprocess
import sys
from pathlib import Path

import batches
import pytest
import warp as wp
from batches import begun, rows_of, run_of

from measured_report.files.errors import UsageError
from measured_report.files.root import ROOT
from measured_report.measuring import worker
from measured_report.measuring.batch import Batch
from measured_report.measuring.cluster_address import read_cluster
from measured_report.measuring.executors import Host, LocalExecutor, Task
from measured_report.measuring.machine import machine
from measured_report.measuring.pool import processes
from measured_report.measuring.scheduler import Scheduler, next_start
from measured_report.measuring.section_run import SectionRun
from measured_report.records.reading import load_record


def fails(toy, log: Path, names: str, executor: LocalExecutor | None = None, **options) -> bool:
    """Measure a section of these batches; whether it fails."""
    run = run_of(toy, batches.section(str(log), names, **options))
    return Scheduler([run], executor or LocalExecutor(machine("cpu"))).run()


def test_a_record_is_put_together_from_its_batches(toy, log):
    assert not fails(toy, log, "abc", alone="b")
    assert begun(log) == ["a", "b", "c"]
    record = load_record(toy.record_path)
    assert [(row["case"], row["slip_mm"]) for row in record.rows] == [("a", 1.0), ("b", 1.0), ("c", 1.0), ("sum", 6.0)]
    assert {name for name in record.measured if name.endswith("_s")} == {
        "batch_a_s", "alone_b_s", "batch_c_s", "batch_sum_s",
    }  # fmt: skip
    assert list(toy.project.root.glob(".cache/batch.*")) == [], "what a record was made of is not kept"


def test_on_a_cpu_batches_are_measured_side_by_side_but_for_those_about_time(toy, log, capsys):
    failing = run_of(toy, batches.single(Batch("bad", batches.fail, (str(log),))), "bad-one")
    with processes(2, "fork") as pool:
        executor = LocalExecutor(machine("cpu"), pool, 2)
        assert Scheduler([failing, run_of(toy, batches.section(str(log), "abcd", 0.2, alone="d"))], executor).run()
    said = [line.split() for line in log.read_text().splitlines()]
    times = {(what, name): float(time) for what, name, time, _ in said}
    assert times["begin", "d"] > max(times["end", name] for name in "abc")
    assert str(os.getpid()) not in {line[3] for line in said}
    assert load_record(toy.record_path).machine["sections_at_once"] == 2
    assert "bad-one: measuring failed" in capsys.readouterr().err


def test_a_batch_that_fails_names_itself_and_costs_no_other_section(toy, log, capsys):
    failing = run_of(toy, batches.single(Batch("bad", batches.fail, (str(log),))), "bad-one")
    other = run_of(toy, batches.section(str(log), "a"))
    assert Scheduler([failing, other], LocalExecutor(machine("cpu"))).run()
    assert "bad-one: measuring failed; what was there is kept: bad: as a test" in capsys.readouterr().err
    assert begun(log) == ["fail", "a"] and len(rows_of(toy)) == 2


def test_the_scheduler_says_how_far_it_is(toy, log):
    said = []

    class Watched(LocalExecutor):
        def start(self, task, process):
            said.append(scheduler.status())
            super().start(task, process)

    known = run_of(toy, batches.section(str(log), "ab"))
    known.known = {"toy": 300.0}
    scheduler = Scheduler([known], Watched(machine("cpu")))
    scheduler.run()
    assert said == [f"{done}; about 5 min left" for done in (
        "0 of 2 batches; toy/a running", "1 of 2 batches; toy/b running", "2 of 3 batches; toy/sum running"
    )]  # fmt: skip
    assert scheduler.status() == "3 of 3 batches; nothing running; about 0 s left"


class Stopped(LocalExecutor):
    """One that is stopped, as by Ctrl-C, before the batch ``at``."""

    def __init__(self, at: str):
        super().__init__(machine("cpu"))
        self.at = at

    def start(self, task, process):
        if task.batch.name == self.at:
            raise KeyboardInterrupt
        super().start(task, process)


def test_what_is_finished_is_found_again_and_only_by_the_same_code(toy, log):
    with pytest.raises(KeyboardInterrupt):
        fails(toy, log, "abcd", Stopped("c"))
    assert not fails(toy, log, "abcd")
    assert begun(log) == ["a", "b", "c", "d"]
    whole = rows_of(toy)
    with pytest.raises(KeyboardInterrupt):
        fails(toy, log, "abcd", Stopped("c"))
    toy.write("experiments/toy.py", "def measure(conditions):\n    return 2\n")
    assert not fails(toy, log, "abcd")
    assert begun(log)[4:] == ["a", "b", "a", "b", "c", "d"] and rows_of(toy) == whole


def test_what_another_kind_of_machine_has_finished_is_not_found(toy, log):
    with pytest.raises(KeyboardInterrupt):
        fails(toy, log, "ab", Stopped("b"))
    other = LocalExecutor({**machine("cpu"), "cpu": "Another"})
    assert not fails(toy, log, "ab", other)
    assert begun(log) == ["a", "a", "b"] and load_record(toy.record_path).machine["cpu"] == "Another"


@pytest.mark.parametrize("names", ["aa", ""])
def test_batches_need_names_of_their_own(toy, log, names, capsys):
    assert fails(toy, log, names)
    assert "batches need names of their own" in capsys.readouterr().err


def task(name: str, seconds: float = 1.0, alone: bool = False) -> Task:
    return Task("toy", Batch(name, batches.work, exclusive=alone), seconds)


KIND = ("cuda", "NVIDIA H200")
TWO = [Host("one", KIND, ["0", "1"], ["0", "1"]), Host("two", KIND, ["0"], ["0"])]


def test_the_longest_goes_first_and_what_must_be_alone_waits_for_an_idle_host():
    short, long, alone = task("short", 1.0), task("long", 9.0), task("alone", 99.0, alone=True)
    ready = [(each, None) for each in (short, alone, long)]
    assert next_start(ready, TWO, {})[0] is long
    assert next_start([(alone, None)], TWO, {("one", "0"): long})[2] == ("two", "0")
    assert next_start([(alone, None)], TWO[:1], {("one", "0"): long}) is None
    assert next_start([(short, None)], TWO[:1], {("one", "0"): alone}) is None
    assert next_start([(short, ("cuda", "NVIDIA A100"))], TWO, {}) is None, "a section stays on one kind of machine"
    assert next_start([(short, KIND)], TWO, {})[1] is TWO[0]


def test_what_need_not_be_alone_shares_the_gpus_where_it_can():
    host = Host("one", KIND, ["gpu/0", "gpu/1"], ["gpu"])
    short, long, alone = task("short", 1.0), task("long", 9.0), task("alone", 99.0, alone=True)
    ready, busy, places = [(each, None) for each in (short, alone, long)], {}, []
    while found := next_start(ready, [host], busy):
        places.append((found[0].batch.name, found[2][1]))
        busy[found[2]] = found[0]
        ready = [pair for pair in ready if pair[0] is not found[0]]
    assert places == [("long", "gpu/0"), ("short", "gpu/1")]
    assert next_start(ready, [host], {}) == (alone, host, ("one", "gpu"))


def test_processes_share_a_gpu_where_a_daemon_lets_them_and_several_prepare_where_memory_is(tmp_path, monkeypatch):
    monkeypatch.setenv(worker.MPS, str(tmp_path))
    monkeypatch.setattr(worker.os, "cpu_count", lambda: 5)
    small, large = worker.Gpu("A", "small", 24_000), worker.Gpu("B", "large", 74_000)
    assert [worker.processes_of(gpu, 2) for gpu in (small, large)] == [(["A"], ["A"]), (["B"], ["B", "B:1", "B:2"])]
    (tmp_path / "control").touch()
    assert worker.processes_of(small, 2) == (["A/0", "A/1"], ["A"])
    assert worker.processes_of(large, 3) == (["B"], ["B", "B:1", "B:2"])  # a process each shares nothing


def test_a_batch_that_is_new_may_take_as_long_as_its_section_did():
    waiting = [Batch(name, batches.work) for name in ("new", "old")]
    known = {"toy": 9.0, "toy/old": 2.0}
    run = SectionRun(None, "toy", "cpu", iter(()), None, known, waiting=waiting)
    assert [each.seconds for each in run.tasks()] == [9.0, 2.0]


HOSTS = {"none": "# nobody\n", "twice": "a\na\n", "option": "-oProxyCommand=x\n", "folder": "a relative/path\n"}


@pytest.mark.parametrize("asked", [
    "", "locals", "local:", "local:0", "local:x", "local:-1", "local:1e3", "local:٣", "local:999999999", "ssh", "ssh:",
    "ssh:/nowhere", "ssh:/", "ssh:/dev/zero", "ssh:pipe",
    "tcp://", "tcp://x", "tcp://x:0", "tcp://x:99999", "tcp://x:1/y", "http://x:1",
    *(f"ssh:{name}" for name in HOSTS),
])  # fmt: skip
def test_what_names_no_workers_is_refused_in_one_line(asked, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name, text in HOSTS.items():
        Path(name).write_text(text)
    os.mkfifo("pipe")
    with pytest.raises(UsageError, match=f"CLUSTER={asked}") as error:
        read_cluster(asked)
    assert "\n" not in str(error.value)


def test_hosts_are_read_with_their_folders(tmp_path):
    (tmp_path / "hosts").write_text("# ours\none\n\ntwo /data/shake report  # the other\n")
    assert read_cluster(f"ssh:{tmp_path}/hosts").hosts == (("one", ""), ("two", "/data/shake report"))
    assert read_cluster("local:3").process_count == 3 and read_cluster("tcp://[::1]:8786").scheduler


@pytest.mark.slow
def test_processes_that_compile_into_one_cache_at_once_do_not_spoil_it(tmp_path):
    settings = {**os.environ, "WARP_CACHE_PATH": str(tmp_path)}
    command = [sys.executable, ROOT / "tests" / "kernels_at_once.py", tmp_path / "cuda"]

    both = [subprocess.Popen(command, env=settings, stdout=subprocess.PIPE, text=True) for _ in range(2)]
    assert [process.communicate()[0].strip() for process in both] == ["[0.0, 2.0, 4.0]"] * 2
    [folder] = (path for path in (tmp_path / wp.config.version).iterdir() if path.name.startswith("wp_"))
    assert sorted(path.suffix for path in folder.iterdir()) == [".cpp", ".meta", ".o"], "one of each, and no leavings"
    assert sorted(path.suffix for path in (tmp_path / "cuda").iterdir()) == [".cu", ".cubin", ".meta"]
