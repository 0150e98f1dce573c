"""The lock that keeps times from being spoilt by other processes of this host."""

import multiprocessing

import pytest

from measured_report.measuring import batch


def hold(exclusive: bool, began, end) -> None:
    with batch.gpu_lock(exclusive=exclusive):
        began.set()
        end.wait()


@pytest.mark.parametrize("first", [False, True])
def test_what_measures_times_has_nothing_beside_it(tmp_path, monkeypatch, capfd, first):
    """It waits for what is shared, and what is shared for it; two that are shared are there together."""
    monkeypatch.setattr(batch, "LOCK", tmp_path / "lock")
    context = multiprocessing.get_context("fork")

    def started(exclusive: bool):
        began, end = context.Event(), context.Event()
        process = context.Process(target=hold, args=(exclusive, began, end), daemon=True)
        process.start()
        return began, end, process

    holders = [started(first) for _ in range(1 if first else 2)]
    assert all(began.wait(60.0) for began, *_ in holders)
    waiting = started(not first)
    said = ""
    while "waiting for another process" not in said:
        assert not waiting[0].is_set()
        said += capfd.readouterr().err
    for _, end, process in holders:
        assert not waiting[0].is_set()
        end.set()
        process.join()
    assert waiting[0].wait(60.0)
    waiting[1].set()
    waiting[2].join()
