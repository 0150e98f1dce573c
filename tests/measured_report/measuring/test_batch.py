"""The lock that keeps times from being spoilt by other processes of this host."""

import multiprocessing
import time

import pytest

from measured_report.measuring import batch


def hold(exclusive: bool, seconds: float, spans) -> None:
    with batch.gpu_lock(exclusive=exclusive):
        begun = time.monotonic()
        time.sleep(seconds)
        spans.put((exclusive, begun, time.monotonic()))


@pytest.mark.parametrize("first", [False, True])
def test_what_measures_times_has_nothing_beside_it(tmp_path, monkeypatch, capfd, first):
    monkeypatch.setattr(batch, "LOCK", tmp_path / "lock")
    context = multiprocessing.get_context("fork")
    spans, processes = context.Queue(), []
    for exclusive in (first, not first, not first):
        processes.append(context.Process(target=hold, args=(exclusive, 0.5, spans)))
        processes[-1].start()
        time.sleep(0.1)
    found = [spans.get(timeout=10.0) for _ in processes]
    for exclusive, begun, ended in found:
        beside = [other for other in found if other[1] < ended and begun < other[2] and other[1] != begun]
        assert not beside or not (exclusive or any(other[0] for other in beside))
    assert "waiting for another process" in capfd.readouterr().err
