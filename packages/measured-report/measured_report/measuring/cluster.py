"""Measure batches on the workers of a Dask scheduler."""

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
    """Open a pool for batches that share the workers and one for exclusive batches."""
    with connected(cluster) as client:
        own = introduce()
        for worker in client.run(introduce).values():
            for key in ("commit", "packages"):
                if worker[key] != own[key] or worker[key].endswith("-dirty"):
                    raise ReportError(
                        f"CLUSTER={cluster}: a worker has {key} {worker[key]}, "
                        f"but this machine has {own[key]}: commit your changes "
                        "and install the same packages on both"
                    )
        submit = client.get_executor(pure=False).submit
        limits = (sys.maxsize, 1)
        yield [
            SimpleNamespace(submit=submit, killed=KilledWorker, limit=limit)
            for limit in limits
        ]


@contextmanager
def connected(cluster: str) -> Iterator[Client]:
    """Connect to a scheduler; raise ReportError if no worker answers in 2 minutes."""
    if cluster.startswith("tcp:"):
        warning = (
            "anyone who can reach this port can run code here and on the workers: see "
            "docs/cluster.md"
        )
        print(f"CLUSTER={cluster}: {warning}", file=sys.stderr, flush=True)
    for name in ("distributed", "distributed.client"):  # Dask sets the levels of both
        # This program prints the errors itself.
        logging.getLogger(name).setLevel(logging.CRITICAL)
    try:
        client = Client(cluster)
        client.wait_for_workers(1, timeout=120)
    # Dask raises MemoryError if the port belongs to another program, and TypeError if a
    # certificate is missing.
    except (MemoryError, OSError, TypeError, ValueError, RuntimeError) as error:
        message = " ".join(str(error).split()) or type(error).__name__
        raise ReportError(
            f"CLUSTER={cluster}: cannot reach any worker ({message:.200}): check "
            "the address and that workers run"
        ) from None
    with client:
        yield client


def introduce() -> dict[str, str]:
    """Return the commit, the packages and the device of this process."""
    report = current()
    report.host.be_quiet()
    cards = report.accelerator.accelerators()
    return {
        "commit": str(commit()),
        "packages": str(package_versions(report.settings)),
        "device": slug(cards[0].name) if cards else "cpu",
    }


def card_of(cluster: str) -> str:
    """Return the device of all workers in a cluster, in the form that labels use."""
    with connected(cluster) as client:
        names = {worker["device"] for worker in client.run(introduce).values()}
    if len(names) > 1:
        raise ReportError(
            f"CLUSTER={cluster}: its workers have {' and '.join(sorted(names))}: "
            "use workers with one kind of device"
        )
    return names.pop()
