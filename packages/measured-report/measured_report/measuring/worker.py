"""What a worker does: it has a process for each of its slots, a GPU or a share of the CPU, and hands it batches.

The processes last, since each takes seconds to load the simulator and its kernels; one that fails, is killed, or
measures what is wanted no longer makes room for a new one. The worker itself never loads the simulator, so that it
always answers.
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

from measured_report import ROOT
from measured_report.editions.devices import slug
from measured_report.measuring.outcome import Done, Failed, Lost

POLL_S = 0.25
"""How soon it is noticed that a batch is wanted no longer."""
MPS, MPS_FOLDER = "CUDA_MPS_PIPE_DIRECTORY", "/tmp/nvidia-mps"
"""Where processes find the daemon through which they share a GPU, by NVIDIA's documentation of MPS, and by default."""
NOWHERE = "/nonexistent"
SHARE_COUNT = 6
"""Processes that share a GPU: a few worlds leave most of it idle."""
CORES_EACH = 2
"""Processor cores that there have to be for each of them."""


@dataclass
class Slot:
    """A process, and the lock of whoever asks it something."""

    device: str
    settings: Mapping[str, str]
    process: subprocess.Popen | None = None
    lock: threading.Lock = field(default_factory=threading.Lock)

    def ask(self, call: bytes, is_wanted: Callable[[], bool]) -> Done | Lost | Failed:
        """What the process answers to a call, or how it was lost."""
        with self.lock:
            if self.process is None or self.process.poll() is not None:
                self._begin()
            try:
                pickle.dump(call, self.process.stdin, protocol=pickle.HIGHEST_PROTOCOL)
                self.process.stdin.flush()
                while not select.select([self.process.stdout], [], [], POLL_S)[0]:
                    if not is_wanted():
                        self.end()
                        return Lost("it is wanted no longer")
                found = pickle.load(self.process.stdout)
            except (OSError, EOFError, pickle.UnpicklingError):
                return Lost(self.end())
            if isinstance(found, Failed):
                self.end()  # an error may have left the device in any state
            return found

    def _begin(self) -> None:
        self.process = subprocess.Popen(
            [sys.executable, "-m", "measured_report.measuring.process", self.device],
            cwd=ROOT,
            env={**os.environ, **self.settings, "TQDM_DISABLE": "1"},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            start_new_session=True,
        )

    def end(self) -> str:
        """End the process with all that it has started; how it had ended, if it had."""
        process, self.process = self.process, None
        if process is None:
            return ""
        with suppress(subprocess.TimeoutExpired):
            process.wait(timeout=0.1)
        code = process.poll()
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        for pipe in (process.stdin, process.stdout):
            with suppress(OSError):
                pipe.close()
        killed = code is not None and code < 0
        return f"its process was killed by {signal.Signals(-code).name}" if killed else f"its process ended with {code}"


_slots: dict[tuple[str, str], Slot] = {}
_slots_lock = threading.Lock()


@dataclass(frozen=True)
class Place:
    """A worker as it introduces itself."""

    node: str
    slots: Sequence[str]
    shared: Sequence[str]
    """See ``study.Host``."""
    greeting: Done | Lost | Failed


def introduce(device: str, processor: str | None, address: str, thread_count: int, call: bytes) -> Place:
    """What slots the worker at ``address`` has, and what the process of the first says to ``call``.

    Args:
        device: ``cuda`` or ``cpu``.
        processor: What a GPU must be called in a label; None for any.
    """
    node, there = platform.node(), gpus() if device == "cuda" else []
    names = [uuid for uuid, name in there if processor in (None, slug(name))]
    if device == "cpu":
        names = [f"{address}#{number}" for number in range(thread_count)]
    if not names:
        others = ", ".join(sorted({name for _, name in there}))
        return Place(node, [], [], Failed(f"it has {others or 'no CUDA device'}, and this is of {processor or device}"))
    return Place(node, names, shared_slots(names) if device == "cuda" else [], measure(device, names[0], call))


def shared_slots(gpus: Sequence[str]) -> list[str]:
    """Slots that share GPUs, those of one GPU far apart; none where no daemon is there that lets processes do so."""
    if not (Path(os.environ.get(MPS, MPS_FOLDER)) / "control").exists():
        return []
    count = min(SHARE_COUNT, (os.cpu_count() or 1) // len(gpus) // CORES_EACH)
    return [f"{gpu}/{number}" for number in range(count) for gpu in gpus] if count > 1 else []


def measure(device: str, slot: str, call: bytes) -> Done | Lost | Failed:
    """Let a slot measure a batch, as long as that is wanted."""
    with _slots_lock:
        mine = _slots.setdefault((device, slot), Slot(device, _settings(slot) if device == "cuda" else {}))
    return mine.ask(call, _still_wanted())


def _settings(slot: str) -> dict[str, str]:
    """The environment of a process that measures on a GPU: only one that shares it finds the daemon."""
    gpu, is_shared, _ = slot.partition("/")
    return {"CUDA_VISIBLE_DEVICES": gpu} | ({} if is_shared else {MPS: NOWHERE})


def _still_wanted() -> Callable[[], bool]:
    """Whether the task that this is called in is still waited for: its client may be gone, or have dropped it."""
    from distributed import get_worker

    worker = get_worker()
    key = worker.get_current_task()

    def is_wanted() -> bool:
        task = worker.state.tasks.get(key)
        return task is not None and task.state == "executing"

    return is_wanted


async def stop() -> None:
    """End all processes: of what the worker is asked, only what is asynchronous is not waited for."""
    for slot in list(_slots.values()):
        slot.end()


def gpus() -> list[tuple[str, str]]:
    """UUID and name of each GPU that this worker may use."""
    query = ["nvidia-smi", "--query-gpu=index,uuid,name", "--format=csv,noheader"]
    try:
        listing = subprocess.run(query, capture_output=True, text=True, check=False).stdout
    except OSError:
        return []
    found = [tuple(part.strip() for part in line.split(",", 2)) for line in listing.splitlines() if line.count(",") > 1]
    allowed = os.environ.get("CUDA_VISIBLE_DEVICES")
    names = None if allowed is None else {name.strip() for name in allowed.split(",")}
    return [(uuid, name) for index, uuid, name in found if names is None or names & {index, uuid}]
