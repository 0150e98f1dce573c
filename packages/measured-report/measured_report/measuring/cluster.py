"""Clusters: batches that the workers of a Dask scheduler measure."""

import logging
import platform
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from distributed import Client, KilledWorker

from measured_report.files.config import report as current
from measured_report.files.errors import ReportError
from measured_report.measuring.machine import slug
from measured_report.records.code import digest_of
from measured_report.records.identity import files_digest, package_versions


@contextmanager
def connected(cluster: str) -> Iterator[Client]:
    """Connect to a scheduler; raise ReportError if it, or a worker, cannot be reached."""
    if cluster.startswith("tcp:"):
        message = "whoever reaches that port may run code on its workers and here (docs/cluster.md)"
        print(f"CLUSTER={cluster}: {message}", file=sys.stderr, flush=True)
    for name in ("distributed", "distributed.client"):  # whose level Dask sets as well
        logging.getLogger(name).setLevel(logging.CRITICAL)  # errors are printed here
    try:
        client = Client(cluster)
        client.wait_for_workers(1, timeout=120)
    # A port of another program may make Dask raise MemoryError, a missing certificate TypeError.
    except (MemoryError, OSError, TypeError, ValueError, RuntimeError) as error:
        message = " ".join(str(error).split()) or type(error).__name__
        raise ReportError(
            f"CLUSTER={cluster}: no workers could be reached: {message:.200}"
        ) from None
    with client:
        yield client


class ClusterPool:
    """Submits to the workers of a cluster, at most ``limit`` batches at once."""

    lost: type[Exception] = KilledWorker

    def __init__(self, client: Client, limit: int):
        self.executor = client.get_executor(pure=False)
        self.limit = limit
        self.digest = digest_here()

    def submit(self, function: Callable[..., Any], *arguments: Any) -> Future[Any]:
        return self.executor.submit(call_here, self.digest, function, *arguments)


def cluster_pools(client: Client, device: str) -> tuple[ClusterPool, ClusterPool]:
    """Return a pool for what shares the workers, and one for what is measured alone, once kernels are compiled."""
    client.run(current().host.prepare, device)
    return ClusterPool(client, sys.maxsize), ClusterPool(client, 1)


def call_here(digest: str, function: Callable[..., Any], *arguments: Any) -> Any:
    """Call a function in this worker, unless it has other code."""
    current().host.be_quiet()
    if digest != digest_here():
        raise ReportError(f"{platform.node()} has other code or packages")
    return function(*arguments)


def digest_here() -> str:
    """Digest the files that measuring may read, and the versions of packages."""
    report = current()
    folders = [report.root / "experiments", report.root / "assets"]
    folders += [*report.root.glob("packages/*"), Path(__file__).parents[1]]
    code = []
    for folder in folders:
        files = [path for path in folder.rglob("*.*") if path.suffix != ".pyc"]
        code.append(files_digest(files, folder))
    return digest_of([*code, package_versions(report.settings)])


def card_here() -> str:
    """Return the name of this worker's accelerator."""
    cards = current().accelerator.accelerators()
    return slug(cards[0].name) if cards else "no device"


def card_of(cluster: str) -> str:
    """Return the name of the accelerator that all workers of a cluster have, as labels have it."""
    with connected(cluster) as client:
        names = {*client.run(card_here).values()}
    if len(names) > 1 or "no device" in names:
        raise ReportError(
            f"CLUSTER={cluster}: its workers have {' and '.join(sorted(names))}: start all on one kind, or set DEVICE=cpu"
        )
    return names.pop()
