"""Skip the wait for other processes that measure on this machine."""

import gc

import pytest

from measured_report.measuring import batch


@pytest.fixture(autouse=True)
def apart(monkeypatch, tmp_path):
    monkeypatch.setattr(batch, "LOCK", tmp_path / "lock")
    gc.freeze()  # otherwise each fork collects the garbage of this process
