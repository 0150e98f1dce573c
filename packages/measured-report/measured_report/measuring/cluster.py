"""Clusters: batches that the workers of a Dask scheduler measure."""

import logging
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from types import SimpleNamespace

from distributed import Client, KilledWorker

from measured_report.files.config import report as current
from measured_report.files.errors import ReportError
from measured_report.measuring.machine import commit, slug
from measured_report.records.identity import package_versions


@contextmanager
def cluster_pools(cluster: str) -> Iterator[list[SimpleNamespace]]:
    """Open a pool for batches that share the workers, and one for those that are measured alone."""
    with connected(cluster) as client:
        here = introduce()
        for worker in client.run(introduce).values():
            for what in ("commit", "packages"):
                if worker[what] != here[what] or worker[what].endswith("-dirty"):
                    raise ReportError(
                        f"CLUSTER={cluster}: {what} of a worker: {worker[what]}; here: {here[what]}: commit changes, and install the same"
                    )
        submit = client.get_executor(pure=False).submit
        limits = sys.maxsize, 1
        yield [
            SimpleNamespace(submit=submit, lost=KilledWorker, limit=limit)
            for limit in limits
        ]


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


def introduce() -> dict[str, str]:
    """Return the code, the packages and the device of this process."""
    report = current()
    report.host.be_quiet()
    cards = report.accelerator.accelerators()
    return {
        "commit": str(commit()),
        "packages": str(package_versions(report.settings)),
        "device": slug(cards[0].name) if cards else "cpu",
    }


def card_of(cluster: str) -> str:
    """Return the device that all workers of a cluster have, as labels name it."""
    with connected(cluster) as client:
        names = {worker["device"] for worker in client.run(introduce).values()}
    if len(names) > 1:
        raise ReportError(
            f"CLUSTER={cluster}: its workers have {' and '.join(sorted(names))}: start all on one kind"
        )
    return names.pop()
