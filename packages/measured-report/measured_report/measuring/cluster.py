"""Pools of the workers of a Dask cluster: who may measure, and by which code."""

import asyncio
import contextlib
import logging
import pickle
import platform
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from pathlib import Path
from typing import Any

import dask
from distributed import Client, KilledWorker, Nanny, Scheduler, Security, SpecCluster
from distributed.core import rpc

from measured_report.files.config import cached_in_report, report
from measured_report.files.errors import ReportError, UsageError
from measured_report.files.processes import KILLED
from measured_report.measuring.accelerator import Accelerator, accelerator
from measured_report.measuring.batch import BatchError
from measured_report.measuring.host import host
from measured_report.measuring.machine import slug
from measured_report.measuring.section import GONE
from measured_report.records.code import digest_of
from measured_report.records.identity import files_digest, package_versions

SHARED, EXCLUSIVE = "shared", "exclusive"  # resources: of a worker that shares its device, of one that measures times
SETTINGS = {
    "distributed.scheduler.allowed-failures": 2,  # a batch is tried three times
    "distributed.scheduler.no-workers-timeout": "120s",
    "distributed.deploy.lost-worker-timeout": "120s",  # a killed one that is not back by then never is
    "distributed.worker.memory.terminate": False,
    # Its web servers can't be left out; they listen on the host alone, and have nothing to say.
    **{f"distributed.{side}.http.routes": [] for side in ("scheduler", "worker")},
}
LOCAL = {"host": "127.0.0.1", "protocol": "tls", "dashboard": False, "dashboard_address": "127.0.0.1:0"}
CONNECT_S, SILENT_S = 30.0, 120.0
OTHER_CODE = "has other code or packages"


@contextlib.contextmanager
def connected(cluster: str, device: str, count: int = 1) -> Iterator[Client]:
    """Connect to the scheduler that ``CLUSTER`` names, or start one here; ReportError where that can't be."""
    for name in ("distributed", "distributed.client"):  # whose level Dask sets as well
        logging.getLogger(name).setLevel(logging.CRITICAL)  # what is wrong is said here
    with dask.config.set(SETTINGS), contextlib.ExitStack() as stack:
        try:
            if cluster == "local":
                client = Client(stack.enter_context(_on_this_host(device, count)))
            else:
                if cluster.startswith("tcp:"):
                    message = "whoever reaches that port may run code on its workers and here (docs/cluster.md)"
                    print(f"CLUSTER={cluster}: {message}", file=sys.stderr, flush=True)
                asyncio.run(asyncio.wait_for(_answer(cluster), CONNECT_S))
                client = Client(cluster, timeout=CONNECT_S)
            stack.enter_context(client)
            client.wait_for_workers(1)
        except (MemoryError, OSError, TypeError, ValueError, RuntimeError, asyncio.TimeoutError) as error:
            # MemoryError: what is no scheduler may name any size. TypeError: no certificate is configured.
            message = " ".join(str(error).split()) or type(error).__name__
            raise ReportError(f"CLUSTER={cluster}: no workers could be started or reached: {message:.200}") from None
        yield client


async def _answer(address: str) -> None:
    """Wait for a scheduler to answer: a client waits without end for one that hangs."""
    async with rpc(address, connection_args=Security().get_connection_args("client")) as scheduler:
        await scheduler.identity()


def _on_this_host(device: str, count: int) -> SpecCluster:
    """Start so many workers on the CPU, or as many as share each accelerator, and one for what is exclusive."""
    security = Security.temporary()  # others on this host are not let in
    cards = [] if device == "cpu" else accelerators()
    workers: dict[Any, dict[str, Any]] = {number: _worker(SHARED, security) for number in range(0 if cards else count)}
    for index, card in enumerate(cards):
        for number in range(accelerator().share_count(card, len(cards))):
            workers[f"{index}/{number}"] = _worker(SHARED, security, **card.settings)
    alone = {**cards[0].settings, **accelerator().ALONE} if cards else {}
    workers[EXCLUSIVE] = _worker(EXCLUSIVE, security, **alone)
    scheduler = {"cls": Scheduler, "options": {**LOCAL, "security": security}}
    return SpecCluster(workers, scheduler, security=security, silence_logs=logging.CRITICAL, name="local")


def _worker(resource: str, security: Security, **settings: str) -> dict[str, Any]:
    options = {"nthreads": 1, "resources": {resource: 1}, "memory_limit": 0, "silence_logs": logging.CRITICAL}
    return {"cls": Nanny, "options": {**LOCAL, **options, "env": settings, "security": security}}


@contextlib.contextmanager
def cluster_pools(cluster: str, device: str, processor: str | None, count: int) -> Iterator[tuple[Any, Any]]:
    """Open pools for what shares a device and for what is exclusive; ReportError where workers or devices are unfit."""
    with connected(cluster, device, count) as client:
        workers = client.scheduler_info(n_workers=-1)["workers"].values()
        for resource in (SHARED, EXCLUSIVE):
            if not any(resource in worker["resources"] for worker in workers):
                raise ReportError(f"CLUSTER={cluster}: no worker was started with --resources {resource}=1")
        try:
            nodes = client.run(introduce, device, processor, digest_here())
            firsts = {node: address for address, node in nodes.items()}.values()
            client.gather([client.submit(host().prepare, device, workers=[worker], pure=False) for worker in firsts])
        except (KilledWorker, OSError):
            raise ReportError(f"CLUSTER={cluster}: {KILLED}") from None
        yield ClusterPool(client, SHARED), ClusterPool(client, EXCLUSIVE)


class ClusterPool:
    """Submit to those workers of a cluster that have a resource."""

    lost: type[Exception] = KilledWorker  # Dask has tried again by itself
    limit = sys.maxsize  # it also keeps what waits

    def __init__(self, client: Client, resource: str):
        self._client = client
        self._executor = client.get_executor(pure=False, resources={resource: 1})
        self._digest = digest_here()

    def submit(self, function: Callable[..., Any], *arguments: Any) -> Future[Any]:
        try:
            call = pickle.dumps((function, arguments))
        except Exception as error:  # is of this batch, as where the process of a host's pool can't read it
            future: Future[Any] = Future()
            future.set_exception(error)
            return future
        return self._executor.submit(call_here, self._digest, call)

    def check(self) -> None:
        """Raise ReportError where the scheduler no longer answers, which Dask itself waits for without end."""
        try:
            self._client.sync(self._client.scheduler.ncores, callback_timeout=SILENT_S)
        except (OSError, asyncio.TimeoutError):
            raise ReportError(GONE) from None


def call_here(digest: str, call: bytes) -> Any:
    """Call a function in this worker, unless it came later than others and has other code."""
    host().be_quiet()  # before a section is imported
    if digest != digest_here():
        raise BatchError(f"{platform.node()} {OTHER_CODE}")
    function, arguments = pickle.loads(call)
    return function(*arguments)


def accelerators() -> list[Accelerator]:
    """List those of the worker that is asked."""
    return accelerator().accelerators()


def introduce(device: str, processor: str | None, digest: str) -> str:
    """Return what this worker's host is called; ReportError where it has other code or another accelerator."""
    host().be_quiet()
    node = platform.node()
    if digest != digest_here():
        raise ReportError(f"{node} {OTHER_CODE}")
    try:
        card, _ = host().card(device)
    except ReportError as error:
        raise ReportError(f"{node}: {error}") from None
    if processor and slug(card or "") != processor:
        raise ReportError(f"{node} has {card or f'no {accelerator().KIND.upper()} device'}, and this is of {processor}")
    return node


@cached_in_report
def digest_here() -> str:
    """Digest the files that measuring may read, and the versions of packages."""
    root = report().root
    folders = [root / "experiments", root / "assets", *root.glob("packages/*"), Path(__file__).parents[1]]
    code = [files_digest((path for path in folder.rglob("*.*") if path.suffix != ".pyc"), folder) for folder in folders]
    return digest_of([*code, package_versions()])


def card_of(cluster: str) -> str:
    """Return what the card that most workers of a cluster have is called in a label; UsageError where there is none."""
    with connected(cluster, accelerator().KIND) as client:
        names = sorted(card.name for cards in client.run(accelerators).values() for card in cards)
    if not names:
        kind = accelerator().KIND.upper()
        raise UsageError(f"CLUSTER={cluster}: its workers have no {kind} device; DEVICE=cpu measures on their CPUs")
    return slug(max(names, key=names.count))
