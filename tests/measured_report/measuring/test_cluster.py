"""Sections measured by a cluster's workers, which are killed, stopped and have other code."""

import asyncio
import gc
import os
import re
import signal
import socket
import ssl
import subprocess
import sys
import threading
import time
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import batches
import pytest
from batches import begun, is_running, rows_of, run_of
from conftest import SOURCES, link

pytest.importorskip("distributed", reason="make test installs the extra that has it")

import asyncssh
import dask

from measured_report.files.errors import ReportError
from measured_report.files.root import ROOT
from measured_report.measuring import cluster as clusters
from measured_report.measuring.batch import Batch
from measured_report.measuring.cluster import cluster_executor
from measured_report.measuring.cluster_address import read_cluster
from measured_report.measuring.executors import LocalExecutor
from measured_report.measuring.machine import machine
from measured_report.measuring.scheduler import Scheduler
from measured_report.records.identity import identity_of

CLUSTER = """
import sys
from distributed import LocalCluster

options = {"memory_limit": 0, "dashboard_address": None, "silence_logs": 50}
with LocalCluster(n_workers=1, threads_per_worker=2, host="127.0.0.1", **options) as cluster:
    print(cluster.scheduler_address, flush=True)
    sys.stdin.read()
"""


@pytest.fixture(scope="module", autouse=True)
def tidy():
    """What Dask leaves says so when it is collected, which breaks whatever Python is compiling just then."""
    yield
    gc.collect()


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    """The project as a report without a host of its own: its processes load no simulator, which takes seconds each."""
    folder = tmp_path_factory.mktemp("project")
    link(folder, *(name for name in SOURCES if name != "report.toml"))
    text = (ROOT / "report.toml").read_text(encoding="utf-8")
    assert len(re.findall("^host = ", text, re.MULTILINE)) == 1
    (folder / "report.toml").write_text(re.sub("^host = .*", "", text, flags=re.MULTILINE), encoding="utf-8")
    return folder


@pytest.fixture(scope="module")
def scheduler(folder):
    """Address of a cluster of one worker with two processes, as somebody may have started it."""
    command, pipe = [sys.executable, "-c", CLUSTER], subprocess.PIPE
    with subprocess.Popen(command, cwd=folder, stdin=pipe, stdout=pipe, text=True) as cluster:
        yield cluster.stdout.readline().strip()
        cluster.communicate()


@contextmanager
def workers_at(scheduler: str):
    with cluster_executor(read_cluster(scheduler), "cpu", None, {}) as executor:
        executor.gather()
        yield executor


def spans(log: Path) -> dict[str, tuple[float, float]]:
    """When each batch was last begun and ended."""
    found: dict[str, list[float]] = {}
    for line in log.read_text().splitlines():
        found.setdefault(line.split()[1], []).append(float(line.split()[2]))
    return {name: (times[-2], times[-1]) for name, times in found.items() if len(times) > 1}


def test_killed_processes_and_workers_cost_nothing_but_what_they_measured(toy, log, scheduler, capsys):
    whole = run_of(toy, batches.section(str(log), "abcdefg", 0.1, alone="cf"))
    mortal = run_of(toy, batches.single(Batch("die", batches.die, (str(log), 2))), "mortal")
    doomed = run_of(toy, batches.single(Batch("die", batches.die, (str(log), 99))), "doomed")
    killer = run_of(toy, batches.single(Batch("worker", batches.kill_worker, (str(log),))), "killer")
    with workers_at(scheduler) as workers:
        assert Scheduler([killer, whole, mortal], workers).run() is False
        assert Scheduler([doomed], workers).run() is True
    errors = capsys.readouterr().err
    assert "killer/worker: its worker is gone; it is tried again" in errors
    assert errors.count("mortal/die: its process was killed by SIGKILL; it is tried again") == 2
    assert "doomed: measuring failed; what was there is kept: die: its process was killed by SIGKILL, 3 times" in errors
    assert [row["case"] for row in rows_of(toy)] == [*"abcdefg", "sum"]
    assert all(begun(log).count(name) <= 2 for name in "abcdefg")
    times = spans(log)
    for alone in "cf":
        begin, end = times.pop(alone)
        assert all(other[1] <= begin or end <= other[0] for other in times.values()), "it was alone"
    assert not running(log)


@pytest.mark.slow
def test_a_worker_of_this_host_comes_back_however_often_it_is_killed(monkeypatch):
    # By itself Dask looks 15 s after a loss whether there is a worker, and gives up; here 1 s after it.
    monkeypatch.setitem(dask.config.config["distributed"]["deploy"], "lost-worker-timeout", "1s")
    with clusters.connected(read_cluster("local:1"), "cpu") as client:
        end = time.monotonic() + 3.0
        while time.monotonic() < end:
            for process in client.run(os.getpid, on_error="ignore").values():
                os.kill(process, signal.SIGKILL)
            time.sleep(0.02)
        client.wait_for_workers(1, timeout=10.0)


def running(log: Path) -> list[int]:
    """Processes that have measured and are still there, a moment later."""
    numbers = {int(line.split()[-1]) for line in log.read_text().splitlines()}
    deadline = time.monotonic() + 5.0
    while (left := [number for number in numbers if is_running(number)]) and time.monotonic() < deadline:
        time.sleep(0.05)
    return left


@pytest.mark.parametrize("differing", ["code: experiments/gap.py", "measured_report"])
def test_a_worker_with_other_code_is_refused_by_name(scheduler, monkeypatch, capsys, differing):
    identities, own = {}, identity_of("gap", "quick")
    if differing == "measured_report":
        monkeypatch.setattr(clusters, "carrying_digest", lambda: "0" * 64)
    else:
        identities["gap"] = replace(own, code="0" * 64, files={**own.files, "experiments/gap.py": "0" * 64})
    opened = cluster_executor(read_cluster(scheduler), "cpu", None, identities)
    with pytest.raises(ReportError, match="no worker may measure this"), opened as executor:
        executor.gather()
    said = capsys.readouterr().err
    assert f"{os.uname().nodename} is left out: it would measure with another {differing}" in said


def test_a_worker_without_the_gpu_that_is_asked_for_is_refused_by_name(scheduler, monkeypatch, capsys):
    opened = cluster_executor(read_cluster(scheduler), "cuda", "nvidia-h200", {})
    with pytest.raises(ReportError, match="no worker may measure this"), opened as executor:
        executor.gather()
    assert "left out: it has no CUDA device, and this is of nvidia-h200" in capsys.readouterr().err


DRIVER = """
import signal
import sys
import batches
from pathlib import Path
from measured_report.measuring.cluster import cluster_executor
from measured_report.measuring.cluster_address import read_cluster
from measured_report.measuring.scheduler import Scheduler
from measured_report.editions.project import Project
from types import SimpleNamespace

if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.default_int_handler)  # whatever whoever runs the tests makes of it
    cluster, root, log = sys.argv[1:]
    toy = SimpleNamespace(project=Project("1.4.0", root=Path(root)))
    with cluster_executor(read_cluster(cluster), "cpu", None, {}) as executor:
        executor.gather()
        Scheduler([batches.run_of(toy, batches.slow_after(log, "ab"))], executor).run()
"""


@pytest.mark.parametrize("sent", [signal.SIGINT, signal.SIGKILL])
def test_measuring_that_is_stopped_leaves_nothing_running_and_goes_on_where_it_was(toy, log, folder, scheduler, sent):
    own = "local:2" if sent == signal.SIGKILL else scheduler
    driver = subprocess.Popen(
        [sys.executable, "-c", DRIVER, own, str(toy.project.root), str(log)],
        cwd=folder, stderr=subprocess.PIPE, start_new_session=True,
    )  # fmt: skip
    while "begin slow" not in log.read_text():
        assert driver.poll() is None, driver.stderr.read().decode()
        time.sleep(0.02)
    driver.send_signal(sent)
    stopped = time.monotonic()
    driver.communicate()
    assert not running(log) and time.monotonic() - stopped < 5.0
    log.write_text("")
    assert not Scheduler([run_of(toy, batches.slow_after(str(log), "ab", 0.0))], LocalExecutor(machine("cpu"))).run()
    assert begun(log) == ["slow"] and [row["case"] for row in rows_of(toy)] == ["a", "b", "slow"]


@pytest.fixture
def hosts(tmp_path, monkeypatch):
    """A file with a host that ssh reaches: this one, through a server of the test's own."""
    key, home = asyncssh.generate_private_key("ssh-ed25519"), tmp_path / "home" / ".ssh"
    home.mkdir(parents=True)
    key.write_private_key(home / "id")
    (home / "id").chmod(0o600)
    (home / "authorized").write_bytes(key.export_public_key())
    loop, started = asyncio.new_event_loop(), threading.Event()

    async def answer(process: asyncssh.SSHServerProcess) -> None:
        number, *_ = process.get_extra_info("peername")[1:]
        environment = {**os.environ, "SSH_CONNECTION": f"127.0.0.1 {number} 127.0.0.1 22"}
        own = await asyncio.create_subprocess_shell(
            f"echo What this shell says to all who come; {process.command}",
            stdin=-1,
            stdout=-1,
            stderr=-1,
            env=environment,
            start_new_session=True,
        )
        await process.redirect(own.stdin, own.stdout, own.stderr)
        status = await own.wait()
        await process.stdout.drain()  # what was said last goes out before the channel is closed
        await process.stderr.drain()
        process.exit(status)

    async def serve() -> None:
        options = {"server_host_keys": [key], "authorized_client_keys": str(home / "authorized")}
        server = await asyncssh.listen("127.0.0.1", 0, process_factory=answer, **options)
        port = server.sockets[0].getsockname()[1]
        (home / "known_hosts").write_text(f"[127.0.0.1]:{port} {key.export_public_key().decode()}")
        (home / "config").write_text(f"Host node\n  HostName 127.0.0.1\n  Port {port}\n  IdentityFile {home}/id\n")
        started.set()

    monkeypatch.setenv("HOME", str(home.parent))
    loop.create_task(serve())
    thread = threading.Thread(target=loop.run_forever, daemon=True)
    thread.start()
    started.wait()
    (tmp_path / "hosts.txt").write_text("node\n")
    yield tmp_path / "hosts.txt"
    loop.call_soon_threadsafe(loop.stop)
    thread.join()


@pytest.mark.parametrize("kind", ["local", "ssh"])
def test_finding_6_only_who_has_the_key_of_the_run_is_let_in(hosts, kind):
    before = {*Path("/tmp").glob("measured-report-*.pem")}
    with clusters.connected(read_cluster(f"ssh:{hosts}" if kind == "ssh" else "local:1"), "cpu") as client:
        keys = {*Path("/tmp").glob("measured-report-*.pem")} - before
        assert [key.stat().st_mode & 0o777 for key in keys] == [0o600] * (kind == "ssh")
        client.wait_for_workers(1, timeout=20.0)
        assert client.submit(os.getpid).result() != os.getpid()
        addresses = [client.scheduler.address, *client.nthreads()]
        assert all(re.match(r"tls://127\.0\.0\.1:", address) for address in addresses)
        for address in addresses:
            place = "127.0.0.1", int(address.rpartition(":")[2])
            unknown = ssl.create_default_context()
            unknown.check_hostname, unknown.verify_mode = False, ssl.CERT_NONE
            with socket.create_connection(place, timeout=5.0) as plain, pytest.raises((ssl.SSLError, ConnectionError)):
                unknown.wrap_socket(plain).recv(1)
        for command in Path("/proc").glob("[0-9]*/cmdline"):
            assert b"PRIVATE KEY" not in command.read_bytes()
    assert not any(key.exists() for key in keys)
