"""Pools of the workers of a Dask cluster: who may measure, and by which code."""

import logging
import pickle
import platform
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import dask
from distributed import Client, KilledWorker, Nanny, Scheduler, Security, SpecCluster

from measured_report.files.config import Report
from measured_report.files.config import report as current
from measured_report.files.errors import ReportError, UsageError
from measured_report.files.processes import KILLED
from measured_report.measuring.accelerator import Accelerator
from measured_report.measuring.batch import BatchError
from measured_report.measuring.machine import slug
from measured_report.records.code import digest_of
from measured_report.records.identity import files_digest, package_versions

SHARED, EXCLUSIVE = (
    "shared",
    "exclusive",
)  # resources: of a worker that shares its device, of one that measures times
SETTINGS = {
    "distributed.scheduler.allowed-failures": 2,  # a batch is tried three times
    "distributed.scheduler.no-workers-timeout": "120s",
    "distributed.deploy.lost-worker-timeout": "120s",  # a killed one that is not back by then never is
    "distributed.worker.memory.terminate": False,
    # Its web servers can't be left out; they listen on the host alone, and have nothing to say.
    **{f"distributed.{side}.http.routes": [] for side in ("scheduler", "worker")},
}
LOCAL = {
    "host": "127.0.0.1",
    "protocol": "tls",
    "dashboard": False,
    "dashboard_address": "127.0.0.1:0",
}
OTHER_CODE = "has other code or packages"


@contextmanager
def connected(
    cluster: str, device: str, report: Report, count: int = 1
) -> Iterator[Client]:
    """Connect to the scheduler that ``CLUSTER`` names, or start one here; ReportError where that can't be."""
    for name in ("distributed", "distributed.client"):  # whose level Dask sets as well
        logging.getLogger(name).setLevel(logging.CRITICAL)  # errors are printed here
    with dask.config.set(SETTINGS), ExitStack() as stack:
        try:
            if cluster == "local":
                client = Client(
                    stack.enter_context(_on_this_host(device, report, count))
                )
            else:
                if cluster.startswith("tcp:"):
                    message = "whoever reaches that port may run code on its workers and here (docs/cluster.md)"
                    print(f"CLUSTER={cluster}: {message}", file=sys.stderr, flush=True)
                client = Client(cluster)
            stack.enter_context(client)
            client.wait_for_workers(1)
        except (MemoryError, OSError, TypeError, ValueError, RuntimeError) as error:
            # MemoryError: what is no scheduler may name any size. TypeError: no certificate is configured.
            message = " ".join(str(error).split()) or type(error).__name__
            raise ReportError(
                f"CLUSTER={cluster}: no workers could be started or reached: {message:.200}"
            ) from None
        yield client


def _on_this_host(device: str, report: Report, count: int) -> SpecCluster:
    """Start so many workers on the CPU, or as many as share each accelerator, and one for what is exclusive."""
    security = Security.temporary()  # others on this host are not let in
    accelerator = report.accelerator
    cards = [] if device == "cpu" else accelerator.accelerators()
    workers: dict[Any, dict[str, Any]] = {
        number: _worker(SHARED, security) for number in range(0 if cards else count)
    }
    for index, card in enumerate(cards):
        for number in range(accelerator.share_count(card, len(cards))):
            workers[f"{index}/{number}"] = _worker(SHARED, security, **card.settings)
    alone = {**cards[0].settings, **accelerator.ALONE} if cards else {}
    workers[EXCLUSIVE] = _worker(EXCLUSIVE, security, **alone)
    scheduler = {"cls": Scheduler, "options": {**LOCAL, "security": security}}
    return SpecCluster(
        workers,
        scheduler,
        security=security,
        silence_logs=logging.CRITICAL,
        name="local",
    )


def _worker(resource: str, security: Security, **settings: str) -> dict[str, Any]:
    options = {
        "nthreads": 1,
        "resources": {resource: 1},
        "memory_limit": 0,
        "silence_logs": logging.CRITICAL,
    }
    return {
        "cls": Nanny,
        "options": {**LOCAL, **options, "env": settings, "security": security},
    }


@contextmanager
def cluster_pools(
    cluster: str, device: str, processor: str | None, report: Report, count: int
) -> Iterator[tuple[Any, Any]]:
    """Open pools for what shares a device and for what is exclusive; ReportError where workers or devices are unfit."""
    with connected(cluster, device, report, count) as client:
        workers = client.scheduler_info(n_workers=-1)["workers"].values()
        for resource in (SHARED, EXCLUSIVE):
            if not any(resource in worker["resources"] for worker in workers):
                raise ReportError(
                    f"CLUSTER={cluster}: no worker was started with --resources {resource}=1"
                )
        digest = digest_here(report)
        try:
            nodes = client.run(introduce, device, processor, digest)
            firsts = {node: address for address, node in nodes.items()}.values()
            prepare = report.host.prepare
            client.gather(
                [
                    client.submit(prepare, device, workers=[worker], pure=False)
                    for worker in firsts
                ]
            )
        except (KilledWorker, OSError):
            raise ReportError(f"CLUSTER={cluster}: {KILLED}") from None
        yield (
            ClusterPool(client, SHARED, digest),
            ClusterPool(client, EXCLUSIVE, digest),
        )


class ClusterPool:
    """Submit to those workers of a cluster that have a resource."""

    lost: type[Exception] = KilledWorker  # Dask has tried again by itself
    limit = sys.maxsize  # it also keeps what waits

    def __init__(self, client: Client, resource: str, digest: str):
        self._executor = client.get_executor(pure=False, resources={resource: 1})
        self._digest = digest

    def submit(self, function: Callable[..., Any], *arguments: Any) -> Future[Any]:
        try:
            call = pickle.dumps((function, arguments))
        except Exception as error:  # is of this batch, as where the process of a host's pool can't read it
            future: Future[Any] = Future()
            future.set_exception(error)
            return future
        return self._executor.submit(call_here, self._digest, call)


def call_here(digest: str, call: bytes) -> Any:
    """Call a function in this worker, unless it came later than others and has other code."""
    report = current()
    report.host.be_quiet()  # before a section is imported
    if digest != digest_here(report):
        raise BatchError(f"{platform.node()} {OTHER_CODE}")
    function, arguments = pickle.loads(call)
    return function(*arguments)


def accelerators() -> list[Accelerator]:
    """List those of the worker that is asked."""
    return list(current().accelerator.accelerators())


def introduce(device: str, processor: str | None, digest: str) -> str:
    """Return what this worker's host is called; ReportError where it has other code or another accelerator."""
    report = current()
    report.host.be_quiet()
    node = platform.node()
    if digest != digest_here(report):
        raise ReportError(f"{node} {OTHER_CODE}")
    try:
        card, _ = report.host.card(device)
    except ReportError as error:
        raise ReportError(f"{node}: {error}") from None
    if processor and slug(card or "") != processor:
        kind = report.accelerator.KIND.upper()
        raise ReportError(
            f"{node} has {card or f'no {kind} device'}, and this is of {processor}"
        )
    return node


def digest_here(report: Report) -> str:
    """Digest the files that measuring may read, and the versions of packages."""
    root = report.root
    folders = [
        root / "experiments",
        root / "assets",
        *root.glob("packages/*"),
        Path(__file__).parents[1],
    ]
    code = [
        files_digest(
            (path for path in folder.rglob("*.*") if path.suffix != ".pyc"), folder
        )
        for folder in folders
    ]
    return digest_of([*code, package_versions(report.settings)])


def card_of(cluster: str, report: Report) -> str:
    """Return what the card that most workers of a cluster have is called in a label; UsageError where there is none."""
    kind = report.accelerator.KIND
    with connected(cluster, kind, report) as client:
        names = sorted(
            card.name for cards in client.run(accelerators).values() for card in cards
        )
    if not names:
        of_cpu = "DEVICE=cpu measures on their CPUs"
        raise UsageError(
            f"CLUSTER={cluster}: its workers have no {kind.upper()} device; {of_cpu}"
        )
    return slug(max(names, key=names.count))
