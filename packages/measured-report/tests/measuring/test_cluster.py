"""Test measuring on a cluster with workers that are killed, unsuitable or outdated."""

import gc
import os
import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import batches
import pytest
from batches import rows_of, section_of, spans

pytest.importorskip(
    "distributed", reason="uv sync --inexact --extra cluster installs it"
)

import dask
from distributed import Client, Security

from measured_report.files.errors import ReportError
from measured_report.measuring import run
from measured_report.measuring.batch import Batch
from measured_report.measuring.cluster import cluster_pools, connected
from measured_report.measuring.run import Loop

SCHEDULER = """
import sys
from dask import config
from distributed import Nanny, Scheduler, SpecCluster

own = {"host": "127.0.0.1", "protocol": sys.argv[2], "dashboard": False, "dashboard_address": "127.0.0.1:0"}
options = [{**own, "nthreads": 1, "memory_limit": 0, "silence_logs": 50}] * int(sys.argv[1])
workers = {number: {"cls": Nanny, "options": each} for number, each in enumerate(options)}
if __name__ == "__main__":
    config.set({"distributed.scheduler.allowed-failures": 2, "distributed.deploy.lost-worker-timeout": "1h"})
    with SpecCluster(workers, {"cls": Scheduler, "options": own}, silence_logs=50) as cluster:
        print(cluster.scheduler_address, flush=True)
        sys.stdin.read()
"""


@pytest.fixture(scope="module", autouse=True)
def tidy():
    """Collect Dask's remaining objects at the end, because their warnings would disturb
    a later compilation.
    """
    yield
    gc.collect()


def started(outside: Path, count: int, protocol: str = "tcp") -> subprocess.Popen:
    command, pipe = (
        [sys.executable, "-c", SCHEDULER, str(count), protocol],
        subprocess.PIPE,
    )
    own = {
        **os.environ,
        "TMPDIR": str(outside),
    }  # the lock is in this folder, so these processes have a lock of their own
    return subprocess.Popen(
        command, cwd=outside, env=own, stdin=pipe, stdout=pipe, text=True
    )


@pytest.fixture(scope="module")
def certificates(tmp_path_factory) -> Iterator[None]:
    """Write a certificate authority, a certificate and its key, and set the variables
    with which Dask and programs find them.
    """
    folder, made = tmp_path_factory.mktemp("tls"), Security.temporary()
    texts = {
        "ca-file": made.tls_ca_file,
        "key": made.tls_client_key,
        "cert": made.tls_client_cert,
    }
    for name, text in texts.items():
        (folder / name).write_text(text)
    names = [
        "ca-file",
        *(
            f"{side}.{name}"
            for side in ("scheduler", "worker", "client")
            for name in ("key", "cert")
        ),
    ]
    settings = {
        f"distributed.comm.tls.{name}": str(folder / name.rpartition(".")[2])
        for name in names
    }
    with pytest.MonkeyPatch.context() as patch, dask.config.set(settings):
        for name, path in settings.items():
            patch.setenv(
                f"DASK_{name.upper().replace('.', '__').replace('-', '_')}", path
            )
        yield


@pytest.fixture(scope="module")
def address(outside, certificates):
    """Yield the address of a cluster with one worker for shared batches and one for all
    others.
    """
    with started(outside, 2, "tls") as process:
        yield process.stdout.readline().strip()
        process.communicate()


@pytest.fixture
def scheduler(address) -> str:
    """Return the same address after all workers have joined.

    Workers that a test killed need a while to return.
    """
    with Client(address) as client:
        client.wait_for_workers(2)
    return address


@pytest.mark.slow
def test_a_killed_worker_costs_nothing_but_what_it_measured(
    toy, log, scheduler, capsys
):
    whole = section_of(toy, batches.plan(str(log), "abcdef", 0.2, exclusive="cf"))
    mortal = section_of(
        toy, batches.single(Batch("die", batches.die, (str(log), 1))), "mortal"
    )
    doomed = section_of(
        toy, batches.single(Batch("die", batches.die, (str(log), 99))), "doomed"
    )
    with cluster_pools(scheduler) as pools:
        assert not Loop([whole, mortal], *pools).run()
        assert Loop([doomed], *pools).run()
    reason = "the process of die was killed twice, the second time while it ran by itself: use less memory"
    assert (
        f"doomed could not be measured (an existing record is kept): {reason}"
        in capsys.readouterr().err
    )
    assert [row["case"] for row in rows_of(toy)] == [*"abcdef", "sum"]
    times = spans(log)
    for exclusive in "cf":
        begin, end = times.pop(exclusive)
        assert all(other[1] <= begin or end <= other[0] for other in times.values()), (
            "it was alone"
        )


def test_a_worker_that_returns_garbage_costs_its_section_alone(
    toy, scheduler, monkeypatch, capsys
):
    assert scheduler.startswith("tls://")
    monkeypatch.setattr(run, "measure_batch", batches.garbage)
    names = [*map(str, range(len(batches.GARBAGE)))]
    with cluster_pools(scheduler) as pools:
        assert Loop(
            [
                section_of(toy, batches.single(Batch(name, id)), f"s{name}")
                for name in names
            ],
            *pools,
        ).run()
    lines = capsys.readouterr().err.splitlines()
    names = [f"s{name}" for name in names]
    assert sorted(line.partition(" could not")[0] for line in lines) == names, lines
    assert all(
        "could not be measured (an existing record is kept): " in line for line in lines
    )
    kept = [path.name for path in toy.record_path.parent.glob("*.json")]
    assert kept == ["toy.json"]


def test_workers_with_other_code_are_refused_in_one_line(scheduler, monkeypatch):
    monkeypatch.setenv("GIT_COMMIT", "abc")
    refused = pytest.raises(
        ReportError, match=r"a worker has commit [^\n]+ this machine has abc"
    )
    with refused, cluster_pools(scheduler):
        pass


def test_a_cluster_for_which_nobody_has_a_certificate_is_refused_in_one_line():
    none = {
        f"distributed.comm.tls.{name}": None
        for name in ("ca-file", "client.key", "client.cert")
    }
    refused = pytest.raises(
        ReportError,
        match=r"^CLUSTER=tls://127\.0\.0\.1:1: cannot reach any worker [^\n]+TLS[^\n]+$",
    )
    with dask.config.set(none), refused, connected("tls://127.0.0.1:1"):
        pass


@pytest.mark.slow
def test_a_scheduler_that_ends_is_noticed(outside, toy, capfd):
    settings = dask.config.set({"distributed.comm.timeouts.connect": "1s"})
    with settings, started(outside, 1) as process:
        address = process.stdout.readline().strip()
        gone = pytest.raises(
            ReportError, match="the connection to the scheduler is lost"
        )
        with cluster_pools(address) as pools:
            batch = Batch("end", os.kill, (process.pid, signal.SIGKILL))
            with gone:
                Loop([section_of(toy, batches.single(batch))], *pools).run()
        unreachable = pytest.raises(
            ReportError, match=f"CLUSTER={address}: cannot reach any worker"
        )
        with unreachable, connected(address):
            pass
        process.wait()
    assert not re.search("Traceback|ERROR", capfd.readouterr().err)
