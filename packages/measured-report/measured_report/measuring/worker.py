"""What a Dask worker does: it has processes, for a GPU, a share of one, or a core each, and hands them batches.

The processes last, since each takes seconds to load the simulator and its kernels; one that fails, is killed, or
measures what is wanted no longer makes room for a new one. The worker itself never loads the simulator, so that it
always answers. Dask's nanny cannot do this: it would start a worker for each process, which does not answer while it
compiles, and knows neither of what must be alone on a host nor of what may share a GPU.
"""

import os
import pickle
import platform
import select
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

from measured_report.editions.devices import slug
from measured_report.files.root import ROOT
from measured_report.measuring.executors import Host
from measured_report.measuring.machine import kind_of, said
from measured_report.measuring.outcome import BatchOutcome, Done, Failed, Lost

POLL_S = 0.25
"""How soon it is noticed that a batch is wanted no longer."""
MPS, MPS_FOLDER = "CUDA_MPS_PIPE_DIRECTORY", "/tmp/nvidia-mps"
"""Where processes find the daemon through which they share a GPU, by NVIDIA's documentation of MPS, and by default."""
SHARE_COUNT = 6
"""Processes that share a GPU: a few worlds leave most of it idle."""
CORES_EACH = 2
"""Processor cores that there have to be for each of them."""


@dataclass
class Process:
    """A worker process, and the lock of whoever asks it something."""

    device: str
    settings: Mapping[str, str]
    program: subprocess.Popen | None = None
    lock: threading.Lock = field(default_factory=threading.Lock)

    def ask(self, call: bytes, is_wanted: Callable[[], bool]) -> BatchOutcome:
        """Return what the process answers to a call, or how it was lost."""
        with self.lock:
            if self.program is None or self.program.poll() is not None:
                command = [sys.executable, "-m", "measured_report.measuring.process", self.device, str(os.getpid())]
                settings = {**os.environ, **self.settings, "TQDM_DISABLE": "1"}
                pipe = subprocess.PIPE
                self.program = subprocess.Popen(
                    command, cwd=ROOT, env=settings, start_new_session=True, stdin=pipe, stdout=pipe
                )
            try:
                pickle.dump(call, self.program.stdin, protocol=pickle.HIGHEST_PROTOCOL)
                self.program.stdin.flush()
                while not select.select([self.program.stdout], [], [], POLL_S)[0]:
                    if not is_wanted():
                        self.end()
                        return Lost("it is wanted no longer")
                found = pickle.load(self.program.stdout)
            except (OSError, EOFError, pickle.UnpicklingError):
                return Lost(self.end())
            if isinstance(found, Failed):
                self.end()  # an error may have left the device in any state
            return found

    def end(self) -> str:
        """End the process with all that it has started, and say how it had ended, if it had."""
        program, self.program = self.program, None
        if program is None:
            return ""
        with suppress(subprocess.TimeoutExpired):
            program.wait(timeout=0.1)
        code = program.poll()
        with suppress(OSError), program:  # which closes its pipes and waits for it
            os.killpg(program.pid, signal.SIGKILL)
        killed = code is not None and code < 0
        return f"its process was killed by {signal.Signals(-code).name}" if killed else f"its process ended with {code}"


_processes: dict[tuple[str, str], Process] = {}
_processes_lock = threading.Lock()


def introduce(device: str, processor: str | None, thread_count: int, call: bytes) -> tuple[str, Host | Lost | Failed]:
    """Say what this worker is called and, once its first process has made a call, what processes it has.

    A GPU must be called ``processor`` in a label, unless that is None; there may be ``thread_count`` processes.
    """
    node, there = platform.node(), gpus() if device == "cuda" else []
    names = [uuid for uuid, name in there if processor in (None, slug(name))]
    shared = shared_processes(names) if names else []
    if device == "cpu":
        names = [str(number) for number in range(thread_count)]
    if not names:
        others = ", ".join(sorted({name for _, name in there}))
        return node, Failed(f"it has {others or 'no CUDA device'}, and this is of {processor or device}")
    found = measure(device, names[0], call)
    if isinstance(found, Done):
        return node, Host(node, kind_of(found.machine), names[:thread_count], shared[:thread_count])
    return node, found


def shared_processes(gpus: Sequence[str]) -> list[str]:
    """Name processes that share GPUs, those of one far apart; none where no daemon is there that lets them do so."""
    if not (Path(os.environ.get(MPS, MPS_FOLDER)) / "control").exists():
        return []
    count = min(SHARE_COUNT, (os.cpu_count() or 1) // len(gpus) // CORES_EACH)
    return [f"{gpu}/{number}" for number in range(count) for gpu in gpus] if count > 1 else []


def measure(device: str, name: str, call: bytes) -> BatchOutcome:
    """Let a process measure a batch, as long as that is wanted."""
    gpu, is_shared, _ = name.partition("/")
    settings = {"CUDA_VISIBLE_DEVICES": gpu} if device == "cuda" else {}
    if settings and not is_shared:
        settings[MPS] = "/nonexistent"  # only one that shares its GPU finds the daemon
    with _processes_lock:
        mine = _processes.setdefault((device, name), Process(device, settings))
    return mine.ask(call, _still_wanted())


def _still_wanted() -> Callable[[], bool]:
    """Ask whether the task that this is called in is still waited for: its client may be gone, or have dropped it."""
    from distributed import get_worker

    worker = get_worker()
    key = worker.get_current_task()

    def is_wanted() -> bool:
        task = worker.state.tasks.get(key)
        return task is not None and task.state == "executing"

    return is_wanted


async def stop() -> None:
    """End all processes: of what the worker is asked, only what is asynchronous is not waited for."""
    for process in list(_processes.values()):
        process.end()


def gpus() -> list[tuple[str, str]]:
    """List UUID and name of each GPU that this worker may use."""
    listing = said("nvidia-smi", "--query-gpu=index,uuid,name", "--format=csv,noheader").splitlines()
    found = [tuple(part.strip() for part in line.split(",", 2)) for line in listing if line.count(",") > 1]
    allowed = os.environ.get("CUDA_VISIBLE_DEVICES")
    names = None if allowed is None else {name.strip() for name in allowed.split(",")}
    return [(uuid, name) for index, uuid, name in found if names is None or names & {index, uuid}]
