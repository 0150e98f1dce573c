"""Test the lock that keeps other processes of this host from disturbing timed runs."""

import multiprocessing
import os
from contextlib import redirect_stderr

import pytest

from measured_report.measuring import batch


def hold(exclusive: bool, pipe: int, end) -> None:
    with (
        open(pipe, "w", buffering=1) as said,
        redirect_stderr(said),
        batch.device_lock(exclusive=exclusive),
    ):
        said.write("began\n")
        end.wait()
        said.write("ended\n")


@pytest.mark.parametrize(("first", "count"), [(True, 1), (False, 2)])
def test_what_measures_times_has_nothing_beside_it(tmp_path, monkeypatch, first, count):
    """Test that exclusive batches wait for shared ones and the other way round, and
    that two shared ones run together.
    """
    monkeypatch.setattr(batch, "LOCK", tmp_path / "lock")
    context = multiprocessing.get_context("fork")
    read, write = os.pipe()
    lines, end = os.fdopen(read), context.Event()

    def starts(exclusive: bool) -> str:
        context.Process(target=hold, args=(exclusive, write, end), daemon=True).start()
        return lines.readline()

    assert [starts(first) for _ in range(count)] == count * ["began\n"]
    assert starts(not first).startswith("waiting for another process")
    end.set()
    assert [lines.readline() for _ in range(count + 2)] == [
        *count * ["ended\n"],
        "began\n",
        "ended\n",
    ]
    lines.close()
    os.close(write)
