"""What a Dask worker does: it has processes, for a GPU, a share of one, or a core each, and hands them batches.

The processes last, since each takes seconds to load the simulator and its kernels; one that fails, is killed, or
measures what is wanted no longer makes room for a new one. The worker itself never loads the simulator, so that it
always answers. Dask's nanny cannot do this: it would start a worker for each process, which does not answer while it
compiles, and knows neither of what must be alone on a host nor of what may share a GPU.
"""

import os
import pickle
import platform
import re
import select
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Mapping
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
SHARE_COUNT = 16
"""Processes that share a GPU, with a core each: a few worlds leave most of it idle."""
SHARED_MIB, ALONE_MIB, BESIDE_MIB = 1 << 10, 64 << 10, 5 << 9
"""Memory of a GPU that there has to be for each of these, for a process for what must be alone, which keeps what it has
prepared, and for each more of those: of a report few batches need more.
"""


@dataclass(frozen=True)
class Gpu:
    uuid: str
    name: str
    memory_mib: int


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


def introduce(
    device: str, processor: str | None, thread_count: int, call: bytes
) -> tuple[str, list[Host] | Lost | Failed]:
    """Say what this worker is called and, once its first process has made a call, what processes it has.

    A GPU must be called ``processor`` in a label, unless that is None; there may be ``thread_count`` processes.
    """
    node, there = platform.node(), gpus() if device == "cuda" else []
    mine = [gpu for gpu in there if processor in (None, slug(gpu.name))][:thread_count]
    if device == "cuda" and not mine:
        others = ", ".join(sorted({gpu.name for gpu in there}))
        return node, Failed(f"it has {others or 'no CUDA device'}, and this is of {processor or device}")
    numbers = [str(number) for number in range(thread_count)]
    each = [processes_of(gpu, len(mine)) for gpu in mine] or [(numbers, numbers)]
    found = measure(device, each[0][1][0], call)
    if not isinstance(found, Done):
        return node, found
    count, kind = thread_count // len(each), kind_of(found.machine)
    return node, [Host(node, kind, together[:count], alone[:count]) for together, alone in each]


def processes_of(gpu: Gpu, gpu_count: int) -> tuple[list[str], list[str]]:
    """Name the processes of one of so many GPUs: for what may run beside others, and for what must be alone there.

    The first share the GPU where a daemon is there that lets them do so. Of the others one at a time measures.
    """
    count = min(SHARE_COUNT, (os.cpu_count() or 1) // gpu_count)
    beside_count = max(0, gpu.memory_mib - count * SHARED_MIB - ALONE_MIB) // BESIDE_MIB
    alone = [gpu.uuid, *(f"{gpu.uuid}:{number + 1}" for number in range(beside_count))]
    if count > 1 and (Path(os.environ.get(MPS, MPS_FOLDER)) / "control").exists():
        return [f"{gpu.uuid}/{number}" for number in range(count)], alone
    return [gpu.uuid], alone


def measure(device: str, name: str, call: bytes) -> BatchOutcome:
    """Let a process measure a batch, as long as that is wanted."""
    settings = {"CUDA_VISIBLE_DEVICES": re.split("[/:]", name)[0]} if device == "cuda" else {}
    if settings and "/" not in name:
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
        if program := process.program:
            with suppress(OSError):
                os.killpg(program.pid, signal.SIGKILL)


def gpus() -> list[Gpu]:
    """List the GPUs that this worker may use."""
    query = "--query-gpu=index,uuid,memory.total,name"
    listing = said("nvidia-smi", query, "--format=csv,noheader,nounits").splitlines()
    found = [[part.strip() for part in line.split(",", 3)] for line in listing if line.count(",") > 2]
    allowed = os.environ.get("CUDA_VISIBLE_DEVICES")
    names = None if allowed is None else {name.strip() for name in allowed.split(",")}
    there = [each for each in found if names is None or names & {*each[:2]}]
    # What shares memory with the processor may not say how much it has.
    return [Gpu(uuid, name, int(size) if size.isdecimal() else 0) for _, uuid, size, name in there]
