"""The address of a cluster: processes of this host, hosts that ssh reaches, or a Dask scheduler that is there."""

import re
import stat
from dataclasses import dataclass
from pathlib import Path

from measured_report.files.errors import UsageError

HOST = re.compile(r"[A-Za-z0-9]([A-Za-z0-9._-]*[A-Za-z0-9])?")
SCHEDULER = re.compile(r"(?:tcp|tls)://(?:[A-Za-z0-9._-]+|\[[0-9a-fA-F:.]+\]):([0-9]{1,5})")
LOOPBACK = re.compile(r"tcp://(127\.[0-9.]+|localhost|\[::1\]):")
PROCESS_LIMIT = 256
BYTE_LIMIT = 1 << 20
"""Of a list of hosts."""


@dataclass(frozen=True)
class ClusterAddress:
    """Who measures, as ``CLUSTER`` says it."""

    asked: str
    process_count: int | None = None
    """How many processes of this host, where that was said."""
    hosts: tuple[tuple[str, str], ...] = ()
    """Hosts to log in to, and the folder of the project on each; empty where it is as here."""
    scheduler: str = ""
    """Address of Dask's scheduler, where one is there already."""

    @property
    def is_open(self) -> bool:
        """Whether anyone who reaches its scheduler is let in."""
        return self.scheduler.startswith("tcp://") and not LOOPBACK.match(self.scheduler)

    @property
    def is_here(self) -> bool:
        """Whether it is this host alone."""
        return not self.hosts and not self.scheduler


def read_cluster(asked: str) -> ClusterAddress:
    """Read what ``CLUSTER`` says; UsageError, in one line, for what makes no sense."""
    kind, _, rest = asked.partition(":")
    if asked == "local":
        return ClusterAddress(asked)
    if kind == "local":
        if not (rest.isascii() and rest.isdigit() and 0 < int(rest[:6]) <= PROCESS_LIMIT):
            raise UsageError(f"CLUSTER={asked:.80}: {rest!r:.40} is no number of processes from 1 to {PROCESS_LIMIT}")
        return ClusterAddress(asked, process_count=int(rest))
    if kind == "ssh":
        return ClusterAddress(asked, hosts=_read_hosts(asked, Path(rest)))
    if (found := SCHEDULER.fullmatch(asked)) and 0 < int(found[1]) < 65536:
        return ClusterAddress(asked, scheduler=asked)
    raise UsageError(f"CLUSTER={asked:.80} names no workers; use local, local:2, ssh:hosts.txt or tcp://scheduler:8786")


def _read_hosts(asked: str, path: Path) -> tuple[tuple[str, str], ...]:
    """Read a file of hosts: a line each, as ssh knows it, and the folder of the project there where it is another."""
    try:
        found = path.stat()
        if not stat.S_ISREG(found.st_mode) or found.st_size > BYTE_LIMIT:  # a pipe or a device may have no end
            raise ValueError
        text = path.read_text(encoding="utf-8")
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else "is no text"
        raise UsageError(f"CLUSTER={asked:.80}: {path}: {reason}") from None
    lines = [line.partition("#")[0].split(maxsplit=1) for line in text.splitlines()]
    hosts = {words[0]: words[1].strip() if len(words) > 1 else "" for words in lines if words}
    for host, folder in hosts.items():
        if not HOST.fullmatch(host) or (folder and not folder.startswith("/")):
            fault = "is no line of a host, and of the project's folder on it"
            raise UsageError(f"CLUSTER={asked:.80}: {host!r:.80} {fault}")
    if len(hosts) < max(1, sum(map(bool, lines))):
        raise UsageError(f"CLUSTER={asked:.80}: {path} has {'a host twice' if hosts else 'no host'}; one a line")
    return tuple(hosts.items())
