"""A worker process, which measures batches one after the other: ``python -m measured_report.measuring.process``.

It reads calls from its input and answers on its output. When its input ends, whoever started it is gone, and it ends
with all that it has started; so it does when nothing is asked of it for a while.
"""

import os
import pickle
import select
import signal
import sys
import threading
import time
from collections.abc import Mapping
from pathlib import Path

from measured_report.files.errors import ReportError
from measured_report.measuring.host import host
from measured_report.measuring.machine import machine
from measured_report.measuring.outcome import BatchOutcome, Failed, run_batch
from measured_report.records.code import unchanged_files
from measured_report.records.identity import Identity, changes, files_digest, identity_of

IDLE_S = 120.0
POLL_S = 0.25
"""How soon it is noticed that whoever started it is gone."""


def prepare(device: str, identities: Mapping[str, Identity], carrying: str) -> None:
    """Make ready what sections need on this host, for all its processes.

    ReportError where they can't be measured, or not by these ``identities`` and the ``carrying_digest`` that is asked.
    """
    with unchanged_files():
        here = {section: identity_of(section, wanted.profile) for section, wanted in identities.items()}
    words = [word for section, wanted in identities.items() for word in changes(here[section], wanted)]
    if carrying != carrying_digest():
        words.append("measured_report")
    if words:
        raise ReportError(f"it would measure with another {'; '.join(dict.fromkeys(words)):.200}")
    host().prepare(device)


def carrying_digest() -> str:
    """Digest the code that hands out batches, which has to be the same on all hosts, though no record depends on it."""
    folder = Path(__file__).parent
    return files_digest(folder.glob("*.py"), folder)


def main(device: str, parent: int) -> None:
    threading.Thread(target=_end_with, args=(parent,), daemon=True).start()
    calls, answers = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what is printed must not come between the answers
    while select.select([calls], [], [], IDLE_S)[0]:
        try:
            call = pickle.load(calls)
        except EOFError:
            break
        pickle.dump(_answer(device, call), answers, protocol=pickle.HIGHEST_PROTOCOL)
        answers.flush()
    os.killpg(0, signal.SIGKILL)


def _end_with(parent: int) -> None:
    """End while it measures, too."""
    while os.getppid() == parent:
        time.sleep(POLL_S)
    os.killpg(0, signal.SIGKILL)


def _answer(device: str, call: bytes) -> BatchOutcome:
    try:
        here = machine(device)  # what the device settles has to be settled before a section is imported
        batch = pickle.loads(call)
    except Exception as error:  # the device or the code is not there
        return Failed(" ".join(str(error).split()))
    return run_batch(batch, here)


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
