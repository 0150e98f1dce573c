"""The workers of a Dask cluster as an executor: which of them may measure, and what was lost.

Dask starts workers, carries bytes and notices who is gone. What runs where is the scheduler's to decide, since some
batches must be alone on their host.
"""

import argparse
import asyncio
import contextlib
import logging
import os
import pickle
import secrets
import shlex
import sys
import time
import uuid
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import asyncssh
import dask
import distributed
from distributed import Client, Future, KilledWorker, LocalCluster, Security, SpecCluster
from distributed.deploy import ssh

from measured_report.files.errors import ReportError
from measured_report.files.root import ROOT
from measured_report.measuring import worker
from measured_report.measuring.batch import Batch
from measured_report.measuring.cluster_address import ClusterAddress, read_cluster
from measured_report.measuring.executors import Host, Task
from measured_report.measuring.outcome import BatchOutcome, Failed, Lost
from measured_report.measuring.process import carrying_digest, prepare
from measured_report.records.columns import UNPRINTABLE
from measured_report.records.identity import Identity

POLL_S = 0.5
SETTINGS = {
    "distributed.scheduler.allowed-failures": 0,
    "distributed.scheduler.worker-ttl": "60s",  # a worker always answers: its processes measure
    "distributed.worker.memory.terminate": False,
    # Dask ends for good what has no worker so long after it lost one, even where the next one is just starting.
    "distributed.deploy.lost-worker-timeout": "365d",
    # Its web servers can't be left out; they listen on the host alone, and have nothing to say.
    "distributed.scheduler.http.routes": [],
    "distributed.worker.http.routes": [],
}
NO_DASHBOARD = {"dashboard": False, "dashboard_address": "127.0.0.1:0"}
QUIET = logging.CRITICAL  # what is wrong is said here
CONNECT_S = 30.0


@contextlib.contextmanager
def connected(cluster: ClusterAddress, device: str) -> Iterator[Client]:
    """A client of the cluster, which is started if it is not there; ReportError where that can't be."""
    logging.getLogger("distributed").setLevel(QUIET)
    with dask.config.set(SETTINGS), contextlib.ExitStack() as stack:
        try:
            if cluster.scheduler:
                if cluster.is_open:
                    said = "whoever reaches that port may run code on its workers and here (docs/cluster.md)"
                    print(f"CLUSTER={cluster.asked}: {said}", file=sys.stderr, flush=True)
                client = Client(cluster.scheduler, timeout=CONNECT_S)
            else:
                started = _over_ssh(cluster) if cluster.hosts else _on_this_host(cluster, device)
                client = Client(stack.enter_context(started))
        except (OSError, ValueError, LookupError, RuntimeError, asyncssh.Error) as error:
            said = " ".join(str(error).split()) or type(error).__name__
            raise ReportError(f"CLUSTER={cluster.asked}: no workers could be started or reached: {said:.200}") from None
        yield stack.enter_context(client)


def _on_this_host(cluster: ClusterAddress, device: str) -> LocalCluster:
    gpus = worker.gpus() if device == "cuda" else []
    thread_count = count = cluster.process_count or (len(gpus) if device == "cuda" else os.cpu_count() or 1)
    settings = {}
    if device == "cuda":
        if count > len(gpus):
            raise ReportError(f"CLUSTER={cluster.asked}: this host has {len(gpus)} GPUs, and {count} are asked for")
        settings["CUDA_VISIBLE_DEVICES"] = ",".join(gpu.uuid for gpu in gpus[:count])
        thread_count = count * max(len(names) for gpu in gpus[:count] for names in worker.processes_of(gpu, count))
    options = {"memory_limit": 0, "dashboard_address": None, "silence_logs": QUIET, "env": settings}
    options |= {"protocol": "tls", "security": Security.temporary()}  # others on this host are not let in
    return LocalCluster(n_workers=1, threads_per_worker=thread_count, host="127.0.0.1", **options)


@contextlib.contextmanager
def _over_ssh(cluster: ClusterAddress) -> Iterator[SpecCluster]:
    """Start processes that know each other by a key made for this run, and listen where ssh reaches their host.

    The key is a file on each host that only its user can read: what is on a command line can be seen by all.
    """
    security, place = Security.temporary(), f"/tmp/measured-report-{secrets.token_hex(16)}.pem"
    hosts = [host for host, _ in cluster.hosts]
    roles = [f"{role}.{what}" for role in ("client", "scheduler", "worker") for what in ("key", "cert")]
    files = {f"distributed.comm.tls.{name}": place for name in ("ca-file", *roles)}
    try:
        pem = security.tls_client_key + security.tls_client_cert
        told = asyncio.run(_tell(hosts, f'umask 077; cat > {place}; echo "$SSH_CONNECTION"', pem))
        addresses = [said.split()[-2] for said in told]  # whatever a shell there says before
        # The scheduler outlives this process for a while where nobody could stop it.
        scheduling = {"protocol": "tls", "port": 0, "idle_timeout": "60s", **NO_DASHBOARD}
        working = {"memory_limit": 0, "death_timeout": str(CONNECT_S), **NO_DASHBOARD}
        each: list[dict[str, Any]] = [
            {"address": host, "connect_options": {}, "remote_python": _python_in(folder), "kwargs": {"host": address}}
            for (host, folder), address in zip(cluster.hosts, addresses, strict=True)
        ]
        scheduler = {"cls": ssh.Scheduler, "options": {**each[0], "kwargs": {**each[0]["kwargs"], **scheduling}}}
        workers = {
            number: {"cls": ssh.Worker, "options": {**one, "kwargs": {**one["kwargs"], **working}}}
            for number, one in enumerate(each)
        }
        settings = {"distributed.comm.require-encryption": True, **files}
        with dask.config.set(settings), SpecCluster(workers, scheduler, security=security, name="ssh") as started:
            yield started
    finally:
        with contextlib.suppress(OSError, asyncssh.Error):  # a host that is gone keeps the key of what is no more
            asyncio.run(_tell(hosts, f"rm -f {place}"))


async def _tell(hosts: Iterable[str], command: str, text: str = "") -> list[str]:
    """Run a command on each host, with a text as its input, and return what it prints."""

    async def tell(host: str) -> str:
        async with asyncssh.connect(host, connect_timeout=CONNECT_S) as connection:
            return str((await connection.run(command, input=text, check=True)).stdout)

    return await asyncio.gather(*map(tell, hosts))


def _python_in(folder: str) -> str:
    """The words that start a host's Python in the project's folder, and with it on its path, for the shell there."""
    root, python = Path(folder or ROOT), Path(sys.executable)
    if folder:
        python = root / (python.relative_to(ROOT) if python.is_relative_to(ROOT) else ".venv/bin/python")
    rooms = [root, *(root / package.relative_to(ROOT) for package in sorted(ROOT.glob("packages/*")))]
    return shlex.join(["env", "-C", str(root), f"PYTHONPATH={':'.join(map(str, rooms))}", str(python)])


@contextlib.contextmanager
def cluster_executor(
    cluster: ClusterAddress, device: str, processor: str | None, identities: Mapping[str, Identity]
) -> Iterator["ClusterExecutor"]:
    """Open an executor of those of the cluster's workers that measure each section by its identity.

    They prepare at once; ``gather`` waits for that. A GPU must be called ``processor`` in a label, unless that is None.
    """
    with connected(cluster, device) as client:
        patience_s = None if cluster.scheduler else CONNECT_S
        executor = ClusterExecutor(client, device, processor, identities, patience_s)
        if cluster.scheduler and not client.nthreads():
            print(f"waiting for workers at {cluster.scheduler}", file=sys.stderr, flush=True)
        try:
            yield executor
        finally:
            executor.stop()


class ClusterExecutor:
    """The workers of a cluster; see ``executors.Executor``."""

    def __init__(
        self,
        client: Client,
        device: str,
        processor: str | None,
        identities: Mapping[str, Identity],
        patience_s: float | None,
    ):
        self.client, self.device, self.processor, self.patience_s = client, device, processor, patience_s
        self._preparing = _call(Batch("prepare", prepare, (device, identities, carrying_digest())))
        self._workers: dict[str, Sequence[Host]] = {}
        """By address; none of those that are left out or have not yet introduced themselves."""
        self._running: dict[Future, tuple[Task | None, str]] = {}
        """With the address of the worker; what is no task is an introduction."""
        self._look_around()

    @property
    def hosts(self) -> list[Host]:
        """The hosts that may measure; of several workers on one the first does so."""
        first: dict[str, Sequence[Host]] = {}
        for hosts in filter(None, list(self._workers.values())):
            first.setdefault(hosts[0].name, hosts)
        return [host for hosts in first.values() for host in hosts]

    def gather(self) -> None:
        """Wait for the first worker that may measure; ReportError when all are left out, or none is there in time."""
        begun = time.monotonic()
        while not self.hosts:
            list(self.wait())
            if self._workers and not self._running and not self.hosts:
                raise ReportError("no worker may measure this")
            if not self._workers and self.patience_s and time.monotonic() - begun > self.patience_s:
                raise ReportError(f"no worker is there after {self.patience_s:.0f} s")

    def start(self, task: Task, process: tuple[str, str]) -> None:
        address = next(address for address, hosts in self._workers.items() if hosts and hosts[0].name == process[0])
        self._submit(task, address, worker.measure, self.device, process[1], _call(task.batch))

    def wait(self) -> Iterator[tuple[Task, BatchOutcome]]:
        """Yield what has ended within a moment."""
        with contextlib.suppress(distributed.TimeoutError):  # the built-in one only from Python 3.11 on
            if self._running:
                distributed.wait(list(self._running), timeout=POLL_S, return_when="FIRST_COMPLETED")
            else:
                time.sleep(POLL_S)
        self._look_around()
        for future, (task, address) in list(self._running.items()):
            if future.done() or address not in self._workers:
                del self._running[future]
                outcome = _outcome(future) if future.done() else Lost("its worker is gone")
                if task:
                    yield task, outcome
                elif address in self._workers:
                    self._meet(address, *(outcome if isinstance(outcome, tuple) else (address, outcome)))
                future.cancel()

    def stop(self) -> None:
        """Drop what runs: the workers end its processes as soon as they know, and all others as well."""
        for future in self._running:
            future.cancel()
        with contextlib.suppress(Exception):  # a scheduler that is gone has no workers
            self.client.run(worker.stop, wait=False)

    def _look_around(self) -> None:
        """Notice who has come and who is gone, and let the new ones introduce themselves."""
        if self.client.status != "running":
            raise ReportError("the scheduler is gone; what is finished is kept")
        there = self.client.nthreads()
        self._workers = {address: host for address, host in self._workers.items() if address in there}
        for address in there.keys() - self._workers.keys():
            self._introduce(address)

    def _introduce(self, address: str) -> None:
        self._workers[address] = []
        thread_count = self.client.nthreads().get(address, 1)
        self._submit(None, address, worker.introduce, self.device, self.processor, thread_count, self._preparing)

    def _meet(self, address: str, name: str, found: Sequence[Host] | BatchOutcome) -> None:
        """Take a worker that has introduced itself, unless it has said why it can't measure."""
        if isinstance(found, list):
            self._workers[address] = found
        elif isinstance(found, Lost):
            self._introduce(address)
        elif isinstance(found, Failed):
            hint = "" if name != address else "; a worker is started in the folder of the project"
            said = UNPRINTABLE.sub("?", f"{name} is left out: {found.reason:.300}{hint}")
            print(" ".join(said.split()), file=sys.stderr, flush=True)

    def _submit(self, task: Task | None, address: str, function: Callable, *arguments: Any) -> None:
        """Let one worker call a function, once."""
        key = f"{task.name if task else 'introduction'}-{uuid.uuid4().hex}"
        future = self.client.submit(function, *arguments, key=key, workers=[address], pure=False)
        self._running[future] = task, address


def _call(batch: Batch) -> bytes:
    return pickle.dumps(batch, protocol=pickle.HIGHEST_PROTOCOL)


def _outcome(future: Future) -> Any:
    """What a worker has returned, or why it has not."""
    if future.status == "finished":
        return future.result()
    error = future.exception() if future.status == "error" else None
    if error is None or isinstance(error, KilledWorker):
        return Lost("its worker is gone")
    return Failed(" ".join(f"{type(error).__name__}: {error}".split()))


def main() -> int:
    """Print the GPU that most worker processes of a cluster have."""
    parser = argparse.ArgumentParser(prog="python -m measured_report.measuring.cluster", description=main.__doc__)
    parser.add_argument("cluster", metavar="CLUSTER")
    try:
        with connected(read_cluster(parser.parse_args().cluster), "cuda") as client:
            client.wait_for_workers(1)
            names = sorted(gpu.name for found in client.run(worker.gpus).values() for gpu in found)
    except ReportError as error:
        print(error, file=sys.stderr)
        return 2
    print(max(names, key=names.count, default=""))
    return 0


if __name__ == "__main__":
    sys.exit(main())
