"""Workers of a Dask cluster as a crew: which of them may measure, what runs where, and what was lost.

Dask starts workers, carries bytes and notices who is gone. What runs where is decided here, since some batches must be
alone on their host.
"""

import argparse
import contextlib
import logging
import os
import pickle
import shlex
import sys
import time
import uuid
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import dask
import distributed
from distributed import Client, Future, KilledWorker, LocalCluster, SSHCluster

from measured_report import ROOT, ReportError
from measured_report.measuring import worker as slots
from measured_report.measuring.course import Task
from measured_report.measuring.machine import kind_of
from measured_report.measuring.outcome import Done, Failed, Lost
from measured_report.measuring.process import SELF, Greeting, greet
from measured_report.measuring.scheduler import Host, Place
from measured_report.measuring.where import Cluster
from measured_report.records.identity import Identity, changes, identity_of

POLL_S = 0.5
SETTINGS = {
    "distributed.scheduler.allowed-failures": 0,
    "distributed.scheduler.worker-ttl": "60s",  # a worker always answers: its processes measure
    "distributed.worker.memory.terminate": False,
    # Dask ends for good what has no worker so long after it lost one, even where the next one is just starting.
    "distributed.deploy.lost-worker-timeout": "365d",
}
QUIET = logging.CRITICAL
"""What is wrong is said here."""
CONNECT_S = 30.0
ORPHANED_S = 60.0
"""How long a scheduler that was started for this study outlives it, if nobody could stop it."""


@contextlib.contextmanager
def connected(cluster: Cluster, device: str) -> Iterator[Client]:
    """A client of the cluster, which is started if it is not there; ReportError where that can't be."""
    logging.getLogger("distributed").setLevel(QUIET)
    with dask.config.set(SETTINGS), contextlib.ExitStack() as stack:
        try:
            if cluster.scheduler:
                client = Client(cluster.scheduler, timeout=CONNECT_S)
            else:
                started = _over_ssh(cluster) if cluster.hosts else _on_this_host(cluster, device)
                client = Client(stack.enter_context(started))
        except (OSError, ValueError, RuntimeError) as error:  # asyncssh's errors are among them
            said = " ".join(str(error).split()) or type(error).__name__
            raise ReportError(f"CLUSTER={cluster.asked}: no workers could be started or reached: {said:.200}") from None
        yield stack.enter_context(client)


def _on_this_host(cluster: Cluster, device: str) -> LocalCluster:
    there = len(slots.gpus()) if device == "cuda" else os.cpu_count() or 1
    count = cluster.process_count or there
    if device == "cuda" and count > there:
        raise ReportError(f"CLUSTER={cluster.asked}: this host has {there} GPUs, and {count} are asked for")
    options = {"threads_per_worker": count, "memory_limit": 0, "dashboard_address": None, "silence_logs": QUIET}
    if device == "cuda":
        gpus = [uuid for uuid, _ in slots.gpus()[:count]]
        options["env"] = {"CUDA_VISIBLE_DEVICES": ",".join(gpus)}
        options["threads_per_worker"] = max(count, len(slots.shared_slots(gpus)))
    return LocalCluster(n_workers=1, host="127.0.0.1", **options)


def _over_ssh(cluster: Cluster) -> SSHCluster:
    hosts = [host for host, _ in cluster.hosts]
    pythons = [_python_in(folder) for _, folder in cluster.hosts]
    return SSHCluster(
        [hosts[0], *hosts],
        remote_python=[pythons[0], *pythons],
        worker_options={"memory_limit": 0, "death_timeout": str(CONNECT_S)},
        scheduler_options={"port": 0, "dashboard": False, "idle_timeout": f"{ORPHANED_S:.0f}s"},
    )


def _python_in(folder: str) -> str:
    """The words that start a host's Python with the project on its path, for the shell there."""
    python = sys.executable
    if folder:
        inside = Path(sys.executable).is_relative_to(ROOT)
        python = str(Path(folder) / (Path(sys.executable).relative_to(ROOT) if inside else ".venv/bin/python"))
    return f"{shlex.quote(f'PYTHONPATH={folder or ROOT}')} {shlex.quote(python)}"


@contextlib.contextmanager
def crew_of(
    cluster: Cluster, device: str, processor: str | None, identities: Mapping[str, Identity], profile: str
) -> Iterator["Workers"]:
    """The cluster's workers, as far as they may measure this.

    Args:
        processor: What a GPU must be called in a label; None for any.
        identities: What each section must be measured by.
    """
    with connected(cluster, device) as client:
        crew = Workers(client, device, processor, identities, profile)
        if cluster.scheduler and not client.nthreads():
            print(f"waiting for workers at {cluster.scheduler}", file=sys.stderr, flush=True)
        try:
            crew.gather(None if cluster.scheduler else CONNECT_S)
            yield crew
        finally:
            crew.stop()


@dataclass
class Worker:
    """A worker that may measure."""

    address: str
    node: str
    kind: tuple
    slots: Sequence[str]
    shared: Sequence[str]
    thread_count: int


class Workers:
    """See ``study.Crew``."""

    def __init__(
        self, client: Client, device: str, processor: str | None, identities: Mapping[str, Identity], profile: str
    ):
        self.client, self.device, self.processor, self.profile = client, device, processor, profile
        self.identities = {**identities, SELF: identity_of(SELF, profile)}
        self._introducing: dict[Future, str] = {}
        self._known: dict[str, Worker | None] = {}
        """By address; None for those that are left out or have not yet introduced themselves."""
        self._threads: dict[str, int] = {}
        self._running: dict[Future, tuple[Task, str]] = {}

    @property
    def hosts(self) -> list[Host]:
        return [Host(worker.node, worker.kind, names, shared) for worker, names, shared in self._shares()]

    def _shares(self) -> list[tuple[Worker, list[str], list[str]]]:
        """The slots of each worker: of a GPU that several on one host see the first has it."""
        taken: set[Place] = set()
        found = []
        for worker in list(self._known.values()):
            if worker:
                free, shared = (
                    [slot for slot in names if (worker.node, slot) not in taken][: worker.thread_count]
                    for names in (worker.slots, worker.shared)
                )
                taken |= {(worker.node, slot) for slot in (*free, *shared)}
                found.append((worker, free, shared))
        return found

    def gather(self, patience_s: float | None) -> None:
        """Wait for the first worker that may measure; ReportError when all are left out, or none is there in time."""
        begun = time.monotonic()
        while not self.hosts:
            self._look_around()
            if self.hosts:
                return
            if self._threads and not self._introducing and self._known.keys() == self._threads.keys():
                raise ReportError("no worker may measure this")
            if not self._threads and patience_s and time.monotonic() - begun > patience_s:
                raise ReportError(f"no worker is there after {patience_s:.0f} s")
            time.sleep(0.1)

    def start(self, task: Task, place: Place) -> None:
        address = next(
            worker.address
            for worker, names, shared in self._shares()
            if worker.node == place[0] and place[1] in (*names, *shared)
        )
        call = pickle.dumps((task.batch.function, task.batch.arguments), protocol=pickle.HIGHEST_PROTOCOL)
        future = self._submit(address, task.name, slots.measure, self.device, place[1], call)
        self._running[future] = task, address

    def wait(self) -> Iterator[tuple[Task, Done | Lost | Failed]]:
        """What has ended within a moment."""
        pending = [*self._running, *self._introducing]
        with contextlib.suppress(distributed.TimeoutError):  # the built-in one only from Python 3.11 on
            if pending:
                distributed.wait(pending, timeout=POLL_S, return_when="FIRST_COMPLETED")
            else:
                time.sleep(POLL_S)
        self._look_around()
        for future, (task, address) in list(self._running.items()):
            if future.done() or address not in self._threads:
                del self._running[future]
                yield task, _outcome(future) if future.done() else Lost("its worker is gone")
                future.cancel()

    def stop(self) -> None:
        """Drop what runs: the workers end its processes as soon as they know, and all others as well."""
        for future in [*self._running, *self._introducing]:
            future.cancel()
        with contextlib.suppress(Exception):  # a scheduler that is gone has no workers
            self.client.run(slots.stop, wait=False)

    def _look_around(self) -> None:
        """Notice who has come and who is gone, and what the new ones say."""
        if self.client.status != "running":
            raise ReportError("the scheduler is gone; what is finished is kept")
        self._threads = dict(self.client.nthreads())
        self._known = {address: worker for address, worker in self._known.items() if address in self._threads}
        for address, count in self._threads.items():
            if address not in self._known:
                self._known[address] = None
                call = pickle.dumps((greet, (self.device, [*self.identities][:-1], self.profile)))
                who = (self.device, self.processor, address, count)
                future = self._submit(address, "greeting", slots.introduce, *who, call)
                self._introducing[future] = address
        for future, address in list(self._introducing.items()):
            if future.done() or address not in self._threads:
                del self._introducing[future]
                if address in self._threads:
                    self._meet(address, future)

    def _meet(self, address: str, future: Future) -> None:
        if future.status != "finished":
            said = " ".join(str(future.exception()).split()) if future.status == "error" else future.status
            self._leave_out(address, f"{said:.200}; a worker is started in the folder of the project")
            return
        place: slots.Place = future.result()
        if isinstance(place.greeting, Lost):
            del self._known[address]  # it is asked again
        elif reason := self._refusal(place):
            self._leave_out(place.node, reason)
        else:
            kind = kind_of(place.greeting.machine)
            known = Worker(address, place.node, kind, place.slots, place.shared, self._threads[address])
            self._known[address] = known

    def _refusal(self, place: slots.Place) -> str:
        """Why a worker may not measure; empty when it may."""
        if isinstance(place.greeting, Failed):
            return place.greeting.reason
        greeting: Greeting = pickle.loads(place.greeting.content)
        differing = [changes(greeting.identities[name], identity) for name, identity in self.identities.items()]
        if found := list(dict.fromkeys(word for words in differing for word in words)):
            return f"it would measure with another {'; '.join(found):.200}"
        return ""

    def _leave_out(self, name: str, reason: str) -> None:
        print(f"{name} is left out: {reason}", file=sys.stderr, flush=True)

    def _submit(self, address: str, name: str, function, *arguments) -> Future:
        """Let one worker call a function, once."""
        only = {"workers": [address], "allow_other_workers": False, "pure": False, "retries": 0}
        return self.client.submit(function, *arguments, key=f"{name}-{uuid.uuid4().hex}", **only)


def _outcome(future: Future) -> Done | Lost | Failed:
    if future.status == "finished":
        return future.result()
    error = future.exception() if future.status == "error" else None
    if error is None or isinstance(error, KilledWorker):
        return Lost("its worker is gone")
    return Failed(" ".join(f"{type(error).__name__}: {error}".split()))


def main() -> int:
    """Print the GPU that most slots of a cluster have."""
    from measured_report.measuring.where import read_cluster

    parser = argparse.ArgumentParser(prog="python -m measured_report.measuring.cluster", description=main.__doc__)
    parser.add_argument("cluster", metavar="CLUSTER")
    try:
        with connected(read_cluster(parser.parse_args().cluster), "cuda") as client:
            client.wait_for_workers(1)
            names = [name for found in client.run(slots.gpus).values() for _, name in found]
    except ReportError as error:
        print(error, file=sys.stderr)
        return 2
    print(Counter(sorted(names)).most_common(1)[0][0] if names else "")
    return 0


if __name__ == "__main__":
    sys.exit(main())
