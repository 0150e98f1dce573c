"""A process that measures batches for a worker, one after the other: ``python -m measured_report.measuring.process``.

It reads calls from its input and answers on its output. When its input ends, whoever started it is gone, and it ends
with all that it has started; so it does when nothing is asked of it for a while.
"""

import os
import pickle
import queue
import signal
import sys
import threading
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import BinaryIO

from measured_report.measuring.host import host
from measured_report.measuring.machine import machine
from measured_report.measuring.outcome import Done, Failed, run_batch
from measured_report.records.identity import Identity, identity_of

IDLE_S = 120.0
SELF = "slot"
"""The name under which the code of the slots themselves has an identity."""


@dataclass(frozen=True)
class Greeting:
    """What a host has to say before it measures."""

    identities: Mapping[str, Identity]
    """What sections would be measured by there, and by which code of the slots."""


def greet(device: str, sections: Sequence[str], profile: str) -> Greeting:
    """Say what would measure here, and prepare that for all processes of this host.

    Raises:
        ReportError: It can't be measured here.
    """
    identities = {section: identity_of(section, profile) for section in (*sections, SELF)}
    host().prepare(device)
    return Greeting(identities)


def main() -> None:
    calls, answers = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what is printed must not come between the answers
    inbox: queue.SimpleQueue[bytes] = queue.SimpleQueue()
    threading.Thread(target=receive, args=(calls, inbox), daemon=True).start()
    while True:
        try:
            call = inbox.get(timeout=IDLE_S)
        except queue.Empty:
            break
        pickle.dump(answer(sys.argv[1], call), answers, protocol=pickle.HIGHEST_PROTOCOL)
        answers.flush()
    os.killpg(0, signal.SIGKILL)


def receive(calls: BinaryIO, inbox: queue.SimpleQueue) -> None:
    """Read calls until there are no more."""
    while True:
        try:
            inbox.put(pickle.load(calls))
        except EOFError:
            os.killpg(0, signal.SIGKILL)


def answer(device: str, call: bytes) -> Done | Failed:
    try:
        here = machine(device)
        host().device(device)  # what it settles has to be settled before a section is imported
        function, arguments = pickle.loads(call)
    except Exception as error:  # the device or the code is not there
        return Failed(" ".join(str(error).split()))
    return run_batch(function, arguments, here)


if __name__ == "__main__":
    main()
